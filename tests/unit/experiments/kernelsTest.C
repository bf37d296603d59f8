/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Collision kernels that are known exactly, of particles that pass through
    one another and count each contact.

    All places are independent and uniform, overlaps at the beginning included
    and not counted: so the expected number of contacts is the kernel's at all
    times, without any correlation. And as all move on lines, geometry tells of
    each pair how often it comes into contact: statistics judge the kernel, but
    every single contact is checked as well.

\*---------------------------------------------------------------------------*/

#include "linearShear.H"
#include "measured.H"
#include "timeSteppingTools.H"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A number of spheres of each diameter, anywhere in a box
particleArrays anywhere
(
    const std::vector<int>& number,
    const std::vector<double>& diameter,
    const double density,
    const vec& length,
    randomNumbers& random
)
{
    std::vector<sphere> spheres;

    for (std::size_t k = 0; k < number.size(); ++k)
    {
        for (int n = 0; n < number[k]; ++n)
        {
            spheres.push_back
            ({
                std::int64_t(spheres.size()), diameter[k], density,
                random.point(0.5).cwiseProduct(length), vec::Zero()
            });
        }
    }

    return arrays(spheres);
}


//- Pairs that move along one axis relative to each other
struct lines
{
    particleArrays p;
    vec length;
    int axis;

    //- Displacements of j relative to i: at the beginning, wherever they turn,
    //  and at the end
    std::function<std::vector<double>(int, int)> way;

    //- Whether the lines are as close as that
    bool near(const int i, const int j, const double distance) const
    {
        double c = distance*distance;

        for (const int k : {(axis + 1) % 3, (axis + 2) % 3})
        {
            double r = p.x(k, j) - p.x(k, i);
            r -= length(k)*std::nearbyint(r/length(k));
            c -= r*r;
        }

        return c > 0;
    }

    //- How often two come to within a distance, if all displacements are off by
    //  an error
    int entries
    (
        const int i,
        const int j,
        const double distance,
        const double error
    ) const
    {
        vec r = p.x.col(j) - p.x.col(i);
        double c = distance*distance;

        for (const int k : {(axis + 1) % 3, (axis + 2) % 3})
        {
            r(k) -= length(k)*std::nearbyint(r(k)/length(k));
            c -= r(k)*r(k);

            if (c <= 0)
            {
                return 0;
            }
        }

        c = std::sqrt(c);
        std::vector<double> places = way(i, j);
        int n = 0;

        for (std::size_t k = 1; k < places.size(); ++k)
        {
            places[k] += error;
        }

        for (std::size_t k = 1; k < places.size(); ++k)
        {
            // Whoever moves up comes in at -c, and so at every image
            const double up = places[k] > places[k - 1] ? 1 : -1;

            const auto passed = [&](const double place)
            {
                return std::floor((up*(r(axis) + place) + c)/length(axis));
            };

            n += passed(places[k]) - passed(places[k - 1]);
        }

        return n;
    }
};


//- Contacts of the pairs of two sizes, added up over runs
struct tally
{
    double contacts = 0;
    double squares = 0;
    double expected = 0;

    //- One standard deviation: a pair that meets twice counts as one event
    double error() const
    {
        return std::sqrt(squares)/contacts;
    }

    void check(const char* what, const std::string& stepping) const
    {
        measured
        (
            "%s, %s: K/theory %.4f +- %.4f (%.0f contacts)\n",
            stepping.c_str(), what, contacts/expected,
            std::sqrt(squares)/expected, contacts
        );

        EXPECT_LE(error(), full() ? 0.03 : 0.13) << what;
        EXPECT_NEAR(contacts/expected, 1, 4*std::sqrt(squares)/expected)
            << what;
    }
};

//- By both diameters
using tallies = std::map<std::pair<double, double>, tally>;


//- Add the contacts to the tallies. Returns how many pairs have met more or
//  less often than geometry says of all spheres that are thicker or thinner,
//  and of all ways that are off, by up to the slack [m]; `doubtful` are those
//  for which that makes a difference.
int count
(
    const std::vector<collisions::record>& records,
    const lines& geometry,
    const double slack,
    tallies& sums,
    int& doubtful
)
{
    std::map<std::pair<std::int64_t, std::int64_t>, int> times;

    for (const collisions::record& r : records)
    {
        // Else it was so from the beginning
        if (r.time > 0)
        {
            ++times[std::minmax(r.id1, r.id2)];
        }
    }

    const particleArrays& p = geometry.p;
    int wrong = 0;

    for (int i = 0; i < p.size(); ++i)
    {
        for (int j = i + 1; j < p.size(); ++j)
        {
            const double touch = 0.5*(p.d(i) + p.d(j));

            if (!geometry.near(i, j, touch + slack))
            {
                continue;
            }

            // Who begins, turns or ends near contact may have the same number
            // at both ends of the slack and another one between
            int least = std::numeric_limits<int>::max();
            int most = 0;

            for (const double share : {-1.0, -0.5, -0.1, 0.0, 0.1, 0.5, 1.0})
            {
                for (const double error : {-slack, 0.0, slack})
                {
                    const int n =
                        geometry.entries(i, j, touch + share*slack, error);

                    least = std::min(least, n);
                    most = std::max(most, n);
                }
            }

            if (most == 0)
            {
                continue;
            }

            const auto met = times.find({i, j});
            const int n = met == times.end() ? 0 : met->second;

            doubtful += most != least;
            wrong += n < least || n > most;
        }
    }

    for (const auto& met : times)
    {
        const int i = met.first.first;
        const int j = met.first.second;
        const double touch = 0.5*(p.d(i) + p.d(j));

        // None but those
        wrong += !geometry.near(i, j, touch + slack);

        tally& sum = sums[std::minmax(p.d(i), p.d(j))];
        sum.contacts += met.second;
        sum.squares += met.second*met.second;
    }

    return wrong;
}


