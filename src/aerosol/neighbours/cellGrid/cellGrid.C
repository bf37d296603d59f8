/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellGrid.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Particles that are looked at together
constexpr int lot = 8;
using block = Eigen::Array<double, lot, 1>;

//- Further away than anything, but with a finite square
constexpr double farAway = 1e100;

//- Sizes of reach, each half of the one before, that have grids of their own
constexpr int nLevels = 6;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Visitor>
void Foam::aerosol::cellGrid::visitAround
(
    const std::array<double, 3>& centre,
    const double radius,
    Visitor&& visitor
) const
{
    const double radiusSqr = radius*radius;

    // A little more, lest rounding hides a particle on the face of a cell
    const double r = radius*(1 + 1e-9);

    std::array<int, 3> lo;
    std::array<int, 3> hi;

    for (int k = 0; k < 3; ++k)
    {
        lo[k] = cellIndex(centre[k] - r, k);
        hi[k] = cellIndex(centre[k] + r, k);
    }

    for (int cx = lo[0]; cx <= hi[0]; ++cx)
    {
        for (int cy = lo[1]; cy <= hi[1]; ++cy)
        {
            // Cells of a row are next to one another: a single run
            const int row = (cx*cells_[1] + cy)*cells_[2];
            const int end = start_[row + hi[2] + 1];

            for (int m = start_[row + lo[2]]; m < end; m += lot)
            {
                const block distanceSqr =
                    (Eigen::Map<const block>(x_[0].data() + m) - centre[0])
                   .square()
                  + (Eigen::Map<const block>(x_[1].data() + m) - centre[1])
                   .square()
                  + (Eigen::Map<const block>(x_[2].data() + m) - centre[2])
                   .square();

                if (distanceSqr.minCoeff() <= radiusSqr)
                {
                    const int size = std::min(lot, end - m);

                    for (int l = 0; l < size; ++l)
                    {
                        if (distanceSqr(l) <= radiusSqr)
                        {
                            visitor(m + l, distanceSqr(l));
                        }
                    }
                }
            }
        }
    }
}


