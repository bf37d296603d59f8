/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "mixtureSource.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(mixtureSource, 0);
    addToRunTimeSelectionTable(particleSource, mixtureSource, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::aerosol::mixtureSource::readDensity(const dictionary& dict)
{
    return
        dict.found("density")
      ? readPositive(dict, "density", dimDensity)
      : -1;
}


std::vector<Foam::aerosol::distributionSource::population>
Foam::aerosol::mixtureSource::readAll(const dictionary& dict)
{
    requireOnly
    (
        dict,
        {"density", "source", "initialVelocity", "seed", "populations"}
    );

    const dictionary all(optionalDict(dict, "populations"));

    if (all.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Source mixture needs a dictionary 'populations' in "
            << dict.name() << ", with a dictionary for each of them"
            << exit(FatalIOError);
    }

    std::vector<population> populations;

    for (const entry& one : all)
    {
        if (!one.isDict())
        {
            FatalIOErrorInFunction(all)
                << "Entry '" << one.keyword() << "' of " << all.name()
                << " is no dictionary, but each population is one"
                << exit(FatalIOError);
        }

        populations.push_back(read(one.dict(), readDensity(dict), {}));
    }

    return populations;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::mixtureSource::mixtureSource(const dictionary& dict)
:
    distributionSource(dict, readDensity(dict), readAll(dict))
{}


// ************************************************************************* //
