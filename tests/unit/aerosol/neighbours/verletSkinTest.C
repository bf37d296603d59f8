/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Skins: a particle that leaves its own is noticed, and in periodic sound none
    does
    for long. Paths are known: a swing about a place, with a mean motion.

\*---------------------------------------------------------------------------*/

#include "randomNumbers.H"
#include "verletSkin.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

namespace
{

constexpr int n = 300;
constexpr double frequency = 1400;
constexpr double omega = 2*EIGEN_PI*frequency;
constexpr double u0 = 1.5;

//- Particles in gas that swings along x, long after the start, at time t
struct swing
{
    vectors middle;
    particleArrays p;

    swing()
    {
        randomNumbers random(4);

        p.resize(n);
        p.resizeLaws();
        middle.resize(3, n);

        for (int i = 0; i < n; ++i)
        {
            p.id(i) = i;
            p.d(i) = random.logUniform(0.5e-6, 8e-6);
            p.m(i) = 2300*EIGEN_PI/6*std::pow(p.d(i), 3);
            p.primaries(i) = 1;
            p.rate(i) = 18*1.81e-5/(2300*p.d(i)*p.d(i));
            p.acceleration.col(i).setZero();
            p.range(i) = 0;
            p.mobilityDiameter(i) = p.d(i);
            p.collisionDiameter(i) = p.d(i);
            middle.col(i) = random.point(0.5e-3);
        }

        at(0);
    }

    void at(const double t)
    {
        p.v.setZero();

        for (int i = 0; i < n; ++i)
        {
            const double s = omega/p.rate(i);
            const double eta = 1/std::sqrt(1 + s*s);
            const double phase = omega*t - std::atan(s);

            p.x.col(i) = middle.col(i);
            p.x(0, i) += eta*u0/omega*std::sin(phase);
            p.v(0, i) = eta*u0*std::cos(phase);
        }
    }
};


//- Rooms at time t, for steps of length h
void make
(
    verletSkin& all,
    swing& air,
    const double t,
    const double h,
    const double concentration
)
{
    air.at(t + h);
    const particleArrays next = air.p;
    air.at(t);

    all.make
    (
        air.p, next.x, next.v, {}, 2*air.p.d, h, frequency, u0, concentration
    );
}


//- Mean way of all
Eigen::Vector3d meanWay(const vectors& x0, const vectors& x1)
{
    return (x1 - x0).rowwise().mean();
}


//- How far each gets beside a common way
scalars ways
(
    const vectors& x0,
    const vectors& x1,
    const Eigen::Vector3d& common
)
{
    return
        ((x1 - x0).colwise() - common).colwise().norm().transpose().array();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(verletSkin, lastForManyPeriodsOfSound)
{
    for (const double stepsPerPeriod : {20, 50, 200})
    {
        const double h = 1/frequency/stepsPerPeriod;

        swing air;
        verletSkin all;
        make(all, air, 0.3/frequency, h, 1e10);

        // Ten periods, in which each swings about its place
        for (int s = 0; s < 10*stepsPerPeriod; ++s)
        {
            const particleArrays before = air.p;
            air.at(0.3/frequency + (s + 1)*h);

            const Eigen::Vector3d way = meanWay(before.x, air.p.x);

            ASSERT_TRUE
            (
                all.contain(before, 1.1*ways(before.x, air.p.x, way))
            ) << stepsPerPeriod << " " << s;
            ASSERT_TRUE
            (
                all.hold
                (
                    before, before.v, air.p.x, air.p.v, h, way, 4, scalars()
                )
            ) << stepsPerPeriod << " " << s;
            ASSERT_FALSE(all.expired());

            all.move(way);
        }
    }
}


TEST(verletSkin, areSmallAgainstTheSwingOfTheGas)
{
    swing air;
    verletSkin all;
    make(all, air, 0.3/frequency, 1/frequency/50, 2.4e11);

    EXPECT_LT(all.sizes().minCoeff(), 0.25*u0/omega);
    EXPECT_LT(all.sizes().mean(), 0.5*u0/omega);
}


TEST(verletSkin, noticeWhoeverLeaves)
{
    const double h = 1/frequency/50;

    for (int i = 0; i < n; i += 7)
    {
        swing air;
        verletSkin all;
        make(all, air, 0, h, 1e10);

        const particleArrays before = air.p;
        air.at(h);

        // The mean of the others
        const Eigen::Vector3d way = meanWay(before.x, air.p.x);

        air.p.x.col(i) = all.centres().col(i) + way;
        air.p.x(2, i) += all.sizes()(i);

        // Also beforehand, by a particle that might get as far
        scalars far = ways(before.x, air.p.x, way);
        EXPECT_FALSE(all.contain(before, far));
        far(i) = 0;
        EXPECT_TRUE(all.contain(before, far));

        EXPECT_FALSE
        (
            all.hold(before, before.v, air.p.x, air.p.v, h, way, 4, scalars())
        );
        EXPECT_TRUE(all.expired());
    }
}


TEST(verletSkin, areLeftByThoseThatGrowOrComeBackFromACluster)
{
    swing air;
    verletSkin all;

    const auto again = [&]()
    {
        make(all, air, 0, 1/frequency/50, 1e10);
    };

    again();
    const Eigen::Vector3d centre = all.centres().col(5);
    const double size = all.sizes()(5);

    all.check(5, centre, 0.99*size);
    EXPECT_FALSE(all.expired());
    all.check(5, centre, 1.01*size);
    EXPECT_TRUE(all.expired());

    again();
    EXPECT_FALSE(all.expired());
    all.shrink(5, 0.02*size);
    all.check(5, centre, 0.99*size);
    EXPECT_TRUE(all.expired());

    again();
    all.move({0, 0, size});
    all.check(5, centre, 0.01*size);
    EXPECT_TRUE(all.expired());
}


// ************************************************************************* //
