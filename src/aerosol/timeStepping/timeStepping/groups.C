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
#include <unordered_set>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::aerosol;

//- Vectors of a member that come with its particle
constexpr int nVectors = 14;

//- Numbers of a member in a message: its group, its index where it comes from,
//  the particle, the vectors
constexpr int memberLength = 2 + particleArrays::nNumbers + 3*nVectors;

//- Of a pair: its group, two ids, the image, the number of steps
constexpr int pairLength = 7;

//- Of a member on its way home: its index there, whether it was absorbed, the
//  particle, its end
constexpr int returnLength = 2 + particleArrays::nNumbers + 6;


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

std::vector<Foam::aerosol::timeStepping::group>
Foam::aerosol::timeStepping::gatherGroups
(
    const particleArrays& p,
    const gasStep& gas,
    const Brownian::kicks& kick,
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
    messages members(nRanks);
    messages pairs(nRanks);

    for (int i = 0; i < n; ++i)
    {
        if (member(i))
        {
            double* to = append(members[home(name(i))], memberLength);

            *to++ = name(i);
            *to++ = i;
            p.pack(i, to);
            to += particleArrays::nNumbers;

            const std::array<const gasStep*, 4> steps
            {
                &gas, &wakes_, &wakesX_, &wakesSlip_
            };

            const auto add = [&](const vectors& v)
            {
                Eigen::Map<Eigen::Vector3d> numbers(to);

                if (v.cols())
                {
                    numbers = v.col(i);
                }
                else
                {
                    numbers.setZero();
                }
                to += 3;
            };

            for (const gasStep* step : steps)
            {
                add(step->u0);
                add(step->um);
                add(step->u1);
            }

            add(kick.v);
            add(kick.x);
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

    const messages receivedMembers = bricks::exchange(std::move(members));
    const messages receivedPairs = bricks::exchange(std::move(pairs));

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
            &one.gas.u0, &one.gas.um, &one.gas.u1,
            &one.wakes.u0, &one.wakes.um, &one.wakes.u1,
            &one.x.u0, &one.x.um, &one.x.u1,
            &one.slip.u0, &one.slip.um, &one.slip.u1,
            &one.kick.v, &one.kick.x
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
        if (!wakes_.um.cols())
        {
            one.wakes.um.resize(3, 0);
        }

        if (!with_.motion.hasBrownian())
        {
            one.kick.v.resize(3, 0);
            one.kick.x.resize(3, 0);
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

            periods image;
            for (int k = 0; k < 3; ++k)
            {
                image[k] = static_cast<std::int8_t>(numbers[3 + k]);
            }

            one.contactPairs.push_back({i, j, image});
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
    messages send(bricks::nRanks());

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
            x = one.p.x.col(m);
            v = one.p.v.col(m);
        }
    }

    const messages received = bricks::exchange(std::move(send));

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
            end.thermal.col(i) = p.thermal.col(i);
        }
    }

    return absorbed;
}


Foam::aerosol::timeStepping::gasStep
Foam::aerosol::timeStepping::outsideWakes
(
    const group& one,
    const std::vector<particlePair>& wakePairs
) const
{
    gasStep outside;

    if (!with_.motion.hasWakes())
    {
        return outside;
    }

    // Those from inside that are part of all: within range at the beginning
    std::vector<particlePair> acting;

    for (const particlePair& pair : wakePairs)
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

    const auto less =
    [&]
    (
        const vectors& w,
        const vectors& x,
        const vectors& slip
    )
    {
        vectors inside;
        with_.motion.wakes
        (
            {x, slip, one.p.d, {}}, acting, one.p.size(), inside
        );

        return vectors(w - inside);
    };

    outside.u0 = less(one.wakes.u0, one.x.u0, one.slip.u0);
    outside.u1 = less(one.wakes.u1, one.x.u1, one.slip.u1);

    if (one.wakes.um.cols())
    {
        outside.um = less(one.wakes.um, one.x.um, one.slip.um);
    }

    return outside;
}


std::vector<Foam::aerosol::particlePair>
Foam::aerosol::timeStepping::bothWays(const std::vector<particlePair>& pairs)
{
    std::vector<particlePair> both;

    for (const particlePair& pair : pairs)
    {
        periods back = pair.image;
        for (std::int8_t& n : back)
        {
            n = -n;
        }

        both.push_back(pair);
        both.push_back({pair.j, pair.i, back});
    }

    return both;
}


std::pair<Foam::scalar, int> Foam::aerosol::timeStepping::firstContact
(
    const group& one,
    const equationOfMotion::state& end,
    const scalar h,
    const int nCollision,
    const std::vector<char>& leftOut
) const
{
    const particleArrays& p = one.p;

    std::pair<scalar, int> first(GREAT, -1);

    for (std::size_t k = 0; k < one.contactPairs.size(); ++k)
    {
        if (leftOut[k])
        {
            continue;
        }

        const particlePair& pair = one.contactPairs[k];
        const int i = pair.i;
        const int j = pair.j;

        const particlePath a
        (
            p.x.col(i), p.v.col(i), end.x.col(i), end.v.col(i), h
        );
        const particlePath b
        (
            p.x.col(j) + shift(pair), p.v.col(j),
            end.x.col(j) + shift(pair), end.v.col(j), h
        );
        const double touch = 0.5*(p.d(i) + p.d(j));

        if (a.staysAwayFrom(b, touch))
        {
            continue;
        }

        // Who touched without sticking does so again only after a separation
        const bool onlyNew = with_.contacts.refused(p.id(i), p.id(j));

        const double when =
            nCollision > 0
          ? particlePath::firstOverlap(a, b, touch, h/nCollision, onlyNew)
          : particlePath::firstTouch(a, b, touch, onlyNew);

        // The first of the list if there are more at the same time
        if (when <= h && when < first.first)
        {
            first = {when, static_cast<int>(k)};
        }
    }

    return first;
}


