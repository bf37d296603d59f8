/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wakeStep.H"
#include "motionTools.H"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::motionTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pi = EIGEN_PI;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(wakeStep, isOfSecondOrder)
{
    const gasProperties gas = gasProperties::air();
    const double frequency = 1000;
    const double omega = 2*pi*frequency;

    const auto gasVelocity = [&](const double t)
    {
        return vec(0.44*std::sin(omega*t), 0.1*std::cos(omega*t), 0);
    };

    particleArrays start = spheres({8e-6, 8e-6, 5e-6}, 2400);
    start.x << 0, 25e-6, 10e-6,
               0, 5e-6, 30e-6,
               0, 0, -10e-6;
    start.v.setConstant(0.02);

    const scalars tau = 2400*start.d.square()/(18*gas.mu);

    particleArrays exact = start;
    RungeKutta
    (
        exact, 1/frequency/4000, 8000,
        [&](const double t, const vectors& x, const vectors& v)
        {
            vectors a(3, 3);
            for (int i = 0; i < 3; ++i)
            {
                vec u = gasVelocity(t);
                for (int j = 0; j < 3; ++j)
                {
                    if (j != i)
                    {
                        u += OseenFlow
                        (
                            x.col(i) - x.col(j),
                            gasVelocity(t) - v.col(j),
                            0.5*start.d(j),
                            gas.nu()
                        );
                    }
                }
                a.col(i) = (u - v.col(i))/tau(i);
            }
            return a;
        }
    );

    // The wakes brought the pair closer by far more than what is missing
    const double moved =
        (exact.x.col(1) - exact.x.col(0)).norm()
      - (start.x.col(1) - start.x.col(0)).norm();

    EXPECT_GT(std::abs(moved), 1e-6);

    // Wakes that are linear in time, and a parabola
    for (const int iterations : {int(wakeStep::linear), 1})
    {
        std::vector<double> apart;
        std::vector<double> place;

        for (const int n : {25, 50, 100, 200, 400})
        {
            particleArrays p = start;
            equationOfMotion motion
            (
                laws("Stokes", "type Oseen; range 100;"),
                gas,
                Eigen::Array3d::Ones()
            );

            advance
            (
                p, motion, everyPair(3), 1/frequency/n, 2*n, gasVelocity,
                iterations
            );

            place.push_back((p.x - exact.x).norm());
            apart.push_back
            (
                (
                    (p.x.col(1) - p.x.col(0))
                  - (exact.x.col(1) - exact.x.col(0))
                ).norm()
            );
        }

        EXPECT_GT(order(place), 1.9) << iterations;
        EXPECT_GT(order(apart), 1.9) << iterations;

        EXPECT_LT(apart[2], 0.01*std::abs(moved)) << iterations;
    }
}


TEST(wakeStep, addsTheWakesOfParticlesOutside)
{
    // A particle that comes with its neighbour, or with the wakes of that
    const gasProperties gas = gasProperties::air();
    const equationOfMotion motion
    (
        laws("Stokes", "type Oseen; range 100;"), gas, Eigen::Array3d::Ones()
    );

    // So heavy that its wake is a parabola in time, nearly
    particleArrays p = spheres({5e-6, 60e-6}, 2000);
    p.x << 0, 100e-6,
           0, 20e-6,
           0, 0;
    p.v.col(1) = vec(0.3, 0, 0);
    motion.laws().refresh(p);

    const double h = 1e-6;
    const stepValues air{vectors::Zero(3, 2), {}, vectors::Zero(3, 2)};

    // The first one does not act
    const std::vector<particlePair> pairs{{0, 1, {0, 0, 0}}};

    stepEnd together;
    motion.inWakes().moveTogether(h, p, pairs, air, {}, 2, together);

    const auto wakesAt = [&](const vectors& x, const vectors& v)
    {
        vectors w;
        motion.wakes().sum(p, pairs, x, v, vectors::Zero(3, 2), w);
        return vectors(w.col(0));
    };

    stepEnd half;
    motion.inWakes().moveTogether
    (
        0.5*h, p, pairs, air.part(0, 0.5), {}, 2, half
    );

    const stepValues outside
    {
        wakesAt(p.x, p.v), wakesAt(half.x, half.v),
        wakesAt(together.x, together.v)
    };

    stepEnd alone;
    motion.inWakes().moveTogether
    (
        h, p.select({0}), {}, {vectors::Zero(3, 1), {}, vectors::Zero(3, 1)},
        outside, 2, alone
    );

    const double moved = (together.x.col(0) - p.x.col(0)).norm();

    EXPECT_GT(moved, 1e-11);
    EXPECT_LT((alone.x.col(0) - together.x.col(0)).norm(), 1e-6*moved);
}


// ************************************************************************* //
