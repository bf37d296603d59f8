/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The sound in a representative box: no place in it is special, and all drift
    as they do in the sound itself. With s = omega tau the drifts are, to second
    order in the amplitude,
        travelling wave   u0^2/(2c) 1/(1 + s^2)
        standing wave     -1/(4 omega) d(U^2)/dx s/(1 + s^2)
    Where drag is not linear or not steady, the same particles in a resolved
    wave, in a box of one wavelength, are the reference.

\*---------------------------------------------------------------------------*/

#include "measured.H"
#include "standingWave.H"
#include "timeSteppingTools.H"
#include "travellingWave.H"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double density = 2300;
const double c = gasProperties::air().c;

//- Both waves, of frequency f, velocity amplitude U and more entries
acoustics::soundField* travelling
(
    const double f,
    const double U,
    const std::string& more = ""
)
{
    return sound<acoustics::travellingWave>
    (
        "type travellingWave; frequency " + std::to_string(f)
      + "; velocityAmplitude " + std::to_string(U) + ";" + more
    );
}

acoustics::soundField* standing
(
    const double f,
    const double U,
    const std::string& more = ""
)
{
    return sound<acoustics::standingWave>
    (
        "type standingWave; frequency " + std::to_string(f)
      + "; velocityAmplitude " + std::to_string(U) + ";" + more
    );
}


//- Diameter for omega tau = s
double diameter(const double s, const double omega)
{
    return std::sqrt(18*gasProperties::air().mu*s/(omega*density));
}


//- Mean displacements, from period to period, over many periods [m/s]
Eigen::ArrayXd drift(experiment& box, const double f, const int steps)
{
    const double h = 1/(f*steps);
    const int transient = 30;
    const int periods = 30;

    vectors last = box.p.x;
    vectors mean = vectors::Zero(3, last.cols());
    vectors moved = vectors::Zero(3, last.cols());
    vectors means[2];

    for (int n = 0; n < (transient + periods + 1)*steps; ++n)
    {
        if (n == transient*steps + steps || n == (transient + periods)*steps)
        {
            means[n > transient*steps + steps] = mean/steps;
        }
        if (n % steps == 0)
        {
            mean.setZero();
        }

        // Counted on through the faces
        mean += moved;
        box.run(h, 1);
        for (int i = 0; i < last.cols(); ++i)
        {
            moved.col(i) += box.nearest(box.p.x.col(i) - last.col(i));
        }
        last = box.p.x;
    }

    // Means of the first and of the last period, periods - 1 apart
    return
        (means[1] - means[0]).row(0).transpose().array()*f/(periods - 1);
}


//- Single particles of the given diameters, at a place
particleArrays singles(const std::vector<double>& diameters, const double x)
{
    std::vector<sphere> spheres;

    for (const double d : diameters)
    {
        const double aside = 1e-5*spheres.size();

        spheres.push_back
        ({
            std::int64_t(spheres.size()), d, density, {x, aside, 0},
            vec::Zero()
        });
    }

    return arrays(spheres);
}


