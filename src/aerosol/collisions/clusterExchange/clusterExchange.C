/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "clusterExchange.H"
#include "packedRecord.H"

#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::aerosol;

//- Vectors of a member that come with its particle
constexpr int nVectors = 14;

//- Numbers of a member in a message: its cluster, its index at home, the
//  particle, the vectors
int memberLength(const particleArrays& p)
{
    return 2 + p.packedNumbers() + 3*nVectors;
}

//- Further away than any wake reaches, but with a finite square [m]
constexpr double farAway = 1e100;

//- Of a pair: its cluster, two ids, the image, the number of steps
constexpr int pairLength = 7;

//- Of a returned member: its index at home, whether it was absorbed, the
//  particle, its end
int returnLength(const particleArrays& p)
{
    return 2 + p.packedNumbers() + 6;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::clusterExchange::clusterExchange
(
    const equationOfMotion& motion,
    const collisions& meetings,
    stepCounters& counters
)
:
    motion_(motion),
    collisions_(meetings),
    counters_(counters)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::aerosol::scalars
Foam::aerosol::clusterExchange::inEncounters(const encounters& found) const
{
    // Also by pairs of other ranks
    scalars marked = scalars::Zero(found.layer.size());

    for (std::size_t k = 0; k < found.pairs.size(); ++k)
    {
        if (found.steps[k])
        {
            marked(found.pairs[k].i) = 1;
            marked(found.pairs[k].j) = 1;
        }
    }

    found.layer.spreadMax(marked);

    if (collisions_.bounces())
    {
        scalars hit = marked;

        for (const particlePair& pair : found.pairs)
        {
            if (marked(pair.i) || marked(pair.j))
            {
                hit(pair.i) = 1;
                hit(pair.j) = 1;
            }
        }

        found.layer.spreadMax(hit);
        marked.swap(hit);
    }

    return marked;
}


Foam::aerosol::scalars Foam::aerosol::clusterExchange::clusterNames
(
    const particleArrays& p,
    const encounters& found,
    const std::vector<std::size_t>& inside
)
{
    scalars name(found.layer.size());

    name.head(p.size()) =
        -(p.id.cast<double>()*communicator::nRanks() + communicator::rank());
    found.layer.fill({{name, found.layer}});

    for (bool first = true; ; first = false)
    {
        bool changed = false;

        for (bool again = true; again; )
        {
            again = false;

            for (const std::size_t k : inside)
            {
                double& a = name(found.pairs[k].i);
                double& b = name(found.pairs[k].j);

                if (a != b)
                {
                    a = b = std::max(a, b);
                    again = changed = true;
                }
            }
        }

        if (!first && communicator::max(changed) == 0)
        {
            break;
        }

        found.layer.spreadMax(name);
    }

    return name;
}


void Foam::aerosol::clusterExchange::unpack
(
    cluster& one,
    const std::vector<std::pair<const double*, int>>& members,
    const particleArrays& alike,
    const bool parabola,
    const bool withMiddle
) const
{
    const int size = static_cast<int>(members.size());

    one.p.resizeHistory(alike.history.rows());
    one.p.resize(size);
    one.p.resizeLaws();

    const std::array<vectors*, nVectors> to
    {
        &one.gas.u0, &one.gas.um, &one.gas.u1,
        &one.wakes.u0, &one.wakes.um, &one.wakes.u1,
        &one.x.u0, &one.x.um, &one.x.u1,
        &one.slip.u0, &one.slip.um, &one.slip.u1,
        &one.increment.v, &one.increment.x
    };

    for (vectors* v : to)
    {
        v->resize(3, size);
    }

    for (int m = 0; m < size; ++m)
    {
        recordReader record(members[m].first + 1);

        one.home.push_back
        ({
            members[m].second, static_cast<int>(record.number())
        });
        one.p.unpack(m, record.numbers(alike.packedNumbers()));

        for (vectors* v : to)
        {
            v->col(m) = record.vector();
        }
    }

    if (!parabola)
    {
        one.gas.um.resize(3, 0);
    }
    if (!withMiddle)
    {
        one.wakes.um.resize(3, 0);
    }

    if (!motion_.noise().active())
    {
        one.increment.v.resize(3, 0);
        one.increment.x.resize(3, 0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<Foam::aerosol::cluster> Foam::aerosol::clusterExchange::gather
(
    const particleArrays& p,
    const stepGas& gas,
    const Brownian::increments& increment,
    const neighbourWakes& wakes,
    const encounters& found
)
{
    const int n = p.size();
    const int nRanks = communicator::nRanks();

    const bool any =
        !found.steps.empty()
     && *std::max_element(found.steps.begin(), found.steps.end()) > 0;

    if (communicator::max(any) == 0)
    {
        return {};
    }

    const scalars marked = inEncounters(found);

    // The pairs within clusters, and their members
    std::vector<std::size_t> inside;
    scalars member = scalars::Zero(found.layer.size());

    for (std::size_t k = 0; k < found.pairs.size(); ++k)
    {
        const particlePair& pair = found.pairs[k];

        if (marked(pair.i) || marked(pair.j))
        {
            inside.push_back(k);
            member(pair.i) = 1;
            member(pair.j) = 1;
        }
    }

    found.layer.spreadMax(member);

    const scalars name = clusterNames(p, found, inside);

    const auto home = [&](const double clusterName)
    {
        return static_cast<int>
        (
            static_cast<std::int64_t>(-clusterName) % nRanks
        );
    };

    // Members and pairs go there
    messages members(nRanks);
    messages pairs(nRanks);

    std::vector<int> own;

    for (int i = 0; i < n; ++i)
    {
        if (member(i))
        {
            own.push_back(i);
        }
    }

    const stepValues air = gas.some(own);

    for (std::size_t k = 0; k < own.size(); ++k)
    {
        const int i = own[k];
        recordWriter record(members[home(name(i))]);

        record << name(i) << double(i);
        p.pack(i, record.room(p.packedNumbers()));

        const auto add =
        [&](const vectors& v, const int column, const double otherwise = 0)
        {
            record
             << (
                    v.cols() && column >= 0
                  ? Eigen::Vector3d(v.col(column))
                  : Eigen::Vector3d(Eigen::Vector3d::Constant(otherwise))
                );
        };

        const auto addStep =
        [&]
        (
            const stepValues& step,
            const int column,
            const double otherwise = 0
        )
        {
            add(step.u0, column, otherwise);
            add(step.um, column, otherwise);
            add(step.u1, column, otherwise);
        };

        const int place = wakes.place(i);

        // A member without wakes is out of range of those of the others
        addStep(air, k);
        addStep(wakes.values(), place);
        addStep(wakes.x(), place, farAway);
        addStep(wakes.slip(), place);
        add(increment.v, i);
        add(increment.x, i);
    }

    for (const std::size_t k : inside)
    {
        const particlePair& pair = found.pairs[k];
        const periods image = found.layer.image(pair.j);

        recordWriter(pairs[home(name(pair.i))])
            << name(pair.i)
            << double(p.id(pair.i))
            << (
                    pair.j < n ? double(p.id(pair.j))
                  : found.ghostId(pair.j - n)
               )
            << double(image[0]) << double(image[1]) << double(image[2])
            << double(found.steps[k]);
    }

    const messages receivedMembers = communicator::exchange(std::move(members));
    const messages receivedPairs = communicator::exchange(std::move(pairs));

    auto arrived = records(receivedMembers, memberLength(p));
    auto arrivedPairs = records(receivedPairs, pairLength);

    // Cluster by cluster, in the order of the ids: name, index, id
    std::sort
    (
        arrived.begin(),
        arrived.end(),
        [](const auto& a, const auto& b)
        {
            return
                std::tie(a.first[0], a.first[2])
              < std::tie(b.first[0], b.first[2]);
        }
    );

    std::sort
    (
        arrivedPairs.begin(),
        arrivedPairs.end(),
        [](const auto& a, const auto& b)
        {
            return std::lexicographical_compare
            (
                a.first, a.first + pairLength, b.first, b.first + pairLength
            );
        }
    );

    std::vector<cluster> clusters;
    auto nextPair = arrivedPairs.begin();

    for (auto from = arrived.begin(); from != arrived.end(); )
    {
        const double clusterName = from->first[0];

        const auto last = std::find_if
        (
            from,
            arrived.end(),
            [&](const auto& r)
            {
                return r.first[0] != clusterName;
            }
        );

        clusters.emplace_back();
        cluster& one = clusters.back();

        unpack(one, {from, last}, p, gas.parabola, wakes.withMiddle());
        from = last;

        const int size = one.p.size();

        const auto place = [&](const double id)
        {
            return static_cast<int>
            (
                std::lower_bound
                (
                    one.p.id.data(), one.p.id.data() + size, std::int64_t(id)
                )
              - one.p.id.data()
            );
        };

        for
        (
            ;
            nextPair != arrivedPairs.end()
         && nextPair->first[0] == clusterName;
            ++nextPair
        )
        {
            recordReader record(nextPair->first + 1);

            const int i = place(record.number());
            const int j = place(record.number());

            periods image;
            for (std::int8_t& count : image)
            {
                count = static_cast<std::int8_t>(record.number());
            }

            one.contactPairs.push_back({i, j, image});
            one.nSteps =
                std::max(one.nSteps, static_cast<int>(record.number()));
        }

        counters_.clusterMembers += size;
    }

    return clusters;
}


std::vector<char> Foam::aerosol::clusterExchange::scatter
(
    const std::vector<cluster>& clusters,
    particleArrays& p,
    stepEnd& end
)
{
    messages send(communicator::nRanks());

    for (const cluster& one : clusters)
    {
        for (int m = 0; m < one.p.size(); ++m)
        {
            recordWriter record(send[one.home[m].first]);

            record << double(one.home[m].second) << double(one.absorbed[m]);
            one.p.pack(m, record.room(p.packedNumbers()));
            record << one.p.x.col(m) << one.p.v.col(m);
        }
    }

    const messages received = communicator::exchange(std::move(send));

    std::vector<char> absorbed(p.size(), 0);
    returned_.clear();

    for (const auto& from : records(received, returnLength(p)))
    {
        recordReader record(from.first);
        const int i = static_cast<int>(record.number());

        returned_.push_back(i);
        absorbed[i] = record.number() > 0;
        p.unpack(i, record.numbers(p.packedNumbers()));
        end.x.col(i) = record.vector();
        end.v.col(i) = record.vector();
        if (end.thermal.cols())
        {
            end.thermal.col(i) = p.thermal.col(i);
        }
    }

    return absorbed;
}


// ************************************************************************* //
