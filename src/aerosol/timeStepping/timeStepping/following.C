/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The part of timeStepping that follows a cluster, from contact to contact.

\*---------------------------------------------------------------------------*/

#include "timeStepping.H"

#include <algorithm>
#include <cmath>
#include <unordered_set>

// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::aerosol::timeStepping::gasStep
Foam::aerosol::timeStepping::outsideWakes
(
    const cluster& one,
    const std::vector<particlePair>& wakePairs,
    const scalar h
) const
{
    gasStep outside;

    if (!with_.motion.hasWakes())
    {
        return outside;
    }

    // All less those from inside
    const auto less =
    [&]
    (
        const vectors& w,
        const vectors& x,
        const vectors& slip,
        const scalar s
    )
    {
        vectors inside;
        with_.motion.wakes
        (
            {
                x, slip, one.p.mobilityDiameter, one.p.range,
                with_.motion.settling(one.p),
                with_.motion.imaginarySlip(one.p.rate, one.gas, s, h)
            },
            wakePairs,
            one.p.size(),
            inside
        );

        return vectors(w - inside);
    };

    outside.u0 = less(one.wakes.u0, one.x.u0, one.slip.u0, 0);
    outside.u1 = less(one.wakes.u1, one.x.u1, one.slip.u1, 1);

    if (one.wakes.um.cols())
    {
        outside.um = less(one.wakes.um, one.x.um, one.slip.um, 0.5);
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
    const cluster& one,
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
        const double touch =
            0.5*(p.collisionDiameter(i) + p.collisionDiameter(j));

        if (a.staysAwayFrom(b, touch))
        {
            continue;
        }

        // A pair that has just bounced is in contact, and may meet again
        if (with_.collisions.bounces())
        {
            const double when = particlePath::firstApproach(a, b, touch);

            if (when <= h && when < first.first)
            {
                first = {when, static_cast<int>(k)};
            }
            continue;
        }

        // A pair that touched without sticking must separate before it touches
        // again
        const bool onlyNew = with_.collisions.refused(p.id(i), p.id(j));

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
    // the absorbed one's ghost at `image` was
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

    // The neighbours of both are now listed twice
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
    cluster& one,
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

    // Gap below which two particles count as touching, relative to the distance
    // of contact
    constexpr double closed = 1e-10;

    particleArrays& p = one.p;
    const scalar longest = h/one.nSteps;

    std::vector<particlePair> wakePairs = bothWays(one.contactPairs);
    const gasStep outside = outsideWakes(one, wakePairs, h);

    equationOfMotion::state end;
    std::vector<char> leftOut(one.contactPairs.size(), 0);
    scalar now = 0;
    std::uint64_t nContacts = 0;

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
        effort_.clusterMoves += p.size();
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
        const double touch =
            0.5*(p.collisionDiameter(pair.i) + p.collisionDiameter(pair.j));
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
        encounter.step = step_;
        encounter.number = block(noise::whole, part, nContacts++);

        // In contact on its path, but by its motion only nearly so
        if (with_.collisions.bounces() && encounter.approach() <= 0)
        {
            leftOut[found.second] = 1;
            continue;
        }

        const int survivor = with_.collisions.meet(p, encounter);

        if (survivor == collisions::passed)
        {
            leftOut[found.second] = 1;
            continue;
        }

        if (survivor == collisions::bounced)
        {
            end.v.col(pair.i) = p.v.col(pair.i);
            end.v.col(pair.j) = p.v.col(pair.j);
            p.x.swap(end.x);
            p.v.swap(end.v);
            now += when;
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

    one.absorbed = with_.collisions.takeAbsorbed(p.size());
}


// ************************************************************************* //
