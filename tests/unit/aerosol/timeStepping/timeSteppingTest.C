/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeSteppingTools.H"
#include "error.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

INSTANTIATE_TEST_SUITE_P
(
    timeStepping,
    eachTimeStepping,
    testing::Values(multipleTimeStep, conventional, eventDriven)
);


TEST_P(eachTimeStepping, findsTheTimeAndPlaceOfAContact)
{
    const double length = 100e-6;
    const double kc = 0.1;

    // In the middle of the box, across a face, an edge and a corner
    for
    (
        const vec& centre :
        {vec(0, 0, 0), vec(50e-6, 0, 0), vec(0, -50e-6, 50e-6),
         vec(50e-6, 50e-6, -50e-6)}
    )
    {
        for
        (
            const vec& direction :
            {vec(1, 0, 0), vec(-1, 1, -1), vec(0.3, -2, 1)}
        )
        {
            for (const bool heavierFirst : {true, false})
            {
                const vec e = direction.normalized();
                const double gap = 20e-6;

                std::vector<sphere> spheres
                {
                    {4, 4e-6, 1000, centre - 12e-6*e, e},
                    {9, 2e-6, 1500, centre + 11e-6*e, -0.5*e}
                };

                const particleArrays start = arrays(spheres);
                const double share = start.m(1)/start.m.sum();

                if (!heavierFirst)
                {
                    std::swap(spheres[0], spheres[1]);
                }

                experiment e2(arrays(spheres), length, with("type none;"));

                const double h = 5e-6;
                const double expected = gap/1.5;
                e2.run(h, 4);

                ASSERT_EQ(meetings.size(), 1u);
                ASSERT_EQ(e2.p.size(), 1);
                EXPECT_EQ(e2.count(), 1);
                EXPECT_EQ(e2.p.id(0), 4);

                const meeting& m = meetings[0];

                // u_c is at least the relative speed, for which a collision
                // step is the longest
                const double late = m.time - expected;
                EXPECT_GE(late, -1e-15);
                EXPECT_LE(late, kc*2e-6/1.5);

                const vec x4 = m.idI == 4 ? m.xi : m.xj;
                const vec x9 = m.idI == 4 ? m.xj : m.xi;

                EXPECT_LT
                (
                    e2.nearest(x4 - (start.x.col(0) + m.time*e)).norm(), 1e-17
                );
                EXPECT_LT
                (
                    e2.nearest(x9 - (start.x.col(1) - 0.5*m.time*e)).norm(),
                    1e-17
                );

                // Without the image the two would be far apart
                EXPECT_NEAR((x9 - x4).norm(), m.touch - 1.5*late, 1e-16);

                // And on it goes with the momentum of both
                const vec v = (1 - 1.5*share)*e;
                const vec x = start.x.col(0) + share*23e-6*e + 4*h*v;

                EXPECT_LT((e2.p.v.col(0) - v).norm(), 1e-14);
                EXPECT_LT(e2.nearest(e2.p.x.col(0) - x).norm(), 1e-16);
                EXPECT_LE(e2.p.x.col(0).cwiseAbs().maxCoeff(), 0.5*length);
            }
        }
    }
}


