/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "searchGrid.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Visitor>
void Foam::aerosol::searchGrid::visit
(
    const Eigen::Array3d& centre,
    const double radius,
    Visitor&& visitor
) const
{
    std::array<int, 3> lo;
    std::array<int, 3> hi;

    for (int k = 0; k < 3; ++k)
    {
        // A little more, lest rounding hides a particle on the face of a cell
        const double r = radius*(1 + 1e-9);

        lo[k] = cellIndex(centre(k) - r, k);
        hi[k] = cellIndex(centre(k) + r, k);
    }

    for (int cx = lo[0]; cx <= hi[0]; ++cx)
    {
        for (int cy = lo[1]; cy <= hi[1]; ++cy)
        {
            // Cells of a row are next to one another: a single run of entries
            const int row = (cx*cells_[1] + cy)*cells_[2];

            const entry* other = entries_.data() + start_[row + lo[2]];
            const entry* const end = entries_.data() + start_[row + hi[2] + 1];

            for (; other != end; ++other)
            {
                const double r0 = other->x(0) - centre(0);
                const double r1 = other->x(1) - centre(1);
                const double r2 = other->x(2) - centre(2);

                visitor(*other, r0*r0 + r1*r1 + r2*r2);
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::searchGrid::build(const vectors& x, const scalars& reach)
{
    const int n = static_cast<int>(reach.size());

    Eigen::Array3d span = Eigen::Array3d::Zero();
    origin_.setZero();

    if (n)
    {
        origin_ = x.rowwise().minCoeff().array();
        span = x.rowwise().maxCoeff().array() - origin_;
    }

    // About one cell per particle, also if all are in a plane or on a line
    const double longest = std::max(span.maxCoeff(), 1e-30);
    const Eigen::Array3d edge = span.max(1e-3*longest);
    const double size = std::cbrt(edge.prod()/std::max(n, 1));

    for (int k = 0; k < 3; ++k)
    {
        cells_[k] = std::max(1, static_cast<int>(edge(k)/size));
        inverseSize_(k) = cells_[k]/edge(k);
    }

    // Counting sort, which keeps the order of the particles in a cell
    start_.assign(cells_[0]*cells_[1]*cells_[2] + 1, 0);
    cellOf_.resize(n);
    entries_.resize(n);

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
        entry& particle = entries_[--start_[cellOf_[i] + 1]];

        particle.x = x.col(i).array();
        particle.reach = reach(i);
        particle.index = i;
    }

    // start_[c + 1] is now where cell c begins
    start_.erase(start_.begin());
    start_.push_back(n);
}


void Foam::aerosol::searchGrid::touching
(
    const int n,
    const scalars& id,
    std::vector<particlePair>& pairs
) const
{
    pairs.clear();

    // In the order of the grid: neighbours are next to one another in memory
    for (const entry& own : entries_)
    {
        // The one with the larger reach looks for the other one
        visit
        (
            own.x,
            2*own.reach,
            [&](const entry& other, const double distanceSqr)
            {
                const double sum = own.reach + other.reach;

                if
                (
                    distanceSqr > sum*sum
                 || other.reach > own.reach
                 || (other.reach == own.reach && other.index <= own.index)
                )
                {
                    return;
                }

                int i = own.index;
                int j = other.index;

                if (id(j) < id(i))
                {
                    std::swap(i, j);
                }

                if (i < n && id(i) != id(j))
                {
                    pairs.push_back({i, j, {}});
                }
            }
        );
    }
}


std::vector<Foam::aerosol::particlePair>
Foam::aerosol::searchGrid::touching
(
    const domain& region,
    const vectors& x,
    const scalars& reach
)
{
    const int n = static_cast<int>(reach.size());

    halo copies(region, true);
    copies.build(x, reach, true);

    vectors places = x;
    scalars reaches = reach;
    scalars index = scalars::LinSpaced(n, 0, n - 1);

    copies.fill
    ({
        {places, copies, true}, {reaches, copies}, {index, copies}
    });

    searchGrid grid;
    std::vector<particlePair> pairs;

    grid.build(places, reaches);
    grid.touching(n, index, pairs);

    for (particlePair& pair : pairs)
    {
        pair.image = copies.image(pair.j);
        pair.j = static_cast<int>(index(pair.j));
    }

    return pairs;
}


void Foam::aerosol::searchGrid::acting
(
    const int n,
    const scalars& id,
    std::vector<particlePair>& pairs
) const
{
    pairs.clear();

    for (const entry& source : entries_)
    {
        if (source.reach <= 0)
        {
            continue;
        }

        const double reachSqr = source.reach*source.reach;

        visit
        (
            source.x,
            source.reach,
            [&](const entry& other, const double distanceSqr)
            {
                if
                (
                    distanceSqr <= reachSqr
                 && other.index < n
                 && other.index != source.index
                 && id(other.index) != id(source.index)
                )
                {
                    pairs.push_back({other.index, source.index, {}});
                }
            }
        );
    }
}


std::vector<int> Foam::aerosol::searchGrid::order() const
{
    std::vector<int> indices;
    indices.reserve(entries_.size());

    for (const entry& particle : entries_)
    {
        indices.push_back(particle.index);
    }

    return indices;
}


// ************************************************************************* //
