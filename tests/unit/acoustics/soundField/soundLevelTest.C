/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// A level becomes a pressure and a velocity: with the square root of two that
// is so easily lost.

#include "gasProperties.H"
#include "soundLevel.H"

#include "dictionary.H"
#include "error.H"
#include "IStringStream.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::acoustics;

namespace
{

soundLevel readFrom(const char* text)
{
    IStringStream is(text);

    return soundLevel::read(dictionary(is), gasProperties::air());
}

} // End anonymous namespace


TEST(soundLevel, isRmsAtThePressureAntinode)
{
    // 94 dB is 1 Pa rms, near enough: 20 uPa*10^4.7
    const soundLevel level =
        soundLevel::fromSPL(94, gasProperties::air());

    EXPECT_NEAR(level.pRms(), 1.00237, 1e-5);
    EXPECT_NEAR(level.pAmplitude()/level.pRms(), std::sqrt(2.0), 1e-14);
}


TEST(soundLevel, knowsTheLevelsOfTheExperiments)
{
    const gasProperties air = gasProperties::air();

    EXPECT_NEAR(soundLevel::fromSPL(140, air).uAmplitude(), 0.685, 0.001);
    EXPECT_NEAR(soundLevel::fromSPL(147, air).pAmplitude(), 633.2, 0.1);
    EXPECT_NEAR(soundLevel::fromSPL(147, air).uAmplitude(), 1.532, 0.001);
}


TEST(soundLevel, comesBackFromItsVelocity)
{
    const gasProperties air = gasProperties::air();
    const scalar u0 = soundLevel::fromSPL(123.4, air).uAmplitude();

    EXPECT_NEAR(soundLevel::fromVelocity(u0, air).SPL(), 123.4, 1e-12);
}


TEST(soundLevel, isReadFromExactlyOneEntry)
{
    EXPECT_NEAR(readFrom("SPL 147;").SPL(), 147, 1e-12);
    EXPECT_EQ(readFrom("velocityAmplitude 0.44;").uAmplitude(), 0.44);
    EXPECT_EQ
    (
        readFrom("velocityAmplitude [0 1 -1 0 0 0 0] 0.44;").uAmplitude(),
        0.44
    );

    EXPECT_THROW(readFrom(""), error);
    EXPECT_THROW(readFrom("SPL 147; velocityAmplitude 1.5;"), error);
    EXPECT_THROW(readFrom("velocityAmplitude -1;"), error);
    EXPECT_THROW(readFrom("velocityAmplitude [0 1 0 0 0 0 0] 1;"), error);
}


// ************************************************************************* //
