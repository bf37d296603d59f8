/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bruteForce.H"
#include "timeSteppingTools.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pitch = 1400;
const double period = 1/pitch;
const double amplitude = 1.2;
const double density = 2000;


//- A cluster at rest
particleArrays closeParticles(const int seed)
{
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> any(0, 1);
    const int n = 30 + seed % 3*10;
    particleArrays p;
    p.resize(n);

    for (int i = 0; i < n;)
    {
        p.id(i) = i;
        p.d(i) = 1e-6*std::pow(15, any(engine));
        p.m(i) = density*pi/6*std::pow(p.d(i), 3);
        p.primaries(i) = 1;
        p.x.col(i) = 120e-6*vec(any(engine), any(engine), any(engine));
        p.v.col(i).setZero();
        bool apart = true;
        for (int j = 0; j < i; ++j)
        {
            apart = apart
             && (p.x.col(i) - p.x.col(j)).norm() > 0.55*(p.d(i) + p.d(j));
        }
        i += apart;
    }
    return p;
}


//- The same on their periodic paths, as if they were alone
particleArrays onOrbits(const int seed)
{
    particleArrays p = closeParticles(seed);

    for (int i = 0; i < p.size(); ++i)
    {
        const double Kn = 2*gasProperties::air().meanFreePath/p.d(i);
        const double tau =
            relaxationTime(p.d(i), density)
           *(1 + Kn*(1.257 + 0.4*std::exp(-1.1/Kn)));

        p.v(0, i) = periodicVelocity(2*pi*pitch, tau, amplitude);
        p.v(1, i) = -9.81*(1 - gasProperties::air().rho/density)*tau;
    }

    return p;
}


//- A full periodic box, of those at rest or on their periodic paths in a gas
//  of the velocity u
const double boxLength = 150e-6;

particleArrays box(const int seed, const double u = 0)
{
    return arrays
    (
        aerosolOf(40, boxLength, 2e-6, 15e-6, density, pitch, u, seed)
    );
}


//- What happens to them; in a box so large that no image matters if there is no
//  other length
bruteForce::conditions conditions(const double range, const double length)
{
    bruteForce::conditions law;
    law.frequency = pitch;
    law.u = amplitude;
    law.gravity = 9.81;
    law.range = range;
    law.length = length;
    return law;
}


//- With the ranges of wakes that the code chooses by itself: half a mean radius
//  of the particles, times the angular frequency
bruteForce::conditions byDefault
(
    bruteForce::conditions law,
    const particleArrays& p
)
{
    law.range = 0;
    law.bound = 0.25*p.d.mean()*2*pi*pitch;
    return law;
}


//- The same by the code: the contacts are in `meetings`
void step
(
    const particleArrays& p,
    const bruteForce::conditions& law,
    const std::string& type,
    const double end,
    const int perPeriod
)
{
    settings s;
    s.stepping = type;
    s.drag = "type Stokes; slipCorrection Cunningham;";
    s.gravity = "type uniform; value (0 -9.81 0);";
    s.wake =
        law.bound > 0 ? std::string("type Oseen;")
      : "type Oseen; range " + std::to_string(law.range) + ";";

    experiment box
    (
        p, law.length > 0 ? law.length : 0.02, s, pitch, {amplitude, 0, 0}
    );
    box.run(period/perPeriod, std::lround(end*perPeriod/period));
}


//- How the code does against the reference, which knows nothing of it
struct comparison
{
    //- Sets in which there is a contact, and those of them in which the first
    //  pair, and the whole order of contacts, is the same
    int sets = 0;
    int samePair = 0;
    int sameOrder = 0;

    //- Errors of the time, in fluid steps, and of the place of the first
    //  contact, in the way of the gas in a fluid step; of the times of all
    std::vector<double> time;
    std::vector<double> place;
    std::vector<double> all;

    static double quantile(std::vector<double> values, const double q)
    {
        std::sort(values.begin(), values.end());
        return values.at(std::size_t(q*(values.size() - 1) + 0.5));
    }
};


