/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudModels.H"

#include "checkedDictionary.H"
#include "cloudTables.H"
#include "describe.H"

#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const Foam::wordList& Foam::aerosol::cloudModels::names()
{
    static const wordList names
    ({
        "domain", "particles", "timeStepping", "drag", "unsteadyDrag",
        "gravity", "wake", "Brownian", "contact", "aggregate", "breakage",
        "report", "frame", "coupling", "turbulence"
    });

    return names;
}


const Foam::dictionary& Foam::aerosol::cloudModels::requireKnown
(
    const dictionary& dict
)
{
    if (dict.found("carried"))
    {
        FatalIOErrorInFunction(dict.optionalSubDict("carried"))
            << "Dictionary 'carried' is named 'frame' now: rename it"
            << exit(FatalIOError);
    }

    requireDictionaries(dict, names());

    requireOnly(optionalDict(dict, "report"), cloudTables::entries());

    return dict;
}


void Foam::aerosol::cloudModels::warnOfIdle(const dictionary& dict)
{
    if
    (
        dict.subDict("contact").get<word>("type") == "none"
     || dict.subDict("aggregate").get<word>("type") == "none"
    )
    {
        WarningInFunction
            << "Nothing sticks, by 'contact' or 'aggregate': there will be no"
            << " new aggregates for 'breakage' to break, and no impacts that"
            << " break any" << endl;
    }
}


std::string Foam::aerosol::cloudModels::table(const dictionary& dict)
{
    std::ostringstream os;
    std::string without;

    os  << "Models";

    for (const word& name : names())
    {
        if (dict.isDict(name))
        {
            os  << "\n    " << std::left << std::setw(13) << name
                << describe(dict.subDict(name));
        }
        else
        {
            without += ' ' + name;
        }
    }

    if (!without.empty())
    {
        os  << "\n    not given, so by default:" << without;
    }

    return os.str();
}


// ************************************************************************* //
