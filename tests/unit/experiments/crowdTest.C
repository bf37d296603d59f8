/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeSteppingTools.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_P(eachTimeStepping, conservesMassAndMomentum)
{
    // Fast particles without drag, crowded: most of them merge
    randomNumbers random(1);
    std::vector<sphere> spheres =
        aerosolOf(300, 100e-6, 1e-6, 8e-6, 1000, 0, 0, 1);

    for (sphere& s : spheres)
    {
        s.v = random.point(1);
    }

    particleArrays start = arrays(spheres);

    // Whole multiples of a unit, so that sums are exact in any order
    start.m = (start.m*std::ldexp(1, 80)).round()*std::ldexp(1, -80);

    experiment gas(start, 100e-6, with("type none;"));

    const vec momentum = start.v*start.m.matrix();
    const double scale =
        start.m.matrix().dot(start.v.colwise().norm().transpose());

    for (int n = 0; n < 10; ++n)
    {
        gas.run(4e-6, 1);

        EXPECT_EQ(gas.p.m.sum(), start.m.sum());
        EXPECT_EQ(gas.p.primaries.sum(), 300);
        EXPECT_EQ(gas.p.size(), 300 - gas.count());
        EXPECT_LT((gas.p.v*gas.p.m.matrix() - momentum).norm(), 1e-13*scale);
        EXPECT_NEAR(gas.p.d.cube().sum()/start.d.cube().sum(), 1, 1e-13);
    }

    EXPECT_GT(gas.count(), 60);
    EXPECT_EQ(gas.count(), int(meetings.size()));

    for (const meeting& m : meetings)
    {
        EXPECT_LE((m.xi - m.xj).norm(), m.touch*(1 + 1e-12));
    }
}


TEST_P(eachTimeStepping, findsWhatBruteForceFinds)
{
    const double length = 200e-6;
    const double frequency = 2000;
    const double omega = 2*pi*frequency;
    const double u = 0.6;
    const double density = 1500;

    const std::vector<sphere> spheres =
        aerosolOf(160, length, 3e-6, 20e-6, density, frequency, u, 3);

    // All pairs in tiny steps, on paths in closed form
    std::vector<std::unique_ptr<freePath>> paths;

    for (const sphere& s : spheres)
    {
        paths.emplace_back
        (
            new freePath
            (
                0, s.x, s.v, s.d, s.density*pi/6*s.d*s.d*s.d, omega, u
            )
        );
    }

    const int steps = 6000;
    const double end = 1.2/frequency;
    std::vector<meeting> expected;
    vectors x(3, spheres.size());

    for (int s = 0; s <= steps; ++s)
    {
        const double t = s*end/steps;

        for (std::size_t i = 0; i < paths.size(); ++i)
        {
            if (paths[i])
            {
                x.col(i) = paths[i]->x(t);
            }
        }

        for (std::size_t i = 0; i < paths.size(); ++i)
        {
            for (std::size_t j = i + 1; paths[i] && j < paths.size(); ++j)
            {
                if (!paths[j])
                {
                    continue;
                }

                const double touch = 0.5*(paths[i]->d + paths[j]->d);
                vec r = x.col(j) - x.col(i);

                // Most are apart in the first direction
                for (int k = 0; k < 3; ++k)
                {
                    r(k) -= length*std::nearbyint(r(k)/length);
                    if (std::abs(r(k)) > touch)
                    {
                        break;
                    }
                }

                if (r.squaredNorm() > touch*touch)
                {
                    continue;
                }

                const double mi = paths[i]->m;
                const double mj = paths[j]->m;
                const double m = mi + mj;

                expected.push_back
                ({
                    std::int64_t(i), std::int64_t(j), {}, {}, {}, {}, touch, t
                });

                std::unique_ptr<freePath> both
                (
                    new freePath
                    (
                        t,
                        x.col(i) + mj/m*r,
                        (mi*paths[i]->v(t) + mj*paths[j]->v(t))/m,
                        std::cbrt
                        (
                            std::pow(paths[i]->d, 3) + std::pow(paths[j]->d, 3)
                        ),
                        m,
                        omega,
                        u
                    )
                );

                const std::size_t survivor = mi >= mj ? i : j;
                paths[i].reset();
                paths[j].reset();
                paths[survivor] = std::move(both);
                x.col(survivor) = paths[survivor]->x(t);
            }
        }
    }

    settings law = with("type Stokes; slipCorrection none;");
    experiment box(arrays(spheres), length, law, frequency, {u, 0, 0});
    box.run(end/240, 240);

    // Not a test of nothing
    EXPECT_GT(expected.size(), 10u);
    ASSERT_EQ(meetings.size(), expected.size());

    // A collision step at the largest possible relative speed, plus what the
    // straight lines between samples of the gas and the brute force cost
    const double late = 0.1*3e-6/u + end/steps;

    for (std::size_t n = 0; n < expected.size(); ++n)
    {
        const auto same = std::find_if
        (
            meetings.begin(), meetings.end(),
            [&](const meeting& m) { return m.pair() == expected[n].pair(); }
        );

        ASSERT_TRUE(same != meetings.end())
            << expected[n].idI << ' ' << expected[n].idJ << " at "
            << expected[n].time;
        EXPECT_NEAR(same->time, expected[n].time, late);
    }

    // And all are where they should be at the end
    for (int i = 0; i < box.p.size(); ++i)
    {
        const auto& path = paths[box.p.id(i)];
        ASSERT_TRUE(path);
        EXPECT_LT(box.nearest(box.p.x.col(i) - path->x(end)).norm(), 0.3e-6);
    }
}


