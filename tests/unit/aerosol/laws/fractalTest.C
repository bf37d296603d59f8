/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Fractal aggregates: their diameters against the formulae; that drag, wake
    and contact take the right one of them; and what a crowd of them conserves.

\*---------------------------------------------------------------------------*/

#include "aggregate.H"
#include "equationOfMotion.H"
#include "error.H"
#include "measured.H"
#include "timeSteppingTools.H"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr double epsilon = std::numeric_limits<double>::epsilon();

const std::string open = "type fractal; dimension 1.8;";

autoPtr<aggregate> make(const std::string& text)
{
    return aggregate::New(parse(text));
}


//- An aggregate of N alike
sphere clusterOf
(
    const std::int64_t id,
    const double primary,
    const int N,
    const double density,
    const vec& x,
    const vec& v
)
{
    return {id, std::cbrt(N)*primary, density, x, v};
}


double CunninghamFactor(const double d, const gasProperties& gas)
{
    const double Kn = 2*gas.meanFreePath/d;
    return 1 + Kn*(1.257 + 0.4*std::exp(-1.1/Kn));
}


//- The laws of motion for aggregates
equationOfMotion laws
(
    const std::string& drag,
    const std::string& gravity,
    const std::string& wake,
    const std::string& aggregate
)
{
    return
    {
        parse
        (
            "drag {" + drag + "} gravity {" + gravity + "} wake {" + wake
          + "} aggregate {" + aggregate + "}"
        ),
        gasProperties::air(),
        Eigen::Array3d::Ones()
    };
}


