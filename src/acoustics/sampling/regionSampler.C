/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "regionSampler.H"
#include "eigenVector.H"

#include "polynomialFit.H"

#include "foamVersion.H"
#include "polyMesh.H"
#include "Pstream.H"

#include <algorithm>
#include <cmath>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Nodes of the lattice per cell
constexpr double nodesPerCell = 4;

//- Most nodes of a lattice: their weights take 150 MB
constexpr double maxNodes = 2.5e5;

//- Cells beyond the region, in cell sizes, from which stencils are chosen
constexpr double margin = 4;

//- Cells of a stencil by the number of directions the mesh resolves
constexpr int stencilSize[] = {1, 5, 16, 40};

} // End anonymous namespace


// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

//- Cells of all ranks, in an order that does not depend on the decomposition
struct Foam::acoustics::regionSampler::cells
{
    Eigen::Matrix3Xd centre;

    //- Size of the box around each cell
    Eigen::Matrix3Xd size;

    //- 1 in directions in which there is more than one layer of cells, else 0
    Eigen::Array3d resolved() const
    {
        const Eigen::Array3d layers =
            centre.rowwise().maxCoeff() - centre.rowwise().minCoeff();
        const Eigen::Array3d cell = size.rowwise().minCoeff();

        return (layers > 0.5*cell).cast<double>();
    }
};


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::acoustics::regionSampler::cells
Foam::acoustics::regionSampler::gatherCells
(
    const polyMesh& mesh,
    const boundBox& region
)
{
    const labelListList& cellPoints = mesh.cellPoints();

    DynamicList<label> chosen;
    DynamicList<vector> chosenSize;

    forAll(cellPoints, celli)
    {
        const boundBox box(mesh.points(), cellPoints[celli], false);
        const vector reach = margin*box.span();

        bool near = true;
        for (direction d = 0; d < 3; ++d)
        {
            near =
                near
             && (
                    mesh.solutionD()[d] == -1
                 || (
                        box.min()[d] - reach[d] <= region.max()[d]
                     && box.max()[d] + reach[d] >= region.min()[d]
                    )
                );
        }

        if (near)
        {
            chosen.append(celli);
            chosenSize.append(box.span());
        }
    }

    localCells_ = chosen;

    const label me = Pstream::myProcNo();
    List<vectorField> centres(Pstream::nProcs());
    List<vectorField> sizes(Pstream::nProcs());

    centres[me] = vectorField(mesh.cellCentres(), chosen);
    sizes[me] = chosenSize;

    gatherToAll(centres);
    gatherToAll(sizes);

    // The last bits of a centre depend on the order of the cell's faces, and
    // thus on the decomposition: round them off
    vector smallest(vector::max);
    forAll(sizes, proc)
    {
        for (const vector& size : sizes[proc])
        {
            smallest = min(smallest, size);
        }
    }
    const scalar unit = 1e-10*cmptMin(smallest);

    DynamicList<labelPair> source;
    DynamicList<vector> rounded;

    forAll(centres, proc)
    {
        forAll(centres[proc], i)
        {
            const vector& c = centres[proc][i];

            source.append(labelPair(proc, i));
            rounded.append
            (
                vector
                (
                    std::round(c.x()/unit)*unit,
                    std::round(c.y()/unit)*unit,
                    std::round(c.z()/unit)*unit
                )
            );
        }
    }

    std::vector<label> order(rounded.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort
    (
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            return std::lexicographical_compare
            (
                rounded[a].begin(), rounded[a].end(),
                rounded[b].begin(), rounded[b].end()
            );
        }
    );

    cells nearby;
    nearby.centre.resize(3, order.size());
    nearby.size.resize(3, order.size());
    source_.setSize(order.size());

    for (size_t i = 0; i < order.size(); ++i)
    {
        const labelPair& from = source[order[i]];

        source_[i] = from;
        nearby.centre.col(i) = toEigen(rounded[order[i]]);
        nearby.size.col(i) = toEigen(sizes[from.first()][from.second()]);
    }

    return nearby;
}


