/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    How the paths of particles converge with the fluid step, in a standing wave
    with gravity: isolated, and in a crowd with the wakes of the others, which
    act on all of it, up to 20 diameters, or as far as by default. The reference
    is a method of Runge and Kutta of fourth order.

\*---------------------------------------------------------------------------*/

#include "measured.H"
#include "standingWave.H"
#include "timeSteppingTools.H"
#include "wakeTools.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double frequency = 1400;
const double amplitude = 1.53;
const double density = 2000;

//- Far larger than the crowd: no image matters
const double length = 0.02;


//- An eighth of a wavelength from the node, where the gradient is largest
acoustics::soundField* wave()
{
    return sound<acoustics::standingWave>
    (
        "type standingWave; frequency 1400; velocityAmplitude 1.53;"
        "origin (-0.0306 0 0);"
    );
}


//- In rows along the wave, so that none comes to touch another one
particleArrays crowd()
{
    randomNumbers random(1);
    std::vector<sphere> spheres;

    for (int row = 0; row < 16; ++row)
    {
        spheres.push_back
        ({
            row, random.logUniform(2e-6, 15e-6), density,
            vec(random.uniform(-30e-6, 30e-6), 30e-6*(row/4), 30e-6*(row % 4)),
            vec::Zero()
        });
    }

    return arrays(spheres);
}


//- The ranges of the wakes that a dictionary asks for [m]; none without wakes
scalars ranges(const std::string& wake, const particleArrays& p)
{
    if (wake == "type none;")
    {
        return {};
    }

    const std::size_t given = wake.find("range");
    if (given != std::string::npos)
    {
        return std::stod(wake.substr(given + 5))*p.d;
    }

    // By default
    const double omega = 2*pi*frequency;
    const gasProperties gas = gasProperties::air();
    scalars result(p.size());

    for (int i = 0; i < p.size(); ++i)
    {
        const double tau = relaxationTime(p.d(i), density);
        const double s = omega*tau;
        const double U =
            amplitude*s/std::sqrt(1 + s*s)
          + tau*9.81*(1 - gas.rho/density);
        const double half = 0.5*U/omega;

        result(i) = std::min
        (
            0.75*p.d(i)*U/(0.25*omega*p.d.mean()),
            half + std::sqrt(half*half + 3*gas.nu()/omega)
        );
    }

    return result;
}


//- Positions at the end of the time
vectors RungeKutta
(
    const particleArrays& p,
    const scalars& range,
    const double end,
    const int steps
)
{
    const std::unique_ptr<acoustics::soundField> gasField(wave());
    const gasProperties gas = gasProperties::air();
    const int n = p.size();

    const auto rates =
    [&](const double t, const vectors& x, const vectors& v)
    {
        vectors u;
        gasField->velocity(t, x, u);

        const vectors slip = u - v;

        if (range.size())
        {
            std::vector<source> sources;
            for (int k = 0; k < n*n; ++k)
            {
                const int i = k/n;
                const int j = k % n;

                if (i != j)
                {
                    sources.push_back
                    (
                        {x.col(i) - x.col(j), slip.col(j), 0.5*p.d(j)}
                    );
                }
            }

            const std::vector<vec> w = disturbances("Oseen", sources);

            std::size_t k = 0;
            for (int i = 0; i < n; ++i)
            {
                for (int j = 0; j < n; ++j)
                {
                    if (i != j)
                    {
                        const double ratio =
                            (x.col(i) - x.col(j)).norm()/range(j);
                        const double s =
                            std::clamp(2*ratio*ratio - 1, 0.0, 1.0);

                        u.col(i) +=
                            (1 - s*s*s*(10 - 15*s + 6*s*s))*w[k++];
                    }
                }
            }
        }

        vectors a = u - v;
        for (int i = 0; i < n; ++i)
        {
            a.col(i) /= relaxationTime(p.d(i), density);
        }
        a.row(1).array() -= 9.81*(1 - gas.rho/density);

        return a;
    };

    const double h = end/steps;
    vectors x = p.x;
    vectors v = p.v;

    for (int s = 0; s < steps; ++s)
    {
        const double t = s*h;
        const vectors a1 = rates(t, x, v);
        const vectors v2 = v + 0.5*h*a1;
        const vectors a2 = rates(t + 0.5*h, x + 0.5*h*v, v2);
        const vectors v3 = v + 0.5*h*a2;
        const vectors a3 = rates(t + 0.5*h, x + 0.5*h*v2, v3);
        const vectors v4 = v + h*a3;
        const vectors a4 = rates(t + h, x + h*v3, v4);

        x += h/6*(v + 2*v2 + 2*v3 + v4);
        v += h/6*(a1 + 2*a2 + 2*a3 + a4);
    }

    return x;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_P(eachTimeStepping, isOfSecondOrderInTheFluidStep)
{
    const double end = 1/frequency;
    const particleArrays p = crowd();

    for
    (
        const std::string wake :
        {
            "type none;", "type Oseen; range 400;", "type Oseen; range 20;",
            "type Oseen;"
        }
    )
    {
        settings law = with("type Stokes; slipCorrection none;");
        law.gravity = "type uniform; value (0 -9.81 0);";
        law.contact = "type none;";
        law.wake = wake;

        const vectors exact = RungeKutta(p, ranges(wake, p), end, 6400);

        double before = 0;

        for (const int n : {25, 50, 100})
        {
            experiment box(p, vec::Constant(length), law, wave());
            box.run(end/n, n);

            const double error =
                (box.p.x - exact).norm()/std::sqrt(p.size());
            const double order = before > 0 ? std::log2(before/error) : 0;

            measured
            (
                "%s wake { %s } T/%d: positions off by %.2e um, order %.2f\n",
                GetParam().c_str(), wake.c_str(), n, 1e6*error, order
            );

            if (GetParam() == conventional)
            {
                // Its step is the far shorter one of the contacts
                EXPECT_LT(error, 1e-9);
            }
            else if (n == 50)
            {
                EXPECT_GT(order, 1.8) << wake;
            }
            else if (n == 100)
            {
                // Below a nanometre the reference is no better
                EXPECT_TRUE(order > 1.9 || error < 1e-9) << wake;
                EXPECT_LT(error, 0.1e-6);
            }

            before = error;
        }
    }
}


// ************************************************************************* //
