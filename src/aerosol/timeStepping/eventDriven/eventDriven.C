/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eventDriven.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

#include <algorithm>
#include <numeric>

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

std::vector<Foam::aerosol::eventDriven::group>
Foam::aerosol::eventDriven::findGroups
(
    const particleArrays& p,
    const equationOfMotion::state& end,
    const scalar h
)
{
    const int n = p.size();
    const Eigen::Array3d period = with_.region.period();

    // In the frame of the mean motion
    const Eigen::Vector3d meanChord = (end.x - p.x).rowwise().mean();
    const Eigen::Vector3d meanV0 = p.v.rowwise().mean();
    const Eigen::Vector3d meanV1 = end.v.rowwise().mean();

    vectors middle(3, n);
    scalars reach(n);

    for (int i = 0; i < n; ++i)
    {
        const Eigen::Vector3d chord = end.x.col(i) - p.x.col(i) - meanChord;

        // Hermite's cubic is no further from its chord than this
        const double bulge =
            4.0/27.0
           *(
                (h*(p.v.col(i) - meanV0) - chord).norm()
              + (h*(end.v.col(i) - meanV1) - chord).norm()
            );

        middle.col(i) = p.x.col(i) + 0.5*chord;
        reach(i) = 0.5*chord.norm() + bulge + (1 + margin)*0.5*p.d(i);
    }

    grid_.build(middle, reach);
    grid_.touching(contactPairs_);

    // Groups as trees: the root of each is its first particle
    std::vector<int> parent(n);
    std::iota(parent.begin(), parent.end(), 0);

    const auto root = [&](int i)
    {
        while (parent[i] != i)
        {
            i = parent[i] = parent[parent[i]];
        }
        return i;
    };

    const auto join = [&](const int i, const int j)
    {
        const int a = root(i);
        const int b = root(j);
        parent[std::max(a, b)] = std::min(a, b);
    };

    // Pairs in an encounter, and how many steps they need
    std::vector<int> steps(n, 0);

    for (const particlePair& pair : contactPairs_)
    {
        const int i = pair.i;
        const int j = pair.j;

        Eigen::Vector3d r0 = p.x.col(j) - p.x.col(i);
        for (int k = 0; k < 3; ++k)
        {
            r0(k) += pair.image[k]*period(k);
        }

        const Eigen::Vector3d chord =
            end.x.col(j) - p.x.col(j) - end.x.col(i) + p.x.col(i);
        const double bulge =
            4.0/27.0
           *(
                (h*(p.v.col(j) - p.v.col(i)) - chord).norm()
              + (h*(end.v.col(j) - end.v.col(i)) - chord).norm()
            );

        // The closest point of the straight way
        const double s =
            std::min
            (
                1.0,
                std::max(0.0, -r0.dot(chord)/(chord.squaredNorm() + VSMALL))
            );
        const double closest = (r0 + s*chord).norm() - bulge;
        const double radii = 0.5*(p.d(i) + p.d(j));

        if (closest < encounter*radii)
        {
            const double way = chord.norm() + 2*bulge;
            const int needed =
                std::min
                (
                    double(maxSteps),
                    std::ceil(way/(resolution_*std::max(closest, radii)))
                );

            steps[i] = std::max(steps[i], std::max(needed, 1));
            steps[j] = std::max(steps[j], std::max(needed, 1));
            join(i, j);
        }
    }

    // Those whom members could meet instead belong to the group, too
    std::vector<char> inEncounter(n);
    for (int i = 0; i < n; ++i)
    {
        inEncounter[i] = steps[i] > 0;
    }

    for (const particlePair& pair : contactPairs_)
    {
        if (inEncounter[pair.i] || inEncounter[pair.j])
        {
            join(pair.i, pair.j);
            steps[pair.i] = std::max(steps[pair.i], 1);
            steps[pair.j] = std::max(steps[pair.j], 1);
        }
    }

    std::vector<group> groups;
    groupOf_.assign(n, -1);

    for (int i = 0; i < n; ++i)
    {
        if (steps[i] > 0)
        {
            const int first = root(i);

            if (groupOf_[first] < 0)
            {
                groupOf_[first] = static_cast<int>(groups.size());
                groups.emplace_back();
            }

            groupOf_[i] = groupOf_[first];
            groups[groupOf_[i]].members.push_back(i);
            groups[groupOf_[i]].nSteps =
                std::max(groups[groupOf_[i]].nSteps, steps[i]);
        }
    }

    // Pairs within the groups, by the places of the particles in them
    std::vector<int> place(n);
    for (const group& one : groups)
    {
        for (std::size_t m = 0; m < one.members.size(); ++m)
        {
            place[one.members[m]] = static_cast<int>(m);
        }
    }

    const auto within = [&](const particlePair& pair)
    {
        return groupOf_[pair.i] >= 0 && groupOf_[pair.i] == groupOf_[pair.j];
    };

    for (const particlePair& pair : contactPairs_)
    {
        if (within(pair))
        {
            groups[groupOf_[pair.i]].contactPairs.push_back
            (
                {place[pair.i], place[pair.j], pair.image}
            );
        }
    }

    for (const particlePair& pair : wakePairs_)
    {
        if (within(pair))
        {
            groups[groupOf_[pair.i]].wakePairs.push_back
            (
                {place[pair.i], place[pair.j], pair.image}
            );
        }
    }

    return groups;
}


