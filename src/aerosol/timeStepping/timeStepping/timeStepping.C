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
    Foam::aerosol::periods image;

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
    wakeHalo_(with.region),
    contactHalo_(with.region)
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

bool Foam::aerosol::timeStepping::begin(particleArrays& p)
{
    ++effort_.fluidSteps;

    if (!p.refreshed())
    {
        with_.motion.refresh(p);
    }

    return bricks::max(p.size()) > 0;
}


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
    const Eigen::Vector3d mean = bricks::mean(p.v);

    const auto speed = [&](const vectors& v)
    {
        return (v.colwise() - mean).colwise().norm().array().transpose();
    };

    return speed(p.v).max(speed(gas.u0)).max(speed(gas.u1));
}


Foam::scalar Foam::aerosol::timeStepping::largestSpeed
(
    const particleArrays& p,
    const gasStep& gas
) const
{
    const scalars speed = relativeSpeed(p, gas);

    return 2*bricks::max(speed.size() ? speed.maxCoeff() : 0.0);
}


Foam::scalar Foam::aerosol::timeStepping::smallest(const scalars& values)
{
    return bricks::min(values.size() ? values.minCoeff() : VGREAT);
}


Foam::aerosol::scalars Foam::aerosol::timeStepping::relativeWay
(
    const particleArrays& p,
    const gasStep& gas,
    const scalar h
) const
{
    const scalars way = h*(relativeSpeed(p, gas) + with_.motion.gain(p, h));

    const scalar furthest = bricks::max(p.size() ? way.maxCoeff() : 0.0);
    const scalar shortest = with_.region.bounds().minDim();

    if (furthest > shortest && bricks::sum(p.size()) > 1)
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
    gasStep& gas,
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
    equationOfMotion::state end;
    bool listed = false;

    for (int s = 0; s < nParticle; ++s)
    {
        if (!listed)
        {
            search(p, {now.u0, {}, gas.u1}, h - s*hp);
            wakesOfAll(p.x, now.u0 - p.v, w0);
            listed = true;
        }

        now.u1 = gas.at(scalar(s + 1)/nParticle);

        moveAll(hp, p, now, w0, end);

        const std::vector<char> absorbed =
            meet(p, now, w0, end, t + s*hp, hp, nCollision);

        p.x.swap(end.x);
        p.v.swap(end.v);
        w0.swap(end.w);
        now.u0.swap(now.u1);

        if (!absorbed.empty())
        {
            p.remove(absorbed);
            removeColumns(now.u0, absorbed);
            removeColumns(gas.u0, absorbed);
            removeColumns(gas.u1, absorbed);
            listed = false;
        }
    }

    with_.region.confine(p);
}


void Foam::aerosol::timeStepping::searchWakes
(
    const particleArrays& p,
    const scalars& reach,
    const bool withRange
)
{
    wakePairs_.clear();

    if (!with_.motion.hasWakes())
    {
        return;
    }

    wakeHalo_.build(p.x, reach, false);

    scalars reaches = reach;
    scalars id = p.id.cast<double>();
    sources_.x = p.x;
    sources_.d = p.d;
    sources_.range.resize(0);

    std::vector<halo::quantity> quantities
    {
        {sources_.x, wakeHalo_, true},
        {sources_.d, wakeHalo_},
        {reaches, wakeHalo_},
        {id, wakeHalo_}
    };

    if (withRange)
    {
        sources_.range = p.range;
        quantities.push_back({sources_.range, wakeHalo_});
    }

    wakeHalo_.fill(quantities);

    grid_.build(sources_.x, reaches);
    grid_.acting(p.size(), id, wakePairs_);

    effort_.wakePairs += wakePairs_.size();
}


void Foam::aerosol::timeStepping::wakesOfAll
(
    const vectors& x,
    const vectors& slip,
    vectors& w
)
{
    if (with_.motion.hasWakes())
    {
        sources_.x.leftCols(x.cols()) = x;
        sources_.slip = slip;

        wakeHalo_.fill
        ({
            {sources_.x, wakeHalo_, true},
            {sources_.slip, wakeHalo_, false}
        });
    }

    with_.motion.wakes(sources_, wakePairs_, x.cols(), w);
}


void Foam::aerosol::timeStepping::searchContacts
(
    const particleArrays& p,
    const vectors& x,
    const scalars& reach
)
{
    contactPairs_.clear();

    if (!with_.contacts.active())
    {
        return;
    }

    contactHalo_.build(x, reach, true);

    vectors places = x;
    scalars reaches = reach;
    scalars id = p.id.cast<double>();

    contactHalo_.fill
    ({
        {places, contactHalo_, true},
        {reaches, contactHalo_},
        {id, contactHalo_},
        {p.d, copiesD_, contactHalo_}
    });

    copiesId_ = id.tail(contactHalo_.nCopies());

    grid_.build(places, reaches);
    grid_.touching(p.size(), id, contactPairs_);

    effort_.contactPairs += contactPairs_.size();
}


void Foam::aerosol::timeStepping::moveAll
(
    const scalar h,
    const particleArrays& p,
    const gasStep& gas,
    const vectors& w0,
    equationOfMotion::state& end
)
{
    with_.motion.predict(h, p, gas, w0, end);
    wakesOfAll(end.x, gas.u1 - end.v, end.w);
    with_.motion.correct(h, p, gas, w0, end);

    ++effort_.particleSteps;
    effort_.particleMoves += p.size();
}


