/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "travellingWave.H"

#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(travellingWave, 0);
    addToRunTimeSelectionTable(soundField, travellingWave, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::travellingWave::travellingWave(const dictionary& dict)
:
    planeWave(dict)
{}


Foam::acoustics::travellingWave::travellingWave
(
    const fvMesh&,
    const dictionary& dict
)
:
    travellingWave(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::travellingWave::velocity
(
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    const Eigen::ArrayXd speed =
        velocityAmplitude()*sine(phase(t) - kDistance(x));

    add(speed, u);
}


// ************************************************************************* //
