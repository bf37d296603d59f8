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
:
    binnedSize(0)
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

    if (dict.found("file"))
    {
        const csvTable table(dict, "file", {"lower,upper,count"});

        for (std::size_t i = 0; i < table.rows().size(); ++i)
        {
            const auto& row = table.rows()[i];

            add(dict, row[0], row[1], row[2], 0, table.where(i));
        }
    }
    else
    {
        const auto rows = dict.get<List<FixedList<scalar, 3>>>("bins");

        forAll(rows, i)
        {
            add
            (
                dict,
                rows[i][0],
                rows[i][1],
                rows[i][2],
                0,
                "number " + std::to_string(i + 1) + " of 'bins'"
            );
        }
    }

    finish(dict);
}


// ************************************************************************* //
