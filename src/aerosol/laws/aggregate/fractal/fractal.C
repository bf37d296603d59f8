/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fractal.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(fractal, 0);
    addToRunTimeSelectionTable(aggregate, fractal, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

scalar inRange
(
    const dictionary& dict,
    const word& key,
    const scalar value,
    const bool valid,
    const char* range
)
{
    if (!valid)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name() << " is " << value
            << ", but it must be " << range << exit(FatalIOError);
    }

    return value;
}


scalar readDimension(const dictionary& dict)
{
    const scalar D = readPositive(dict, "dimension", dimless);

    return inRange(dict, "dimension", D, D > 1 && D <= 3, "above 1, up to 3");
}


scalar readExponent(const dictionary& dict)
{
    const scalar b = readPositive(dict, "mobilityExponent", dimless, 0.46);

    // A third, with as many digits as one likes to write
    return inRange
    (
        dict, "mobilityExponent", b, b >= 0.33 && b <= 1, "1/3 to 1"
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::fractal::fractal(const dictionary& dict)
:
    dimension_(readDimension(dict)),
    prefactor_(readPositive(dict, "prefactor", dimless, 1)),
    mobilityExponent_(readExponent(dict))
{
    requireOnly(dict, {"type", "dimension", "prefactor", "mobilityExponent"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::fractal::mobilityDiameter
(
    const scalar d,
    const std::int64_t primaries
) const
{
    // Relative to d, which has N^(1/3) of d_p
    const scalar larger =
        d*std::max(1.0, std::pow(scalar(primaries), mobilityExponent_ - 1.0/3));

    return std::min(larger, collisionDiameter(d, primaries));
}


Foam::scalar Foam::aerosol::fractal::collisionDiameter
(
    const scalar d,
    const std::int64_t primaries
) const
{
    if (primaries < 2)
    {
        return d;
    }

    const scalar N = primaries;

    return
        d
       *std::max
        (
            1.0,
            std::pow(N, 1/dimension_ - 1.0/3)
           *std::pow(prefactor_, -1/dimension_)
        );
}


Foam::scalar Foam::aerosol::fractal::growth() const
{
    return
        equivalentSphere::growth()
       *std::max
        (
            collisionDiameter(1, 2), std::pow(2.0, 1/dimension_ - 1.0/3)
        );
}


// ************************************************************************* //
