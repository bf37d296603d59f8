/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Mean and harmonics of a known signal, whatever the steps are

#include "harmonicSum.H"

#include "error.H"
#include "scalarField.H"
#include "vectorField.H"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <utility>

using namespace Foam;
using namespace Foam::acoustics;

namespace
{

constexpr double twoPi = 6.28318530717958647692;
constexpr double frequency = 1400;

//- A mean and three harmonics
struct tones
{
    double mean = 101325;
    double cosine[3] = {3, -0.4, 0.05};
    double sine[3] = {-5, 0.2, 0.1};

    double operator()(const double t) const
    {
        double y = mean;
        for (int k = 0; k < 3; ++k)
        {
            const double angle = twoPi*frequency*(k + 1)*t;
            y += cosine[k]*std::cos(angle) + sine[k]*std::sin(angle);
        }
        return y;
    }
};


//- Largest error of the mean and of the first n harmonics over many periods, as
//  a fraction of the fundamental
template<class Step>
double worst
(
    const double start,
    const int nPeriods,
    const int n,
    const tones& y,
    Step&& step
)
{
    harmonicSum<scalar> sum(frequency, 3);

    const double amplitude = std::hypot(y.cosine[0], y.sine[0]);
    double error = 0;
    int periods = 0;
    double t = start;
    double expectedEnd = std::ceil(start*frequency - 1e-9)/frequency;

    sum.add(t, scalarField(1, y(t)));

    while (periods < nPeriods)
    {
        t += step();

        if (sum.add(t, scalarField(1, y(t))))
        {
            ++periods;
            expectedEnd += 1/frequency;
            EXPECT_NEAR(sum.end(), expectedEnd, 1e-9/frequency);
            EXPECT_GE(t, sum.end() - 1e-7/frequency);

            error = std::max(error, std::abs(sum.mean()[0] - y.mean));
            for (int k = 1; k <= n; ++k)
            {
                error = std::max
                ({
                    error,
                    std::abs(sum.cosine(k)[0] - y.cosine[k - 1]),
                    std::abs(sum.sine(k)[0] - y.sine[k - 1])
                });
            }
        }
    }

    EXPECT_EQ(sum.nPeriods(), nPeriods);

    return error/amplitude;
}


//- A sine alone
tones pure()
{
    tones y;
    y.mean = 0;
    y.cosine[0] = 0.6;
    y.sine[0] = 0.8;
    for (const int k : {1, 2})
    {
        y.cosine[k] = y.sine[k] = 0;
    }
    return y;
}

} // End anonymous namespace


TEST(harmonicSum, isExactIfTheStepsFitThePeriod)
{
    for (const int n : {20, 50, 200})
    {
        // The first period has a slope yet to find
        harmonicSum<scalar> sum(frequency, 3);
        const tones y;

        for (int i = 0; i <= 3*n; ++i)
        {
            const double t = (4*n + i)/(n*frequency);
            sum.add(t, scalarField(1, y(t)));
        }

        EXPECT_EQ(sum.nPeriods(), 3);
        EXPECT_NEAR(sum.mean()[0], y.mean, 1e-9);
        for (int k = 1; k <= 3; ++k)
        {
            EXPECT_NEAR(sum.cosine(k)[0], y.cosine[k - 1], 1e-9) << n;
            EXPECT_NEAR(sum.sine(k)[0], y.sine[k - 1], 1e-9) << n;
        }
    }
}


TEST(harmonicSum, findsAPureSineAtFiftyStepsPerPeriod)
{
    double most = 0;

    // Also where the first period has no more than a line to begin with
    for (const double steps : {50.0, 49.99, 50.3, 50.5, 50.77, 51.4142})
    {
        for (const double start : {0.0, 0.3, 7.77})
        {
            const double error = worst
            (
                start/frequency, 30, 1, pure(),
                [=]() { return 1/(steps*frequency); }
            );
            EXPECT_LT(error, 5e-4) << steps << " steps from " << start;
            most = std::max(most, error);
        }
    }

    std::printf
    (
        "pure sine at 50 steps per period: %.4f %% of the amplitude off\n",
        100*most
    );
}


