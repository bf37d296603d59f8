/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkedDictionary.H"

#include "ITstream.H"
#include "OStringStream.H"
#include "primitiveEntry.H"

#include <cstdio>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::requireDictionaries(const dictionary& dict, const wordList& valid)
{
    for (const entry& e : dict)
    {
        const bool known = valid.found(e.keyword());

        if (!e.isDict() && known)
        {
            FatalIOErrorInFunction(dict)
                << "'" << e.keyword() << "' in line " << e.startLineNumber()
                << " must be a dictionary, such as " << e.keyword()
                << " { ... }" << exit(FatalIOError);
        }

        if (e.isDict() && e.keyword() != "FoamFile" && !known)
        {
            FatalIOErrorInFunction(e.dict())
                << "Unknown dictionary '" << visible(e.keyword()).c_str()
                << "' in " << dict.name() << "; valid ones are " << valid
                << exit(FatalIOError);
        }
    }
}


void Foam::requireValue(const dictionary& dict, const word& key)
{
    const entry* found = dict.findEntry(key, keyType::REGEX);

    if (found && found->isDict())
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name()
            << " must be a value, such as " << key << " 1;"
            << " but it is a dictionary" << exit(FatalIOError);
    }
}


void Foam::requireAllRead(const dictionary& dict, const word& key)
{
    const auto* read = dynamic_cast<const primitiveEntry*>
    (
        &dict.lookupEntry(key, keyType::REGEX)
    );

    // A single word, as of a Function1 whose coefficients are elsewhere, has
    // swallowed nothing, and newer versions of OpenFOAM do not read on in it
    if (read && read->size() > 1 && read->nRemainingTokens())
    {
        OStringStream rest;
        for (label i = read->tokenIndex(); i < read->size(); ++i)
        {
            rest << ' ' << (*read)[i];
        }

        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name()
            << " goes on with '" << visible(rest.str().substr(1)).c_str()
            << "', which nobody reads: is a semicolon missing?"
            << exit(FatalIOError);
    }
}


Foam::dictionary Foam::optionalDict(const dictionary& dict, const word& key)
{
    if (dict.found(key) && !dict.isDict(key))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name()
            << " must be a dictionary, such as " << key << " { ... }"
            << exit(FatalIOError);
    }

    return dict.subOrEmptyDict(key);
}


Foam::string Foam::visible(const string& text)
{
    std::string shown;

    for (std::size_t i = 0; i < text.size(); ++i)
    {
        const auto c = static_cast<unsigned char>(text[i]);

        // The bytes that follow the first one of a character in UTF-8
        const std::size_t more = c < 0xc0 ? 0 : c < 0xe0 ? 1 : c < 0xf0 ? 2 : 3;
        unsigned code = more ? c & (0x3f >> more) : c;

        for (std::size_t k = 1; k <= more && i + k < text.size(); ++k)
        {
            code = 64*code + (text[i + k] & 0x3f);
        }

        if (c >= ' ' && c < 0x7f)
        {
            shown += text[i];
        }
        else
        {
            char name[16];
            std::snprintf(name, sizeof(name), "<U+%04X>", code);
            shown += name;
            i += more;
        }
    }

    return shown;
}


// ************************************************************************* //
