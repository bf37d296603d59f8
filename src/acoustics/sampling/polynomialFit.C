/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "polynomialFit.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr int nTerms = 20;

//- A term of which less than this fraction is left by the terms before it is
//  not resolved by the points
constexpr double resolved = 0.01;

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

    Eigen::Matrix<double, Eigen::Dynamic, nTerms> terms(n, nTerms);

    for (Eigen::Index i = 0; i < n; ++i)
    {
        const double x = offsets(0, i);
        const double y = offsets(1, i);
        const double z = offsets(2, i);

        terms.row(i) <<
            1,
            x, y, z,
            x*x, y*y, z*z, x*y, y*z, z*x,
            x*x*x, y*y*y, z*z*z,
            x*x*y, x*x*z, y*y*x, y*y*z, z*z*x, z*z*y, x*y*z;

        terms.row(i) *= root(i);
    }

    // Values of the terms at the target, where all but the first vanish
    Eigen::Matrix<double, nTerms, 1> atTarget;
    atTarget.setZero();
    atTarget(0) = 1;

    Eigen::VectorXd weights = Eigen::VectorXd::Zero(n);
    int kept = 0;

    for (int term = 0; term < nTerms; ++term)
    {
        auto column = terms.col(term);
        double value = atTarget(term);
        const double before = column.norm();

        // Twice is enough for full accuracy
        for (int pass = 0; pass < 2; ++pass)
        {
            for (int other = 0; other < kept; ++other)
            {
                const double part = terms.col(other).dot(column);

                column -= part*terms.col(other);
                value -= part*atTarget(other);
            }
        }

        const double left = column.norm();

        if (left > resolved*before)
        {
            terms.col(kept) = column/left;
            atTarget(kept) = value/left;

            weights += atTarget(kept)*terms.col(kept);
            ++kept;
        }
    }

    return weights.cwiseProduct(root);
}


// ************************************************************************* //
