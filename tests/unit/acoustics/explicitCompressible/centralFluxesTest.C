/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Fluxes on a periodic line of cells: of which order they are, whether they
    conserve, what the filter does, and that the order of the cells in memory
    does not matter.

\*---------------------------------------------------------------------------*/

#include "centralFluxes.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

namespace
{

using Foam::acoustics::centralFluxes;

constexpr double pi = 3.14159265358979323846;

const centralFluxes::gas air
{
    1.4, 287.0, 1.81e-5, 0.026, 343.2, 1.204, 1.204*343.2*343.2/1.4
};


//- Equal cells around a ring of length one, in any order in memory
struct ring
{
    int n;
    std::vector<int> place;

    explicit ring(const int size)
    :
        n(size),
        place(size)
    {
        std::iota(place.begin(), place.end(), 0);
    }

    std::vector<centralFluxes::face> faces() const
    {
        std::vector<centralFluxes::face> list;
        for (int i = 0; i < n; ++i)
        {
            const auto at = [&](const int j)
            {
                return place[(i + j + n) % n];
            };

            list.push_back
            ({
                {at(-1), at(0), at(1), at(2)},
                {0.6, 0.8, 0},
                double(n)
            });
        }
        return list;
    }

    //- Density, velocity and pressure by functions of the place
    template<class Gas>
    centralFluxes::state fill(const Gas& gas) const
    {
        centralFluxes::state q;
        for (auto& values : q)
        {
            values.resize(n);
        }
        for (int i = 0; i < n; ++i)
        {
            const std::array<double, 5> values = gas((i + 0.5)/n);
            for (int k = 0; k < 5; ++k)
            {
                q[k][place[i]] = values[k];
            }
        }
        return q;
    }
};


centralFluxes::state none(const int n)
{
    centralFluxes::state sum;
    for (auto& values : sum)
    {
        values.assign(n, 0);
    }
    return sum;
}


//- A plane wave along the line, of the given amplitude relative to c
std::array<double, 5> wave(const double x, const double amplitude)
{
    const double s = amplitude*std::sin(2*pi*x);

    return
    {
        air.rho*(1 + s), 0.6*air.c*s, 0.8*air.c*s, 0,
        air.p*(1 + air.gamma*s)
    };
}


//- Largest error of the outflow of mass of a weak wave, over its largest value
double massError(const int n)
{
    const ring cells(n);
    const double amplitude = 1e-6;

    const auto q = cells.fill
    (
        [&](const double x) { return wave(x, amplitude); }
    );

    auto sum = none(n);
    centralFluxes(air, cells.faces()).addInviscid(q, sum);

    double error = 0;
    for (int i = 0; i < n; ++i)
    {
        const double exact =
            2*pi*air.rho*air.c*amplitude*std::cos(2*pi*(i + 0.5)/n);

        error = std::max(error, std::abs(sum[0][i]*n - exact));
    }
    return error/(2*pi*air.rho*air.c*amplitude);
}

} // End anonymous namespace


TEST(centralFluxes, areOfFourthOrderForAWave)
{
    const double coarse = massError(25);
    const double fine = massError(50);

    // The modified wave number is low by (kh)^4/30
    EXPECT_NEAR(fine, std::pow(2*pi/50, 4)/30, 0.1*fine);
    EXPECT_GT(std::log2(coarse/fine), 3.9);
}


TEST(centralFluxes, conserveAndDoNotDependOnTheOrderOfTheCells)
{
    const int n = 333;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(-0.1, 0.1);

    ring straight(n);
    ring shuffled(n);
    std::shuffle(shuffled.place.begin(), shuffled.place.end(), random);

    std::vector<std::array<double, 5>> values(n);
    for (auto& q : values)
    {
        q =
        {
            air.rho*(1 + noise(random)), 50*noise(random), 50*noise(random),
            50*noise(random), air.p*(1 + noise(random))
        };
    }
    const auto gas = [&](const double x) { return values[int(x*n)]; };

    std::array<centralFluxes::state, 2> sums;
    for (int which = 0; which < 2; ++which)
    {
        const ring& cells = which ? shuffled : straight;
        const auto q = cells.fill(gas);

        centralFluxes fluxes(air, cells.faces());
        sums[which] = none(n);
        fluxes.addInviscid(q, sums[which]);
        fluxes.divergence(q);
        fluxes.addViscous(q, sums[which]);
    }

    for (int k = 0; k < 5; ++k)
    {
        double total = 0;
        double size = 0;
        for (int i = 0; i < n; ++i)
        {
            const double a = sums[0][k][straight.place[i]];
            const double b = sums[1][k][shuffled.place[i]];

            total += a;
            size += std::abs(a);
            EXPECT_NEAR(a, b, 1e-12*(std::abs(a) + std::abs(b)) + 1e-9);
        }
        EXPECT_NEAR(total, 0, 1e-13*size);
    }
}


TEST(centralFluxes, filterASawtoothAndLeaveShearAlone)
{
    const int n = 32;
    const ring cells(n);
    const centralFluxes fluxes(air, cells.faces());

    const auto sign = [&](const double x)
    {
        return int(x*n) % 2 ? 1.0 : -1.0;
    };

    // Central differences alone would let both be as they are
    const auto pressure = cells.fill
    (
        [&](const double x) -> std::array<double, 5>
        {
            return {air.rho, 0, 0, 0, air.p + 10*sign(x)};
        }
    );
    const auto shear = cells.fill
    (
        [&](const double x) -> std::array<double, 5>
        {
            return {air.rho, 0.8*sign(x), -0.6*sign(x), 0, air.p};
        }
    );

    auto outOfPressure = none(n);
    auto outOfShear = none(n);
    fluxes.addInviscid(pressure, outOfPressure);
    fluxes.addInviscid(shear, outOfShear);

    for (int i = 0; i < n; ++i)
    {
        // d3 = 8 times the sawtooth, on both sides of the cell; the filter is
        // all but fully on
        const double exact =
            2*8*centralFluxes::filterStrength*10*sign((i + 0.5)/n)/air.c;

        EXPECT_NEAR(outOfPressure[0][i], exact, 1e-3*std::abs(exact));
        for (int k = 0; k < 5; ++k)
        {
            EXPECT_NEAR(outOfShear[k][i], 0, 1e-9);
        }
    }
}


TEST(centralFluxes, dissipateByViscosity)
{
    // Shear across the line, u_z = sin(2 pi x): mu u'' on equal cells, with the
    // eigenvalue of three points
    const int n = 40;
    const ring cells(n);
    centralFluxes fluxes(air, cells.faces());

    const auto q = cells.fill
    (
        [&](const double x) -> std::array<double, 5>
        {
            return {air.rho, 0, 0, std::sin(2*pi*x), air.p};
        }
    );

    auto sum = none(n);
    fluxes.divergence(q);
    fluxes.addViscous(q, sum);

    const double eigenvalue = air.mu*std::pow(2*n*std::sin(pi/n), 2);
    for (int i = 0; i < n; ++i)
    {
        EXPECT_NEAR(sum[3][i]*n, eigenvalue*q[3][i], 1e-9*eigenvalue);
    }
}


// ************************************************************************* //
