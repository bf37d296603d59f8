/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    How the paths of particles converge with the fluid step, in a standing wave
    with gravity: isolated, and in a crowd with the wakes of all others. The
    reference is a method of Runge and Kutta of fourth order.

\*---------------------------------------------------------------------------*/

#include "measured.H"
#include "standingWave.H"
#include "timeSteppingTools.H"
#include "wakeTools.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double frequency = 1400;
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


//- Positions at the end of the time
vectors RungeKutta
(
    const particleArrays& p,
    const bool withWakes,
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

        if (withWakes)
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

            for (std::size_t k = 0; k < w.size(); ++k)
            {
                u.col(k/(n - 1)) += w[k];
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

    for (const bool withWakes : {false, true})
    {
        settings law = with("type Stokes; slipCorrection none;");
        law.gravity = "type uniform; value (0 -9.81 0);";
        law.contact = "type none;";
        law.wake = withWakes ? "type Oseen; range 400;" : "type none;";

        const vectors exact = RungeKutta(p, withWakes, end, 6400);

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
                "%s, %s, T/%d: positions off by %.2e um, order %.2f\n",
                GetParam().c_str(), withWakes ? "wakes" : "no wakes", n,
                1e6*error, order
            );

            if (GetParam() == conventional)
            {
                // Its step is the far shorter one of the contacts
                EXPECT_LT(error, 1e-9);
            }
            else if (n == 50)
            {
                EXPECT_GT(order, 1.8) << withWakes;
            }
            else if (n == 100)
            {
                // Below a nanometre the reference is no better
                EXPECT_TRUE(order > 1.9 || error < 1e-9) << withWakes;
                EXPECT_LT(error, 0.1e-6);
            }

            before = error;
        }
    }
}


// ************************************************************************* //
