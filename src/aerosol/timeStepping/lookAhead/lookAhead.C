/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lookAhead.H"
#include "communicator.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::aerosol;

//- Intervals of a period, and how many are looked ahead: wakes come and go,
//  contacts are rare
constexpr double intervals = 10;
constexpr int aheadInWakes = 2;
constexpr int aheadWithout = 5;

//- With more than these a path may be further from its chord, in an interval,
//  than a cubic shows
constexpr int mostHarmonics = 5;

//- The gas of all steps is kept
constexpr double longestInterval = 40;

//- Of the particles, up to how many may be busy if it is worth while
constexpr double largestShare = 0.6;

//- Rounding of times makes no more difference than this
constexpr double rounding = 1e-9;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::lookAhead::lookAhead
(
    const acoustics::soundField& sound,
    const domain& region,
    const equationOfMotion& motion,
    encounterFinder& finder,
    stepCounters& counters
)
:
    sound_(sound),
    domain_(region),
    motion_(motion),
    finder_(finder),
    counters_(counters),
    running_(false),
    pause_(0),
    lastPause_(0),
    response_(0),
    first_{0, 0, 0},
    every_(1),
    exchange_(region),
    contacts_(region),
    wakes_(region)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::optional<Foam::aerosol::commonStep>
Foam::aerosol::lookAhead::gas(const fluidStep& step) const
{
    const auto u0 = sound_.commonAt(step.t);

    if
    (
        !u0
     || u0->nOfSound > mostHarmonics
     || motion_.noise().active()
     || motion_.unsteady().active()
    )
    {
        return std::nullopt;
    }

    const auto um = sound_.commonAt(step.t + 0.5*step.h);
    const auto u1 = sound_.commonAt(step.t + step.h);

    // The real and the imaginary part of the response move them
    const scalar omega = 2*EIGEN_PI*sound_.frequency();
    const Eigen::Vector3d displacement =
        response_.real()*(step.h/6*(u0->u + 4*um->u + u1->u))
      + response_.imag()*((u1->u - u0->u)/omega);

    // Velocities, by the parabola
    const Eigen::Vector3d begin =
        response_.real()*u0->u
      + response_.imag()/(step.h*omega)*(4*um->u - 3*u0->u - u1->u);
    const Eigen::Vector3d end =
        response_.real()*u1->u
      + response_.imag()/(step.h*omega)*(3*u1->u - 4*um->u + u0->u);

    return commonStep{*u0, *um, *u1, displacement, begin, end};
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::optional<Eigen::Vector3d> Foam::aerosol::lookAhead::displacement
(
    const particleArrays& p,
    const fluidStep& step
)
{
    if (!sound_.commonAt(step.t))
    {
        return std::nullopt;
    }

    vectors parts = vectors::Zero(3, p.size());
    parts.row(0) = p.response.real().matrix().transpose();
    parts.row(1) = p.response.imag().matrix().transpose();

    const Eigen::Vector3d mean = communicator::mean(parts);
    response_ = {mean(0), mean(1)};

    const auto common = gas(step);

    return
        common ? std::optional<Eigen::Vector3d>(common->displacement)
      : std::nullopt;
}


int Foam::aerosol::lookAhead::every(const fluidStep& step) const
{
    const scalar steps = 1/(intervals*sound_.frequency()*step.h) + 0.01;

    return static_cast<int>(std::min(std::max(steps, 1.0), longestInterval));
}


int Foam::aerosol::lookAhead::nSteps(const fluidStep& step) const
{
    return
        every(step)
       *(motion_.wakes().active() ? aheadInWakes : aheadWithout);
}


bool Foam::aerosol::lookAhead::begin
(
    const particleArrays& p,
    const fluidStep& first
)
{
    first_ = first;
    every_ = every(first);
    expected_.clear();
    done_.clear();

    fluidStep step = first;

    for (int m = 0; m < nSteps(first); ++m)
    {
        const auto common = gas(step);

        if (!common)
        {
            return false;
        }

        expected_.push_back(*common);
        ++step.index;
        step.t += step.h;
    }

    motion_.exact().moveAlone
    (
        first.h, p, expected_, every_, p.x, p.v, x_, v_, furthest_, bulge_
    );

    running_ = separate(p);

    return running_;
}


bool Foam::aerosol::lookAhead::expected(const fluidStep& step) const
{
    const auto now = gas(step);

    if (!now || step.h != first_.h)
    {
        return false;
    }

    const commonStep& then = expected_[done_.size()];
    const double scale =
        rounding
       *std::max({now->u0.u.norm(), now->um.u.norm(), now->u1.u.norm()});

    const auto alike =
    [&]
    (
        const acoustics::commonVelocity& a,
        const acoustics::commonVelocity& b
    )
    {
        return
            (a.u - b.u).norm() <= scale
         && (
                a.nHarmonics() != b.nHarmonics()
              ? std::max(a.oscillation.norm(), b.oscillation.norm()) <= scale
              : (a.oscillation - b.oscillation).norm() <= scale
            );
    };

    return
        alike(now->u0, then.u0)
     && alike(now->um, then.um)
     && alike(now->u1, then.u1);
}


void Foam::aerosol::lookAhead::beginStep
(
    const fluidStep& step,
    const stepEnd& alone
)
{
    done_.push_back(*gas(step));
    aloneX_ = alone.x;
    aloneV_ = alone.v;
}


bool Foam::aerosol::lookAhead::within
(
    const vectors& x,
    const vectors& v,
    scalars& strayed,
    scalars& strayedSpeed
) const
{
    const double h = first_.h;

    // Two particles in the same gas come no further apart than their
    // velocities, which drag makes alike
    strayed =
        strayed_ + h*strayedSpeed_
      + (x - aloneX_).colwise().norm().transpose().array();
    strayedSpeed =
        strayedSpeed_/(1 + h*busy_.rate)
      + (v - aloneV_).colwise().norm().transpose().array();

    return
       !(perDistance*strayed + perStep*h*strayedSpeed > allowance_).any();
}


bool Foam::aerosol::lookAhead::within(const stepEnd& end) const
{
    scalars strayed, strayedSpeed;

    return within(end.x, end.v, strayed, strayedSpeed);
}


bool Foam::aerosol::lookAhead::endStep
(
    const std::vector<int>& returned,
    const std::vector<char>& absorbed
)
{
    scalars strayed, strayedSpeed;
    const bool allowed = within(busy_.x, busy_.v, strayed, strayedSpeed);

    strayed_.swap(strayed);
    strayedSpeed_.swap(strayedSpeed);

    for (const int i : returned)
    {
        returned_[i] = 1;
    }

    bool ends = done_.size() == expected_.size();

    for (std::size_t i = 0; i < absorbed.size(); ++i)
    {
        if (absorbed[i])
        {
            absorbed_[i] = 1;
            ends = true;
        }
    }

    return allowed && !ends;
}


void Foam::aerosol::lookAhead::moveResting(particleArrays& all) const
{
    // The gas was what was expected, but for the rounding of times
    if (done_.size() == expected_.size())
    {
        all.x = x_.back();
        all.v = v_;
    }
    else if (done_.size())
    {
        std::vector<vectors> x;
        vectors v;
        scalars furthest, bulge;

        motion_.exact().moveAlone
        (
            first_.h, all, done_, static_cast<int>(done_.size()), all.x, all.v,
            x, v, furthest, bulge
        );
        all.x.swap(x[0]);
        all.v.swap(v);
    }

}


void Foam::aerosol::lookAhead::bring(particleArrays& all) const
{
    if (running_)
    {
        std::vector<char> returned, absorbed;

        moveResting(all);
        exchange_.give(busy_, returned_, absorbed_, all, returned, absorbed);
    }
}


Eigen::Vector3d Foam::aerosol::lookAhead::end
(
    particleArrays& all,
    std::vector<int>& returned,
    std::vector<char>& absorbed
)
{
    std::vector<char> marks;

    moveResting(all);
    exchange_.give(busy_, returned_, absorbed_, all, marks, absorbed);

    returned.clear();

    for (int i = 0; i < all.size(); ++i)
    {
        if (marks[i])
        {
            returned.push_back(i);
        }
    }

    Eigen::Vector3d moved = Eigen::Vector3d::Zero();
    for (const commonStep& step : done_)
    {
        moved += step.displacement;
    }

    counters_.looksAhead += 1;
    counters_.stepsAhead += done_.size();
    counters_.busyMoves += static_cast<double>(busy_.size())*done_.size();

    running_ = false;
    x_.clear();

    // It is worth while if many rest for long
    if
    (
        2*done_.size() < expected_.size()
     || communicator::sum(busy_.size() - largestShare*all.size()) > 0
    )
    {
        pause();
    }
    else
    {
        lastPause_ = 0;
    }

    return moved;
}


// ************************************************************************* //
