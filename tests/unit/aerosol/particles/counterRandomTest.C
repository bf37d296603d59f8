/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// The random numbers are those of the published generator, are uniform or
// normal, and know nothing of their neighbours.

#include "counterRandom.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

using Foam::aerosol::counterRandom;
using stream = counterRandom::stream;

namespace
{

constexpr int N = 400000;

//- Sample correlation times sqrt(N): standard normal for independent numbers
double correlation
(
    const std::function<double(int)>& a,
    const std::function<double(int)>& b
)
{
    double sumA = 0, sumB = 0, sumAA = 0, sumBB = 0, sumAB = 0;

    for (int i = 0; i < N; ++i)
    {
        const double x = a(i), y = b(i);

        sumA += x;
        sumB += y;
        sumAA += x*x;
        sumBB += y*y;
        sumAB += x*y;
    }

    return
        (sumAB - sumA*sumB/N)
       /std::sqrt((sumAA - sumA*sumA/N)*(sumBB - sumB*sumB/N))
       *std::sqrt(double(N));
}


//- Kolmogorov's distance from a distribution, times sqrt(N)
double KolmogorovDistance
(
    std::vector<double> sample,
    const std::function<double(double)>& fractionBelow
)
{
    std::sort(sample.begin(), sample.end());

    const double n = sample.size();
    double distance = 0;

    for (std::size_t i = 0; i < sample.size(); ++i)
    {
        const double F = fractionBelow(sample[i]);

        distance = std::max({distance, F - i/n, (i + 1)/n - F});
    }

    return distance*std::sqrt(n);
}


//- Exceeded once in a million samples
constexpr double KolmogorovLimit = 2.69;
constexpr double normalLimit = 4.89;

} // End anonymous namespace


// From tests/kat_vectors of Random123 1.14.0, the lines "philox4x64 10"
TEST(counterRandom, generatorIsTheOneItClaimsToBe)
{
    using words = r123::Philox4x64::ctr_type;

    const words fromZero = r123::Philox4x64()({{0, 0, 0, 0}}, {{0, 0}});

    EXPECT_EQ
    (
        fromZero,
        (words
        {{
            0x16554d9eca36314c, 0xdb20fe9d672d0fdc,
            0xd7e772cee186176b, 0x7e68b68aec7ba23b
        }})
    );

    const words fromPi = r123::Philox4x64()
    (
        {{
            0x243f6a8885a308d3, 0x13198a2e03707344,
            0xa4093822299f31d0, 0x082efa98ec4e6c89
        }},
        {{0x452821e638d01377, 0xbe5466cf34e90c6c}}
    );

    EXPECT_EQ
    (
        fromPi,
        (words
        {{
            0xa528f45403e61d95, 0x38c72dbd566e9788,
            0xa5a1610e72fd18b5, 0x57bd43b5e52b7fe6
        }})
    );
}


// What a seed gives must not change from version to version. The numbers are
// from an independent implementation of the generator.
TEST(counterRandom, countersAreFilledAsEver)
{
    const auto bits = counterRandom(1).bits(2, 3, stream::Brownian, 4);

    EXPECT_EQ(bits[0], 0x9c298d29a8b778afu);
    EXPECT_EQ(bits[1], 0x45ea2952d2ef6399u);
    EXPECT_EQ(bits[2], 0x97261f10b70f3b9cu);
    EXPECT_EQ(bits[3], 0xc2be1ac244907e82u);
}


TEST(counterRandom, endsOfTheIntervalAreExcluded)
{
    EXPECT_GT(counterRandom::openUniform(0), 0);
    EXPECT_LT(counterRandom::openUniform(~std::uint64_t(0)), 1);
    EXPECT_EQ
    (
        counterRandom::openUniform(0)
      + counterRandom::openUniform(~std::uint64_t(0)),
        1
    );
}


TEST(counterRandom, uniformNumbersAreUniform)
{
    const counterRandom random(1);

    for (int k = 0; k < 4; ++k)
    {
        std::vector<double> sample(N);

        for (int i = 0; i < N; ++i)
        {
            sample[i] = random.uniforms(i, 7, stream::position)[k];
        }

        EXPECT_LT
        (
            KolmogorovDistance(sample, [](double u) { return u; }),
            KolmogorovLimit
        );
    }
}


TEST(counterRandom, normalNumbersAreNormal)
{
    const counterRandom random(1);

    for (int k = 0; k < 4; ++k)
    {
        std::vector<double> sample(N);

        for (int i = 0; i < N; ++i)
        {
            sample[i] = random.normals(i, 7, stream::Brownian)[k];
        }

        EXPECT_LT
        (
            KolmogorovDistance
            (
                sample,
                [](double z) { return 0.5*std::erfc(-z/std::sqrt(2.0)); }
            ),
            KolmogorovLimit
        );

        // The variance is what Brownian motion lives on
        double sum = 0;

        for (const double z : sample)
        {
            sum += z*z;
        }

        EXPECT_NEAR(sum/N, 1, normalLimit*std::sqrt(2.0/N));
    }
}


TEST(counterRandom, numbersOfOneBlockAreIndependent)
{
    const counterRandom random(1);

    for (int j = 0; j < 4; ++j)
    {
        for (int k = 0; k < j; ++k)
        {
            const auto number = [&](const int which)
            {
                return [&random, which](const int i)
                {
                    return random.normals(i, 7, stream::Brownian)[which];
                };
            };

            EXPECT_LT(std::abs(correlation(number(j), number(k))), normalLimit);

            const auto square = [&](const int which)
            {
                return [&random, which](const int i)
                {
                    const auto z = random.normals(i, 7, stream::Brownian);
                    return z[which]*z[which];
                };
            };

            EXPECT_LT(std::abs(correlation(square(j), square(k))), normalLimit);
        }
    }
}


TEST(counterRandom, neighboursAreIndependent)
{
    const auto number = [](int seed, int id, int step, stream s, int block)
    {
        return counterRandom(seed).uniforms(id, step, s, block)[0];
    };

    const auto byId = [&](int i)
    {
        return number(1, i, 7, stream::size, 0);
    };
    const auto byStep = [&](int i)
    {
        return number(1, 7, i, stream::size, 0);
    };

    const std::vector<std::function<double(int)>> neighboursOfId
    {
        [&](int i) { return number(1, i + 1, 7, stream::size, 0); },
        [&](int i) { return number(1, i, 8, stream::size, 0); },
        [&](int i) { return number(2, i, 7, stream::size, 0); },
        [&](int i) { return number(1, i, 7, stream::Brownian, 0); },
        [&](int i) { return number(1, i, 7, stream::size, 1); },
        byStep
    };

    for (const auto& neighbour : neighboursOfId)
    {
        EXPECT_LT(std::abs(correlation(byId, neighbour)), normalLimit);
    }

    EXPECT_LT
    (
        std::abs
        (
            correlation
            (
                byStep,
                [&](int i) { return number(1, 7, i + 1, stream::size, 0); }
            )
        ),
        normalLimit
    );
}


TEST(counterRandom, idsBeyondFourBytesAreKept)
{
    const counterRandom random(1);
    const std::int64_t far = std::int64_t(1) << 32;

    EXPECT_NE
    (
        random.bits(far, 0, stream::size)[0],
        random.bits(0, 0, stream::size)[0]
    );
    EXPECT_NE
    (
        random.bits(0, far, stream::size)[0],
        random.bits(0, 0, stream::size)[0]
    );
}
