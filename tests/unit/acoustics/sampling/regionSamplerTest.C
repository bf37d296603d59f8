/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// The gas velocity between the cells' centres: how close it comes to a known
// field, and where it must be exact.

#include "block.H"
#include "polynomialFit.H"
#include "regionSampler.H"
#include "velocityLattice.H"

#include "error.H"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>

using namespace Foam;
using namespace Foam::acoustics;

namespace
{

constexpr double pi = 3.14159265358979323846;

using field = std::function<vector(const vector&)>;

vectorField inCells(const polyMesh& mesh, const field& f)
{
    vectorField values(mesh.nCells());
    forAll(values, celli)
    {
        values[celli] = f(mesh.cellCentres()[celli]);
    }

    return values;
}

//- Random points in a box
Eigen::Matrix3Xd pointsIn(const boundBox& box, const int n = 500)
{
    Eigen::Matrix3Xd x = (Eigen::Matrix3Xd::Random(3, n).array() + 1)/2;
    for (int d = 0; d < 3; ++d)
    {
        x.row(d) = box.min()[d] + box.span()[d]*x.row(d).array();
    }

    return x;
}

//- Largest difference of the sampled and the exact field in the region
double samplingError
(
    const polyMesh& mesh,
    const boundBox& region,
    const field& f
)
{
    regionSampler sampler(mesh, region);
    const vectorField values = inCells(mesh, f);
    sampler.reset(values, values);

    const Eigen::Matrix3Xd x = pointsIn(region);
    Eigen::Matrix3Xd u;
    sampler.velocity(1, x, u);

    double largest = 0;
    for (int i = 0; i < x.cols(); ++i)
    {
        const vector exact = f(vector(x(0, i), x(1, i), x(2, i)));
        for (int d = 0; d < 3; ++d)
        {
            largest = std::max(largest, std::abs(u(d, i) - exact[d]));
        }
    }

    return largest;
}

} // End anonymous namespace


TEST(polynomialFit, reproducesACubicFunction)
{
    const Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Random(3, 60);
    const Eigen::VectorXd importance =
        Eigen::VectorXd::Random(60).array() + 1.1;

    const Eigen::VectorXd w = polynomialFit(x, importance);

    double sum = 0;
    for (int i = 0; i < x.cols(); ++i)
    {
        const double a = x(0, i);
        const double b = x(1, i);
        const double c = x(2, i);

        sum +=
            w(i)
           *(
                7 + a - 2*b + 3*c + a*a - 4*b*c + 0.3*c*c + a*c - b*b
              + a*b*c - 5*c*c*c + a*a*b
            );
    }

    EXPECT_NEAR(sum, 7, 1e-12);
}


TEST(polynomialFit, leavesOutWhatThePointsDoNotResolve)
{
    // Points on a line off the target: nothing is known across it
    Eigen::Matrix3Xd x(3, 5);
    x.row(0) << -2, -1, 0.5, 1, 2;
    x.row(1).setConstant(0.3);
    x.row(2).setConstant(-0.4);

    const Eigen::VectorXd w = polynomialFit(x, Eigen::VectorXd::Ones(5));

    EXPECT_NEAR(w.sum(), 1, 1e-14);
    EXPECT_NEAR(w.dot(x.row(0)), 0, 1e-13);
    EXPECT_NEAR(w.dot(x.row(0).cwiseAbs2()), 0, 1e-13);
    EXPECT_NEAR(w.dot(x.row(0).array().cube().matrix()), 0, 1e-13);

    // One point, two points: constant, linear
    EXPECT_NEAR
    (
        polynomialFit(Eigen::Vector3d(1, 1, 1), Eigen::VectorXd::Ones(1))(0),
        1,
        1e-15
    );
    EXPECT_NEAR
    (
        polynomialFit(x.leftCols(2), Eigen::VectorXd::Ones(2)).dot
        (
            x.row(0).leftCols(2)
        ),
        0,
        1e-13
    );
}


TEST(velocityLattice, isTheSameOnEveryRankThatHoldsThePoint)
{
    const Eigen::Array3d origin(0.1, -0.3, 0);
    const Eigen::Array3d spacing(0.013, 0.007, 0.01);

    const velocityLattice whole(origin, spacing, {0, 0, 0}, {9, 9, 9});
    const velocityLattice part(origin, spacing, {3, 2, 0}, {7, 6, 9});

    const auto sample = [](const velocityLattice& lattice)
    {
        const Eigen::Array3Xd x = lattice.nodes();
        velocityLattice::values v(4, x.cols());
        v.topRows<3>() = (31*x).sin();
        v.row(3).setZero();
        return v;
    };

    const boundBox held
    (
        point(0.1 + 3*0.013, -0.3 + 2*0.007, 0),
        point(0.1 + 7*0.013, -0.3 + 6*0.007, 0.09)
    );
    const Eigen::Matrix3Xd x = pointsIn(held);

    Eigen::Matrix3Xd u;
    Eigen::Matrix3Xd v;
    whole.interpolate(sample(whole), x, u);
    part.interpolate(sample(part), x, v);

    EXPECT_EQ(u, v);
}


