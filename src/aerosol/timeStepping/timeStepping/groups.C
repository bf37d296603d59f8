/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The part of timeStepping that gathers in groups, each at one rank, those
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
constexpr int nVectors = 11;

//- Numbers of a member in a message: its group, its index where it comes from,
//  the particle, the vectors
constexpr int memberLength = 2 + particleArrays::nNumbers + 3*nVectors;

//- Of a pair: its group, two ids, the image, the number of steps
constexpr int pairLength = 7;

//- Of a member on its way home: its index there, whether it was absorbed, the
//  particle, its end
constexpr int returnLength = 2 + particleArrays::nNumbers + 9;


//- Room for one more record in a message
double* append(std::vector<double>& message, const int length)
{
    const std::size_t before = message.size();
    message.resize(before + length);

    return message.data() + before;
}


//- Send messages, one to each rank; those received
List<List<double>> exchange(const std::vector<std::vector<double>>& messages)
{
    List<List<double>> lists(messages.size());

    forAll(lists, rank)
    {
        const std::vector<double>& message = messages[rank];

        lists[rank].resize(message.size());
        std::copy(message.begin(), message.end(), lists[rank].begin());
    }

    return bricks::exchange(lists);
}


//- The records of all messages, each with the rank that it is from
std::vector<std::pair<const double*, int>> records
(
    const List<List<double>>& messages,
    const int length
)
{
    std::vector<std::pair<const double*, int>> all;

    forAll(messages, rank)
    {
        for (label k = 0; k < messages[rank].size(); k += length)
        {
            all.push_back({messages[rank].cdata() + k, int(rank)});
        }
    }

    return all;
}

} // End anonymous namespace


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

std::vector<Foam::aerosol::timeStepping::group>
Foam::aerosol::timeStepping::gatherGroups
(
    const particleArrays& p,
    const gasStep& gas,
    const vectors& w0,
    const equationOfMotion::state& end,
    const std::vector<int>& steps
)
{
    const int n = p.size();
    const int nRanks = bricks::nRanks();

    const bool any =
        !steps.empty() && *std::max_element(steps.begin(), steps.end()) > 0;

    if (bricks::max(any) == 0)
    {
        return {};
    }

    // Who is marked, also by pairs of other ranks
    scalars marked = scalars::Zero(contactHalo_.size());

    for (std::size_t k = 0; k < contactPairs_.size(); ++k)
    {
        if (steps[k])
        {
            marked(contactPairs_[k].i) = 1;
            marked(contactPairs_[k].j) = 1;
        }
    }

    contactHalo_.spreadMax(marked);

    // The pairs within groups
    std::vector<std::size_t> inside;

    for (std::size_t k = 0; k < contactPairs_.size(); ++k)
    {
        if (marked(contactPairs_[k].i) || marked(contactPairs_[k].j))
        {
            inside.push_back(k);
        }
    }

    // The name of a group is its lowest id, and the rank where that is at home.
    // It spreads along the pairs, negative, as the largest of all.
    scalars name(contactHalo_.size());

    name.head(n) = -(p.id.cast<double>()*nRanks + bricks::here());
    contactHalo_.fill({{name, contactHalo_}});

    scalars member = scalars::Zero(contactHalo_.size());

    for (const std::size_t k : inside)
    {
        member(contactPairs_[k].i) = 1;
        member(contactPairs_[k].j) = 1;
    }

    contactHalo_.spreadMax(member);

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

        if (!first && bricks::max(changed) == 0)
        {
            break;
        }

        contactHalo_.spreadMax(name);
    }

    const auto home = [&](const double groupName)
    {
        return static_cast<int>
        (
            static_cast<std::int64_t>(-groupName) % nRanks
        );
    };

    // Members and pairs go there
    std::vector<std::vector<double>> members(nRanks);
    std::vector<std::vector<double>> pairs(nRanks);

    for (int i = 0; i < n; ++i)
    {
        if (member(i))
        {
            double* to = append(members[home(name(i))], memberLength);

            *to++ = name(i);
            *to++ = i;
            p.pack(i, to);
            to += particleArrays::nNumbers;

            const Eigen::Vector3d zero = Eigen::Vector3d::Zero();

            for
            (
                const Eigen::Vector3d& v :
                std::array<Eigen::Vector3d, nVectors>
                {
                    gas.u0.col(i),
                    gas.um.cols() ? gas.um.col(i) : zero,
                    gas.u1.col(i),
                    w0.col(i),
                    end.x.col(i),
                    end.v.col(i),
                    end.w.col(i),
                    sources_.x.cols() ? sources_.x.col(i) : zero,
                    sources_.slip.cols() ? sources_.slip.col(i) : zero,
                    end.kick.v.cols() ? end.kick.v.col(i) : zero,
                    end.kick.x.cols() ? end.kick.x.col(i) : zero
                }
            )
            {
                Eigen::Map<Eigen::Vector3d> numbers(to);
                numbers = v;
                to += 3;
            }
        }
    }

    for (const std::size_t k : inside)
    {
        const particlePair& pair = contactPairs_[k];
        double* to = append(pairs[home(name(pair.i))], pairLength);
        const periods image = contactHalo_.image(pair.j);

        *to++ = name(pair.i);
        *to++ = static_cast<double>(p.id(pair.i));
        *to++ =
            pair.j < n ? static_cast<double>(p.id(pair.j))
          : copiesId_(pair.j - n);
        *to++ = image[0];
        *to++ = image[1];
        *to++ = image[2];
        *to++ = steps[k];
    }

    const List<List<double>> receivedMembers = exchange(members);
    const List<List<double>> receivedPairs = exchange(pairs);

    auto arrived = records(receivedMembers, memberLength);
    auto arrivedPairs = records(receivedPairs, pairLength);

    // Group by group, in the order of the ids: name, index, id
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

    std::vector<group> groups;
    auto nextPair = arrivedPairs.begin();

    for (auto from = arrived.begin(); from != arrived.end(); )
    {
        const double groupName = from->first[0];

        const auto last = std::find_if
        (
            from,
            arrived.end(),
            [&](const auto& r)
            {
                return r.first[0] != groupName;
            }
        );

        groups.emplace_back();
        group& one = groups.back();

        const int size = static_cast<int>(last - from);

        one.p.resize(size);
        one.p.resizeLaws();

        const std::array<vectors*, nVectors> to
        {
            &one.gas.u0, &one.gas.um, &one.gas.u1, &one.w0,
            &one.end.x, &one.end.v, &one.end.w, &one.x1, &one.slip1,
            &one.end.kick.v, &one.end.kick.x
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
            numbers += particleArrays::nNumbers;

            for (vectors* v : to)
            {
                v->col(m) = Eigen::Map<const Eigen::Vector3d>(numbers);
                numbers += 3;
            }
        }

        if (!gas.um.cols())
        {
            one.gas.um.resize(3, 0);
        }

        if (!with_.motion.hasBrownian())
        {
            one.end.kick.v.resize(3, 0);
            one.end.kick.x.resize(3, 0);
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
         && nextPair->first[0] == groupName;
            ++nextPair
        )
        {
            const double* numbers = nextPair->first;

            const int i = place(numbers[1]);
            const int j = place(numbers[2]);

            periods there;
            periods back;
            for (int k = 0; k < 3; ++k)
            {
                there[k] = static_cast<std::int8_t>(numbers[3 + k]);
                back[k] = static_cast<std::int8_t>(-numbers[3 + k]);
            }

            one.contactPairs.push_back({i, j, there});
            one.wakePairs.push_back({i, j, there});
            one.wakePairs.push_back({j, i, back});
            one.nSteps = std::max(one.nSteps, static_cast<int>(numbers[6]));
        }

        effort_.groupMembers += size;
    }

    return groups;
}


