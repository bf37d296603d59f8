/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "quiescent.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(quiescent, 0);
    addToRunTimeSelectionTable(soundField, quiescent, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::quiescent::quiescent(const dictionary& dict)
:
    analyticSound(0, dict),
    velocity_(readFlow(dict))
{
    requireOnly(dict, {"type", "velocity", "gas"});
}


Foam::acoustics::quiescent::quiescent
(
    const fvMesh&,
    const dictionary& dict
)
:
    quiescent(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::quiescent::velocity
(
    const scalar,
    const vectors& x,
    vectors& u
) const
{
    u = velocity_.replicate(1, x.cols());
}


// ************************************************************************* //
