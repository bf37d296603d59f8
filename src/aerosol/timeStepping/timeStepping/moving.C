/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The part of timeStepping that moves all particles, in the wakes of those
    that are within range.

\*---------------------------------------------------------------------------*/

#include "timeStepping.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Particles that are moved together
constexpr int runLength = 512;

} // End anonymous namespace


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::aerosol::timeStepping::searchWakes
(
    const particleArrays& p,
    vectors x,
    const scalars& reach,
    const scalars& skin
)
{
    wakePairs_.clear();

    if (!with_.motion.hasWakes())
    {
        return;
    }

    const bool mutual = skin.size();

    scalars reaches = mutual ? scalars(reach.max(skin)) : reach;
    scalars skins = skin;
    scalars id = p.id.cast<double>();

    wakeGhosts_.build(x, reaches, mutual);

    std::vector<ghosts::quantity> quantities
    {
        {x, wakeGhosts_, true}, {reaches, wakeGhosts_}, {id, wakeGhosts_}
    };
    if (mutual)
    {
        quantities.push_back({skins, wakeGhosts_});
    }
    wakeGhosts_.fill(quantities);

    grid_.build(x, reaches);

    if (mutual)
    {
        grid_.acting(p.size(), id, skins, wakePairs_);
    }
    else
    {
        grid_.acting(p.size(), id, wakePairs_);
    }
}


void Foam::aerosol::timeStepping::involve(const particleArrays& p)
{
    involved_.clear();

    if (!with_.motion.hasWakes())
    {
        return;
    }

    effort_.wakePairs += wakePairs_.size();

    const int n = p.size();

    // Only those ghosts that act on a particle
    std::vector<char> felt(wakeGhosts_.nGhosts(), 0);

    for (const particlePair& pair : wakePairs_)
    {
        if (pair.j >= n)
        {
            felt[pair.j - n] = 1;
        }
    }

    const std::vector<int> kept = wakeGhosts_.keep(felt);

    std::vector<char> marks = wakeGhosts_.sent();

    for (const particlePair& pair : wakePairs_)
    {
        marks[pair.i] = 1;

        if (pair.j < n)
        {
            marks[pair.j] = 1;
        }
    }

    place_.assign(n, -1);

    for (int i = 0; i < n; ++i)
    {
        if (marks[i])
        {
            place_[i] = static_cast<int>(involved_.size());
            involved_.push_back(i);
        }
    }

    // From now on by their places
    const int nInvolved = static_cast<int>(involved_.size());

    for (particlePair& pair : wakePairs_)
    {
        pair.i = place_[pair.i];
        pair.j =
            pair.j < n ? place_[pair.j] : nInvolved + kept[pair.j - n];
    }

    wakeGhosts_.renumber(place_, nInvolved);

    sources_.x.resize(3, wakeGhosts_.size());
    sources_.slip.resize(3, wakeGhosts_.size());

    sources_.d = p.mobilityDiameter(involved_);
    sources_.range = p.range(involved_);

    std::vector<ghosts::quantity> quantities
    {
        {sources_.d, wakeGhosts_}, {sources_.range, wakeGhosts_}
    };

    if (with_.motion.wakeModel().omega() > 0)
    {
        const vectors all = with_.motion.settling(p);
        sources_.steady.resize(3, wakeGhosts_.size());
        sources_.steady.leftCols(nInvolved) = all(Eigen::all, involved_);
        quantities.push_back({sources_.steady, wakeGhosts_, false});
    }

    wakeGhosts_.fill(quantities);
}


