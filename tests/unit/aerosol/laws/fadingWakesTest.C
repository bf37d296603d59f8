/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Wakes that fade out where users let them end: after 20 diameters, or as far
    as by default. In sound, particles swing through the ranges of one another;
    time steps are of second order nevertheless, and find the contacts that
    shorter steps find.

\*---------------------------------------------------------------------------*/

#include "measured.H"
#include "timeSteppingTools.H"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double frequency = 1400;
const double amplitude = 1.53;
const double density = 2300;


//- On its periodic path, as if it were alone
sphere swinging(const int id, const double d, const vec& x)
{
    return
    {
        id, d, density, x,
        vec
        (
            periodicVelocity
            (
                2*pi*frequency, relaxationTime(d, density), amplitude
            ),
            0,
            0
        )
    };
}


//- Small ones about a coarse one, through whose range they swing, but touch
//  none
particleArrays aboutACoarseOne()
{
    randomNumbers random(1);
    std::vector<sphere> spheres{swinging(0, 10e-6, vec::Zero())};

    while (spheres.size() < 41)
    {
        const vec x = random.point(300e-6);

        if (x.tail<2>().norm() > 12e-6)
        {
            spheres.push_back(swinging(spheres.size(), 1.5e-6, x));
        }
    }

    return arrays(spheres);
}


//- Fly ash in a periodic cube, up to a largest diameter
particleArrays flyAsh
(
    const int n,
    const double length,
    const double largest,
    const int seed
)
{
    randomNumbers random(seed);
    std::vector<sphere> spheres;

    while (static_cast<int>(spheres.size()) < n)
    {
        // Nearly normally distributed
        double z = -6;
        for (int k = 0; k < 12; ++k)
        {
            z += random.uniform(0, 1);
        }

        const double d = 1.5e-6*std::pow(1.8, z);
        const vec x = random.point(0.5*length);

        const bool apart = std::none_of
        (
            spheres.begin(), spheres.end(),
            [&](const sphere& other)
            {
                vec r = other.x - x;
                r -= length*(r/length).array().round().matrix();
                return r.norm() < 0.51*(d + other.d);
            }
        );

        if (apart && d > 0.3e-6 && d < largest)
        {
            spheres.push_back(swinging(spheres.size(), d, x));
        }
    }

    return arrays(spheres);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(fadingWakes, leaveTimeStepsOfSecondOrder)
{
    const int periods = 3;

    for (const std::string type : {"Oseen", "memory", "history"})
    {
        for (const std::string range : {"", " range 20;"})
        {
            for (const std::string& stepping : {eventDriven, multipleTimeStep})
            {
                settings law;
                law.stepping = stepping;
                law.contact = "type none;";
                law.wake = "type " + type + ';' + range;

                const auto end = [&](const int perPeriod)
                {
                    experiment box
                    (
                        aboutACoarseOne(), 0.02, law, frequency,
                        {amplitude, 0, 0}
                    );
                    box.run(1/frequency/perPeriod, periods*perPeriod);
                    return box.p.x;
                };

                // The error of second order that is left there, 1/64 of that
                // at T/100, does not matter
                const vectors exact = end(800);
                double before = 0;

                for (const int perPeriod : {25, 50, 100})
                {
                    const double error =
                        (end(perPeriod) - exact).norm()/std::sqrt(41);

                    measured
                    (
                        "%s wake { type %s;%s } T/%d: %.3f nm, ratio %.1f\n",
                        stepping.c_str(), type.c_str(), range.c_str(),
                        perPeriod, 1e9*error, before/error
                    );

                    if (before > 0)
                    {
                        EXPECT_GT(before/error, 3.5)
                            << stepping << type << range << perPeriod;
                    }

                    // As exact as where all act on all, a nanometre
                    if (stepping == eventDriven && perPeriod == 50)
                    {
                        EXPECT_LT(error, 1e-9) << type << range;
                    }

                    before = error;
                }
            }
        }
    }
}


TEST(fadingWakes, leaveTheContactsOfLongSteps)
{
    // Twenty times as dense as usual; the tests of each build are content with
    // less, but denser
    const int n = full() ? 1000 : 400;
    const double length = std::cbrt(n/(full() ? 4.8e12 : 2e13));
    const double largest = full() ? 10e-6 : 6e-6;
    const int nSeeds = full() ? 8 : 1;
    const int periods = full() ? 5 : 3;
    const int reference = full() ? 400 : 200;

    using pairs = std::set<std::pair<std::int64_t, std::int64_t>>;

    for (const std::string range : {" range 20;", ""})
    {
        const auto found = [&]
        (
            const int perPeriod,
            const int seed,
            const double moved
        )
        {
            settings law;
            law.stepping = eventDriven;
            law.gravity = "type uniform; value (0 0 -9.81);";
            law.wake = "type Oseen;" + range;

            particleArrays p = flyAsh(n, length, largest, seed);
            randomNumbers random(9);

            for (int i = 0; i < n; ++i)
            {
                p.x.col(i) += random.point(moved);
            }

            experiment box(p, length, law, frequency, {amplitude, 0, 0});
            box.run(1/frequency/perPeriod, periods*perPeriod);

            pairs result;
            for (const meeting& one : meetings)
            {
                result.insert(one.pair());
            }

            return result;
        };

        struct run
        {
            int perPeriod;
            double moved;
            int missed = 0;
            int added = 0;
        };

        std::vector<run> runs{{50, 0}};

        if (full())
        {
            runs.push_back({20, 0});

            // Some contacts hang on less than a nanometre: so many are others
            // from places that are a nanometre beside
            runs.push_back({reference, 1e-9});
        }

        std::size_t all = 0;

        for (int seed = 1; seed <= nSeeds; ++seed)
        {
            const pairs expected = found(reference, seed, 0);
            all += expected.size();

            for (run& one : runs)
            {
                const pairs these = found(one.perPeriod, seed, one.moved);

                for (const auto& pair : expected)
                {
                    one.missed += !these.count(pair);
                }
                for (const auto& pair : these)
                {
                    one.added += !expected.count(pair);
                }
            }
        }

        for (const run& one : runs)
        {
            measured
            (
                "wake { type Oseen;%s } of %d contacts, T/%d%s misses %d and"
                " adds %d\n",
                range.c_str(), int(all), one.perPeriod,
                one.moved > 0 ? " from 1 nm beside" : "", one.missed, one.added
            );
        }

        EXPECT_GT(all, nSeeds*4u) << range;
        EXPECT_LE(runs[0].missed, 1) << range;
        EXPECT_LE(runs[0].added, 1) << range;
    }
}


// ************************************************************************* //
