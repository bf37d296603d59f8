/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "communicator.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <algorithm>

// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

int Foam::aerosol::communicator::nRanks()
{
    return Pstream::parRun() ? Pstream::nProcs() : 1;
}


int Foam::aerosol::communicator::rank()
{
    return Pstream::parRun() ? Pstream::myProcNo() : 0;
}


Foam::aerosol::messages Foam::aerosol::communicator::exchange(messages send)
{
    if (send.size() == 1)
    {
        return send;
    }

    const label n = send.size();
    List<List<double>> out(n);
    List<List<double>> in;

    for (label rank = 0; rank < n; ++rank)
    {
        out[rank].resize(send[rank].size());
        std::copy(send[rank].begin(), send[rank].end(), out[rank].begin());
    }

    Pstream::exchange<List<double>, double>(out, in);

    for (label rank = 0; rank < n; ++rank)
    {
        send[rank].assign(in[rank].begin(), in[rank].end());
    }

    return send;
}


double Foam::aerosol::communicator::max(const double value)
{
    return -min(-value);
}


double Foam::aerosol::communicator::min(const double value)
{
    scalar all = value;

    if (nRanks() > 1)
    {
        reduce(all, minOp<scalar>());
    }

    return all;
}


double Foam::aerosol::communicator::sum(const double value)
{
    scalar all = value;

    if (nRanks() > 1)
    {
        reduce(all, sumOp<scalar>());
    }

    return all;
}


Eigen::Vector3d Foam::aerosol::communicator::mean
(
    Eigen::Vector3d total,
    const int n
)
{
    for (int k = 0; k < 3; ++k)
    {
        total(k) = sum(total(k));
    }

    return total/std::max(sum(n), 1.0);
}


// ************************************************************************* //
