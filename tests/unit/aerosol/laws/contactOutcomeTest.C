/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Who sticks, who bounces and how fast: against the formulae and the laws of
    conservation, with each time stepping.

\*---------------------------------------------------------------------------*/

#include "coalescence.H"
#include "criticalVelocity.H"
#include "measured.H"
#include "probability.H"
#include "timeSteppingTools.H"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using encounter = contactOutcome::encounter;

const double density = 2300;

const std::string glass =
    "type criticalVelocity; workOfAdhesion 0.05; YoungsModulus 70e9;"
    "PoissonRatio 0.3;";


//- Two of the given diameters, a gap apart along a line
particleArrays two
(
    const double d1,
    const double d2,
    const double gap,
    const vec& v1,
    const vec& v2,
    const vec& line = vec::UnitX()
)
{
    const double r = 0.5*(d1 + d2) + gap;

    return arrays
    ({
        {3, d1, density, -0.5*r*line, v1}, {8, d2, density, 0.5*r*line, v2}
    });
}


double stickingSpeed(const std::string& law, const double d1, const double d2)
{
    return
        criticalVelocity(parse(law)).stickingSpeed
        (
            two(d1, d2, 0, vec::Zero(), vec::Zero()), 0, 1
        );
}


vec momentum(const particleArrays& p)
{
    return p.v*p.m.matrix();
}


double energy(const particleArrays& p)
{
    return 0.5*p.v.colwise().squaredNorm().dot(p.m.matrix());
}

