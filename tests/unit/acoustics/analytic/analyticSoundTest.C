/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// The sounds that are formulas: they obey the equations of sound, and refuse
// what is none.

#include "linearShear.H"
#include "localSound.H"
#include "quiescent.H"
#include "standingWave.H"
#include "travellingWave.H"

#include "boundBox.H"
#include "dictionary.H"
#include "error.H"
#include "IStringStream.H"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::acoustics;

namespace
{

constexpr double pi = 3.14159265358979323846;

dictionary parse(const std::string& text)
{
    IStringStream is(text);

    return dictionary(is);
}

//- Velocity at one point
Eigen::Vector3d at
(
    const soundField& sound,
    const double t,
    const Eigen::Vector3d& x
)
{
    soundField::vectors u;
    sound.velocity(t, x, u);

    EXPECT_EQ(u.cols(), 1);
    return u.col(0);
}

const char* const wave =
    "frequency 1400; SPL 147; direction (0 2 0); origin (0 0.01 0);";

} // End anonymous namespace


TEST(standingWave, hasItsNodesWhereTheyBelong)
{
    const standingWave sound(parse(wave));

    const double c = sound.gas().c;
    const double lambda = c/1400;
    const double quarterPeriod = 0.25/1400;
    const double u0 = 632.46/(1.204*343.2);

    EXPECT_NEAR(sound.velocityAmplitude(), u0, 2e-3);

    // At rest at the pressure antinode, at all times
    for (const double t : {0.0, 1e-4, 3.7e-4})
    {
        EXPECT_NEAR(at(sound, t, {0.3, 0.01, -2}).norm(), 0, 1e-12);
        EXPECT_NEAR(at(sound, t, {0, 0.01 + lambda/2, 0}).norm(), 0, 1e-12);
    }

    // Fastest a quarter of a wavelength and of a period later, along y
    const Eigen::Vector3d fastest =
        at(sound, quarterPeriod, {0, 0.01 + lambda/4, 0});

    EXPECT_NEAR(fastest[1], sound.velocityAmplitude(), 1e-10);
    EXPECT_EQ(fastest[0], 0);
    EXPECT_EQ(fastest[2], 0);
}


TEST(standingWave, isAcceleratedByItsPressure)
{
    // rho du/dt = -dp/ds with p = p_amp cos(k s) cos(omega t + phase)
    const standingWave sound
    (
        parse("frequency 1400; velocityAmplitude 1.5; phase 0.4;")
    );

    const gasProperties& gas = sound.gas();
    const double omega = 2*pi*1400;
    const double k = omega/gas.c;
    const double x = 0.037;
    const double t = 2.3e-4;
    const double dt = 1e-8;

    const double acceleration =
        (
            at(sound, t + dt, {x, 0, 0})[0] - at(sound, t - dt, {x, 0, 0})[0]
        )/(2*dt);

    const double pressureGradient =
       -gas.rho*gas.c*1.5*k*std::sin(k*x)*std::cos(omega*t + 0.4);

    EXPECT_NEAR(acceleration*gas.rho/-pressureGradient, 1, 1e-6);
}


TEST(travellingWave, movesWithTheSpeedOfSound)
{
    const travellingWave sound
    (
        parse("frequency 700; velocityAmplitude 0.3; direction (1 1 0);")
    );

    const Eigen::Vector3d along = Eigen::Vector3d(1, 1, 0).normalized();
    const double t = 1.1e-3;
    const double later = 0.4e-3;

    const Eigen::Vector3d here = at(sound, t, {0.02, -0.05, 1});
    const Eigen::Vector3d there = at
    (
        sound,
        t + later,
        Eigen::Vector3d(0.02, -0.05, 1) + sound.gas().c*later*along
    );

    EXPECT_NEAR((here - there).norm(), 0, 1e-12);
    EXPECT_NEAR(here.cross(along).norm(), 0, 1e-15);
    EXPECT_NEAR
    (
        at(sound, 0.25/700, {0, 0, 0}).dot(along),
        0.3,
        1e-12
    );
}


