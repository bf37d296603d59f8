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
    const scalars& room
)
{
    wakePairs_.clear();

    if (!with_.motion.hasWakes())
    {
        return;
    }

    const bool mutual = room.size();

    scalars reaches = mutual ? scalars(reach.max(room)) : reach;
    scalars rooms = room;
    scalars id = p.id.cast<double>();

    wakeHalo_.build(x, reaches, mutual);

    std::vector<halo::quantity> quantities
    {
        {x, wakeHalo_, true}, {reaches, wakeHalo_}, {id, wakeHalo_}
    };
    if (mutual)
    {
        quantities.push_back({rooms, wakeHalo_});
    }
    wakeHalo_.fill(quantities);

    grid_.build(x, reaches);

    if (mutual)
    {
        grid_.acting(p.size(), id, rooms, wakePairs_);
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

    // Only those copies that somebody feels
    std::vector<char> felt(wakeHalo_.nCopies(), 0);

    for (const particlePair& pair : wakePairs_)
    {
        if (pair.j >= n)
        {
            felt[pair.j - n] = 1;
        }
    }

    const std::vector<int> copies = wakeHalo_.keep(felt);

    std::vector<char> marks = wakeHalo_.sent();

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
            pair.j < n ? place_[pair.j] : nInvolved + copies[pair.j - n];
    }

    wakeHalo_.renumber(place_, nInvolved);

    sources_.x.resize(3, wakeHalo_.size());
    sources_.slip.resize(3, wakeHalo_.size());

    sources_.d = p.mobility(involved_);
    sources_.range = p.range(involved_);

    std::vector<halo::quantity> quantities
    {
        {sources_.d, wakeHalo_}, {sources_.range, wakeHalo_}
    };

    if (with_.motion.wakeModel().omega() > 0)
    {
        const vectors all = with_.motion.settling(p);
        sources_.steady.resize(3, wakeHalo_.size());
        sources_.steady.leftCols(nInvolved) = all(Eigen::all, involved_);
        quantities.push_back({sources_.steady, wakeHalo_, false});
    }

    wakeHalo_.fill(quantities);
}


void Foam::aerosol::timeStepping::wakesAt
(
    const vectors& x,
    const vectors& v,
    const vectors& u,
    const vectors& quadrature,
    vectors& keptX,
    vectors& keptSlip,
    vectors& w
)
{
    keptX = x;
    keptSlip = u - v;
    sources_.x.leftCols(x.cols()) = keptX;
    sources_.slip.leftCols(x.cols()) = keptSlip;

    std::vector<halo::quantity> quantities
    {
        {sources_.x, wakeHalo_, true},
        {sources_.slip, wakeHalo_, false}
    };

    // Also where nobody is involved: all ranks exchange the same
    if (with_.motion.wakeModel().omega() > 0)
    {
        sources_.quadrature.resize(3, sources_.x.cols());
        sources_.quadrature.leftCols(x.cols()) = quadrature;
        quantities.push_back({sources_.quadrature, wakeHalo_, false});
    }

    wakeHalo_.fill(quantities);

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

    motion.kick(h, p, step_, block(noise::whole, part), end.kick);

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

    commonWay_ = h*bricks::mean((end.x - p.x)/h);
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
    there.kick = {select(end.kick.v), select(end.kick.x)};

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
            x, v, u, motion.quadrature(q.rate, air, s, h),
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