void Foam::aerosol::timeStepping::wakesAt
(
    const vectors& x,
    const vectors& v,
    const vectors& u,
    const vectors& imaginary,
    vectors& keptX,
    vectors& keptSlip,
    vectors& w
)
{
    keptX = x;
    keptSlip = u - v;
    sources_.x.leftCols(x.cols()) = keptX;
    sources_.slip.leftCols(x.cols()) = keptSlip;

    std::vector<ghosts::quantity> quantities
    {
        {sources_.x, wakeGhosts_, true},
        {sources_.slip, wakeGhosts_, false}
    };

    // Also on ranks without wakes: all ranks exchange the same quantities
    if (with_.motion.wakeModel().omega() > 0)
    {
        sources_.imaginary.resize(3, sources_.x.cols());
        sources_.imaginary.leftCols(x.cols()) = imaginary;
        quantities.push_back({sources_.imaginary, wakeGhosts_, false});
    }

    wakeGhosts_.fill(quantities);

    with_.motion.wakes(sources_, wakePairs_, x.cols(), w);
}


void Foam::aerosol::timeStepping::inRuns
(
    const particleArrays& p,
    const std::function<void(const int first, const int size)>& task
)
{
    for (int first = 0; first < p.size(); first += runLength)
    {
        task(first, std::min(runLength, p.size() - first));
    }
}


void Foam::aerosol::timeStepping::moveWithoutWakes
(
    const scalar h,
    const particleArrays& p,
    const gasOfStep& gas,
    const int part,
    equationOfMotion::state& end
)
{
    const equationOfMotion& motion = with_.motion;

    ++effort_.particleSteps;
    effort_.particleMoves += p.size();

    motion.increment(h, p, step_, block(noise::whole, part), end.increment);

    // Also where there are none, or none any more
    end.x.resize(3, p.size());
    end.v.resize(3, p.size());

    inRuns
    (
        p,
        [&](const int first, const int size)
        {
            const gasStep air = gas.run(first, size);

            motion.move(h, p, air, {}, false, end, first);

            if (!motion.linear())
            {
                motion.move(h, p, air, {}, true, end, first);
            }
        }
    );

    meanDisplacement_ = h*communicator::mean((end.x - p.x)/h);
}


void Foam::aerosol::timeStepping::moveInWakes
(
    const scalar h,
    const particleArrays& p,
    const gasOfStep& gas,
    const bool withMiddle,
    equationOfMotion::state& end
)
{
    const equationOfMotion& motion = with_.motion;

    if (!motion.hasWakes())
    {
        motion.split(h, p, end);
        return;
    }

    gasStep& w = wakes_;
    withMiddle_ = withMiddle;

    // Those involved, by themselves
    const auto select = [&](const vectors& all)
    {
        return
            all.cols() ? vectors(all(Eigen::all, involved_))
          : vectors(3, 0);
    };

    const particleArrays q = p.select(involved_);
    const gasStep air = gas.some(involved_);

    equationOfMotion::state there;
    there.increment = {select(end.increment.v), select(end.increment.x)};

    // The thermal velocity at the end is that of drag and noise alone
    motion.cool(h, q, there);

    const auto wakesOf =
    [&]
    (
        const scalar s,
        const vectors& x,
        const vectors& v,
        const vectors& u,
        vectors& result
    )
    {
        const auto part = [&](gasStep& all) -> vectors&
        {
            return s == 0 ? all.u0 : s == 1 ? all.u1 : all.um;
        };

        wakesAt
        (
            x, v, u, motion.imaginarySlip(q.rate, air, s, h),
            part(wakesX_), part(wakesSlip_), result
        );
    };

    if (withMiddle)
    {
        motion.moveInWakes(h, q, air, wakesOf, nIterations, w, there);
    }
    else
    {
        w.um.resize(3, 0);
        w.u1.resize(3, 0);
        wakesX_.um.resize(3, 0);
        wakesSlip_.um.resize(3, 0);

        wakesOf(0, q.x, motion.drift(q.v, q.thermal), air.u0, w.u0);
        motion.move(h, q, air, w, false, there);
        wakesOf
        (
            1, there.x, motion.drift(there.v, there.thermal), air.u1, w.u1
        );
        motion.move(h, q, air, w, true, there);
    }

    for (std::size_t k = 0; k < involved_.size(); ++k)
    {
        end.x.col(involved_[k]) = there.x.col(k);
        end.v.col(involved_[k]) = there.v.col(k);
    }

    motion.split(h, p, end);
}


// ************************************************************************* //
