/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "impactBreakage.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(impactBreakage, 0);
    addToRunTimeSelectionTable(breakage, impactBreakage, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::impactBreakage::impactBreakage(const dictionary& dict)
:
    bond_(dict.subDict("bond")),
    factor_
    (
        readPositive
        (
            dict,
            "factor",
            dimless,
            valueOr<word>(dict, "fragments", "erosion") == "two" ? 10 : 3
        )
    )
{
    requireOnly(dict, {"bond", "factor"});

    if (!bond_.hasWork())
    {
        FatalIOErrorInFunction(dict.subDict("bond"))
            << "What an impact needs to break a bond of type JKR depends on"
            << " the elasticity: give 'YoungsModulus' in "
            << dict.subDict("bond").name() << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::breakage::impact Foam::aerosol::impactBreakage::hit
(
    const particleArrays& p,
    const contactOutcome::encounter& pair
) const
{
    const int i = pair.i;
    const int j = pair.j;
    const std::int64_t primaries = p.primaries(i) + p.primaries(j);

    if (primaries < 3)
    {
        return {};
    }

    const scalar mass = p.m(i)*p.m(j)/(p.m(i) + p.m(j));
    const scalar speed = std::max(0.0, pair.approach());
    const scalar primary =
        std::cbrt
        (
            (p.d(i)*p.d(i)*p.d(i) + p.d(j)*p.d(j)*p.d(j))/primaries
        );

    impact one;
    one.energy =
        std::max
        (
            0.0,
            0.5*mass*speed*speed
          - factor_*(primaries - 1)*bond_.work(primary)
        );
    one.mass = mass;
    one.direction =
        (p.m(i) < p.m(j) ? pair.xi - pair.xj : pair.xj - pair.xi).normalized();

    return one;
}


bool Foam::aerosol::impactBreakage::breaks
(
    const particleArrays&,
    const int,
    const particleArrays& pieces,
    const surroundings& where,
    const acoustics::gasProperties&,
    parting& apart
) const
{
    const scalar m0 = pieces.m(0);
    const scalar m1 = pieces.m(1);

    apart.direction = where.hit.direction;
    apart.speed =
        std::sqrt
        (
            2*where.hit.energy/std::max(m0*m1/(m0 + m1), where.hit.mass)
        );

    return true;
}


// ************************************************************************* //
