/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "BrownianClusterSolver.H"
#include "BrownianCrossing.H"
#include "neighbourWakes.H"
#include "randomBlock.H"
#include "relativeMotion.H"
#include "stepPaths.H"

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

struct Foam::aerosol::BrownianClusterSolver::part
{
    cluster& one;

    //- Pairs (i, j), j acts on i by its wake
    std::vector<particlePair> wakePairs;

    //- Gas and wakes from outside in this part
    stepValues gas;
    stepValues outside;

    //- The end of the part
    stepEnd end;

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

void Foam::aerosol::BrownianClusterSolver::moveOn
(
    part& all,
    const int i,
    const scalar when,
    const fluidStep& step
)
{
    ++all.nMergers;

    const equationOfMotion& motion = motion_;
    const scalar h = step.h;
    particleArrays& p = all.one.p;
    stepEnd& end = all.end;

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

    stepValues gas = all.gas.part(when/h, 1);
    for (vectors* u : {&gas.u0, &gas.um, &gas.u1})
    {
        if (u->cols())
        {
            *u = vectors(u->col(i));
        }
    }

    stepEnd there;
    motion.noise().increment
    (
        left,
        single,
        step.index,
        randomBlock(noise::rest, step.part, all.nMergers),
        there.increment
    );

    if (motion.wakes().active())
    {
        // The neighbours, at both ends
        std::vector<particlePair> acting;
        vectors x0 = p.x;
        vectors v0 = motion.noise().drift(p.v, p.thermal);
        const vectors v1 = motion.noise().drift(end.v, end.thermal);

        for (const particlePair& pair : all.wakePairs)
        {
            if (pair.i == i)
            {
                const int j = pair.j;
                const scalar since = when - all.begin[j];
                const scalar length = h - all.begin[j];
                const scalar s = length > 0 ? since/length : 1;

                acting.push_back(pair);
                x0.col(j) = stepPaths::own(p, end, j, length).position(since);
                v0.col(j) =
                    (1 - s)*v0.col(j) + s*(end.v.col(j) - end.thermal.col(j));
            }
        }

        const auto wakesAt =
        [&]
        (
            const scalar s,
            const vectors& x,
            const vectors& v,
            const vectors&,
            vectors& result
        )
        {
            const scalar ofPart = s > 0 ? 1 : when/h;
            vectors places = s > 0 ? end.x : x0;
            vectors drifts = s > 0 ? v1 : v0;
            places.col(i) = x.col(0);
            drifts.col(i) = v.col(0);

            vectors found;
            motion.wakes().sum
            (
                p, acting, places, drifts, all.gas.at(ofPart), found,
                motion.wakes().imaginarySlip(p.rate, all.gas, ofPart, h)
            );
            result = found.col(i);

            if (all.outside.u0.cols())
            {
                result += all.outside.at(ofPart).col(i);
            }
        };

        stepValues w;
        motion.noise().cool(left, single, there);
        motion.inWakes().move
        (
            left, single, gas, wakesAt, wakeStep::linear, w, there
        );
    }
    else
    {
        motion.exact().moveAlone(left, single, gas, there);
    }

    motion.noise().split(left, single, there);

    end.x.col(i) = there.x.col(0);
    end.v.col(i) = there.v.col(0);
    end.thermal.col(i) = there.thermal.col(0);
    end.path0.col(i) = there.path0.col(0);
    end.path1.col(i) = there.path1.col(0);

    all.stray(i) = motion.noise().reach(left, single).stray(0)/left;
    ++counters_.clusterMoves;
}


void Foam::aerosol::BrownianClusterSolver::collide
(
    part& all,
    const fluidStep& step,
    const int nCollision,
    const int s
)
{
    const scalar h = step.h;
    cluster& one = all.one;
    particleArrays& p = one.p;
    stepEnd& end = all.end;

    all.begin.assign(p.size(), 0);
    all.age.assign(p.size(), 0);
    all.stray = motion_.noise().reach(h, p).stray/h;

    const auto pathFrom = [&](const int i, const scalar first)
    {
        const scalar begin = all.begin[i];
        const particlePath path = stepPaths::own(p, end, i, h - begin);

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
            collisions_.absorbed(i)
         || collisions_.absorbed(j)
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

        const double strayed =
            relativeMotion::nDeviations*std::sqrt(variance);

        if (a.staysAwayFrom(b, touch + strayed))
        {
            return;
        }

        scalar when =
            contactTime(a, b, p.id(i), p.id(j), touch, h, nCollision);

        if (when > length)
        {
            const double gap0 =
                (b.position(0) - a.position(0)).norm() - touch;
            const double gap1 =
                (b.position(length) - a.position(length)).norm() - touch;

            if
            (
                BrownianCrossing
                (
                    motion_.laws().BrownianModel(), p.id(i), p.id(j),
                    gap0, gap1, variance, step.index,
                    randomBlock
                    (
                        noise::whole, step.part, s + manyParts*ageOf(pair)
                    )
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
            collisions_.absorbed(i)
         || collisions_.absorbed(j)
         || found.age != ageOf(found.pair)
        )
        {
            continue;
        }

        const contactOutcome::encounter encounter = encounterOf
        (
            found.pair,
            {
                pathFrom(i, when).position(0), pathFrom(j, when).position(0),
                between(i, when, p.v, end.v), between(j, when, p.v, end.v)
            },
            step,
            step.t + when,
            nContacts++
        );

        const Eigen::Vector3d thermal =
        (
            p.m(i)*between(i, when, p.thermal, end.thermal)
          + p.m(j)*between(j, when, p.thermal, end.thermal)
        )/(p.m(i) + p.m(j));

        const int survivor = collisions_.meet(p, encounter);

        if (survivor < 0)
        {
            continue;
        }

        p.thermal.col(survivor) = thermal;
        motion_.laws().refresh(p, survivor);

        replaceAbsorbed(one.contactPairs, found.pair, survivor);
        if (motion_.wakes().active())
        {
            all.wakePairs = bothWays(one.contactPairs);
        }

        ++all.age[survivor];
        all.grown[survivor] = 1;

        moveOn(all, survivor, when, step);

        for (const particlePair& pair : one.contactPairs)
        {
            if (pair.i == survivor || pair.j == survivor)
            {
                look(pair, when);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::BrownianClusterSolver::solve
(
    cluster& one,
    const fluidStep& step,
    const int nCollision
)
{
    const scalar h = step.h;
    particleArrays& p = one.p;

    const int n = one.nSteps;
    const scalar length = h/n;

    part all
    {
        one, bothWays(one.contactPairs), {}, {}, {}, {}, {},
        std::vector<char>(p.size(), 0), {}, 0
    };

    const stepValues outside = outsideWakes(one, all.wakePairs, h);

    // The noise of a step of one part is known, to the last bit
    std::vector<Brownian::increments> increments(1, one.increment);

    if (n > 1)
    {
        motion_.noise().bridge
        (
            h, p, step.index, randomBlock(noise::parts, step.part), n,
            one.increment, increments
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
                motion_.noise().increment
                (
                    length, p.select({i}), step.index,
                    randomBlock(noise::grown, step.part, s), own
                );

                all.end.increment.v.col(i) = own.v.col(0);
                all.end.increment.x.col(i) = own.x.col(0);
            }
        }

        motion_.inWakes().moveTogether
        (
            length, p, all.wakePairs, all.gas, all.outside,
            wakeStep::nIterations, all.end
        );
        counters_.clusterMoves += p.size();

        collide
        (
            all,
            {step.index, step.t + s*length, length, step.part},
            nCollision,
            s
        );

        all.end.accept(p);
    }

    one.absorbed = collisions_.takeAbsorbed(p.size());
}


// ************************************************************************* //