comparison compare
(
    const std::function<particleArrays(int)>& particles,
    const int nSets,
    const bruteForce::conditions& given,
    const std::string& type,
    const int perPeriod
)
{
    const double h = period/perPeriod;
    comparison result;

    for (int seed = 1; seed <= nSets; ++seed)
    {
        const particleArrays p = particles(seed);
        const bruteForce::conditions law =
            given.range > 0 ? given : byDefault(given, p);

        bruteForce exact(p, law);
        exact.run(0.25*period);
        const auto& expected = exact.contacts();

        if (expected.empty())
        {
            continue;
        }
        ++result.sets;

        // The code may be late
        step(p, law, type, 0.28*period, perPeriod);

        std::stable_sort
        (
            meetings.begin(), meetings.end(),
            [](const meeting& a, const meeting& b)
            {
                return a.time < b.time;
            }
        );

        for (const auto& contact : expected)
        {
            const auto same = std::find_if
            (
                meetings.begin(), meetings.end(),
                [&](const meeting& m) { return m.pair() == contact.ids; }
            );

            if (same != meetings.end())
            {
                result.all.push_back(std::abs(same->time - contact.time)/h);
            }
        }

        if (meetings.size() && meetings[0].pair() == expected[0].ids)
        {
            ++result.samePair;
            result.time.push_back
            (
                std::abs(meetings[0].time - expected[0].time)/h
            );

            vec apart =
                0.5*(meetings[0].xi + meetings[0].xj) - expected[0].place;
            if (law.length > 0)
            {
                apart -=
                    law.length*(apart/law.length).array().round().matrix();
            }
            result.place.push_back(apart.norm()/(h*amplitude));
        }

        result.sameOrder +=
            meetings.size() >= expected.size()
         && std::equal
            (
                expected.begin(), expected.end(), meetings.begin(),
                [](const bruteForce::contact& a, const meeting& b)
                {
                    return a.ids == b.pair();
                }
            );
    }

    std::cout
        << "    " << type << " T/" << perPeriod << ": " << result.samePair
        << " first pairs and " << result.sameOrder << " orders of "
        << result.sets << " sets; time of the first in fluid steps, median "
        << comparison::quantile(result.time, 0.5) << ", 90 % below "
        << comparison::quantile(result.time, 0.9) << ", place "
        << comparison::quantile(result.place, 0.9) << "; of all "
        << comparison::quantile(result.all, 0.5) << ", "
        << comparison::quantile(result.all, 0.9) << std::endl;

    return result;
}


//- Who, when and where, to 1e-3 of a fluid step. Contacts that come in the step
//  of another one and after it are found later or sooner by a part of that
//  step: those outside of a cluster feel what has merged there from the next
//  step on.
void expectTheSame(const comparison& c, const double within = 1e-3)
{
    EXPECT_GE(c.sets, 20);
    EXPECT_EQ(c.samePair, c.sets);
    EXPECT_GE(c.sameOrder, 0.95*c.sets);
    EXPECT_LT(comparison::quantile(c.time, 0.9), within);
    EXPECT_LT(comparison::quantile(c.place, 0.9), 1e-3);
    EXPECT_LT(comparison::quantile(c.all, 0.5), 1e-3);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(bruteForce, mergesOnPathsInClosedForm)
{
    // Three without wakes that merge one after the other, across faces of the
    // box, which end where paths in closed form do
    const double omega = 2*pi*pitch;
    const double length = 100e-6;

    bruteForce::conditions law;
    law.frequency = pitch;
    law.u = amplitude;
    law.length = length;
    law.slipCorrection = false;

    const std::vector<sphere> spheres
    {
        {5, 10e-6, density, {48e-6, 0, 49e-6}, {0.5, 0.1, 0}},
        {2, 8e-6, density, {-39e-6, 1e-6, -50e-6}, {-0.5, 0, 0}},
        {7, 11e-6, density, {-29e-6, 4e-6, -49e-6}, {-0.6, 0, 0.01}}
    };
    const particleArrays p = arrays(spheres);

    std::vector<freePath> paths;
    for (int i = 0; i < 3; ++i)
    {
        paths.emplace_back
        (
            0, p.x.col(i), p.v.col(i), p.d(i), p.m(i), omega, amplitude
        );
    }

    // The first lives on until the third, which is lighter than both together
    freePath one = paths[0];
    std::vector<double> times;

    for (const freePath& other : {paths[1], paths[2]})
    {
        const double touch = 0.5*(one.d + other.d);

        const auto r = [&](const double t)
        {
            vec result = other.x(t) - one.x(t);
            result -= length*(result/length).array().round().matrix();
            return result;
        };

        double low = times.empty() ? 0 : times[0];
        double high = low;
        while (r(high).norm() > touch && high < period)
        {
            low = high;
            high += 1e-7;
        }
        for (int n = 0; n < 60; ++n)
        {
            const double t = 0.5*(low + high);
            (r(t).norm() > touch ? low : high) = t;
        }
        times.push_back(high);

        const double m = one.m + other.m;
        one = freePath
        (
            high,
            one.x(high) + other.m/m*r(high),
            (one.m*one.v(high) + other.m*other.v(high))/m,
            std::cbrt(std::pow(one.d, 3) + std::pow(other.d, 3)),
            m,
            omega,
            amplitude
        );
    }

    const double end = 0.5*period;
    ASSERT_LT(times[1], end);

    bruteForce reference(p, law);
    reference.run(end);

    ASSERT_EQ(reference.contacts().size(), 2u);
    EXPECT_EQ(reference.contacts()[0].ids, std::make_pair(2l, 5l));
    EXPECT_EQ(reference.contacts()[1].ids, std::make_pair(5l, 7l));

    // To 1e-5 of the 50th part of a period
    for (int n = 0; n < 2; ++n)
    {
        EXPECT_NEAR(reference.contacts()[n].time, times[n], 2e-7*period);
    }

    const particleArrays left = reference.particles();
    ASSERT_EQ(left.size(), 1);

    vec error = left.x.col(0) - one.x(end);
    error -= length*(error/length).array().round().matrix();
    EXPECT_LT(error.norm(), 1e-6*one.d);
    EXPECT_LT((left.v.col(0) - one.v(end)).norm(), 1e-6*amplitude);
    EXPECT_NEAR(left.d(0)/one.d, 1, 1e-14);
    EXPECT_EQ(left.id(0), 5);
}


TEST(bruteForce, isConverged)
{
    const auto check = [](const particleArrays& p, bruteForce::conditions law)
    {
        bruteForce usual(p, law);
        law.tolerance /= 100;
        bruteForce finer(p, law);

        usual.run(0.25*period);
        finer.run(0.25*period);

        const auto& a = usual.contacts();
        const auto& b = finer.contacts();

        EXPECT_EQ(a.size(), b.size());

        for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n)
        {
            EXPECT_EQ(a[n].ids, b[n].ids);

            // To 1e-5 of the 50th part of a period
            EXPECT_NEAR(a[n].time, b[n].time, 2e-7*period);
        }

        return a.size();
    };

    std::size_t count = 0;

    for (int seed = 1; seed <= 8; ++seed)
    {
        count += check(closeParticles(seed), conditions(400, 0));
        count += check(box(seed, amplitude), conditions(5, boxLength));
    }

    EXPECT_GT(count, 10u);
}


