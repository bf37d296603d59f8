/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The part of timeStepping that follows clusters in Brownian motion.

    The noise of each part of a step is known in advance: which particles form a
    cluster depends on it. Ending the part for the whole cluster at a merger
    would discard the remaining noise of all members, and with it their known
    ends: contact rates in large clusters come out too low by up to a third. So
    only merged particles get new noise, and a new path.

\*---------------------------------------------------------------------------*/

#include "timeStepping.H"

#include <cmath>
#include <queue>
#include <tuple>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A contact found on the paths of a pair
struct meeting
{
    double time;
    std::int64_t idI;
    std::int64_t idJ;
    Foam::aerosol::particlePair pair;

    //- How often the paths of both had changed when it was found
    int age;

    //- Earliest first; at the same time in the order of the ids
    bool operator<(const meeting& b) const
    {
        return
            std::tie(time, idI, idJ) > std::tie(b.time, b.idI, b.idJ);
    }
};

//- More parts than a step can have: makes numbers of the part, and of the
//  mergers in it, one number
constexpr std::uint64_t manyParts = 4096;

} // End anonymous namespace


// * * * * * * * * * * * * * * * Private Classes * * * * * * * * * * * * * * //

struct Foam::aerosol::timeStepping::BrownianCluster
{
    cluster& one;

    //- Pairs (i, j), j acts on i by its wake
    std::vector<particlePair> wakePairs;

    //- Gas and wakes from outside in this part
    gasStep gas;
    gasStep outside;

    //- The end of the part
    equationOfMotion::state end;

    //- When the paths of the members begin within the part: 0, or the time of
    //  the merger [s]
    std::vector<double> begin;

    //- How often they have changed in the part
    std::vector<int> age;

    //- Whether they have in this part or before
    std::vector<char> grown;

    //- How far they stray, per time [m2/s]
    scalars stray;

    //- Mergers in all parts
    std::uint64_t nMergers;
};


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::timeStepping::moveOn
(
    BrownianCluster& all,
    const int i,
    const scalar when,
    const scalar h,
    const std::uint64_t randomBlock
)
{
    const equationOfMotion& motion = with_.motion;
    particleArrays& p = all.one.p;
    equationOfMotion::state& end = all.end;

    const scalar left = h - when;
    const particleArrays single = p.select({i});

    all.begin[i] = when;

    // At the very end of the part there is nothing left
    if (left <= 1e-9*h)
    {
        end.x.col(i) = p.x.col(i);
        end.v.col(i) = p.v.col(i);
        end.thermal.col(i) = p.thermal.col(i);
        end.path0.col(i) = p.v.col(i);
        end.path1.col(i) = p.v.col(i);
        all.stray(i) = 0;
        return;
    }

    gasStep gas = all.gas.part(when/h, 1);
    for (vectors* u : {&gas.u0, &gas.um, &gas.u1})
    {
        if (u->cols())
        {
            *u = vectors(u->col(i));
        }
    }

    equationOfMotion::state there;
    motion.increment(left, single, step_, randomBlock, there.increment);

    gasStep w;

    if (motion.hasWakes())
    {
        std::vector<particlePair> acting;
        vectors x = p.x;
        vectors v = motion.drift(p.v, p.thermal);

        for (const particlePair& pair : all.wakePairs)
        {
            if (pair.i == i)
            {
                const int j = pair.j;
                const scalar since = when - all.begin[j];
                const scalar length = h - all.begin[j];
                const scalar s = length > 0 ? since/length : 1;

                acting.push_back(pair);
                x.col(j) = pathOfOwn(p, end, j, length).position(since);
                v.col(j) =
                    (1 - s)*v.col(j) + s*(end.v.col(j) - end.thermal.col(j));
            }
        }

        const auto wakesAt =
        [&]
        (
            const scalar s,
            const vectors& places,
            const vectors& drifts,
            vectors& result
        )
        {
            vectors found;
            motion.wakes
            (
                p, acting, places, drifts, all.gas.at(s), found,
                motion.imaginarySlip(p.rate, all.gas, s, h)
            );
            result = found.col(i);

            if (all.outside.u0.cols())
            {
                result += all.outside.at(s).col(i);
            }
        };

        wakesAt(when/h, x, v, w.u0);
        motion.move(left, single, gas, w, false, there);
        motion.cool(left, single, there);

        x = end.x;
        v = motion.drift(end.v, end.thermal);
        x.col(i) = there.x.col(0);
        v.col(i) = there.v.col(0) - there.thermal.col(0);

        wakesAt(1, x, v, w.u1);
    }
    else
    {
        motion.move(left, single, gas, w, false, there);
    }

    if (motion.hasWakes() || !motion.linear())
    {
        motion.move(left, single, gas, w, true, there);
    }

    motion.split(left, single, there);

    end.x.col(i) = there.x.col(0);
    end.v.col(i) = there.v.col(0);
    end.thermal.col(i) = there.thermal.col(0);
    end.path0.col(i) = there.path0.col(0);
    end.path1.col(i) = there.path1.col(0);

    all.stray(i) = motion.reach(left, single).stray(0)/left;
    ++effort_.clusterMoves;
}


