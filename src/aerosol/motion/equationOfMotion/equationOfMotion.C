/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "equationOfMotion.H"
#include "IStringStream.H"
#include "noAggregate.H"

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

Foam::aerosol::equationOfMotion::equationOfMotion
(
    const dictionary& dict,
    const gasProperties& gas,
    const Eigen::Array3d& period,
    const slipBound& slips
)
:
    gas_(gas),
    drag_(drag::New(dict.subDict("drag"))),
    unsteady_
    (
        unsteadyDrag::New(dict, slips.omega()/constant::mathematical::twoPi)
    ),
    gravity_(gravity::New(dict.subDict("gravity"))),
    aggregate_
    (
        dict.found("aggregate")
      ? aggregate::New(dict.subDict("aggregate"))
      : autoPtr<aggregate>(new noAggregate(dict))
    ),
    wake_(wake::New(dict.subDict("wake"))),
    Brownian_
    (
        Brownian::New
        (
            dict.found("Brownian") ? dict.subDict("Brownian")
          : dictionary(IStringStream("type none;")())
        )
    ),
    period_(period),
    slips_(slips),
    meanFlow_(Eigen::Vector3d::Zero()),
    amplitude_(slips_.amplitude())
{
    wake_->setSound(dict.subDict("wake"), slips_.omega(), gas_);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::equationOfMotion::size
(
    particleArrays& p,
    const int i
) const
{
    const auto N = p.primaries(i);

    p.mobilityDiameter(i) = aggregate_->mobilityDiameter(p.d(i), N);
    p.collisionDiameter(i) = aggregate_->collisionDiameter(p.d(i), N);
}


std::complex<double> Foam::aerosol::equationOfMotion::response
(
    const particleArrays& one
) const
{
    const scalar omega = slips_.omega();

    if (omega <= 0)
    {
        return 0;
    }

    const unsteadyDrag::phasors more =
        unsteady_->periodic(omega, gas_, one, 0);

    // The finite drag depends on the slip, and this on the drag
    const int nPasses = linear() ? 1 : 20;

    std::complex<double> H;
    scalar factor = 1;

    for (int pass = 0; pass < nPasses; ++pass)
    {
        const std::complex<double> kappa
        (
            more.slip.real(),
            more.slip.imag() - factor*one.rate(0)/omega
        );

        H = (kappa + more.gas)/(kappa + 1.0);

        if (!linear())
        {
            const scalar slip =
                8/(3*EIGEN_PI)*std::abs(1.0 - H)*amplitude_;

            factor = drag_->factor
            (
                scalars::Constant(1, one.mobilityDiameter(0)*slip/gas_.nu())
            )(0);
        }
    }

    return H;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::equationOfMotion::move
(
    const scalar h,
    const particleArrays& p,
    const gasStep& gas,
    const gasStep& wakes,
    const bool withEnd,
    state& end,
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

            rate *= drag_->factor(Re);
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


void Foam::aerosol::equationOfMotion::accelerate
(
    const scalar h,
    const gasStep& gas,
    const int first,
    particleArrays& p,
    state& end
) const
{
    const int n = static_cast<int>(gas.u0.cols());

    const vectors U0 =
        gas.u0
      - drift(p.v.middleCols(first, n), p.thermal.middleCols(first, n));

    vectors a0;
    scalars q;
    unsteady_->begin(h, U0, gas.u1 - gas.u0, gas_, first, p, a0, q);

    p.unsteady.middleCols(first, n).setZero();

    // With finite drag, which depends on the end, once more
    const int nPasses = linear() ? 1 : 2;

    for (int pass = 0; pass < nPasses; ++pass)
    {
        move(h, p, gas, {}, pass > 0, end, first);

        for (int l = 0; l < n; ++l)
        {
            const int i = first + l;
            const double z = h*p.rate(i);
            const double A = z > 1e-12 ? -std::expm1(-z)/z : 1;

            Eigen::Vector3d U1 = gas.u1.col(l) - end.v.col(i);
            if (hasBrownian())
            {
                U1 += (1 - z*A)*p.thermal.col(i);
            }

            p.unsteady.col(i) +=
            (
                a0.col(l) + q(l)*(U1 - U0.col(l)) - p.unsteady.col(i)
            )/(1 + q(l)*h*A);
        }
    }
}


void Foam::aerosol::equationOfMotion::increment
(
    const scalar h,
    const particleArrays& p,
    const std::int64_t step,
    const std::uint64_t block,
    Brownian::increments& increment
) const
{
    Brownian_->increment(p, p.rate, gas_, h, step, block, increment);
}


void Foam::aerosol::equationOfMotion::bridge
(
    const scalar h,
    const particleArrays& p,
    const std::int64_t step,
    const std::uint64_t block,
    const int n,
    const Brownian::increments& whole,
    std::vector<Brownian::increments>& parts
) const
{
    Brownian_->bridge(p, p.rate, gas_, h, step, block, n, whole, parts);
}


Foam::aerosol::Brownian::extent Foam::aerosol::equationOfMotion::reach
(
    const scalar h,
    const particleArrays& p
) const
{
    return Brownian_->reach(p, p.rate, gas_, h);
}


void Foam::aerosol::equationOfMotion::cool
(
    const scalar h,
    const particleArrays& p,
    state& end
) const
{
    if (!hasBrownian())
    {
        return;
    }

    end.thermal.resize(3, p.size());

    // One by one, that the result depends on the particle only
    for (int i = 0; i < p.size(); ++i)
    {
        end.thermal.col(i) =
            std::exp(-h*p.rate(i))*p.thermal.col(i) + end.increment.v.col(i);
    }
}


void Foam::aerosol::equationOfMotion::split
(
    const scalar h,
    const particleArrays& p,
    state& end
) const
{
    if (!hasBrownian())
    {
        return;
    }

    const int n = p.size();

    cool(h, p, end);
    end.path0.resize(3, n);
    end.path1.resize(3, n);

    for (int i = 0; i < n; ++i)
    {
        const double z = h*p.rate(i);
        const double A = z > 1e-12 ? -std::expm1(-z)/z : 1;

        const Eigen::Vector3d before = p.thermal.col(i);
        const Eigen::Vector3d after = end.thermal.col(i);
        const Eigen::Vector3d mean = A*before + end.increment.x.col(i)/h;

        end.path0.col(i) = p.v.col(i) - (1 - A)*(before - mean);
        end.path1.col(i) = end.v.col(i) - (1 - A)*(after - mean);
    }
}


Foam::aerosol::equationOfMotion::state
Foam::aerosol::equationOfMotion::halfway
(
    const scalar h,
    const particleArrays& p,
    const state& end
) const
{
    state middle;

    if (hasBrownian())
    {
        middle.increment.x = 0.5*end.increment.x;
        middle.increment.v.setZero(3, p.size());
        cool(0.5*h, p, middle);
    }

    return middle;
}


void Foam::aerosol::equationOfMotion::arrive
(
    particleArrays& p,
    state& end
) const
{
    p.x.swap(end.x);
    p.v.swap(end.v);

    if (hasBrownian())
    {
        p.thermal.swap(end.thermal);
    }
}


Foam::aerosol::vectors Foam::aerosol::equationOfMotion::drift
(
    const vectors& v,
    const vectors& thermal
) const
{
    return hasBrownian() ? vectors(v - thermal) : v;
}


void Foam::aerosol::equationOfMotion::chooseTolerance(const particleArrays& p)
{
    particleArrays sized(p);
    sized.resizeLaws();
    for (int i = 0; i < sized.size(); ++i)
    {
        size(sized, i);
    }

    wake_->setTolerance
    (
        slips_.tolerance
        (
            sized.mobilityDiameter,
            slipBound::settling
            (
                drag_->StokesRate(sized, gas_),
                gravity_->acceleration(sized, gas_)
            )
        )
    );
}


void Foam::aerosol::equationOfMotion::refresh
(
    particleArrays& particles,
    const int i
) const
{
    size(particles, i);

    particleArrays one = particles.select({i});

    one.rate = drag_->StokesRate(one, gas_);
    particles.rate(i) = one.rate(0);
    particles.response(i) = response(one);
    particles.acceleration.col(i) = gravity_->acceleration(one, gas_).col(0);

    const scalars slip = slips_.slip
    (
        scalars::Constant(1, particles.rate(i)),
        particles.acceleration.col(i)
    );
    const scalar range = wake_->range(one.mobilityDiameter, slip)(0);

    particles.range(i) =
        wake_->needsTolerance() && !wake_->ends()
      ? std::min(range, slips_.longestRange(slip(0), gas_.nu()))
      : range;
}


void Foam::aerosol::equationOfMotion::refresh(particleArrays& particles) const
{
    // One by one, that the result depends on the particle only
    particles.resizeLaws();

    if (particles.history.rows() != unsteady_->nHistory())
    {
        particles.resizeHistory(unsteady_->nHistory());
    }

    for (int i = 0; i < particles.size(); ++i)
    {
        refresh(particles, i);
    }

    // Left by a run that had it
    if (!hasBrownian())
    {
        particles.thermal.setZero(3, particles.size());
    }
}


Foam::aerosol::scalars
Foam::aerosol::equationOfMotion::relaxationTime(const particleArrays& p)
{
    return 1/p.rate.max(VSMALL);
}


Foam::aerosol::scalars
Foam::aerosol::equationOfMotion::gain(const particleArrays& p, const scalar h)
{
    const scalars longest = relaxationTime(p).min(h);
    const scalars speed =
        p.acceleration.colwise().norm().transpose().array()*longest;

    return
        p.unsteady.cols()
      ? speed + p.unsteady.colwise().norm().transpose().array()*longest
      : speed;
}


Foam::aerosol::vectors Foam::aerosol::equationOfMotion::imaginarySlip
(
    const scalars& rate,
    const gasStep& gas,
    const scalar s,
    const scalar h
) const
{
    const scalar omega = wake_->omega();

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
            (share*(u.col(i) - meanFlow_) - change.col(i)/omega)
           /(1 + share*share);
    }

    return result;
}


Foam::aerosol::vectors
Foam::aerosol::equationOfMotion::settling(const particleArrays& p) const
{
    if (wake_->omega() <= 0)
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


Foam::scalar Foam::aerosol::equationOfMotion::fadingSpeed
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
    const scalar slip = std::min
    (
        slips_.slip
        (
            scalars::Constant(1, p.rate(i)), p.acceleration.col(i)
        )(0),
        1e6
    );

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

    wake_->evaluate(block, gas_);

    return std::sqrt
    (
        (
            block.velocity[0].square()
          + block.velocity[1].square()
          + block.velocity[2].square()
        ).maxCoeff()
    );
}


void Foam::aerosol::equationOfMotion::wakes
(
    const sources& from,
    const std::vector<particlePair>& pairs,
    const int nTargets,
    vectors& w
) const
{
    w.setZero(3, nTargets);

    if (!hasWakes() || pairs.empty())
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
        // Added and subtracted, it rounds to a multiple of 2^-44
        constexpr double rounding = 0x1.8p8;

        wake_->evaluate(block, gas_);

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
                (share*block.velocity[k] + rounding) - rounding;
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
      ? wake_->paths(from.slip - from.steady, from.imaginary)
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


void Foam::aerosol::equationOfMotion::wakes
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
    wakes
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


void Foam::aerosol::equationOfMotion::moveInWakes
(
    const scalar h,
    const particleArrays& p,
    const gasStep& gas,
    const wakesOfStep& wakesAt,
    const int nIterations,
    gasStep& w,
    state& end
) const
{
    state middle = halfway(h, p, end);
    const gasStep firstHalf = gas.part(0, 0.5);

    w.um.resize(3, 0);
    w.u1.resize(3, 0);
    wakesAt(0, p.x, drift(p.v, p.thermal), gas.u0, w.u0);

    for (int n = 0; n < nIterations; ++n)
    {
        // First with the wakes of the beginning, later with those just found
        const bool again = n > 0;

        move
        (
            0.5*h, p, firstHalf, again ? w.part(0, 0.5) : w, again, middle
        );
        wakesAt
        (
            0.5,
            middle.x,
            drift(middle.v, middle.thermal),
            firstHalf.u1,
            w.um
        );

        if (!again)
        {
            w.u1 = 2*w.um - w.u0;
            move(h, p, gas, w, false, end);
        }

        wakesAt(1, end.x, drift(end.v, end.thermal), gas.u1, w.u1);
        move(h, p, gas, w, true, end);
    }
}


void Foam::aerosol::equationOfMotion::step
(
    const scalar h,
    const particleArrays& p,
    const std::vector<particlePair>& wakePairs,
    const gasStep& gas,
    const gasStep& outside,
    const int nIterations,
    state& end
) const
{
    gasStep w;

    if (!hasWakes())
    {
        move(h, p, gas, w, false, end);

        if (!linear())
        {
            move(h, p, gas, w, true, end);
        }

        split(h, p, end);
        return;
    }

    // The thermal velocity at the end is that of drag and noise alone
    cool(h, p, end);

    const auto wakesAt =
    [&]
    (
        const scalar s,
        const vectors& x,
        const vectors& v,
        const vectors& u,
        vectors& result
    )
    {
        wakes
        (
            p, wakePairs, x, v, u, result, imaginarySlip(p.rate, gas, s, h)
        );

        if (outside.u0.cols())
        {
            result += outside.at(s);
        }
    };

    moveInWakes(h, p, gas, wakesAt, nIterations, w, end);

    split(h, p, end);
}


// ************************************************************************* //
