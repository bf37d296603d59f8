/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "encounterFinder.H"
#include "communicator.H"
#include "pathSphere.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::aerosol;

//- In radii: the distance in which wakes must be followed closely
constexpr double encounter = 5;

//- More steps than this are not needed: contact ends the approach. Brownian
//  motion strays as the root of time, and needs more.
constexpr int maxSteps = 64;
constexpr int maxBrownianSteps = 1024;

//- In standard deviations of the Wiener process: how far a pair is taken to
//  stray from its straight line, which it exceeds with a probability of 1e-8,
//  and how far for the choice of the steps
constexpr double strays = 3;
constexpr double straysOften = 1.5;


//- How far each particle may get in a step, relative to all [m]
scalars displacements
(
    const particleArrays& p,
    const stepEnd& end,
    const Eigen::Vector3d& meanDisplacement
)
{
    return
        encounterFinder::wakeMargin
       *((end.x - p.x).colwise() - meanDisplacement).colwise().norm()
       .transpose().array();
}


//- A sphere around the path of a particle of diameter d
struct spheres
{
    const Eigen::Vector3d& displacement;
    const double h;
    const bool Brownian;

    pathSphere operator()
    (
        const Eigen::Vector3d& x0,
        const Eigen::Vector3d& v0,
        const Eigen::Vector3d& x1,
        const Eigen::Vector3d& v1,
        const double d,
        const double strayed
    ) const
    {
        // In the frame of the common motion
        const Eigen::Vector3d mean = displacement/h;

        return pathSphere
        (
            x0,
            v0 - mean,
            x1 - x0 - displacement,
            v1 - mean,
            h,
            std::max
            (
                (1 + encounterFinder::margin)*0.5*d,
                0.5*d + (Brownian ? strays*std::sqrt(strayed) : 0.0)
            )
        );
    }
};


