/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "BrownianPath.H"
#include "IStringStream.H"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

using namespace Foam;
using namespace Foam::aerosol;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using vec = Eigen::Vector3d;

const gasProperties gas = gasProperties::air();

autoPtr<Brownian> law(const std::string& text)
{
    return Brownian::New(dictionary(IStringStream(text)()));
}


//- One particle, with a rate of drag [1/s]
particleArrays particle(const double rate)
{
    particleArrays p;
    p.resize(1);
    p.id(0) = 7;
    p.d(0) = 1e-6;
    p.m(0) = 1e-15;
    p.primaries(0) = 1;
    p.x.col(0) = vec(1, 2, 3);
    p.v.col(0) = vec(0.5, -0.1, 0.2);
    p.thermal.col(0) = vec(0.3, 0, -0.2);
    p.resizeLaws();
    p.rate(0) = rate;

    return p;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(BrownianPath, coolsByDragBetweenTheIncrements)
{
    const autoPtr<Brownian> process = law("type OrnsteinUhlenbeck; seed 1;");
    const BrownianPath noise(*process, gas);

    for (const double h : {1e-8, 1e-5, 1e-2})
    {
        const particleArrays p = particle(1e4);

        stepEnd end;
        noise.increment(h, p, 3, 5, end.increment);
        noise.cool(h, p, end);

        const vec expected =
            std::exp(-1e4*h)*p.thermal.col(0) + end.increment.v.col(0);

        EXPECT_LT((end.thermal.col(0) - expected).norm(), 1e-15) << h;
        EXPECT_EQ
        (
            noise.drift(p.v, p.thermal).col(0),
            p.v.col(0) - p.thermal.col(0)
        );

        // Half of the displacement by half of the time, by itself
        const stepEnd middle = noise.halfway(h, p, end);

        EXPECT_EQ(middle.increment.x, 0.5*end.increment.x);
        EXPECT_EQ(middle.increment.v.norm(), 0);
        EXPECT_LT
        (
            (
                middle.thermal.col(0)
              - std::exp(-0.5e4*h)*p.thermal.col(0)
            ).norm(),
            1e-15
        ) << h;
    }
}


TEST(BrownianPath, isSmoothInShortStepsAndStraightInLongOnes)
{
    const autoPtr<Brownian> process = law("type OrnsteinUhlenbeck; seed 1;");
    const BrownianPath noise(*process, gas);
    const double rate = 1e4;

    for (const double z : {1e-7, 1e7})
    {
        const double h = z/rate;
        const particleArrays p = particle(rate);

        stepEnd end;
        noise.increment(h, p, 3, 5, end.increment);
        end.v = p.v + end.increment.v;
        noise.split(h, p, end);

        if (z < 1)
        {
            EXPECT_LT((end.path0 - p.v).norm(), 1e-6);
            EXPECT_LT((end.path1 - end.v).norm(), 1e-6);
            continue;
        }

        // The drift at either end, and the mean of the thermal velocity
        const vec mean = end.increment.x.col(0)/h + p.thermal.col(0)/z;

        EXPECT_LT
        (
            (
                end.path0.col(0) - (p.v.col(0) - p.thermal.col(0) + mean)
            ).norm(),
            1e-6
        );
        EXPECT_LT
        (
            (
                end.path1.col(0) - (end.v.col(0) - end.thermal.col(0) + mean)
            ).norm(),
            1e-6
        );
    }
}


TEST(BrownianPath, leavesAStepAloneWithoutNoise)
{
    const autoPtr<Brownian> none = law("type none;");
    const BrownianPath noise(*none, gas);
    const particleArrays p = particle(1e4);

    EXPECT_FALSE(noise.active());
    EXPECT_EQ(noise.drift(p.v, p.thermal), p.v);

    stepEnd end;
    noise.increment(1e-5, p, 3, 5, end.increment);
    noise.split(1e-5, p, end);

    EXPECT_EQ(end.increment.x.cols(), 0);
    EXPECT_EQ(end.thermal.cols(), 0);
    EXPECT_EQ(end.path0.cols(), 0);
    EXPECT_EQ(noise.halfway(1e-5, p, end).thermal.cols(), 0);
}


// ************************************************************************* //