TEST(analyticSound, treatsEachPointAlike)
{
    const standingWave sound(parse(wave));
    const soundField::vectors x = soundField::vectors::Random(3, 101);

    soundField::vectors u;
    sound.velocity(1.3e-4, x, u);

    for (int i = 0; i < x.cols(); ++i)
    {
        EXPECT_NEAR((u.col(i) - at(sound, 1.3e-4, x.col(i))).norm(), 0, 1e-13);
    }

    // No points are no error
    sound.velocity(0, soundField::vectors(3, 0), u);
    EXPECT_EQ(u.cols(), 0);
}


TEST(linearShear, shears)
{
    linearShear sound
    (
        parse
        (
            "shearRate 1000; flowDirection (0 0 1); velocity (0 1 0);"
            "origin (0 0.5 0);"
        )
    );

    EXPECT_EQ(sound.frequency(), 0);
    EXPECT_NEAR
    (
        (at(sound, 7, {3, 0.502, 9}) - Eigen::Vector3d(0, 1, 2)).norm(),
        0,
        1e-10
    );

    // Its largest speed is that in the region, less the uniform velocity
    sound.prepare(boundBox(point(-1, 0.499, -1), point(1, 0.503, 1)));
    EXPECT_NEAR(sound.velocityAmplitude(), 3, 1e-9);
}


TEST(quiescent, isAtRestOrMovesUniformly)
{
    EXPECT_EQ(at(quiescent(parse("")), 3, {1, 2, 3}).norm(), 0);
    EXPECT_EQ
    (
        at(quiescent(parse("velocity (1 -2 3);")), 0, {0, 0, 0}),
        Eigen::Vector3d(1, -2, 3)
    );
}


TEST(localSound, seesTheMeanFlowFromItsFrame)
{
    const Eigen::Vector3d frame(0.2, 0, -1);

    quiescent wind(parse("velocity (1 -2 3);"));
    localSound inWind(wind);
    inWind.represent(boundBox(point(0, 0, 0), point(2, 2, 2)));
    inWind.move(frame, frame, 0);

    ASSERT_TRUE(inWind.meanFlow());
    EXPECT_EQ(*inWind.meanFlow(), at(inWind, 5, {1, 2, 3}));

    // Who does not know it, does not know it from there either
    linearShear shear(parse("shearRate 1;"));
    localSound inShear(shear);
    inShear.move(frame, frame, 0);

    EXPECT_FALSE(inShear.meanFlow());
}


TEST(analyticSound, takesTheGasItIsGiven)
{
    const standingWave sound
    (
        parse("frequency 1400; SPL 147; gas { rho 0.6; c 500; }")
    );

    EXPECT_EQ(sound.gas().c, 500);
    EXPECT_NEAR(sound.velocityAmplitude(), 633.2/300, 1e-3);
}


TEST(analyticSound, refusesWhatIsNoSound)
{
    const auto refused = [](const char* text)
    {
        EXPECT_THROW(standingWave{parse(text)}, error) << text;
    };

    refused("SPL 147;");
    refused("frequency 0; SPL 147;");
    refused("frequency -1400; SPL 147;");
    refused("frequency [0 0 1 0 0 0 0] 1400; SPL 147;");
    refused("frequency 1400; SPL 147; direction (0 0 0);");
    refused("frequency 1400; SPL 147; origin [0 0 1 0 0 0 0] (0 0 0);");
    refused("frequency 1400; SPL 147; gas { c 0; }");

    EXPECT_NO_THROW
    (
        standingWave
        {
            parse("frequency [0 0 -1 0 0 0 0] 1400; SPL [0 0 0 0 0 0 0] 147;")
        }
    );

    EXPECT_THROW
    (
        linearShear{parse("shearRate 1; gradientDirection (1 1 0);")},
        error
    );
}


// ************************************************************************* //