std::vector<char> Foam::aerosol::timeStepping::disperse
(
    const std::vector<group>& groups,
    particleArrays& p,
    equationOfMotion::state& end
)
{
    std::vector<std::vector<double>> send(bricks::nRanks());

    for (const group& one : groups)
    {
        for (int m = 0; m < one.p.size(); ++m)
        {
            double* to = append(send[one.home[m].first], returnLength);

            *to++ = one.home[m].second;
            *to++ = one.absorbed[m];
            one.p.pack(m, to);
            to += particleArrays::nNumbers;
            Eigen::Map<Eigen::Vector3d> x(to);
            Eigen::Map<Eigen::Vector3d> v(to + 3);
            Eigen::Map<Eigen::Vector3d> thermal(to + 6);
            x = one.end.x.col(m);
            v = one.end.v.col(m);
            thermal.setZero();
            if (one.end.thermal.cols())
            {
                thermal = one.end.thermal.col(m);
            }
        }
    }

    const List<List<double>> received = exchange(send);

    std::vector<char> absorbed(p.size(), 0);

    for (const auto& record : records(received, returnLength))
    {
        const double* numbers = record.first;
        const int i = static_cast<int>(*numbers++);

        absorbed[i] = *numbers++ > 0;
        p.unpack(i, numbers);
        numbers += particleArrays::nNumbers;
        end.x.col(i) = Eigen::Map<const Eigen::Vector3d>(numbers);
        end.v.col(i) = Eigen::Map<const Eigen::Vector3d>(numbers + 3);
        if (end.thermal.cols())
        {
            end.thermal.col(i) = Eigen::Map<const Eigen::Vector3d>(numbers + 6);
        }
    }

    return absorbed;
}


void Foam::aerosol::timeStepping::outsideWakes
(
    const group& one,
    vectors& outside0,
    vectors& outside1
) const
{
    outside0 = one.w0;
    outside1 = one.end.w;

    if (!with_.motion.hasWakes())
    {
        return;
    }

    // Those from inside that are part of them: within range at the beginning
    std::vector<particlePair> acting;

    for (const particlePair& pair : one.wakePairs)
    {
        double distanceSqr = 0;

        for (int k = 0; k < 3; ++k)
        {
            const double r =
                one.p.x(k, pair.i)
              - (one.p.x(k, pair.j) + pair.image[k]*contactHalo_.period()(k));
            distanceSqr += r*r;
        }

        if (distanceSqr <= one.p.range(pair.j)*one.p.range(pair.j))
        {
            acting.push_back(pair);
        }
    }

    const int n = one.p.size();
    vectors inside;

    with_.motion.wakes
    (
        {
            one.p.x, one.gas.u0 - (one.p.v - one.p.thermal), one.p.d, {}
        },
        acting, n, inside
    );
    outside0 -= inside;

    with_.motion.wakes({one.x1, one.slip1, one.p.d, {}}, acting, n, inside);
    outside1 -= inside;
}


// ************************************************************************* //
