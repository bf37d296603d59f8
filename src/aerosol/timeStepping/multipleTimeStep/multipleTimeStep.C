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
    timeStepping(with),
    kp_(readFraction(dict, "kp")),
    kc_(readFraction(dict, "kc"))
{
    requireOnly(dict, {"type", "kp", "kc"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::multipleTimeStep::advance
(
    particleArrays& p,
    const scalar t,
    const scalar h
)
{
    ++effort_.fluidSteps;

    if (!p.size())
    {
        return;
    }

    with_.motion.refresh(p);

    const gasStep gas = sampleGas(p, t, h);
    const scalar uc = 2*relativeSpeed(p, gas).maxCoeff();
    const scalar tau = with_.motion.relaxationTime().minCoeff();

    const int nParticle = std::max(1, int(std::ceil(h/(kp_*tau))));
    const int nCollision =
        std::max
        (
            1,
            int(std::ceil(h/nParticle*uc/(kc_*p.d.minCoeff())))
        );

    nestedSteps(p, gas, t, h, nParticle, nCollision);
}


// ************************************************************************* //
