/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "lookAhead.H"
#include "communicator.H"
#include "listedPaths.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- In distances from contact: allowed without wakes
constexpr double leastAllowance = 0.05;

//- In mean distances: allowed in the strongest wakes
constexpr double largestAllowance = 0.5;

//- Of the allowance, what a skin must leave room for; and the room in the next
//  list, in what was needed
constexpr double leastShare = 0.1;
constexpr double moreRoom = 3;

//- Estimates of wakes are taken by so much more
constexpr double safety = 2;

//- In displacements of a step: how far beyond its places a particle reaches in
//  a step in which it may meet others, half of its displacement and the bulge
//  of the path
constexpr double pathShare = 0.75;

//- Cubics follow a sound that well
constexpr double bulgeMargin = 1.1;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::aerosol::scalars
Foam::aerosol::lookAhead::roomLeft(const particleArrays& p) const
{
    const int n = p.size();

    // What is left of their skins. A chord is within any convex body in which
    // its ends are.
    const verletSkin& skin = finder_.skin();
    scalars room = skin.sizes();
    Eigen::Vector3d moved = Eigen::Vector3d::Zero();

    for (std::size_t k = 0; k <= x_.size(); ++k)
    {
        const vectors& x = k ? x_[k - 1] : p.x;

        for (int m = 0; k && m < every_; ++m)
        {
            moved += expected_[(k - 1)*every_ + m].displacement;
        }

        for (int i = 0; i < n; ++i)
        {
            room(i) = std::min
            (
                room(i), skin.sizes()(i) - skin.beyond(i, x.col(i), moved)
            );
        }
    }

    return
        room
      - bulgeMargin*bulge_
      - (
            (1 + encounterFinder::margin)*0.5*p.collisionDiameter
          + pathShare*furthest_
        ).max(encounterFinder::wakeMargin*furthest_);
}


bool Foam::aerosol::lookAhead::separate(const particleArrays& p)
{
    const int n = p.size();
    const bool withWakes = motion_.wakes().active();
    const double h = every_*first_.h;
    const double whole = h*x_.size();

    allowance_ = leastAllowance*p.collisionDiameter;

    const scalars room = roomLeft(p);
    const scalars bulge = bulgeMargin*bulge_;

    // Wakes that will be felt, and how far they may carry particles
    const neighbourList& acting = finder_.wakeCandidates();
    const neighbourList& touching = finder_.contacts();

    listedPaths near(touching, p.x, x_, furthest_, bulge, every_);
    std::vector<ghosts::filling> fillings{near.filling()};

    scalars range = p.range;
    scalars reach;
    scalars distance(acting.pairs().size());

    if (!withWakes)
    {
        ghosts::fill(fillings);
    }
    else
    {
        // Oseen's wake at a distance of 1 m
        scalars strength =
            0.75*p.mobilityDiameter
           *(
                std::max(sound_.velocityAmplitude(), 0.0)*(1 - p.response).abs()
              + p.acceleration.colwise().norm().transpose().array()
               /p.rate.max(SMALL)
            );

        const double mostAllowed =
            largestAllowance
           *std::cbrt(domain_.volume()/communicator::sum(n));

        listedPaths paths(acting, p.x, x_, furthest_, bulge, every_);
        const ghosts& layer = acting.layer();

        fillings.push_back(paths.filling());
        fillings.back().quantities.push_back({strength, layer});
        fillings.back().quantities.push_back({range, layer});
        ghosts::fill(fillings);

        reach = encounterFinder::wakeMargin*paths.furthest();

        scalars speed = scalars::Zero(n);

        for (std::size_t m = 0; m < acting.pairs().size(); ++m)
        {
            const particlePair& pair = acting.pairs()[m];
            const double far =
                range(pair.j) + reach(pair.i) + reach(pair.j);

            distance(m) =
                paths.mayCome(pair, far + 2*mostAllowed)
              ? paths.closest(pair) : GREAT;

            if (distance(m) < far)
            {
                speed(pair.i) +=
                    strength(pair.j)*paths.meanInverse(pair)
                   *wake::fade(sqr(distance(m)/range(pair.j)));
            }
        }

        allowance_ += safety*(perDistance*whole + perStep*first_.h)*speed;
        allowance_ = allowance_.min(mostAllowed);
    }

    // Those that lack it get more in the next list, whatever rank they are on
    // then
    messages lacking(communicator::nRanks());

    for (int i = 0; i < n; ++i)
    {
        if (room(i) < leastShare*allowance_(i))
        {
            for (std::vector<double>& message : lacking)
            {
                message.push_back(static_cast<double>(p.id(i)));
                message.push_back(moreRoom*(allowance_(i) - room(i)));
            }
        }
    }

    if (communicator::max(!lacking[0].empty()) > 0)
    {
        for (const auto& message : communicator::exchange(std::move(lacking)))
        {
            for (std::size_t m = 0; m < message.size(); m += 2)
            {
                finder_.makeRoom
                (
                    static_cast<std::int64_t>(message[m]), message[m + 1]
                );
            }
        }
        return false;
    }

    allowance_ = allowance_.min(room);

    std::vector<particlePair> wakePairs;
    std::vector<particlePair> contactPairs;

    scalars allowed = allowance_;
    scalars size =
        allowance_ + (1 + encounterFinder::margin)*0.5*p.collisionDiameter;

    fillings = {{&touching.layer(), {{size, touching.layer()}}}};
    if (withWakes)
    {
        fillings.push_back({&acting.layer(), {{allowed, acting.layer()}}});
    }
    ghosts::fill(fillings);

    if (withWakes)
    {
        for (std::size_t m = 0; m < acting.pairs().size(); ++m)
        {
            const particlePair& pair = acting.pairs()[m];
            const double far =
                range(pair.j)
              + reach(pair.i) + reach(pair.j)
              + allowed(pair.i) + allowed(pair.j);

            if (distance(m) <= far)
            {
                wakePairs.push_back(pair);
            }
        }
    }

    size += pathShare*near.furthest();

    for (const particlePair& pair : touching.pairs())
    {
        const double far = size(pair.i) + size(pair.j);

        if (near.mayCome(pair, far) && near.closest(pair) <= far)
        {
            contactPairs.push_back(pair);
        }
    }

    take(p, wakePairs, contactPairs);

    return true;
}


void Foam::aerosol::lookAhead::take
(
    const particleArrays& p,
    const std::vector<particlePair>& wakePairs,
    const std::vector<particlePair>& contactPairs
)
{
    std::vector<pairsWithGhosts> pairs
    {
        {finder_.contacts().layer(), contactPairs}
    };
    std::vector<neighbourList*> lists{&contacts_};

    if (motion_.wakes().active())
    {
        pairs.push_back({finder_.wakeCandidates().layer(), wakePairs});
        lists.push_back(&wakes_);
    }

    exchange_.gather(p, pairs, allowance_, busy_, lists);

    strayed_.setZero(busy_.size());
    strayedSpeed_.setZero(busy_.size());
    returned_.assign(busy_.size(), 0);
    absorbed_.assign(busy_.size(), 0);

    const communicator::alone here;
    contacts_.fillIds(busy_.id.cast<double>());
}


// ************************************************************************* //
