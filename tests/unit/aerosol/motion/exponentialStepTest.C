/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exponentialStep.H"
#include "motionTools.H"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::motionTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pi = EIGEN_PI;


//- Integral of exp(-z (1 - s)) s^(n-1)/(n-1)! over s from 0 to 1: what a gas
//  velocity that grows as a power of time gives
long double phi(const int n, const long double z)
{
    if (z < 4)
    {
        // Alternating series
        long double term = 1;
        for (int k = 2; k <= n; ++k)
        {
            term /= k;
        }

        long double sum = 0;
        for (int k = n; k < n + 60; ++k)
        {
            sum += term;
            term *= -z/(k + 1);
        }

        return sum;
    }

    return
        n == 1
      ? -std::expm1(-z)/z
      : (1.0L/std::tgamma((long double)(n)) - phi(n - 1, z))/z;
}


//- Velocity and position after a step, by the variation of constants
struct variation
{
    long double v;
    long double x;

    //- The gas has um at half of the step
    variation
    (
        const long double k,
        const long double h,
        const long double v0,
        const long double u0,
        const long double um,
        const long double u1,
        const long double g
    )
    {
        const long double z = k*h;

        // dv/dt at the beginning, its growth, and the growth of that
        const long double a = k*(u0 - v0) + g;
        const long double b = k*(4*um - 3*u0 - u1);
        const long double c = 4*k*(u0 + u1 - 2*um);

        v = v0 + h*(a*phi(1, z) + b*phi(2, z) + c*phi(3, z));
        x = h*v0 + h*h*(a*phi(2, z) + b*phi(3, z) + c*phi(4, z));
    }

