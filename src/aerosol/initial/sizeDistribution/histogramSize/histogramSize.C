/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "histogramSize.H"
#include "FixedList.H"
#include "List.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "csvTable.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(histogramSize, 0);
    addToRunTimeSelectionTable(sizeDistribution, histogramSize, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::histogramSize::histogramSize(const dictionary& dict)
{
    requireOnly(dict, {"type", "bins", "file"});

    if (dict.found("bins") == dict.found("file"))
    {
        FatalIOErrorInFunction(dict)
            << "A histogram needs either 'bins' or 'file', but "
            << dict.name() << " has "
            << (dict.found("bins") ? "both" : "neither")
            << exit(FatalIOError);
    }

    scalar sum = 0;
    scalar end = 0;

    // `where` tells the user which interval is meant
    const auto add = [&]
    (
        const scalar lower,
        const scalar upper,
        const scalar count,
        const string& where
    )
    {
        const char* valid =
            !(lower > 0) ? "its lower diameter must be positive"
          : !(lower < upper) ? "its upper diameter must exceed its lower one"
          : !(upper < 1) ? "no particle is a metre large"
          : !(count >= 0) ? "its count must be zero or more"
          : !(count < GREAT) ? "its count must be a finite number"
          : lower < end ? "intervals must rise and not overlap"
          : nullptr;

        if (valid)
        {
            FatalIOErrorInFunction(dict)
                << "The interval (" << lower << ' ' << upper << ' ' << count
                << "), " << where.c_str() << ", is not valid: " << valid
                << "; it stands for (lower upper count), diameters in metres"
                << exit(FatalIOError);
        }

        end = upper;
        sum += count;

        if (count > 0)
        {
            bins_.push_back({lower, upper, sum});
        }
    };

    if (dict.found("file"))
    {
        const csvTable table(dict, "file", {"lower,upper,count"});

        for (std::size_t i = 0; i < table.rows().size(); ++i)
        {
            const auto& row = table.rows()[i];

            add(row[0], row[1], row[2], table.where(i));
        }
    }
    else
    {
        const auto rows = dict.get<List<FixedList<scalar, 3>>>("bins");

        forAll(rows, i)
        {
            add
            (
                rows[i][0],
                rows[i][1],
                rows[i][2],
                "number " + std::to_string(i + 1) + " of 'bins'"
            );
        }
    }

    if (bins_.empty() || !std::isfinite(sum))
    {
        FatalIOErrorInFunction(dict)
            << "The counts of the histogram " << dict.name() << " add up to "
            << sum << ", but the sum must be positive and finite"
            << exit(FatalIOError);
    }

    for (bin& b : bins_)
    {
        b.cumulative /= sum;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::histogramSize::quantile(const scalar p) const
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

    return std::clamp
    (
        found->lower*std::pow(found->upper/found->lower, f),
        found->lower,
        found->upper
    );
}


// ************************************************************************* //
