/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "equivalentSphere.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(equivalentSphere, 0);
    addToRunTimeSelectionTable(aggregate, equivalentSphere, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::equivalentSphere::equivalentSphere(const dictionary& dict)
{
    requireOnly(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::equivalentSphere::merge
(
    particleArrays& p,
    const contactOutcome::encounter& pair
) const
{
    const int i = pair.i;
    const int j = pair.j;

    const double mass = p.m(i) + p.m(j);

    // Relative to i, so that a small partner is not lost in rounding
    const double share = p.m(j)/mass;

    p.x.col(i) = pair.xi + share*(pair.xj - pair.xi);
    p.v.col(i) = (p.m(i)*pair.vi + p.m(j)*pair.vj)/mass;

    p.d(i) = std::cbrt(p.d(i)*p.d(i)*p.d(i) + p.d(j)*p.d(j)*p.d(j));
    p.m(i) = mass;
    p.primaries(i) += p.primaries(j);
}


// ************************************************************************* //
