/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "standingWave.H"

#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(standingWave, 0);
    addToRunTimeSelectionTable(soundField, standingWave, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::standingWave::standingWave(const dictionary& dict)
:
    planeWave(dict)
{}


Foam::acoustics::standingWave::standingWave
(
    const fvMesh&,
    const dictionary& dict
)
:
    standingWave(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::standingWave::velocity
(
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    const Eigen::ArrayXd speed =
        velocityAmplitude()*std::sin(phase(t))*sine(kDistance(x));

    add(speed, u);
}


// ************************************************************************* //
