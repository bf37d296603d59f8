/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "describe.H"
#include "dictionary.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The value of an entry, in one line
std::string valueOf(const Foam::entry& e)
{
    if (e.isDict())
    {
        return "{ " + Foam::describe(e.dict()) + " }";
    }

    // A list of particles, for instance
    constexpr int most = 20;

    Foam::OStringStream os;
    const Foam::ITstream& tokens = e.stream();

    for (int i = 0; i < std::min<int>(tokens.size(), most); ++i)
    {
        os  << (i ? " " : "") << tokens[i];
    }

    std::string text = os.str();
    if (tokens.size() > most || text.size() > 200)
    {
        text.resize(std::min<std::size_t>(text.size(), 60));
        text += " ...";
    }

    for (char& c : text)
    {
        c = c == '\n' ? ' ' : c;
    }

    return text;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::string Foam::describe(const dictionary& dict)
{
    std::string first, others;

    for (const entry& e : dict)
    {
        const std::string value = valueOf(e);

        if (e.keyword() == "type" || e.keyword() == "source")
        {
            first = value + ';' + first;
        }
        else
        {
            others += ' ' + e.keyword() + ' ' + value + (e.isDict() ? "" : ";");
        }
    }

    return first.empty() && !others.empty() ? others.substr(1) : first + others;
}


// ************************************************************************* //
