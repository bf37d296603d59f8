/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "nestedSteps.H"
#include "BrownianCrossing.H"
#include "communicator.H"
#include "randomBlock.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::nestedSteps::nestedSteps(const tools& with)
:
    timeStepping(with),
    contacts_(with.region),
    paths_(with.motion)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::nestedSteps::search
(
    const particleArrays& p,
    const stepValues& gas,
    const scalar h
)
{
    const scalars displacement = relative_.relativeDisplacement(p, gas, h);
    const scalar furthest =
        communicator::max(p.size() ? displacement.maxCoeff() : 0.0);

    wakes_.search
    (
        grid_,
        p,
        p.x,
        (p.range > 0).select(p.range + displacement + furthest, p.range)
    );
    wakes_.involve(p);

    // More for the wake of a neighbour, which is no faster than its slip, and
    // that no faster than twice the relative speed. A sphere that has just
    // grown by a merger may touch one that is not listed: it is found in the
    // next step.
    const scalar drawn = with_.motion.wakes().active() ? 2*furthest : 0;

    contacts_.pairs().clear();

    if (with_.collisions.active())
    {
        contacts_.findTouching
        (
            grid_,
            p.id.cast<double>(),
            p.x,
            0.5*p.collisionDiameter + displacement + drawn
        );
    }

    counters_.contactPairs += contacts_.pairs().size();
}


bool Foam::aerosol::nestedSteps::meet
(
    particleArrays& p,
    const stepGas& gas,
    stepEnd& end,
    const fluidStep& step,
    const int nCollision,
    std::vector<char>& absorbed
)
{
    if (!with_.collisions.active())
    {
        return false;
    }

    counters_.collisionSteps += nCollision;

    const scalar h = step.h;
    const std::vector<particlePair>& pairs = contacts_.pairs();

    paths_.fill(contacts_.layer(), p, end, h);

    std::vector<int> steps(pairs.size(), 0);
    double found = 0;

    for (std::size_t k = 0; k < pairs.size(); ++k)
    {
        const int i = pairs[k].i;
        const int j = pairs[k].j;
        const int n = contacts_.layer().n();

        const scalar touch =
            0.5*(p.collisionDiameter(i) + paths_.diameter(p, j));

        const particlePath a = paths_.of(p, end, i, h);
        const particlePath b = paths_.of(p, end, j, h);

        const scalar variance = paths_.strayOf(i) + paths_.strayOf(j);
        const scalar strayed =
            relativeMotion::nDeviations*std::sqrt(variance);

        if (a.staysAwayFrom(b, touch + strayed))
        {
            continue;
        }

        ++counters_.collisionPairs;

        const std::int64_t idJ =
            j < n ? p.id(j) : std::int64_t(contacts_.ghostId()(j - n));

        if
        (
            particlePath::firstOverlap
            (
                a, b, touch, h/nCollision,
                with_.collisions.refused(p.id(i), idJ)
            )
         <= h
         || (
                with_.motion.noise().active()
             && BrownianCrossing
                (
                    with_.motion.laws().BrownianModel(), p.id(i), idJ,
                    (b.position(0) - a.position(0)).norm() - touch,
                    (b.position(h) - a.position(h)).norm() - touch,
                    variance,
                    step.index,
                    randomBlock(noise::whole, step.part)
                )
            )
        )
        {
            steps[k] = 1;
            found = 1;
        }
    }

    if (communicator::max(found) == 0)
    {
        return false;
    }

    absorbed = collide
    (
        p,
        gas,
        {contacts_.layer(), contacts_.ghostId(), pairs, steps},
        step,
        nCollision,
        end
    );

    return true;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::aerosol::nestedSteps::move
(
    particleArrays& p,
    stepValues& gas,
    const fluidStep& step,
    const int nParticle,
    const int nCollision
)
{
    const scalar hp = step.h/nParticle;

    stepValues now;
    now.u0 = gas.u0;

    stepEnd end;
    bool listed = false;

    for (int s = 0; s < nParticle; ++s)
    {
        if (!listed)
        {
            search(p, {now.u0, {}, gas.u1}, step.h - s*hp);
            listed = true;
        }

        now.u1 = gas.at(scalar(s + 1)/nParticle);

        const stepGas air = gasSampler::atHand(now);
        const fluidStep part
        {
            step.index, step.t + s*hp, hp, step.part + s
        };

        mover_.moveWithoutWakes(part, p, air, end);
        wakes_.move(hp, p, air, false, end);

        std::vector<char> absorbed;
        const bool met = meet(p, air, end, part, nCollision, absorbed);

        end.accept(p);
        now.u0.swap(now.u1);

        // Merged and bounced particles are not where they were listed
        if (met)
        {
            p.remove(absorbed);
            remove(now.u0, absorbed);
            remove(gas.u0, absorbed);
            remove(gas.u1, absorbed);
            listed = false;
        }

        if (nParticle > 1)
        {
            progressed(scalar(s + 1)/nParticle);
        }
    }

    migrate(p);
}


Foam::scalar Foam::aerosol::nestedSteps::smallest(const scalars& values)
{
    return communicator::min(values.size() ? values.minCoeff() : VGREAT);
}


// ************************************************************************* //
