/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "tableSize.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "csvTable.H"
#include "ITstream.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(tableSize, 0);
    addToRunTimeSelectionTable(sizeDistribution, tableSize, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using aerosol::csvTable;

//- What a column of amounts holds
struct amount
{
    const char* name;

    //- Moment of the sizes that it is
    int k;

    //- Whether it is divided by the width of the interval, or cumulative
    bool density;
    bool undersize;
};

const amount amounts[] =
{
    {"number", 0, false, false},
    {"volume", 3, false, false},
    {"mass", 3, false, false},
    {"dNdlogd", 0, true, false},
    {"dVdlogd", 3, true, false},
    {"dMdlogd", 3, true, false},
    {"numberUndersize", 0, false, true},
    {"volumeUndersize", 3, false, true},
    {"massUndersize", 3, false, true}
};


//- The columns of a table
struct layout
{
    label nColumns = 0;

    // Places; -1 if there is none
    label lower = -1;
    label upper = -1;
    label diameter = -1;
    label value = -1;

    const amount* what = nullptr;
};


layout readLayout(const dictionary& dict)
{
    requireValue(dict, "columns");
    const wordList names(dict.get<wordList>("columns"));

    wordList known({"lower", "upper", "diameter"});

    for (const amount& a : amounts)
    {
        known.append(a.name);
    }

    layout found;
    found.nColumns = names.size();

    forAll(names, i)
    {
        const word& name = names[i];

        if (name == "skip")
        {
            continue;
        }

        const auto a = std::find_if
        (
            std::begin(amounts),
            std::end(amounts),
            [&](const amount& one) { return name == one.name; }
        );
        const bool isAmount = a != std::end(amounts);

        label* place =
            name == "lower" ? &found.lower
          : name == "upper" ? &found.upper
          : name == "diameter" ? &found.diameter
          : isAmount ? &found.value
          : nullptr;

        if (!place || *place >= 0)
        {
            FatalIOErrorInFunction(dict)
                << "Column '" << visible(name).c_str() << "' in 'columns' of "
                << dict.name()
                <<
                (
                    place
                  ? " is the second one of its kind"
                  : " is not known"
                )
                << "; the columns are " << known
                << ", one of which holds the amounts, and skip for those that"
                << " are not to be read"
                << exit(FatalIOError);
        }

        *place = i;

        if (isAmount)
        {
            found.what = &*a;
        }
    }

    const bool edges = found.lower >= 0 && found.upper >= 0;
    const bool anyEdge = found.lower >= 0 || found.upper >= 0;

    if (!found.what || anyEdge != edges || edges == (found.diameter >= 0))
    {
        FatalIOErrorInFunction(dict)
            << "The 'columns' of " << dict.name() << " are " << names
            << ", but they must have either lower and upper, or diameter, and"
            << " one of the amounts; all columns are " << known << " and skip"
            << exit(FatalIOError);
    }

    return found;
}


csvTable::format readFormat(const dictionary& dict)
{
    requireValue(dict, "separator");
    requireValue(dict, "decimalComma");

    csvTable::format style{',', dict.getOrDefault("decimalComma", false)};

    if (dict.found("separator"))
    {
        // A word, a string or the character
        const ITstream& is = dict.lookup("separator");
        const token first(is.size() ? is[0] : token());
        const string text
        (
            first.isWord() || first.isString() ? first.stringToken()
          : first.isPunctuation() ? string(1, char(first.pToken()))
          : string()
        );

        style.separator =
            text == "comma" || text == "," ? ','
          : text == "semicolon" || text == ";" ? ';'
          : text == "tab" || text == "\\t" || text == "\t" ? '\t'
          : text == "space" || text == " " ? ' '
          : '\0';

        if (!style.separator)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'separator' of " << dict.name() << " is '"
                << visible(text).c_str()
                << "', but it must be comma, semicolon, tab or space"
                << exit(FatalIOError);
        }
    }

    if (style.decimalComma && style.separator == ',')
    {
        FatalIOErrorInFunction(dict)
            << "With 'decimalComma' of " << dict.name() << " a comma cannot"
            << " separate the columns, too: give 'separator' (semicolon, tab"
            << " or space)"
            << exit(FatalIOError);
    }

    return style;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

int Foam::aerosol::tableSize::readWeight(const dictionary& dict)
{
    const word within(valueOr<word>(dict, "within", "logUniform"));

    if (within != "logUniform" && within != "logUniformVolume")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'within' of " << dict.name() << " is '"
            << visible(within).c_str()
            << "', but it must be logUniform or logUniformVolume"
            << exit(FatalIOError);
    }

    return within == "logUniform" ? 0 : 3;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::tableSize::tableSize(const dictionary& dict)
:
    binnedSize(readWeight(dict))
{
    requireOnly
    (
        dict,
        {"type", "file", "separator", "decimalComma", "unit", "columns",
         "within", "min", "max"}
    );

    const layout columns(readLayout(dict));
    const amount& what = *columns.what;
    const scalar unit = readPositive(dict, "unit", dimLength, 1);

    const csvTable table(dict, "file", columns.nColumns, readFormat(dict));
    const auto& rows = table.rows();
    const label n = rows.size();

    const auto refuse = [&](const label i, const char* why)
    {
        FatalIOErrorInFunction(dict)
            << "In " << table.where(i).c_str() << ": " << why
            << exit(FatalIOError);
    };

    // An interval from each row, but that an undersize is known at points
    const bool points = what.undersize && columns.diameter >= 0;

    const auto diameter = [&](const label i)
    {
        return unit*rows[i][columns.diameter];
    };

    // Half-way between the middles of two intervals
    const auto between = [&](const label i)
    {
        return std::sqrt(diameter(i)*diameter(i + 1));
    };

    if (columns.diameter >= 0)
    {
        for (label i = 0; i < n; ++i)
        {
            if (!(diameter(i) > 0) || (i && !(diameter(i) > diameter(i - 1))))
            {
                refuse(i, "the diameters must be above zero and rise");
            }
        }

        if (n < 2)
        {
            refuse(0, "one diameter makes no interval; give lower and upper");
        }
    }

    if (points && rows[0][columns.value] > 0)
    {
        refuse
        (
            0,
            "the undersize at the first diameter is not zero, and nothing says"
            " how small those particles are; add a row with their smallest"
            " diameter and 0"
        );
    }

    for (label i = points; i < n; ++i)
    {
        scalar lower, upper;

        if (points)
        {
            lower = diameter(i - 1);
            upper = diameter(i);
        }
        else if (columns.diameter >= 0)
        {
            lower = i ? between(i - 1) : sqr(diameter(0))/between(0);
            upper =
                i + 1 < n ? between(i) : sqr(diameter(i))/between(i - 1);
        }
        else
        {
            lower = unit*rows[i][columns.lower];
            upper = unit*rows[i][columns.upper];
        }

        scalar content = rows[i][columns.value];

        if (what.undersize)
        {
            const scalar before = i ? rows[i - 1][columns.value] : 0;

            if (content < before)
            {
                refuse(i, "the undersize must not fall");
            }

            content -= before;
        }
        else if (what.density && lower > 0 && upper > lower)
        {
            content *= std::log10(upper/lower);
        }

        add(dict, lower, upper, content, what.k, table.where(i));
    }

    if (what.undersize)
    {
        const scalar last = rows.back()[columns.value];

        for (const scalar whole : {1.0, 100.0})
        {
            if (last > 0.5*whole && last < 0.995*whole)
            {
                IOWarningInFunction(dict)
                    << "The undersize in " << table.where(n - 1).c_str()
                    << " is " << last << ", not " << whole
                    << ": what is larger is left out" << endl;
            }
        }
    }

    if (dict.found("min") || dict.found("max"))
    {
        const scalar min = readPositive(dict, "min", dimLength, VSMALL);
        const scalar max = readPositive(dict, "max", dimLength, GREAT);

        if (min >= max)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'min' of " << dict.name() << " is " << min
                << ", but it must be less than 'max', which is " << max
                << exit(FatalIOError);
        }

        const auto left = cut(min, max);

        Info<< "Size distribution of " << dict.dictName() << ": "
            << 100*left.first << " % of the number and " << 100*left.second
            << " % of the volume of the table are between 'min' and 'max'"
            << nl;
    }

    finish(dict);
}


// ************************************************************************* //
