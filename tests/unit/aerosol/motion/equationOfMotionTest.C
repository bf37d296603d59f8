/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "equationOfMotion.H"
#include "motionTools.H"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::motionTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pi = EIGEN_PI;

using phasor = std::complex<double>;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(equationOfMotion, isEntrainedAsStokesSays)
{
    const gasProperties gas = gasProperties::air();

    struct sound
    {
        double frequency;
        double density;
        std::vector<double> d;
    };

    for
    (
        const sound& s :
        {
            sound{1400, 2300, {1e-6, 2e-6, 5e-6, 10e-6}},
            sound{5000, 2400, {8e-6}},
            sound{200, 2400, {8e-6}}
        }
    )
    {
        for (const int n : {50, 100, 200})
        {
            const double omega = 2*pi*s.frequency;
            const double u = 1.5;

            particleArrays p = spheres(s.d, s.density);
            equationOfMotion motion
                (laws("Stokes"), gas, Eigen::Array3d::Ones());

            const double h = 1/s.frequency/n;
            const auto gasVelocity = [&](const double t)
            {
                return vec(u*std::cos(omega*t), 0, 0);
            };

            // On its periodic path from the beginning
            std::vector<phasor> H;
            for (int i = 0; i < p.size(); ++i)
            {
                const double tau =
                    s.density*p.d(i)*p.d(i)/(18*gas.mu);

                H.push_back(1.0/phasor(1, omega*tau));
                p.v(0, i) = u*H[i].real();
            }

            motion.laws().refresh(p);

            vectors u0 = gasVelocity(0).replicate(1, p.size());
            stepEnd end;
            std::vector<phasor> response(p.size());
            vectors start;

            for (int step = 0; step < 20*n; ++step)
            {
                const vectors u1 =
                    gasVelocity((step + 1)*h).replicate(1, p.size());

                motion.exact().move(h, p, {u0, {}, u1}, {}, false, end);

                if (step == 19*n)
                {
                    start = p.x;
                }
                if (step >= 19*n)
                {
                    for (int i = 0; i < p.size(); ++i)
                    {
                        response[i] +=
                            2.0/n*end.v(0, i)
                           *std::polar(1.0, -omega*(step + 1)*h);
                    }
                }

                p.x = end.x;
                p.v = end.v;
                u0 = u1;
            }

            // The straight lines between the samples of the gas have an
            // amplitude that is too small by this share
            const double chord = std::pow(pi/n, 2)/3;

            for (int i = 0; i < p.size(); ++i)
            {
                EXPECT_NEAR
                (
                    std::abs(response[i])/(u*std::abs(H[i])), 1, 1.02*chord
                ) << n << ' ' << s.d[i];

                // H has the sign of exp(+i omega t): it lags
                EXPECT_NEAR
                (
                    std::arg(response[i]), std::arg(H[i]), 1e-4
                ) << n << ' ' << s.d[i];

                EXPECT_LT
                (
                    std::abs(p.x(0, i) - start(0, i)), 1e-6*u/omega
                ) << n << ' ' << s.d[i];
            }
        }
    }
}


TEST(equationOfMotion, hasThePublishedEntrainment)
{
    // One value as a number: 5 um, 2300 kg/m3, 1.4 kHz
    const gasProperties gas = gasProperties::air();
    particleArrays p = spheres({5e-6}, 2300);
    equationOfMotion motion(laws("Stokes"), gas, Eigen::Array3d::Ones());

    const double omega = 2*pi*1400;
    double largest = 0;

    for (int n = 0; n < 200; ++n)
    {
        const double begin = 10*n/(200*1400.0);

        advance
        (
            p, motion, {}, 1/(1400.0*200), 10,
            [&](const double t)
            {
                return vec(std::sin(omega*(begin + t)), 0, 0);
            }
        );

        if (n >= 180)
        {
            largest = std::max(largest, std::abs(p.v(0, 0)));
        }
    }

    EXPECT_LT(largest, 0.5415*1.0005);
    EXPECT_GT(largest, 0.5415*std::cos(pi/20)*0.999);
}


TEST(equationOfMotion, isOfSecondOrderAtFiniteReynoldsNumber)
{
    const gasProperties gas = gasProperties::air();

    const auto gasVelocity = [](const double t)
    {
        return vec(2*std::sin(2*pi*500*t), 0, 1);
    };

    particleArrays start = spheres({30e-6}, 2000);
    start.v.col(0) = vec(0, 3, 0);

    const double rate = 18*gas.mu/(2000*900e-12);

    particleArrays exact = start;
    RungeKutta
    (
        exact, 1e-6, 2000,
        [&](const double t, const vectors&, const vectors& v)
        {
            const vec slip = gasVelocity(t) - v.col(0);
            const double Re = slip.norm()*30e-6/gas.nu();

            return vectors(rate*(1 + 0.15*std::pow(Re, 0.687))*slip);
        }
    );

    std::vector<double> errors;

    for (const int n : {25, 50, 100, 200})
    {
        particleArrays p = start;
        equationOfMotion motion
            (laws("SchillerNaumann"), gas, Eigen::Array3d::Ones());

        advance(p, motion, {}, 0.002/n, n, gasVelocity);
        errors.push_back((p.x - exact.x).norm());
    }

    EXPECT_GT(order(errors), 1.9);
    EXPECT_LT(errors.back(), 1e-4*(exact.x - start.x).norm());
}


// ************************************************************************* //
