/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "conventional.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(conventional, 0);
    addToRunTimeSelectionTable(timeStepping, conventional, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::conventional::conventional
(
    const dictionary& dict,
    const tools& with
)
:
    nestedSteps(with),
    kc_(readFraction(dict, "kc"))
{
    requireOnly(dict, {"type", "kc"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::conventional::advance
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
    const scalar uc =
        relative_.largestSpeed(p, sampler_.atAll(p, step), h);
    const int n =
        std::max(1, int(std::ceil(h*uc/(kc_*smallest(p.collisionDiameter)))));

    for (int s = 0; s < n; ++s)
    {
        const fluidStep part{step.index, step.t + s*h/n, h/n, s};

        stepValues gas = sampler_.atAll(p, part);

        move(p, gas, part, 1, 1);

        progressed(scalar(s + 1)/n);
    }
}


// ************************************************************************* //
