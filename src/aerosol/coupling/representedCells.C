/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "representedCells.H"
#include "eigenVector.H"

#include "foamVersion.H"
#include "polyMesh.H"
#include "Pstream.H"

#include <algorithm>
#include <array>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Bins per cell, in each direction
constexpr double binsPerCell = 4;

//- Most bins, all of which every rank has
constexpr double maxBins = 1e5;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::representedCells::representedCells
(
    const polyMesh& mesh,
    const boundBox& box,
    const Eigen::Array<bool, 3, 1>& whole
)
:
    box_(box),
    volume_(0)
{
    const labelListList& cellPoints = mesh.cellPoints();

    const auto bounds = [&](const label celli)
    {
        return boundBox(mesh.points(), cellPoints[celli], false);
    };

    // The smallest cells that the box meets
    vector smallest(box.span());

    forAll(cellPoints, celli)
    {
        const boundBox cell(bounds(celli));

        if (cell.overlaps(box))
        {
            smallest = min(smallest, cell.span());
        }
    }

    reduce(smallest, minOp<vector>());

    Eigen::Array3d n;

    for (int k = 0; k < 3; ++k)
    {
        // Rounding must not add a bin where they fit
        n(k) =
            whole(k)
          ? 1
          : std::ceil(binsPerCell*box.span()[k]/smallest[k] - 1e-6);
    }

    while (n.prod() > maxBins)
    {
        n = (0.9*n).floor().max(1.0);
    }

    n_ = n.cast<int>();
    size_ = toEigen(box.span()).array()/n;

    forAll(cellPoints, celli)
    {
        const boundBox cell(bounds(celli));

        // Along each direction: the first bin, and the fractions in the bins
        std::array<int, 3> first = {0, 0, 0};
        std::array<std::vector<double>, 3> part;

        for (int k = 0; k < 3; ++k)
        {
            if (whole(k))
            {
                part[k] = {1.0};
                continue;
            }

            const double low = (cell.min()[k] - box.min()[k])/size_(k);
            const double high = (cell.max()[k] - box.min()[k])/size_(k);

            first[k] = int(std::clamp(std::floor(low), 0.0, n(k)));
            const int end = int(std::clamp(std::ceil(high), 0.0, n(k)));

            for (int b = first[k]; b < end; ++b)
            {
                part[k].push_back
                (
                    (std::min(high, b + 1.0) - std::max(low, double(b)))
                   /(high - low)
                );
            }
        }

        const std::size_t before = bin_.size();

        for (std::size_t i = 0; i < part[0].size(); ++i)
        {
            for (std::size_t j = 0; j < part[1].size(); ++j)
            {
                for (std::size_t k = 0; k < part[2].size(); ++k)
                {
                    const double fraction = part[0][i]*part[1][j]*part[2][k];

                    bin_.push_back
                    (
                        first[0] + i
                      + n_(0)*(first[1] + j + n_(1)*(first[2] + k))
                    );
                    fraction_.push_back(fraction);
                    volume_ += fraction*mesh.cellVolumes()[celli];
                }
            }
        }

        if (bin_.size() > before)
        {
            cell_.push_back(celli);
            start_.push_back(before);
        }
    }

    start_.push_back(bin_.size());

    reduce(volume_, sumOp<scalar>());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::representedCells::add
(
    const vectors& x,
    const Eigen::MatrixXd& amounts,
    Eigen::MatrixXd& densities
) const
{
    const Eigen::Index rows = amounts.rows();

    scalarField sums(rows*n_.prod(), Zero);

    // Copies, which the compiler knows to stay as they are
    const Eigen::Array3i n = n_;
    const Eigen::Array3d perPeriod = 1/(size_*n_.cast<double>());
    const Eigen::Array3d low = toEigen(box_.min());

    for (Eigen::Index i = 0; i < x.cols(); ++i)
    {
        int bin = 0;

        for (int k = 2; k >= 0; --k)
        {
            // A particle that has just left is back on the other side
            const double place = (x(k, i) - low[k])*perPeriod[k];
            const double inside = place - std::floor(place);

            bin = bin*n[k] + std::min(int(inside*n[k]), n[k] - 1);
        }

        for (Eigen::Index row = 0; row < rows; ++row)
        {
            sums[rows*bin + row] += amounts(row, i);
        }
    }

    // The sums are in another place in memory after that
    combineToAll(sums, plusEqOp<scalar>());

    const Eigen::MatrixXd bins =
        Eigen::Map<const Eigen::MatrixXd>(sums.cdata(), rows, n_.prod())
       /size_.prod();

    for (std::size_t c = 0; c < cell_.size(); ++c)
    {
        for (int b = start_[c]; b < start_[c + 1]; ++b)
        {
            densities.col(cell_[c]) += fraction_[b]*bins.col(bin_[b]);
        }
    }
}


// ************************************************************************* //
