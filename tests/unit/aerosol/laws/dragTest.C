/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "drag.H"
#include "equationOfMotion.H"
#include "gravity.H"
#include "error.H"
#include "IStringStream.H"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

using namespace Foam;
using namespace Foam::aerosol;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pi = EIGEN_PI;

dictionary parse(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


autoPtr<drag> make(const std::string& type, const std::string& slip = "none")
{
    return drag::New(parse("type " + type + "; slipCorrection " + slip + ";"));
}


particleArrays spheres(const std::vector<double>& d, const double density)
{
    particleArrays p;
    p.resize(static_cast<int>(d.size()));

    for (int i = 0; i < p.size(); ++i)
    {
        p.id(i) = i;
        p.d(i) = d[i];
        p.m(i) = density*pi/6*std::pow(d[i], 3);
        p.primaries(i) = 1;
    }

    p.x.setZero();
    p.v.setZero();
    p.mobilityDiameter = p.d;

    return p;
}


double Cunningham(const double d, const gasProperties& gas)
{
    const double Kn = 2*gas.meanFreePath/d;
    return 1 + Kn*(1.257 + 0.4*std::exp(-1.1/Kn));
}


//- Speed at which the drag carries the weight less the buoyancy, by bisection
//  of the balance of forces
template<class Phi>
double terminalSpeed
(
    const double d,
    const double density,
    const gasProperties& gas,
    const Phi& phi
)
{
    const double weight = (density - gas.rho)*pi/6*d*d*d*9.81;

    double low = 0;
    double high = 100;

    for (int n = 0; n < 100; ++n)
    {
        const double speed = 0.5*(low + high);
        const double force =
            3*pi*gas.mu*d*speed*phi(gas.rho*speed*d/gas.mu);

        (force < weight ? low : high) = speed;
    }

    return 0.5*(low + high);
}


//- Speed of the code after many relaxation times of falling in gas at rest
double settledSpeed
(
    const std::string& law,
    const double d,
    const double density,
    const gasProperties& gas,
    const int steps = 4000
)
{
    equationOfMotion motion
    (
        parse
        (
            "drag {" + law + "}"
            "gravity { type uniform; value (0 0 -9.81); } wake { type none; }"
            "aggregate { type none; }"
        ),
        gas,
        Eigen::Array3d::Ones()
    );

    particleArrays p = spheres({d}, density);
    motion.laws().refresh(p);

    const double h = 0.02*motion.laws().relaxationTime(p)(0);
    const vectors still = vectors::Zero(3, 1);
    stepEnd end;

    for (int s = 0; s < steps; ++s)
    {
        motion.inWakes().moveTogether(h, p, {}, {still, {}, still}, {}, 1, end);
        p.x = end.x;
        p.v = end.v;
    }

    EXPECT_EQ(p.v(0, 0), 0);
    EXPECT_EQ(p.v(1, 0), 0);
    EXPECT_LT(p.x(2, 0), 0);

    return -p.v(2, 0);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(drag, hasStokesRate)
{
    const gasProperties gas = gasProperties::air();
    const std::vector<double> d{0.3e-6, 1e-6, 2.5e-6, 8e-6, 40e-6};

    for (const double density : {1000.0, 2300.0})
    {
        const particleArrays p = spheres(d, density);

        for (const std::string law : {"Stokes", "SchillerNaumann", "Oseen"})
        {
            const scalars none = make(law)->StokesRate(p, gas);
            const scalars slip = make(law, "Cunningham")->StokesRate(p, gas);

            for (int i = 0; i < p.size(); ++i)
            {
                const double rate = 18*gas.mu/(density*d[i]*d[i]);

                EXPECT_NEAR(none(i)/rate, 1, 1e-14);
                EXPECT_NEAR(slip(i)*Cunningham(d[i], gas)/rate, 1, 1e-14);
            }
        }
    }

    // 5 um of 2300 kg/m3: 176 us
    const particleArrays p = spheres({5e-6}, 2300);
    EXPECT_NEAR(1/make("Stokes")->StokesRate(p, gas)(0), 176.5e-6, 0.1e-6);
}


TEST(drag, hasTheFactorsOfItsLaws)
{
    scalars Re(7);
    Re << 0, 1e-12, 1e-3, 0.1, 1, 20, 500;

    const auto Stokes = make("Stokes");
    const auto Schiller = make("SchillerNaumann");
    const auto Oseen = make("Oseen");

    EXPECT_TRUE(Stokes->linear());
    EXPECT_FALSE(Schiller->linear());
    EXPECT_FALSE(Oseen->linear());

    std::feclearexcept(FE_ALL_EXCEPT);

    const scalars phi = Schiller->factor(Re);
    const scalars phiOseen = Oseen->factor(Re);

    EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW));
    EXPECT_TRUE((Stokes->factor(Re) == 1).all());

    for (int i = 0; i < Re.size(); ++i)
    {
        EXPECT_NEAR(phi(i), 1 + 0.15*std::pow(Re(i), 0.687), 1e-13*phi(i));
        EXPECT_NEAR(phiOseen(i), 1 + 0.1875*Re(i), 1e-13*phiOseen(i));
    }

    // Drag coefficients 24 phi/Re of a sphere in textbooks
    EXPECT_NEAR(24/1.0*phi(4), 27.6, 0.05);
    EXPECT_NEAR(24/500.0*phi(6), 0.56, 0.01);
}


