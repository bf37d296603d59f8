/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coalescence.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(coalescence, 0);
    addToRunTimeSelectionTable(contactOutcome, coalescence, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::coalescence::coalescence(const dictionary& dict)
:
    surfaceTension_(readPositive(dict, "surfaceTension", dimForce/dimLength))
{
    requireOnly(dict, {"type", "surfaceTension"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::aerosol::coalescence::sticks
(
    const particleArrays& p,
    const encounter& e
) const
{
    const double small = std::min(p.d(e.i), p.d(e.j));
    const double ratio = std::max(p.d(e.i), p.d(e.j))/small;
    const double density =
        (p.m(e.i) + p.m(e.j))
       /(EIGEN_PI/6*small*small*small*(1 + ratio*ratio*ratio));

    // The part of v^2 across the line of centres, v^2 sin^2(theta)
    const double head = e.approach();
    const double across =
        std::max(0.0, (e.vi - e.vj).squaredNorm() - head*head);

    return
        density*0.5*small*across
     <= 2.4*surfaceTension_*ratio*(2.7 + ratio*(ratio - 2.4));
}


// ************************************************************************* //