void Foam::aerosol::eventDriven::follow
(
    group& one,
    particleArrays& p,
    const gasStep& gas,
    const vectors& w0,
    equationOfMotion::state& end,
    const scalar t,
    const scalar h,
    std::vector<char>& absorbed
)
{
    const std::vector<int>& members = one.members;
    const int n = static_cast<int>(members.size());

    particleArrays local;
    local.id = p.id(members);
    local.x = p.x(Eigen::all, members);
    local.v = p.v(Eigen::all, members);
    local.d = p.d(members);
    local.m = p.m(members);
    local.primaries = p.primaries(members);

    gasStep localGas;
    localGas.u0 = gas.u0(Eigen::all, members);
    localGas.um = gas.um(Eigen::all, members);
    localGas.u1 = gas.u1(Eigen::all, members);

    with_.motion.refresh(local);

    // Wakes from outside of the group: all less those from inside, at the
    // ends of the long step
    vectors outside0 = w0(Eigen::all, members);
    vectors outside1 = end.w(Eigen::all, members);
    vectors inside;

    with_.motion.wakes
    (
        local, one.wakePairs, local.x, local.v, localGas.u0, inside
    );
    outside0 -= inside;

    with_.motion.wakes
    (
        local,
        one.wakePairs,
        end.x(Eigen::all, members),
        end.v(Eigen::all, members),
        localGas.u1,
        inside
    );
    outside1 -= inside;

    wakePairs_.swap(one.wakePairs);
    contactPairs_.swap(one.contactPairs);

    march(local, localGas, outside0, outside1, t, h, one.nSteps, 0);

    effort_.particleSteps += one.nSteps;

    const std::vector<char> gone = with_.contacts.takeAbsorbed(n);

    for (int m = 0; m < n; ++m)
    {
        const int i = members[m];

        end.x.col(i) = local.x.col(m);
        end.v.col(i) = local.v.col(m);
        p.d(i) = local.d(m);
        p.m(i) = local.m(m);
        p.primaries(i) = local.primaries(m);
        absorbed[i] = gone[m];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::eventDriven::advance
(
    particleArrays& p,
    const scalar t,
    const scalar h
)
{
    ++effort_.fluidSteps;

    if (!p.size())
    {
        return;
    }

    with_.motion.refresh(p);

    const gasStep gas = sampleGas(p, t, h, true);

    searchWakes(p, relativeWay(p, gas, h));

    vectors w0;
    equationOfMotion::state end;

    with_.motion.wakes(p, wakePairs_, p.x, p.v, gas.u0, w0);
    with_.motion.step(h, p, wakePairs_, gas, w0, {}, end);

    ++effort_.particleSteps;
    effort_.wakePairs += wakePairs_.size();

    if (with_.contacts.active())
    {
        std::vector<char> absorbed(p.size(), 0);
        std::vector<group> groups = findGroups(p, end, h);

        effort_.contactPairs += contactPairs_.size();

        for (group& one : groups)
        {
            follow(one, p, gas, w0, end, t, h, absorbed);
        }

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
