/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eventDriven.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(eventDriven, 0);
    addToRunTimeSelectionTable(timeStepping, eventDriven, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- In radii: what is added to the sphere of a path, and the distance in which
//  wakes must be followed closely
constexpr double margin = 3;
constexpr double encounter = 5;

//- If a source has more neighbours than this within its oscillation amplitude,
//  on average, lists are made anew in every step
constexpr double crowd = 200;

//- How far a particle may get in a step, in its displacement without wakes: the
//  tenth more is for wakes and for the curvature of its path. A pair that gets
//  within range nevertheless is where hardly anything is left of the wake.
constexpr double wakeMargin = 1.1;

//- More steps than this are not needed: contact ends the approach. Brownian
//  motion strays as the root of time, and needs more.
constexpr int maxSteps = 64;
constexpr int maxBrownianSteps = 1024;

//- In standard deviations of the Wiener process: how far a pair is taken to
//  stray from its straight line, which it exceeds with a probability of 1e-8,
//  and how far for the choice of the steps
constexpr double strays = 3;
constexpr double straysOften = 1.5;


//- Remove the ghosts that are in none of the pairs
void keepNeeded
(
    Foam::aerosol::ghosts& layer,
    std::vector<Foam::aerosol::particlePair>& pairs
)
{
    const int n = layer.n();
    std::vector<char> needed(layer.nGhosts(), 0);

    for (const auto& pair : pairs)
    {
        if (pair.j >= n)
        {
            needed[pair.j - n] = 1;
        }
    }

    const std::vector<int> places = layer.keep(needed);

    for (auto& pair : pairs)
    {
        if (pair.j >= n)
        {
            pair.j = n + places[pair.j - n];
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::eventDriven::eventDriven
(
    const dictionary& dict,
    const tools& with
)
:
    timeStepping(with),
    resolution_(readFraction(dict, "resolution", 0.25)),
    listedWakeGhosts_(with.region)
{
    requireOnly(dict, {"type", "resolution"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::eventDriven::list
(
    particleArrays& p,
    const scalar t,
    const scalar h
)
{
    timeStepping::migrate(p);

    const acoustics::soundField& sound = with_.sound;
    const bool Brownian = with_.motion.hasBrownian();

    // Two alike may merge
    scalars least = with_.motion.growth()*(1 + margin)*0.5*p.collisionDiameter;

    if (Brownian)
    {
        const Brownian::extent reach = with_.motion.reach(h, p);

        least =
            least.max(0.5*p.collisionDiameter + strays*reach.stray.sqrt())
          + 2*reach.x;
    }

    // Where they are about to go, in wakes as they are now
    const gasOfStep gas = gasWhenAsked(p, t, h, false);
    vectors w;
    const scalars wakeSpeed = wakesNow(p, gas, h, w);

    equationOfMotion::state end;
    inRuns
    (
        p,
        [&](const int first, const int size)
        {
            gasStep wakes;
            if (w.cols())
            {
                wakes.u0 = w.middleCols(first, size);
            }

            with_.motion.move
            (
                h, p, gas.run(first, size), wakes, false, end, first
            );
        }
    );

    const scalar furthest = skin_.make
    (
        p,
        end.x,
        end.v,
        wakeSpeed,
        least,
        h,
        sound.frequency(),
        std::max(sound.velocityAmplitude(), 0.0),
        communicator::sum(p.size())/with_.region.volume()
    );
    const scalars& skin = skin_.sizes();

    requireShort(communicator::sum(p.size()) < 2 ? 0.0 : furthest, h);
    searchContacts(p, skin_.centres(), skin);
    contactCandidates_.swap(contactPairs_);
    keepNeeded(contactGhosts_, contactCandidates_);
    fillIds(p);

    // For one step only, findWakes looks for them
    listedRange_ = p.range;
    if (skin_.lasting())
    {
        searchWakes
        (
            p,
            skin_.centres(),
            (p.range > 0).select(p.range + skin, 0),
            skin
        );
        wakeCandidates_.swap(wakePairs_);
        listedWakeGhosts_ = wakeGhosts_;
        keepNeeded(listedWakeGhosts_, wakeCandidates_);
    }
}


Foam::aerosol::scalars Foam::aerosol::eventDriven::wakesNow
(
    const particleArrays& p,
    const gasOfStep& gas,
    const scalar h,
    vectors& w
)
{
    if (!with_.motion.hasWakes())
    {
        return {};
    }

    const double omega = 2*EIGEN_PI*with_.sound.frequency();
    const double u0 = std::max(with_.sound.velocityAmplitude(), 0.0);
    const int n = p.size();

    // The slip of Stokes' response, times the radius; and how far a source gets
    // as it oscillates: a particle out of range now may come into range then
    scalars strength(n);
    scalars reach = p.range;
    for (int j = 0; j < n; ++j)
    {
        // Finite also without drag
        const double s = p.rate(j) > 1e-8*omega ? omega/p.rate(j) : 1e8;
        const double slip = s/std::sqrt(1 + s*s)*u0;

        strength(j) = 0.5*p.mobilityDiameter(j)*slip;

        if (omega > 0 && reach(j) > 0)
        {
            reach(j) += 2*slip/omega;
        }
    }

    // Pairs per particle
    const double all = communicator::sum(n);
    const double volume = with_.region.volume();
    const double meanDistance = std::cbrt(volume/all);

    vectors spheres = vectors::Zero(3, n);
    spheres.row(0) =
        4*EIGEN_PI/3*(reach/meanDistance).cube().matrix().transpose();

    if (communicator::mean(spheres)(0) > crowd)
    {
        return scalars::Constant(n, -1);
    }

    searchWakes(p, p.x, reach);

    wakeGhosts_.fill
    ({
        {p.x, wakeGhostX_, wakeGhosts_, true},
        {strength, wakeGhosts_},
    });

    scalars speed = scalars::Zero(n);

    for (const particlePair& pair : wakePairs_)
    {
        const vectors& xj = pair.j < n ? p.x : wakeGhostX_;
        const int column = pair.j < n ? pair.j : pair.j - n;
        const double r = (p.x.col(pair.i) - xj.col(column)).norm();

        speed(pair.i) +=
            1.5*strength(pair.j)/std::max(r, 0.5*p.collisionDiameter(pair.i));
    }

    involve(p);

    const gasStep air = gas.some(involved_);

    vectors kept, slip, found;
    wakesAt
    (
        p.x(Eigen::all, involved_),
        with_.motion.drift
        (
            p.v(Eigen::all, involved_), p.thermal(Eigen::all, involved_)
        ),
        air.u0,
        with_.motion.imaginarySlip(p.rate(involved_), air, 0, h),
        kept, slip, found
    );

    w.setZero(3, n);
    w(Eigen::all, involved_) = found;

    return speed;
}


void Foam::aerosol::eventDriven::fillIds(const particleArrays& p)
{
    const scalars id = p.id.cast<double>();

    contactGhosts_.fill({{id, ghostId_, contactGhosts_}});
}


void Foam::aerosol::eventDriven::findWakes
(
    const particleArrays& p,
    const equationOfMotion::state& end
)
{
    if (!with_.motion.hasWakes())
    {
        return;
    }

    const int n = p.size();

    const scalars displacement =
        wakeMargin
       *((end.x - p.x).colwise() - meanDisplacement_).colwise().norm()
       .transpose().array();
    const scalars reach = (p.range > 0).select(p.range + displacement, 0);

    bool listed = skin_.lasting();

    if (listed && communicator::max(!skin_.contain(p, displacement)) > 0)
    {
        listed = false;
        skin_.expire();
    }

    if (!listed)
    {
        // Less the mean displacement, as in findEncounters
        searchWakes(p, p.x.colwise() - skin_.moved(), reach, displacement);
        involve(p);
        return;
    }

    wakeGhosts_ = listedWakeGhosts_;
    wakeGhosts_.fill
    ({
        {p.x, wakeGhostX_, wakeGhosts_, true},
        {reach, wakeGhostReach_, wakeGhosts_}
    });

    wakePairs_.clear();

    for (const particlePair& pair : wakeCandidates_)
    {
        const bool own = pair.j < n;
        const double* const xi = p.x.data() + 3*pair.i;
        const double* const xj =
            own ? p.x.data() + 3*pair.j : wakeGhostX_.data() + 3*(pair.j - n);
        const double far =
            (own ? reach(pair.j) : wakeGhostReach_(pair.j - n))
          + displacement(pair.i);

        const double r[3] = {xi[0] - xj[0], xi[1] - xj[1], xi[2] - xj[2]};

        if (r[0]*r[0] + r[1]*r[1] + r[2]*r[2] <= far*far)
        {
            wakePairs_.push_back(pair);
        }
    }

    involve(p);
}


std::vector<int> Foam::aerosol::eventDriven::findEncounters
(
    const particleArrays& p,
    const equationOfMotion::state& end,
    const scalar h
)
{
    const int n = p.size();
    const bool Brownian = with_.motion.hasBrownian();

    const vectors& start = Brownian ? end.path0 : p.v;
    const vectors& final = Brownian ? end.path1 : end.v;

    scalars stray;
    if (Brownian)
    {
        stray = with_.motion.reach(h, p).stray;
    }

    // In the frame of the common motion
    const Eigen::Vector3d& displacement = meanDisplacement_;
    const Eigen::Vector3d mean = displacement/h;

    // Hermite's cubic is no further from its chord than this
    const auto bulgeOf =
    [h]
    (
        const Eigen::Vector3d& v0,
        const Eigen::Vector3d& chord,
        const Eigen::Vector3d& v1
    )
    {
        return 4.0/27.0*((h*v0 - chord).norm() + (h*v1 - chord).norm());
    };

    // A sphere around the middle of the path
    struct sphere
    {
        Eigen::Vector3d middle;
        double radius;
    };

    const auto sphereOf =
    [&]
    (
        const Eigen::Vector3d& x0,
        const Eigen::Vector3d& v0,
        const Eigen::Vector3d& x1,
        const Eigen::Vector3d& v1,
        const double d,
        const double strayed
    )
    {
        const Eigen::Vector3d chord = x1 - x0 - displacement;

        return sphere
        {
            x0 + 0.5*chord,
            0.5*chord.norm()
          + bulgeOf(v0 - mean, chord, v1 - mean)
          + std::max
            (
                (1 + margin)*0.5*d,
                0.5*d + (Brownian ? strays*std::sqrt(strayed) : 0.0)
            )
        };
    };

    const auto sphereOfOwn = [&](const int i)
    {
        return sphereOf
        (
            p.x.col(i), start.col(i), end.x.col(i), final.col(i),
            p.collisionDiameter(i), Brownian ? stray(i) : 0.0
        );
    };

    const auto sphereOfGhost = [&](const int c)
    {
        return sphereOf
        (
            ghostX0_.col(c), ghostV0_.col(c), ghostX1_.col(c),
            ghostV1_.col(c), ghostD_(c), Brownian ? ghostStray_(c) : 0.0
        );
    };

    scalars extra;
    if (Brownian)
    {
        extra = 0.5*p.collisionDiameter + strays*stray.sqrt();
    }

    const bool held = skin_.hold
    (
        p, start, end.x, final, h, displacement, 1 + margin, extra
    );
    skin_.move(displacement);

    if (communicator::max(!held) > 0)
    {
        // A particle left its skin, so that pairs may be missing: search
        vectors middle(3, n);
        scalars reach(n);
        double furthest = 0;

        for (int i = 0; i < n; ++i)
        {
            const sphere one = sphereOfOwn(i);
            middle.col(i) = one.middle;
            reach(i) = one.radius;
            furthest = std::max(furthest, 2*(one.middle - p.x.col(i)).norm());
        }

        // Less the mean displacement since the last migration, which brings no
        // particles together: else a mean flow would need ever more ghosts
        middle.colwise() -= skin_.moved() - displacement;

        skin_.expire();
        requireShort(furthest, h);
        searchContacts(p, middle, reach);
        contactCandidates_.swap(contactPairs_);
    }

    fillPaths(p, end, h);

    contactPairs_.clear();
    std::vector<int> steps;

    for (const particlePair& pair : contactCandidates_)
    {
        const int i = pair.i;
        const int j = pair.j;

        const sphere a = sphereOfOwn(i);
        const sphere b = j < n ? sphereOfOwn(j) : sphereOfGhost(j - n);
        const double sum = a.radius + b.radius;

        if ((b.middle - a.middle).squaredNorm() > sum*sum)
        {
            continue;
        }

        contactPairs_.push_back(pair);
        steps.push_back(0);
        int& needed = steps.back();

        Eigen::Vector3d r0 = -p.x.col(i);
        Eigen::Vector3d chord = p.x.col(i) - end.x.col(i);
        Eigen::Vector3d v0 = -start.col(i);
        Eigen::Vector3d v1 = -final.col(i);
        double radii = 0.5*p.collisionDiameter(i);

        if (j < n)
        {
            r0 += p.x.col(j);
            chord += end.x.col(j) - p.x.col(j);
            v0 += start.col(j);
            v1 += final.col(j);
            radii += 0.5*p.collisionDiameter(j);
        }
        else
        {
            const int c = j - n;

            r0 += ghostX0_.col(c);
            chord += ghostX1_.col(c) - ghostX0_.col(c);
            v0 += ghostV0_.col(c);
            v1 += ghostV1_.col(c);
            radii += 0.5*ghostD_(c);
        }

        // The closest point of the straight line
        const double s =
            std::min
            (
                1.0,
                std::max(0.0, -r0.dot(chord)/(chord.squaredNorm() + VSMALL))
            );
        const double bulge = bulgeOf(v0, chord, v1);
        const double closest = (r0 + s*chord).norm() - bulge;

        const double deviation =
            Brownian
          ? std::sqrt(stray(i) + (j < n ? stray(j) : ghostStray_(j - n)))
          : 0;

        if
        (
            closest < encounter*radii
         || closest < radii + strays*deviation
        )
        {
            const double distance = chord.norm() + 2*bulge;

            const double resolved =
                resolution_
               *std::max(closest - straysOften*deviation, radii);

            needed = static_cast<int>
            (
                std::max
                (
                    1.0,
                    std::min
                    (
                        double(maxSteps),
                        std::ceil(distance/resolved)
                    )
                )
            );

            needed =
                std::max
                (
                    needed,
                    static_cast<int>
                    (
                        std::min
                        (
                            double(maxBrownianSteps),
                            std::ceil(deviation*deviation/(resolved*resolved))
                        )
                    )
                );
        }
    }

    effort_.contactPairs += contactPairs_.size();

    return steps;
}


void Foam::aerosol::eventDriven::tidy
(
    particleArrays& p,
    const std::vector<char>& absorbed
)
{
    const int n = p.size();
    const bool withWakes = with_.motion.hasWakes();

    for (const int i : returned_)
    {
        if (withWakes && p.range(i) > listedRange_(i))
        {
            skin_.shrink(i, p.range(i) - listedRange_(i));
            listedRange_(i) = p.range(i);
        }

        skin_.check(i, p.x.col(i), (1 + margin)*0.5*p.collisionDiameter(i));
    }

    const bool any =
        std::find(absorbed.begin(), absorbed.end(), 1) != absorbed.end();

    if (communicator::max(any) == 0)
    {
        return;
    }

    // The index of each particle from now on
    std::vector<int> places(n);
    int left = 0;
    for (int i = 0; i < n; ++i)
    {
        places[i] = absorbed[i] ? -1 : i;
        left += !absorbed[i];
    }
    for (const auto& move : moves(absorbed))
    {
        places[move.first] = move.second;
    }

    const scalars gone =
        Eigen::Map<const Eigen::Array<char, Eigen::Dynamic, 1>>
        (
            absorbed.data(), n
        ).cast<double>();

    const auto drop = [&](ghosts& layer, std::vector<particlePair>& pairs)
    {
        scalars ghostsGone;
        layer.fill({{gone, ghostsGone, layer}});

        const auto lost = [&](const particlePair& pair)
        {
            return
                absorbed[pair.i]
             || (pair.j < n ? absorbed[pair.j] : ghostsGone(pair.j - n));
        };

        pairs.erase
        (
            std::remove_if(pairs.begin(), pairs.end(), lost), pairs.end()
        );

        keepNeeded(layer, pairs);
        layer.renumber(places, left);

        for (particlePair& pair : pairs)
        {
            pair.i = places[pair.i];
            pair.j = pair.j < n ? places[pair.j] : left + pair.j - n;
        }
    };

    drop(contactGhosts_, contactCandidates_);

    if (withWakes)
    {
        if (skin_.lasting())
        {
            drop(listedWakeGhosts_, wakeCandidates_);
        }
        remove(listedRange_, absorbed);
    }

    skin_.remove(absorbed);
    p.remove(absorbed);
    fillIds(p);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::eventDriven::advance
(
    particleArrays& p,
    const scalar t,
    const scalar h,
    const std::int64_t step
)
{
    if (!begin(p, t, h, step))
    {
        return;
    }

    if (communicator::max(skin_.expired()) > 0)
    {
        list(p, t, h);
    }

    const gasOfStep gas = gasWhenAsked(p, t, h, true);
    equationOfMotion::state end;

    moveWithoutWakes(h, p, gas, 0, end);
    findWakes(p, end);
    moveInWakes(h, p, gas, true, end);

    std::vector<int> steps;
    std::vector<char> absorbed;

    // Also without contacts: the lists of wakes depend on the skins
    if (with_.collisions.active() || with_.motion.hasWakes())
    {
        steps = findEncounters(p, end, h);
    }

    if (with_.collisions.active())
    {
        std::vector<cluster> clusters =
            gatherClusters(p, gas, end.increment, steps);

        for (cluster& one : clusters)
        {
            follow(one, t, h, 0, 0);
        }

        with_.collisions.share();

        absorbed = disperse(clusters, p, end);
    }

    with_.motion.arrive(p, end);

    if (with_.collisions.active())
    {
        tidy(p, absorbed);
    }
}


void Foam::aerosol::eventDriven::migrate(particleArrays& p)
{
    timeStepping::migrate(p);
    skin_.expire();
}


// ************************************************************************* //
