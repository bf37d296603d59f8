/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Breakage by impacts: the work of bonds against the integral over their
    force; the energy at which it begins; what the pieces have; that they fly
    apart.

\*---------------------------------------------------------------------------*/

#include "bond.H"
#include "breakageTools.H"
#include "error.H"
#include "impactBreakage.H"
#include "measured.H"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <utility>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Glass
constexpr double W = 0.05;
constexpr double E = 70e9;
constexpr double nu = 0.2;
constexpr double reduced = 0.5*E/(1 - nu*nu);

const std::string glass =
    "{ type JKR; workOfAdhesion 0.05; YoungsModulus 70e9; PoissonRatio 0.2; }";


//- Johnson, Kendall and Roberts' contact of spheres of a reduced radius R, from
//  its radius a
struct JKRContact
{
    double R;

    double force(const double a) const
    {
        return
            4*reduced*a*a*a/(3*R) - std::sqrt(8*pi*W*reduced*a*a*a);
    }

    double approach(const double a) const
    {
        return a*a/R - std::sqrt(2*pi*W*a/reduced);
    }

    //- Work against the force, from one radius to another, by Simpson's rule
    double work(const double from, const double to) const
    {
        const int n = 2000;
        double sum = 0;

        for (int k = 0; k < n; ++k)
        {
            const double a = from + (to - from)*k/n;
            const double b = from + (to - from)*(k + 1)/n;
            const double mean = 0.5*(a + b);

            // d(approach) = (2a/R - sqrt(pi W/(2 a E))) da
            const auto f = [&](const double x)
            {
                return
                    force(x)
                   *(2*x/R - std::sqrt(pi*W/(2*x*reduced)));
            };

            sum += (b - a)/6*(f(a) + 4*f(mean) + f(b));
        }

        return sum;
    }
};


double rootOf
(
    const std::function<double(double)>& f,
    double low,
    double high
)
{
    for (int k = 0; k < 200; ++k)
    {
        const double mean = 0.5*(low + high);
        ((f(mean) > 0) == (f(high) > 0) ? high : low) = mean;
    }
    return low;
}


double kineticEnergy(const particleArrays& p)
{
    return 0.5*(p.v.colwise().squaredNorm()*p.m.matrix())(0);
}


vec momentum(const particleArrays& p)
{
    return p.v*p.m.matrix();
}


