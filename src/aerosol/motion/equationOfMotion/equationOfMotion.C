/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "equationOfMotion.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::equationOfMotion::equationOfMotion
(
    const dictionary& dict,
    const gasProperties& gas,
    const Eigen::Array3d& period
)
:
    gas_(gas),
    drag_(drag::New(dict.subDict("drag"))),
    gravity_(gravity::New(dict.subDict("gravity"))),
    wake_(wake::New(dict.subDict("wake"))),
    period_(period)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::equationOfMotion::rate
(
    const scalars& d,
    const scalars& slipSpeed
) const
{
    if (drag_->linear())
    {
        return StokesRate_;
    }

    return StokesRate_*drag_->factor(d*slipSpeed/gas_.nu());
}


void Foam::aerosol::equationOfMotion::glide
(
    const scalar h,
    const scalars& k,
    const vectors& acceleration,
    const vectors& x,
    const vectors& v,
    const gasStep& u,
    state& end
)
{
    const scalars z = h*k;

    // Below the limit the differences cancel; the series are exact to rounding.
    // The vectorised functions are evaluated first, as select() is not.
    constexpr double small = 0.02;
    const scalars zs = z.max(small);
    const scalars fullA = (1 - (-zs).exp())/zs;
    const scalars fullB = (1 - fullA)/zs;
    const scalars fullC = (0.5 - fullB)/zs;

    const scalars A = (z < small).select
    (
        1 - z/2*(1 - z/3*(1 - z/4*(1 - z/5*(1 - z/6)))),
        fullA
    );
    const scalars B = (z < small).select
    (
        0.5*(1 - z/3*(1 - z/4*(1 - z/5*(1 - z/6*(1 - z/7))))),
        fullB
    );
    const scalars C = (z < small).select
    (
        1.0/6.0*(1 - z/4*(1 - z/5*(1 - z/6*(1 - z/7*(1 - z/8))))),
        fullC
    );

    const auto rows = [](const scalars& factor)
    {
        return factor.transpose();
    };

    const auto slip = (u.u0 - v).array();
    const auto a = acceleration.array();

    // Of u = u0 + linear s + square s^2, with the fraction s of the step
    vectors linear = u.u1 - u.u0;
    vectors square;

    if (u.um.cols())
    {
        square = 2*(u.u0 + u.u1 - 2*u.um);
        linear -= square;
    }

    end.v =
        v.array()
      + slip.rowwise()*rows(z*A)
      + linear.array().rowwise()*rows(z*B)
      + a.rowwise()*rows(h*A);

    end.x =
        x.array()
      + h*v.array()
      + slip.rowwise()*rows(h*z*B)
      + linear.array().rowwise()*rows(h*z*C)
      + a.rowwise()*rows(h*h*B);

    if (u.um.cols())
    {
        end.v.array() += square.array().rowwise()*rows(1 - 2*B);
        end.x.array() += square.array().rowwise()*rows(h*(1.0/3 - 2*C));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::vectors
Foam::aerosol::equationOfMotion::gasStep::at(const scalar s) const
{
    if (!um.cols())
    {
        return u0 + s*(u1 - u0);
    }

    return
        (1 - s)*(1 - 2*s)*u0 + 4*s*(1 - s)*um + s*(2*s - 1)*u1;
}


void Foam::aerosol::equationOfMotion::refresh(const particleArrays& particles)
{
    StokesRate_ = drag_->StokesRate(particles, gas_);
    acceleration_ = gravity_->acceleration(particles, gas_);
    range_ = wake_->range(particles.d);
}


Foam::aerosol::scalars Foam::aerosol::equationOfMotion::relaxationTime() const
{
    return 1/StokesRate_.max(VSMALL);
}


Foam::aerosol::scalars
Foam::aerosol::equationOfMotion::gain(const scalar h) const
{
    return
        acceleration_.colwise().norm().transpose().array()
       *relaxationTime().min(h);
}


void Foam::aerosol::equationOfMotion::wakes
(
    const particleArrays& particles,
    const std::vector<particlePair>& pairs,
    const vectors& x,
    const vectors& v,
    const vectors& u,
    vectors& w
) const
{
    w.setZero(3, particles.size());

    if (!hasWakes())
    {
        return;
    }

    wake::block block;
    std::array<int, wake::blockSize> target;
    int n = 0;

    // Unused places of the last block: no slip, no disturbance
    for (int k = 0; k < 3; ++k)
    {
        block.r[k].setOnes();
        block.slip[k].setZero();
    }
    block.radius.setOnes();

    const auto evaluate = [&]()
    {
        wake_->evaluate(block, gas_);

        for (int b = 0; b < n; ++b)
        {
            for (int k = 0; k < 3; ++k)
            {
                w(k, target[b]) += block.velocity[k](b);
            }
        }

        n = 0;
    };

    for (const particlePair& pair : pairs)
    {
        const int i = pair.i;
        const int j = pair.j;

        double distanceSqr = 0;

        for (int k = 0; k < 3; ++k)
        {
            const double r = x(k, i) - x(k, j) - pair.image[k]*period_(k);

            block.r[k](n) = r;
            block.slip[k](n) = u(k, j) - v(k, j);
            distanceSqr += r*r;
        }

        if (distanceSqr > range_(j)*range_(j) || distanceSqr < VSMALL)
        {
            continue;
        }

        block.radius(n) = 0.5*particles.d(j);
        target[n] = i;

        if (++n == wake::blockSize)
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
        }
        block.radius(b) = 1;
    }

    evaluate();
}


void Foam::aerosol::equationOfMotion::step
(
    const scalar h,
    const particleArrays& particles,
    const std::vector<particlePair>& wakePairs,
    const gasStep& gas,
    const vectors& w0,
    const vectors& outside,
    state& end
) const
{
    // What moves the particles: the gas and the wakes, first those of the
    // beginning
    gasStep u;
    u.u0 = gas.u0 + w0;
    u.u1 = gas.u1 + w0;
    if (gas.um.cols())
    {
        u.um = gas.um + w0;
    }

    const scalars slip0 = (u.u0 - particles.v).colwise().norm().array();

    glide
    (
        h,
        rate(particles.d, slip0),
        acceleration_,
        particles.x,
        particles.v,
        u,
        end
    );

    if (!hasWakes() && drag_->linear())
    {
        end.w = w0;
        return;
    }

    wakes(particles, wakePairs, end.x, end.v, gas.u1, end.w);
    if (outside.cols())
    {
        end.w += outside;
    }

    // Then those that change on the way
    u.u1 = gas.u1 + end.w;
    if (gas.um.cols())
    {
        u.um = gas.um + 0.5*(w0 + end.w);
    }

    const scalars slip1 = (u.u1 - end.v).colwise().norm().array();

    glide
    (
        h,
        rate(particles.d, 0.5*(slip0 + slip1)),
        acceleration_,
        particles.x,
        particles.v,
        u,
        end
    );
}


void Foam::aerosol::equationOfMotion::moveOn
(
    const int i,
    const scalar done,
    const scalar h,
    const particleArrays& particles,
    const std::vector<particlePair>& wakePairs,
    const gasStep& gas,
    const vectors& outside,
    state& end
)
{
    particleArrays one;
    one.resize(1);
    one.id(0) = particles.id(i);
    one.x = particles.x.col(i);
    one.v = particles.v.col(i);
    one.d(0) = particles.d(i);
    one.m(0) = particles.m(i);
    one.primaries(0) = particles.primaries(i);

    StokesRate_.segment<1>(i) = drag_->StokesRate(one, gas_);
    acceleration_.col(i) = gravity_->acceleration(one, gas_);
    range_.segment<1>(i) = wake_->range(one.d);

    std::vector<particlePair> acting;
    for (const particlePair& pair : wakePairs)
    {
        if (pair.i == i)
        {
            acting.push_back(pair);
        }
    }

    const Eigen::Vector3d from =
        outside.cols() ? Eigen::Vector3d(outside.col(i))
      : Eigen::Vector3d(Eigen::Vector3d::Zero());

    vectors w;
    wakes(particles, acting, particles.x, particles.v, gas.u0, w);

    gasStep u;
    u.u0 = gas.at(done).col(i) + w.col(i) + from;
    u.u1 = gas.u1.col(i) + w.col(i) + from;

    const scalars slip = (u.u0 - one.v).colwise().norm().array();

    scalars k = StokesRate_.segment<1>(i);
    k *= drag_->factor(one.d*slip/gas_.nu());

    state rest;
    glide((1 - done)*h, k, acceleration_.col(i), one.x, one.v, u, rest);

    end.x.col(i) = rest.x;
    end.v.col(i) = rest.v;

    wakes(particles, acting, end.x, end.v, gas.u1, w);
    end.w.col(i) = w.col(i) + from;
}


// ************************************************************************* //