TEST(harmonicSum, findsHarmonicsAtUnevenSteps)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> between(0.7, 1.3);
    double errors[2];

    // What is left of a large mean would drown the harmonics
    tones y;
    y.mean = 2;

    for (const int fine : {0, 1})
    {
        const double steps = 100*(1 + fine);
        errors[fine] = worst
        (
            0.1/frequency, 30, 3, y,
            [&]() { return between(random)/(steps*frequency); }
        );
    }

    std::printf
    (
        "three harmonics at uneven steps: %.2e and %.2e at 100 and 200 steps\n",
        errors[0], errors[1]
    );

    EXPECT_LT(errors[0], 5e-4);

    // Of third order or better
    EXPECT_LT(errors[1], errors[0]/7);
}


TEST(harmonicSum, isOfFourthOrderForStepsThatDoNotFit)
{
    const auto error = [](const double steps)
    {
        harmonicSum<scalar> sum(frequency, 3);
        const tones y;
        double most = 0;
        for (int i = 0; sum.nPeriods() < 20; ++i)
        {
            const double t = i/(steps*frequency);
            if (sum.add(t, scalarField(1, y(t))) && sum.nPeriods() > 1)
            {
                most = std::max(most, std::abs(sum.sine(1)[0] - y.sine[0]));
            }
        }
        return most;
    };

    EXPECT_LT(error(101.3), error(50.65)/12);
}


TEST(harmonicSum, takesFieldsOfVectors)
{
    harmonicSum<vector> sum(frequency, 1);

    for (int i = 0; i <= 100; ++i)
    {
        const double t = i/(50*frequency);
        const double c = std::cos(twoPi*frequency*t);
        const double s = std::sin(twoPi*frequency*t);
        vectorField y(2);
        y[0] = vector(c, s, 1);
        y[1] = vector(2*s, 0, -c);
        sum.add(t, y);
    }

    EXPECT_LT(mag(sum.mean()[0] - vector(0, 0, 1)), 1e-12);
    EXPECT_LT(mag(sum.cosine(1)[0] - vector(1, 0, 0)), 1e-12);
    EXPECT_LT(mag(sum.sine(1)[0] - vector(0, 1, 0)), 1e-12);
    EXPECT_LT(mag(sum.cosine(1)[1] - vector(0, 0, -1)), 1e-12);
    EXPECT_LT(mag(sum.sine(1)[1] - vector(2, 0, 0)), 1e-12);
}


TEST(harmonicSum, leavesOutAPeriodThatBeganBeforeTheFirstValue)
{
    harmonicSum<scalar> sum(frequency, 1);

    int steps = 0;
    for (double t = 0.4; t < 1.9999; t += 0.02)
    {
        EXPECT_FALSE(sum.add(t/frequency, scalarField(1, 1.0))) << t;
        ++steps;
    }
    EXPECT_TRUE(sum.add(2.001/frequency, scalarField(1, 1.0)));
    EXPECT_NEAR(sum.mean()[0], 1, 1e-12);
}


TEST(harmonicSum, beginsAnewAfterAGap)
{
    const tones y = pure();
    harmonicSum<scalar> sum(frequency, 1);

    const auto feed = [&](const double from, const double to)
    {
        for (int i = std::lround(50*from); i <= std::lround(50*to); ++i)
        {
            const double t = i/(50*frequency);
            sum.add(t, scalarField(1, y(t)));
        }
    };

    feed(0, 1.5);
    EXPECT_EQ(sum.nPeriods(), 1);

    // The period of the gap and the one in which it ends are left out
    feed(7.5, 8.9);
    EXPECT_EQ(sum.nPeriods(), 1);
    feed(8.92, 9);
    EXPECT_EQ(sum.nPeriods(), 2);
    EXPECT_NEAR(sum.end(), 9/frequency, 1e-9/frequency);
    EXPECT_NEAR(sum.sine(1)[0], y.sine[0], 1e-4);

    // Always as far apart: no gaps, but steps that are too long
    EXPECT_FALSE(sum.add(10/frequency, scalarField(1, 0.0)));
    EXPECT_THROW(sum.add(11/frequency, scalarField(1, 0.0)), Foam::error);
}


TEST(harmonicSum, refusesStepsThatAreTooLong)
{
    harmonicSum<scalar> sum(frequency, 3);
    sum.add(0, scalarField(1, 0.0));
    EXPECT_THROW(sum.add(0.2/frequency, scalarField(1, 0.0)), Foam::error);
}


// ************************************************************************* //
