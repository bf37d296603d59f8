/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sameContents.H"

#include "ITstream.H"
#include "OStringStream.H"
#include "dictionary.H"

#include <algorithm>
#include <string>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A number as all its digits, whether it was read as a label or as a scalar
std::string asText(const Foam::token& t)
{
    Foam::OStringStream os;
    os.precision(17);

    if (t.isNumber())
    {
        os << t.number();
    }
    else
    {
        os << t;
    }

    return os.str();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::sameContents(const dictionary& a, const dictionary& b)
{
    if (a.size() != b.size())
    {
        return false;
    }

    for (const entry& one : a)
    {
        const entry* other = b.findEntry(one.keyword(), keyType::LITERAL);

        if (!other || one.isDict() != other->isDict())
        {
            return false;
        }

        if (one.isDict())
        {
            if (!sameContents(one.dict(), other->dict()))
            {
                return false;
            }
            continue;
        }

        const UList<token>& tokens = one.stream();
        const UList<token>& others = other->stream();

        const auto equal = [](const token& t, const token& u)
        {
            return asText(t) == asText(u);
        };

        if
        (
            !std::equal
            (
                tokens.begin(), tokens.end(),
                others.begin(), others.end(),
                equal
            )
        )
        {
            return false;
        }
    }

    return true;
}
