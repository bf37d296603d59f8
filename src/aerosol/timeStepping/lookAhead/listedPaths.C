/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "listedPaths.H"
#include "scalar.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The mean of the inverse distance [1/m] on a straight line from r0 to r1
double meanInverse(const Eigen::Vector3d& r0, const Eigen::Vector3d& r1)
{
    const Eigen::Vector3d chord = r1 - r0;
    const double length = chord.norm();

    if (length < 1e-3*r0.norm())
    {
        return 1/r0.norm();
    }

    const double begin = r0.dot(chord)/length;
    const double b = std::max
    (
        std::sqrt(std::max(0.0, r0.squaredNorm() - begin*begin)), 1e-3*length
    );

    // The difference of two areas of the hyperbola
    const double end = begin + length;
    const double sum0 = begin + std::sqrt(begin*begin + b*b);
    const double sum1 = end + std::sqrt(end*end + b*b);

    return std::log(sum1/std::max(sum0, 1e-12*sum1))/length;
}


//- Square of the closest distance of two points that move from xi0 to xi1 and
//  from xj0 to xj1
double closestSqr
(
    const double* const xi0,
    const double* const xi1,
    const double* const xj0,
    const double* const xj1
)
{
    double rr = 0, rc = 0, cc = 0;

    for (int k = 0; k < 3; ++k)
    {
        const double r = xi0[k] - xj0[k];
        const double c = xi1[k] - xj1[k] - r;

        rr += r*r;
        rc += r*c;
        cc += c*c;
    }

    const double s = std::min(1.0, std::max(0.0, -rc/(cc + Foam::VSMALL)));

    // Where they meet, rounding may leave less than nothing
    return std::max(0.0, rr + s*(2*rc + s*cc));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::listedPaths::listedPaths
(
    const neighbourList& list,
    const vectors& start,
    const std::vector<vectors>& ends,
    const scalars& furthest,
    const scalars& bulge,
    const int every
)
:
    list_(list),
    n_(static_cast<int>(start.cols())),
    steps_(every*static_cast<int>((ends.size() + 1)/2)),
    ghostX_(ends.size() + 1),
    bulge_(bulge),
    furthest_(furthest)
{
    own_.push_back(&start);

    for (const vectors& x : ends)
    {
        own_.push_back(&x);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::ghosts::filling Foam::aerosol::listedPaths::filling()
{
    const ghosts& layer = list_.layer();
    std::vector<ghosts::quantity> quantities
    {
        {furthest_, layer}, {bulge_, layer}
    };

    x_.clear();

    for (std::size_t k = 0; k < own_.size(); ++k)
    {
        x_.push_back(own_[k]->data());
        quantities.push_back({*own_[k], ghostX_[k], layer, true});
    }

    return {&layer, quantities};
}



double Foam::aerosol::listedPaths::closest(const particlePair& pair) const
{
    double least = GREAT;

    for (std::size_t k = 0; k + 1 < x_.size(); ++k)
    {
        least = std::min
        (
            least,
            closestSqr
            (
                x(k, pair.i), x(k + 1, pair.i),
                x(k, pair.j), x(k + 1, pair.j)
            )
        );
    }

    return std::max
    (
        0.0, std::sqrt(least) - bulge_(pair.i) - bulge_(pair.j)
    );
}


double
Foam::aerosol::listedPaths::meanInverse(const particlePair& pair) const
{
    using vector = Eigen::Map<const Eigen::Vector3d>;

    double sum = 0;

    for (std::size_t k = 0; k + 1 < x_.size(); ++k)
    {
        sum += ::meanInverse
        (
            vector(x(k, pair.i)) - vector(x(k, pair.j)),
            vector(x(k + 1, pair.i)) - vector(x(k + 1, pair.j))
        );
    }

    return sum/(x_.size() - 1);
}


// ************************************************************************* //