TEST(eventDriven, findsTheContactsOfBruteForce)
{
    // Wakes that act on all of them, up to 20 diameters, and as far as by
    // default. After 20 diameters the wakes of small ones fade out in less than
    // the way of a step: their effect on times is small, but seen.
    for (const double range : {400, 20, 0})
    {
        expectTheSame
        (
            compare(onOrbits, 40, conditions(range, 0), eventDriven, 50),
            range == 20 ? 3e-3 : 1e-3
        );
    }
}


TEST(multipleTimeStep, findsTheContactsOfBruteForce)
{
    for (const double range : {400, 20, 0})
    {
        expectTheSame
        (
            compare
            (
                onOrbits, 40, conditions(range, 0),
                "type multipleTimeStep; kp 0.1; kc 0.02;", 200
            ),
            range == 20 ? 3e-3 : 1e-3
        );
    }
}


TEST(eventDriven, findsContactsAtTimesOfSecondOrder)
{
    // At rest in gas that begins to move: slips change within less than a step.
    // Half the step, a quarter of the error or less, with 15 % to spare for the
    // spread of the medians.
    std::array<double, 2> medians;

    for (const int k : {0, 1})
    {
        const int perPeriod = k ? 100 : 50;
        const comparison c =
            compare
            (
                closeParticles, 40, conditions(400, 0), eventDriven, perPeriod
            );

        EXPECT_GE(c.sets, 20);
        EXPECT_EQ(c.samePair, c.sets);
        medians[k] = comparison::quantile(c.time, 0.5)/perPeriod;
    }

    EXPECT_LT(medians[1], 1.15*medians[0]/4);
}


TEST(eventDriven, findsTheContactsOfBruteForceInABox)
{
    // With images, and with wakes that end at half of the box at the most:
    // after five diameters, where they would be a seventh of the slip
    const comparison c = compare
    (
        [](const int seed) { return box(seed, amplitude); },
        30, conditions(5, boxLength), eventDriven, 50
    );

    EXPECT_GE(c.sets, 10);
    EXPECT_EQ(c.samePair, c.sets);
    EXPECT_GE(c.sameOrder, 0.95*c.sets);
    EXPECT_LT(comparison::quantile(c.time, 0.9), 3e-3);
}


// ************************************************************************* //