TEST(multipleTimeStep, meetsTheSamePairsEveryPeriodWithoutAggregates)
{
    // What passes another one passes it again in every period
    const double frequency = 1400;
    settings s;
    s.aggregate = "type none;";

    experiment box
    (
        arrays(aerosolOf(400, 250e-6, 2e-6, 12e-6, 2000, frequency, 0.5, 5)),
        250e-6, s, frequency, {0.5, 0, 0}
    );

    std::vector<int> counts;
    for (int period = 0; period < 4; ++period)
    {
        const int before = box.count();
        box.run(1/frequency/100, 100);
        counts.push_back(box.count() - before);
    }

    EXPECT_EQ(box.p.size(), 400);
    EXPECT_GT(counts[0], 30);
    EXPECT_EQ(counts[1], counts[0]);
    EXPECT_EQ(counts[2], counts[0]);
    EXPECT_EQ(counts[3], counts[0]);
}


TEST(multipleTimeStep, stopsAgglomeratingByOrthokineticMotionAlone)
{
    // Nothing refills the volume that a particle has swept
    const double frequency = 1400;

    experiment box
    (
        arrays(aerosolOf(1000, 350e-6, 2e-6, 12e-6, 2000, frequency, 0.5, 6)),
        350e-6, settings(), frequency, {0.5, 0, 0}
    );

    box.run(1/frequency/100, 100);
    const int first = box.count();

    // Aggregates relax to a path of their own, and may meet others once
    box.run(1/frequency/100, 300);
    const int settling = box.count() - first;

    box.run(1/frequency/100, 500);
    const int late = box.count() - first - settling;

    EXPECT_GT(first, 30);
    EXPECT_LT(settling, 0.5*first);
    EXPECT_LT(late, 0.05*first);
}


TEST(multipleTimeStep, findsTheSamePairsAsConventional)
{
    const double frequency = 1400;
    settings s;
    s.wake = "type Oseen; range 12;";
    s.gravity = "type uniform; value (0 -9.81 0);";
    s.drag = "type SchillerNaumann; slipCorrection Cunningham;";

    using pairs = std::vector<std::pair<std::int64_t, std::int64_t>>;

    const auto pairsMet = [&](const std::string& stepping, const int seed)
    {
        s.stepping = stepping;

        experiment box
        (
            arrays
            (
                aerosolOf(80, 200e-6, 3e-6, 15e-6, 2000, frequency, 0.5, seed)
            ),
            200e-6, s, frequency, {0.5, 0, 0}
        );

        box.run(1/frequency/200, 200);

        pairs met;
        for (const meeting& m : meetings)
        {
            met.push_back(m.pair());
        }
        return met;
    };

    for (const int seed : {7, 8})
    {
        const pairs met = pairsMet(multipleTimeStep, seed);

        EXPECT_GE(met.size(), 4u);
        EXPECT_EQ(met, pairsMet(conventional, seed));
    }
}


// ************************************************************************* //
