/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wakeInteraction.H"
#include "motionTools.H"
#include "periodicBox.H"
#include "periodicPairs.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::motionTools;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wakeInteraction, fadesWakesOutTowardsTheirRange)
{
    const gasProperties gas = gasProperties::air();
    equationOfMotion motion
    (
        laws("Stokes", "type Oseen; range 10;"), gas, Eigen::Array3d::Ones()
    );

    // The range is that of the source: 80 um for 8 um, 20 um for 2 um
    particleArrays p = spheres({8e-6, 2e-6}, 2000);
    motion.laws().refresh(p);

    EXPECT_NEAR(p.range(0), 80e-6, 1e-18);
    EXPECT_NEAR(p.range(1), 20e-6, 1e-18);

    const vectors still = vectors::Zero(3, 2);
    p.v.setConstant(0.1);

    const vec direction = vec(1, 2, -2)/3;

    // By each at the other one, over Oseen's flow; those who are out of range
    // may be in the list or not
    const auto shares = [&](const double r)
    {
        p.x.col(0) = vec(0.1, 0.2, 0.3);
        p.x.col(1) = p.x.col(0) + r*direction;

        vectors w;
        motion.wakes().sum(p, everyPair(2), p.x, p.v, still, w);

        const auto share = [&](const int source, const double sign)
        {
            return
                w.col(1 - source).norm()
               /OseenFlow
                (
                    sign*r*direction, -p.v.col(source), 0.5*p.d(source),
                    gas.nu()
                ).norm();
        };

        return std::array<double, 2>{share(0, 1), share(1, -1)};
    };

    for (const double r : {10e-6, 14.1e-6, 56.5e-6})
    {
        EXPECT_NEAR(shares(r)[0], 1, 1e-8) << r;
        EXPECT_EQ(shares(r)[1] > 0.999, r < 20e-6) << r;
    }

    // The half at sqrt(3)/2 of the range, nothing beyond it
    EXPECT_NEAR(shares(std::sqrt(0.75)*80e-6)[0], 0.5, 1e-8);
    EXPECT_NEAR(shares(std::sqrt(0.75)*20e-6)[1], 0.5, 1e-8);
    EXPECT_EQ(shares(80.01e-6)[0], 0);
    EXPECT_EQ(shares(20.01e-6)[1], 0);

    // Slope and curvature are continuous where it begins and ends
    for (const double h : {0.001, 0.01})
    {
        const double gone = 10*std::pow(2*h, 3);

        EXPECT_NEAR(1 - shares(80e-6*std::sqrt(0.5 + h))[0], gone, 0.1*gone);
        EXPECT_NEAR(shares(80e-6*std::sqrt(1 - h))[0], gone, 0.1*gone);
    }
}


