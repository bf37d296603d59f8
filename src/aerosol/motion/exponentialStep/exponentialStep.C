/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exponentialStep.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Particles that are worked out together. All take the same instructions,
//  wherever they are in the block.
constexpr int blockSize = Foam::acoustics::commonVelocity::blockSize;

using block = Foam::acoustics::commonVelocity::block;
using blocks = Foam::acoustics::commonVelocity::blocks;

//- Added to a square: the vector instruction for the root of 0 is undefined
constexpr double tiny = 1e-60;

// Functions that are not inlined give the same bits wherever they are called:
// products and sums are not contracted in one place only.


//- The columns of v from a first one on, components apart. Zero beyond size,
//  also if there are no columns.
void load
(
    const Foam::aerosol::vectors& v,
    const int first,
    const int size,
    blocks& apart
)
{
    double buffer[3*blockSize];
    const double* from = v.data() + 3*first;

    if (size < blockSize || !v.cols())
    {
        const int end = v.cols() ? 3*size : 0;

        std::copy(from, from + end, buffer);
        std::fill(buffer + end, buffer + 3*blockSize, 0.0);
        from = buffer;
    }

    double* const x = apart[0].data();
    double* const y = apart[1].data();
    double* const z = apart[2].data();

    for (int l = 0; l < blockSize; ++l)
    {
        x[l] = from[3*l];
        y[l] = from[3*l + 1];
        z[l] = from[3*l + 2];
    }
}


//- The reverse
void store
(
    const blocks& apart,
    const int first,
    const int size,
    Foam::aerosol::vectors& v
)
{
    double buffer[3*blockSize];
    double* const to = v.data() + 3*first;
    double* const whole = size < blockSize ? buffer : to;

    const double* const x = apart[0].data();
    const double* const y = apart[1].data();
    const double* const z = apart[2].data();

    for (int l = 0; l < blockSize; ++l)
    {
        whole[3*l] = x[l];
        whole[3*l + 1] = y[l];
        whole[3*l + 2] = z[l];
    }

    if (size < blockSize)
    {
        std::copy(buffer, buffer + 3*size, to);
    }
}


//- What the exact integration multiplies with
struct factors
{
    block zA, zB, zC, hA, hB, square, cube;
};


//- Of a step of length h with these rates of drag
[[gnu::noinline]] void integrals(const double h, const block& rate, factors& f)
{
    // Below the limit the differences cancel; the series are exact to rounding
    constexpr double small = 0.02;

    const block z = h*rate;
    const block decay = (-z).exp();
    block A, B, C;

    for (int l = 0; l < blockSize; ++l)
    {
        const double y = z(l);
        const double large = y < small ? small : y;
        const double a = (1 - decay(l))/large;
        const double b = (1 - a)/large;
        const double c = (0.5 - b)/large;

        const double tail = 1 - y/6*(1 - y/7*(1 - y/8));
        const double c0 = 1.0/6*(1 - y/4*(1 - y/5*tail));
        const double b0 = 0.5 - y*c0;
        const double a0 = 1 - y*b0;

        A(l) = y < small ? a0 : a;
        B(l) = y < small ? b0 : b;
        C(l) = y < small ? c0 : c;
    }

    f.zA = z*A;
    f.zB = z*B;
    f.zC = z*C;
    f.hA = h*A;
    f.hB = h*B;
    f.square = 1 - 2*B;
    f.cube = 1.0/3 - 2*C;
}


//- Positions x1 and velocities v1 at the end of a step of length h
[[gnu::noinline]] void integrate
(
    const factors& f,
    const double h,
    const bool parabola,
    const blocks& x,
    const blocks& v,
    const blocks& a,
    const blocks& u0,
    const blocks& um,
    const blocks& u1,
    blocks& x1,
    blocks& v1
)
{
    for (int c = 0; c < 3; ++c)
    {
        const block slip = u0[c] - v[c];
        block change = u1[c] - u0[c];

        block then = v[c] + slip*f.zA + a[c]*f.hA;
        block mean = v[c] + slip*f.zB + a[c]*f.hB;

        if (parabola)
        {
            const block bent = 2*(u0[c] + u1[c] - 2*um[c]);

            change -= bent;
            then += bent*f.square;
            mean += bent*f.cube;
        }

        v1[c] = then + change*f.zB;
        x1[c] = x[c] + h*(mean + change*f.zC);
    }
}