void Foam::aerosol::timeStepping::fillPaths
(
    const particleArrays& p,
    const equationOfMotion::state& end
)
{
    contactHalo_.fill
    ({
        {p.x, copiesX0_, contactHalo_, true},
        {p.v, copiesV0_, contactHalo_, false},
        {end.x, copiesX1_, contactHalo_, true},
        {end.v, copiesV1_, contactHalo_, false}
    });
}


void Foam::aerosol::timeStepping::collide
(
    group& together,
    const gasStep& gas,
    const vectors& outside,
    const scalar t,
    const scalar h,
    const int nCollision
)
{
    particleArrays& p = together.p;
    equationOfMotion::state& end = together.end;

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

        const particlePath pathI = pathOf(i);
        const particlePath pathJ = pathOf(j);

        if (begin.empty() && pathI.staysAwayFrom(pathJ.moved(shift), touch))
        {
            return;
        }

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

    for (const particlePair& pair : together.contactPairs)
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

        periods image = found.image;

        if (survivor == j)
        {
            for (std::int8_t& n : image)
            {
                n = -n;
            }
        }

        redirect(together, survivor, survivor == i ? j : i, image);

        with_.motion.moveOn
        (
            survivor, when/h, h, p, together.wakePairs, gas, outside, end
        );

        for (const particlePair& pair : together.contactPairs)
        {
            if (pair.i == survivor || pair.j == survivor)
            {
                look(pair, when);
            }
        }
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
    const scalars way = relativeWay(p, gas, h);
    const scalar furthest = bricks::max(p.size() ? way.maxCoeff() : 0.0);

    searchWakes
    (
        p,
        (p.range > 0).select(p.range + way + furthest, p.range),
        true
    );

    // More for the wake of a neighbour, which is no faster than its slip, and
    // that no faster than twice the relative speed. A sphere that has just
    // grown by a merger may touch one that is not listed: it is found in the
    // next step.
    const scalar drawn = with_.motion.hasWakes() ? 2*furthest : 0;

    searchContacts(p, p.x, 0.5*p.d + way + drawn);
}


Foam::aerosol::particlePath Foam::aerosol::timeStepping::pathOf
(
    const particleArrays& p,
    const equationOfMotion::state& end,
    const int i,
    const scalar h
) const
{
    if (i < contactHalo_.n())
    {
        return {p.x.col(i), p.v.col(i), end.x.col(i), end.v.col(i), 0, h};
    }

    const int c = i - contactHalo_.n();

    return
    {
        copiesX0_.col(c), copiesV0_.col(c), copiesX1_.col(c), copiesV1_.col(c),
        0, h
    };
}


std::vector<char> Foam::aerosol::timeStepping::meet
(
    particleArrays& p,
    const gasStep& gas,
    const vectors& w0,
    equationOfMotion::state& end,
    const scalar t,
    const scalar h,
    const int nCollision
)
{
    if (!with_.contacts.active())
    {
        return {};
    }

    effort_.collisionSteps += nCollision;

    fillPaths(p, end);

    std::vector<int> steps(contactPairs_.size(), 0);
    double found = 0;

    for (std::size_t k = 0; k < contactPairs_.size(); ++k)
    {
        const int i = contactPairs_[k].i;
        const int j = contactPairs_[k].j;
        const int n = contactHalo_.n();

        const scalar dj = j < n ? p.d(j) : copiesD_(j - n);
        const scalar touch = 0.5*(p.d(i) + dj);

        const particlePath a = pathOf(p, end, i, h);
        const particlePath b = pathOf(p, end, j, h);

        if (a.staysAwayFrom(b, touch))
        {
            continue;
        }

        ++effort_.collisionPairs;

        const std::int64_t idJ = j < n ? p.id(j) : copiesId_(j - n);

        if
        (
            particlePath::firstOverlap
            (
                a, b, Eigen::Vector3d::Zero(), touch, 0, h, h/nCollision,
                with_.contacts.refused(p.id(i), idJ)
            )
         <= h
        )
        {
            steps[k] = 1;
            found = 1;
        }
    }

    if (bricks::max(found) == 0)
    {
        return {};
    }

    std::vector<group> groups = gatherGroups(p, gas, w0, end, steps);

    for (group& one : groups)
    {
        vectors outside0;
        vectors outside1;
        outsideWakes(one, outside0, outside1);

        collide(one, one.gas, outside1, t, h, nCollision);

        one.absorbed = with_.contacts.takeAbsorbed(one.p.size());
    }

    with_.contacts.share();

    return disperse(groups, p, end);
}


void Foam::aerosol::timeStepping::redirect
(
    group& together,
    const int survivor,
    const int absorbed,
    const periods& image
)
{
    // Contacts of the absorbed one become contacts of the survivor, which is
    // where the absorbed one's copy at `image` was
    for (particlePair& pair : together.contactPairs)
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
    std::vector<particlePair>& wakePairs = together.wakePairs;

    wakePairs.erase
    (
        std::remove_if
        (
            wakePairs.begin(),
            wakePairs.end(),
            [&](const particlePair& pair)
            {
                return pair.i == absorbed || pair.j == absorbed;
            }
        ),
        wakePairs.end()
    );
}


// ************************************************************************* //
