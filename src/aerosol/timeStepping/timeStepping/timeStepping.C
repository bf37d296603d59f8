/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeStepping.H"
#include "selectModel.H"

#include <cmath>

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

//- Fluid steps after which particles that were close in memory are no longer so
//  in space
constexpr int sortInterval = 50;


Eigen::Vector3d corner(const Foam::vector& x)
{
    return {x.x(), x.y(), x.z()};
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::timeStepping::timeStepping(const tools& with)
:
    with_(with),
    step_(0),
    sorted_(0),
    wakeHalo_(with.region),
    withMiddle_(false),
    commonWay_(Eigen::Vector3d::Zero()),
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

void Foam::aerosol::timeStepping::settle(particleArrays& p)
{
    with_.region.confine(p.x);
    contactHalo_.owners().settle(p);

    if (step_ - sorted_ >= sortInterval)
    {
        searchGrid::sort(p);
        sorted_ = step_;
    }
}


bool Foam::aerosol::timeStepping::begin
(
    particleArrays& p,
    const scalar t,
    const scalar h,
    const std::int64_t step
)
{
    ++effort_.fluidSteps;
    step_ = step;

    if (!p.refreshed())
    {
        with_.motion.refresh(p);
    }

    if (with_.motion.isUnsteady())
    {
        const gasOfStep gas = gasWhenAsked(p, t, h, true);
        equationOfMotion::state end;

        inRuns
        (
            p,
            [&](const int first, const int size)
            {
                with_.motion.accelerate(h, gas.run(first, size), first, p, end);
            }
        );
    }

    return bricks::max(p.size()) > 0;
}


Foam::aerosol::timeStepping::gasStep
Foam::aerosol::timeStepping::sampleGas
(
    vectors x,
    const vectors& v,
    const phasors& response,
    const scalar t,
    const scalar h,
    const bool parabola
) const
{
    gasStep gas;

    // Who has left the domain finds the gas that is where the border says
    with_.region.confine(x);

    with_.sound.velocityAt(t, x, response, gas.u0);

    // Where a particle will be at the end matters to second order; just across
    // the border of the domain the gas is that at the border
    const Eigen::Vector3d lower = corner(with_.region.bounds().min());
    const Eigen::Vector3d upper = corner(with_.region.bounds().max());

    vectors x1(3, x.cols());

    for (int i = 0; i < x.cols(); ++i)
    {
        x1.col(i) =
            (x.col(i) + h*v.col(i)).cwiseMax(lower).cwiseMin(upper);
    }

    with_.sound.velocityAt(t + h, x1, response, gas.u1);

    if (parabola)
    {
        x1 = 0.5*(x + x1);
        with_.sound.velocityAt(t + 0.5*h, x1, response, gas.um);
    }

    return gas;
}


Foam::aerosol::timeStepping::gasOfStep
Foam::aerosol::timeStepping::gasWhenAsked
(
    const particleArrays& p,
    const scalar t,
    const scalar h,
    const bool parabola
) const
{
    return
    {
        [this, &p, t, h, parabola](const int first, const int size)
        {
            return sampleGas
            (
                p.x.middleCols(first, size),
                with_.motion.drift
                (
                    p.v.middleCols(first, size),
                    p.thermal.middleCols(first, size)
                ),
                p.response.segment(first, size),
                t, h, parabola
            );
        },
        [this, &p, t, h, parabola](const std::vector<int>& some)
        {
            return sampleGas
            (
                p.x(Eigen::all, some),
                with_.motion.drift
                (
                    p.v(Eigen::all, some), p.thermal(Eigen::all, some)
                ),
                p.response(some),
                t, h, parabola
            );
        },
        parabola
    };
}


Foam::aerosol::timeStepping::gasOfStep
Foam::aerosol::timeStepping::gasAtHand(const gasStep& gas)
{
    const auto of = [&gas](const auto& choose)
    {
        return gasStep
        {
            choose(gas.u0),
            gas.um.cols() ? choose(gas.um) : vectors(3, 0),
            gas.u1.cols() ? choose(gas.u1) : vectors(3, 0)
        };
    };

    return
    {
        [of](const int first, const int size)
        {
            return of
            (
                [&](const vectors& u)
                {
                    return vectors(u.middleCols(first, size));
                }
            );
        },
        [of](const std::vector<int>& some)
        {
            return of
            (
                [&](const vectors& u) { return vectors(u(Eigen::all, some)); }
            );
        },
        gas.um.cols() > 0
    };
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

    // A single one may go as far as it likes
    const bool alone = bricks::sum(p.size()) < 2;

    requireShort(p.size() && !alone ? way.maxCoeff() : 0.0, h);

    return way;
}


void Foam::aerosol::timeStepping::requireShort
(
    const scalar way,
    const scalar h
) const
{
    const scalar furthest = bricks::max(way);
    const scalar shortest = with_.region.bounds().minDim();

    if (furthest > shortest)
    {
        FatalErrorInFunction
            << "In one fluid step of " << h << " s a particle can move by "
            << furthest << " m relative to the others, which is more than the "
            << "shortest edge of the domain, " << shortest
            << " m. Reduce deltaT of system/controlDict"
            << exit(FatalError);
    }
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

    equationOfMotion::state end;
    bool listed = false;

    for (int s = 0; s < nParticle; ++s)
    {
        if (!listed)
        {
            search(p, {now.u0, {}, gas.u1}, h - s*hp);
            listed = true;
        }

        now.u1 = gas.at(scalar(s + 1)/nParticle);

        const gasOfStep air = gasAtHand(now);

        moveWithoutWakes(hp, p, air, before + s, end);
        moveInWakes(hp, p, air, false, end);

        std::vector<char> absorbed;
        const bool met =
            meet(p, now, end, t + s*hp, hp, nCollision, before + s, absorbed);

        with_.motion.arrive(p, end);
        now.u0.swap(now.u1);

        // Who has merged or bounced is not where it was listed
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

    settle(p);
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
        {id, contactHalo_}
    });

    copiesId_ = id.tail(contactHalo_.nCopies());

    grid_.build(places, reaches);
    grid_.touching(p.size(), id, contactPairs_);

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
        {Brownian ? end.path1 : end.v, copiesV1_, contactHalo_, false},
        {p.collision, copiesD_, contactHalo_}
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
        p, p.x, (p.range > 0).select(p.range + way + furthest, p.range)
    );
    involve(p);

    // More for the wake of a neighbour, which is no faster than its slip, and
    // that no faster than twice the relative speed. A sphere that has just
    // grown by a merger may touch one that is not listed: it is found in the
    // next step.
    const scalar drawn = with_.motion.hasWakes() ? 2*furthest : 0;

    searchContacts(p, p.x, 0.5*p.collision + way + drawn);
    effort_.contactPairs += contactPairs_.size();
}


