/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "probability.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(probability, 0);
    addToRunTimeSelectionTable(contactOutcome, probability, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A number from zero to one
scalar readShare
(
    const dictionary& dict,
    const word& key
)
{
    const scalar value = readFinite(dict, key, dimless);

    if (value < 0 || value > 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name() << " is " << value
            << ", but it must be from 0 to 1" << exit(FatalIOError);
    }

    return value;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::probability::probability(const dictionary& dict)
:
    sticking_(readShare(dict, "sticking")),
    restitution_
    (
        dict.found("restitution") ? readShare(dict, "restitution") : -1
    ),
    slowest_(readPositive(dict, "slowest", dimVelocity, 1e-6)),
    random_(readSeed(dict))
{
    requireOnly(dict, {"type", "sticking", "restitution", "slowest", "seed"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::aerosol::probability::sticks
(
    const particleArrays& p,
    const encounter& e
) const
{
    if (bounces() && e.approach() < slowest_)
    {
        return true;
    }

    const std::pair<std::int64_t, std::int64_t> ids =
        std::minmax(p.id(e.i), p.id(e.j));

    const auto bits = random_.bits
    (
        ids.first,
        e.step,
        counterRandom::stream::contact,
        e.number,
        ids.second
    );

    return counterRandom::openUniform(bits[0]) < sticking_;
}


// ************************************************************************* //
