/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dragBreakage.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(dragBreakage, 0);
    addToRunTimeSelectionTable(breakage, dragBreakage, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::dragBreakage::dragBreakage(const dictionary& dict)
:
    bond_(dict.subDict("bond"))
{
    requireOnly(dict, {"bond"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::dragBreakage::tension(const particleArrays& pieces)
{
    const scalar m0 = pieces.m(0);
    const scalar m1 = pieces.m(1);

    // k = m rate
    return (pieces.rate(1) - pieces.rate(0))*m0*m1/(m0 + m1);
}


bool Foam::aerosol::dragBreakage::mayBreak
(
    const particleArrays& p,
    const int i,
    const surroundings& where,
    const acoustics::gasProperties&
) const
{
    // No piece has more drag than the whole, and the tension is below that
    return p.m(i)*p.rate(i)*where.slip.norm() > bond_.strength(p, i);
}


bool Foam::aerosol::dragBreakage::breaks
(
    const particleArrays& p,
    const int i,
    const particleArrays& pieces,
    const surroundings& where,
    const acoustics::gasProperties&,
    parting& apart
) const
{
    const scalar U = where.slip.norm();
    const scalar T = tension(pieces);

    if (std::abs(T)*U <= bond_.strength(p, i))
    {
        return false;
    }

    apart.direction = where.slip*(T > 0 ? 1/U : -1/U);

    return true;
}


// ************************************************************************* //