void Foam::aerosol::timeStepping::collide
(
    BrownianCluster& all,
    const scalar t,
    const scalar h,
    const int nCollision,
    const int part,
    const int s
)
{
    cluster& one = all.one;
    particleArrays& p = one.p;
    equationOfMotion::state& end = all.end;

    all.begin.assign(p.size(), 0);
    all.age.assign(p.size(), 0);
    all.stray = with_.motion.reach(h, p).stray/h;

    const auto pathFrom = [&](const int i, const scalar first)
    {
        const scalar begin = all.begin[i];
        const particlePath path = pathOfOwn(p, end, i, h - begin);

        return first > begin ? path.rest(first - begin) : path;
    };

    // Linear in time between the ends of its path
    const auto between =
    [&]
    (
        const int i,
        const scalar when,
        const vectors& v0,
        const vectors& v1
    )
    {
        const scalar begin = all.begin[i];
        const scalar r = h > begin ? (when - begin)/(h - begin) : 1;

        return Eigen::Vector3d((1 - r)*v0.col(i) + r*v1.col(i));
    };

    const auto ageOf = [&](const particlePair& pair)
    {
        return all.age[pair.i] + all.age[pair.j];
    };

    std::priority_queue<meeting> queue;
    std::uint64_t nContacts = manyParts*s;

    // The first contact of a pair from the given time on
    const auto look = [&](const particlePair& pair, const scalar first)
    {
        const int i = pair.i;
        const int j = pair.j;
        const scalar length = h - first;

        if
        (
            with_.collisions.absorbed(i)
         || with_.collisions.absorbed(j)
         || length <= 1e-9*h
        )
        {
            return;
        }

        const particlePath a = pathFrom(i, first);
        const particlePath b = pathFrom(j, first).moved(shift(pair));
        const double touch =
            0.5*(p.collisionDiameter(i) + p.collisionDiameter(j));
        const double variance = (all.stray(i) + all.stray(j))*length;

        if (a.staysAwayFrom(b, touch + nDeviations*std::sqrt(variance)))
        {
            return;
        }

        // A pair that touched without sticking must separate before it touches
        // again
        const bool onlyNew = with_.collisions.refused(p.id(i), p.id(j));

        scalar when =
            nCollision > 0
          ? particlePath::firstOverlap(a, b, touch, h/nCollision, onlyNew)
          : particlePath::firstTouch(a, b, touch, onlyNew);

        if (when > length)
        {
            const double gap0 =
                (b.position(0) - a.position(0)).norm() - touch;
            const double gap1 =
                (b.position(length) - a.position(length)).norm() - touch;

            if
            (
                crosses
                (
                    p.id(i), p.id(j), gap0, gap1, variance,
                    block(noise::whole, part, s + manyParts*ageOf(pair))
                )
            )
            {
                when = gap0/(gap0 + gap1)*length;
            }
        }

        if (when <= length)
        {
            queue.push
            ({
                first + when, p.id(i), p.id(j), pair, ageOf(pair)
            });
        }
    };

    for (const particlePair& pair : one.contactPairs)
    {
        look(pair, 0);
    }

    while (!queue.empty())
    {
        const meeting found = queue.top();
        queue.pop();

        const int i = found.pair.i;
        const int j = found.pair.j;
        const scalar when = found.time;

        if
        (
            with_.collisions.absorbed(i)
         || with_.collisions.absorbed(j)
         || found.age != ageOf(found.pair)
        )
        {
            continue;
        }

        contactOutcome::encounter encounter;
        encounter.i = i;
        encounter.j = j;
        encounter.shift = shift(found.pair);
        encounter.xi = pathFrom(i, when).position(0);
        encounter.xj = pathFrom(j, when).position(0) + encounter.shift;
        encounter.vi = between(i, when, p.v, end.v);
        encounter.vj = between(j, when, p.v, end.v);
        encounter.time = t + when;
        encounter.step = step_;
        encounter.number = block(noise::whole, part, nContacts++);

        const Eigen::Vector3d thermal =
        (
            p.m(i)*between(i, when, p.thermal, end.thermal)
          + p.m(j)*between(j, when, p.thermal, end.thermal)
        )/(p.m(i) + p.m(j));

        const int survivor = with_.collisions.meet(p, encounter);

        if (survivor < 0)
        {
            continue;
        }

        p.thermal.col(survivor) = thermal;
        with_.motion.refresh(p, survivor);

        periods image = found.pair.image;
        if (survivor == j)
        {
            for (std::int8_t& n : image)
            {
                n = -n;
            }
        }

        redirect(one.contactPairs, survivor, survivor == i ? j : i, image);
        if (with_.motion.hasWakes())
        {
            all.wakePairs = bothWays(one.contactPairs);
        }

        ++all.age[survivor];
        all.grown[survivor] = 1;

        moveOn
        (
            all, survivor, when, h, block(noise::rest, part, ++all.nMergers)
        );

        for (const particlePair& pair : one.contactPairs)
        {
            if (pair.i == survivor || pair.j == survivor)
            {
                look(pair, when);
            }
        }
    }
}


