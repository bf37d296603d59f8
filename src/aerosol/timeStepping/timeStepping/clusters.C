/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The part of timeStepping that gathers in clusters, each at one rank, those
    particles that may meet, and brings them home again.

\*---------------------------------------------------------------------------*/

#include "timeStepping.H"

#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::aerosol;

//- Vectors of a member that come with its particle
constexpr int nVectors = 14;

//- Numbers of a member in a message: its cluster, its index at home, the
//  particle, the vectors
int memberLength(const particleArrays& p)
{
    return 2 + p.packedNumbers() + 3*nVectors;
}

//- Of a pair: its cluster, two ids, the image, the number of steps
constexpr int pairLength = 7;

//- Of a returned member: its index at home, whether it was absorbed, the
//  particle, its end
int returnLength(const particleArrays& p)
{
    return 2 + p.packedNumbers() + 6;
}


//- Room for one more record in a message
double* append(std::vector<double>& message, const int length)
{
    const std::size_t before = message.size();
    message.resize(before + length);

    return message.data() + before;
}


//- The records of all messages, each with the rank that it is from
std::vector<std::pair<const double*, int>> records
(
    const messages& received,
    const int length
)
{
    std::vector<std::pair<const double*, int>> all;

    for (std::size_t rank = 0; rank < received.size(); ++rank)
    {
        for (std::size_t k = 0; k < received[rank].size(); k += length)
        {
            all.push_back({received[rank].data() + k, int(rank)});
        }
    }

    return all;
}

} // End anonymous namespace


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