TEST(wakeInteraction, sumsTheWakesOfAllImages)
{
    const gasProperties gas = gasProperties::air();
    const periodicBox box
        (parse("centre (0.01 0 0); length (180e-6 100e-6 140e-6);"));

    equationOfMotion motion
    (
        laws("Stokes", "type Oseen; range 20;"), gas, box.period()
    );

    // Up to 160 um: further than the box is long in two directions
    std::mt19937_64 engine(1);
    const auto random = [&]()
    {
        return std::ldexp(double(engine() >> 11), -53);
    };

    std::vector<double> d;
    for (int i = 0; i < 40; ++i)
    {
        d.push_back(1e-6*std::pow(8, random()));
    }

    particleArrays p = spheres(d, 2000);
    vectors u(3, p.size());

    for (int i = 0; i < p.size(); ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            p.x(k, i) =
                box.bounds().min()[k] + random()*box.bounds().span()[k];
            p.v(k, i) = random() - 0.5;
            u(k, i) = random() - 0.5;
        }
    }

    motion.laws().refresh(p);

    const std::vector<particlePair> pairs =
        testTools::actingPairs(box, p.x, p.range);

    EXPECT_GT(pairs.size(), 500u);

    vectors w;
    motion.wakes().sum(p, pairs, p.x, p.v, u, w);

    for (int i = 0; i < p.size(); ++i)
    {
        vec expected = vec::Zero();

        for (int j = 0; j < p.size(); ++j)
        {
            for (int image = 0; j != i && image < 125; ++image)
            {
                const vec m(image/25 - 2, image/5%5 - 2, image%5 - 2);
                const vec r =
                    p.x.col(i) - p.x.col(j) - m.cwiseProduct
                    (
                        box.period().matrix()
                    );

                // Overlapping spheres: as at the surface
                const double a = 0.5*p.d(j);

                if (r.norm() <= 20*p.d(j))
                {
                    const double s = std::max
                    (
                        2*std::pow(r.norm()/(20*p.d(j)), 2) - 1, 0.0
                    );

                    expected +=
                        (1 - 10*s*s*s + 15*s*s*s*s - 6*std::pow(s, 5))
                       *OseenFlow
                        (
                            r*std::max(1.0, a/r.norm()),
                            u.col(j) - p.v.col(j),
                            a,
                            gas.nu()
                        );
                }
            }
        }

        EXPECT_LT((w.col(i) - expected).norm(), 1e-10) << i;
    }
}


TEST(wakeInteraction, doesNotDependOnTheOrderOfPairs)
{
    // To the last bit
    const gasProperties gas = gasProperties::air();

    for (const std::string wake : {"Oseen", "memory"})
    {
        const equationOfMotion motion
        (
            laws
            (
                "Stokes",
                "type " + wake + "; range 50;"
              + (wake == "memory" ? " frequency 1000;" : "")
            ),
            gas,
            Eigen::Array3d::Ones()
        );

        const int n = 30;
        particleArrays p = spheres(std::vector<double>(n, 5e-6), 2000);
        vectors u(3, n);
        stepValues air;

        for (int i = 0; i < n; ++i)
        {
            p.x.col(i) = 40e-6*vec(std::sin(7*i), std::cos(5*i), std::sin(3*i));
            p.v.col(i) = vec(0.01*i, 0.2, -0.5);
            u.col(i) = vec(1, -0.03*i, 0.4);
        }
        air.u0 = u;
        air.u1 = -u;

        motion.laws().refresh(p);
        const vectors imaginary =
            motion.wakes().imaginarySlip(p.rate, air, 0, 1e-5);

        EXPECT_EQ(imaginary.cols() > 0, motion.wakes().asksForPhase());

        std::vector<particlePair> pairs = everyPair(n);
        vectors w;
        motion.wakes().sum(p, pairs, p.x, p.v, u, w, imaginary);
        EXPECT_GT(w.norm(), 0);

        std::mt19937 engine(1);
        for (int k = 0; k < 5; ++k)
        {
            std::shuffle(pairs.begin(), pairs.end(), engine);

            vectors again;
            motion.wakes().sum(p, pairs, p.x, p.v, u, again, imaginary);
            EXPECT_EQ(again, w) << wake;
        }
    }
}


TEST(wakeInteraction, ignoresItsWakesWithoutAny)
{
    const gasProperties gas = gasProperties::air();
    equationOfMotion motion(laws("Stokes"), gas, Eigen::Array3d::Ones());

    particleArrays p = spheres({1e-6, 1e-6}, 2000);
    motion.laws().refresh(p);

    EXPECT_FALSE(motion.wakes().active());
    EXPECT_TRUE((p.range == 0).all());
    EXPECT_TRUE((motion.laws().gain(p, 1) == 0).all());

    vectors w;
    motion.wakes().sum(p, everyPair(2), p.x, p.v, vectors::Ones(3, 2), w);

    ASSERT_EQ(w.cols(), 2);
    EXPECT_EQ(w.norm(), 0);
}


// ************************************************************************* //
