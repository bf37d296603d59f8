/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noDrag.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(noDrag, 0);
    addToRunTimeSelectionTable(drag, noDrag, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::noDrag::noDrag(const dictionary&)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::noDrag::StokesRate
(
    const particleArrays& p,
    const gasProperties&
) const
{
    return scalars::Zero(p.size());
}


Foam::aerosol::scalars Foam::aerosol::noDrag::factor(const scalars& Re) const
{
    return scalars::Ones(Re.size());
}


// ************************************************************************* //