void Foam::aerosol::timeStepping::redirect
(
    std::vector<particlePair>& pairs,
    const int survivor,
    const int absorbed,
    const periods& image
)
{
    // Pairs of the absorbed one become pairs of the survivor, which is where
    // the absorbed one's copy at `image` was
    for (particlePair& pair : pairs)
    {
        for (int k = 0; k < 3; ++k)
        {
            if (pair.i == absorbed)
            {
                pair.image[k] += image[k];
            }
            if (pair.j == absorbed)
            {
                pair.image[k] -= image[k];
            }
        }

        if (pair.i == absorbed)
        {
            pair.i = survivor;
        }
        if (pair.j == absorbed)
        {
            pair.j = survivor;
        }
    }

    // Those who were neighbours of both are now there twice
    std::vector<particlePair> kept;
    std::unordered_set<std::int64_t> known;

    for (const particlePair& pair : pairs)
    {
        const std::int64_t low = std::min(pair.i, pair.j);
        const std::int64_t high = std::max(pair.i, pair.j);

        if (pair.i != pair.j && known.insert(low << 32 | high).second)
        {
            kept.push_back(pair);
        }
    }

    pairs.swap(kept);
}


void Foam::aerosol::timeStepping::follow
(
    group& one,
    const scalar t,
    const scalar h,
    const int nCollision,
    const int part
)
{
    if (with_.motion.hasBrownian())
    {
        followBrownian(one, t, h, nCollision, part);
        return;
    }

    // Distance from contact that is no distance, in distances
    constexpr double closed = 1e-10;

    particleArrays& p = one.p;
    const scalar longest = h/one.nSteps;

    std::vector<particlePair> wakePairs = bothWays(one.contactPairs);
    const gasStep outside = outsideWakes(one, wakePairs);

    equationOfMotion::state end;
    std::vector<char> leftOut(one.contactPairs.size(), 0);
    scalar now = 0;

    const auto moveOver = [&](const scalar length, equationOfMotion::state& to)
    {
        with_.motion.step
        (
            length,
            p,
            wakePairs,
            one.gas.part(now/h, (now + length)/h),
            outside.part(now/h, (now + length)/h),
            nIterations,
            to
        );
        effort_.groupMoves += p.size();
    };

    while (h - now > 1e-9*longest)
    {
        const scalar length =
            (h - now)/std::ceil((h - now)/longest - 1e-9);

        moveOver(length, end);

        const auto found = firstContact(one, end, length, nCollision, leftOut);

        if (found.second < 0)
        {
            p.x.swap(end.x);
            p.v.swap(end.v);
            now += length;
            std::fill(leftOut.begin(), leftOut.end(), 0);
            continue;
        }

        // To the contact, by the motion itself rather than by its path
        const particlePair pair = one.contactPairs[found.second];
        const double touch = 0.5*(p.d(pair.i) + p.d(pair.j));
        scalar when = found.first;

        for (int n = 0; n < 5 && when > 1e-9*longest; ++n)
        {
            moveOver(when, end);

            const Eigen::Vector3d r =
                end.x.col(pair.j) + shift(pair) - end.x.col(pair.i);
            const double gap = r.norm() - touch;
            const double rate =
                (end.v.col(pair.j) - end.v.col(pair.i)).dot(r)/r.norm();

            if (std::abs(gap) < closed*touch || rate >= 0)
            {
                break;
            }

            when = std::min(std::max(when - gap/rate, 0.0), length);
        }

        if (when > 1e-9*longest)
        {
            moveOver(when, end);
        }
        else
        {
            when = 0;
            end.x = p.x;
            end.v = p.v;
        }

        contactOutcome::encounter encounter;
        encounter.i = pair.i;
        encounter.j = pair.j;
        encounter.shift = shift(pair);
        encounter.xi = end.x.col(pair.i);
        encounter.xj = end.x.col(pair.j) + encounter.shift;
        encounter.vi = end.v.col(pair.i);
        encounter.vj = end.v.col(pair.j);
        encounter.time = t + now + when;

        const int survivor = with_.contacts.meet(p, encounter);

        if (survivor < 0)
        {
            leftOut[found.second] = 1;
            continue;
        }

        // All go on from there
        const Eigen::Vector3d xs = p.x.col(survivor);
        const Eigen::Vector3d vs = p.v.col(survivor);

        p.x.swap(end.x);
        p.v.swap(end.v);
        p.x.col(survivor) = xs;
        p.v.col(survivor) = vs;
        now += when;

        with_.motion.refresh(p, survivor);

        periods image = pair.image;
        if (survivor == pair.j)
        {
            for (std::int8_t& n : image)
            {
                n = -n;
            }
        }

        redirect
        (
            one.contactPairs,
            survivor,
            survivor == pair.i ? pair.j : pair.i,
            image
        );
        wakePairs = bothWays(one.contactPairs);
        leftOut.assign(one.contactPairs.size(), 0);
    }

    one.absorbed = with_.contacts.takeAbsorbed(p.size());
}


// ************************************************************************* //
