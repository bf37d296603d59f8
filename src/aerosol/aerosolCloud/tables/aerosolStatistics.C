/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aerosolStatistics.H"

#include <algorithm>
#include <cmath>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::aerosol::scalars;

//- exp of the standard deviation of ln d
double geometricStandardDeviation(const scalars& d)
{
    const Eigen::Index n = d.size();

    if (n < 2)
    {
        return 1;
    }

    const scalars lnD = d.unaryExpr([](double di) { return std::log(di); });

    return std::exp(std::sqrt((lnD - lnD.mean()).square().sum()/(n - 1)));
}


//- The bin of a diameter, between the edges, below or above them
Eigen::Index binOf(const double d, const scalars& edges)
{
    const double* begin = edges.data();

    return std::upper_bound(begin, begin + edges.size(), d) - begin;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::aerosolStatistics::aerosolStatistics
(
    const particleArrays& particles
)
:
    size(particles.size())
{
    if (!size)
    {
        return;
    }

    const scalars& d = particles.d;

    sizePM25 = (d <= PM25).count();
    GSD = geometricStandardDeviation(d);
    mass = particles.m.sum();
    momentum = particles.v*particles.m.matrix();

    std::vector<int> bySize(size);
    std::iota(bySize.begin(), bySize.end(), 0);
    std::sort
    (
        bySize.begin(),
        bySize.end(),
        [&d](int i, int j) { return d(i) < d(j); }
    );

    largestDiameter = d(bySize.back());
    countMedianDiameter = 0.5*(d(bySize[(size - 1)/2]) + d(bySize[size/2]));

    double massSoFar = 0;

    for (const int i : bySize)
    {
        massSoFar += particles.m(i);
        massMedianDiameter = d(i);

        if (massSoFar >= 0.5*mass)
        {
            break;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::aerosolStatistics::logarithmicBins
(
    const double min,
    const double max,
    const int n
)
{
    scalars edges(n + 1);

    for (int k = 0; k < n; ++k)
    {
        edges(k) = min*std::pow(max/min, double(k)/n);
    }
    edges(n) = max;

    return edges;
}


Foam::aerosol::integers Foam::aerosol::aerosolStatistics::histogram
(
    const scalars& d,
    const scalars& edges
)
{
    integers counts = integers::Zero(edges.size() + 1);

    for (const double di : d)
    {
        ++counts(binOf(di, edges));
    }

    return counts;
}


Foam::aerosol::scalars Foam::aerosol::aerosolStatistics::histogram
(
    const scalars& d,
    const scalars& edges,
    const scalars& share
)
{
    scalars sums = scalars::Zero(edges.size() + 1);

    for (Eigen::Index i = 0; i < d.size(); ++i)
    {
        sums(binOf(d(i), edges)) += share(i);
    }

    return sums;
}


// ************************************************************************* //
