#include "searchGrid.H"
#include "domain.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A factor of two in reach per level: a ratio of 1000 needs ten
constexpr int maxLevels = 12;

Eigen::Array3d components(const Foam::vector& v)
{
    return {v.x(), v.y(), v.z()};
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

int Foam::aerosol::searchGrid::cellIndex
(
    const level& grid,
    const Eigen::Array3d& x,
    int k
) const
{
    return static_cast<int>(std::floor((x(k) - origin_(k))/grid.cellSize(k)));
}


void Foam::aerosol::searchGrid::fill(level& grid) const
{
    // No more than two cells per particle, whatever the reach
    const double volume = span_.prod();
    const double smallest =
        std::max(grid.reach, std::cbrt(0.5*volume/grid.entries.size()));

    for (int k = 0; k < 3; ++k)
    {
        grid.cells[k] =
            std::max(1, static_cast<int>(std::min(1e3, span_(k)/smallest)));
        grid.cellSize(k) = span_(k)/grid.cells[k];
    }

    const int nCells = grid.cells[0]*grid.cells[1]*grid.cells[2];

    // Counting sort, which keeps the order of the particles in a cell
    std::vector<int> cellOf(grid.entries.size());
    grid.start.assign(nCells + 1, 0);

    for (std::size_t e = 0; e < grid.entries.size(); ++e)
    {
        entry& particle = grid.entries[e];
        int cell = 0;

        for (int k = 0; k < 3; ++k)
        {
            const int c = cellIndex(grid, particle.x, k);
            cell =
                cell*grid.cells[k] + std::min(std::max(c, 0), grid.cells[k]-1);
        }

        cellOf[e] = cell;
        ++grid.start[cell + 1];
    }

    for (int c = 0; c < nCells; ++c)
    {
        grid.start[c + 1] += grid.start[c];
    }

    std::vector<entry> sorted(grid.entries.size());
    std::vector<int> next(grid.start.begin(), grid.start.end() - 1);

    for (std::size_t e = 0; e < grid.entries.size(); ++e)
    {
        sorted[next[cellOf[e]]++] = grid.entries[e];
    }

    grid.entries.swap(sorted);
}


template<class Visitor>
void Foam::aerosol::searchGrid::visit
(
    const level& grid,
    const Eigen::Array3d& x,
    const double radius,
    Visitor&& visitor
) const
{
    // A little more, lest rounding hides a particle on the face of a cell
    const Eigen::Array3d reach = radius + 1e-12*span_;

    std::array<int, 3> lo;
    std::array<int, 3> hi;

    for (int k = 0; k < 3; ++k)
    {
        lo[k] = cellIndex(grid, x - reach, k);
        hi[k] = cellIndex(grid, x + reach, k);

        if (period_(k) == 0)
        {
            // Particles outside of the bounds are kept in the border cells
            lo[k] = std::min(std::max(lo[k], 0), grid.cells[k] - 1);
            hi[k] = std::min(std::max(hi[k], 0), grid.cells[k] - 1);
        }
    }

    const auto floorDivide = [](const int a, const int b)
    {
        return a >= 0 ? a/b : -((b - 1 - a)/b);
    };

    std::array<std::int8_t, 3> image;
    Eigen::Array3d shift;

    for (int cx = lo[0]; cx <= hi[0]; ++cx)
    {
        const int ix = floorDivide(cx, grid.cells[0]);
        const int rowX = (cx - ix*grid.cells[0])*grid.cells[1];
        image[0] = static_cast<std::int8_t>(ix);
        shift(0) = ix*period_(0);

        for (int cy = lo[1]; cy <= hi[1]; ++cy)
        {
            const int iy = floorDivide(cy, grid.cells[1]);
            const int rowY =
                (rowX + cy - iy*grid.cells[1])*grid.cells[2];
            image[1] = static_cast<std::int8_t>(iy);
            shift(1) = iy*period_(1);

            for (int cz = lo[2]; cz <= hi[2]; ++cz)
            {
                const int iz = floorDivide(cz, grid.cells[2]);
                const int cell = rowY + cz - iz*grid.cells[2];
                image[2] = static_cast<std::int8_t>(iz);
                shift(2) = iz*period_(2);

                for (int e = grid.start[cell]; e < grid.start[cell+1]; ++e)
                {
                    const entry& other = grid.entries[e];

                    visitor
                    (
                        other,
                        (other.x + shift - x).matrix().squaredNorm(),
                        image
                    );
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::searchGrid::searchGrid(const domain& region)
:
    origin_(components(region.bounds().min())),
    span_(components(region.bounds().span())),
    period_(region.period())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::searchGrid::build(const vectors& x, const scalars& reach)
{
    x_ = x;
    reach_ = reach;

    const int n = static_cast<int>(reach.size());

    levels_.clear();
    levelOf_.assign(n, -1);

    if (n == 0)
    {
        return;
    }

    // Below half the mean distance, smaller cells find nothing faster
    const double largest = reach.maxCoeff();
    const double base =
        std::max
        (
            0.5*std::cbrt(span_.prod()/n),
            largest*std::exp2(1 - maxLevels)
        );

    levels_.resize(maxLevels);

    for (int i = 0; i < n; ++i)
    {
        if (reach(i) <= 0)
        {
            continue;
        }

        const int l =
            reach(i) <= base
          ? 0
          : std::min
            (
                maxLevels - 1,
                static_cast<int>(std::ceil(std::log2(reach(i)/base)))
            );

        levelOf_[i] = l;
        levels_[l].reach = std::max(levels_[l].reach, reach(i));
        levels_[l].entries.push_back({x.col(i).array(), reach(i), i});
    }

    for (level& grid : levels_)
    {
        if (!grid.entries.empty())
        {
            fill(grid);
        }
    }
}


void Foam::aerosol::searchGrid::touching
(
    std::vector<particlePair>& pairs
) const
{
    pairs.clear();

    const int n = static_cast<int>(reach_.size());

    for (int i = 0; i < n; ++i)
    {
        const Eigen::Array3d x = x_.col(i).array();
        const double reach = reach_(i);

        // The one with the smaller reach looks for the one with the larger
        const int own = levelOf_[i];

        for (int l = std::max(own, 0); l < maxLevels; ++l)
        {
            const level& grid = levels_[l];

            if (grid.entries.empty())
            {
                continue;
            }

            visit
            (
                grid,
                x,
                reach + grid.reach,
                [&]
                (
                    const entry& other,
                    const double distanceSqr,
                    const std::array<std::int8_t, 3>& image
                )
                {
                    const double sum = reach + other.reach;

                    if
                    (
                        distanceSqr <= sum*sum
                     && (l == own ? other.index > i : other.index != i)
                    )
                    {
                        pairs.push_back({i, other.index, image});
                    }
                }
            );
        }
    }
}


void Foam::aerosol::searchGrid::acting(std::vector<particlePair>& pairs) const
{
    pairs.clear();

    const int n = static_cast<int>(reach_.size());

    for (int i = 0; i < n; ++i)
    {
        const Eigen::Array3d x = x_.col(i).array();

        for (const level& grid : levels_)
        {
            if (grid.entries.empty())
            {
                continue;
            }

            visit
            (
                grid,
                x,
                grid.reach,
                [&]
                (
                    const entry& other,
                    const double distanceSqr,
                    const std::array<std::int8_t, 3>& image
                )
                {
                    if
                    (
                        distanceSqr <= other.reach*other.reach
                     && other.index != i
                    )
                    {
                        pairs.push_back({i, other.index, image});
                    }
                }
            );
        }
    }
}


// ************************************************************************* //
