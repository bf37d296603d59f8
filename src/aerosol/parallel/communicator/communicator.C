/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "communicator.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "UIPstream.H"
#include "UOPstream.H"
#include "vector2D.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

int Foam::aerosol::communicator::alone_ = 0;


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

int Foam::aerosol::communicator::nRanks()
{
    return Pstream::parRun() && !alone_ ? Pstream::nProcs() : 1;
}


int Foam::aerosol::communicator::rank()
{
    return Pstream::parRun() && !alone_ ? Pstream::myProcNo() : 0;
}


bool Foam::aerosol::communicator::worksAlone()
{
    return Pstream::parRun() && alone_;
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


Foam::aerosol::messages Foam::aerosol::communicator::exchange
(
    messages send,
    const std::vector<std::size_t>& lengths
)
{
    if (send.size() == 1)
    {
        return send;
    }

    const int n = static_cast<int>(send.size());
    const label firstRequest = Pstream::nRequests();
    messages received(n);

    for (int from = 0; from < n; ++from)
    {
        if (from != rank() && lengths[from])
        {
            std::vector<double>& message = received[from];
            message.resize(lengths[from]);

            UIPstream::read
            (
                Pstream::commsTypes::nonBlocking,
                from,
                reinterpret_cast<char*>(message.data()),
                message.size()*sizeof(double)
            );
        }
    }

    for (int to = 0; to < n; ++to)
    {
        const std::vector<double>& message = send[to];

        if (to != rank() && !message.empty())
        {
            UOPstream::write
            (
                Pstream::commsTypes::nonBlocking,
                to,
                reinterpret_cast<const char*>(message.data()),
                message.size()*sizeof(double)
            );
        }
    }

    received[rank()] = std::move(send[rank()]);
    Pstream::waitRequests(firstRequest);

    return received;
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
    const Eigen::Vector3d& total,
    const int n
)
{
    // OpenFOAM reduces two numbers at once
    vector2D first(total(0), total(1));
    vector2D last(total(2), n);

    if (nRanks() > 1)
    {
        reduce(first, sumOp<vector2D>());
        reduce(last, sumOp<vector2D>());
    }

    return
        Eigen::Vector3d(first.x(), first.y(), last.x())
       /std::max(last.y(), 1.0);
}


// ************************************************************************* //
