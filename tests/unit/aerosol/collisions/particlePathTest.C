/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The cubic path of a particle, and when two spheres on theirs meet: against
    straight lines and dense samples.

\*---------------------------------------------------------------------------*/

#include "particlePath.H"
#include "randomNumbers.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::aerosol;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Across the middle, bent at random, from x = side
particlePath bent(testTools::randomNumbers& random, const double side)
{
    const Eigen::Vector3d x(side, 0, 0);

    const Eigen::Vector3d x0 = x + random.point(0.5);
    const Eigen::Vector3d v0 = -2*x + random.point(3);
    const Eigen::Vector3d x1 = -x + random.point(0.5);
    const Eigen::Vector3d v1 = -2*x + random.point(3);

    return {x0, v0, x1, v1, 1};
}

double distance(const particlePath& a, const particlePath& b, const double t)
{
    return (b.position(t) - a.position(t)).norm();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(particlePath, hasTheEndsThatAreGiven)
{
    const Eigen::Vector3d x0(1, 2, 3), v0(4, -5, 6), x1(-1, 0, 2), v1(0, 7, 1);
    const particlePath path(x0, v0, x1, v1, 0.5);

    EXPECT_TRUE(path.position(0).isApprox(x0, 1e-15));
    EXPECT_TRUE(path.velocity(0).isApprox(v0, 1e-15));
    EXPECT_TRUE(path.position(0.5).isApprox(x1, 1e-15));
    EXPECT_TRUE(path.velocity(0.5).isApprox(v1, 1e-14));

    // The velocity is that of the position
    const Eigen::Vector3d slope =
        (path.position(0.2 + 1e-5) - path.position(0.2 - 1e-5))/2e-5;
    EXPECT_TRUE(path.velocity(0.2).isApprox(slope, 1e-8));
}


TEST(particlePath, goesOnAsItWas)
{
    testTools::randomNumbers random(1);

    const particlePath path = bent(random, 1);
    const particlePath rest = path.rest(0.3);
    const Eigen::Vector3d shift(1, -2, 3);

    for (const double t : {0.0, 0.2, 0.5, 0.7})
    {
        EXPECT_TRUE(rest.position(t).isApprox(path.position(0.3 + t), 1e-13));
        EXPECT_TRUE
        (
            path.moved(shift).position(t).isApprox
            (
                path.position(t) + shift, 1e-13
            )
        );
    }
}


TEST(particlePath, touchesOnStraightLinesWhenItMust)
{
    const Eigen::Vector3d v(3, 0, 0);
    const Eigen::Vector3d rest(0, 0, 0);
    const particlePath a({0, 0, 0}, v, {3, 0, 0}, v, 1);
    const particlePath b({2, 0.3, 0}, rest, {2, 0.3, 0}, rest, 1);

    const double expected = (2 - std::sqrt(0.5*0.5 - 0.3*0.3))/3;

    EXPECT_NEAR(particlePath::firstTouch(a, b, 0.5, false), expected, 1e-9);
    EXPECT_NEAR(particlePath::firstTouch(a, b, 0.5, true), expected, 1e-9);
    EXPECT_NEAR(particlePath::firstApproach(a, b, 0.5), expected, 1e-9);

    // It passes by
    EXPECT_GT(particlePath::firstTouch(a, b, 0.29, false), 1);
}


TEST(particlePath, onlyNewContactsCountIfAskedFor)
{
    const Eigen::Vector3d v(1, 0, 0);
    const Eigen::Vector3d rest(0, 0, 0);
    const particlePath leaving({0.1, 0, 0}, v, {1.1, 0, 0}, v, 1);
    const particlePath fixed(rest, rest, rest, rest, 1);

    EXPECT_EQ(particlePath::firstTouch(fixed, leaving, 0.5, false), 0);
    EXPECT_GT(particlePath::firstTouch(fixed, leaving, 0.5, true), 1);

    // Overlaps but separates
    EXPECT_GT(particlePath::firstApproach(fixed, leaving, 0.5), 1);
}


TEST(particlePath, missesNoContactOfBentPaths)
{
    constexpr int samples = 20000;
    constexpr double touch = 0.3;
    int met = 0;

    testTools::randomNumbers random(7);

    for (int n = 0; n < 300; ++n)
    {
        const particlePath a = bent(random, 1);
        const particlePath b = bent(random, -1);

        if (distance(a, b, 0) < touch)
        {
            continue;
        }

        int first = 0;
        while
        (
            first <= samples
         && distance(a, b, first/double(samples)) > touch
        )
        {
            ++first;
        }

        const double when = particlePath::firstTouch(a, b, touch, false);

        if (first <= samples)
        {
            ++met;
            EXPECT_FALSE(a.staysAwayFrom(b, touch)) << n;
            EXPECT_LE(when, first/double(samples) + 1e-9) << n;
            EXPECT_NEAR(distance(a, b, when), touch, 1e-6*touch) << n;
        }
        else if (when <= 1)
        {
            // Between two samples
            EXPECT_NEAR(distance(a, b, when), touch, 1e-6*touch) << n;
        }
    }

    EXPECT_GT(met, 50);
}


// ************************************************************************* //
