/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "costTable.H"

#include "communicator.H"
#include "memInfo.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::costTable::costTable()
:
    written_(clock::now())
{
    seconds_.fill(0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::costTable::open(const tableFolder& folder)
{
    file_ = folder.events
    (
        "cost",
        {
            "time_s", "wall_s", "gas_s", "particles_s", "coupling_s",
            "breakages_s", "tables_s", "fluidSteps", "particleSteps",
            "particleMoves", "wakePairs", "contactPairs", "collisionPairs",
            "clusterParticles", "clusterMoves", "lists", "memory_MB"
        }
    );
}


void Foam::aerosol::costTable::write
(
    const double time,
    const stepCounters& done
)
{
    const clock::time_point now = clock::now();

    // All ranks take the same steps
    const auto since = [&](double stepCounters::*count)
    {
        return done.*count - counted_.*count;
    };
    const auto ofAll = [&](double stepCounters::*count)
    {
        return communicator::sum(since(count));
    };

    const std::array<double, 6> sums
    {
        ofAll(&stepCounters::particleMoves),
        ofAll(&stepCounters::wakePairs),
        ofAll(&stepCounters::contactPairs),
        ofAll(&stepCounters::collisionPairs),
        ofAll(&stepCounters::clusterMembers),
        ofAll(&stepCounters::clusterMoves)
    };
    const double memory = communicator::sum(1.024e-3*memInfo().rss());

    if (file_)
    {
        tableFile& row = *file_;

        row << time
            << std::chrono::duration<double>(now - written_).count();
        for (const double part : seconds_)
        {
            row << part;
        }
        row << since(&stepCounters::fluidSteps)
            << since(&stepCounters::particleSteps);
        for (const double sum : sums)
        {
            row << sum;
        }
        row << since(&stepCounters::lists) << memory;

        row.endRow();
        row.flush();
    }

    written_ = now;
    counted_ = done;
    seconds_.fill(0);
}


// ************************************************************************* //
