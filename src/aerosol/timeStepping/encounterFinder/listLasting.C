/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "encounterFinder.H"
#include "communicator.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Lists that are to last are made for so many periods of settling, for this
//  drift of any particle, in mean distances, and with so much more than the
//  amplitude
constexpr double lastingPeriods = 20;
constexpr double longDrift = 0.2;
constexpr double extentMargin = 1.05;

//- More room than others need is no more than that, in mean distances
constexpr double mostRestless = 0.5;

//- Of the shortest edge of the domain: how far one may reach
constexpr double furthestReach = 1;

//- With more neighbours than that, per particle, such lists are not worth while
constexpr double mostNeighbours = 30;

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::aerosol::encounterFinder::listLasting
(
    const particleArrays& p,
    const fluidStep& step,
    const std::complex<double>& meanResponse
)
{
    const int n = p.size();
    const double omega = 2*EIGEN_PI*sound_.frequency();
    const double period = 1/sound_.frequency();

    // Mean and phasor of the gas, now
    const Eigen::Vector3d u = sound_.commonAt(step.t)->u;
    const Eigen::Vector3d quarter = sound_.commonAt(step.t + 0.25*period)->u;
    const Eigen::Vector3d half = sound_.commonAt(step.t + 0.5*period)->u;
    const Eigen::Vector3d mean = 0.5*(u + half);
    const std::complex<double> i1(0, 1);
    const Eigen::Vector3cd phasor =
        (u - mean).cast<std::complex<double>>()
      - i1*(quarter - mean).cast<std::complex<double>>();

    vectors centre(3, n);
    vectors extent(3, n);
    scalars size(n);

    const double meanDistance =
        std::cbrt(domain_.volume()/communicator::sum(n));
    const double growth = motion_.laws().aggregateModel().growth();

    for (int i = 0; i < n; ++i)
    {
        const std::complex<double> relative =
            (p.response(i) - meanResponse)/(i1*omega);
        const double relaxation =
            std::min(1/std::max(p.rate(i), VSMALL), period);
        const Eigen::Vector3d settling = p.acceleration.col(i)*relaxation;

        // A velocity that is not that of the oscillation will be gone
        const Eigen::Vector3d rest =
            p.v.col(i) - mean - (p.response(i)*phasor).real() - settling;

        centre.col(i) =
            p.x.col(i) - (relative*phasor).real() + relaxation*rest
          + 0.5*lastingPeriods*period*settling;
        extent.col(i) =
            extentMargin*std::abs(relative)*phasor.cwiseAbs()
          + 0.5*lastingPeriods*period*settling.cwiseAbs()
          + relaxation*rest.cwiseAbs();

        // Two alike may merge
        size(i) =
            growth*(1 + margin)*0.5*p.collisionDiameter(i)
          + meanDistance*longDrift
          + std::min(restlessness(p.id(i)), mostRestless*meanDistance);
    }

    // Pairs per particle, if all were alike
    const double neighbours = communicator::mean
    (
        vectors::NullaryExpr
        (
            3,
            n,
            [&](const Eigen::Index k, const Eigen::Index i)
            {
                return
                    (4*(extent(k, i) + size(i)) + 2*p.range(i))/meanDistance;
            }
        )
    ).prod();

    // One that reaches far makes ghosts of all
    double furthest = 0;
    for (int i = 0; i < n; ++i)
    {
        furthest =
            std::max(furthest, extent.col(i).norm() + size(i) + p.range(i));
    }

    const bool far =
        communicator::max(furthest)
      > furthestReach*domain_.bounds().minDim();

    if (far || neighbours > mostNeighbours)
    {
        skin_.expire();
        return false;
    }

    // Most of them will need it no more
    for (auto one = restless_.begin(); one != restless_.end(); )
    {
        one->second *= 0.5;
        one =
            one->second < 0.01*meanDistance ? restless_.erase(one)
          : std::next(one);
    }

    ++counters_.lists;
    skin_.make(std::move(centre), std::move(extent), std::move(size));

    // Also on ranks without particles
    const bool withWakes = motion_.wakes().active();

    wakeCandidates_.findActing
    (
        grid_,
        p.id.cast<double>(),
        skin_,
        withWakes ? p.range : scalars(scalars::Zero(n)),
        contacts_
    );

    // Not soon needed again
    grid_ = cellGrid();

    if (!collisions_.active())
    {
        contacts_.pairs().clear();
    }

    listedRange_ = p.range;
    contacts_.keepNeededGhosts();
    contacts_.fillIds(p.id.cast<double>());
    wakeCandidates_.keepNeededGhosts();

    return true;
}


// ************************************************************************* //
