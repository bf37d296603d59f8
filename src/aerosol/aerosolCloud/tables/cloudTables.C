/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudTables.H"

#include "aerosolStatistics.H"
#include "checkedDictionary.H"
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
    initialNumberPM25_(0),
    quantities_(dict),
    withCost_(valueOr<Switch>(dict, "cost", true))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::aerosol::cloudTables::entries()
{
    wordList names({"interval", "sizeBins", "contacts", "breakages", "cost"});

    names.append(aerosolQuantities::entries());

    return names;
}


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
        new agglomerationTables
        (
            folder,
            sizeBins_,
            contacts_,
            breakages_,
            quantities_.wanted("distributions")
        )
    );

    std::vector<std::string> columns({"time_s"});
    for (const std::string& column : quantities_.names())
    {
        columns.push_back(column);
    }
    if (columns.size() > 1)
    {
        quantitiesFile_ = folder.states("quantities", columns);
    }

    if (withCost_)
    {
        cost_.open(folder);
    }
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
    const stepCounters& done,
    const bool last
)
{
    const Time& time = mesh_.time();
    const scalar now = time.value();

    if (withCost_ && time.timeIndex() != time.startTimeIndex())
    {
        cost_.write(now, done);
    }

    const costTable::watch watch(cost_, costTable::tables);

    files_->writeRow
    (
        now,
        aerosolStatistics(all),
        initialNumber_,
        initialNumberPM25_,
        volume,
        contacts
    );

    if (quantitiesFile_)
    {
        tableFile& row = *quantitiesFile_;

        row << now;
        for (const auto& quantity : quantities_.of(all, volume))
        {
            row << quantity.second;
        }
        row.endRow();
        row.flush();
    }

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
        files_->writeSizes(now, all, volume);
    }
}


void Foam::aerosol::cloudTables::add
(
    const std::vector<collisions::record>& contacts,
    const std::vector<fragmentation::record>& breakages
)
{
    const costTable::watch watch(cost_, costTable::tables);

    files_->writeContacts(contacts);
    files_->writeBreakages(breakages);
}


// ************************************************************************* //
