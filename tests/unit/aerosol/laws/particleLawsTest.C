/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "motionTools.H"
#include "error.H"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::motionTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pi = EIGEN_PI;

const std::string all =
    "drag { type Stokes; slipCorrection none; }"
    "gravity { type uniform; value (0 0 -9.81); }"
    "wake { type Oseen; range 10; }"
    "aggregate { type fractal; dimension 1.8; }";

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(particleLaws, workOutWhatFollowsFromSize)
{
    const gasProperties gas = gasProperties::air();
    const particleLaws laws(parse(all), gas, slipBound(1400, 1.5));

    particleArrays p = spheres({2e-6, 5e-6, 20e-6}, 2000);
    laws.refresh(p);

    for (int i = 0; i < p.size(); ++i)
    {
        const double tau = p.m(i)/(3*pi*gas.mu*p.d(i));
        const double displaced = gas.rho*pi/6*std::pow(p.d(i), 3)/p.m(i);
        const double s = 2*pi*1400*tau;
        const double fall = 9.81*(1 - displaced);

        EXPECT_NEAR(p.rate(i)*tau, 1, 1e-14);
        EXPECT_NEAR(particleLaws::relaxationTime(p)(i)/tau, 1, 1e-14);
        EXPECT_NEAR(-p.acceleration(2, i)/fall, 1, 1e-14);
        EXPECT_NEAR(p.range(i)/p.d(i), 10, 1e-14);
        EXPECT_EQ(p.mobilityDiameter(i), p.d(i));
        EXPECT_EQ(p.collisionDiameter(i), p.d(i));
        EXPECT_LT
        (
            std::abs(p.response(i) - 1.0/std::complex<double>(1, s)), 1e-14
        );
        EXPECT_NEAR
        (
            laws.largestSlip(p, i),
            tau*fall + 1.5*s/std::sqrt(1 + s*s),
            1e-13
        );
        EXPECT_NEAR
        (
            particleLaws::gain(p, tau/3)(i)/(fall*tau/3), 1, 1e-14
        );
        EXPECT_NEAR(particleLaws::gain(p, 3*tau)(i)/(fall*tau), 1, 1e-14);
    }
}


TEST(particleLaws, areThoseOfTheParticleOnly)
{
    // One that has grown has what it would have among others
    const gasProperties gas = gasProperties::air();
    const particleLaws laws(parse(all), gas, slipBound(1400, 1.5));

    particleArrays p = spheres({2e-6, 5e-6, 20e-6}, 2000);
    laws.refresh(p);

    p.d(1) *= std::cbrt(3.0);
    p.m(1) *= 3;
    p.primaries(1) = 3;

    particleArrays again = p;
    laws.refresh(p, 1);
    laws.refresh(again);

    EXPECT_GT(p.collisionDiameter(1), p.d(1));
    EXPECT_TRUE((p.rate == again.rate).all());
    EXPECT_TRUE((p.response == again.response).all());
    EXPECT_TRUE((p.range == again.range).all());
    EXPECT_TRUE((p.mobilityDiameter == again.mobilityDiameter).all());
    EXPECT_TRUE((p.collisionDiameter == again.collisionDiameter).all());
    EXPECT_EQ(p.acceleration, again.acceleration);
}


TEST(particleLaws, refuseToGuess)
{
    const gasProperties gas = gasProperties::air();

    for (const word name : {"drag", "gravity", "wake", "aggregate"})
    {
        dictionary dict = parse(all);
        dict.remove(name);

        EXPECT_THROW(particleLaws(dict, gas), IOerror) << name;
    }
}


// ************************************************************************* //
