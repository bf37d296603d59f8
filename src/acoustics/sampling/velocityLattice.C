/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "velocityLattice.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::velocityLattice::velocityLattice
(
    const Eigen::Array3d& origin,
    const Eigen::Array3d& spacing,
    const index3& first,
    const index3& last
)
:
    origin_(origin),
    spacing_(spacing),
    first_(first),
    last_(last)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Eigen::Index Foam::acoustics::velocityLattice::size() const
{
    return Eigen::Index(size(0))*size(1)*size(2);
}


Eigen::Matrix3Xd Foam::acoustics::velocityLattice::nodes() const
{
    Eigen::Matrix3Xd x(3, size());
    Eigen::Index node = 0;

    for (int k = first_[2]; k <= last_[2]; ++k)
    {
        for (int j = first_[1]; j <= last_[1]; ++j)
        {
            for (int i = first_[0]; i <= last_[0]; ++i)
            {
                x.col(node++) = origin_ + spacing_*Eigen::Array3d(i, j, k);
            }
        }
    }

    return x;
}


double Foam::acoustics::velocityLattice::rmsGradient
(
    const values& nodeVelocity,
    const Eigen::Array3i& intervals
) const
{
    // A coarser lattice, with nodes at both ends of this one
    const Eigen::Array3d n(size(0) - 1, size(1) - 1, size(2) - 1);
    const Eigen::Array3i parts =
        (n/intervals.cast<double>()).round().max(1.0).cast<int>();

    const velocityLattice coarse
    (
        origin_ + spacing_*Eigen::Array3d(first_[0], first_[1], first_[2]),
        spacing_*n/parts.cast<double>(),
        {0, 0, 0},
        {parts[0], parts[1], parts[2]}
    );

    Eigen::Matrix3Xd u;
    interpolate(nodeVelocity, coarse.nodes(), u);

    const Eigen::Index row = coarse.size(0);
    const Eigen::Index next[3] = {1, row, row*coarse.size(1)};

    double sum = 0;

    for (int k = 0; k < parts[2]; ++k)
    {
        for (int j = 0; j < parts[1]; ++j)
        {
            for (int i = 0; i < parts[0]; ++i)
            {
                const Eigen::Index corner = i*next[0] + j*next[1] + k*next[2];

                for (int d = 0; d < 3; ++d)
                {
                    // The four edges in this direction
                    const Eigen::Index b = next[(d + 1) % 3];
                    const Eigen::Index c = next[(d + 2) % 3];

                    Eigen::Vector3d difference = Eigen::Vector3d::Zero();
                    for (const Eigen::Index edge : {0*b, b, c, b + c})
                    {
                        difference +=
                            u.col(corner + edge + next[d])
                          - u.col(corner + edge);
                    }

                    sum += (difference/(4*coarse.spacing_[d])).squaredNorm();
                }
            }
        }
    }

    return std::sqrt(sum/parts.cast<double>().prod());
}


void Foam::acoustics::velocityLattice::interpolate
(
    const values& nodeVelocity,
    const Eigen::Matrix3Xd& x,
    Eigen::Matrix3Xd& u
) const
{
    using velocity = Eigen::Array4d;

    // Copies, which the compiler knows to stay as they are
    const Eigen::Array3d origin = origin_;
    const Eigen::Array3d perSpacing = spacing_.inverse();
    const Eigen::Array3d low(first_[0], first_[1], first_[2]);
    const Eigen::Array3d high(last_[0] - 1, last_[1] - 1, last_[2] - 1);

    const Eigen::Index row = size(0);
    const Eigen::Index layer = row*size(1);

    u.resize(3, x.cols());

    for (Eigen::Index point = 0; point < x.cols(); ++point)
    {
        // Number of the node before the point, and distance from it
        double node[3];
        double w[3];

        for (int d = 0; d < 3; ++d)
        {
            const double s = (x(d, point) - origin[d])*perSpacing[d];

            node[d] = std::min(std::max(std::floor(s), low[d]), high[d]);
            w[d] = s - node[d];
        }

        const Eigen::Index corner =
            Eigen::Index(node[0] - low[0])
          + Eigen::Index(node[1] - low[1])*row
          + Eigen::Index(node[2] - low[2])*layer;

        const auto along = [&](const Eigen::Index at) -> velocity
        {
            const velocity a = nodeVelocity.col(at);
            const velocity b = nodeVelocity.col(at + 1);
            return a + w[0]*(b - a);
        };

        const velocity front0 = along(corner);
        const velocity back0 = along(corner + row);
        const velocity front1 = along(corner + layer);
        const velocity back1 = along(corner + layer + row);

        const velocity bottom = front0 + w[1]*(back0 - front0);
        const velocity top = front1 + w[1]*(back1 - front1);
        const velocity middle = bottom + w[2]*(top - bottom);

        u.col(point) = middle.head<3>().matrix();
    }
}


// ************************************************************************* //
