/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Small functions that are used in more than one place.

\*---------------------------------------------------------------------------*/

#include "meanDecay.H"
#include "sineSeries.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(meanDecay, isTheMeanOfADecay)
{
    EXPECT_EQ(meanDecay(0), 1);
    EXPECT_NEAR(meanDecay(1e-13), 1, 1e-12);
    EXPECT_NEAR(meanDecay(1e-6), 1 - 0.5e-6, 1e-12);
    EXPECT_NEAR(meanDecay(2), (1 - std::exp(-2.0))/2, 1e-16);
    EXPECT_NEAR(meanDecay(1e9), 1e-9, 1e-24);
}


TEST(sineSeries, isExactToRoundingUpToARightAngle)
{
    for (double y = 1e-3; y < 1.5708; y += 1e-3)
    {
        EXPECT_NEAR(y*sineSeries(y*y), std::sin(y), 2.3e-16) << y;
    }
}


// ************************************************************************* //
