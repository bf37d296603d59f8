/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Integrals over periods of a known function, sampled at steps of any length.

\*---------------------------------------------------------------------------*/

#include "periodQuadrature.H"

#include "error.H"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace Foam;
using namespace Foam::acoustics;

namespace
{

constexpr double f = 1400;
constexpr double omega = 2*3.14159265358979323846*f;

//- Mean 0.3, first harmonic 2 cos - sin, second 0.5 sin
double y(const double t)
{
    return
        0.3 + 2*std::cos(omega*t) - std::sin(omega*t)
      + 0.5*std::sin(2*omega*t);
}

double slope(const double t)
{
    return
        omega
       *(
          - 2*std::sin(omega*t) - std::cos(omega*t) + std::cos(2*omega*t)
        );
}

const std::vector<double> exact{0.3, 2, -1, 0, 0.5};

//- The largest error of the five integrals over the second period, from
//  samples at these times
double largestError(const std::vector<double>& times)
{
    const periodQuadrature quadrature(f, 2);
    std::vector<double> sums(quadrature.size(), 0);
    int period = 0;
    double worst = GREAT;

    for (std::size_t n = 0; n + 1 < times.size(); ++n)
    {
        const double t0 = times[n];
        const double t1 = times[n + 1];
        const double known[] = {y(t0), slope(t0), y(t1), slope(t1)};

        for (const auto& part : quadrature.parts(t0, t1))
        {
            for (std::size_t s = 0; s < sums.size(); ++s)
            {
                for (int c = 0; c < 4; ++c)
                {
                    sums[s] += part.sums[s][c]*known[c];
                }
            }

            if (part.endsPeriod)
            {
                ++period;
                EXPECT_NEAR(part.end, period/f, 1e-15);

                if (period == 2)
                {
                    worst = 0;
                    for (std::size_t s = 0; s < sums.size(); ++s)
                    {
                        worst = std::max(worst, std::abs(sums[s] - exact[s]));
                    }
                }

                sums.assign(sums.size(), 0);
            }
        }
    }

    return worst;
}

std::vector<double> alike(const int perPeriod)
{
    std::vector<double> times;
    for (int n = 0; n <= 2*perPeriod; ++n)
    {
        times.push_back(n/(perPeriod*f));
    }

    return times;
}

//- Of lengths that differ by up to a factor of three, with periods that end
//  within steps
std::vector<double> unlike(const int perPeriod)
{
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> length(0.5, 1.5);

    std::vector<double> times{0};
    while (times.back() < 2.1/f)
    {
        times.push_back(times.back() + length(generator)/(perPeriod*f));
    }

    return times;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(periodQuadrature, isExactForLikeSteps)
{
    // Harmonics up to n/2 - 1, and sums of two of them
    EXPECT_LT(largestError(alike(20)), 1e-12);
}


TEST(periodQuadrature, isOfFourthOrderForUnlikeSteps)
{
    const double coarse = largestError(unlike(40));
    const double fine = largestError(unlike(160));

    EXPECT_LT(coarse, 1e-4);
    EXPECT_GT(coarse, 1e-8);
    EXPECT_LT(fine, coarse/100);
}


TEST(periodQuadrature, knowsWherePeriodsEnd)
{
    const periodQuadrature quadrature(f, 1);
    const double h = 1/(50*f);

    EXPECT_EQ(quadrature.number(0, h), 0);
    EXPECT_EQ(quadrature.number(0.999/f, h), 0);
    EXPECT_EQ(quadrature.number((1 - 1e-9)/f, h), 1);
    EXPECT_TRUE(quadrature.isBoundary((3 + 1e-9)/f, h));
    EXPECT_FALSE(quadrature.isBoundary(3.01/f, h));
}


TEST(periodQuadrature, refusesStepsThatCannotTellHarmonicsApart)
{
    const periodQuadrature quadrature(f, 2);

    EXPECT_NO_THROW(quadrature.parts(0, 0.19/f));
    EXPECT_THROW(quadrature.parts(0, 0.2/f), Foam::error);
    EXPECT_THROW(quadrature.parts(1, 1), Foam::error);
}


// ************************************************************************* //
