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

//- More steps than this are not needed: contact ends the approach. Brownian
//  motion strays as the root of time, and needs more.
constexpr int maxSteps = 64;
constexpr int maxBrownianSteps = 1024;

//- In standard deviations of the Wiener process: how far a pair is taken to
//  stray from its straight way, which it exceeds with a probability of 1e-8,
//  and how far for the choice of the steps
constexpr double strays = 3;
constexpr double straysOften = 1.5;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::eventDriven::eventDriven
(
    const dictionary& dict,
    const tools& with
)
:
    timeStepping(with),
    resolution_(readFraction(dict, "resolution", 0.25))
{
    requireOnly(dict, {"type", "resolution"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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

    // In the frame of the mean motion
    const Eigen::Vector3d mean = bricks::mean((end.x - p.x)/h);

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

    vectors middle(3, n);
    scalars reach(n);
    scalar furthest = 0;

    for (int i = 0; i < n; ++i)
    {
        const Eigen::Vector3d chord = end.x.col(i) - p.x.col(i) - h*mean;

        furthest = std::max(furthest, chord.norm());
        middle.col(i) = p.x.col(i) + 0.5*chord;
        reach(i) =
            0.5*chord.norm()
          + bulgeOf(start.col(i) - mean, chord, final.col(i) - mean)
          + std::max
            (
                (1 + margin)*0.5*p.d(i),
                0.5*p.d(i) + (Brownian ? strays*std::sqrt(stray(i)) : 0.0)
            );
    }

    requireShort(furthest, h);
    searchContacts(p, middle, reach);
    fillPaths(p, end, h);

    std::vector<int> steps(contactPairs_.size(), 0);

    for (std::size_t k = 0; k < contactPairs_.size(); ++k)
    {
        const int i = contactPairs_[k].i;
        const int j = contactPairs_[k].j;

        Eigen::Vector3d r0 = -p.x.col(i);
        Eigen::Vector3d chord = p.x.col(i) - end.x.col(i);
        Eigen::Vector3d v0 = -start.col(i);
        Eigen::Vector3d v1 = -final.col(i);
        double radii = 0.5*p.d(i);

        if (j < n)
        {
            r0 += p.x.col(j);
            chord += end.x.col(j) - p.x.col(j);
            v0 += start.col(j);
            v1 += final.col(j);
            radii += 0.5*p.d(j);
        }
        else
        {
            const int c = j - n;

            r0 += copiesX0_.col(c);
            chord += copiesX1_.col(c) - copiesX0_.col(c);
            v0 += copiesV0_.col(c);
            v1 += copiesV1_.col(c);
            radii += 0.5*copiesD_(c);
        }

        // The closest point of the straight way
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
          ? std::sqrt(stray(i) + (j < n ? stray(j) : copiesStray_(j - n)))
          : 0;

        if
        (
            closest < encounter*radii
         || closest < radii + strays*deviation
        )
        {
            const double way = chord.norm() + 2*bulge;

            const double resolved =
                resolution_
               *std::max(closest - straysOften*deviation, radii);

            steps[k] = static_cast<int>
            (
                std::max
                (
                    1.0,
                    std::min
                    (
                        double(maxSteps),
                        std::ceil(way/resolved)
                    )
                )
            );

            steps[k] =
                std::max
                (
                    steps[k],
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

    return steps;
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
    if (!begin(p, step))
    {
        return;
    }

    const gasStep gas = sampleGas(p, t, h, true);

    equationOfMotion::state end;

    searchWakes(p, p.range, false);
    moveAll(h, p, gas, true, 0, end);

    if (with_.contacts.active())
    {
        const std::vector<int> steps = findEncounters(p, end, h);

        std::vector<group> groups = gatherGroups(p, gas, end.kick, steps);

        for (group& one : groups)
        {
            follow(one, t, h, 0, 0);
        }

        with_.contacts.share();

        const std::vector<char> absorbed = disperse(groups, p, end);

        with_.motion.arrive(p, end);

        if (std::find(absorbed.begin(), absorbed.end(), 1) != absorbed.end())
        {
            p.remove(absorbed);
        }
    }
    else
    {
        with_.motion.arrive(p, end);
    }

    with_.region.confine(p);
}


// ************************************************************************* //
