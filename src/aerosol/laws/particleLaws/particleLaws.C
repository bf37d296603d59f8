/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleLaws.H"
#include "IStringStream.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::particleLaws::particleLaws
(
    const dictionary& dict,
    const gasProperties& gas,
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
    aggregate_(aggregate::New(dict.subDict("aggregate"))),
    wake_(wake::New(dict.subDict("wake"))),
    Brownian_
    (
        Brownian::New
        (
            dict.found("Brownian") ? dict.subDict("Brownian")
          : dictionary(IStringStream("type none;")())
        )
    ),
    slips_(slips),
    meanFlow_(Eigen::Vector3d::Zero()),
    amplitude_(slips_.amplitude())
{
    wake_->setSound(dict.subDict("wake"), slips_.omega(), gas_);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::particleLaws::size
(
    particleArrays& p,
    const int i
) const
{
    const auto N = p.primaries(i);

    p.mobilityDiameter(i) = aggregate_->mobilityDiameter(p.d(i), N);
    p.collisionDiameter(i) = aggregate_->collisionDiameter(p.d(i), N);
}


std::complex<double> Foam::aerosol::particleLaws::response
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
    const int nPasses = drag_->linear() ? 1 : 20;

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

        if (!drag_->linear())
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

void Foam::aerosol::particleLaws::chooseTolerance(const particleArrays& p)
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


void Foam::aerosol::particleLaws::refresh
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


void Foam::aerosol::particleLaws::refresh(particleArrays& particles) const
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
    if (!Brownian_->active())
    {
        particles.thermal.setZero(3, particles.size());
    }
}


Foam::aerosol::scalars
Foam::aerosol::particleLaws::relaxationTime(const particleArrays& p)
{
    return 1/p.rate.max(VSMALL);
}


Foam::aerosol::scalars
Foam::aerosol::particleLaws::gain(const particleArrays& p, const scalar h)
{
    const scalars longest = relaxationTime(p).min(h);
    const scalars speed =
        p.acceleration.colwise().norm().transpose().array()*longest;

    return
        p.unsteady.cols()
      ? speed + p.unsteady.colwise().norm().transpose().array()*longest
      : speed;
}


Foam::scalar Foam::aerosol::particleLaws::largestSlip
(
    const particleArrays& p,
    const int i
) const
{
    return slips_.slip
    (
        scalars::Constant(1, p.rate(i)), p.acceleration.col(i)
    )(0);
}


// ************************************************************************* //