class kernels
:
    public testing::TestWithParam<std::string>
{
protected:

    settings law_;

    kernels()
    {
        law_.stepping = GetParam();
        law_.contact = "type stick;";
        law_.aggregate = "type none;";
    }

    //- First word of what selects the time stepping
    std::string name() const
    {
        const std::string text = GetParam().substr(5);
        return text.substr(0, text.find(';'));
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

INSTANTIATE_TEST_SUITE_P
(
    timeStepping,
    kernels,
    testing::Values(multipleTimeStep, eventDriven),
    [](const testing::TestParamInfo<std::string>& stepping)
    {
        return stepping.index ? "eventDriven" : "multipleTimeStep";
    }
);


TEST_P(kernels, ofLaminarShear)
{
    // Smoluchowski: K = G (d1 + d2)^3/6 in u = (G y, 0, 0). The particles keep
    // their y, and so have the velocity of the gas for ever. They are within
    // |y| < W/2, so that none meets an image in y, whose velocity would be
    // wrong: those at the border lack neighbours, exactly the share
    // 3 pi (d1 + d2)/(32 W) of the contacts. Two of them meet at relative
    // speeds of less than G (d1 + d2)/2, and the run ends before such a pair
    // can have come round the box.
    const double G = 1000;
    const double d = 2e-6;
    const int share = full() ? 1 : 12;

    struct mixture
    {
        std::vector<int> number;
        vec slab;
        double end;
    };

    for
    (
        const mixture& now :
        {
            mixture{{4200/share}, d*vec(500, 12, 700/share), 480/G},
            mixture
            {
                {4000/share, 4000/share}, d*vec(750, 12, 2200/share), 370/G
            }
        }
    )
    {
        const vec& slab = now.slab;
        const vec length(slab(0), 1.2*slab(1), slab(2));
        const int steps = static_cast<int>(std::lround(now.end*G));
        const int n = now.number.size();

        ASSERT_LT(G*now.end*n*d, slab(0) - 2*n*d);

        randomNumbers random(1);
        particleArrays p =
            anywhere(now.number, {d, 2*d}, 40e3, slab, random);

        p.v.row(0) = G*p.x.row(1);

        const lines geometry
        {
            p, length, 0,
            [&](const int i, const int j) -> std::vector<double>
            {
                return {0, G*(p.x(1, j) - p.x(1, i))*now.end};
            }
        };

        law_.stepping =
            GetParam() == multipleTimeStep
          ? "type multipleTimeStep; kp 1; kc 1;"
          : GetParam();

        experiment shear
        (
            p, length, law_,
            sound<acoustics::linearShear>
            (
                "type linearShear; shearRate 1000;"
            )
        );
        shear.run(now.end/steps, steps);

        // In a collision step of multipleTimeStep two that are so close move
        // by d/15 relative to one another
        tallies sums;
        int doubtful = 0;
        EXPECT_EQ(count(shear.records(), geometry, 1e-3*d, sums, doubtful), 0);
        EXPECT_LT(doubtful, 20);

        const double d1 = d;
        const double d2 = n*d;
        const double d12 = d1 + d2;
        const double K = G/6*d12*d12*d12*(1 - 3*pi*d12/(32*slab(1)));
        const double pairs =
            n == 1
          ? 0.5*now.number[0]*(now.number[0] - 1)
          : double(now.number[0])*now.number[1];

        tally& sum = sums[{d1, d2}];
        sum.expected = pairs/slab.prod()*K*now.end;
        sum.check(n == 1 ? "shear, equal" : "shear, 1 to 2", name());
    }
}


TEST_P(kernels, ofSettling)
{
    // K = pi/4 (d1 + d2)^2 |v1 - v2|, until a pair can meet an image
    const double d1 = 10e-6;
    const double d2 = 20e-6;
    const double density = 2300;
    const double buoyancy = 1 - gasProperties::air().rho/density;
    const vec length = vec::Constant(2.5e-3);
    const int number = full() ? 3800 : 1200;
    const int steps = 60;

    randomNumbers random(2);
    particleArrays p =
        anywhere({number, number}, {d1, d2}, density, length, random);

    for (int i = 0; i < p.size(); ++i)
    {
        p.v(2, i) = -9.81*buoyancy*relaxationTime(p.d(i), density);
    }

    const double speed = p.v(2, 0) - p.v(2, p.size() - 1);
    const double end = 0.95*length(2)/speed;

    const lines geometry
    {
        p, length, 2,
        [&](const int i, const int j) -> std::vector<double>
        {
            return {0, (p.v(2, j) - p.v(2, i))*end};
        }
    };

    law_.gravity = "type uniform; value (0 0 -9.81);";
    experiment still(p, length(0), law_);
    still.run(end/steps, steps);

    // multipleTimeStep may miss those that pass within a collision step
    tallies sums;
    int doubtful = 0;
    EXPECT_EQ(count(still.records(), geometry, 1e-3*d1, sums, doubtful), 0);
    EXPECT_LT(doubtful, 20);

    // Two of the same size never meet
    ASSERT_EQ(sums.size(), 1u);

    tally& sum = sums[{d1, d2}];
    sum.expected =
        double(number)*number/length.prod()
       *pi/4*std::pow(d1 + d2, 2)*speed*end;
    sum.check("settling", name());
}


TEST_P(kernels, ofOrthokineticMotionWithFullRefill)
{
    // Gas that swings alike everywhere moves two sizes to and fro, with the
    // relative velocity u12 sin(omega t + phi),
    //     u12 = u0 omega |t1 - t2|/sqrt((1 + (omega t1)^2)(1 + (omega t2)^2)).
    // In places that are uniform at all times the rate of contacts is
    // pi/4 (d1 + d2)^2 times the mean speed, (2/pi) u12: in one period, with
    // the relative displacement A = u12/omega either way, a volume of
    // 4 A pi/4 (d1 + d2)^2. That is what the kernel means, and counts each
    // time that a pair comes into contact: the way back sweeps the same volume
    // once more. If a pair counted once only, it would be half of it, 2 A, in
    // as many contacts as there are if all stick. All places are new in each
    // period.
    const double frequency = 1400;
    const double omega = 2*pi*frequency;
    const double u0 = 1.53;
    const double d1 = 1e-6;
    const double d2 = 5e-6;
    const double density = 2300;
    const vec length = vec::Constant(600e-6);
    const int number = 2000;
    const int periods = full() ? 9 : 1;
    const bool exact = name() == "eventDriven";
    const int steps = exact ? 20 : 50;

    // In clusters the gas is linear in time over a step, which is off by up to
    // (omega h)^2/12 of the velocity, on ways of 0.26 mm
    const double slack = 0.3e-6;

    const auto response = [&](const double d)
    {
        return
            1.0/std::complex<double>(1, omega*relaxationTime(d, density));
    };

    // Displacements of 2 relative to 1 since t = 0, where they turn
    const std::complex<double> H = response(d2) - response(d1);
    std::vector<double> phases{0, -std::arg(H), 2*pi};
    phases[1] -= pi*std::floor(phases[1]/pi);
    phases.insert(phases.begin() + 2, phases[1] + pi);

    std::vector<double> forth;
    std::vector<double> back;
    for (const double phase : phases)
    {
        const double s =
            u0/omega
           *(H*(std::polar(1.0, phase) - 1.0)/std::complex<double>(0, 1))
           .imag();
        forth.push_back(s);
        back.push_back(-s);
    }
    const std::vector<double> none{0, 0};

    randomNumbers random(3);
    tallies sums;
    int doubtful = 0;
    int wrong = 0;

    for (int period = 0; period < periods; ++period)
    {
        particleArrays p =
            anywhere({number, number}, {d1, d2}, density, length, random);

        for (int i = 0; i < p.size(); ++i)
        {
            p.v(0, i) = u0*response(p.d(i)).imag();
        }

        const lines geometry
        {
            p, length, 0,
            [&](const int i, const int j)
            {
                return p.d(i) == p.d(j) ? none : p.d(i) < p.d(j) ? forth : back;
            }
        };

        experiment swing(p, length(0), law_, frequency, {u0, 0, 0});
        swing.run(1/(frequency*steps), steps);

        wrong += count(swing.records(), geometry, slack, sums, doubtful);
    }

    measured
    (
        "%s, T/%d: %d pairs wrong by more than %.2g um, %d in doubt\n",
        name().c_str(), steps, wrong, 1e6*slack, doubtful
    );
    // Whoever comes back within the last collision step of multipleTimeStep may
    // be taken for one that has not been away
    const double contacts = sums.begin()->second.contacts;
    EXPECT_LE(wrong, exact ? 0 : 0.002*contacts);
    EXPECT_LT(doubtful, 0.3*contacts);

    // Two of the same size never meet
    ASSERT_EQ(sums.size(), 1u);

    const double s1 = omega*relaxationTime(d1, density);
    const double s2 = omega*relaxationTime(d2, density);
    const double u12 =
        u0*std::abs(s1 - s2)/std::sqrt((1 + s1*s1)*(1 + s2*s2));

    tally& sum = sums[{d1, d2}];
    sum.expected =
        double(number)*number/length.prod()*periods/frequency
       *pi/4*std::pow(d1 + d2, 2)*2/pi*u12;
    sum.check("orthokinetic", name());
}


// ************************************************************************* //
