/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polynomialFit.H"

#include <Eigen/QR>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Columns and pivots below this fraction count as not resolved
constexpr double resolved = 1e-6;


//- Adds the terms `basis` (one row per point, weighted by the root of the
//  importance) with their values at the target to the fit. They must be
//  orthogonal to what is in it already.
void addTerms
(
    const Eigen::MatrixXd& basis,
    const Eigen::RowVectorXd& atTarget,
    const Eigen::VectorXd& root,
    Eigen::VectorXd& weights
)
{
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(resolved);
    decomposition.compute(basis);

    if (decomposition.rank() > 0)
    {
        const Eigen::MatrixXd inverse = decomposition.pseudoInverse();

        weights +=
            (atTarget*inverse).transpose().cwiseProduct(root);
    }
}


//- Makes columns of the basis orthogonal to those of `to`, which are
//  combinations that can be evaluated at the target as well; drops those of
//  which nothing is left
void orthogonalise
(
    const Eigen::MatrixXd& to,
    const Eigen::RowVectorXd& toAtTarget,
    Eigen::MatrixXd& basis,
    Eigen::RowVectorXd& atTarget
)
{
    const Eigen::RowVectorXd before = basis.colwise().norm();

    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(resolved);
    decomposition.compute(to);

    if (decomposition.rank() > 0)
    {
        const Eigen::MatrixXd projection = decomposition.solve(basis);

        basis -= to*projection;
        atTarget -= toAtTarget*projection;
    }

    for (Eigen::Index j = 0; j < basis.cols(); ++j)
    {
        if (basis.col(j).norm() <= resolved*before(j))
        {
            basis.col(j).setZero();
            atTarget(j) = 0;
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Eigen::VectorXd Foam::acoustics::polynomialFit
(
    const Eigen::Matrix3Xd& offsets,
    const Eigen::VectorXd& importance
)
{
    const Eigen::Index n = offsets.cols();
    const Eigen::VectorXd root = importance.cwiseSqrt();

    Eigen::VectorXd weights = importance/importance.sum();

    const Eigen::MatrixXd constant = root;
    const Eigen::RowVectorXd one = Eigen::RowVectorXd::Ones(1);

    Eigen::MatrixXd linear(n, 3);
    Eigen::MatrixXd quadratic(n, 6);

    for (Eigen::Index i = 0; i < n; ++i)
    {
        const double x = offsets(0, i);
        const double y = offsets(1, i);
        const double z = offsets(2, i);

        linear.row(i) << x, y, z;
        quadratic.row(i) << x*x, y*y, z*z, x*y, y*z, z*x;

        linear.row(i) *= root(i);
        quadratic.row(i) *= root(i);
    }

    // All terms but the constant vanish at the target
    Eigen::RowVectorXd linearAtTarget = Eigen::RowVectorXd::Zero(3);
    Eigen::RowVectorXd quadraticAtTarget = Eigen::RowVectorXd::Zero(6);

    orthogonalise(constant, one, linear, linearAtTarget);
    addTerms(linear, linearAtTarget, root, weights);

    Eigen::MatrixXd affine(n, 4);
    affine << constant, linear;
    Eigen::RowVectorXd affineAtTarget(4);
    affineAtTarget << one, linearAtTarget;

    orthogonalise(affine, affineAtTarget, quadratic, quadraticAtTarget);
    addTerms(quadratic, quadraticAtTarget, root, weights);

    return weights;
}


// ************************************************************************* //