void Foam::aerosol::timeStepping::followBrownian
(
    cluster& one,
    const scalar t,
    const scalar h,
    const int nCollision,
    const int part
)
{
    particleArrays& p = one.p;

    const int n = one.nSteps;
    const scalar length = h/n;

    BrownianCluster all
    {
        one, bothWays(one.contactPairs), {}, {}, {}, {}, {},
        std::vector<char>(p.size(), 0), {}, 0
    };

    const gasStep outside = outsideWakes(one, all.wakePairs, h);

    // The noise of a step of one part is known, to the last bit
    std::vector<Brownian::increments> increments(1, one.increment);

    if (n > 1)
    {
        with_.motion.bridge
        (
            h, p, step_, block(noise::parts, part), n, one.increment, increments
        );
    }

    for (int s = 0; s < n; ++s)
    {
        all.gas = one.gas.part(scalar(s)/n, scalar(s + 1)/n);
        all.outside = outside.part(scalar(s)/n, scalar(s + 1)/n);
        all.end.increment = increments[s];

        // Merged particles move on with noise of their own
        for (int i = 0; i < p.size(); ++i)
        {
            if (all.grown[i])
            {
                Brownian::increments own;
                with_.motion.increment
                (
                    length, p.select({i}), step_,
                    block(noise::grown, part, s), own
                );

                all.end.increment.v.col(i) = own.v.col(0);
                all.end.increment.x.col(i) = own.x.col(0);
            }
        }

        with_.motion.step
        (
            length, p, all.wakePairs, all.gas, all.outside, nIterations,
            all.end
        );
        effort_.clusterMoves += p.size();

        collide(all, t + s*length, length, nCollision, part, s);

        with_.motion.arrive(p, all.end);
    }

    one.absorbed = with_.collisions.takeAbsorbed(p.size());
}


// ************************************************************************* //
