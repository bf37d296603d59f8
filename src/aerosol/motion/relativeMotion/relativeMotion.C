/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "relativeMotion.H"
#include "communicator.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::relativeMotion::relativeMotion
(
    const equationOfMotion& motion,
    const domain& region
)
:
    motion_(motion),
    domain_(region)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::relativeMotion::relativeSpeed
(
    const particleArrays& p,
    const stepValues& gas
) const
{
    const vectors drift = p.v - p.thermal;
    const Eigen::Vector3d mean = communicator::mean(drift);

    const auto speed = [&](const vectors& v)
    {
        return (v.colwise() - mean).colwise().norm().array().transpose();
    };

    return speed(drift).max(speed(gas.u0)).max(speed(gas.u1));
}


Foam::scalar Foam::aerosol::relativeMotion::largestSpeed
(
    const particleArrays& p,
    const stepValues& gas,
    const scalar h
) const
{
    scalars speed = relativeSpeed(p, gas);

    if (motion_.noise().active())
    {
        speed +=
            p.thermal.colwise().norm().transpose().array()
          + nDeviations*motion_.noise().reach(h, p).v;
    }

    return 2*communicator::max(speed.size() ? speed.maxCoeff() : 0.0);
}


Foam::aerosol::scalars Foam::aerosol::relativeMotion::relativeDisplacement
(
    const particleArrays& p,
    const stepValues& gas,
    const scalar h
) const
{
    scalars displacement =
        h*(relativeSpeed(p, gas) + particleLaws::gain(p, h));

    if (motion_.noise().active())
    {
        displacement +=
            p.thermal.colwise().norm().transpose().array()
           *particleLaws::relaxationTime(p).min(h)
          + nDeviations*motion_.noise().reach(h, p).x;
    }

    // Without another particle there is no limit
    const bool alone = communicator::sum(p.size()) < 2;

    requireShort(p.size() && !alone ? displacement.maxCoeff() : 0.0, h);

    return displacement;
}


void Foam::aerosol::relativeMotion::requireShort
(
    const scalar displacement,
    const scalar h
) const
{
    const scalar furthest = communicator::max(displacement);
    const scalar shortest = domain_.bounds().minDim();

    if (furthest > shortest)
    {
        FatalErrorInFunction
            << "In one fluid step of " << h << " s a particle can move by "
            << furthest << " m relative to the others, which is more than the "
            << "shortest edge of the domain, " << shortest
            << " m. Reduce deltaT of system/controlDict"
            << exit(FatalError);
    }
}


// ************************************************************************* //
