/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "replayComparison.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::replayComparison::replayComparison(const scalar end)
:
    end_(end),
    n_(0),
    squares_(0),
    largest_(0)
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::replayComparison::amplitude
(
    const scalar t,
    const scalar frequency,
    const harmonicFlow& replay,
    const size_t nRegions
)
{
    scalar amplitude = 0;

    for (size_t region = 0; region < nRegions; ++region)
    {
        for (label i = 0; i < 24; ++i)
        {
            amplitude = max
            (
                amplitude,
                std::sqrt
                (
                    replay.atNodes(region, t + i/(24*frequency))
                   .topRows<3>().matrix().colwise().squaredNorm().maxCoeff()
                )
            );
        }
    }
    reduce(amplitude, maxOp<scalar>());

    return nRegions ? amplitude : replay.largestAmplitude();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::replayComparison::add
(
    const scalar t,
    const vectorField& solved,
    const harmonicFlow& replay,
    const size_t nRegions
)
{
    scalar n = 0;
    scalar squares = 0;
    scalar largest = 0;

    const auto add = [&](const scalar differenceSqr)
    {
        n += 1;
        squares += differenceSqr;
        largest = max(largest, std::sqrt(differenceSqr));
    };

    for (size_t region = 0; region < nRegions; ++region)
    {
        velocityLattice::values atNodes;
        replay.sampler(region).sample(solved, atNodes);

        const velocityLattice::values difference =
            atNodes - replay.atNodes(region, t);

        for (Eigen::Index node = 0; node < difference.cols(); ++node)
        {
            add(difference.col(node).head<3>().matrix().squaredNorm());
        }
    }

    if (!nRegions)
    {
        const vectorField difference(solved - replay.inCells(t));
        for (const vector& d : difference)
        {
            add(magSqr(d));
        }
    }

    reduce(n, sumOp<scalar>());
    reduce(squares, sumOp<scalar>());
    reduce(largest, maxOp<scalar>());

    n_ += n;
    squares_ += squares;
    largest_ = max(largest_, largest);
}


Foam::scalar Foam::acoustics::replayComparison::rms() const
{
    return std::sqrt(squares_/n_);
}


// ************************************************************************* //