TEST_P(eachTimeStepping, mergesThreeInARowWithinOneStep)
{
    const double kc = 0.1;
    int order[3] = {0, 1, 2};

    do
    {
        // Each of the three is once the heaviest, the lightest and between
        for
        (
            const vec& density :
            {vec(1000, 5000, 2000), vec(9000, 1000, 2000),
             vec(1000, 3000, 9000), vec(500, 3000, 9000)}
        )
        {
            for (const vec& centre : {vec(0, 0, 0), vec(vec::Constant(150e-6))})
            {
                const vec e = vec(1, -2, 2)/3;

                const double dA = 3e-6;
                const double dB = 2e-6;
                const double dC = 2.5e-6;
                const double xB = 5e-6 + 0.5*(dA + dB);
                const double xC = xB + 5e-6 + 0.5*(dB + dC);

                const std::vector<sphere> row
                {
                    {1, dA, density(0), centre, e},
                    {2, dB, density(1), centre + xB*e, vec::Zero()},
                    {3, dC, density(2), centre + xC*e, vec::Zero()}
                };

                const particleArrays start = arrays(row);
                const double mA = start.m(0);
                const double mB = start.m(1);
                const double mC = start.m(2);

                const double t1 = 5e-6;
                const double dAB = std::cbrt(dA*dA*dA + dB*dB*dB);

                // Its centre of mass does not depend on when it was made
                const double t2 =
                    ((xC - 0.5*(dAB + dC))*(mA + mB) - mB*xB)/mA;

                const double h = 50e-6;
                ASSERT_LT(t2, h);

                experiment three
                (
                    arrays({row[order[0]], row[order[1]], row[order[2]]}),
                    300e-6,
                    with("type none;")
                );

                const double V = mA/(mA + mB + mC);
                const double step = kc*dB/(2*std::max(2.0/3, 1 - V));

                three.run(h, 1);

                ASSERT_EQ(meetings.size(), 2u);
                ASSERT_EQ(three.p.size(), 1);

                EXPECT_EQ(meetings[0].pair(), std::make_pair(1l, 2l));
                EXPECT_GE(meetings[0].time, t1*(1 - 1e-12));
                EXPECT_LE(meetings[0].time, t1 + 1.5*step);

                EXPECT_EQ
                (
                    meetings[1].pair(), std::make_pair(mA > mB ? 1l : 2l, 3l)
                );
                EXPECT_NEAR(meetings[1].touch, 0.5*(dAB + dC), 1e-18);
                EXPECT_GE(meetings[1].time, t2*(1 - 1e-12));
                EXPECT_LE(meetings[1].time, t2 + 1.5*step);

                int heaviest;
                start.m.maxCoeff(&heaviest);
                EXPECT_EQ(three.p.id(0), heaviest + 1);
                EXPECT_EQ(three.p.primaries(0), 3);

                const vec x =
                    centre + (mB*xB + mC*xC + mA*h)/(mA + mB + mC)*e;

                EXPECT_LT((three.p.v.col(0) - V*e).norm(), 1e-13);
                EXPECT_LT(three.nearest(three.p.x.col(0) - x).norm(), 1e-16);
            }
        }
    }
    while (std::next_permutation(order, order + 3));
}


TEST_P(eachTimeStepping, lookForWhatTheAbsorbedOneWouldHaveMet)
{
    // A fast one hits a heavier one at rest, which in the rest of the step
    // carries it to a third: too far for the heavier one alone to look for
    const double h = 50e-6;
    const vec e = vec(1, -2, 2)/3;

    for (const double d : {2e-6, 240e-6})
    {
        for (const double corner : {0.0, 500e-6, -500e-6})
        {
            for (const double away : {-1.5e-6, 0.0, 3e-6, 12e-6})
            {
                // The face of the box passes between any two of them
                const vec centre = vec(corner, -corner, corner) + away*e;

                const double share = 0.45;
                const double xFast = -4e-6;
                const double t1 = 2e-6;
                const double t2 = 40e-6;
                const double both = 2e-6*std::cbrt(2.0);
                const double xThird =
                    share*(xFast + t2) + 0.5*(both + d);

                std::vector<sphere> spheres
                {
                    {1, 2e-6, 1000*share/(1 - share), centre + xFast*e, e},
                    {2, 2e-6, 1000, centre, vec::Zero()},
                    {3, d, 1000, centre + xThird*e, vec::Zero()}
                };

                // So that the mean velocity is nearly that of those at rest
                for (int n = 0; n < 40; ++n)
                {
                    spheres.push_back
                    ({
                        4 + n, 2e-6, 1000,
                        centre + vec(20e-6*n - 400e-6, 350e-6, 350e-6),
                        vec::Zero()
                    });
                }

                for (const bool reversed : {false, true})
                {
                    if (reversed)
                    {
                        std::reverse(spheres.begin(), spheres.end());
                    }

                    experiment box(arrays(spheres), 1e-3, with("type none;"));
                    box.run(h, 1);

                    ASSERT_EQ(meetings.size(), 2u);
                    EXPECT_EQ(meetings[0].pair(), std::make_pair(1l, 2l));
                    EXPECT_EQ(meetings[1].pair(), std::make_pair(2l, 3l));

                    const double late = 0.1*2e-6;
                    EXPECT_GE(meetings[0].time, t1*(1 - 1e-9));
                    EXPECT_LE(meetings[0].time, t1 + late);
                    EXPECT_GE(meetings[1].time, t2*(1 - 1e-9));
                    EXPECT_LE(meetings[1].time, t2 + late);
                }
            }
        }
    }
}


