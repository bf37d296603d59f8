/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeStepping.H"
#include "selectModel.H"

#include <algorithm>
#include <queue>
#include <tuple>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(timeStepping, 0);
    defineRunTimeSelectionTable(timeStepping, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- An overlap found on the paths of a pair
struct overlap
{
    double time;
    std::int64_t idI;
    std::int64_t idJ;
    int i;
    int j;
    std::array<std::int8_t, 3> image;

    //- How often the paths of both had changed when it was found
    int age;

    //- Earliest first; at the same time in the order of the ids
    bool operator<(const overlap& b) const
    {
        return
            std::tie(time, idI, idJ) > std::tie(b.time, b.idI, b.idJ);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::timeStepping::timeStepping(const tools& with)
:
    with_(with),
    grid_(with.region)
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::timeStepping>
Foam::aerosol::timeStepping::New
(
    const dictionary& dict,
    const tools& with
)
{
    return selectModel<timeStepping>
    (
        dict,
        "time stepping",
        dictionaryConstructorTablePtr_,
        dict,
        with
    );
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::aerosol::timeStepping::gasStep
Foam::aerosol::timeStepping::sampleGas
(
    const particleArrays& p,
    const scalar t,
    const scalar h,
    const bool parabola
) const
{
    gasStep gas;

    with_.sound.velocity(t, p.x, gas.u0);

    // Where a particle will be at the end matters to second order; just across
    // the border of the domain the gas is that at the border
    vectors x1 = p.x + h*p.v;

    const vector lower = with_.region.bounds().min();
    const vector upper = with_.region.bounds().max();

    for (int k = 0; k < 3; ++k)
    {
        x1.row(k) = x1.row(k).cwiseMax(lower[k]).cwiseMin(upper[k]);
    }

    with_.sound.velocity(t + h, x1, gas.u1);

    if (parabola)
    {
        with_.sound.velocity(t + 0.5*h, 0.5*(p.x + x1), gas.um);
    }

    return gas;
}


Foam::aerosol::scalars Foam::aerosol::timeStepping::relativeSpeed
(
    const particleArrays& p,
    const gasStep& gas
) const
{
    const Eigen::Vector3d mean = p.v.rowwise().mean();

    const auto speed = [&](const vectors& v)
    {
        return (v.colwise() - mean).colwise().norm().array().transpose();
    };

    return speed(p.v).max(speed(gas.u0)).max(speed(gas.u1));
}


Foam::aerosol::scalars Foam::aerosol::timeStepping::relativeWay
(
    const particleArrays& p,
    const gasStep& gas,
    const scalar h
) const
{
    const scalars way = h*(relativeSpeed(p, gas) + with_.motion.gain(h));

    const scalar furthest = way.maxCoeff();
    const scalar shortest = with_.region.bounds().minDim();

    if (p.size() > 1 && furthest > shortest)
    {
        FatalErrorInFunction
            << "In one fluid step of " << h << " s a particle can move by "
            << furthest << " m relative to the others, which is more than the "
            << "shortest edge of the domain, " << shortest
            << " m. Reduce deltaT"
            << exit(FatalError);
    }

    return way;
}


void Foam::aerosol::timeStepping::nestedSteps
(
    particleArrays& p,
    const gasStep& gas,
    const scalar t,
    const scalar h,
    const int nParticle,
    const int nCollision
)
{
    search(p, gas, h);

    march(p, gas, {}, {}, t, h, nParticle, nCollision);

    with_.contacts.sweep(p);
    with_.region.confine(p);

    effort_.collisionSteps += std::int64_t(nParticle)*nCollision;
    effort_.particleSteps += nParticle;
    effort_.wakePairs += wakePairs_.size();
    effort_.contactPairs += contactPairs_.size();
}


void Foam::aerosol::timeStepping::march
(
    particleArrays& p,
    const gasStep& gas,
    const vectors& outside0,
    const vectors& outside1,
    const scalar t,
    const scalar h,
    const int nParticle,
    const int nCollision
)
{
    const scalar hp = h/nParticle;

    gasStep now;
    now.u0 = gas.u0;

    vectors w0;
    vectors outside;
    equationOfMotion::state end;

    with_.motion.wakes(p, wakePairs_, p.x, p.v, now.u0, w0);
    if (outside0.cols())
    {
        w0 += outside0;
    }

    for (int s = 0; s < nParticle; ++s)
    {
        const scalar done = scalar(s + 1)/nParticle;

        now.u1 = gas.at(done);
        if (outside0.cols())
        {
            outside = outside0 + done*(outside1 - outside0);
        }

        with_.motion.step(hp, p, wakePairs_, now, w0, outside, end);

        collide(p, end, now, outside, t + s*hp, hp, nCollision);

        p.x.swap(end.x);
        p.v.swap(end.v);
        w0.swap(end.w);
        now.u0.swap(now.u1);
    }
}


void Foam::aerosol::timeStepping::searchWakes
(
    const particleArrays& p,
    const scalars& way
)
{
    wakePairs_.clear();

    if (with_.motion.hasWakes())
    {
        const scalars& range = with_.motion.wakeRange();

        grid_.build
        (
            p.x,
            (range > 0).select(range + way + way.maxCoeff(), range)
        );
        grid_.acting(wakePairs_);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::timeStepping::search
(
    const particleArrays& p,
    const gasStep& gas,
    const scalar h
)
{
    with_.motion.refresh(p);

    const scalars way = relativeWay(p, gas, h);

    searchWakes(p, way);

    if (with_.contacts.active())
    {
        // More for the wake of a neighbour, which is no faster than its slip,
        // and that no faster than twice the relative speed. A sphere that has
        // just grown by a merger may touch one that is not listed: it is found
        // in the next step.
        const scalar drawn = with_.motion.hasWakes() ? 2*way.maxCoeff() : 0;

        grid_.build(p.x, 0.5*p.d + way + drawn);
        grid_.touching(contactPairs_);
    }
}


void Foam::aerosol::timeStepping::collide
(
    particleArrays& p,
    equationOfMotion::state& end,
    const gasStep& gas,
    const vectors& outside,
    const scalar t,
    const scalar h,
    const int nCollision
)
{
    if (contactPairs_.empty())
    {
        return;
    }

    const Eigen::Array3d period = with_.region.period();

    // Particles that merged within this step began their path later
    std::vector<double> begin;
    std::vector<int> age;

    const auto pathOf = [&](const int i) -> particlePath
    {
        return
        {
            p.x.col(i), p.v.col(i), end.x.col(i), end.v.col(i),
            begin.empty() ? 0 : begin[i], h
        };
    };

    const auto shiftOf = [&](const particlePair& pair) -> Eigen::Vector3d
    {
        return
        {
            pair.image[0]*period(0),
            pair.image[1]*period(1),
            pair.image[2]*period(2)
        };
    };

    std::priority_queue<overlap> queue;

    // The first time, from the given one on, at which a pair overlaps
    const auto look = [&](const particlePair& pair, const double first)
    {
        const int i = pair.i;
        const int j = pair.j;

        if
        (
            i == j
         || with_.contacts.absorbed(i)
         || with_.contacts.absorbed(j)
        )
        {
            return;
        }

        const double touch = 0.5*(p.d(i) + p.d(j));
        const Eigen::Vector3d shift = shiftOf(pair);

        // Most pairs stay apart: the distance is no less than that at either
        // end less the way between them
        if (begin.empty())
        {
            const Eigen::Vector3d r0 = p.x.col(j) + shift - p.x.col(i);
            const Eigen::Vector3d r1 = end.x.col(j) + shift - end.x.col(i);
            const Eigen::Vector3d v0 = p.v.col(j) - p.v.col(i);
            const Eigen::Vector3d v1 = end.v.col(j) - end.v.col(i);

            // Hermite's cubic is no further from an end than this
            const double way =
                (r1 - r0).norm() + 4.0/27.0*h*(v0.norm() + v1.norm());

            if (std::max(r0.norm(), r1.norm()) > touch + way)
            {
                return;
            }
        }

        const particlePath pathI = pathOf(i);
        const particlePath pathJ = pathOf(j);

        // Who touched without sticking does so again only after a separation
        const bool onlyNew = with_.contacts.refused(p.id(i), p.id(j));

        const double when =
            nCollision > 0
          ? particlePath::firstOverlap
            (
                pathI, pathJ, shift, touch, first, h, h/nCollision,
                onlyNew
            )
          : particlePath::firstTouch
            (
                pathI, pathJ, shift, touch, first, h,
                onlyNew
            );

        if (when <= h)
        {
            queue.push
            ({
                when, p.id(i), p.id(j), i, j, pair.image,
                age.empty() ? 0 : age[i] + age[j]
            });
        }
    };

    for (const particlePair& pair : contactPairs_)
    {
        look(pair, 0);
    }

    while (!queue.empty())
    {
        const overlap found = queue.top();
        queue.pop();

        const int i = found.i;
        const int j = found.j;

        if
        (
            with_.contacts.absorbed(i)
         || with_.contacts.absorbed(j)
         || found.age != (age.empty() ? 0 : age[i] + age[j])
        )
        {
            continue;
        }

        const scalar when = found.time;
        const particlePath pathI = pathOf(i);
        const particlePath pathJ = pathOf(j);
        const Eigen::Vector3d shift = shiftOf({i, j, found.image});

        contactOutcome::encounter encounter;
        encounter.i = i;
        encounter.j = j;
        encounter.xi = pathI.position(when);
        encounter.xj = pathJ.position(when) + shift;
        encounter.shift = shift;
        encounter.vi = pathI.velocity(when);
        encounter.vj = pathJ.velocity(when);
        encounter.time = t + when;

        const int survivor = with_.contacts.meet(p, encounter);

        if (survivor < 0)
        {
            continue;
        }

        if (begin.empty())
        {
            begin.assign(p.size(), 0);
            age.assign(p.size(), 0);
        }

        begin[survivor] = when;
        ++age[survivor];

        std::array<std::int8_t, 3> image = found.image;

        if (survivor == j)
        {
            for (std::int8_t& n : image)
            {
                n = -n;
            }
        }

        redirect(survivor, survivor == i ? j : i, image);

        with_.motion.moveOn
        (
            survivor, when/h, h, p, wakePairs_, gas, outside, end
        );

        for (const particlePair& pair : contactPairs_)
        {
            if (pair.i == survivor || pair.j == survivor)
            {
                look(pair, when);
            }
        }
    }
}


void Foam::aerosol::timeStepping::redirect
(
    const int survivor,
    const int absorbed,
    const std::array<std::int8_t, 3>& image
)
{
    // Contacts of the absorbed one become contacts of the survivor, which is
    // where the absorbed one's copy at `image` was
    for (particlePair& pair : contactPairs_)
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

    // Its wake is gone
    wakePairs_.erase
    (
        std::remove_if
        (
            wakePairs_.begin(),
            wakePairs_.end(),
            [&](const particlePair& pair)
            {
                return pair.i == absorbed || pair.j == absorbed;
            }
        ),
        wakePairs_.end()
    );
}


// ************************************************************************* //
