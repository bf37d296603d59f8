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
    const vectors& u0,
    const vectors& u1,
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

    const auto slip = (u0 - v).array();
    const auto change = (u1 - u0).array();
    const auto a = acceleration.array();

    end.v =
        v.array()
      + slip.rowwise()*rows(z*A)
      + change.rowwise()*rows(z*B)
      + a.rowwise()*rows(h*A);

    end.x =
        x.array()
      + h*v.array()
      + slip.rowwise()*rows(h*z*B)
      + change.rowwise()*rows(h*z*C)
      + a.rowwise()*rows(h*h*B);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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


Foam::scalar Foam::aerosol::equationOfMotion::maxAcceleration() const
{
    return
        acceleration_.cols()
      ? acceleration_.colwise().norm().maxCoeff()
      : 0;
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
    const vectors& u0,
    const vectors& u1,
    const vectors& w0,
    state& end
) const
{
    const vectors start = u0 + w0;

    const scalars slip0 = (start - particles.v).colwise().norm().array();

    glide
    (
        h,
        rate(particles.d, slip0),
        acceleration_,
        particles.x,
        particles.v,
        start,
        u1 + w0,
        end
    );

    if (!hasWakes() && drag_->linear())
    {
        end.w = w0;
        return;
    }

    wakes(particles, wakePairs, end.x, end.v, u1, end.w);

    const scalars slip1 = (u1 + end.w - end.v).colwise().norm().array();

    glide
    (
        h,
        rate(particles.d, 0.5*(slip0 + slip1)),
        acceleration_,
        particles.x,
        particles.v,
        start,
        u1 + end.w,
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
    const vectors& u0,
    const vectors& u1,
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

    vectors w;
    wakes(particles, acting, particles.x, particles.v, u0, w);

    const vectors uEnd = u1.col(i) + w.col(i);
    const vectors uNow =
        uEnd - (1 - done)*(u1.col(i) - u0.col(i));

    const scalars slip = (uNow - one.v).colwise().norm().array();

    scalars k = StokesRate_.segment<1>(i);
    k *= drag_->factor(one.d*slip/gas_.nu());

    state rest;
    glide
    (
        (1 - done)*h,
        k,
        acceleration_.col(i),
        one.x,
        one.v,
        uNow,
        uEnd,
        rest
    );

    end.x.col(i) = rest.x;
    end.v.col(i) = rest.v;

    wakes(particles, acting, end.x, end.v, u1, w);
    end.w.col(i) = w.col(i);
}


// ************************************************************************* //