TEST_P(eachTimeStepping, findsTheRightImageAfterAMerger)
{
    // A fast one takes another one along, and meets the third in one of the
    // two images that it may reach in a short box
    for (const double way : {1.0, -1.0})
    {
        for (const bool fastFirst : {true, false})
        {
            const std::vector<sphere> spheres
            {
                {fastFirst ? 1 : 3, 8e-6, 2000, {0, 0, 0}, {way, 0, 0}},
                {2, 8e-6, 100, {25e-6*way, 0, 0}, {0, 0, 0}},
                {fastFirst ? 3 : 1, 8e-6, 1000, {70e-6*way, 0, 0}, {0, 0, 0}}
            };

            experiment box
            (
                arrays(spheres), {100e-6, 200e-6, 200e-6}, with("type none;"),
                new swingingGas(0, vec::Zero(), gasProperties::air())
            );
            box.run(90e-6, 1);

            EXPECT_EQ(meetings.size(), 2u) << way << ' ' << fastFirst;
            EXPECT_EQ(box.p.size(), 1) << way << ' ' << fastFirst;
        }
    }
}


TEST_P(eachTimeStepping, keepsAClusterFreeOfWakesOutOfRange)
{
    // Two meet near a third one, which belongs to their cluster, but is beyond
    // the range of their wakes; also where coordinates are zero
    for (const vec& centre : {vec(0, 0, 0), vec(1e-3, 2e-3, -1e-3)})
    {
        for (const bool close : {true, false})
        {
            settings s = with("type Stokes; slipCorrection none;");
            s.wake =
                close ? "type Oseen; range 1;" : "type Oseen; range 3;";

            const double d = close ? 4e-6 : 10e-6;
            const double v = close ? 0.1 : 1;
            const vec third(0, close ? 40e-6 : 60e-6, 0);

            experiment box
            (
                arrays
                ({
                    {1, d, 1000, centre, {v, 0, 0}},
                    {2, d, 1000, centre + vec(1.5*d, 0, 0), {-v, 0, 0}},
                    {3, close ? 20e-6 : d, 1000, centre + third, vec::Zero()}
                }),
                vec::Constant(400e-6), s,
                new swingingGas(0, vec::Zero(), s.gas), centre
            );
            box.run(12e-6, 1);

            ASSERT_EQ(box.p.size(), 2) << close;
            EXPECT_EQ(box.p.id(1), 3);
            EXPECT_EQ(box.p.v.col(1), vec::Zero());
            EXPECT_EQ(box.p.x.col(1), vec(centre + third));
        }
    }
}


TEST_P(eachTimeStepping, doesNotLetTheFastTunnel)
{
    // 400 diameters closer in one step, past one another in a 40th of it
    for (const double offset : {0.0, 0.5e-6, 0.9e-6})
    {
        experiment pair
        (
            arrays
            ({
                {1, 1e-6, 1000, {-100e-6, 0, 0}, {20, 0, 0}},
                {2, 1e-6, 1000, {100e-6, offset, 0}, {-20, 0, 0}}
            }),
            1e-3,
            with("type none;")
        );

        pair.run(10e-6, 1);

        ASSERT_EQ(meetings.size(), 1u);

        const double expected =
            (200e-6 - std::sqrt(1e-12 - offset*offset))/40;

        EXPECT_GE(meetings[0].time, expected*(1 - 1e-12));
        EXPECT_LE(meetings[0].time, expected + 0.1*1e-6/40);
    }

    // A hundredth of a diameter too far to touch
    experiment miss
    (
        arrays
        ({
            {1, 1e-6, 1000, {-100e-6, 0, 0}, {20, 0, 0}},
            {2, 1e-6, 1000, {100e-6, 1.01e-6, 0}, {-20, 0, 0}}
        }),
        1e-3,
        with("type none;")
    );

    miss.run(10e-6, 1);

    EXPECT_EQ(meetings.size(), 0u);
    EXPECT_EQ(miss.p.size(), 2);
}


