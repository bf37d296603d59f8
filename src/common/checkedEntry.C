/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkedEntry.H"
#include "checkedDictionary.H"

#include "ITstream.H"
#include "OStringStream.H"
#include "dictionary.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void refuse
(
    const Foam::dictionary& dict,
    const Foam::word& key,
    const Foam::scalar value,
    const char* valid
)
{
    FatalIOErrorInFunction(dict)
        << "Entry '" << key << "' of " << dict.name() << " is " << value
        << ", but it must be " << valid
        << exit(Foam::FatalIOError);
}


//- Not a number at all
void refuseText
(
    const Foam::dictionary& dict,
    const Foam::word& key,
    const Foam::string& what
)
{
    FatalIOErrorInFunction(dict)
        << "Entry '" << key << "' of " << dict.name() << ' ' << what.c_str()
        << ", but it must be a number in SI units, alone or after its"
        << " dimensions in brackets"
        << exit(Foam::FatalIOError);
}


//- The entry, read past its dimensions if it has any: these must be right and
//  may bring a multiplier. Not by dimensionedScalar: of a word it says "attempt
//  to read beyond EOF", and of wrong dimensions it aborts with a stack trace.
Foam::ITstream& readDimensions
(
    const Foam::dictionary& dict,
    const Foam::word& key,
    const Foam::dimensionSet& dimensions,
    Foam::scalar& multiplier
)
{
    using namespace Foam;

    requireValue(dict, key);

    ITstream& is = dict.lookup(key);
    multiplier = 1;

    if
    (
        is.size()
     && is[0].isPunctuation()
     && is[0].pToken() == token::BEGIN_SQR
    )
    {
        dimensionSet given(dimless);
        given.read(is, multiplier);

        if (given != dimensions)
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << key << "' of " << dict.name()
                << " has the dimensions " << given << ", but it must have "
                << dimensions
                << exit(FatalIOError);
        }
    }

    return is;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::holdsVector(const ITstream& is)
{
    if (is.nRemainingTokens() != 5)
    {
        return false;
    }

    const label first = is.tokenIndex();

    const auto isBracket = [&](const label i, const token::punctuationToken c)
    {
        return is[i].isPunctuation() && is[i].pToken() == c;
    };

    return
        isBracket(first, token::BEGIN_LIST)
     && is[first + 1].isNumber()
     && is[first + 2].isNumber()
     && is[first + 3].isNumber()
     && isBracket(first + 4, token::END_LIST);
}


Foam::scalar Foam::readFinite
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dimensions
)
{
    scalar multiplier;
    ITstream& is = readDimensions(dict, key, dimensions, multiplier);

    if (is.nRemainingTokens() != 1)
    {
        refuseText(dict, key, "does not hold one number");
    }

    const token number(is);

    if (!number.isNumber())
    {
        OStringStream text;
        text << number;
        refuseText(dict, key, "is '" + visible(text.str()) + "'");
    }

    const scalar value = multiplier*number.number();

    if (!std::isfinite(value))
    {
        refuse(dict, key, value, "a finite number");
    }

    return value;
}


Foam::scalar Foam::readPositive
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dimensions
)
{
    const scalar value = readFinite(dict, key, dimensions);

    if (value <= 0)
    {
        refuse(dict, key, value, "positive");
    }

    return value;
}


Foam::scalar Foam::readPositive
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dimensions,
    const scalar defaultValue
)
{
    return
        dict.found(key) ? readPositive(dict, key, dimensions) : defaultValue;
}


Foam::scalar Foam::readFraction(const dictionary& dict, const word& key)
{
    const scalar value = readPositive(dict, key, dimless);

    if (value > 1)
    {
        refuse(dict, key, value, "above 0 and not above 1");
    }

    return value;
}


Foam::scalar Foam::readFraction
(
    const dictionary& dict,
    const word& key,
    const scalar defaultValue
)
{
    return dict.found(key) ? readFraction(dict, key) : defaultValue;
}


void Foam::requireOnly(const dictionary& dict, const wordList& valid)
{
    for (const word& key : dict.toc())
    {
        if (!valid.found(key))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown entry '" << visible(key).c_str() << "' in "
                << dict.name() << "; valid entries are " << valid
                << exit(FatalIOError);
        }
    }
}


Foam::scalar Foam::readNonNegative
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dimensions,
    const scalar defaultValue
)
{
    if (!dict.found(key))
    {
        return defaultValue;
    }

    const scalar value = readFinite(dict, key, dimensions);

    if (value < 0)
    {
        refuse(dict, key, value, "zero or more");
    }

    return value;
}


Foam::label Foam::readInteger
(
    const dictionary& dict,
    const word& key,
    const label defaultValue,
    const label least,
    const label most
)
{
    const scalar value =
        dict.found(key) ? readFinite(dict, key, dimless) : defaultValue;

    if (value < least || value > most || value != std::floor(value))
    {
        OStringStream valid;
        valid << "a whole number, " << least << " or more";
        if (most < labelMax)
        {
            valid << ", up to " << most;
        }
        refuse(dict, key, value, valid.str().c_str());
    }

    return label(value);
}


Foam::label Foam::readSeed(const dictionary& dict)
{
    return readInteger(dict, "seed", 1, 0);
}


Foam::vector Foam::getVector
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dimensions
)
{
    scalar multiplier;
    ITstream& is = readDimensions(dict, key, dimensions, multiplier);

    if (!holdsVector(is))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name() << " is '"
            << visible(is.toString()).c_str() << "', but it must be one vector,"
            << " such as (1 0 0), and nothing after it"
            << exit(FatalIOError);
    }

    vector value;
    is >> value;

    return multiplier*value;
}


Foam::vector Foam::readVector
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dimensions,
    const vector& defaultValue
)
{
    return dict.found(key) ? getVector(dict, key, dimensions) : defaultValue;
}


Foam::vector Foam::readDirection
(
    const dictionary& dict,
    const word& key,
    const vector& defaultValue
)
{
    const vector value = readVector(dict, key, dimless, defaultValue);

    // Of huge numbers, too, the square is one
    const scalar largest = cmptMax(cmptMag(value));

    if (largest < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name()
            << " is a zero vector and so has no direction"
            << exit(FatalIOError);
    }

    const vector scaled = value/largest;

    return scaled/mag(scaled);
}


// ************************************************************************* //