//- So many that the distance changes by no more than is to be resolved in one
int stepsNeeded
(
    const double distance,
    const double deviation,
    const double resolved
)
{
    const double straight =
        std::min(double(maxSteps), std::ceil(distance/resolved));
    const double Brownian =
        std::min
        (
            double(maxBrownianSteps),
            std::ceil(deviation*deviation/(resolved*resolved))
        );

    return static_cast<int>(std::max({1.0, straight, Brownian}));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::encounterFinder::encounterFinder
(
    const acoustics::soundField& sound,
    const domain& region,
    const equationOfMotion& motion,
    const collisions& meetings,
    const gasSampler& sampler,
    const relativeMotion& relative,
    neighbourWakes& wakes,
    stepCounters& counters,
    const scalar resolution
)
:
    sound_(sound),
    domain_(region),
    motion_(motion),
    collisions_(meetings),
    sampler_(sampler),
    relative_(relative),
    wakes_(wakes),
    counters_(counters),
    resolution_(resolution),
    contacts_(region),
    wakeCandidates_(region),
    paths_(motion)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::encounterFinder::searchContacts
(
    const particleArrays& p,
    const vectors& x,
    const scalars& reach
)
{
    contacts_.pairs().clear();

    if (collisions_.active())
    {
        contacts_.findTouching(grid_, p.id.cast<double>(), x, reach);
    }
    else
    {
        // No pairs, but as many particles as there are
        contacts_.layer().set(p.size(), {});
    }
}


void Foam::aerosol::encounterFinder::sift
(
    const neighbourList& candidates,
    const particleArrays& p,
    const scalars& reach,
    const scalars& displacement
)
{
    const int n = p.size();

    ghosts& layer = wakes_.list().layer();
    std::vector<particlePair>& pairs = wakes_.list().pairs();

    layer = candidates.layer();
    layer.fill
    ({
        {p.x, wakeGhostX_, layer, true},
        {reach, wakeGhostReach_, layer}
    });

    pairs.clear();

    for (const particlePair& pair : candidates.pairs())
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
            pairs.push_back(pair);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::encounterFinder::list
(
    const particleArrays& p,
    const fluidStep& step
)
{
    ++counters_.lists;

    const scalar h = step.h;
    const bool Brownian = motion_.noise().active();

    // Two alike may merge
    scalars least =
        motion_.laws().aggregateModel().growth()*(1 + margin)
       *0.5*p.collisionDiameter;

    if (Brownian)
    {
        const Brownian::extent reach = motion_.noise().reach(h, p);

        least =
            least.max(0.5*p.collisionDiameter + strays*reach.stray.sqrt())
          + 2*reach.x;
    }

    // Where they are about to go, in wakes as they are now
    const stepGas gas = sampler_.whenAsked(p, step, false);
    vectors w;
    const scalars wakeSpeed = wakesNow(p, gas, h, w);

    stepEnd end;
    particleStep::inRuns
    (
        p,
        [&](const int first, const int size)
        {
            stepValues wakes;
            if (w.cols())
            {
                wakes.u0 = w.middleCols(first, size);
            }

            motion_.exact().move
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
        sound_.frequency(),
        std::max(sound_.velocityAmplitude(), 0.0),
        communicator::sum(p.size())/domain_.volume()
    );
    const scalars& skin = skin_.sizes();

    // Gravity may move them further than their velocities at the start say
    const vectors displacement = end.x - p.x;
    const Eigen::Vector3d mean = h*communicator::mean(displacement/h);
    const scalar most =
        p.size()
      ? (displacement.colwise() - mean).colwise().norm().maxCoeff()
      : 0;

    relative_.requireShort
    (
        communicator::sum(p.size()) < 2 ? 0.0 : std::max(furthest, most),
        h
    );
    searchContacts(p, skin_.centres(), skin);
    contacts_.keepNeededGhosts();
    contacts_.fillIds(p.id.cast<double>());

    // For one step only, findWakes looks for them
    listedRange_ = p.range;
    if (skin_.lasting())
    {
        wakeCandidates_.pairs().clear();

        if (motion_.wakes().active())
        {
            wakeCandidates_.findActing
            (
                grid_,
                p.id.cast<double>(),
                skin_.centres(),
                (p.range > 0).select(p.range + skin, 0),
                skin
            );
        }

        wakeCandidates_.keepNeededGhosts();
    }
}


void Foam::aerosol::encounterFinder::findWakes
(
    const particleArrays& p,
    const stepEnd& end,
    const Eigen::Vector3d& meanDisplacement
)
{
    if (!motion_.wakes().active())
    {
        return;
    }

    const scalars displacement =
        displacements(p, end, meanDisplacement);
    const scalars reach = (p.range > 0).select(p.range + displacement, 0);

    bool listed = skin_.lasting();

    if (listed && communicator::max(!skin_.contain(p, displacement)) > 0)
    {
        listed = false;
        skin_.expire();
    }

    if (listed)
    {
        sift(wakeCandidates_, p, reach, displacement);
    }
    else
    {
        // Less the mean displacement, as in `find`
        wakes_.search
        (
            grid_, p, p.x.colwise() - skin_.moved(), reach, displacement
        );
    }

    wakes_.involve(p);
}


void Foam::aerosol::encounterFinder::findWakes
(
    const neighbourList& candidates,
    const particleArrays& p,
    const stepEnd& end,
    const Eigen::Vector3d& meanDisplacement
)
{
    if (!motion_.wakes().active())
    {
        return;
    }

    const scalars displacement =
        displacements(p, end, meanDisplacement);

    sift
    (
        candidates,
        p,
        (p.range > 0).select(p.range + displacement, 0),
        displacement
    );
    wakes_.involve(p);
}


Foam::aerosol::encounters Foam::aerosol::encounterFinder::find
(
    const particleArrays& p,
    const stepEnd& end,
    const Eigen::Vector3d& meanDisplacement,
    const scalar h
)
{
    const int n = p.size();
    const bool Brownian = motion_.noise().active();

    const vectors& start = stepPaths::begin(p, end);
    const vectors& final = stepPaths::finish(end);

    const scalars stray =
        Brownian ? motion_.noise().reach(h, p).stray : scalars();

    // In the frame of the common motion
    const Eigen::Vector3d mean = meanDisplacement/h;

    const spheres sphereOf{meanDisplacement, h, Brownian};

    const auto sphereOfOwn = [&](const int i)
    {
        return sphereOf
        (
            p.x.col(i), start.col(i), end.x.col(i), final.col(i),
            p.collisionDiameter(i), Brownian ? stray(i) : 0.0
        );
    };

    scalars extra;
    if (Brownian)
    {
        extra = 0.5*p.collisionDiameter + strays*stray.sqrt();
    }

    const bool held = skin_.hold
    (
        p, start, end.x, final, h, meanDisplacement, 1 + margin, extra
    );
    skin_.move(meanDisplacement);

    if (communicator::max(!held) > 0)
    {
        // A particle left its skin, so that pairs may be missing: search
        vectors middle(3, n);
        scalars reach(n);
        double furthest = 0;

        for (int i = 0; i < n; ++i)
        {
            const pathSphere one = sphereOfOwn(i);
            middle.col(i) = one.middle;
            reach(i) = one.radius;

            // Those that are alike all bend away from their chords together
            const Eigen::Vector3d chord = 2*(one.middle - p.x.col(i));
            const double bulge = pathSphere::bulge
            (
                start.col(i) - mean, chord, final.col(i) - mean, h
            );
            furthest = std::max({furthest, chord.norm(), bulge});
        }

        // Less the mean displacement since the last migration, which brings no
        // particles together: else a mean flow would need ever more ghosts
        middle.colwise() -= skin_.moved() - meanDisplacement;

        skin_.expire();
        relative_.requireShort(furthest, h);
        searchContacts(p, middle, reach);
    }

    return find(contacts_, p, end, meanDisplacement, h);
}


Foam::aerosol::encounters Foam::aerosol::encounterFinder::find
(
    const neighbourList& candidates,
    const particleArrays& p,
    const stepEnd& end,
    const Eigen::Vector3d& meanDisplacement,
    const scalar h
)
{
    const int n = p.size();
    const bool Brownian = motion_.noise().active();

    const vectors& start = stepPaths::begin(p, end);
    const vectors& final = stepPaths::finish(end);

    paths_.fill(candidates.layer(), p, end, h);

    const scalars& stray = paths_.stray;
    const spheres sphereOf{meanDisplacement, h, Brownian};

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
            paths_.x0.col(c), paths_.v0.col(c), paths_.x1.col(c),
            paths_.v1.col(c), paths_.d(c), Brownian ? paths_.ghostStray(c) : 0.0
        );
    };

    pairs_.clear();
    std::vector<int> steps;

    for (const particlePair& pair : candidates.pairs())
    {
        const int i = pair.i;
        const int j = pair.j;

        const pathSphere a = sphereOfOwn(i);
        const pathSphere b = j < n ? sphereOfOwn(j) : sphereOfGhost(j - n);
        const double sum = a.radius + b.radius;

        if ((b.middle - a.middle).squaredNorm() > sum*sum)
        {
            continue;
        }

        pairs_.push_back(pair);
        steps.push_back(0);

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

            r0 += paths_.x0.col(c);
            chord += paths_.x1.col(c) - paths_.x0.col(c);
            v0 += paths_.v0.col(c);
            v1 += paths_.v1.col(c);
            radii += 0.5*paths_.d(c);
        }

        // The closest point of the straight line
        const double s =
            std::min
            (
                1.0,
                std::max(0.0, -r0.dot(chord)/(chord.squaredNorm() + VSMALL))
            );
        const double bulge = pathSphere::bulge(v0, chord, v1, h);
        const double closest = (r0 + s*chord).norm() - bulge;

        const double deviation =
            Brownian
          ? std::sqrt(stray(i) + (j < n ? stray(j) : paths_.ghostStray(j - n)))
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

            steps.back() = stepsNeeded(distance, deviation, resolved);
        }
    }

    counters_.contactPairs += pairs_.size();

    return {candidates.layer(), candidates.ghostId(), pairs_, steps};
}


void Foam::aerosol::encounterFinder::update
(
    particleArrays& p,
    const std::vector<char>& absorbed,
    const std::vector<int>& returned
)
{
    const int n = p.size();
    const bool withWakes = motion_.wakes().active();

    for (const int i : returned)
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

    contacts_.remove(absorbed, places, left);

    if (withWakes)
    {
        if (skin_.lasting())
        {
            wakeCandidates_.remove(absorbed, places, left);
        }
        aerosol::remove(listedRange_, absorbed);
    }

    skin_.remove(absorbed);
    p.remove(absorbed);
    contacts_.fillIds(p.id.cast<double>());
}


// ************************************************************************* //
