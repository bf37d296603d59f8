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
constexpr int blockSize = 64;

using block = Eigen::Array<double, blockSize, 1>;

//- The three components of vectors
using blocks = std::array<block, 3>;


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


//- The factors A, B, C of the exact integration, at z = h k
void integrals(const block& z, block& A, block& B, block& C)
{
    // Below the limit the differences cancel; the series are exact to rounding
    constexpr double small = 0.02;

    const block decay = (-z).exp();

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
    scalars Re = scalars::Zero(blockSize);
    blocks x, v, a, forced, u0, um, u1, x1, v1, w0, wm, w1;

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

        block rate = k;

        if (!linear())
        {
            block slip =
            (
                (u0[0] - v[0]).square()
              + (u0[1] - v[1]).square()
              + (u0[2] - v[2]).square()
              + 1e-60
            ).sqrt();

            if (withEnd)
            {
                load(end.v, i0, size, v1);

                const block slip1 =
                (
                    (u1[0] - v1[0]).square()
                  + (u1[1] - v1[1]).square()
                  + (u1[2] - v1[2]).square()
                  + 1e-60
                ).sqrt();

                slip = 0.5*(slip + slip1);
            }

            for (int l = 0; l < size; ++l)
            {
                Re(l) = p.mobilityDiameter(i0 + l)*slip(l)/gas_.nu();
            }

            rate *= drag_.factor(Re);
        }

        block A, B, C;
        const block z = h*rate;
        integrals(z, A, B, C);

        const block zA = z*A;
        const block zB = z*B;
        const block zC = z*C;
        const block square = 1 - 2*B;
        const block cube = 1.0/3 - 2*C;

        for (int c = 0; c < 3; ++c)
        {
            const block slip = u0[c] - v[c];
            block change = u1[c] - u0[c];

            v1[c] = v[c] + slip*zA + a[c]*(h*A);
            block mean = v[c] + slip*zB + a[c]*(h*B);

            if (parabola)
            {
                const block bent = 2*(u0[c] + u1[c] - 2*um[c]);

                change -= bent;
                v1[c] += bent*square;
                mean += bent*cube;
            }

            v1[c] += change*zB;
            mean += change*zC;

            x1[c] = x[c] + h*mean;
        }

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


// ************************************************************************* //
