/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lognormalSize.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "normalQuantile.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(lognormalSize, 0);
    addToRunTimeSelectionTable(sizeDistribution, lognormalSize, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::aerosol::lognormalSize::readSigma(const dictionary& dict)
{
    const scalar GSD = readPositive(dict, "GSD", dimless);

    if (GSD <= 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'GSD' of " << dict.name() << " is " << GSD
            << ", but a geometric standard deviation must be greater than 1;"
            << " for particles of one size use type monodisperse"
            << exit(FatalIOError);
    }

    return std::log(GSD);
}


Foam::scalar Foam::aerosol::lognormalSize::z(const scalar d) const
{
    return std::log(d/median_)/sigma_;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::lognormalSize::lognormalSize(const dictionary& dict)
:
    median_(readPositive(dict, "median", dimLength)),
    sigma_(readSigma(dict)),
    min_(readPositive(dict, "min", dimLength)),
    max_(readPositive(dict, "max", dimLength)),
    belowMin_(normalFraction(z(min_))),
    belowMax_(normalFraction(z(max_))),
    aboveMin_(normalFraction(-z(min_))),
    aboveMax_(normalFraction(-z(max_)))
{
    requireOnly(dict, {"type", "median", "GSD", "min", "max"});

    if (min_ >= max_)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'min' of " << dict.name() << " is " << min_
            << ", but it must be less than 'max', which is " << max_
            << exit(FatalIOError);
    }

    // What an aerosol was before a filter or an impactor is a proper use; a
    // wrong power of ten is not
    const scalar kept =
        std::max(belowMax_ - belowMin_, aboveMin_ - aboveMax_);

    if (kept < 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "Less than one in a million of the particles of a lognormal"
            << " distribution with 'median' " << median_ << " and 'GSD' "
            << std::exp(sigma_) << " lies between 'min' " << min_
            << " and 'max' " << max_ << " of " << dict.name()
            << "; all three are diameters in metres"
            << exit(FatalIOError);
    }

    if (median_ < min_ || median_ > max_)
    {
        IOWarningInFunction(dict)
            << "Entry 'median' of " << dict.name() << " is " << median_
            << ", which is not between 'min' " << min_ << " and 'max' "
            << max_ << "; only " << 100*kept
            << " % of the lognormal distribution is used" << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::lognormalSize::quantile(const scalar p) const
{
    const scalar below = belowMin_ + p*(belowMax_ - belowMin_);
    const scalar above = aboveMax_ + (1 - p)*(aboveMin_ - aboveMax_);

    const scalar z =
        below < above ? normalQuantile(below) : -normalQuantile(above);

    return std::clamp(median_*std::exp(sigma_*z), min_, max_);
}


Foam::scalar Foam::aerosol::lognormalSize::moment
(
    const int k,
    const scalar d
) const
{
    // Fraction of a standard normal distribution, from the end where it is
    // small
    const auto between = [](const scalar a, const scalar b)
    {
        return
            a > 0
          ? normalFraction(-a) - normalFraction(-b)
          : normalFraction(b) - normalFraction(a);
    };

    const scalar shift = k*sigma_;
    const scalar lower = z(min_);
    const scalar upper = z(std::clamp(d, min_, max_));

    return
        std::pow(median_, k)*std::exp(0.5*shift*shift)
       *between(lower - shift, upper - shift)/between(lower, z(max_));
}


// ************************************************************************* //
