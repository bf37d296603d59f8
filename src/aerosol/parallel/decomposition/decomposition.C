/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "decomposition.H"
#include "domain.H"
#include "eigenVector.H"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Three numbers with product n, for subdomains of the smallest surface
std::array<int, 3> split(const int n, const Eigen::Array3d& span)
{
    std::array<int, 3> best{n, 1, 1};
    double least = std::numeric_limits<double>::max();

    for (int i = 1; i <= n; ++i)
    {
        for (int j = 1; n % i == 0 && j <= n/i; ++j)
        {
            if (n/i % j == 0)
            {
                const Eigen::Array3d edge = span/Eigen::Array3d(i, j, n/i/j);
                const double surface =
                    edge(0)*edge(1) + edge(1)*edge(2) + edge(2)*edge(0);

                if (surface < least*(1 - 1e-9))
                {
                    least = surface;
                    best = {i, j, n/i/j};
                }
            }
        }
    }

    return best;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::decomposition::decomposition
(
    const domain& region,
    const int n
)
:
    origin_(toEigen(region.bounds().min())),
    span_(toEigen(region.bounds().span())),
    n_(split(n, span_))
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::aerosol::particleArrays
Foam::aerosol::decomposition::gather(particleArrays own)
{
    const int length = own.packedNumbers();

    if (communicator::nRanks() == 1)
    {
        // Without the memory for messages
        std::vector<int> order(own.size());
        std::iota(order.begin(), order.end(), 0);
        std::sort
        (
            order.begin(),
            order.end(),
            [&](const int a, const int b) { return own.id(a) < own.id(b); }
        );

        own.reorder(order);

        return own;
    }

    if (!own.refreshed())
    {
        own.resizeLaws();
        own.rate.setZero();
        own.response.setZero();
        own.acceleration.setZero();
        own.range.setZero();
        own.mobilityDiameter.setZero();
        own.collisionDiameter.setZero();
    }

    std::vector<double> mine(own.size()*length);
    for (int i = 0; i < own.size(); ++i)
    {
        own.pack(i, mine.data() + i*length);
    }

    const messages all =
        communicator::exchange(messages(communicator::nRanks(), mine));

    std::vector<const double*> one;
    for (const std::vector<double>& part : all)
    {
        for (std::size_t i = 0; i < part.size(); i += length)
        {
            one.push_back(part.data() + i);
        }
    }

    // The first number is the id
    std::sort
    (
        one.begin(),
        one.end(),
        [](const double* a, const double* b)
        {
            return *a < *b;
        }
    );

    particleArrays gathered;
    gathered.resizeHistory(own.history.rows());
    gathered.resize(static_cast<int>(one.size()));
    gathered.resizeLaws();

    for (std::size_t i = 0; i < one.size(); ++i)
    {
        gathered.unpack(static_cast<int>(i), one[i]);
    }

    return gathered;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::aerosol::decomposition::rankOf(const Eigen::Vector3d& x) const
{
    int rank = 0;

    for (int k = 0; k < 3; ++k)
    {
        const int c =
            static_cast<int>(std::floor((x(k) - origin_(k))/span_(k)*n_[k]));

        rank = rank*n_[k] + std::min(std::max(c, 0), n_[k] - 1);
    }

    return rank;
}


Eigen::Array3d Foam::aerosol::decomposition::lower(const int rank) const
{
    const Eigen::Array3d place
    (
        rank/(n_[1]*n_[2]),
        rank/n_[2] % n_[1],
        rank % n_[2]
    );

    return origin_ + place*span_/Eigen::Array3d(n_[0], n_[1], n_[2]);
}


Eigen::Array3d Foam::aerosol::decomposition::upper(const int rank) const
{
    return lower(rank) + span_/Eigen::Array3d(n_[0], n_[1], n_[2]);
}


void Foam::aerosol::decomposition::keepOwn(particleArrays& p) const
{
    if (communicator::nRanks() == 1)
    {
        return;
    }

    std::vector<char> others(p.size());

    for (int i = 0; i < p.size(); ++i)
    {
        others[i] = rankOf(p.x.col(i)) != communicator::rank();
    }

    p.remove(others);
}


void Foam::aerosol::decomposition::migrate(particleArrays& p) const
{
    if (communicator::nRanks() == 1)
    {
        return;
    }

    const int length = p.packedNumbers();

    messages send(communicator::nRanks());
    std::vector<char> left(p.size(), 0);
    int nLeft = 0;

    for (int i = 0; i < p.size(); ++i)
    {
        const int rank = rankOf(p.x.col(i));

        if (rank != communicator::rank())
        {
            std::vector<double>& numbers = send[rank];
            numbers.resize(numbers.size() + length);
            p.pack(i, numbers.data() + numbers.size() - length);
            left[i] = 1;
            ++nLeft;
        }
    }

    const messages received = communicator::exchange(std::move(send));

    int n = p.size() - nLeft;
    for (const std::vector<double>& part : received)
    {
        n += part.size()/length;
    }

    if (!nLeft && n == p.size())
    {
        return;
    }

    particleArrays stay;
    stay.resizeHistory(p.history.rows());
    stay.resize(n);
    stay.resizeLaws();

    std::vector<double> numbers(length);
    int to = 0;

    for (int i = 0; i < p.size(); ++i)
    {
        if (!left[i])
        {
            p.pack(i, numbers.data());
            stay.unpack(to++, numbers.data());
        }
    }

    for (const std::vector<double>& part : received)
    {
        for (std::size_t i = 0; i < part.size(); i += length)
        {
            stay.unpack(to++, part.data() + i);
        }
    }

    p = std::move(stay);
}


// ************************************************************************* //
