/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "RosinRammlerSize.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(RosinRammlerSize, 0);
    addToRunTimeSelectionTable(sizeDistribution, RosinRammlerSize, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::RosinRammlerSize::RosinRammlerSize(const dictionary& dict)
:
    binnedSize(3)
{
    requireOnly(dict, {"type", "d63", "n", "min", "max"});

    const scalar d63 = readPositive(dict, "d63", dimLength);
    const scalar n = readPositive(dict, "n", dimless);
    const scalar min = readPositive(dict, "min", dimLength);
    const scalar max = readPositive(dict, "max", dimLength);

    if (min >= max)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'min' of " << dict.name() << " is " << min
            << ", but it must be less than 'max', which is " << max
            << exit(FatalIOError);
    }

    // Exponent of what is above a diameter; beyond 700 there is nothing
    const auto exponent = [&](const scalar d)
    {
        return std::exp(std::min(n*std::log(d/d63), std::log(700.0)));
    };

    const scalar kept = std::exp(-exponent(min)) - std::exp(-exponent(max));

    if (!(kept > 1e-6))
    {
        FatalIOErrorInFunction(dict)
            << "Less than one in a million of the volume of a distribution of"
            << " Rosin and Rammler with 'd63' " << d63 << " and 'n' " << n
            << " lies between 'min' " << min << " and 'max' " << max << " of "
            << dict.name() << "; all three are diameters in metres"
            << exit(FatalIOError);
    }

    constexpr int nBins = 1000;
    const scalar step = std::log(max/min)/nBins;

    for (int i = 0; i < nBins; ++i)
    {
        const scalar lower = min*std::exp(i*step);
        const scalar upper = min*std::exp((i + 1)*step);
        add
        (
            dict,
            lower,
            upper,
           -std::exp(-exponent(lower))
           *std::expm1(exponent(lower) - exponent(upper)),
            3,
            "of Rosin and Rammler"
        );
    }

    finish(dict);
}


// ************************************************************************* //
