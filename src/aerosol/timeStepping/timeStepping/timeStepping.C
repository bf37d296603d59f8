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
    step_(0),
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

bool Foam::aerosol::timeStepping::begin
(
    particleArrays& p,
    const std::int64_t step
)
{
    ++effort_.fluidSteps;
    step_ = step;

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
    vectors x1 = p.x + h*(p.v - p.thermal);

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
    const vectors drift = p.v - p.thermal;
    const Eigen::Vector3d mean = bricks::mean(drift);

    const auto speed = [&](const vectors& v)
    {
        return (v.colwise() - mean).colwise().norm().array().transpose();
    };

    return speed(drift).max(speed(gas.u0)).max(speed(gas.u1));
}


Foam::scalar Foam::aerosol::timeStepping::largestSpeed
(
    const particleArrays& p,
    const gasStep& gas,
    const scalar h
) const
{
    scalars speed = relativeSpeed(p, gas);

    if (with_.motion.hasBrownian())
    {
        speed +=
            p.thermal.colwise().norm().transpose().array()
          + nDeviations*with_.motion.reach(h, p).v;
    }

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
    scalars way = h*(relativeSpeed(p, gas) + with_.motion.gain(p, h));

    if (with_.motion.hasBrownian())
    {
        way +=
            p.thermal.colwise().norm().transpose().array()
           *with_.motion.relaxationTime(p).min(h)
          + nDeviations*with_.motion.reach(h, p).x;
    }

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
    const int nCollision,
    const int before
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
            wakesOfAll(p.x, now.u0 - (p.v - p.thermal), w0);
            listed = true;
        }

        now.u1 = gas.at(scalar(s + 1)/nParticle);

        moveAll(hp, p, now, w0, before + s, end);

        const std::vector<char> absorbed =
            meet(p, now, w0, end, t + s*hp, hp, nCollision, before + s);

        with_.motion.arrive(p, end);
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
    const int part,
    equationOfMotion::state& end
)
{
    with_.motion.kick(h, p, step_, block(noise::whole, part), end.kick);
    with_.motion.predict(h, p, gas, w0, end);
    wakesOfAll
    (
        end.x, gas.u1 - with_.motion.drift(end.v, end.thermal), end.w
    );
    with_.motion.correct(h, p, gas, w0, end);

    ++effort_.particleSteps;
    effort_.particleMoves += p.size();
}


void Foam::aerosol::timeStepping::fillPaths
(
    const particleArrays& p,
    const equationOfMotion::state& end,
    const scalar h
)
{
    const bool Brownian = with_.motion.hasBrownian();

    std::vector<halo::quantity> quantities
    {
        {p.x, copiesX0_, contactHalo_, true},
        {Brownian ? end.path0 : p.v, copiesV0_, contactHalo_, false},
        {end.x, copiesX1_, contactHalo_, true},
        {Brownian ? end.path1 : end.v, copiesV1_, contactHalo_, false}
    };

    if (Brownian)
    {
        stray_ = with_.motion.reach(h, p).stray;
        quantities.push_back({stray_, copiesStray_, contactHalo_});
    }

    contactHalo_.fill(quantities);
}


bool Foam::aerosol::timeStepping::crosses
(
    const std::int64_t idI,
    const std::int64_t idJ,
    const scalar gap0,
    const scalar gap1,
    const scalar variance,
    const std::uint64_t block
) const
{
    const double exponent = 2*gap0*gap1/(variance + VSMALL);

    // Of the probability no random number is as small as this one
    if (gap0 <= 0 || gap1 <= 0 || exponent > 40)
    {
        return false;
    }

    return
        with_.motion.noise().uniform(idI, idJ, step_, block)
      < std::exp(-exponent);
}