TEST(regionSampler, isCloseToAStandingWave)
{
    // 50 cells per wavelength, oblique wave, region touching the walls
    const block cells({20, 20, 20}, {0.4, 0.4, 0.4});
    const vector k = 2*pi*normalised(vector(1, 2, 0.5));

    const field wave = [&](const vector& x)
    {
        return std::sin((k & x) + 0.7)*vector(1, -0.5, 0.2);
    };

    const double atWalls = samplingError
    (
        *cells.mesh,
        boundBox(vector::zero, {0.1, 0.1, 0.1}),
        wave
    );
    const double inside = samplingError
    (
        *cells.mesh,
        boundBox(vector::uniform(0.1), vector::uniform(0.2)),
        wave
    );

    RecordProperty("percentAtWalls", std::to_string(100*atWalls));
    RecordProperty("percentInside", std::to_string(100*inside));

    EXPECT_LT(inside, 5e-4);
    EXPECT_LT(atWalls, 1e-3);
}


TEST(regionSampler, convergesWithSecondOrder)
{
    const field wave = [](const vector& x)
    {
        return std::sin(2*pi*x.x() + 0.4)*vector(1, 0, 0);
    };
    const boundBox region({0, 0.02, 0.02}, {0.4, 0.08, 0.08});

    // 25, 50 and 100 cells per wavelength, one cell across
    double last = 0;
    for (const label n : {20, 40, 80})
    {
        const block cells({n, 1, 1}, {0.8, 0.1, 0.1});
        const double now = samplingError(*cells.mesh, region, wave);

        if (last > 0)
        {
            EXPECT_GT(std::log2(last/now), 1.9);
        }
        last = now;
    }

    EXPECT_LT(last, 1e-4);
}


TEST(regionSampler, isExactForALinearField)
{
    const field shear = [](const vector& x)
    {
        return vector(1 + 3*x.x() - x.y(), x.x() + 2*x.y(), 4 - x.y());
    };

    // One cell thick in z, where nothing varies
    const block cells({7, 5, 1}, {0.3, 0.4, 0.01});

    const double thin =
        samplingError(*cells.mesh, cells.mesh->bounds(), shear);

    EXPECT_NEAR(thin, 0, 1e-11);

    // Two cells resolve a linear field, but no more
    const block few({2, 2, 2}, {1, 1, 1});

    const double coarse =
        samplingError(*few.mesh, few.mesh->bounds(), shear);

    EXPECT_NEAR(coarse, 0, 1e-11);
}


TEST(regionSampler, isLinearInTimeAndExactAtTheEnds)
{
    const block cells({10, 1, 1}, {1, 0.1, 0.1});
    const boundBox region({0.3, 0, 0}, {0.6, 0.1, 0.1});

    regionSampler sampler(*cells.mesh, region);
    const auto uniform = [&](const double u)
    {
        return vectorField(cells.mesh->nCells(), vector(u, 2*u, -u));
    };
    sampler.reset(uniform(1), uniform(3));

    const Eigen::Matrix3Xd x = pointsIn(region, 1);
    Eigen::Matrix3Xd u;
    const auto at = [&](const double fraction)
    {
        sampler.velocity(fraction, x, u);
        return u(0, 0);
    };

    EXPECT_NEAR(at(0), 1, 1e-14);
    EXPECT_NEAR(at(0.25), 1.5, 1e-14);

    const double end = at(1);
    EXPECT_NEAR(end, 3, 1e-14);

    // The end of this step is the beginning of the next, to the last bit
    sampler.advance(uniform(10));
    EXPECT_EQ(at(0), end);
    EXPECT_NEAR(at(0.5), 6.5, 1e-14);
}


TEST(regionSampler, refusesARegionOutsideOfTheMesh)
{
    const block cells({4, 4, 4}, {1, 1, 1});

    EXPECT_THROW
    (
        regionSampler(*cells.mesh, boundBox({0.5, 0.5, 0.5}, {1.01, 0.6, 0.6})),
        Foam::error
    );
    EXPECT_NO_THROW(regionSampler(*cells.mesh, cells.mesh->bounds()));
}


TEST(velocityLattice, hasTheGradientOfParts)
{
    // Linear, but for every other node
    const velocityLattice lattice
    (
        Eigen::Array3d(1, 2, 3), Eigen::Array3d(0.1, 0.2, 0.3),
        {0, 0, 0}, {8, 4, 12}
    );
    Eigen::Matrix3d A;
    A << 3, -7, 2, 11, -5, 0.5, -1, 4, 2;

    velocityLattice::values u(4, lattice.size());
    u.topRows<3>() = (A*lattice.nodes()).array();
    u.row(3).setZero();

    EXPECT_NEAR(lattice.rmsGradient(u, {1, 1, 1})/A.norm(), 1, 1e-12);

    for (Eigen::Index node = 0; node < u.cols(); ++node)
    {
        u(0, node) += node % 9 % 2;
    }

    EXPECT_GT(lattice.rmsGradient(u, {1, 1, 1})/A.norm(), 1.1);
    EXPECT_NEAR(lattice.rmsGradient(u, {2, 2, 2})/A.norm(), 1, 1e-12);

    // Longer than the lattice
    EXPECT_NEAR(lattice.rmsGradient(u, {100, 100, 100})/A.norm(), 1, 1e-12);
}


// ************************************************************************* //