settings alone(const std::string& stepping)
{
    settings law;
    law.stepping = stepping;
    law.contact = "type none;";
    law.representative = true;
    return law;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_P(eachTimeStepping, driftsInABoxAsInTheSound)
{
    const double f = 1400;
    const double omega = 2*pi*f;
    const double U = 1.5;
    const std::vector<double> s{0.1, 1, 10};
    const double eighth = c/f/8;

    std::vector<double> d;
    for (const double one : s)
    {
        d.push_back(diameter(one, omega));
    }

    experiment wave
    (
        singles(d, 0), vec(1e-3, 1.1e-3, 1.2e-3), alone(GetParam()),
        travelling(f, U)
    );
    experiment between
    (
        singles(d, eighth), vec(1e-3, 1.1e-3, 1.2e-3), alone(GetParam()),
        standing(f, U), vec(eighth, 0, 0)
    );

    const Eigen::ArrayXd inWave = drift(wave, f, 100);
    const Eigen::ArrayXd inStanding = drift(between, f, 100);

    for (int i = 0; i < 3; ++i)
    {
        // At an eighth of a wavelength d(U^2 sin^2)/dx is k U^2
        const double ofWave = U*U/(2*c)/(1 + s[i]*s[i]);
        const double ofStanding = -U*U/(4*c)*s[i]/(1 + s[i]*s[i]);

        measured
        (
            "%s, s = %g: drift %.5f mm/s in a travelling wave (theory %.5f),"
            " %.5f in a standing one (%.5f)\n",
            GetParam().c_str(), s[i], 1e3*inWave(i), 1e3*ofWave,
            1e3*inStanding(i), 1e3*ofStanding
        );

        EXPECT_NEAR(inWave(i)/ofWave, 1, 0.01);
        EXPECT_NEAR(inStanding(i)/ofStanding, 1, 0.01);
    }
}


TEST(representativeSound, driftsAsInAResolvedWaveWithAnyDrag)
{
    // 147 dB at 1400 Hz, slips of Re = 2
    const double f = 1400;
    const double U = 1.53;
    const double wavelength = c/f;
    const std::vector<double> d{3e-6, 10e-6, 20e-6};

    for (const char* const which : {"finite Re", "unsteady", "both"})
    {
        settings law = alone(eventDriven);

        if (which != std::string("unsteady"))
        {
            law.drag = "type SchillerNaumann; slipCorrection none;";
        }
        if (which != std::string("finite Re"))
        {
            law.unsteadyDrag = "type Basset; frequencies (140 28000);";
        }

        settings resolved = law;
        resolved.representative = false;

        for (const bool isStanding : {false, true})
        {
            const double x = isStanding ? wavelength/8 : 0;
            const auto make = [&]()
            {
                return isStanding ? standing(f, U) : travelling(f, U);
            };

            experiment box
            (
                singles(d, x), vec::Constant(1e-3), law, make(), vec(x, 0, 0)
            );
            experiment tube
            (
                singles(d, x), vec(wavelength, 1e-3, 1e-3), resolved, make(),
                vec(x, 0, 0)
            );

            const Eigen::ArrayXd inBox = drift(box, f, 100);
            const Eigen::ArrayXd inTube = drift(tube, f, 100);

            for (int i = 0; i < int(d.size()); ++i)
            {
                measured
                (
                    "%s, %s wave, %g um: drift %.5f mm/s in a box, %.5f in the"
                    " wave\n",
                    which, isStanding ? "standing" : "travelling", 1e6*d[i],
                    1e3*inBox(i), 1e3*inTube(i)
                );

                // Terms of the order u0/c of the drifts, 0.4 %, are left out
                EXPECT_NEAR(inBox(i)/inTube(i), 1, 0.0045)
                    << which << ", " << 1e6*d[i] << " um";
            }
        }
    }
}


TEST(representativeSound, leavesAUniformAerosolUniform)
{
    // Half of the box is crossed by each swing; sampled at the particles, all
    // of them end in a plane after 0.5 s at 1400 Hz
    struct situation
    {
        double f;
        double U;
        double length;
        bool isStanding;
        double end;
    };

    for
    (
        const situation& now :
        {
            situation{1400, 1.53, 0.5e-3, false, full() ? 10.0 : 1.0},
            situation{1400, 1.53, 0.5e-3, true, full() ? 10.0 : 1.0},
            situation{100, 0.685, 3e-3, false, 10.0}
        }
    )
    {
        const int n = 1000;
        const double x = now.isStanding ? c/now.f/8 : 0;
        randomNumbers random(3);

        std::vector<sphere> spheres;
        for (int i = 0; i < n; ++i)
        {
            spheres.push_back
            ({
                i, 1e-6, density, random.point(0.5*now.length) + vec(x, 0, 0),
                vec::Zero()
            });
        }

        experiment box
        (
            arrays(spheres), vec::Constant(now.length), alone(eventDriven),
            now.isStanding ? standing(now.f, now.U) : travelling(now.f, now.U),
            vec(x, 0, 0)
        );

        const int steps = 25;
        box.run(1/(now.f*steps), int(std::round(now.end*now.f*steps)));

        // Ten layers of a hundred, along the sound
        double chiSquare = 0;
        Eigen::ArrayXd layers = Eigen::ArrayXd::Zero(10);
        for (int i = 0; i < n; ++i)
        {
            const double at = (box.p.x(0, i) - x)/now.length + 0.5;
            layers(std::min(9, std::max(0, int(10*at)))) += 1;
        }
        chiSquare = ((layers - 0.1*n).square()/(0.1*n)).sum();

        measured
        (
            "%g Hz, %s wave, after %g s: chi-square %.1f (9 degrees of"
            " freedom)\n",
            now.f, now.isStanding ? "standing" : "travelling", now.end,
            chiSquare
        );

        // Exceeded by one of 10000 samples
        EXPECT_LT(chiSquare, 33.7);
    }
}


TEST(representativeSound, givesTheSameContactsAtAnyPlace)
{
    // The same particles at an antinode of a standing wave, halfway to a node
    // of a louder one, and in a travelling wave: with the same phase and u0 at
    // the centre, what differs is drifts of mm/s
    const double f = 1400;
    const double U = 1.53;
    const double k = 2*pi*f/c;
    const double length = 0.32e-3;

    for
    (
        const char* const wake :
        {
            "type none;",
            "type Oseen; range 20;",
            "type ProudmanPearson; range 20;",
            "type memory; tolerance 0.03;"
        }
    )
    {
        // Who met whom, in all runs
        std::vector<std::set<std::array<std::int64_t, 3>>> found;

        for (const int place : {0, 1, 2})
        {
            settings law = alone(eventDriven);
            law.contact = "type recordedStick;";
            law.wake = wake;

            // Where k x is a half or a quarter of pi
            const double x =
                place == 2 ? 0 : place == 1 ? pi/4/k : pi/2/k;

            found.emplace_back();
            for (int seed = 1; seed <= (full() ? 10 : 1); ++seed)
            {
                std::vector<sphere> spheres = aerosolOf
                (
                    400, length, 1e-6, 6e-6, density, f, U, seed
                );
                for (sphere& s : spheres)
                {
                    s.x(0) += x;
                }

                experiment box
                (
                    arrays(spheres), vec::Constant(length), law,
                    place == 2 ? travelling(f, U)
                  : standing(f, place == 1 ? U*std::sqrt(2) : U),
                    vec(x, 0, 0)
                );
                box.run(1/(f*50), 50);

                for (const collisions::record& met : box.records())
                {
                    const auto pair = std::minmax(met.id1, met.id2);
                    found.back().insert({seed, pair.first, pair.second});
                }
            }
        }

        measured
        (
            "%s contacts: %zu at the antinode, %zu between, %zu in a"
            " travelling wave\n",
            wake, found[0].size(), found[1].size(), found[2].size()
        );

        EXPECT_GT(found[0].size(), 5u);
        for (const int place : {1, 2})
        {
            // Drifts of mm/s move particles by micrometres in a period:
            // most pairs are the same
            double common = 0;
            for (const auto& pair : found[0])
            {
                common += found[place].count(pair);
            }

            measured("    %.0f of them the same\n", common);
            EXPECT_GE(common, 0.7*found[0].size());
        }
    }
}


TEST(representativeSound, knowsTheHarmonicsOfASoundThatIsBeingSolved)
{
    // A sound that does not tell its harmonics, with steps that do and that do
    // not fit the period: those of the last period are found
    class unknown
    :
        public acoustics::travellingWave
    {
    public:

        using travellingWave::travellingWave;

        std::optional<vectorPhasors> harmonics
        (
            const label,
            const Eigen::Vector3d&
        ) const override
        {
            return std::nullopt;
        }
    };

    const double f = 1400;
    const boundBox bounds(point(-5e-4, -5e-4, -5e-4), point(5e-4, 5e-4, 5e-4));
    const std::string wave =
        "type travellingWave; frequency 1400; velocityAmplitude 1.5;"
        " velocity (2 1 0);";

    for (const double steps : {100.0, 73.3})
    {
        boxSound known(sound<acoustics::travellingWave>(wave), bounds);
        boxSound solved(sound<unknown>(wave), bounds);

        const double h = 1/(f*steps);
        const acoustics::soundField::phasors response
        (
            acoustics::soundField::phasors::Constant(1, {0.4, -0.5})
        );
        vectors exact, u;
        double swing = 0;
        double worst = 0;

        for (int n = 0; n < 3*steps; ++n)
        {
            known.follow(n*h, h);
            solved.follow(n*h, h);

            known.velocityAt((n + 1)*h, vectors::Zero(3, 1), response, exact);
            solved.velocityAt((n + 1)*h, vectors::Zero(3, 1), response, u);

            // What the swing adds is u0^2/c, 6.6 mm/s
            if ((n + 1)*h*f > 1.001)
            {
                worst = std::max(worst, (u - exact).norm());
            }
            else if ((n + 1)*h*f < 0.98)
            {
                // No swing yet
                vectors still;
                solved.velocity((n + 1)*h, vectors::Zero(3, 1), still);
                EXPECT_EQ(u, still);
                swing = std::max(swing, (exact - still).norm());
            }
        }

        measured
        (
            "%g steps per period: the swing is off by %.2e of what it adds\n",
            steps, worst/6.6e-3
        );
        EXPECT_LT(worst, (steps == 100 ? 1e-6 : 2e-3)*6.6e-3);
        EXPECT_GT(swing, 0.5*6.6e-3*0.6);
    }
}


// ************************************************************************* //
