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

    for (int i = 0; i < n; ++i)
    {
        const Eigen::Vector3d chord = end.x.col(i) - p.x.col(i) - h*mean;

        middle.col(i) = p.x.col(i) + 0.5*chord;
        reach(i) =
            0.5*chord.norm()
          + bulgeOf(start.col(i) - mean, chord, final.col(i) - mean)
          + 0.5*p.d(i)
          + std::max
            (
                margin*0.5*p.d(i),
                Brownian ? strays*std::sqrt(stray(i)) : 0.0
            );
    }

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


void Foam::aerosol::eventDriven::follow
(
    group& one,
    const scalar t,
    const scalar h
)
{
    const int n = one.p.size();
    const scalar hs = h/one.nSteps;

    // Wakes from outside are linear in time over the long step
    vectors outside0;
    vectors outside1;
    outsideWakes(one, outside0, outside1);

    gasStep now;
    now.u0 = one.gas.u0;

    vectors outside = outside0;
    vectors w0;

    with_.motion.wakes
    (
        one.p, one.wakePairs, one.p.x,
        with_.motion.drift(one.p.v, one.p.thermal), now.u0, w0
    );
    w0 += outside;

    // The noise of the step is known already; whether they are here depends on
    // it
    std::vector<Brownian::kicks> kicks;
    const bool noisy = with_.motion.hasBrownian();

    with_.motion.bridge
    (
        h, one.p, step_, block(noise::parts, 0), one.nSteps, one.end.kick,
        kicks
    );

    for (int s = 0; s < one.nSteps; ++s)
    {
        const scalar done = scalar(s + 1)/one.nSteps;

        now.u1 = one.gas.at(done);
        outside = outside0 + done*(outside1 - outside0);

        if (noisy)
        {
            one.end.kick = kicks[s];

            // Who has grown moves on with noise of its own
            for (std::size_t i = 0; i < one.grown.size(); ++i)
            {
                if (one.grown[i])
                {
                    const particleArrays grown = one.p.select({int(i)});

                    Brownian::kicks own;
                    with_.motion.kick
                    (
                        hs, grown, step_, block(noise::grown, s), own
                    );
                    one.end.kick.v.col(i) = own.v;
                    one.end.kick.x.col(i) = own.x;
                }
            }
        }

        with_.motion.step
        (
            hs, one.p, one.wakePairs, now, w0, outside, one.end
        );

        collide(one, now, outside, t + s*hs, hs, 0, s);

        with_.motion.arrive(one.p, one.end);
        w0.swap(one.end.w);
        now.u0.swap(now.u1);
    }

    // Where the last step has ended
    one.end.x = one.p.x;
    one.end.v = one.p.v;
    one.end.thermal = one.p.thermal;
    one.absorbed = with_.contacts.takeAbsorbed(n);

    effort_.groupMoves += scalar(one.nSteps)*n;
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

    // That no particle gets too far
    relativeWay(p, gas, h);

    vectors w0;
    equationOfMotion::state end;

    searchWakes(p, p.range, false);
    wakesOfAll(p.x, gas.u0 - (p.v - p.thermal), w0);
    moveAll(h, p, gas, w0, 0, end);

    if (with_.contacts.active())
    {
        const std::vector<int> steps = findEncounters(p, end, h);

        std::vector<group> groups = gatherGroups(p, gas, w0, end, steps);

        for (group& one : groups)
        {
            follow(one, t, h);
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
