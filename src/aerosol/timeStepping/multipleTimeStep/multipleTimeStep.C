/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "multipleTimeStep.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(multipleTimeStep, 0);
    addToRunTimeSelectionTable(timeStepping, multipleTimeStep, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::multipleTimeStep::multipleTimeStep
(
    const dictionary& dict,
    const tools& with
)
:
    nestedSteps(with),
    kp_(readFraction(dict, "kp")),
    kc_(readFraction(dict, "kc"))
{
    requireOnly(dict, {"type", "kp", "kc"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::multipleTimeStep::advance
(
    particleArrays& p,
    const fluidStep& step
)
{
    if (!begin(p, step))
    {
        return;
    }

    const scalar h = step.h;
    stepValues gas = sampler_.atAll(p, step);
    const scalar uc = relative_.largestSpeed(p, gas, h);
    const scalar tau = smallest(particleLaws::relaxationTime(p));

    const int nParticle = std::max(1, int(std::ceil(h/(kp_*tau))));
    const int nCollision =
        std::max
        (
            1,
            int(std::ceil(h/nParticle*uc/(kc_*smallest(p.collisionDiameter))))
        );

    move(p, gas, step, nParticle, nCollision);
}


// ************************************************************************* //
