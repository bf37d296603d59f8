/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Densities in cells from amounts of particles in a box: nothing is lost.

\*---------------------------------------------------------------------------*/

#include "block.H"
#include "representedCells.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::aerosol;

namespace
{

//- Cells of 1 mm x 2 mm x 3 mm
block mesh()
{
    return block({4, 3, 2}, vector(4e-3, 6e-3, 6e-3));
}

//- Two rows of amounts of particles in a box
struct particles
{
    vectors x;
    Eigen::MatrixXd amounts;

    explicit particles(const boundBox& box, const int n = 200)
    :
        x(3, n),
        amounts(Eigen::MatrixXd::Random(2, n))
    {
        for (int k = 0; k < 3; ++k)
        {
            x.row(k) =
                box.min()[k]
              + box.span()[k]*(0.5 + 0.5*Eigen::ArrayXd::Random(n));
        }
    }
};

//- What is in the cells
Eigen::VectorXd total(const polyMesh& mesh, const Eigen::MatrixXd& densities)
{
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(densities.rows());

    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        sum += mesh.cellVolumes()[celli]*densities.col(celli);
    }

    return sum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(representedCells, getWhatTheBoxHasWhereItStandsForItsOwnExtent)
{
    const block b = mesh();

    // Across faces of cells
    const boundBox box(point(0.7e-3, 1.1e-3, 2e-3), point(2.9e-3, 3e-3, 5e-3));
    const representedCells cells(*b.mesh, box, {false, false, false});

    EXPECT_NEAR(cells.volume(), box.volume(), 1e-12*box.volume());

    const particles p(box);
    Eigen::MatrixXd densities = Eigen::MatrixXd::Zero(2, b.mesh->nCells());
    cells.add(p.x, p.amounts, densities);

    const Eigen::VectorXd in = p.amounts.rowwise().sum();
    EXPECT_LT((total(*b.mesh, densities) - in).norm(), 1e-12*in.norm());

    // No cell that the box does not meet
    for (label celli = 0; celli < b.mesh->nCells(); ++celli)
    {
        if (b.mesh->cellCentres()[celli].x() > 3e-3)
        {
            EXPECT_EQ(densities.col(celli).norm(), 0);
        }
    }
}


TEST(representedCells, getSoManyTimesMoreWhereItStandsForTheWholeMesh)
{
    const block b = mesh();
    const boundBox box(point(1e-3, 2.9e-3, 2.9e-3), point(2e-3, 3e-3, 3e-3));
    const representedCells cells(*b.mesh, box, {false, true, true});

    // A slice of 1 mm of the mesh
    const double volume = 1e-3*6e-3*6e-3;
    EXPECT_NEAR(cells.volume(), volume, 1e-12*volume);

    const particles p(box);
    Eigen::MatrixXd densities = Eigen::MatrixXd::Zero(2, b.mesh->nCells());
    cells.add(p.x, p.amounts, densities);

    const Eigen::VectorXd in =
        volume/box.volume()*p.amounts.rowwise().sum();
    EXPECT_LT((total(*b.mesh, densities) - in).norm(), 1e-12*in.norm());
}


TEST(representedCells, haveAParticleWhereItIs)
{
    const block b = mesh();
    const boundBox box(point(0, 0, 0), point(4e-3, 6e-3, 6e-3));
    const representedCells cells(*b.mesh, box, {false, false, false});

    const Eigen::MatrixXd one = Eigen::MatrixXd::Ones(1, 1);

    for (label celli = 0; celli < b.mesh->nCells(); ++celli)
    {
        // Also of its periodic image, when it has just left
        for (const double moved : {0.0, 4e-3, -4e-3})
        {
            const point& centre = b.mesh->cellCentres()[celli];
            const vectors x
            (
                Eigen::Vector3d(centre.x() + moved, centre.y(), centre.z())
            );

            Eigen::MatrixXd densities =
                Eigen::MatrixXd::Zero(1, b.mesh->nCells());
            cells.add(x, one, densities);

            const double inverse = 1/b.mesh->cellVolumes()[celli];
            EXPECT_NEAR(densities(0, celli), inverse, 1e-9*inverse);
            EXPECT_NEAR(densities.sum(), inverse, 1e-9*inverse);
        }
    }
}


// ************************************************************************* //
