/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sizeDistribution.H"
#include "selectModel.H"

#include <algorithm>
#include <cmath>
#include <vector>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(sizeDistribution, 0);
    defineRunTimeSelectionTable(sizeDistribution, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Fractions between which a quantile is smooth: they halve towards either end,
//  where the tails are
std::vector<Foam::scalar> panels()
{
    std::vector<Foam::scalar> ends;

    for (int i = 50; i > 1; --i)
    {
        ends.push_back(std::ldexp(1.0, -i));
    }
    for (int i = 1; i <= 50; ++i)
    {
        ends.push_back(1 - std::ldexp(1.0, -i));
    }

    return ends;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::sizeDistribution>
Foam::aerosol::sizeDistribution::New
(
    const dictionary& dict
)
{
    return selectModel<sizeDistribution>
    (
        dict,
        "size distribution",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::sizeDistribution::moment
(
    const int k,
    const scalar d
) const
{
    // Three points of Gauss in each panel
    constexpr scalar apart = 0.3872983346207417;
    constexpr scalar outer = 5.0/18;
    constexpr scalar middle = 8.0/18;

    static const std::vector<scalar> ends(panels());

    // Fraction of the particles that are smaller
    scalar end = d > min() ? 1 : 0;

    if (d > min() && d < max())
    {
        scalar lower = 0;

        while (end - lower > 1e-15)
        {
            const scalar p = 0.5*(lower + end);

            (quantile(p) < d ? lower : end) = p;
        }
    }

    const auto power = [&](const scalar p)
    {
        return std::pow(quantile(p), k);
    };

    scalar sum = 0;

    for (std::size_t i = 1; i < ends.size() && ends[i - 1] < end; ++i)
    {
        const scalar upper = std::min(ends[i], end);
        const scalar h = upper - ends[i - 1];
        const scalar p = 0.5*(upper + ends[i - 1]);

        sum +=
            h
           *(
                outer*(power(p - apart*h) + power(p + apart*h))
              + middle*power(p)
            );
    }

    return sum;
}


Foam::scalar Foam::aerosol::sizeDistribution::quantileOf
(
    const int k,
    const scalar p
) const
{
    const scalar wanted = p*moment(k);

    scalar lower = std::log(min());
    scalar upper = std::log(max());

    // Far enough to be exact
    for (int i = 0; i < 60; ++i)
    {
        const scalar middle = 0.5*(lower + upper);

        (moment(k, std::exp(middle)) < wanted ? lower : upper) = middle;
    }

    return std::exp(0.5*(lower + upper));
}


// ************************************************************************* //