//- The slip of particles with these velocities
[[gnu::noinline]] void slipSpeed(const blocks& u, const blocks& v, block& slip)
{
    slip =
    (
        (u[0] - v[0]).square()
      + (u[1] - v[1]).square()
      + (u[2] - v[2]).square()
      + tiny
    ).sqrt();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::exponentialStep::exponentialStep
(
    const drag& law,
    const gasProperties& gas
)
:
    drag_(law),
    gas_(gas)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::exponentialStep::rates
(
    const block& Stokes,
    const block& diameter,
    const block& slip,
    block& rate
) const
{
    const scalars Re = diameter*slip/gas_.nu();

    rate = Stokes*drag_.factor(Re);
}


void Foam::aerosol::exponentialStep::move
(
    const scalar h,
    const particleArrays& p,
    const stepValues& gas,
    const stepValues& wakes,
    const bool withEnd,
    stepEnd& end,
    const int first
) const
{
    const int n = static_cast<int>(gas.u0.cols());
    const bool parabola = gas.um.cols() || wakes.um.cols();
    const bool incremented = end.increment.x.cols();
    const bool unsteady = p.unsteady.cols();

    end.x.resize(3, p.size());
    end.v.resize(3, p.size());

    // Those beyond the end of the last block: at rest in gas at rest
    block k = block::Zero();
    block d = block::Zero();
    blocks x, v, a, forced, u0, um, u1, x1, v1, w0, wm, w1;
    factors f;

    for (int from = 0; from < n; from += blockSize)
    {
        const int size = std::min(blockSize, n - from);
        const int i0 = first + from;

        k.setZero();
        std::copy(p.rate.data() + i0, p.rate.data() + i0 + size, k.data());

        load(p.x, i0, size, x);
        load(p.v, i0, size, v);
        load(p.acceleration, i0, size, a);

        if (unsteady)
        {
            load(p.unsteady, i0, size, forced);

            for (int c = 0; c < 3; ++c)
            {
                a[c] += forced[c];
            }
        }

        load(gas.u0, from, size, u0);
        load(gas.u1, from, size, u1);

        if (gas.um.cols())
        {
            load(gas.um, from, size, um);
        }
        else
        {
            for (int c = 0; c < 3; ++c)
            {
                um[c] = 0.5*(u0[c] + u1[c]);
            }
        }

        if (wakes.u0.cols())
        {
            load(wakes.u0, from, size, w0);
            load(wakes.u1.cols() ? wakes.u1 : wakes.u0, from, size, w1);
            load(wakes.um, from, size, wm);

            for (int c = 0; c < 3; ++c)
            {
                um[c] += wakes.um.cols() ? wm[c] : block(0.5*(w0[c] + w1[c]));
                u0[c] += w0[c];
                u1[c] += w1[c];
            }
        }

        if (linear())
        {
            integrals(h, k, f);
        }
        else
        {
            d.setZero();
            std::copy
            (
                p.mobilityDiameter.data() + i0,
                p.mobilityDiameter.data() + i0 + size,
                d.data()
            );

            block slip, rate;
            slipSpeed(u0, v, slip);

            if (withEnd)
            {
                load(end.v, i0, size, v1);

                block slip1;
                slipSpeed(u1, v1, slip1);
                slip = 0.5*(slip + slip1);
            }

            rates(k, d, slip, rate);
            integrals(h, rate, f);
        }

        integrate(f, h, parabola, x, v, a, u0, um, u1, x1, v1);

        store(x1, i0, size, end.x);
        store(v1, i0, size, end.v);

        for (int i = i0; incremented && i < i0 + size; ++i)
        {
            end.v.col(i) += end.increment.v.col(i);
            end.x.col(i) += end.increment.x.col(i);
        }
    }
}


void Foam::aerosol::exponentialStep::moveAlone
(
    const scalar h,
    const particleArrays& p,
    const stepValues& gas,
    stepEnd& end,
    const int first
) const
{
    move(h, p, gas, {}, false, end, first);

    if (!linear())
    {
        move(h, p, gas, {}, true, end, first);
    }
}


void Foam::aerosol::exponentialStep::moveAlone
(
    const scalar h,
    const particleArrays& p,
    const std::vector<commonStep>& steps,
    const int every,
    const vectors& x0,
    const vectors& v0,
    std::vector<vectors>& x,
    vectors& v,
    scalars& furthest,
    scalars& bulge
) const
{
    const int n = p.size();
    const int nSteps = static_cast<int>(steps.size());

    int nHarmonics = 0;
    for (const commonStep& step : steps)
    {
        for (const auto* u : {&step.u0, &step.um, &step.u1})
        {
            nHarmonics = std::max(nHarmonics, u->nHarmonics());
        }
    }

    x.resize(nSteps/every);
    for (vectors& some : x)
    {
        some.resize(3, n);
    }
    v.resize(3, n);
    furthest.resize(n);
    bulge.resize(n);

    block k, d, furthestSqr, largest;
    blocks begin, chord;
    acoustics::commonVelocity::phasorBlock response;
    blocks xl, vl, a, u0, um, u1, x1, v1;
    factors f;

    for (int from = 0; from < n; from += blockSize)
    {
        const int size = std::min(blockSize, n - from);

        k.setZero();
        d.setZero();
        std::copy(p.rate.data() + from, p.rate.data() + from + size, k.data());
        std::copy
        (
            p.mobilityDiameter.data() + from,
            p.mobilityDiameter.data() + from + size,
            d.data()
        );

        response.first.setZero();
        response.second.setZero();
        response.first.head(size) = p.response.segment(from, size).real();
        response.second.head(size) = p.response.segment(from, size).imag();

        const auto responses =
            acoustics::commonVelocity::responses(response, nHarmonics);

        load(x0, from, size, xl);
        load(v0, from, size, vl);
        load(p.acceleration, from, size, a);
        furthestSqr.setConstant(tiny);
        largest.setZero();

        if (linear())
        {
            integrals(h, k, f);
        }

        for (int m = 0; m < nSteps; ++m)
        {
            const commonStep& step = steps[m];

            if (m % every == 0)
            {
                for (int c = 0; c < 3; ++c)
                {
                    begin[c] = every*h*(vl[c] - step.begin(c));
                    chord[c].setZero();
                }
            }

            step.u0.at(responses, u0);
            step.um.at(responses, um);
            step.u1.at(responses, u1);

            if (linear())
            {
                integrate(f, h, true, xl, vl, a, u0, um, u1, x1, v1);
            }
            else
            {
                block slip, slip1, rate;

                slipSpeed(u0, vl, slip);
                rates(k, d, slip, rate);
                integrals(h, rate, f);
                integrate(f, h, true, xl, vl, a, u0, um, u1, x1, v1);

                slipSpeed(u1, v1, slip1);
                slip = 0.5*(slip + slip1);
                rates(k, d, slip, rate);
                integrals(h, rate, f);
                integrate(f, h, true, xl, vl, a, u0, um, u1, x1, v1);
            }

            block moved = block::Zero();
            for (int c = 0; c < 3; ++c)
            {
                const block way = x1[c] - xl[c] - step.displacement(c);
                chord[c] += way;
                moved += way.square();
            }
            furthestSqr = furthestSqr.max(moved);

            xl.swap(x1);
            vl.swap(v1);

            if ((m + 1) % every == 0)
            {
                store(xl, from, size, x[(m + 1)/every - 1]);

                // That of Hermite's cubic
                block before = block::Constant(tiny);
                block after = block::Constant(tiny);
                for (int c = 0; c < 3; ++c)
                {
                    before += (begin[c] - chord[c]).square();
                    after +=
                        (every*h*(vl[c] - step.end(c)) - chord[c]).square();
                }
                largest =
                    largest.max(4.0/27*(before.sqrt() + after.sqrt()));
            }
        }

        store(vl, from, size, v);
        bulge.segment(from, size) = largest.head(size);

        furthest.segment(from, size) = furthestSqr.head(size).sqrt();
    }
}


// ************************************************************************* //