//- Of all pairs, in distances of contact
double deepestOverlap(const experiment& crowd)
{
    const particleArrays& p = crowd.p;
    double deepest = 0;

    for (int i = 0; i < p.size(); ++i)
    {
        for (int j = 0; j < i; ++j)
        {
            const double touch = 0.5*(p.d(i) + p.d(j));
            const vec r = crowd.nearest(p.x.col(i) - p.x.col(j));

            deepest = std::max(deepest, 1 - r.norm()/touch);
        }
    }

    return deepest;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(coalescence, endsWhereDropsGraze)
{
    // O'Rourke: sin^2(theta) = 2.4 f/We; f = 1.3 for equal drops and 3.8 for
    // twice the diameter
    const coalescence water
    (
        parse("type coalescence; surfaceTension 0.07;")
    );
    const double speed = 6;

    for (const auto& [d1, d2, f] :
    {
        std::tuple{50e-6, 50e-6, 1.3}, std::tuple{100e-6, 50e-6, 3.8}
    })
    {
        const double We = 1000*speed*speed*0.5*50e-6/0.07;
        const double limit = std::asin(std::sqrt(2.4*f/We));

        const auto sticks = [&](const double angle)
        {
            const vec v =
                speed*vec(std::cos(angle), std::sin(angle), 0);

            particleArrays p = two(d1, d2, 0, v, vec::Zero());
            p.m *= 1000/density;

            return water.sticks
            (
                p,
                {
                    0, 1, p.x.col(0), p.x.col(1), vec::Zero(), v,
                    vec::Zero(), 0
                }
            );
        };

        EXPECT_TRUE(sticks(0));
        EXPECT_TRUE(sticks(0.999*limit));
        EXPECT_FALSE(sticks(1.001*limit));
    }
}


TEST(criticalVelocity, takesTheEnergyOfAdhesion)
{
    // Published: two digits, of silica of 2300 kg/m3 and nu = 0.3
    const std::string soft =
        "type criticalVelocity; workOfAdhesion 0.1; YoungsModulus 5e9;";

    const double v15 = stickingSpeed(glass, 1e-6, 5e-6);
    const double v55 = stickingSpeed(glass, 5e-6, 5e-6);
    const double s15 = stickingSpeed(soft, 1e-6, 5e-6);

    measured
    (
        "sticking speeds of 1, 5 um; 5, 5 um; soft 1, 5 um:"
        " %.4f, %.4f, %.4f m/s\n", v15, v55, s15
    );

    EXPECT_NEAR(v15, 0.15, 0.005);
    EXPECT_NEAR(v55, 0.039, 0.0005);
    EXPECT_NEAR(s15, 0.64, 0.005);

    // Half m v^2 is the work 7.09 (W^5 R^4/E^2)^(1/3)
    const double m1 = density*pi/6*1e-18;
    const double m2 = 125*m1;
    const double R = 1/(2e6 + 0.4e6);
    const double E = 1/(2*(1 - 0.09)/70e9);
    const double work =
        7.09*std::exp
        (
            (5*std::log(0.05) + 4*std::log(R) - 2*std::log(E))/3
        );

    EXPECT_NEAR(0.5*m1*m2/(m1 + m2)*v15*v15/work, 1, 1e-12);
}


TEST(criticalVelocity, restitutionLosesThatEnergy)
{
    const criticalVelocity law(parse(glass));
    const particleArrays p =
        two(1e-6, 5e-6, 0, vec::Zero(), vec::Zero());
    const double vs = law.stickingSpeed(p, 0, 1);

    for (const double ratio : {0.5, 0.9999, 1.0001, 1.5, 10.0, 1e3})
    {
        // Only what is along the line of centres counts
        encounter e{};
        e.i = 0;
        e.j = 1;
        e.xi = p.x.col(0);
        e.xj = p.x.col(1);
        e.vi = vec(ratio*vs, 7, -3);
        e.vj = vec(0, -1, 2);

        EXPECT_EQ(law.sticks(p, e), ratio < 1) << ratio;

        if (ratio > 1)
        {
            const double rest = law.restitution(p, e);

            EXPECT_NEAR(ratio*ratio*(1 - rest*rest), 1, 1e-9) << ratio;
        }
    }
}


TEST(probability, isWhatItSays)
{
    const probability law
    (
        parse("type probability; sticking 0.3; seed 5;")
    );
    particleArrays p = two(1e-6, 5e-6, 0, vec::UnitX(), vec::Zero());

    encounter e{};
    e.i = 0;
    e.j = 1;
    e.xi = p.x.col(0);
    e.xj = p.x.col(1);
    e.vi = vec::UnitX();
    e.vj = vec::Zero();

    const int n = 100000;
    int stuck = 0;

    for (int k = 0; k < n; ++k)
    {
        p.id(0) = k % 100;
        p.id(1) = 100 + k/100 % 10;
        e.step = k/1000 % 10;
        e.number = k/10000;

        const bool sticks = law.sticks(p, e);
        stuck += sticks;

        std::swap(e.i, e.j);
        EXPECT_EQ(law.sticks(p, e), sticks);
        std::swap(e.i, e.j);
    }

    // Four standard deviations
    EXPECT_NEAR(stuck, 0.3*n, 4*std::sqrt(0.3*0.7*n));
    EXPECT_FALSE(law.bounces());
}


class bouncing
:
    public eachTimeStepping
{};

INSTANTIATE_TEST_SUITE_P
(
    timeStepping,
    bouncing,
    testing::Values(multipleTimeStep, conventional, eventDriven)
);


TEST_P(bouncing, isExactForTwo)
{
    settings law = with("type none;");
    law.contact = glass;

    // Head-on, and off the centre across a face of the box
    for (const double offset : {0.0, 2e-6})
    {
        const double d1 = 5e-6;
        const double d2 = 3e-6;
        const double touch = 4e-6;
        const vec v1(0.7, 0.1, 0);
        const vec v2(-0.3, 0.1, 0);
        const double speed = 1;

        particleArrays start = arrays
        ({
            {3, d1, density, vec(49e-6, 0, 0), v1},
            {8, d2, density, vec(-45e-6, offset, 0), v2}
        });

        // 6 um apart along x
        const double contact =
            (6e-6 - std::sqrt(touch*touch - offset*offset))/speed;
        const vec n =
            vec(std::sqrt(touch*touch - offset*offset), offset, 0)/touch;
        const double vn = (v1 - v2).dot(n);
        const double vs = stickingSpeed(glass, d1, d2);
        const double e = std::sqrt(1 - vs*vs/(vn*vn));
        const double m1 = start.m(0);
        const double m2 = start.m(1);
        const double J = (1 + e)*m1*m2/(m1 + m2)*vn;

        const vec w1 = v1 - J/m1*n;
        const vec w2 = v2 + J/m2*n;

        experiment pair(start, 100e-6, law);
        pair.run(2e-6, 4);

        ASSERT_EQ(pair.p.size(), 2);
        EXPECT_EQ(pair.count(), 1);
        EXPECT_LT((pair.p.v.col(0) - w1).norm(), 1e-9);
        EXPECT_LT((pair.p.v.col(1) - w2).norm(), 1e-9);
        EXPECT_LT
        (
            (momentum(pair.p) - momentum(start)).norm(), 1e-15*(m1 + m2)
        );

        // At the right time: it is where it is
        EXPECT_LT
        (
            pair.nearest
            (
                start.x.col(0) + contact*v1 + (8e-6 - contact)*w1
              - pair.p.x.col(0)
            ).norm(),
            1e-12
        );

        const auto met = pair.records();
        ASSERT_EQ(met.size(), 1u);
        EXPECT_TRUE(met[0].bounced);
        EXPECT_FALSE(met[0].merged);
        EXPECT_NEAR(met[0].time, contact, 1e-12);
    }
}


TEST_P(bouncing, beginsAtTheStickingSpeed)
{
    settings law = with("type none;");
    law.contact = glass;

    const double vs = stickingSpeed(glass, 1e-6, 5e-6);

    for (const double ratio : {0.999, 1.001})
    {
        experiment pair
        (
            two(1e-6, 5e-6, 0.5e-6, vec(ratio*vs, 0, 0), vec::Zero()), 100e-6,
            law
        );
        pair.run(1e-6, 10);

        EXPECT_EQ(pair.p.size(), ratio < 1 ? 1 : 2);
        EXPECT_EQ(pair.count(), 1);
    }
}


TEST_P(bouncing, endsInSticking)
{
    // A large one falls on a small one, which is thrown ahead and stopped by
    // the gas, again and again
    settings law = with("type Stokes; slipCorrection none;");
    law.gravity = "type uniform; value (0 0 -9.81);";
    law.contact =
        "type criticalVelocity; workOfAdhesion 1e-3; YoungsModulus 70e9;";

    experiment pair
    (
        two
        (
            4e-6, 20e-6, 1e-6, vec::Zero(), vec(0, 0, -1), vec::UnitZ()
        ),
        200e-6, law
    );
    const double vs = stickingSpeed(law.contact, 4e-6, 20e-6);
    pair.run(10e-6, 1000);

    const auto met = pair.records();

    EXPECT_EQ(pair.p.size(), 1);
    ASSERT_GE(met.size(), 3u);

    for (std::size_t k = 0; k < met.size(); ++k)
    {
        const bool last = k + 1 == met.size();

        EXPECT_EQ(met[k].bounced, !last);
        EXPECT_EQ(met[k].merged, last);
        EXPECT_EQ(met[k].speed > vs, !last) << met[k].speed << " " << vs;
    }

    measured
    (
        "%s %d bounces, the last contact at %.4f m/s, v_s %.4f\n",
        GetParam().c_str(), int(met.size()) - 1, met.back().speed, vs
    );
}


TEST_P(bouncing, endsInStickingAlsoIfPressedHard)
{
    // So hard that the last bounces are lower than the gap of two in touch, and
    // that two that separate turn round in the same step
    for (const std::string& g : strings{"100", "1e3", "1e4"})
    {
        for (const std::string& e : strings{"0", "0.3", "0.7", "0.95"})
        {
            settings law = with("type Stokes; slipCorrection none;");
            law.gravity = "type uniform; value (-" + g + " 0 0);";
            law.contact =
                "type probability; sticking 0; restitution " + e + ";";

            experiment pair
            (
                two(5e-6, 10e-6, 1e-6, vec::Zero(), vec::Zero()), 200e-6, law
            );

            double deepest = 0;

            for (int k = 0; k < 300 && pair.p.size() > 1; ++k)
            {
                pair.run(10e-6, 1);
                deepest = std::max(deepest, deepestOverlap(pair));
            }

            EXPECT_EQ(pair.p.size(), 1) << g << ' ' << e;
            EXPECT_LT(deepest, 1e-8) << g << ' ' << e;
        }
    }
}


TEST_P(bouncing, crowdKeepsMomentumAndDistance)
{
    const int n = 300;
    const double length = 100e-6;
    const double step = 2e-6;

    std::vector<sphere> spheres =
        aerosolOf(n, length, 2e-6, 6e-6, density, 0, 0, 3);

    randomNumbers random(7);
    for (sphere& s : spheres)
    {
        s.v = random.point(1);
    }

    const particleArrays start = arrays(spheres);

    settings law = with("type none;");
    law.contact = "type probability; sticking 0; restitution 1;";

    experiment crowd(start, length, law);

    // In another order
    std::vector<int> turned(n);
    std::iota(turned.rbegin(), turned.rend(), 0);
    experiment same(start.select(turned), length, law);

    double deepest = 0;

    for (int k = 0; k < 50; ++k)
    {
        crowd.run(step, 1);
        same.run(step, 1);

        deepest = std::max(deepest, deepestOverlap(crowd));
    }

    const double speeds = start.v.colwise().norm().dot(start.m.matrix());
    const double lost = (momentum(crowd.p) - momentum(start)).norm()/speeds;
    const double gained = energy(crowd.p)/energy(start) - 1;

    measured
    (
        "%s %lld bounces of %d: momentum changed by %.2g of the sum of m |v|,"
        " energy by %.2g; deepest overlap %.2g distances\n",
        GetParam().c_str(), static_cast<long long>(crowd.count()), n, lost,
        gained, deepest
    );

    EXPECT_EQ(crowd.p.size(), n);
    EXPECT_GT(crowd.count(), n/2);
    EXPECT_LT(lost, 1e-13);
    EXPECT_NEAR(gained, 0, 1e-9);
    EXPECT_LT(deepest, 1e-9);

    EXPECT_EQ(crowd.count(), same.count());
    EXPECT_EQ(crowd.p.x, same.p.x);
    EXPECT_EQ(crowd.p.v, same.p.v);

    // In one step of 20 um at 1 m/s some get where nobody was looked for
    experiment coarse(start, length, law);
    double overlap = 0;

    for (int k = 0; k < 5; ++k)
    {
        coarse.run(10*step, 1);
        overlap = std::max(overlap, deepestOverlap(coarse));
    }

    measured
    (
        "    in steps ten times as long %lld bounces, deepest overlap %.2g\n",
        static_cast<long long>(coarse.count()), overlap
    );

    EXPECT_NEAR(double(coarse.count())/crowd.count(), 1, 0.1);
    EXPECT_LT
    (
        (momentum(coarse.p) - momentum(start)).norm()/speeds, 1e-13
    );
}


// ************************************************************************* //