    //- It is linear in time
    variation
    (
        const long double k,
        const long double h,
        const long double v0,
        const long double u0,
        const long double u1,
        const long double g
    )
    :
        variation(k, h, v0, u0, 0.5L*(u0 + u1), u1, g)
    {}
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(exponentialStep, isExactInGasThatChangesLinearlyInTime)
{
    const gasProperties gas = gasProperties::air();
    const double h = 1e-5;
    const double g = 9.81;

    // Masses such that z = h/tau is what is wanted
    std::vector<double> z;
    for (double s = 1e-8; s < 1.01e4; s *= std::pow(10, 0.1))
    {
        z.push_back(s);
    }
    for (const double s : {0.0199, 0.019999999, 0.02, 0.020000001, 0.0201})
    {
        z.push_back(s);
    }

    particleArrays p = spheres(std::vector<double>(z.size(), 2e-6), 1000);
    scalars k(p.size());

    for (int i = 0; i < p.size(); ++i)
    {
        p.m(i) = 3*pi*gas.mu*p.d(i)*h/z[i];
        k(i) = 3*pi*gas.mu*p.d(i)/p.m(i);
    }

    equationOfMotion motion
    (
        laws("Stokes", "type none;", "type uniform; value (0 0 -9.81);"),
        gas,
        Eigen::Array3d::Ones()
    );
    motion.laws().refresh(p);

    // Started from rest at the origin, nothing hides in rounding: x has gas at
    // a constant velocity, y one that rises from zero, z gravity
    vectors u0(3, p.size());
    vectors u1(3, p.size());
    u0.colwise() = vec(1.3, 0, 0);
    u1.colwise() = vec(1.3, 0.7, 0);

    stepEnd end;
    motion.exact().move(h, p, {u0, {}, u1}, {}, false, end);

    for (int i = 0; i < p.size(); ++i)
    {
        const double fall =
            -g*(1 - gas.rho*pi/6*std::pow(p.d(i), 3)/p.m(i));

        const variation x(k(i), h, 0, 1.3, 1.3, 0);
        const variation y(k(i), h, 0, 0, 0.7, 0);
        const variation w(k(i), h, 0, 0, 0, fall);

        EXPECT_NEAR(end.v(0, i)/double(x.v), 1, 1e-13) << z[i];
        EXPECT_NEAR(end.v(1, i)/double(y.v), 1, 1e-11) << z[i];
        EXPECT_NEAR(end.v(2, i)/double(w.v), 1, 1e-11) << z[i];

        EXPECT_NEAR(end.x(0, i)/double(x.x), 1, 1e-11) << z[i];
        EXPECT_NEAR(end.x(1, i)/double(y.x), 1, 1e-9) << z[i];
        EXPECT_NEAR(end.x(2, i)/double(w.x), 1, 1e-11) << z[i];
    }

    // All at once, from anywhere at any velocity
    const vec x0(0.1, -0.2, 0.3);
    const vec v0(-2, 0.5, 1);
    p.x.colwise() = x0;
    p.v.colwise() = v0;
    u0.colwise() = vec(1, 2, 3);
    u1.colwise() = vec(-1, 2.5, 0);
    motion.exact().move(h, p, {u0, {}, u1}, {}, false, end);

    for (int i = 0; i < p.size(); ++i)
    {
        const double fall =
            -g*(1 - gas.rho*pi/6*std::pow(p.d(i), 3)/p.m(i));

        for (int c = 0; c < 3; ++c)
        {
            const variation exact
            (
                k(i), h, v0(c), u0(c, i), u1(c, i), c == 2 ? fall : 0
            );

            EXPECT_NEAR(end.v(c, i), double(exact.v), 1e-13) << z[i];
            EXPECT_NEAR(end.x(c, i), x0(c) + double(exact.x), 2e-16) << z[i];
        }
    }
}


TEST(exponentialStep, isExactInGasThatIsAParabolaInTime)
{
    const gasProperties gas = gasProperties::air();
    const double h = 1e-5;

    particleArrays p = spheres(std::vector<double>(60, 2e-6), 1000);
    std::vector<double> z;

    for (int i = 0; i < p.size(); ++i)
    {
        z.push_back(1e-3*std::pow(10, 0.1*i));
        p.m(i) = 3*pi*gas.mu*p.d(i)*h/z[i];
    }

    const equationOfMotion motion(laws("Stokes"), gas, Eigen::Array3d::Ones());
    motion.laws().refresh(p);

    const vec v0(-2, 0.5, 1);
    const vec u0(1, 0, 3);
    const vec um(0.5, 1, -2);
    const vec u1(-1, 0, 0);
    p.v.colwise() = v0;

    const auto all = [&](const vec& u)
    {
        return vectors(u.replicate(1, p.size()));
    };

    // Of the gas, or of the wakes, or a part of both
    const std::vector<std::pair<stepValues, stepValues>> cases
    {
        {{all(u0), all(um), all(u1)}, {}},
        {{all(0*u0), {}, all(0*u1)}, {all(u0), all(um), all(u1)}},
        {
            {all(u0), all(0.5*(u0 + u1)), all(u1)},
            {all(0*u0), all(um - 0.5*(u0 + u1)), all(0*u1)}
        },
        {
            {all(u0), {}, all(u1)},
            {all(0*u0), all(um - 0.5*(u0 + u1)), all(0*u1)}
        }
    };

    for (const auto& each : cases)
    {
        stepEnd end;
        motion.exact().move(h, p, each.first, each.second, false, end);

        for (int i = 0; i < p.size(); ++i)
        {
            for (int c = 0; c < 3; ++c)
            {
                const variation exact
                (
                    3*pi*gas.mu*p.d(i)/p.m(i), h, v0(c), u0(c), um(c), u1(c), 0
                );

                EXPECT_NEAR(end.v(c, i), double(exact.v), 1e-10) << z[i];
                EXPECT_NEAR(end.x(c, i)/h, double(exact.x)/h, 1e-10) << z[i];
            }
        }
    }
}


TEST(exponentialStep, doesNotCareHowAStepIsDivided)
{
    // What is exact for a step is exact for its parts: one of h, or a
    // thousand on the other side of the series' limit
    const gasProperties gas = gasProperties::air();
    equationOfMotion motion(laws("Stokes"), gas, Eigen::Array3d::Ones());

    particleArrays once = spheres({0.5e-6, 3e-6, 20e-6}, 2300);
    once.v.setConstant(-0.3);
    particleArrays often = once;

    const auto rising = [](const double t)
    {
        return vec(0.4 + 2e4*t, -1e4*t, 0);
    };

    advance(once, motion, {}, 1e-5, 1, rising);
    advance(often, motion, {}, 1e-8, 1000, rising);

    EXPECT_LT((once.x - often.x).norm(), 1e-17);
    EXPECT_LT((once.v - often.v).norm(), 1e-12);
}


TEST(exponentialStep, dependsOnTheParticleOnly)
{
    // To the last bit: not on its place in a block, nor on how many there are
    const gasProperties gas = gasProperties::air();

    std::vector<double> d;
    for (int i = 0; i < 150; ++i)
    {
        d.push_back(1e-7*std::pow(1.04, i));
    }

    particleArrays p = spheres(d, 2000);
    vectors u0(3, p.size());
    vectors u1(3, p.size());

    for (int i = 0; i < p.size(); ++i)
    {
        p.x.col(i) = vec(0.1*i, -0.3, 0.02*i*i);
        p.v.col(i) = vec(0.01*i, 0.2, -0.5);
        u0.col(i) = vec(1, -0.03*i, 0.4);
        u1.col(i) = vec(0.5 + 0.1*i, 2, 0);
    }

    for (const std::string drag : {"Stokes", "SchillerNaumann"})
    {
        const equationOfMotion motion(laws(drag), gas, Eigen::Array3d::Ones());
        motion.laws().refresh(p);

        stepEnd all;
        motion.exact().moveAlone(1e-5, p, {u0, {}, u1}, all);

        stepEnd parts;
        for (const int first : {0, 37, 101})
        {
            const int size = first == 0 ? 37 : first == 37 ? 64 : 49;

            motion.exact().moveAlone
            (
                1e-5,
                p,
                {u0.middleCols(first, size), {}, u1.middleCols(first, size)},
                parts,
                first
            );
        }

        EXPECT_EQ(parts.x, all.x) << drag;
        EXPECT_EQ(parts.v, all.v) << drag;

        for (int i = 0; i < p.size(); ++i)
        {
            stepEnd one;
            motion.exact().moveAlone
            (
                1e-5, p.select({i}), {u0.col(i), {}, u1.col(i)}, one
            );

            EXPECT_EQ(one.x.col(0), all.x.col(i)) << drag << ' ' << i;
            EXPECT_EQ(one.v.col(0), all.v.col(i)) << drag << ' ' << i;
        }
    }
}


// ************************************************************************* //
