/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fragmentation.H"
#include "checkedDictionary.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "noBreakage.H"
#include "packedRecord.H"

#include <algorithm>
#include <cmath>
#include <map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- By how much the pieces are apart, in distances of contact
constexpr double gap = 1e-3;

//- For the gradient, in diameters: far enough for differences that are no
//  rounding, near enough for them to be those of the flow at the aggregate
constexpr double spacing = 0.5;


//- The share of the smaller piece
scalar readShare(const dictionary& dict)
{
    const word fragments(valueOr<word>(dict, "fragments", "erosion"));

    if (fragments == "erosion" && !dict.found("share"))
    {
        return 0;
    }

    if (fragments != "two")
    {
        FatalIOErrorInFunction(dict)
            << "'fragments' are " << fragments << "; valid ones are erosion,"
            << " without 'share', and two" << exit(FatalIOError);
    }

    const scalar share = readPositive(dict, "share", dimless, 0.5);

    if (share > 0.5)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'share' of " << dict.name() << " is " << share
            << ", but it is that of the smaller piece and must not be above 0.5"
            << exit(FatalIOError);
    }

    return share;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::fragmentation::fragmentation(const dictionary& dict)
:
    model_
    (
        dict.empty() ? autoPtr<breakage>(new noBreakage(dict))
      : breakage::New(dict)
    ),
    share_(model_->active() ? readShare(dict) : 0),
    nextId_(0),
    count_(0),
    keepsRecords_(false)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::aerosol::particleArrays Foam::aerosol::fragmentation::pieces
(
    const particleArrays& p,
    const int i
) const
{
    const std::int64_t N = p.primaries(i);
    const std::int64_t smaller =
        std::max<std::int64_t>(1, std::floor(share_*N));

    particleArrays two = p.select({i, i});

    two.primaries << N - smaller, smaller;

    for (const int k : {0, 1})
    {
        two.d(k) *= std::cbrt(scalar(two.primaries(k))/N);
    }

    // Rounded like the whole, of which it is a part, that the sum is exact
    two.m(1) = (p.m(i) + p.m(i)*(scalar(smaller)/N)) - p.m(i);
    two.m(0) -= two.m(1);

    return two;
}


std::vector<Eigen::Matrix3d> Foam::aerosol::fragmentation::gradients
(
    const acoustics::soundField& sound,
    const domain& region,
    const scalar t,
    const vectors& x,
    const scalars& distance
)
{
    const boundBox& box = region.bounds();
    const int n = x.cols();

    std::vector<Eigen::Matrix3d> all(n, sound.gradient(t));

    for (int k = 0; k < 3; ++k)
    {
        vectors low = x;
        vectors high = x;

        for (int i = 0; i < n; ++i)
        {
            low(k, i) = std::max(x(k, i) - distance(i), box.min()[k]);
            high(k, i) = std::min(x(k, i) + distance(i), box.max()[k]);
        }

        vectors before, after;
        sound.velocity(t, low, before);
        sound.velocity(t, high, after);

        for (int i = 0; i < n; ++i)
        {
            all[i].col(k) +=
                (after.col(i) - before.col(i))/(high(k, i) - low(k, i));
        }
    }

    return all;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::vector<Foam::aerosol::fragmentation::record>
Foam::aerosol::fragmentation::takeRecords()
{
    std::vector<record> taken;
    taken.swap(records_);

    return taken;
}


bool Foam::aerosol::fragmentation::apply
(
    particleArrays& p,
    const std::map<std::int64_t, breakage::impact>& impacts,
    const equationOfMotion& motion,
    const acoustics::soundField& sound,
    const domain& region,
    const scalar t,
    const scalar h,
    const std::int64_t step
)
{
    if (!active())
    {
        return false;
    }

    std::vector<int> aggregates;

    const auto concerns = [&](const int i)
    {
        return !model_->needsImpacts() || impacts.count(p.id(i));
    };

    for (int i = 0; i < p.size(); ++i)
    {
        if (p.primaries(i) > 1 && concerns(i))
        {
            aggregates.push_back(i);
        }
    }

    // Outside of the domain: the gas at the place that the border says. Also
    // where there are none: other ranks may need the gas that is here
    vectors x = p.x(Eigen::all, aggregates);
    region.confine(x);

    vectors u;
    sound.velocityAt(t, x, p.response(aggregates), u);

    std::vector<Eigen::Matrix3d> gradient;
    if (model_->needsGradient())
    {
        gradient = gradients
        (
            sound, region, t, x, spacing*p.mobilityDiameter(aggregates)
        );
    }

    // Those that break here
    struct broken
    {
        int i;
        particleArrays pieces;
    };

    std::vector<broken> mine;
    std::vector<double> numbers;

    for (std::size_t k = 0; k < aggregates.size(); ++k)
    {
        const int i = aggregates[k];

        breakage::surroundings where;
        where.slip = u.col(k) - (p.v.col(i) - p.thermal.col(i));
        where.h = h;
        where.step = step;
        if (!gradient.empty())
        {
            where.gradient = gradient[k];
        }

        const auto hit = impacts.find(p.id(i));
        if (hit != impacts.end())
        {
            where.hit = hit->second;
        }

        if (!model_->mayBreak(p, i, where, sound.gas()))
        {
            continue;
        }

        particleArrays two = pieces(p, i);
        motion.laws().refresh(two);

        breakage::parting parting;
        if (!model_->breaks(p, i, two, where, sound.gas(), parting))
        {
            continue;
        }

        // About the common centre of mass
        const Eigen::Vector3d apart =
            (1 + gap)*0.5*(two.collisionDiameter(0) + two.collisionDiameter(1))
           *parting.direction;
        const Eigen::Vector3d speed = parting.speed*parting.direction;

        two.x.col(0) -= two.m(1)/p.m(i)*apart;
        two.x.col(1) += two.m(0)/p.m(i)*apart;
        two.v.col(0) -= two.m(1)/p.m(i)*speed;
        two.v.col(1) += two.m(0)/p.m(i)*speed;

        recordWriter(numbers)
            << double(p.id(i)) << p.d(i) << two.d(1)
            << double(p.primaries(i)) << double(two.primaries(1));

        mine.push_back({i, std::move(two)});
    }

    // All of them, in the order of ids
    constexpr int length = 5;

    std::map<std::int64_t, record> all;

    const messages received = exchangeWithAll(numbers);

    for (const auto& one : records(received, length))
    {
        const double* const part = one.first;
        const std::int64_t id = part[0];

        all[id] =
        {
            t, id, 0, part[1], part[2], std::int64_t(part[3]),
            std::int64_t(part[4])
        };
    }

    for (auto& one : all)
    {
        one.second.newId = nextId_++;
        ++count_;

        if (keepsRecords_)
        {
            records_.push_back(one.second);
        }
    }

    for (broken& one : mine)
    {
        one.pieces.id(1) = all[p.id(one.i)].newId;
        p.replace(one.i, one.pieces);
    }

    return !all.empty();
}


// ************************************************************************* //