TEST(drag, noneIsNothing)
{
    particleArrays p = spheres({1e-6, 1e-4}, 1000);
    const auto none = drag::New(parse("type none;"));

    EXPECT_TRUE((none->StokesRate(p, gasProperties::air()) == 0).all());
    EXPECT_TRUE(none->linear());

    // Free fall: v = -g' t, x = -g' t^2/2
    equationOfMotion motion
    (
        parse
        (
            "drag { type none; } wake { type none; } aggregate { type none; }"
            "gravity { type uniform; value (0 0 -9.81); }"
        ),
        gasProperties::air(),
        Eigen::Array3d::Ones()
    );
    motion.laws().refresh(p);

    const vectors gas = vectors::Ones(3, 2);
    stepEnd end;
    motion.inWakes().moveTogether(0.1, p, {}, {gas, {}, 2*gas}, {}, 1, end);

    const double g = 9.81*(1 - 1.204/1000);

    for (int i = 0; i < 2; ++i)
    {
        EXPECT_NEAR(end.v(2, i), -0.1*g, 1e-14);
        EXPECT_NEAR(end.x(2, i), -0.005*g, 1e-15);
        EXPECT_EQ(end.v(0, i), 0);
        EXPECT_EQ(end.x(1, i), 0);
    }
}


TEST(drag, rejectsUnknownNames)
{
    EXPECT_THROW(make("Newton"), IOerror);
    EXPECT_THROW(drag::New(parse("type Stokes;")), IOerror);
    EXPECT_THROW(gravity::New(parse("type moon;")), IOerror);
}


TEST(gravity, isWeightLessBuoyancy)
{
    const gasProperties gas = gasProperties::air();

    particleArrays p = spheres({1e-6, 5e-6, 1e-5, 1e-5}, 2300);
    p.m(2) = gas.rho*pi/6*1e-15;
    p.m(3) = 0.5*p.m(2);

    const vectors a =
        gravity::New(parse("type uniform; value (1 -2 -9.81);"))
      ->acceleration(p, gas);

    const Eigen::Vector3d g(1, -2, -9.81);
    const double share = 1 - gas.rho/2300;

    ASSERT_EQ(a.cols(), 4);
    EXPECT_LT((a.col(0) - share*g).norm(), 1e-14);
    EXPECT_LT((a.col(1) - share*g).norm(), 1e-14);

    // As light as the gas, and half as light: rises as it would fall
    EXPECT_LT(a.col(2).norm(), 1e-14);
    EXPECT_LT((a.col(3) + g).norm(), 1e-13);

    const vectors none =
        gravity::New(parse("type none;"))->acceleration(p, gas);

    ASSERT_EQ(none.cols(), 4);
    EXPECT_EQ(none.norm(), 0);
}


TEST(gravity, settlesAtThePublishedSpeed)
{
    const gasProperties gas = gasProperties::air();

    // 5 um of 2300 kg/m3: 1.73 mm/s
    const double speed =
        settledSpeed("type Stokes; slipCorrection none;", 5e-6, 2300, gas);

    EXPECT_NEAR(speed, 1.73e-3, 0.005e-3);

    const double tau = 2300*25e-12/(18*gas.mu);
    EXPECT_NEAR(speed/(tau*9.81*(1 - gas.rho/2300)), 1, 1e-12);

    const double slip = settledSpeed
    (
        "type Stokes; slipCorrection Cunningham;", 1e-6, 1000, gas
    );

    EXPECT_NEAR
    (
        slip
       /(1e-9/(18*gas.mu)*Cunningham(1e-6, gas)*9.81*(1 - gas.rho/1000)),
        1,
        1e-12
    );

    // A textbook's value (Hinds): 35 um/s for 1 um at unit density
    EXPECT_NEAR(slip, 35e-6, 0.4e-6);
}


TEST(gravity, settlesWhereFiniteReynoldsDragCarriesTheWeight)
{
    const gasProperties gas = gasProperties::air();

    for (const double d : {5e-6, 50e-6, 200e-6})
    {
        const double Schiller = terminalSpeed
        (
            d, 2300, gas,
            [](const double Re) { return 1 + 0.15*std::pow(Re, 0.687); }
        );
        const double Oseen = terminalSpeed
        (
            d, 2300, gas, [](const double Re) { return 1 + 3*Re/16; }
        );

        EXPECT_NEAR
        (
            settledSpeed
            (
                "type SchillerNaumann; slipCorrection none;", d, 2300, gas
            )/Schiller,
            1,
            1e-9
        ) << d;
        EXPECT_NEAR
        (
            settledSpeed("type Oseen; slipCorrection none;", d, 2300, gas)
           /Oseen,
            1,
            1e-9
        ) << d;
    }
}


// ************************************************************************* //
