/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "searchGrid.H"
#include "domain.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Eigen::Array3d components(const Foam::vector& v)
{
    return {v.x(), v.y(), v.z()};
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::aerosol::particlePair Foam::aerosol::searchGrid::makePair
(
    const entry& own,
    const entry& other,
    const std::array<int, 3>& image
)
{
    particlePair pair{own.index, other.index, {}};

    for (int k = 0; k < 3; ++k)
    {
        pair.image[k] =
            static_cast<std::int8_t>
            (
                image[k] + other.moved[k] - own.moved[k]
            );
    }

    return pair;
}


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
    bool inside = true;

    for (int k = 0; k < 3; ++k)
    {
        // A little more, lest rounding hides a particle on the face of a cell
        const double r = radius + 1e-12*span_(k);

        lo[k] = cellIndex(centre(k) - r, k);
        hi[k] = cellIndex(centre(k) + r, k);

        if (period_(k) == 0)
        {
            // What is outside of the bounds is kept in the border cells
            lo[k] = std::min(std::max(lo[k], 0), cells_[k] - 1);
            hi[k] = std::min(std::max(hi[k], 0), cells_[k] - 1);
        }

        inside = inside && lo[k] >= 0 && hi[k] < cells_[k];
    }

    // Cells of a row are next to one another: they are a single run of entries
    const auto run =
    [&](
        const int row,
        const int first,
        const int last,
        const Eigen::Array3d& from,
        const std::array<int, 3>& image
    )
    {
        const entry* other = entries_.data() + start_[row + first];
        const entry* const end = entries_.data() + start_[row + last + 1];

        for (; other != end; ++other)
        {
            visitor(*other, (other->x - from).matrix().squaredNorm(), image);
        }
    };

    if (inside)
    {
        // Most are far enough from the border to see no images
        for (int cx = lo[0]; cx <= hi[0]; ++cx)
        {
            for (int cy = lo[1]; cy <= hi[1]; ++cy)
            {
                const int row = (cx*cells_[1] + cy)*cells_[2];

                run(row, lo[2], hi[2], centre, {0, 0, 0});
            }
        }

        return;
    }

    const auto floorDivide = [](const int a, const int b)
    {
        return a >= 0 ? a/b : -((b - 1 - a)/b);
    };

    std::array<int, 3> image;
    Eigen::Array3d from;

    for (int cx = lo[0]; cx <= hi[0]; ++cx)
    {
        image[0] = floorDivide(cx, cells_[0]);
        from(0) = centre(0) - image[0]*period_(0);
        const int plane = (cx - image[0]*cells_[0])*cells_[1];

        for (int cy = lo[1]; cy <= hi[1]; ++cy)
        {
            image[1] = floorDivide(cy, cells_[1]);
            from(1) = centre(1) - image[1]*period_(1);
            const int row = (plane + cy - image[1]*cells_[1])*cells_[2];

            for (int cz = lo[2]; cz <= hi[2]; )
            {
                image[2] = floorDivide(cz, cells_[2]);
                from(2) = centre(2) - image[2]*period_(2);

                // All those of one image at once
                const int begin = image[2]*cells_[2];
                const int last = std::min(hi[2], begin + cells_[2] - 1);

                run(row, cz - begin, last - begin, from, image);

                cz = last + 1;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::searchGrid::searchGrid(const domain& region)
:
    origin_(components(region.bounds().min())),
    span_(components(region.bounds().span())),
    period_(region.period()),
    cells_{1, 1, 1},
    inverseSize_(1/span_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::searchGrid::build(const vectors& x, const scalars& reach)
{
    const int n = static_cast<int>(reach.size());

    // About one cell per particle
    const double size = std::cbrt(span_.prod()/std::max(n, 1));

    for (int k = 0; k < 3; ++k)
    {
        cells_[k] = std::max(1, static_cast<int>(span_(k)/size));
        inverseSize_(k) = cells_[k]/span_(k);
    }

    // Counting sort, which keeps the order of the particles in a cell
    start_.assign(cells_[0]*cells_[1]*cells_[2] + 1, 0);
    cellOf_.resize(n);
    unsorted_.resize(n);
    entries_.resize(n);

    for (int i = 0; i < n; ++i)
    {
        entry& particle = unsorted_[i];

        particle.x = x.col(i).array();
        particle.reach = reach(i);
        particle.index = i;

        int cell = 0;

        for (int k = 0; k < 3; ++k)
        {
            int c = cellIndex(particle.x(k), k);
            int moved = 0;

            if (period_(k) > 0 && (c < 0 || c >= cells_[k]))
            {
                moved =
                    -static_cast<int>
                    (
                        std::floor((particle.x(k) - origin_(k))/span_(k))
                    );
                particle.x(k) += moved*period_(k);
                c = cellIndex(particle.x(k), k);
            }

            particle.moved[k] = static_cast<std::int8_t>(moved);
            cell = cell*cells_[k] + std::min(std::max(c, 0), cells_[k] - 1);
        }

        cellOf_[i] = cell;
        ++start_[cell + 1];
    }

    for (std::size_t c = 1; c < start_.size(); ++c)
    {
        start_[c] += start_[c - 1];
    }

    for (int i = n - 1; i >= 0; --i)
    {
        entries_[--start_[cellOf_[i] + 1]] = unsorted_[i];
    }

    // start_[c + 1] is now where cell c begins
    start_.erase(start_.begin());
    start_.push_back(n);
}


void Foam::aerosol::searchGrid::touching
(
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
            [&]
            (
                const entry& other,
                const double distanceSqr,
                const std::array<int, 3>& image
            )
            {
                const double sum = own.reach + other.reach;

                if
                (
                    distanceSqr <= sum*sum
                 && (
                        other.reach < own.reach
                     || (other.reach == own.reach && other.index > own.index)
                    )
                )
                {
                    pairs.push_back(makePair(own, other, image));
                }
            }
        );
    }
}


void Foam::aerosol::searchGrid::acting(std::vector<particlePair>& pairs) const
{
    pairs.clear();

    // In the order of the grid: neighbours are next to one another in memory
    for (const entry& own : entries_)
    {
        if (own.reach <= 0)
        {
            continue;
        }

        visit
        (
            own.x,
            own.reach,
            [&]
            (
                const entry& other,
                const double distanceSqr,
                const std::array<int, 3>& image
            )
            {
                if
                (
                    distanceSqr <= own.reach*own.reach
                 && other.index != own.index
                )
                {
                    // The other one's image meets the source; seen from the
                    // other one, it is the source that is an image
                    particlePair pair = makePair(own, other, image);

                    std::swap(pair.i, pair.j);
                    for (std::int8_t& m : pair.image)
                    {
                        m = -m;
                    }

                    pairs.push_back(pair);
                }
            }
        );
    }
}


// ************************************************************************* //
