#include "checkedEntry.H"

#include "dictionary.H"
#include "dimensionedScalar.H"

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

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::readFinite
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dimensions
)
{
    const scalar value = dimensionedScalar(key, dimensions, dict).value();

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


Foam::vector Foam::readDirection
(
    const dictionary& dict,
    const word& key,
    const vector& defaultValue
)
{
    const vector value = dict.lookupOrDefault<vector>(key, defaultValue);

    if (mag(value) < VSMALL)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name()
            << " is a zero vector and so has no direction"
            << exit(FatalIOError);
    }

    return value/mag(value);
}


// ************************************************************************* //