void Foam::aerosol::timeStepping::collide
(
    group& together,
    const gasStep& gas,
    const vectors& outside,
    const scalar t,
    const scalar h,
    const int nCollision,
    const int part
)
{
    particleArrays& p = together.p;
    equationOfMotion::state& end = together.end;

    const Eigen::Array3d period = with_.region.period();
    const bool Brownian = with_.motion.hasBrownian();

    // Per time, which a particle that merged in the step has less of
    scalars stray;
    if (Brownian)
    {
        stray = with_.motion.reach(h, p).stray/h;
    }

    // Particles that merged within this step began their path later
    std::vector<double> begin;
    std::vector<int> age;

    const auto pathOf = [&](const int i) -> particlePath
    {
        return
        {
            p.x.col(i), Brownian ? end.path0.col(i) : p.v.col(i),
            end.x.col(i), Brownian ? end.path1.col(i) : end.v.col(i),
            begin.empty() ? 0 : begin[i], h
        };
    };

    // Of the velocity on the path, the part that is Brownian
    const auto thermalOf = [&](const int i, const double when)
    {
        const double b = begin.empty() ? 0 : begin[i];
        const double s = h > b ? (when - b)/(h - b) : 1;

        return Eigen::Vector3d
        (
            (1 - s)*(end.path0.col(i) - (p.v.col(i) - p.thermal.col(i)))
          + s*(end.path1.col(i) - (end.v.col(i) - end.thermal.col(i)))
        );
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

        const double variance =
            Brownian ? (stray(i) + stray(j))*(h - first) : 0;

        if
        (
            begin.empty()
         && pathI.staysAwayFrom
            (
                pathJ.moved(shift), touch + nDeviations*std::sqrt(variance)
            )
        )
        {
            return;
        }

        // Who touched without sticking does so again only after a separation
        const bool onlyNew = with_.contacts.refused(p.id(i), p.id(j));

        double when =
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

        const int changes = age.empty() ? 0 : age[i] + age[j];

        if (Brownian && when > h)
        {
            const auto gap = [&](const double t)
            {
                return
                    (pathJ.position(t) + shift - pathI.position(t)).norm()
                  - touch;
            };

            const double gap0 = gap(first);
            const double gap1 = gap(h);

            if
            (
                crosses
                (
                    p.id(i), p.id(j), gap0, gap1, variance,
                    block(noise::whole, part, changes)
                )
            )
            {
                when = first + gap0/(gap0 + gap1)*(h - first);
            }
        }

        if (when <= h)
        {
            queue.push
            ({
                when, p.id(i), p.id(j), i, j, pair.image, changes
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

        Eigen::Vector3d thermal = Eigen::Vector3d::Zero();
        if (Brownian)
        {
            thermal =
                (p.m(i)*thermalOf(i, when) + p.m(j)*thermalOf(j, when))
               /(p.m(i) + p.m(j));
        }

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
        together.grown.resize(p.size(), 0);
        together.grown[survivor] = 1;
        p.thermal.col(survivor) = thermal;

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
            survivor, when/h, h, p, together.wakePairs, gas, outside, end,
            step_, block(noise::rest, part, age[survivor])
        );

        if (Brownian && when < h)
        {
            stray(survivor) =
                with_.motion.reach(h - when, p.select({survivor})).stray(0)
               /(h - when);
        }

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
        const bool Brownian = with_.motion.hasBrownian();

        return
        {
            p.x.col(i), Brownian ? end.path0.col(i) : p.v.col(i),
            end.x.col(i), Brownian ? end.path1.col(i) : end.v.col(i),
            0, h
        };
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
    const int nCollision,
    const int part
)
{
    if (!with_.contacts.active())
    {
        return {};
    }

    effort_.collisionSteps += nCollision;

    fillPaths(p, end, h);

    const bool Brownian = with_.motion.hasBrownian();

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

        const scalar variance =
            Brownian ? stray_(i) + (j < n ? stray_(j) : copiesStray_(j - n))
          : 0;

        if (a.staysAwayFrom(b, touch + nDeviations*std::sqrt(variance)))
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
         || (
                Brownian
             && crosses
                (
                    p.id(i), idJ,
                    (b.position(0) - a.position(0)).norm() - touch,
                    (b.position(h) - a.position(h)).norm() - touch,
                    variance,
                    block(noise::whole, part)
                )
            )
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

        with_.motion.split(h, one.p, one.end);

        collide(one, one.gas, outside1, t, h, nCollision, part);

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