void Foam::acoustics::regionSampler::makeLattice
(
    const boundBox& region,
    const cells& nearby
)
{
    const Eigen::Array3d origin = toEigen(region.min());
    const Eigen::Array3d span =
        toEigen(region.span()).array().max(VSMALL);
    const Eigen::Array3d cell = nearby.size.rowwise().minCoeff();

    // Intervals between nodes
    Eigen::Array3d n =
        (resolved_*nodesPerCell*span/cell).ceil().max(1.0);

    while ((n + 1).prod() > maxNodes)
    {
        n = (0.9*n).floor().max(1.0);
    }

    const Eigen::Array3d spacing = span/n;

    // Also if a direction has but one cell, or hardly an extent
    intervalsPerCell_ = (cell.min(span)/spacing).round().max(1.0).cast<int>();

    // The part that this rank needs
    velocityLattice::index3 first;
    velocityLattice::index3 last;

    for (int d = 0; d < 3; ++d)
    {
        const double low = (region_.min()[d] - origin[d])/spacing[d];
        const double high = (region_.max()[d] - origin[d])/spacing[d];

        first[d] = int(std::clamp(std::floor(low), 0.0, n[d] - 1));
        last[d] = int(std::clamp(std::ceil(high), first[d] + 1.0, n[d]));
    }

    lattice_.reset(new velocityLattice(origin, spacing, first, last));
}


void Foam::acoustics::regionSampler::makeStencils
(
    const polyMesh& mesh,
    const cells& nearby
)
{
    const Eigen::Index nCells = nearby.centre.cols();

    const int nResolved = int(resolved_.sum());

    Eigen::Array3d solved;
    for (int d = 0; d < 3; ++d)
    {
        solved[d] = mesh.solutionD()[d] == -1 ? 0 : 1;
    }

    // Bins of cells, to find the near ones
    const Eigen::Array3d low = nearby.centre.rowwise().minCoeff();
    const Eigen::Array3d binSize = nearby.size.rowwise().maxCoeff();
    const Eigen::Array3i nBins =
        (
            (nearby.centre.rowwise().maxCoeff().array() - low)/binSize + 1
        ).cast<int>();

    const auto binOf = [&](const Eigen::Vector3d& x) -> Eigen::Array3i
    {
        return
            ((x.array() - low)/binSize).max(0.0)
           .min((nBins - 1).cast<double>()).cast<int>();
    };

    std::vector<std::vector<label>> bins(size_t(nBins.cast<double>().prod()));
    const auto bin = [&](const Eigen::Array3i& b) -> std::vector<label>&
    {
        return bins[b[0] + nBins[0]*(b[1] + size_t(nBins[1])*b[2])];
    };

    for (Eigen::Index i = 0; i < nCells; ++i)
    {
        bin(binOf(nearby.centre.col(i))).push_back(i);
    }


    const Eigen::Matrix3Xd nodes = lattice_->nodes();

    stencilStart_.assign(1, 0);

    std::vector<std::pair<double, label>> near;

    for (Eigen::Index node = 0; node < nodes.cols(); ++node)
    {
        const Eigen::Vector3d x = nodes.col(node);
        const Eigen::Array3i centreBin = binOf(x);

        // Distances in units of the cell's size
        near.clear();
        bool inside = false;

        const Eigen::Array3i from = (centreBin - 3).max(0);
        const Eigen::Array3i to = (centreBin + 3).min(nBins - 1);

        Eigen::Array3i b;
        for (b[2] = from[2]; b[2] <= to[2]; ++b[2])
        {
            for (b[1] = from[1]; b[1] <= to[1]; ++b[1])
            {
                for (b[0] = from[0]; b[0] <= to[0]; ++b[0])
                {
                    for (const label celli : bin(b))
                    {
                        const Eigen::Array3d r =
                            solved*(x - nearby.centre.col(celli)).array()
                           /nearby.size.col(celli).array();

                        near.emplace_back(r.square().sum(), celli);
                        inside = inside || r.abs().maxCoeff() < 0.75;
                    }
                }
            }
        }

        if (!inside)
        {
            FatalErrorInFunction
                << "The region " << region_ << " in which the gas velocity is"
                << " needed leaves the mesh at ("
                << x[0] << ' ' << x[1] << ' ' << x[2] << ")." << nl
                << "The mesh spans " << mesh.bounds()
                << exit(FatalError);
        }

        // The nearest cells; those at the same distance come together
        const auto last =
            near.begin()
          + std::min<size_t>(stencilSize[nResolved], near.size()) - 1;

        std::nth_element(near.begin(), last, near.end());

        const double farthest = last->first*(1 + 1e-6);

        near.erase
        (
            std::remove_if
            (
                near.begin(),
                near.end(),
                [&](const auto& cell) { return cell.first > farthest; }
            ),
            near.end()
        );
        std::sort(near.begin(), near.end());

        const size_t n = near.size();

        Eigen::Matrix3Xd offsets(3, n);
        Eigen::VectorXd importance(n);
        const double reach = 1.44*farthest;

        for (size_t i = 0; i < n; ++i)
        {
            const label celli = near[i].second;

            offsets.col(i) =
                (nearby.centre.col(celli) - x).cwiseQuotient
                (
                    nearby.size.col(near[0].second)
                );

            const double w = 1 - near[i].first/std::max(reach, VSMALL);
            importance[i] = w*w;
        }

        const Eigen::VectorXd weights = polynomialFit(offsets, importance);

        for (size_t i = 0; i < n; ++i)
        {
            stencilCell_.push_back(near[i].second);
            stencilWeight_.push_back(weights[i]);
        }
        stencilStart_.push_back(stencilCell_.size());
    }
}


