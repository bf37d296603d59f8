/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "criticalVelocity.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "reducedModulus.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(criticalVelocity, 0);
    addToRunTimeSelectionTable(contactOutcome, criticalVelocity, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::criticalVelocity::criticalVelocity(const dictionary& dict)
:
    adhesion_
    (
        std::pow
        (
            readPositive(dict, "workOfAdhesion", dimEnergy/dimArea), 5.0/6
        )
       /std::cbrt(reducedModulus(dict))
    )
{
    requireOnly
    (
        dict, {"type", "workOfAdhesion", "YoungsModulus", "PoissonRatio"}
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::aerosol::criticalVelocity::stickingSpeed
(
    const particleArrays& p,
    const int i,
    const int j
) const
{
    const double mass = p.m(i)*p.m(j)/(p.m(i) + p.m(j));
    const double radius = 0.5*p.d(i)*p.d(j)/(p.d(i) + p.d(j));

    return
        std::sqrt(14.18/mass)*adhesion_*std::cbrt(radius)*std::cbrt(radius);
}


bool Foam::aerosol::criticalVelocity::sticks
(
    const particleArrays& p,
    const encounter& e
) const
{
    return e.approach() <= stickingSpeed(p, e.i, e.j);
}


double Foam::aerosol::criticalVelocity::restitution
(
    const particleArrays& p,
    const encounter& e
) const
{
    const double ratio = stickingSpeed(p, e.i, e.j)/e.approach();

    return std::sqrt(std::max(0.0, 1 - ratio*ratio));
}


// ************************************************************************* //
