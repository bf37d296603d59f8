/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ProudmanPearsonWake.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(ProudmanPearsonWake, 0);
    addToRunTimeSelectionTable(wake, ProudmanPearsonWake, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::ProudmanPearsonWake::ProudmanPearsonWake(const dictionary& dict)
:
    OseenWake(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::ProudmanPearsonWake::range
(
    const scalars& d,
    const scalars& slip
) const
{
    const scalars far = OseenWake::range(d, slip);

    return tolerance() > 0 ? far.max(0.5*outer/fadeBegin*d).eval() : far;
}


void Foam::aerosol::ProudmanPearsonWake::evaluate
(
    block& pairs,
    const acoustics::gasProperties& gas
) const
{
    OseenWake::evaluate(pairs, gas);

    const blockVectors& s = pairs.r;
    const blockVectors& U = pairs.slip;

    const blockScalars distanceSqr =
        s[0].square() + s[1].square() + s[2].square();

    // Most pairs of a dilute aerosol are far from each other. The margin keeps
    // rounding from making a result depend on the other pairs of its block.
    constexpr double farAway = 1.001*outer;
    if ((distanceSqr - farAway*farAway*pairs.radius.square()).minCoeff() > 0)
    {
        return;
    }

    const blockScalars distance = distanceSqr.sqrt();
    const blockScalars R = distance/pairs.radius;

    const blockScalars x =
        ((R - inner)/(outer - inner)).max(0.0).min(1.0);
    const blockScalars far = x.square()*(3 - 2*x);
    const blockScalars near = 1 - far;

    const blockScalars perDistance = 1/distance;
    const blockScalars e0 = s[0]*perDistance;
    const blockScalars e1 = s[1]*perDistance;
    const blockScalars e2 = s[2]*perDistance;
    const blockScalars along = U[0]*e0 + U[1]*e1 + U[2]*e2;
    const blockScalars speedSqr =
        U[0].square() + U[1].square() + U[2].square();

    // k/|U|. Not quite the root of zero: Eigen's AVX-512 one raises an
    // exception
    const blockScalars kappa = (0.375/gas.nu())*pairs.radius;
    const blockScalars onePlusK = 1 + kappa*(speedSqr + 1e-60).sqrt();

    // Exactly one at the surface and within, where gap is exactly zero
    const blockScalars q = pairs.radius/distance.max(pairs.radius);
    const blockScalars gap = 1 - q;

    const blockScalars even = 1 + 0.25*q*(1 + q);
    const blockScalars odd = even + 0.5*q.cube();

    const blockScalars transverse = gap*(onePlusK*even - kappa*along*odd);
    const blockScalars radial =
        gap.square()
       *(
            0.5*(2 + q)*onePlusK*along
          - 0.25*kappa*(2 + q + q.square())*(3*along.square() - speedSqr)
        );

    // The gas relative to the sphere is transverse (U - (U.e) e) + radial e
    const blockScalars outward = near*(radial - transverse*along);
    const blockScalars forward = near*(transverse - 1);

    pairs.velocity[0] = outward*e0 + forward*U[0] + far*pairs.velocity[0];
    pairs.velocity[1] = outward*e1 + forward*U[1] + far*pairs.velocity[1];
    pairs.velocity[2] = outward*e2 + forward*U[2] + far*pairs.velocity[2];
}


// ************************************************************************* //