TEST_P(eachTimeStepping, countsAContactThatDoesNotStickOnce)
{
    // Through one another within 10 fluid steps, and once more around the box
    settings law = with("type none;");
    law.contact = "type neverStick;";

    experiment pair
    (
        arrays
        ({
            {1, 10e-6, 1000, {-20e-6, 1e-6, 0}, {1, 0, 0}},
            {2, 10e-6, 1000, {20e-6, 0, 0}, {-1, 0, 0}}
        }),
        100e-6,
        law
    );

    // They touch after 15 us, part after 25 us, and meet again after 65 us
    pair.run(1e-6, 12);
    EXPECT_EQ(pair.count(), 0);
    pair.run(1e-6, 40);
    EXPECT_EQ(pair.count(), 1);
    pair.run(1e-6, 20);
    EXPECT_EQ(pair.count(), 2);
    EXPECT_EQ(pair.p.size(), 2);
}


TEST_P(eachTimeStepping, leavesThoseAloneThatRestInOneAnother)
{
    // Equal and overlapping, they move alike and never part
    settings law = with("type none;");
    law.aggregate = "type none;";

    experiment pair
    (
        arrays
        ({
            {1, 10e-6, 1000, {0, 0, 0}, {1, 0, 0}},
            {2, 10e-6, 1000, {5e-6, 0, 0}, {1, 0, 0}}
        }),
        100e-6,
        law
    );

    pair.run(1e-6, 10);

    EXPECT_EQ(pair.count(), 1);
    EXPECT_EQ(pair.p.size(), 2);
}


TEST_P(eachTimeStepping, movesASingleParticleAndNoneAtAll)
{
    experiment none(arrays({}), 1e-3, with("type none;"));
    none.run(1e-5, 3);
    EXPECT_EQ(none.p.size(), 0);

    // In a box that is smaller than its path: it never meets its image
    experiment one
    (
        arrays({{5, 8e-6, 1000, {0, 0, 0}, {1, -2, 0.5}}}),
        20e-6,
        with("type none;")
    );
    one.run(1e-5, 7);

    ASSERT_EQ(one.p.size(), 1);
    EXPECT_EQ(one.count(), 0);
    EXPECT_LT
    (
        one.nearest(one.p.x.col(0) - 7e-5*vec(1, -2, 0.5)).norm(), 1e-18
    );
}


TEST(multipleTimeStep, nestsItsStepsAsItsFactorsSay)
{
    // tau of the smaller one 7.1 us at 2 um: 14 particle steps of 0.5 tau in
    // 100 us; u_c 2 m/s: 0.1*2 um/(2 m/s) = 0.1 us
    experiment pair
    (
        arrays
        ({
            {1, 2e-6, 580, {0, 100e-6, 0}, {1, 0, 0}},
            {2, 8e-6, 580, {0, 0, 0}, {-1, 0, 0}}
        }),
        1e-3,
        settings()
    );

    const double h = 100e-6;
    pair.run(h, 1);

    const double tau = relaxationTime(2e-6, 580);
    const int particleSteps = int(std::ceil(h/(0.5*tau)));
    const int collisionSteps =
        int(std::ceil(h/particleSteps*2/(0.1*2e-6)));

    EXPECT_EQ(pair.done().fluidSteps, 1);
    EXPECT_EQ(pair.done().particleSteps, particleSteps);
    EXPECT_EQ(pair.done().collisionSteps, particleSteps*collisionSteps);
    EXPECT_EQ(pair.done().wakePairs, 0);
}


TEST(timeStepping, rejectsWhatMakesNoSense)
{
    const auto make = [](const std::string& stepping)
    {
        settings s;
        s.stepping = stepping;
        experiment none(arrays({}), 1e-3, s);
    };

    EXPECT_THROW(make("type conventional;"), IOerror);
    EXPECT_THROW(make("type conventional; kc 0;"), IOerror);
    EXPECT_THROW(make("type multipleTimeStep; kc 0.1;"), IOerror);
    EXPECT_THROW(make("type multipleTimeStep; kc 0.1; kp -1;"), IOerror);
    EXPECT_THROW(make("type fast; kc 0.1; kp 1;"), IOerror);
}


// ************************************************************************* //