//- The first one runs into the second one, which rests
contactOutcome::encounter headOn(const double speed)
{
    contactOutcome::encounter pair{};

    pair.i = 0;
    pair.j = 1;
    pair.xi = vec::Zero();
    pair.xj = vec(1e-6, 0, 0);
    pair.shift = vec::Zero();
    pair.vi = vec(speed, 0, 0);
    pair.vj = vec::Zero();

    return pair;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(bond, hasTheWorkOfTheContact)
{
    const bond JKRBond
    (
        parse
        (
            "type JKR; workOfAdhesion 0.05;"
            "YoungsModulus 70e9; PoissonRatio 0.2;"
        )
    );
    const bond Rumpf
    (
        parse("type Rumpf; HamakerConstant 1e-19; asperity 10e-9;")
    );

    for (const double primary : {0.3e-6, 1e-6, 8e-6})
    {
        const JKRContact contact{0.25*primary};
        const double R = contact.R;

        // Without a load; at no approach; where the surfaces jump apart
        const double large = std::cbrt(9*pi*W*R*R/reduced);
        const auto radius = [&](const std::function<double(double)>& f)
        {
            return rootOf(f, 0.4*large, large);
        };
        const double a0 =
            radius([&](double a) { return contact.force(a); });
        const double flat =
            radius([&](double a) { return contact.approach(a); });
        const double jump =
            rootOf
            (
                [&](double a)
                {
                    return 2*a/R - std::sqrt(pi*W/(2*a*reduced));
                },
                0.01*large, large
            );

        const double exact = contact.work(a0, jump);
        const double distance = -contact.approach(jump);

        measured
        (
            "primaries of %g m: work %.4e J, %.4f of force times distance;"
            " from no approach %.4f (W^5 R^4/E^2)^(1/3)\n",
            primary, JKRBond.work(primary),
            JKRBond.work(primary)/(JKRBond.strength(primary)*distance),
            contact.work(flat, jump)
           /std::cbrt(std::pow(W, 5)*std::pow(R, 4)/sqr(reduced))
        );

        EXPECT_NEAR(JKRBond.work(primary)/exact, 1, 1e-6);

        // Wada et al.
        EXPECT_NEAR
        (
            JKRBond.work(primary)/(JKRBond.strength(primary)*distance), 1.54,
            0.005
        );

        // The energy that two lose when they stick is that from no approach on:
        // Thornton and Ning's 7.09 (W^5 R^4/E^2)^(1/3)
        EXPECT_NEAR
        (
            contact.work(flat, jump)
           /std::cbrt(std::pow(W, 5)*std::pow(R, 4)/sqr(reduced)),
            7.09, 0.01
        );

        // van der Waals' forces, over the logarithm of the distance
        double sum = 0;
        const int n = 200000;
        const double low = std::log(0.4e-9);
        const double high = std::log(1.0);
        for (int k = 0; k < n; ++k)
        {
            const double z = std::exp(low + (high - low)*(k + 0.5)/n);
            sum +=
                1e-19/6*(10e-9/(z*z) + R/sqr(10e-9 + z))*z*(high - low)/n;
        }
        EXPECT_NEAR(Rumpf.work(primary)/sum, 1, 1e-6);
    }
}


TEST(impactBreakage, refusesWhatMakesNoSense)
{
    for
    (
        const std::string& text : strings
        {
            "type impact;",
            "type impact; bond { type JKR; workOfAdhesion 0.05; }",
            "type impact; bond { type JKR; workOfAdhesion 0.05;"
            " PoissonRatio 0.2; }",
            "type impact; factor 0; bond " + glass,
            "type impact; strength 3; bond " + glass
        }
    )
    {
        EXPECT_THROW(fragmentation(parse(text)), IOerror) << text;
    }
}


TEST(impactBreakage, beginsAtItsEnergyAndGivesWhatIsLeft)
{
    // Primaries of 1 um hit aggregates, not head-on
    const double primary = 1e-6;
    const double m = density*pi/6*1e-18;
    const double energy = bond
    (
        parse
        (
            "type JKR; workOfAdhesion 0.05; YoungsModulus 70e9;"
            " PoissonRatio 0.2;"
        )
    ).work(primary);

    struct row
    {
        std::string law;
        int N;
        int hits;
        double C;
        int smaller;
    };

    for
    (
        const row& r : std::vector<row>
        {
            {"", 12, 1, 3, 1}, {"", 2, 1, 3, 1}, {"", 20, 20, 3, 1},
            {"fragments two;", 12, 4, 10, 8},
            {"fragments two; share 0.25; factor 2;", 7, 1, 2, 2}
        }
    )
    {
        const int N = r.N + r.hits;
        const double mass = m*r.N*r.hits/N;
        const double least = r.C*(N - 1)*energy;
        const vec n = vec(1, 2, -0.5).normalized();
        const vec across = n.unitOrthogonal();

        for (const double share : {0.999, 1.001, 4.0})
        {
            for (const bool lightFirst : {false, true})
            {
                const double speed = std::sqrt(2*share*least/mass);
                const vec v(0.3, -0.2, 0.1);

                // The second one comes along -n, the light one or the heavy one
                particleArrays p = clusters
                (
                    lightFirst
                  ? std::vector<int>{r.hits, r.N}
                  : std::vector<int>{r.N, r.hits},
                    primary, {vec::Zero(), vec::Zero()}, v
                );

                const equationOfMotion motion = laws();
                motion.laws().refresh(p);

                contactOutcome::encounter pair;
                pair.i = 0;
                pair.j = 1;
                pair.xi = vec::Zero();
                pair.xj =
                    0.5*(p.collisionDiameter(0) + p.collisionDiameter(1))*n;
                pair.shift = vec::Zero();
                pair.vi = v;
                pair.vj = v - speed*n + 0.7*speed*across;
                pair.time = 0;
                p.x.col(1) = pair.xj;
                p.v.col(1) = pair.vj;

                const vec before = momentum(p);
                const double was = kineticEnergy(p);

                fragmentation all
                (
                    parse("type impact;" + r.law + "bond " + glass)
                );
                all.begin(100, 0);

                collisions both
                (
                    parse("contact { type stick; }"),
                    motion.laws().aggregateModel()
                );
                both.breakBy(all.model());

                const int survivor = both.meet(p, pair);
                ASSERT_GE(survivor, 0);
                motion.laws().refresh(p, survivor);
                p.remove(both.takeAbsorbed(2));
                ASSERT_EQ(p.size(), 1);
                const double together = kineticEnergy(p);

                const bool broke = all.apply
                (
                    p, both.takeImpacts(), motion, anyGas(vec::Zero()), box(),
                    0, 1e-5, 1
                );
                ASSERT_EQ(broke, share > 1) << r.N;

                if (!broke)
                {
                    continue;
                }

                ASSERT_EQ(p.size(), 2);
                EXPECT_EQ(p.primaries(1), r.smaller);

                // To where the lighter one came from; with what is left
                const double mu = p.m(0)*p.m(1)/p.m.sum();
                const double w =
                    std::sqrt(2*(share - 1)*least/std::max(mu, mass));
                const vec back =
                    lightFirst && r.hits < r.N ? vec(-n) : n;

                EXPECT_NEAR
                (
                    (p.v.col(1) - p.v.col(0) - w*back).norm()/speed, 0, 1e-9
                );
                EXPECT_NEAR
                (
                    (p.x.col(1) - p.x.col(0)).normalized().dot(back), 1, 1e-12
                );
                EXPECT_NEAR
                (
                    (momentum(p) - before).norm()/before.norm(), 0, 1e-12
                );
                EXPECT_NEAR
                (
                    (kineticEnergy(p) - together)/(0.5*mu*w*w), 1, 1e-6
                );

                // The energy across the line of centres is gone, too
                EXPECT_LT(kineticEnergy(p), was - 0.99*least);

                // Once
                EXPECT_TRUE(both.takeImpacts().empty());
            }
        }
    }
}


TEST(impactBreakage, breaksNobodyWhoBounces)
{
    particleArrays p =
        clusters({10, 10}, 1e-6, {vec::Zero(), vec(1e-6, 0, 0)});
    const contactOutcome::encounter pair = headOn(20);

    const fragmentation all(parse("type impact; bond " + glass));

    const autoPtr<aggregate> merging =
        aggregate::New(parse("type equivalentSphere;"));
    collisions both
    (
        parse
        (
            "contact { type criticalVelocity; workOfAdhesion 0.05;"
            " YoungsModulus 70e9; PoissonRatio 0.2; }"
        ),
        *merging
    );
    both.breakBy(all.model());

    EXPECT_GT(all.model().hit(p, pair).energy, 0);
    EXPECT_EQ(both.meet(p, pair), collisions::bounced);
    EXPECT_TRUE(both.takeImpacts().empty());
}


TEST(impactBreakage, needsSpeed)
{
    // From which speed on, for primaries of 1 um, 70 GPa, by the formula
    const impactBreakage law
    (
        parse
        (
            "type impact;"
            "bond { type JKR; workOfAdhesion 0.05; YoungsModulus 70e9; }"
        )
    );
    const double E = bond
    (
        parse("type JKR; workOfAdhesion 0.05; YoungsModulus 70e9;")
    ).work(1e-6);

    for
    (
        const std::pair<int, int>& N :
        {
            std::pair<int, int>{1, 2}, std::pair<int, int>{1, 10},
            std::pair<int, int>{1, 100}, std::pair<int, int>{10, 10}
        }
    )
    {
        const particleArrays p =
            clusters({N.first, N.second}, 1e-6, {vec::Zero(), vec::Zero()});

        const double speed = rootOf
        (
            [&](double v)
            {
                return law.hit(p, headOn(v)).energy - 1e-30;
            },
            0, 100
        );

        measured("%d on %d: %.2f m/s\n", N.first, N.second, speed);

        const double mass = p.m(0)*p.m(1)/p.m.sum();
        EXPECT_NEAR
        (
            speed
           /std::sqrt(2*3*(N.first + N.second - 1)*E/mass),
            1, 1e-6
        );
    }
}


TEST(impactBreakage, breaksNoTwoSinglePrimaries)
{
    particleArrays p =
        clusters({1, 1}, 1e-6, {vec::Zero(), vec(1e-6, 0, 0)});

    const impactBreakage law(parse("type impact; bond " + glass));

    EXPECT_EQ(law.hit(p, headOn(10)).energy, 0);

    p.primaries(1) = 2;
    EXPECT_GT(law.hit(p, headOn(10)).energy, 0);

    // Who separates hits nobody
    EXPECT_EQ(law.hit(p, headOn(-10)).energy, 0);
}


TEST(impactBreakage, ofSeveralTheHardestCounts)
{
    // Two hit the same one in a step, and a third one softly; in any order
    const std::vector<vec> from{vec::UnitX(), vec::UnitY(), vec::UnitZ()};
    const std::vector<double> speed{3, 5, 1e-3};

    for (const std::vector<int>& order : std::vector<std::vector<int>>
        {{0, 1, 2}, {1, 0, 2}, {2, 1, 0}, {1, 2, 0}})
    {
        particleArrays p = clusters
        (
            {9, 1, 1, 1}, 1e-6, std::vector<vec>(4, vec::Zero())
        );

        fragmentation all(parse("type impact; bond " + glass));
        const autoPtr<aggregate> merging =
            aggregate::New(parse("type equivalentSphere;"));
        collisions some(parse("contact { type stick; }"), *merging);
        some.breakBy(all.model());

        for (const int k : order)
        {
            contactOutcome::encounter pair;
            pair.i = 1 + k;
            pair.j = 0;
            pair.xi = 1e-6*from[k];
            pair.xj = vec::Zero();
            pair.shift = vec::Zero();
            pair.vi = p.v.col(0) - speed[k]*from[k];
            pair.vj = p.v.col(0);
            pair.time = 0;

            ASSERT_EQ(some.meet(p, pair), 0);
        }

        const auto impacts = some.takeImpacts();

        ASSERT_EQ(impacts.size(), 1u);
        EXPECT_EQ(impacts.begin()->first, p.id(0));
        EXPECT_NEAR
        (
            impacts.begin()->second.direction.dot(from[1]), 1, 1e-12
        );
    }
}


TEST(impactBreakage, flyApart)
{
    // Without gas: what has broken is not together again, with any strategy
    for (const std::string& stepping :
        {conventional, multipleTimeStep, eventDriven})
    {
        settings s;
        s.stepping = stepping;
        s.drag = "type none;";
        s.aggregate = "type fractal; dimension 1.8;";
        s.contact = "type stick;";
        s.breakage = "type impact; bond " + glass;

        particleArrays p = clusters
        (
            {30, 5, 1}, 1e-6,
            {vec(-2e-5, 0, 0), vec(2e-5, 1e-6, 0), vec(0, 9e-5, 0)}
        );
        p.id << 0, 1, 2;
        p.v.col(0) << 1, 0, 0;
        p.v.col(1) << -3, 0, 0;

        experiment one(p, 2e-4, s);
        const vec before = momentum(one.p);

        one.run(1e-6, 25);

        EXPECT_EQ(one.count(), 1) << stepping;
        EXPECT_EQ(one.broken(), 1) << stepping;

        ASSERT_EQ(one.p.size(), 3);
        EXPECT_EQ(one.p.id(2), 3);
        EXPECT_EQ(one.p.primaries(0), 34);
        EXPECT_EQ(one.p.primaries(2), 1);
        EXPECT_NEAR((momentum(one.p) - before).norm()/before.norm(), 0, 1e-12);

        // As far from one another as they have flown since
        const vec r = one.nearest(one.p.x.col(2) - one.p.x.col(0));
        const vec v = one.p.v.col(2) - one.p.v.col(0);
        EXPECT_GT(r.norm(), 10e-6);
        EXPECT_GT(r.normalized().dot(v.normalized()), 0.95);
    }
}


// ************************************************************************* //
