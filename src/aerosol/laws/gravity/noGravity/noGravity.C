/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noGravity.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(noGravity, 0);
    addToRunTimeSelectionTable(gravity, noGravity, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::noGravity::noGravity(const dictionary&)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::vectors Foam::aerosol::noGravity::acceleration
(
    const particleArrays& p,
    const acoustics::gasProperties&
) const
{
    return vectors::Zero(3, p.size());
}


// ************************************************************************* //
