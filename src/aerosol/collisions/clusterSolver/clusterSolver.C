/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clusterSolver.H"
#include "BrownianClusterSolver.H"
#include "neighbourWakes.H"
#include "randomBlock.H"

#include <algorithm>
#include <cmath>
#include <set>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::clusterSolver::clusterSolver
(
    const equationOfMotion& motion,
    collisions& meetings,
    const Eigen::Array3d& period,
    stepCounters& counters
)
:
    motion_(motion),
    collisions_(meetings),
    period_(period),
    counters_(counters)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::pair<Foam::scalar, int> Foam::aerosol::clusterSolver::firstContact
(
    const cluster& one,
    const stepEnd& end,
    const scalar h,
    const int nCollision,
    const std::vector<char>& leftOut
) const
{
    const particleArrays& p = one.p;

    std::pair<scalar, int> first(GREAT, -1);

    for (std::size_t k = 0; k < one.contactPairs.size(); ++k)
    {
        if (leftOut[k])
        {
            continue;
        }

        const particlePair& pair = one.contactPairs[k];
        const int i = pair.i;
        const int j = pair.j;

        const particlePath a
        (
            p.x.col(i), p.v.col(i), end.x.col(i), end.v.col(i), h
        );
        const particlePath b
        (
            p.x.col(j) + shift(pair), p.v.col(j),
            end.x.col(j) + shift(pair), end.v.col(j), h
        );
        const double touch =
            0.5*(p.collisionDiameter(i) + p.collisionDiameter(j));

        if (a.staysAwayFrom(b, touch))
        {
            continue;
        }

        // A pair that has just bounced is in contact, and may meet again
        const scalar when =
            collisions_.bounces()
          ? particlePath::firstApproach(a, b, touch)
          : contactTime(a, b, p.id(i), p.id(j), touch, h, nCollision);

        // The first of the list if there are more at the same time
        if (when <= h && when < first.first)
        {
            first = {when, static_cast<int>(k)};
        }
    }

    return first;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::aerosol::stepValues Foam::aerosol::clusterSolver::outsideWakes
(
    const cluster& one,
    const std::vector<particlePair>& wakePairs,
    const scalar h
) const
{
    stepValues outside;

    if (!motion_.wakes().active())
    {
        return outside;
    }

    // All less those from inside
    const auto less =
    [&]
    (
        const vectors& w,
        const vectors& x,
        const vectors& slip,
        const scalar s
    )
    {
        vectors inside;
        motion_.wakes().sum
        (
            {
                x, slip, one.p.mobilityDiameter, one.p.range,
                motion_.wakes().settling(one.p),
                motion_.wakes().imaginarySlip(one.p.rate, one.gas, s, h)
            },
            wakePairs,
            one.p.size(),
            inside
        );

        return vectors(w - inside);
    };

    outside.u0 = less(one.wakes.u0, one.x.u0, one.slip.u0, 0);
    outside.u1 = less(one.wakes.u1, one.x.u1, one.slip.u1, 1);

    if (one.wakes.um.cols())
    {
        outside.um = less(one.wakes.um, one.x.um, one.slip.um, 0.5);
    }

    return outside;
}


std::vector<Foam::aerosol::particlePair>
Foam::aerosol::clusterSolver::bothWays(const std::vector<particlePair>& pairs)
{
    std::vector<particlePair> both;

    for (const particlePair& pair : pairs)
    {
        both.push_back(pair);
        both.push_back({pair.j, pair.i, reversed(pair.image)});
    }

    return both;
}


Foam::scalar Foam::aerosol::clusterSolver::contactTime
(
    const particlePath& a,
    const particlePath& b,
    const std::int64_t idI,
    const std::int64_t idJ,
    const scalar touch,
    const scalar h,
    const int nCollision
) const
{
    // A pair that touched without sticking must separate before it touches
    // again
    const bool onlyNew = collisions_.refused(idI, idJ);

    return
        nCollision > 0
      ? particlePath::firstOverlap(a, b, touch, h/nCollision, onlyNew)
      : particlePath::firstTouch(a, b, touch, onlyNew);
}


Foam::aerosol::contactOutcome::encounter
Foam::aerosol::clusterSolver::encounterOf
(
    const particlePair& pair,
    const meetingPoint& where,
    const fluidStep& step,
    const scalar time,
    const std::uint64_t count
) const
{
    contactOutcome::encounter encounter;

    encounter.i = pair.i;
    encounter.j = pair.j;
    encounter.shift = shift(pair);
    encounter.xi = where.xi;
    encounter.xj = where.xj + encounter.shift;
    encounter.vi = where.vi;
    encounter.vj = where.vj;
    encounter.time = time;
    encounter.step = step.index;
    encounter.number = randomBlock(noise::whole, step.part, count);

    return encounter;
}


void Foam::aerosol::clusterSolver::redirect
(
    std::vector<particlePair>& pairs,
    const int survivor,
    const int absorbed,
    const periods& image
)
{
    // Pairs of the absorbed one become pairs of the survivor, which is where
    // the absorbed one's ghost at `image` was
    for (particlePair& pair : pairs)
    {
        for (int k = 0; k < 3; ++k)
        {
            if (pair.i == absorbed)
            {
                pair.image[k] += image[k];
            }
            if (pair.j == absorbed)
            {
                pair.image[k] -= image[k];
            }
        }

        if (pair.i == absorbed)
        {
            pair.i = survivor;
        }
        if (pair.j == absorbed)
        {
            pair.j = survivor;
        }
    }

    // The neighbours of both are now listed twice; in a small domain, one may
    // be a neighbour in more than one image
    std::vector<particlePair> kept;
    std::set<std::pair<int, periods>> known;

    for (const particlePair& pair : pairs)
    {
        const bool isNew =
            pair.i == survivor
          ? known.insert({pair.j, pair.image}).second
          : pair.j != survivor
         || known.insert({pair.i, reversed(pair.image)}).second;

        if (pair.i != pair.j && isNew)
        {
            kept.push_back(pair);
        }
    }

    pairs.swap(kept);
}


void Foam::aerosol::clusterSolver::replaceAbsorbed
(
    std::vector<particlePair>& pairs,
    const particlePair& met,
    const int survivor
)
{
    const bool iSurvives = survivor == met.i;

    redirect
    (
        pairs,
        survivor,
        iSurvives ? met.j : met.i,
        iSurvives ? met.image : reversed(met.image)
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::unique_ptr<Foam::aerosol::clusterSolver>
Foam::aerosol::clusterSolver::New
(
    const equationOfMotion& motion,
    collisions& meetings,
    const Eigen::Array3d& period,
    stepCounters& counters
)
{
    if (motion.noise().active())
    {
        return std::make_unique<BrownianClusterSolver>
        (
            motion, meetings, period, counters
        );
    }

    return std::make_unique<clusterSolver>(motion, meetings, period, counters);
}


void Foam::aerosol::clusterSolver::solve
(
    cluster& one,
    const fluidStep& step,
    const int nCollision
)
{
    // Gap below which two particles count as touching, relative to the distance
    // of contact
    constexpr double closed = 1e-10;

    const scalar h = step.h;
    particleArrays& p = one.p;
    const scalar longest = h/one.nSteps;

    std::vector<particlePair> wakePairs = bothWays(one.contactPairs);
    const stepValues outside = outsideWakes(one, wakePairs, h);

    stepEnd end;
    std::vector<char> leftOut(one.contactPairs.size(), 0);
    scalar now = 0;
    std::uint64_t nContacts = 0;

    const auto moveOver = [&](const scalar length, stepEnd& to)
    {
        motion_.inWakes().moveTogether
        (
            length,
            p,
            wakePairs,
            one.gas.part(now/h, (now + length)/h),
            outside.part(now/h, (now + length)/h),
            wakeStep::nIterations,
            to
        );
        counters_.clusterMoves += p.size();
    };

    while (h - now > 1e-9*longest)
    {
        const scalar length =
            (h - now)/std::ceil((h - now)/longest - 1e-9);

        moveOver(length, end);

        const auto found = firstContact(one, end, length, nCollision, leftOut);

        if (found.second < 0)
        {
            p.x.swap(end.x);
            p.v.swap(end.v);
            now += length;
            std::fill(leftOut.begin(), leftOut.end(), 0);
            continue;
        }

        // To the contact, by the motion itself rather than by its path
        const particlePair pair = one.contactPairs[found.second];
        const double touch =
            0.5*(p.collisionDiameter(pair.i) + p.collisionDiameter(pair.j));
        scalar when = found.first;

        // A time at which they overlap and come closer, if there is one
        scalar closing = -1;

        // The gap between their surfaces at `end` [m], and its rate [m/s]
        const auto gapAndRate = [&]()
        {
            const Eigen::Vector3d r =
                end.x.col(pair.j) + shift(pair) - end.x.col(pair.i);

            return std::pair<double, double>
            (
                r.norm() - touch,
                (end.v.col(pair.j) - end.v.col(pair.i)).dot(r)/r.norm()
            );
        };

        const auto moveTo = [&](const scalar time)
        {
            if (time > 1e-9*longest)
            {
                moveOver(time, end);
            }
            else
            {
                end.x = p.x;
                end.v = p.v;
            }
        };

        for (int n = 0; n < 5 && when > 1e-9*longest; ++n)
        {
            moveOver(when, end);

            const auto [gap, rate] = gapAndRate();

            if (std::abs(gap) < closed*touch || rate >= 0)
            {
                break;
            }
            if (gap < 0)
            {
                closing = when;
            }

            when = std::min(std::max(when - gap/rate, 0.0), length);
        }

        if (when <= 1e-9*longest)
        {
            when = 0;
        }

        moveTo(when);

        // Two that overlap, separate and turn round have no gap that closes:
        // they meet where they turn round
        if (collisions_.bounces() && when < closing && gapAndRate().second >= 0)
        {
            scalar apart = when;
            when = closing;

            for (int n = 0; n < 40; ++n)
            {
                const scalar half = 0.5*(apart + when);

                moveTo(half);

                const auto [gap, rate] = gapAndRate();

                (gap < 0 && rate < 0 ? when : apart) = half;
            }

            moveTo(when);
        }

        const contactOutcome::encounter encounter = encounterOf
        (
            pair,
            {
                end.x.col(pair.i), end.x.col(pair.j),
                end.v.col(pair.i), end.v.col(pair.j)
            },
            step,
            step.t + now + when,
            nContacts++
        );

        // In contact on its path, but by its motion only nearly so
        if (collisions_.bounces() && encounter.approach() <= 0)
        {
            leftOut[found.second] = 1;
            continue;
        }

        const int survivor = collisions_.meet(p, encounter);

        if (survivor == collisions::passed)
        {
            leftOut[found.second] = 1;
            continue;
        }

        if (survivor == collisions::bounced)
        {
            end.v.col(pair.i) = p.v.col(pair.i);
            end.v.col(pair.j) = p.v.col(pair.j);
            p.x.swap(end.x);
            p.v.swap(end.v);
            now += when;
            continue;
        }

        // All go on from there
        const Eigen::Vector3d xs = p.x.col(survivor);
        const Eigen::Vector3d vs = p.v.col(survivor);

        p.x.swap(end.x);
        p.v.swap(end.v);
        p.x.col(survivor) = xs;
        p.v.col(survivor) = vs;
        now += when;

        motion_.laws().refresh(p, survivor);

        replaceAbsorbed(one.contactPairs, pair, survivor);
        wakePairs = bothWays(one.contactPairs);
        leftOut.assign(one.contactPairs.size(), 0);
    }

    one.absorbed = collisions_.takeAbsorbed(p.size());
}


// ************************************************************************* //
