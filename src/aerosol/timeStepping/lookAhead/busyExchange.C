/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "busyExchange.H"
#include "packedRecord.H"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::aerosol;

//- Below all names
constexpr double nobody = -1e300;

//- Of a pair: its list, two ids, the image
constexpr int pairLength = 6;

//- Of a busy particle that is sent: its index at home, its allowance, itself
int sentLength(const particleArrays& p)
{
    return 2 + p.packedNumbers();
}

//- The same of one that comes back: its index, what happened to it, itself
int returnLength(const particleArrays& p)
{
    return 3 + p.packedNumbers();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::busyExchange::busyExchange(const domain& region)
:
    domain_(region)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<Foam::aerosol::scalars> Foam::aerosol::busyExchange::ownNames
(
    const particleArrays& p,
    const std::vector<pairsWithGhosts>& lists
)
{
    std::vector<scalars> names(lists.size());
    std::vector<ghosts::filling> fillings;

    for (std::size_t m = 0; m < lists.size(); ++m)
    {
        names[m] =
            -(
                p.id.cast<double>()*communicator::nRanks()
              + communicator::rank()
            );
        fillings.push_back
        ({
            &lists[m].layer, {ghosts::quantity(names[m], lists[m].layer)}
        });
    }

    ghosts::fill(fillings);

    return names;
}


Foam::aerosol::scalars Foam::aerosol::busyExchange::groupNames
(
    const std::vector<pairsWithGhosts>& lists,
    std::vector<scalars> names
)
{
    const int n = lists[0].layer.n();
    scalars own = scalars::Constant(n, nobody);

    // Only those in a pair have a name
    for (std::size_t m = 0; m < lists.size(); ++m)
    {
        scalars named = scalars::Constant(names[m].size(), nobody);

        for (const particlePair& pair : lists[m].pairs)
        {
            named(pair.i) = names[m](pair.i);
            named(pair.j) = names[m](pair.j);
        }
        names[m].swap(named);
        own = own.max(names[m].head(n));
    }

    for (bool first = true; ; first = false)
    {
        bool changed = false;

        for (bool again = true; again; )
        {
            again = false;

            for (std::size_t m = 0; m < lists.size(); ++m)
            {
                const auto name = [&](const int i) -> double&
                {
                    return i < n ? own(i) : names[m](i);
                };

                for (const particlePair& pair : lists[m].pairs)
                {
                    double& a = name(pair.i);
                    double& b = name(pair.j);

                    if (a != b)
                    {
                        a = b = std::max(a, b);
                        again = changed = true;
                    }
                }
            }
        }

        if (!first && communicator::max(changed) == 0)
        {
            return own;
        }

        std::vector<std::pair<const ghosts*, scalars*>> layers;

        for (std::size_t m = 0; m < lists.size(); ++m)
        {
            names[m].head(n) = own;
            layers.push_back({&lists[m].layer, &names[m]});
        }

        ghosts::spreadMax(layers);
        own = names[0].head(n);
    }
}


Foam::aerosol::particleArrays
Foam::aerosol::busyExchange::receive
(
    const messages& received,
    const particleArrays& alike,
    std::vector<double>& allowance,
    std::vector<const double*>& pairs
)
{
    std::vector<std::pair<const double*, int>> arrived;

    for (std::size_t rank = 0; rank < received.size(); ++rank)
    {
        if (received[rank].empty())
        {
            continue;
        }

        const double* next = received[rank].data();
        const double* const end = next + received[rank].size();

        for (int left = static_cast<int>(*next++); left; --left)
        {
            arrived.push_back({next, static_cast<int>(rank)});
            next += sentLength(alike);
        }
        for (; next != end; next += pairLength)
        {
            pairs.push_back(next);
        }
    }

    const int n = static_cast<int>(arrived.size());

    particleArrays guests;
    guests.resizeHistory(alike.history.rows());
    guests.resize(n);
    guests.resizeLaws();

    for (int k = 0; k < n; ++k)
    {
        recordReader record(arrived[k].first);

        home_.push_back
        ({
            arrived[k].second, static_cast<int>(record.number())
        });
        allowance.push_back(record.number());
        guests.unpack(k, record.numbers(alike.packedNumbers()));
    }

    return guests;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::busyExchange::gather
(
    const particleArrays& p,
    const std::vector<pairsWithGhosts>& from,
    scalars& allowance,
    particleArrays& busy,
    const std::vector<neighbourList*>& lists
)
{
    const int nRanks = communicator::nRanks();
    const int here = communicator::rank();
    const std::vector<scalars> names = ownNames(p, from);
    const scalars groups = groupNames(from, names);

    const auto rankOf = [&](const int i)
    {
        return static_cast<int>
        (
            static_cast<std::int64_t>(-groups(i)) % nRanks
        );
    };
    const auto id = [&](const std::size_t m, const int i)
    {
        return static_cast<std::int64_t>(-names[m](i))/nRanks;
    };

    // Those that stay, and for each other rank: the number of particles, these,
    // the pairs
    std::vector<int> chosen;
    std::vector<int> place(p.size(), -1);
    std::vector<double> allowed;
    messages send(nRanks);

    home_.clear();
    away_.assign(nRanks, 0);

    for (int i = 0; i < p.size(); ++i)
    {
        if (groups(i) == nobody)
        {
            continue;
        }

        const int rank = rankOf(i);

        if (rank == here)
        {
            place[i] = static_cast<int>(chosen.size());
            chosen.push_back(i);
            home_.push_back({here, i});
            allowed.push_back(allowance(i));
            continue;
        }

        if (send[rank].empty())
        {
            send[rank].push_back(0);
        }

        recordWriter record(send[rank]);

        record << double(i) << allowance(i);
        p.pack(i, record.room(p.packedNumbers()));
        send[rank][0] = ++away_[rank];
    }

    for (std::size_t m = 0; m < from.size(); ++m)
    {
        for (const particlePair& pair : from[m].pairs)
        {
            if (rankOf(pair.i) != here)
            {
                const periods image = from[m].layer.image(pair.j);

                recordWriter(send[rankOf(pair.i)])
                    << double(m)
                    << double(id(m, pair.i)) << double(id(m, pair.j))
                    << double(image[0]) << double(image[1]) << double(image[2]);
            }
        }
    }

    const messages received = communicator::exchange(std::move(send));
    std::vector<const double*> sentPairs;

    busy = p.select(chosen);
    const int stay = busy.size();
    busy.append(receive(received, p, allowed, sentPairs));
    allowance = Eigen::Map<const scalars>(allowed.data(), allowed.size());

    // Other ranks know particles by their ids
    std::unordered_map<std::int64_t, int> placeOf;

    if (nRanks > 1)
    {
        for (int k = stay; k < busy.size(); ++k)
        {
            placeOf[busy.id(k)] = k;
        }
        for (const pairsWithGhosts& list : from)
        {
            const std::vector<char> known = list.layer.sent();

            for (int i = 0; i < p.size(); ++i)
            {
                if (known[i] && place[i] >= 0)
                {
                    placeOf[p.id(i)] = place[i];
                }
            }
        }
    }

    std::vector<std::vector<particlePair>> pairs(lists.size());

    for (std::size_t m = 0; m < lists.size(); ++m)
    {
        const std::vector<int> originals = from[m].layer.originals();

        for (const particlePair& pair : from[m].pairs)
        {
            if (rankOf(pair.i) != here)
            {
                continue;
            }

            const int j =
                pair.j < p.size() ? pair.j : originals[pair.j - p.size()];

            pairs[m].push_back
            ({
                place[pair.i],
                j >= 0 ? place[j] : placeOf.at(id(m, pair.j)),
                from[m].layer.image(pair.j)
            });
        }
    }

    for (const double* const one : sentPairs)
    {
        recordReader record(one);

        std::vector<particlePair>& list = pairs[std::size_t(record.number())];
        const int i = placeOf.at(std::int64_t(record.number()));
        const int j = placeOf.at(std::int64_t(record.number()));

        periods image;
        for (std::int8_t& count : image)
        {
            count = static_cast<std::int8_t>(record.number());
        }
        list.push_back({i, j, image});
    }

    for (std::size_t m = 0; m < lists.size(); ++m)
    {
        *lists[m] = neighbourList(domain_, true);
        lists[m]->set(busy.size(), std::move(pairs[m]));
    }
}


void Foam::aerosol::busyExchange::give
(
    const particleArrays& busy,
    const std::vector<char>& returned,
    const std::vector<char>& absorbed,
    particleArrays& all,
    std::vector<char>& allReturned,
    std::vector<char>& allAbsorbed
) const
{
    allReturned.assign(all.size(), 0);
    allAbsorbed.assign(all.size(), 0);

    messages send(communicator::nRanks());
    std::vector<double> numbers(busy.packedNumbers());

    for (int k = 0; k < busy.size(); ++k)
    {
        const int i = home_[k].second;

        if (home_[k].first != communicator::rank())
        {
            recordWriter record(send[home_[k].first]);

            record << double(i) << double(returned[k]) << double(absorbed[k]);
            busy.pack(k, record.room(busy.packedNumbers()));
            continue;
        }

        if (returned[k])
        {
            busy.pack(k, numbers.data());
            all.unpack(i, numbers.data());
        }
        else
        {
            all.x.col(i) = busy.x.col(k);
            all.v.col(i) = busy.v.col(k);
        }
        allReturned[i] = returned[k];
        allAbsorbed[i] = absorbed[k];
    }

    std::vector<std::size_t> lengths;
    for (const std::size_t n : away_)
    {
        lengths.push_back(n*returnLength(all));
    }

    const messages received = communicator::exchange(std::move(send), lengths);

    for (const auto& one : records(received, returnLength(all)))
    {
        recordReader record(one.first);
        const int i = static_cast<int>(record.number());

        allReturned[i] = record.number() > 0;
        allAbsorbed[i] = record.number() > 0;
        all.unpack(i, record.numbers(all.packedNumbers()));
    }
}


// ************************************************************************* //