void Foam::acoustics::regionSampler::sample
(
    const vectorField& U,
    velocityLattice::values& nodeVelocity
) const
{
    List<vectorField> gathered(Pstream::nProcs());

    gathered[Pstream::myProcNo()] =
        vectorField(U, localCells_);

    gatherToAll(gathered);

    velocityLattice::values cellVelocity(4, source_.size());

    forAll(source_, i)
    {
        const vector& v = gathered[source_[i].first()][source_[i].second()];

        cellVelocity.col(i) << v.x(), v.y(), v.z(), 0;
    }

    const Eigen::Index nNodes = lattice_->size();
    nodeVelocity.resize(4, nNodes);

    for (Eigen::Index node = 0; node < nNodes; ++node)
    {
        Eigen::Array4d sum = Eigen::Array4d::Zero();

        for (label i = stencilStart_[node]; i < stencilStart_[node + 1]; ++i)
        {
            sum += stencilWeight_[i]*cellVelocity.col(stencilCell_[i]);
        }

        nodeVelocity.col(node) = sum;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::regionSampler::regionSampler
(
    const polyMesh& mesh,
    const boundBox& region
)
:
    region_(region),
    fraction_(-1)
{
    boundBox all(region);
    all.reduce();

    // A point on the wall is in the mesh
    const scalar tolerance = 1e-9*mesh.bounds().mag();

    for (direction d = 0; d < 3; ++d)
    {
        if
        (
            mesh.solutionD()[d] != -1
         && (
                all.min()[d] < mesh.bounds().min()[d] - tolerance
             || all.max()[d] > mesh.bounds().max()[d] + tolerance
            )
        )
        {
            FatalErrorInFunction
                << "The region " << all << " in which the gas velocity is"
                << " needed leaves the mesh, which spans " << mesh.bounds()
                << exit(FatalError);
        }
    }

    const cells nearby = gatherCells(mesh, all);

    resolved_ = nearby.resolved();
    makeLattice(all, nearby);
    makeStencils(mesh, nearby);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::regionSampler::interpolationError
(
    const scalar waveNumber
) const
{
    return
        (resolved_*waveNumber*lattice_->spacing()).square().maxCoeff()/8;
}


void Foam::acoustics::regionSampler::reset
(
    const vectorField& begin,
    const vectorField& end
)
{
    sample(begin, begin_);
    sample(end, end_);
    fraction_ = -1;
}


void Foam::acoustics::regionSampler::advance(const vectorField& end)
{
    begin_.swap(end_);
    sample(end, end_);
    fraction_ = -1;
}


void Foam::acoustics::regionSampler::velocity
(
    const scalar fraction,
    const Eigen::Matrix3Xd& x,
    Eigen::Matrix3Xd& u
) const
{
    #ifdef FULLDEBUG
    for (Eigen::Index i = 0; i < x.cols(); ++i)
    {
        const point p(x(0, i), x(1, i), x(2, i));

        if (!region_.contains(p))
        {
            FatalErrorInFunction
                << "The gas velocity is asked for at " << p
                << ", outside of the region " << region_
                << " that was announced" << exit(FatalError);
        }
    }
    #endif

    if (fraction != fraction_)
    {
        now_ = (1 - fraction)*begin_ + fraction*end_;
        fraction_ = fraction;
    }

    lattice_->interpolate(now_, x, u);
}


// ************************************************************************* //