Foam::aerosol::particlePath Foam::aerosol::timeStepping::pathOfOwn
(
    const particleArrays& p,
    const equationOfMotion::state& end,
    const int i,
    const scalar h
) const
{
    const bool Brownian = with_.motion.hasBrownian();

    return
    {
        p.x.col(i), Brownian ? end.path0.col(i) : p.v.col(i),
        end.x.col(i), Brownian ? end.path1.col(i) : end.v.col(i),
        h
    };
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
        return pathOfOwn(p, end, i, h);
    }

    const int c = i - contactHalo_.n();

    return
    {
        copiesX0_.col(c), copiesV0_.col(c), copiesX1_.col(c), copiesV1_.col(c),
        h
    };
}


bool Foam::aerosol::timeStepping::meet
(
    particleArrays& p,
    const gasStep& gas,
    equationOfMotion::state& end,
    const scalar t,
    const scalar h,
    const int nCollision,
    const int part,
    std::vector<char>& absorbed
)
{
    if (!with_.contacts.active())
    {
        return false;
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

        const scalar dj = j < n ? p.collision(j) : copiesD_(j - n);
        const scalar touch = 0.5*(p.collision(i) + dj);

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
                a, b, touch, h/nCollision,
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
        return false;
    }

    std::vector<group> groups =
        gatherGroups(p, gasAtHand(gas), end.kick, steps);

    for (group& one : groups)
    {
        follow(one, t, h, nCollision, part);
    }

    with_.contacts.share();

    absorbed = disperse(groups, p, end);

    return true;
}


// ************************************************************************* //
