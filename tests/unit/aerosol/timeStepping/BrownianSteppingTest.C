/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Brownian motion in the full time stepping: it has the temperature of the gas
// and Einstein's diffusion at any step, and those who are followed closely move
// as the others do.

#include "timeSteppingTools.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr double kB = 1.380649e-23;
constexpr double density = 1000;


//- Spheres at rest, at random in a cube
particleArrays atRest(const int n, const double d, const double length)
{
    randomNumbers random(3);
    std::vector<sphere> spheres;

    for (int i = 0; i < n; ++i)
    {
        spheres.push_back
        (
            {100 + i, d, density, random.point(0.5*length), vec::Zero()}
        );
    }

    return arrays(spheres);
}


//- The displacements since the beginning
vectors displacements(const experiment& e, const particleArrays& start)
{
    vectors r(3, e.p.size());

    for (int i = 0; i < e.p.size(); ++i)
    {
        const auto at = std::find
        (
            start.id.data(), start.id.data() + start.size(), e.p.id(i)
        );

        r.col(i) =
            e.nearest(e.p.x.col(i) - start.x.col(at - start.id.data()));
    }

    return r;
}


settings withNoise(const std::string& stepping)
{
    settings s;
    s.stepping = stepping;
    s.contact = "type none;";
    s.Brownian = "type OrnsteinUhlenbeck; seed 4;";

    return s;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(BrownianStepping, heatsAndDiffusesAtAnyStep)
{
    const double d = 0.7e-6;
    const double tau = relaxationTime(d, density);

    struct run
    {
        double hByTau;
        int steps;
        int n;
    };

    for
    (
        const std::string& stepping :
        {eventDriven, multipleTimeStep, conventional}
    )
    {
        for
        (
            const run& r :
            {
                run{0.01, 300, 1000}, run{0.1, 40, 8000}, run{1, 10, 8000},
                run{10, 5, 8000}, run{100, 3, 8000}
            }
        )
        {
            // Which resolves all particles in small steps
            const bool isSlow = stepping != eventDriven;
            const int n = isSlow && r.hByTau > 1 ? 800 : r.n;

            if (stepping == conventional && r.hByTau > 1)
            {
                continue;
            }

            const particleArrays start = atRest(n, d, 1e-2);
            experiment e(start, 0.1, withNoise(stepping));
            e.run(r.hByTau*tau, r.steps);

            // Chandrasekhar (1943), from rest
            const double z = r.hByTau*r.steps;
            const double variance = kB*gasProperties::air().T/start.m(0);
            const double vSqr = -3*variance*std::expm1(-2*z);
            const double xSqr =
                3*variance*tau*tau
               *(2*z - 3 + 4*std::exp(-z) - std::exp(-2*z));

            // Exceeded once in a million
            const double tolerance = 4.89*std::sqrt(2.0/(3*n));

            const double v = e.p.v.colwise().squaredNorm().mean();
            const double x =
                displacements(e, start).colwise().squaredNorm().mean();

            EXPECT_NEAR(v/vSqr, 1, tolerance) << stepping << ' ' << r.hByTau;
            EXPECT_NEAR(x/xSqr, 1, tolerance) << stepping << ' ' << r.hByTau;

            // All of it is Brownian motion
            EXPECT_LT((e.p.v - e.p.thermal).norm(), 1e-12*e.p.v.norm());
        }
    }
}


TEST(BrownianStepping, movesThoseInGroupsAsIfAlone)
{
    // Dense: nearly all are in large clusters, of many steps, where nobody
    // sticks. With a linear drag they arrive where they would have come alone.
    const double d = 0.05e-6;
    const double tau = relaxationTime(d, density);

    for (const double hByTau : {1.0, 10.0, 100.0})
    {
        const particleArrays start = atRest(300, d, 1.25e-6);
        const double h = hByTau*tau;

        settings law = withNoise
        (
            hByTau > 10 ? eventDriven : eventDriven + "resolution 0.02;"
        );
        experiment alone(start, 1.25e-6, law);

        law.contact = "type neverStick;";
        experiment together(start, 1.25e-6, law);

        // The touching ones, too
        alone.run(h, 4);
        together.run(h, 4);

        EXPECT_GT(together.done().clusterMembers, 600);
        EXPECT_GT
        (
            together.done().clusterMoves, 2*together.done().clusterMembers
        );
        EXPECT_GT(together.count(), 10);

        ASSERT_EQ(alone.p.size(), together.p.size());

        const double vScale = alone.p.v.norm();
        EXPECT_LT((alone.p.v - together.p.v).norm(), 1e-11*vScale);
        EXPECT_LT
        (
            (alone.p.thermal - together.p.thermal).norm(), 1e-11*vScale
        );

        double furthest = 0;
        for (int i = 0; i < alone.p.size(); ++i)
        {
            furthest = std::max
            (
                furthest,
                together.nearest(alone.p.x.col(i) - together.p.x.col(i)).norm()
            );
        }
        EXPECT_LT(furthest, 1e-11*1.25e-6);
    }
}


TEST(BrownianStepping, doesNotDependOnTheOrderOfTheParticles)
{
    const double d = 0.5e-6;
    const double tau = relaxationTime(d, density);

    for
    (
        const std::string& stepping : {eventDriven, multipleTimeStep}
    )
    {
        // Pairs, close and far from others: strong wakes, which are explicit
        std::vector<sphere> spheres;
        for (int i = 0; i < 125; ++i)
        {
            const vec x = 10*d*vec(i % 5 - 2, i/5 % 5 - 2, i/25 - 2);
            const vec gap = (0.95 + 0.002*(i % 40))*d*vec(0.6, 0, 0.8);

            spheres.push_back({2*i, d, density, x, vec::Zero()});
            spheres.push_back
            (
                {2*i + 1, 0.9*d, density, x + gap, vec::Zero()}
            );
        }
        const particleArrays start = arrays(spheres);

        std::vector<int> backwards;
        for (int i = start.size() - 1; i >= 0; --i)
        {
            backwards.push_back(i);
        }

        settings law = withNoise(stepping);
        law.contact = "type recordedStick;";
        law.wake = "type Oseen; range 20;";
        law.drag = "type SchillerNaumann; slipCorrection Cunningham;";

        experiment one(start, 50*d, law, 1000, vec(1, 0, 0));
        one.run(2*tau, 4);
        const std::size_t contacts = meetings.size();

        experiment other
        (
            start.select(backwards), 50*d, law, 1000, vec(1, 0, 0)
        );
        other.run(2*tau, 4);

        EXPECT_GT(contacts, 10u);
        EXPECT_EQ(meetings.size(), contacts);
        ASSERT_EQ(one.p.size(), other.p.size());

        const int n = one.p.size();
        for (int i = 0; i < n; ++i)
        {
            ASSERT_EQ(one.p.id(i), other.p.id(i));
            EXPECT_EQ(one.p.x.col(i), other.p.x.col(i));
            EXPECT_EQ(one.p.v.col(i), other.p.v.col(i));
            EXPECT_EQ(one.p.thermal.col(i), other.p.thermal.col(i));
        }
    }
}


TEST(BrownianStepping, keepsAMergedOneWarm)
{
    // Pairs in contact merge in the first step; soon the survivors have the
    // energy of their own mass, in clusters and in nested steps
    const double d = 0.5e-6;
    const double tau = relaxationTime(std::cbrt(2.0)*d, density);

    for
    (
        const std::string& stepping : {eventDriven, multipleTimeStep}
    )
    {
        std::vector<sphere> spheres;
        for (int i = 0; i < 1500; ++i)
        {
            const vec x
            (
                (i % 20 - 10)*40*d, (i/20 % 20 - 10)*40*d, (i/400 - 2)*40*d
            );
            spheres.push_back({2*i, d, density, x, vec::Zero()});
            spheres.push_back
            (
                {2*i + 1, d, density, x + vec(1.0001*d, 0, 0), vec::Zero()}
            );
        }

        settings law = withNoise(stepping);
        law.contact = "type recordedStick;";
        experiment e(arrays(spheres), 1000*d, law);

        e.run(4*tau, 1);

        // Nearly all have; of them, those who have been one for long are warm
        double sum = 0;
        int n = 0;
        for (int i = 0; i < e.p.size(); ++i)
        {
            if (e.p.primaries(i) == 2)
            {
                sum += e.p.m(i)*e.p.v.col(i).squaredNorm();
                ++n;
            }
        }

        EXPECT_GT(n, 1000) << stepping;
        EXPECT_NEAR
        (
            sum/(3*n*kB*gasProperties::air().T), 1, 4.89*std::sqrt(2.0/(3*n))
        ) << stepping;
    }
}


// ************************************************************************* //
