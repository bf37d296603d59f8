/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "binnedSize.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::aerosol::binnedSize::integral
(
    const int k,
    const scalar a,
    const scalar b
) const
{
    const int n = k - weight_;

    return
        n == 0
      ? std::log(b/a)
      : std::pow(a, n)*std::expm1(n*std::log(b/a))/n;
}


Foam::scalar Foam::aerosol::binnedSize::momentIn
(
    const bin& one,
    const int k,
    const scalar b
) const
{
    return
        integral(k, one.lower, b)/integral(0, one.lower, one.upper);
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::aerosol::binnedSize::add
(
    const dictionary& dict,
    const scalar lower,
    const scalar upper,
    const scalar content,
    const int k,
    const string& where
)
{
    const char* valid =
        !(lower > 0) ? "its lower diameter must be positive"
      : !(lower < upper) ? "its upper diameter must exceed its lower one"
      : !(upper < 1) ? "no particle is a metre large"
      : !(content >= 0) ? "its count must be zero or more"
      : !(content < GREAT) ? "its count must be a finite number"
      : lower < end_*(1 - 1e-9) ? "intervals must rise and not overlap"
      : nullptr;

    if (valid)
    {
        FatalIOErrorInFunction(dict)
            << "The interval (" << lower << ' ' << upper << ' ' << content
            << "), " << where.c_str() << ", is not valid: " << valid
            << "; it stands for (lower upper count), diameters in metres"
            << exit(FatalIOError);
    }

    end_ = upper;

    if (content > 0)
    {
        bins_.push_back({lower, upper, content, 0});
        bins_.back().share /= momentIn(bins_.back(), k, upper);
    }
}


std::pair<Foam::scalar, Foam::scalar> Foam::aerosol::binnedSize::cut
(
    const scalar min,
    const scalar max
)
{
    scalar all[2] = {0, 0};
    scalar left[2] = {0, 0};

    for (bin& one : bins_)
    {
        const scalar lower = std::clamp(min, one.lower, one.upper);
        const scalar upper = std::clamp(max, lower, one.upper);

        for (const int i : {0, 1})
        {
            const int k = 3*i;
            const scalar above = momentIn(one, k, lower);

            all[i] += one.share*momentIn(one, k, one.upper);
            left[i] += one.share*(momentIn(one, k, upper) - above);
        }

        one.share *= momentIn(one, 0, upper) - momentIn(one, 0, lower);
        one.lower = lower;
        one.upper = upper;
    }

    bins_.erase
    (
        std::remove_if
        (
            bins_.begin(),
            bins_.end(),
            [](const bin& one)
            {
                return !(one.share > 0 && one.lower < one.upper);
            }
        ),
        bins_.end()
    );

    return {left[0]/all[0], left[1]/all[1]};
}


void Foam::aerosol::binnedSize::finish(const dictionary& dict)
{
    scalar sum = 0;

    for (const bin& one : bins_)
    {
        sum += one.share;
    }

    if (bins_.empty() || !std::isfinite(sum))
    {
        FatalIOErrorInFunction(dict)
            << "The counts of the distribution " << dict.name()
            << " add up to " << sum
            << ", but the sum must be positive and finite"
            << exit(FatalIOError);
    }

    scalar cumulative = 0;

    for (bin& one : bins_)
    {
        cumulative += one.share;
        one.share /= sum;
        one.cumulative = cumulative/sum;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::binnedSize::binnedSize(const int weight)
:
    weight_(weight),
    end_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::binnedSize::quantile(const scalar p) const
{
    const auto found = std::upper_bound
    (
        bins_.begin(),
        bins_.end() - 1,
        p,
        [](const scalar fraction, const bin& b)
        {
            return fraction < b.cumulative;
        }
    );

    const scalar before =
        found == bins_.begin() ? 0 : std::prev(found)->cumulative;

    const scalar f = (p - before)/(found->cumulative - before);
    const scalar ratio = found->upper/found->lower;

    const scalar d =
        weight_ == 0
      ? found->lower*std::pow(ratio, f)
      : found->lower
       *std::pow(1 - f*(1 - std::pow(ratio, -weight_)), -1.0/weight_);

    return std::clamp(d, found->lower, found->upper);
}


Foam::scalar Foam::aerosol::binnedSize::moment
(
    const int k,
    const scalar d
) const
{
    scalar sum = 0;

    for (const bin& one : bins_)
    {
        sum += one.share*momentIn(one, k, std::clamp(d, one.lower, one.upper));
    }

    return sum;
}


// ************************************************************************* //
