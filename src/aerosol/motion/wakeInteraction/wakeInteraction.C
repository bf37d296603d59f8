/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wakeInteraction.H"
#include "nearestMultiple.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::wakeInteraction::wakeInteraction
(
    const particleLaws& laws,
    const Eigen::Array3d& period
)
:
    laws_(laws),
    wake_(laws.wakeModel()),
    gas_(laws.gas()),
    period_(period)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::vectors Foam::aerosol::wakeInteraction::imaginarySlip
(
    const scalars& rate,
    const stepValues& gas,
    const scalar s,
    const scalar h
) const
{
    const scalar omega = wake_.omega();

    if (omega <= 0)
    {
        return {};
    }

    const vectors u = gas.at(s);
    const vectors change = gas.change(s, h);

    vectors result(3, u.cols());

    for (int i = 0; i < result.cols(); ++i)
    {
        // 1/s: zero without drag
        const double share = rate(i)/omega;

        result.col(i) =
            (share*(u.col(i) - laws_.meanFlow()) - change.col(i)/omega)
           /(1 + share*share);
    }

    return result;
}


Foam::aerosol::vectors
Foam::aerosol::wakeInteraction::settling(const particleArrays& p) const
{
    if (wake_.omega() <= 0)
    {
        return {};
    }

    vectors result(3, p.size());

    for (int i = 0; i < p.size(); ++i)
    {
        // Nothing settles without drag
        result.col(i) =
            p.acceleration.col(i)*(p.rate(i) > 0 ? -1/p.rate(i) : 0);
    }

    return result;
}


Foam::scalar Foam::aerosol::wakeInteraction::fadingSpeed
(
    const particleArrays& p,
    const int i
) const
{
    constexpr int nDirections = 8;
    constexpr int nPhases = wake::blockSize/nDirections;

    if (p.range(i) <= 0)
    {
        return 0;
    }

    // GREAT without drag
    const scalar slip = std::min(laws_.largestSlip(p, i), 1e6);

    wake::block block;

    for (int k = 0; k < 3; ++k)
    {
        block.r[k].setZero();
        block.slip[k].setZero();
        block.imaginary[k].setZero();
        block.steady[k].setZero();
    }
    block.radius = 0.5*p.mobilityDiameter(i);

    for (int b = 0; b < wake::blockSize; ++b)
    {
        const double angle = EIGEN_PI*(b/nPhases)/(nDirections - 1);
        const double phase = 2*EIGEN_PI*(b % nPhases)/nPhases;
        const double r = wake::fadeBegin*p.range(i);

        block.r[0](b) = r*std::cos(angle);
        block.r[1](b) = r*std::sin(angle);
        block.slip[0](b) = slip*std::cos(phase);
        block.imaginary[0](b) = slip*std::sin(phase);
    }

    wake_.evaluate(block, gas_);

    return std::sqrt
    (
        (
            block.velocity[0].square()
          + block.velocity[1].square()
          + block.velocity[2].square()
        ).maxCoeff()
    );
}


void Foam::aerosol::wakeInteraction::sum
(
    const sources& from,
    const std::vector<particlePair>& pairs,
    const int nTargets,
    vectors& w
) const
{
    w.setZero(3, nTargets);

    if (!active() || pairs.empty())
    {
        return;
    }

    wake::block block;
    wake::blockScalars range;
    wake::blockScalars share = wake::blockScalars::Ones();
    std::array<int, wake::blockSize> target;
    int n = 0;

    // Unused places of the last block: no slip, no disturbance
    for (int k = 0; k < 3; ++k)
    {
        block.r[k].setOnes();
        block.slip[k].setZero();
        block.imaginary[k].setZero();
        block.steady[k].setZero();
    }
    block.radius.setOnes();
    range.setOnes();

    const auto evaluate = [&]()
    {
        wake_.evaluate(block, gas_);

        for (int b = 0; b < wake::blockSize; ++b)
        {
            share(b) *= wake::fade
            (
                (
                    block.r[0](b)*block.r[0](b)
                  + block.r[1](b)*block.r[1](b)
                  + block.r[2](b)*block.r[2](b)
                )/(range(b)*range(b))
            );
        }

        for (int k = 0; k < 3; ++k)
        {
            block.velocity[k] =
                nearestMultiple<-44>(share*block.velocity[k]);
        }

        share.setOnes();

        const double* const w0 = block.velocity[0].data();
        const double* const w1 = block.velocity[1].data();
        const double* const w2 = block.velocity[2].data();

        for (int b = 0; b < n; ++b)
        {
            double* const sum = w.data() + 3*target[b];
            sum[0] += w0[b];
            sum[1] += w1[b];
            sum[2] += w2[b];
        }

        n = 0;
    };

    const double* const x = from.x.data();
    const double* const slip = from.slip.data();
    const bool withImaginary = from.imaginary.cols();
    const double* const imaginary = from.imaginary.data();
    const double* const steady = from.steady.data();
    const std::vector<wake::path> paths =
        withImaginary
      ? wake_.paths(from.slip - from.steady, from.imaginary)
      : std::vector<wake::path>();
    const double* const d = from.d.data();
    const double* const ranges = from.range.data();

    for (const particlePair& pair : pairs)
    {
        const double* const xi = x + 3*pair.i;
        const double* const xj = x + 3*pair.j;

        double r[3] = {xi[0] - xj[0], xi[1] - xj[1], xi[2] - xj[2]};

        // Most of them do not reach across a side of the domain
        if (pair.image[0] | pair.image[1] | pair.image[2])
        {
            for (int k = 0; k < 3; ++k)
            {
                r[k] = xi[k] - (xj[k] + pair.image[k]*period_(k));
            }
        }

        const double distanceSqr = r[0]*r[0] + r[1]*r[1] + r[2]*r[2];
        const double reach = ranges[pair.j];

        if (distanceSqr > reach*reach || distanceSqr < VSMALL)
        {
            continue;
        }

        const double* const U = slip + 3*pair.j;

        for (int k = 0; k < 3; ++k)
        {
            block.r[k].data()[n] = r[k];
            block.slip[k].data()[n] = U[k];
        }

        for (int k = 0; withImaginary && k < 3; ++k)
        {
            block.imaginary[k].data()[n] = imaginary[3*pair.j + k];
            block.steady[k].data()[n] = steady[3*pair.j + k];
        }

        block.radius.data()[n] = 0.5*d[pair.j];
        range.data()[n] = reach;
        target[n] = pair.i;

        if (!paths.empty())
        {
            share.data()[n] = paths[pair.j].share(r, paths[pair.i]);
        }

        // Branch-free: adding the condition is faster than a branch that is
        // often mispredicted
        n += share.data()[n] > 0;

        if (n == wake::blockSize)
        {
            evaluate();
        }
    }

    for (int b = n; b < wake::blockSize; ++b)
    {
        for (int k = 0; k < 3; ++k)
        {
            block.r[k](b) = 1;
            block.slip[k](b) = 0;
            block.imaginary[k](b) = 0;
            block.steady[k](b) = 0;
        }
        block.radius(b) = 1;
        range(b) = 1;
        share(b) = 1;
    }

    evaluate();
}


void Foam::aerosol::wakeInteraction::sum
(
    const particleArrays& particles,
    const std::vector<particlePair>& pairs,
    const vectors& x,
    const vectors& v,
    const vectors& u,
    vectors& w,
    const vectors& imaginary
) const
{
    sum
    (
        {
            x, u - v, particles.mobilityDiameter, particles.range,
            settling(particles), imaginary
        },
        pairs,
        particles.size(),
        w
    );
}


// ************************************************************************* //