std::vector<Foam::aerosol::timeStepping::cluster>
Foam::aerosol::timeStepping::gatherClusters
(
    const particleArrays& p,
    const gasOfStep& gas,
    const Brownian::increments& increment,
    const std::vector<int>& steps
)
{
    const int n = p.size();
    const int nRanks = communicator::nRanks();

    const bool any =
        !steps.empty() && *std::max_element(steps.begin(), steps.end()) > 0;

    if (communicator::max(any) == 0)
    {
        return {};
    }

    // The marked particles, also by pairs of other ranks
    scalars marked = scalars::Zero(contactGhosts_.size());

    for (std::size_t k = 0; k < contactPairs_.size(); ++k)
    {
        if (steps[k])
        {
            marked(contactPairs_[k].i) = 1;
            marked(contactPairs_[k].j) = 1;
        }
    }

    contactGhosts_.spreadMax(marked);

    // A bounce may push a particle into a third one: include the neighbours of
    // both
    if (with_.collisions.bounces())
    {
        scalars hit = marked;

        for (const particlePair& pair : contactPairs_)
        {
            if (marked(pair.i) || marked(pair.j))
            {
                hit(pair.i) = 1;
                hit(pair.j) = 1;
            }
        }

        contactGhosts_.spreadMax(hit);
        marked.swap(hit);
    }

    // The pairs within clusters
    std::vector<std::size_t> inside;

    for (std::size_t k = 0; k < contactPairs_.size(); ++k)
    {
        if (marked(contactPairs_[k].i) || marked(contactPairs_[k].j))
        {
            inside.push_back(k);
        }
    }

    // The name of a cluster is its lowest id, and the rank that owns it. It
    // spreads along the pairs, negative, as the largest of all.
    scalars name(contactGhosts_.size());

    name.head(n) = -(p.id.cast<double>()*nRanks + communicator::rank());
    contactGhosts_.fill({{name, contactGhosts_}});

    scalars member = scalars::Zero(contactGhosts_.size());

    for (const std::size_t k : inside)
    {
        member(contactPairs_[k].i) = 1;
        member(contactPairs_[k].j) = 1;
    }

    contactGhosts_.spreadMax(member);

    for (bool first = true; ; first = false)
    {
        bool changed = false;

        for (bool again = true; again; )
        {
            again = false;

            for (const std::size_t k : inside)
            {
                double& a = name(contactPairs_[k].i);
                double& b = name(contactPairs_[k].j);

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

        contactGhosts_.spreadMax(name);
    }

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

    const gasStep air = gas.some(own);

    for (std::size_t k = 0; k < own.size(); ++k)
    {
        const int i = own[k];
        double* to = append(members[home(name(i))], memberLength(p));

        *to++ = name(i);
        *to++ = i;
        p.pack(i, to);
        to += p.packedNumbers();

        const auto add = [&](const vectors& v, const int column)
        {
            Eigen::Map<Eigen::Vector3d> numbers(to);

            if (v.cols() && column >= 0)
            {
                numbers = v.col(column);
            }
            else
            {
                numbers.setZero();
            }
            to += 3;
        };

        const auto addStep = [&](const gasStep& step, const int column)
        {
            add(step.u0, column);
            add(step.um, column);
            add(step.u1, column);
        };

        const int place = with_.motion.hasWakes() ? place_[i] : -1;

        addStep(air, k);
        addStep(wakes_, place);
        addStep(wakesX_, place);
        addStep(wakesSlip_, place);
        add(increment.v, i);
        add(increment.x, i);
    }

    for (const std::size_t k : inside)
    {
        const particlePair& pair = contactPairs_[k];
        double* to = append(pairs[home(name(pair.i))], pairLength);
        const periods image = contactGhosts_.image(pair.j);

        *to++ = name(pair.i);
        *to++ = static_cast<double>(p.id(pair.i));
        *to++ =
            pair.j < n ? static_cast<double>(p.id(pair.j))
          : ghostId_(pair.j - n);
        *to++ = image[0];
        *to++ = image[1];
        *to++ = image[2];
        *to++ = steps[k];
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

        const int size = static_cast<int>(last - from);

        one.p.resizeHistory(p.history.rows());
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

        for (int m = 0; m < size; ++m, ++from)
        {
            const double* numbers = from->first + 1;

            one.home.push_back({from->second, static_cast<int>(*numbers++)});
            one.p.unpack(m, numbers);
            numbers += p.packedNumbers();

            for (vectors* v : to)
            {
                v->col(m) = Eigen::Map<const Eigen::Vector3d>(numbers);
                numbers += 3;
            }
        }

        if (!gas.parabola)
        {
            one.gas.um.resize(3, 0);
        }
        if (!withMiddle_)
        {
            one.wakes.um.resize(3, 0);
        }

        if (!with_.motion.hasBrownian())
        {
            one.increment.v.resize(3, 0);
            one.increment.x.resize(3, 0);
        }

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
            const double* numbers = nextPair->first;

            const int i = place(numbers[1]);
            const int j = place(numbers[2]);

            periods image;
            for (int k = 0; k < 3; ++k)
            {
                image[k] = static_cast<std::int8_t>(numbers[3 + k]);
            }

            one.contactPairs.push_back({i, j, image});
            one.nSteps = std::max(one.nSteps, static_cast<int>(numbers[6]));
        }

        effort_.clusterMembers += size;
    }

    return clusters;
}


std::vector<char> Foam::aerosol::timeStepping::disperse
(
    const std::vector<cluster>& clusters,
    particleArrays& p,
    equationOfMotion::state& end
)
{
    messages send(communicator::nRanks());

    for (const cluster& one : clusters)
    {
        for (int m = 0; m < one.p.size(); ++m)
        {
            double* to = append(send[one.home[m].first], returnLength(p));

            *to++ = one.home[m].second;
            *to++ = one.absorbed[m];
            one.p.pack(m, to);
            to += p.packedNumbers();
            Eigen::Map<Eigen::Vector3d> x(to);
            Eigen::Map<Eigen::Vector3d> v(to + 3);
            x = one.p.x.col(m);
            v = one.p.v.col(m);
        }
    }

    const messages received = communicator::exchange(std::move(send));

    std::vector<char> absorbed(p.size(), 0);
    returned_.clear();

    for (const auto& record : records(received, returnLength(p)))
    {
        const double* numbers = record.first;
        const int i = static_cast<int>(*numbers++);

        returned_.push_back(i);
        absorbed[i] = *numbers++ > 0;
        p.unpack(i, numbers);
        numbers += p.packedNumbers();
        end.x.col(i) = Eigen::Map<const Eigen::Vector3d>(numbers);
        end.v.col(i) = Eigen::Map<const Eigen::Vector3d>(numbers + 3);
        if (end.thermal.cols())
        {
            end.thermal.col(i) = p.thermal.col(i);
        }
    }

    return absorbed;
}


// ************************************************************************* //