template<class Visitor>
void Foam::aerosol::cellGrid::visit
(
    const int own,
    const double radius,
    Visitor&& visitor
)
{
    const std::array<double, 3> centre{x_[0][own], x_[1][own], x_[2][own]};

    // It does not find itself: almost all looks are in vain, and quick
    x_[0][own] = farAway;
    visitAround(centre, radius, visitor);
    x_[0][own] = centre[0];
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::cellGrid::build(const vectors& x, const scalars& reach)
{
    const int n = static_cast<int>(reach.size());

    Eigen::Array3d span = Eigen::Array3d::Zero();
    origin_.setZero();

    if (n)
    {
        origin_ = x.rowwise().minCoeff().array();
        span = x.rowwise().maxCoeff().array() - origin_;
    }

    // About three particles per cell, also if all are in a plane or on a line
    const double longest = std::max(span.maxCoeff(), 1e-30);
    const Eigen::Array3d edge = span.max(1e-3*longest);
    const double size = std::cbrt(3*edge.prod()/std::max(n, 1));

    for (int k = 0; k < 3; ++k)
    {
        cells_[k] = std::max(1, static_cast<int>(edge(k)/size));
        inverseSize_(k) = cells_[k]/edge(k);
    }

    // Counting sort, which keeps the order of the particles in a cell
    start_.assign(cells_[0]*cells_[1]*cells_[2] + 1, 0);
    cellOf_.resize(n);
    reach_.resize(n);
    index_.resize(n);
    for (std::vector<double>& x : x_)
    {
        x.resize(n + lot);
        std::fill(x.end() - lot, x.end(), farAway);
    }

    for (int i = 0; i < n; ++i)
    {
        const int cell =
            (cellIndex(x(0, i), 0)*cells_[1] + cellIndex(x(1, i), 1))*cells_[2]
          + cellIndex(x(2, i), 2);

        cellOf_[i] = cell;
        ++start_[cell + 1];
    }

    for (std::size_t c = 1; c < start_.size(); ++c)
    {
        start_[c] += start_[c - 1];
    }

    for (int i = n - 1; i >= 0; --i)
    {
        const int place = --start_[cellOf_[i] + 1];

        x_[0][place] = x(0, i);
        x_[1][place] = x(1, i);
        x_[2][place] = x(2, i);
        reach_[place] = reach(i);
        index_[place] = i;
    }

    // start_[c + 1] is now where cell c begins
    start_.erase(start_.begin());
    start_.push_back(n);
}


void Foam::aerosol::cellGrid::touching
(
    const int n,
    const scalars& id,
    std::vector<particlePair>& pairs
) const
{
    pairs.clear();

    touching
    (
        n, id, false,
        [&](const int i, const int j)
        {
            pairs.push_back({i, j, {}});
        }
    );
}


void Foam::aerosol::cellGrid::touching
(
    const int n,
    const scalars& id,
    const bool shared,
    const std::function<void(int, int)>& add
) const
{
    const int all = static_cast<int>(index_.size());

    if (all == 0)
    {
        return;
    }

    // Those of a large reach are few. Each particle looks among those of its
    // own level and of larger ones, no further than these reach.
    const double largest = *std::max_element(reach_.begin(), reach_.end());

    std::vector<int> level(all);
    std::array<std::vector<int>, nLevels> members;
    std::array<double, nLevels> furthest{};

    for (int place = 0; place < all; ++place)
    {
        int l = 0;
        for (double r = 2*reach_[place]; l + 1 < nLevels && r < largest; r *= 2)
        {
            ++l;
        }

        level[place] = l;
        members[l].push_back(place);
        furthest[l] = std::max(furthest[l], reach_[place]);
    }

    std::array<cellGrid, nLevels> grids;

    for (int l = 0; l < nLevels; ++l)
    {
        const int n = static_cast<int>(members[l].size());

        vectors x(3, n);
        scalars reach(n);

        for (int m = 0; m < n; ++m)
        {
            const int place = members[l][m];

            x.col(m) << x_[0][place], x_[1][place], x_[2][place];
            reach(m) = reach_[place];
        }

        grids[l].build(x, reach);
    }

    // In the order of the grid: neighbours are next to one another in memory
    for (int own = 0; own < all; ++own)
    {
        const double reach = reach_[own];

        for (int l = 0; l <= level[own]; ++l)
        {
            const cellGrid& grid = grids[l];

            if (members[l].empty())
            {
                continue;
            }

            grid.visitAround
            (
                {x_[0][own], x_[1][own], x_[2][own]},
                reach + furthest[l],
                [&](const int found, const double distanceSqr)
                {
                    const int other = members[l][grid.index_[found]];
                    const double sum = reach + reach_[other];

                    // Two of the same level find one another
                    if
                    (
                        distanceSqr > sum*sum
                     || (l == level[own] && other <= own)
                    )
                    {
                        return;
                    }

                    int i = index_[own];
                    int j = index_[other];

                    if (id(j) < id(i))
                    {
                        std::swap(i, j);
                    }

                    if ((i < n || (shared && j < n)) && id(i) != id(j))
                    {
                        add(i, j);
                    }
                }
            );
        }
    }
}


void Foam::aerosol::cellGrid::acting
(
    const int n,
    const scalars& id,
    std::vector<particlePair>& pairs
)
{
    pairs.clear();

    for (int source = 0; source < static_cast<int>(index_.size()); ++source)
    {
        if (reach_[source] <= 0)
        {
            continue;
        }

        const int j = index_[source];

        visit
        (
            source,
            reach_[source],
            [&](const int target, double)
            {
                const int i = index_[target];

                if (i < n && id(i) != id(j))
                {
                    pairs.push_back({i, j, {}});
                }
            }
        );
    }
}


void Foam::aerosol::cellGrid::acting
(
    const int n,
    const scalars& id,
    const scalars& skin,
    std::vector<particlePair>& pairs
)
{
    pairs.clear();

    const int all = static_cast<int>(index_.size());

    if (all == 0)
    {
        return;
    }

    // Sources search for particles of a small skin; those of a large skin,
    // which are few, search for sources
    const double small = 2*skin.mean();
    const double furthest = *std::max_element(reach_.begin(), reach_.end());

    const auto isSource = [&](const int place)
    {
        return reach_[place] > skin(index_[place]);
    };

    const auto add =
    [&](const int source, const int target, const double distanceSqr)
    {
        const int i = index_[target];
        const int j = index_[source];
        const double far = reach_[source] + skin(i);

        if (id(i) != id(j) && distanceSqr <= far*far)
        {
            pairs.push_back({i, j, {}});
        }
    };

    for (int own = 0; own < all; ++own)
    {
        const int i = index_[own];

        if (isSource(own))
        {
            visit
            (
                own,
                reach_[own] + small,
                [&](const int other, const double distanceSqr)
                {
                    if (index_[other] < n && skin(index_[other]) <= small)
                    {
                        add(own, other, distanceSqr);
                    }
                }
            );
        }

        if (i < n && skin(i) > small)
        {
            visit
            (
                own,
                skin(i) + furthest,
                [&](const int other, const double distanceSqr)
                {
                    if (isSource(other))
                    {
                        add(other, own, distanceSqr);
                    }
                }
            );
        }
    }
}


void Foam::aerosol::cellGrid::sort(particleArrays& p)
{
    cellGrid grid;
    grid.build(p.x, scalars::Zero(p.size()));

    p.reorder(grid.index_);
}


// ************************************************************************* //
