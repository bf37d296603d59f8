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
    const scalar h
)
{
    ++effort_.fluidSteps;

    if (!p.size())
    {
        return;
    }

    const scalar uc = 2*relativeSpeed(p, sampleGas(p, t, h)).maxCoeff();
    const int n =
        std::max(1, int(std::ceil(h*uc/(kc_*p.d.minCoeff()))));

    for (int s = 0; s < n; ++s)
    {
        const scalar ts = t + s*h/n;

        nestedSteps(p, sampleGas(p, ts, h/n), ts, h/n, 1, 1);
    }
}


// ************************************************************************* //
