/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nearestMultiple.H"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>
#include <random>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(nearestMultiple, roundsToMultiplesOfAPowerOfTwo)
{
    std::mt19937_64 engine(1);

    // Below 2^(51 - 44), as 2^-44 asks for
    std::uniform_real_distribution<double> uniform(-127, 127);

    Eigen::Array<double, 64, 1> many;

    for (int i = 0; i < 64; ++i)
    {
        many(i) = uniform(engine);
    }

    const Eigen::Array<double, 64, 1> rounded = nearestMultiple<-44>(many);

    for (int i = 0; i < 64; ++i)
    {
        const double x = many(i);

        EXPECT_EQ(nearestMultiple<0>(x), std::nearbyint(x));
        EXPECT_EQ(nearestMultiple<3>(x), 8*std::nearbyint(x/8));
        EXPECT_EQ(nearestMultiple<-20>(x), std::nearbyint(x*0x1p20)*0x1p-20);
        EXPECT_EQ(rounded(i), std::nearbyint(x*0x1p44)*0x1p-44);
    }
}


// ************************************************************************* //
