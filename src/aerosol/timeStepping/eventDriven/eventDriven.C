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

//- More steps than this are not needed: contact ends the approach
constexpr int maxSteps = 64;

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
          + bulgeOf(p.v.col(i) - mean, chord, end.v.col(i) - mean)
          + (1 + margin)*0.5*p.d(i);
    }

    searchContacts(p, middle, reach);
    fillPaths(p, end);

    std::vector<int> steps(contactPairs_.size(), 0);

    for (std::size_t k = 0; k < contactPairs_.size(); ++k)
    {
        const int i = contactPairs_[k].i;
        const int j = contactPairs_[k].j;

        Eigen::Vector3d r0 = -p.x.col(i);
        Eigen::Vector3d chord = p.x.col(i) - end.x.col(i);
        Eigen::Vector3d v0 = -p.v.col(i);
        Eigen::Vector3d v1 = -end.v.col(i);
        double radii = 0.5*p.d(i);

        if (j < n)
        {
            r0 += p.x.col(j);
            chord += end.x.col(j) - p.x.col(j);
            v0 += p.v.col(j);
            v1 += end.v.col(j);
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

        if (closest < encounter*radii)
        {
            const double way = chord.norm() + 2*bulge;

            steps[k] = static_cast<int>
            (
                std::max
                (
                    1.0,
                    std::min
                    (
                        double(maxSteps),
                        std::ceil(way/(resolution_*std::max(closest, radii)))
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
    const scalar h
)
{
    if (!begin(p))
    {
        return;
    }

    const gasStep gas = sampleGas(p, t, h, true);

    // That no particle gets too far
    relativeWay(p, gas, h);

    equationOfMotion::state end;

    searchWakes(p, p.range, false);
    moveAll(h, p, gas, true, end);

    if (with_.contacts.active())
    {
        const std::vector<int> steps = findEncounters(p, end, h);

        std::vector<group> groups = gatherGroups(p, gas, steps);

        for (group& one : groups)
        {
            follow(one, t, h, 0);
        }

        with_.contacts.share();

        const std::vector<char> absorbed = disperse(groups, p, end);

        p.x.swap(end.x);
        p.v.swap(end.v);

        if (std::find(absorbed.begin(), absorbed.end(), 1) != absorbed.end())
        {
            p.remove(absorbed);
        }
    }
    else
    {
        p.x.swap(end.x);
        p.v.swap(end.v);
    }

    with_.region.confine(p);
}


// ************************************************************************* //
