/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "StokesDrag.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(StokesDrag, 0);
    addToRunTimeSelectionTable(drag, StokesDrag, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::StokesDrag::StokesDrag(const dictionary& dict)
:
    slip_(slipCorrection::New(dict))
{
    requireOnly(dict, {"type", "slipCorrection"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::StokesDrag::StokesRate
(
    const particleArrays& p,
    const gasProperties& gas
) const
{
    return
        3*EIGEN_PI*gas.mu*p.mobilityDiameter
       /(p.m*slip_->factor(p.mobilityDiameter, gas));
}


Foam::aerosol::scalars Foam::aerosol::StokesDrag::factor
(
    const scalars& Re
) const
{
    return scalars::Ones(Re.size());
}


// ************************************************************************* //
