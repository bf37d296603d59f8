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
    timeStepping(with),
    kc_(readFraction(dict, "kc"))
{
    requireOnly(dict, {"type", "kc"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::conventional::advance
(
    particleArrays& p,
    const scalar t,
    const scalar h,
    const std::int64_t step
)
{
    if (!begin(p, t, h, step))
    {
        return;
    }

    const scalar uc = largestSpeed(p, sampleGas(p, t, h), h);
    const int n =
        std::max(1, int(std::ceil(h*uc/(kc_*smallest(p.collisionDiameter)))));

    for (int s = 0; s < n; ++s)
    {
        const scalar ts = t + s*h/n;

        gasStep gas = sampleGas(p, ts, h/n);

        nestedSteps(p, gas, ts, h/n, 1, 1, s);

        progressed(scalar(s + 1)/n);
    }
}


// ************************************************************************* //