//- Velocity of one particle after steps in gas that rests
vec velocityAfter
(
    const equationOfMotion& motion,
    particleArrays p,
    const double h,
    const int steps
)
{
    motion.laws().refresh(p);

    const vectors still = vectors::Zero(3, 1);
    stepEnd end;

    for (int s = 0; s < steps; ++s)
    {
        motion.inWakes().moveTogether(h, p, {}, {still, {}, still}, {}, 1, end);
        p.x = end.x;
        p.v = end.v;
    }

    return p.v;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(fractal, hasTheDiametersOfTheFormulae)
{
    struct law
    {
        double D;
        double k;
        double beta;
    };

    for
    (
        const law& l : std::vector<law>
        {
            {1.8, 1, 0.46}, {1.8, 0.66, 0.46}, {2.1, 1.3, 0.4},
            {1.2, 1, 0.56}, {2.5, 1, 0.46}, {3, 5, 0.34}, {1.8, 1, 0.9}
        }
    )
    {
        std::ostringstream text;
        text<< "type fractal; dimension " << l.D << "; prefactor " << l.k
            << "; mobilityExponent " << l.beta << ";";
        const autoPtr<aggregate> model = make(text.str());

        for (const double primary : {30e-9, 1.5e-6})
        {
            // A single one is a sphere, exactly
            EXPECT_EQ(model->collisionDiameter(primary, 1), primary);
            EXPECT_EQ(model->mobilityDiameter(primary, 1), primary);

            for (const int N : {2, 3, 10, 1000, 1000000})
            {
                const double d = primary*std::cbrt(N);
                const double touch =
                    std::max(d, primary*std::pow(N/l.k, 1/l.D));
                const double drag =
                    std::min
                    (
                        touch, std::max(d, primary*std::pow(N, l.beta))
                    );

                EXPECT_NEAR(model->collisionDiameter(d, N)/touch, 1, 1e-14)
                    << text.str() << N;
                EXPECT_NEAR(model->mobilityDiameter(d, N)/drag, 1, 1e-14)
                    << text.str() << N;
            }
        }
    }

    // In numbers: 1000 primaries of 30 nm
    EXPECT_NEAR(make(open)->collisionDiameter(300e-9, 1000), 1392.5e-9, 1e-10);
    EXPECT_NEAR(make(open)->mobilityDiameter(300e-9, 1000), 719.6e-9, 1e-10);
}


TEST(fractal, refusesWhatMakesNoSense)
{
    for
    (
        const std::string text :
        {
            "", "dimension 1;", "dimension 0.5;", "dimension 3.1;",
            "dimension -2;", "dimension 1.8; prefactor 0;",
            "dimension 1.8; prefactor -1;",
            "dimension 1.8; mobilityExponent 0.3;",
            "dimension 1.8; mobilityExponent 1.1;",
            "dimension 1.8; exponent 0.46;"
        }
    )
    {
        EXPECT_THROW(make("type fractal; " + text), IOerror) << text;
    }

    EXPECT_NO_THROW(make("type fractal; dimension 3; mobilityExponent 0.333;"));
}


TEST(fractal, settlesAndSlowsDownByItsMobility)
{
    const gasProperties gas = gasProperties::air();
    const double primary = 1e-6;
    const double density = 2300;

    for (const int N : {1, 2, 50, 3000})
    {
        particleArrays p = arrays
        ({
            clusterOf(0, primary, N, density, vec::Zero(), vec::UnitX())
        });
        p.primaries(0) = N;

        const double m = N*density*pi/6*primary*primary*primary;
        const double d = primary*std::pow(N, 0.46);
        const double tau =
            m*CunninghamFactor(d, gas)/(3*pi*gas.mu*d);

        // No gravity: it slows down as exp(-t/tau)
        const vec slowed = velocityAfter
        (
            laws
            (
                "type Stokes; slipCorrection Cunningham;", "type none;",
                "type none;", open
            ),
            p, 0.1*tau, 20
        );
        EXPECT_NEAR(slowed(0)/std::exp(-2.0), 1, 1e-12) << N;

        // It falls with its weight less the buoyancy of its solid
        const double weight = m*(1 - gas.rho/density)*9.81;

        p.v.setZero();
        const vec fallen = velocityAfter
        (
            laws
            (
                "type Stokes; slipCorrection Cunningham;",
                "type uniform; value (0 0 -9.81);", "type none;", open
            ),
            p, tau, 50
        );
        EXPECT_NEAR(-fallen(2)/(weight*tau/m), 1, 1e-12) << N;

        // With Reynolds' number on the same diameter
        const vec faster = velocityAfter
        (
            laws
            (
                "type SchillerNaumann; slipCorrection none;",
                "type uniform; value (0 0 -9.81);", "type none;", open
            ),
            p, 0.05*tau, 1000
        );
        const double Re = gas.rho*faster.norm()*d/gas.mu;
        EXPECT_NEAR
        (
            3*pi*gas.mu*d*faster.norm()*(1 + 0.15*std::pow(Re, 0.687))/weight,
            1, 1e-9
        ) << N;

        measured
        (
            "%d primaries of 1 um: settles at %.3f mm/s by Stokes, %.3f mm/s at"
            " Re %.2g\n",
            N, -1e3*fallen(2), 1e3*faster.norm(), Re
        );
    }
}


TEST(fractal, hasTheWakeOfItsMobility)
{
    const double primary = 1e-6;
    const int N = 200;
    const double density = 2300;
    const double d = primary*std::pow(N, 0.46);

    // Far enough that nothing depends on the collision radius
    const vec source(0.1, 0.2, 0.3);
    const vec other = source + vec(50e-6, 20e-6, -10e-6);

    particleArrays aggregates = arrays
    ({
        clusterOf(0, primary, N, density, source, vec(0.1, 0, 0)),
        {1, 1e-6, density, other, vec::Zero()}
    });
    aggregates.primaries(0) = N;

    const particleArrays spheres = arrays
    ({
        {0, d, density, source, vec(0.1, 0, 0)},
        {1, 1e-6, density, other, vec::Zero()}
    });

    const std::vector<particlePair> pairs{{1, 0, {{0, 0, 0}}}};

    const auto wakeOf = [&](particleArrays p, double& range)
    {
        const equationOfMotion motion = laws
        (
            "type Stokes; slipCorrection none;", "type none;",
            "type Oseen; range 20;", open
        );
        motion.laws().refresh(p);
        range = p.range(0);

        vectors w;
        motion.wakes().sum(p, pairs, p.x, p.v, vectors::Zero(3, 2), w);
        return vec(w.col(1));
    };

    double range, rangeOfSphere;
    const vec wake = wakeOf(aggregates, range);
    const vec wakeOfSphere = wakeOf(spheres, rangeOfSphere);

    EXPECT_GT(wakeOfSphere.norm(), 1e-3);
    EXPECT_NEAR((wake - wakeOfSphere).norm()/wakeOfSphere.norm(), 0, 1e-10);
    EXPECT_NEAR(range/(20*d), 1, 1e-14);
    EXPECT_NEAR(rangeOfSphere/(20*d), 1, 1e-14);
}


class fractals
:
    public eachTimeStepping
{};

INSTANTIATE_TEST_SUITE_P
(
    timeStepping,
    fractals,
    testing::Values(conventional, multipleTimeStep, eventDriven)
);


TEST_P(fractals, touchAtTheirCollisionRadii)
{
    // Without drag: the time of contact is the gap over the speed. Across a
    // face of the box.
    const double primary = 0.5e-6;
    const int N1 = 100;
    const int N2 = 30;
    const double speed = 0.5;
    const double length = 100e-6;

    const double d1 = primary*std::pow(N1, 1/1.8);
    const double d2 = primary*std::pow(N2, 1/1.8);
    const double gap = 0.31e-6;

    const vec xi = vec(47e-6, 3e-6, -2e-6);
    const vec n = vec(3, 1, 2).normalized();
    const vec xj = xi + (0.5*(d1 + d2) + gap)*n - vec(length, 0, 0);

    settings law = with("type none;");
    law.contact = "type stick;";
    law.aggregate = open;

    std::vector<sphere> two
    {
        clusterOf(0, primary, N1, 1000, xi, 0.5*speed*n),
        clusterOf(1, primary, N2, 2000, xj, -0.5*speed*n)
    };

    particleArrays p = arrays(two);
    p.primaries << N1, N2;
    const double mass = p.m.sum();
    const vec momentum = p.v*p.m.matrix();

    experiment pair(p, length, law);
    pair.run(1e-6, 2);

    const auto records = pair.records();
    ASSERT_EQ(records.size(), 1u);

    // conventional and multipleTimeStep look at the ends of collision steps,
    // a tenth of the smaller one's diameter over twice the largest speed
    const double step =
        GetParam() == eventDriven ? 1e-12 : 0.1*d2/speed;
    EXPECT_GE(records[0].time, gap/speed - 1e-12);
    EXPECT_LE(records[0].time, gap/speed + step);

    measured
    (
        "%s touch after %.5f us, of %.5f us\n",
        GetParam().c_str(), 1e6*records[0].time, 1e6*gap/speed
    );

    ASSERT_EQ(pair.p.size(), 1);
    EXPECT_EQ(pair.p.primaries(0), N1 + N2);
    EXPECT_EQ(pair.p.m(0), mass);
    EXPECT_NEAR((pair.p.v.col(0)*mass - momentum).norm()/mass, 0, 1e-12);

    const double d = primary*std::cbrt(N1 + N2);
    EXPECT_NEAR(pair.p.d(0)/d, 1, 1e-14);
    EXPECT_NEAR
    (
        pair.p.collisionDiameter(0)/(primary*std::pow(N1 + N2, 1/1.8)), 1, 1e-14
    );
    EXPECT_NEAR
    (
        pair.p.mobilityDiameter(0)/(primary*std::pow(N1 + N2, 0.46)), 1, 1e-14
    );
}


TEST_P(fractals, ofDimensionThreeAreSpheres)
{
    // To the last bit
    const std::vector<sphere> spheres =
        aerosolOf(150, 60e-6, 0.8e-6, 4e-6, 2300, 1400, 1.5, 3);

    std::vector<particleArrays> ends;

    for
    (
        const std::string& aggregate :
        {
            std::string("type equivalentSphere;"),
            std::string("type fractal; dimension 3;")
        }
    )
    {
        settings law = with("type SchillerNaumann; slipCorrection Cunningham;");
        law.contact = "type stick;";
        law.wake = "type Oseen; range 8;";
        law.aggregate = aggregate;

        experiment crowd(arrays(spheres), 60e-6, law, 1400, vec(1.5, 0, 0));
        crowd.run(1/1400.0/100, 30);

        EXPECT_GT(crowd.count(), 10);
        ends.push_back(crowd.p);
    }

    ASSERT_EQ(ends[0].size(), ends[1].size());
    EXPECT_TRUE((ends[0].id == ends[1].id).all());
    EXPECT_EQ(ends[0].x, ends[1].x);
    EXPECT_EQ(ends[0].v, ends[1].v);
    EXPECT_TRUE((ends[0].d == ends[1].d).all());
}


TEST(fractal, crowdMeetsAlikeInAllTimeSteppings)
{
    // Contacts, and who is left, by continuous contacts on the listed pairs and
    // by small steps
    const std::vector<sphere> spheres =
        aerosolOf(400, 60e-6, 0.5e-6, 3e-6, 2300, 1400, 1.5, 5);

    struct result
    {
        std::vector<std::pair<std::int64_t, std::int64_t>> pairs;
        particleArrays p;
    };

    const auto runWith = [&](const std::string& stepping, const int perPeriod)
    {
        settings law;
        law.stepping = stepping;
        law.contact = "type stick;";
        law.aggregate = open;

        const double d3 = arrays(spheres).d.cube().sum();

        experiment crowd(arrays(spheres), 60e-6, law, 1400, vec(1.5, 0, 0));
        crowd.run(1/1400.0/perPeriod, perPeriod/4);

        result found;
        found.p = crowd.p;
        for (const auto& r : crowd.records())
        {
            found.pairs.push_back(std::minmax(r.id1, r.id2));
        }

        EXPECT_EQ(crowd.p.primaries.sum(), 400);
        EXPECT_NEAR(crowd.p.d.cube().sum()/d3, 1, 1e-14);

        return found;
    };

    const result one = runWith(eventDriven, 100);
    const result other = runWith("type multipleTimeStep; kp 1; kc 0.02;", 400);

    int common = 0;
    for (const auto& pair : one.pairs)
    {
        common +=
            std::find(other.pairs.begin(), other.pairs.end(), pair)
         != other.pairs.end();
    }

    measured
    (
        "%d and %d contacts, %d in common; largest aggregate %d primaries\n",
        int(one.pairs.size()), int(other.pairs.size()), common,
        int(one.p.primaries.maxCoeff())
    );

    EXPECT_GT(one.pairs.size(), 50u);
    EXPECT_GE(common, 0.97*one.pairs.size());
    EXPECT_GE(common, 0.97*other.pairs.size());
}


TEST(fractal, keepsMassAndVolumeInManyMerges)
{
    // 2^17 of different sizes: two by two, then these two by two; and one that
    // takes up all others
    const int n = 131072;
    const autoPtr<aggregate> model = make(open);

    randomNumbers random(7);
    std::vector<sphere> spheres;
    for (int i = 0; i < n; ++i)
    {
        spheres.push_back
        ({
            i, random.logUniform(0.2e-6, 1e-6), 2300, vec::Zero(), vec::Zero()
        });
    }
    particleArrays start = arrays(spheres);

    // Whole multiples of a unit, so that all sums of masses are exact
    start.m = (start.m*std::ldexp(1, 80)).round()*std::ldexp(1, -80);

    using extended = long double;
    const extended mass = start.m.cast<extended>().sum();
    const extended cube = start.d.cast<extended>().cube().sum();

    for (const bool twoByTwo : {true, false})
    {
        particleArrays p = start;

        const auto merge = [&](const int i, const int j)
        {
            contactOutcome::encounter pair{};
            pair.i = i;
            pair.j = j;
            pair.xi = pair.xj = pair.vi = pair.vj = vec::Zero();
            model->merge(p, pair);
        };

        for (int apart = 1; twoByTwo && apart < n; apart *= 2)
        {
            for (int i = 0; i < n; i += 2*apart)
            {
                merge(i, i + apart);
            }
        }
        for (int j = 1; !twoByTwo && j < n; ++j)
        {
            merge(0, j);
        }

        const extended d = p.d(0);
        const double lost = double(d*d*d/cube - 1);

        measured
        (
            "%d mergers, %s: mass changed by %.1Lg, volume by %.2g\n",
            n - 1, twoByTwo ? "two by two" : "one takes up all",
            extended(p.m(0)) - mass, lost
        );

        EXPECT_EQ(p.primaries(0), n);
        EXPECT_EQ(extended(p.m(0)), mass);

        // The cube root and the cubes are right to the last bit, of a diameter
        EXPECT_LT(std::abs(lost), 3*epsilon*(twoByTwo ? 17 : n));
    }
}


// ************************************************************************* //
