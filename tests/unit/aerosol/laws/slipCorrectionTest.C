/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "slipCorrection.H"
#include "error.H"
#include "IStringStream.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::aerosol;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

autoPtr<slipCorrection> make(const std::string& type)
{
    return slipCorrection::New
    (
        dictionary(IStringStream("slipCorrection " + type + ";")())
    );
}


double CunninghamOf(const double d, const gasProperties& gas)
{
    return make("Cunningham")->factor(scalars::Constant(1, d), gas)(0);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(slipCorrection, isThePublishedValueAtOneMicron)
{
    EXPECT_NEAR(CunninghamOf(1e-6, gasProperties::air()), 1.166, 5e-4);
}


TEST(slipCorrection, followsDaviesFormula)
{
    gasProperties gas = gasProperties::air();

    for (const double lambda : {30e-9, 66e-9, 500e-9})
    {
        gas.meanFreePath = lambda;

        for (double d = 1e-9; d < 1e-3; d *= 1.7)
        {
            const double expected =
                1 + 2.514*lambda/d + 0.8*lambda/d*std::exp(-0.55*d/lambda);

            EXPECT_NEAR(CunninghamOf(d, gas)/expected, 1, 1e-14) << d;
        }
    }
}


TEST(slipCorrection, treatsEachParticleByItsOwnSize)
{
    const gasProperties gas = gasProperties::air();

    scalars d(5);
    d << 1e-5, 1e-8, 1e-6, 1e-4, 1e-7;

    const scalars Cc = make("Cunningham")->factor(d, gas);

    ASSERT_EQ(Cc.size(), d.size());

    for (int i = 0; i < d.size(); ++i)
    {
        EXPECT_DOUBLE_EQ(Cc(i), CunninghamOf(d(i), gas));
    }
}


TEST(slipCorrection, noneIsOne)
{
    const scalars d = scalars::LinSpaced(9, 1e-9, 1e-4);
    const scalars Cc = make("none")->factor(d, gasProperties::air());

    ASSERT_EQ(Cc.size(), d.size());
    EXPECT_TRUE((Cc == 1).all());
}


TEST(slipCorrection, rejectsUnknownNames)
{
    EXPECT_THROW(make("Cuningham"), IOerror);
}


// ************************************************************************* //
