/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudTables.H"

#include "aerosolStatistics.H"
#include "checkedEntry.H"
#include "functionObject.H"
#include "fvMesh.H"
#include "Switch.H"
#include "Time.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::cloudTables::cloudTables
(
    const dictionary& dict,
    const fvMesh& mesh,
    const scalar frequency
)
:
    mesh_(mesh),
    dict_(dict),
    contacts_(dict.getOrDefault<Switch>("contacts", false)),
    breakages_(dict.getOrDefault<Switch>("breakages", false)),
    interval_
    (
        readPositive
        (
            dict,
            "interval",
            dimTime,
            frequency > 0 ? 1/frequency : 100*mesh.time().deltaTValue()
        )
    ),
    nextRow_(0),
    lastRow_(-VGREAT),
    initialNumber_(0),
    initialNumberPM25_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::cloudTables::start(const particleArrays& particles)
{
    const aerosolStatistics initial(particles);

    initialNumber_ = initial.size;
    initialNumberPM25_ = initial.sizePM25;
    sizeBins_ = agglomerationTables::sizeBins(dict_, particles.d);
}


void Foam::aerosol::cloudTables::save(dictionary& state) const
{
    state.add("initialNumber", initialNumber_);
    state.add("initialNumberPM25", initialNumberPM25_);
    state.add("sizeBins", sizeBins_);
}


void Foam::aerosol::cloudTables::load(const dictionary& state)
{
    initialNumber_ = state.get<label>("initialNumber");
    initialNumberPM25_ = state.get<label>("initialNumberPM25");
    sizeBins_ = state.subDict("sizeBins");
}


void Foam::aerosol::cloudTables::open
(
    const word& cloudName,
    const bool isNew
)
{
    const Time& time = mesh_.time();

    const tableFolder folder
    (
        time.globalPath()/functionObject::outputPrefix/cloudName,
        time.value(),
        1e-6*time.deltaTValue() + 1e-15*mag(time.value()),
        isNew
    );

    files_.reset
    (
        new agglomerationTables(folder, sizeBins_, contacts_, breakages_)
    );
}


bool Foam::aerosol::cloudTables::due(const bool last) const
{
    const Time& time = mesh_.time();

    return
        time.timeIndex() == time.startTimeIndex()
     || time.writeTime()
     || last
     || time.value() > nextRow_ - 0.5*time.deltaTValue();
}


void Foam::aerosol::cloudTables::add
(
    const particleArrays& all,
    const scalar volume,
    const std::int64_t contacts,
    const bool last
)
{
    const Time& time = mesh_.time();
    const scalar now = time.value();

    files_->writeRow
    (
        now,
        aerosolStatistics(all),
        initialNumber_,
        initialNumberPM25_,
        volume,
        contacts
    );

    lastRow_ = now;

    // Rows at whole intervals, also after a restart
    const scalar reached = now + 0.5*time.deltaTValue();
    nextRow_ = interval_*(std::floor(reached/interval_ + 1e-6) + 1);

    if
    (
        time.timeIndex() == time.startTimeIndex()
     || time.writeTime()
     || last
    )
    {
        files_->writeSizes(now, all);
    }
}


void Foam::aerosol::cloudTables::add
(
    const std::vector<collisions::record>& contacts,
    const std::vector<fragmentation::record>& breakages
)
{
    files_->writeContacts(contacts);
    files_->writeBreakages(breakages);
}


// ************************************************************************* //
