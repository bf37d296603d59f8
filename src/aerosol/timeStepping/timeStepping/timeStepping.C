/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeStepping.H"
#include "eigenVector.H"
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

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::timeStepping::timeStepping(const tools& with)
:
    with_(with),
    step_(0),
    sorted_(0),
    wakeGhosts_(with.region),
    withMiddle_(false),
    meanDisplacement_(Eigen::Vector3d::Zero()),
    contactGhosts_(with.region)
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

void Foam::aerosol::timeStepping::migrate(particleArrays& p)
{
    with_.region.confine(p.x);
    contactGhosts_.owners().migrate(p);

    if (step_ - sorted_ >= sortInterval)
    {
        cellGrid::sort(p);
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

    return communicator::max(p.size()) > 0;
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

    // Sample outside positions at their wrapped place
    with_.region.confine(x);

    with_.sound.velocityAt(t, x, response, gas.u0);

    // Where a particle will be at the end matters to second order; just across
    // the border of the domain the gas is that at the border
    const Eigen::Vector3d lower = toEigen(with_.region.bounds().min());
    const Eigen::Vector3d upper = toEigen(with_.region.bounds().max());

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
    const Eigen::Vector3d mean = communicator::mean(drift);

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

    return 2*communicator::max(speed.size() ? speed.maxCoeff() : 0.0);
}


Foam::scalar Foam::aerosol::timeStepping::smallest(const scalars& values)
{
    return communicator::min(values.size() ? values.minCoeff() : VGREAT);
}


Foam::aerosol::scalars Foam::aerosol::timeStepping::relativeDisplacement
(
    const particleArrays& p,
    const gasStep& gas,
    const scalar h
) const
{
    scalars displacement = h*(relativeSpeed(p, gas) + with_.motion.gain(p, h));

    if (with_.motion.hasBrownian())
    {
        displacement +=
            p.thermal.colwise().norm().transpose().array()
           *with_.motion.relaxationTime(p).min(h)
          + nDeviations*with_.motion.reach(h, p).x;
    }

    // Without another particle there is no limit
    const bool alone = communicator::sum(p.size()) < 2;

    requireShort(p.size() && !alone ? displacement.maxCoeff() : 0.0, h);

    return displacement;
}


void Foam::aerosol::timeStepping::requireShort
(
    const scalar displacement,
    const scalar h
) const
{
    const scalar furthest = communicator::max(displacement);
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


void Foam::aerosol::timeStepping::searchContacts
(
    const particleArrays& p,
    const vectors& x,
    const scalars& reach
)
{
    contactPairs_.clear();

    if (!with_.collisions.active())
    {
        return;
    }

    contactGhosts_.build(x, reach, true);

    vectors places = x;
    scalars reaches = reach;
    scalars id = p.id.cast<double>();

    contactGhosts_.fill
    ({
        {places, contactGhosts_, true},
        {reaches, contactGhosts_},
        {id, contactGhosts_}
    });

    ghostId_ = id.tail(contactGhosts_.nGhosts());

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

    std::vector<ghosts::quantity> quantities
    {
        {p.x, ghostX0_, contactGhosts_, true},
        {Brownian ? end.path0 : p.v, ghostV0_, contactGhosts_, false},
        {end.x, ghostX1_, contactGhosts_, true},
        {Brownian ? end.path1 : end.v, ghostV1_, contactGhosts_, false},
        {p.collisionDiameter, ghostD_, contactGhosts_}
    };

    if (Brownian)
    {
        stray_ = with_.motion.reach(h, p).stray;
        quantities.push_back({stray_, ghostStray_, contactGhosts_});
    }

    contactGhosts_.fill(quantities);
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
    const scalars displacement = relativeDisplacement(p, gas, h);
    const scalar furthest =
        communicator::max(p.size() ? displacement.maxCoeff() : 0.0);

    searchWakes
    (
        p, p.x, (p.range > 0).select(p.range + displacement + furthest, p.range)
    );
    involve(p);

    // More for the wake of a neighbour, which is no faster than its slip, and
    // that no faster than twice the relative speed. A sphere that has just
    // grown by a merger may touch one that is not listed: it is found in the
    // next step.
    const scalar drawn = with_.motion.hasWakes() ? 2*furthest : 0;

    searchContacts(p, p.x, 0.5*p.collisionDiameter + displacement + drawn);
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
    if (i < contactGhosts_.n())
    {
        return pathOfOwn(p, end, i, h);
    }

    const int c = i - contactGhosts_.n();

    return
    {
        ghostX0_.col(c), ghostV0_.col(c), ghostX1_.col(c), ghostV1_.col(c),
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
    if (!with_.collisions.active())
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
        const int n = contactGhosts_.n();

        const scalar dj = j < n ? p.collisionDiameter(j) : ghostD_(j - n);
        const scalar touch = 0.5*(p.collisionDiameter(i) + dj);

        const particlePath a = pathOf(p, end, i, h);
        const particlePath b = pathOf(p, end, j, h);

        const scalar variance =
            Brownian ? stray_(i) + (j < n ? stray_(j) : ghostStray_(j - n))
          : 0;

        if (a.staysAwayFrom(b, touch + nDeviations*std::sqrt(variance)))
        {
            continue;
        }

        ++effort_.collisionPairs;

        const std::int64_t idJ = j < n ? p.id(j) : ghostId_(j - n);

        if
        (
            particlePath::firstOverlap
            (
                a, b, touch, h/nCollision,
                with_.collisions.refused(p.id(i), idJ)
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

    if (communicator::max(found) == 0)
    {
        return false;
    }

    std::vector<cluster> clusters =
        gatherClusters(p, gasAtHand(gas), end.increment, steps);

    for (cluster& one : clusters)
    {
        follow(one, t, h, nCollision, part);
    }

    with_.collisions.share();

    absorbed = disperse(clusters, p, end);

    return true;
}


// ************************************************************************* //
