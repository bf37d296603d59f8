/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "replay.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "checkedEntry.H"
#include "gasEntries.H"
#include "fvMesh.H"
#include "localIOdictionary.H"
#include "OSspecific.H"
#include "stateDictionary.H"
#include "Time.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(replay, 0);
    addToRunTimeSelectionTable(soundField, replay, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A file in a time directory
Foam::IOobject object
(
    const Foam::word& name,
    const Foam::word& time,
    const Foam::fileName& local,
    const Foam::polyMesh& mesh
)
{
    return Foam::IOobject
    (
        name,
        time,
        local,
        mesh,
        Foam::IOobject::MUST_READ,
        Foam::IOobject::NO_WRITE,
        false
    );
}


//- Whether every rank has it
bool found(Foam::IOobject io)
{
    return Foam::returnReduce
    (
        io.typeHeaderOk<Foam::localIOdictionary>(false, false),
        Foam::andOp<bool>()
    );
}


//- A dictionary that a sound has left, empty if it has not
Foam::dictionary left
(
    const Foam::word& name,
    const Foam::word& time,
    const Foam::polyMesh& mesh,
    const Foam::wordList& entries
)
{
    using namespace Foam;

    const IOobject io(object(name, time, "uniform", mesh));

    if (!found(io))
    {
        if (!fileHandler().filePath(io.objectPath()).empty())
        {
            FatalErrorInFunction
                << "The file " << io.objectPath() << ", which says what is"
                << " replayed, is not whole" << exit(FatalError);
        }

        return dictionary();
    }

    const localIOdictionary dict(io, "dictionary");
    stateDictionary::require(dict, entries);

    return dictionary(dict);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::replay::chamber::chamber
(
    const fvMesh& here,
    const dictionary& dict
)
:
    mesh(&here),
    frequency(0)
{
    requireOnly(dict, {"type", "source", "time", "frequency", "gas"});

    if (dict.found("source"))
    {
        requireValue(dict, "source");
        fileName source(dict.get<fileName>("source"));
        source.expand();

        // Relative to the case, not to where the solver was started
        fileName path
        (
            source.isAbsolute() ? source : here.time().globalPath()/source
        );
        if (!path.isAbsolute())
        {
            path = cwd()/path;
        }
        path.clean();

        fileName root = path.path();
        word caseName = path.name();

        if (Pstream::parRun())
        {
            root = path;
            caseName = "processor" + std::to_string(Pstream::myProcNo());
        }

        // Where OpenFOAM's file handler keeps it, collated or not
        const bool hasMesh = returnReduce
        (
            !fileHandler().filePath
            (
                root/caseName/"constant"/polyMesh::meshSubDir
            ).empty(),
            andOp<bool>()
        );

        if (!hasMesh && !Pstream::parRun())
        {
            FatalIOErrorInFunction(dict)
                << "The source " << path << " of the replay has no mesh in"
                << " constant/polyMesh" << exit(FatalIOError);
        }

        if (Pstream::parRun())
        {
            const label parts = fileHandler().nProcs(path);

            if (!hasMesh || parts != Pstream::nProcs())
            {
                FatalIOErrorInFunction(dict)
                    << "The source " << path << " of the replay has " << parts
                    << " parts with a mesh (processor0, ... or processors"
                    << Pstream::nProcs() << "): decompose it into "
                    << Pstream::nProcs() << ", as this case, by decomposePar"
                    << " -latestTime there" << exit(FatalIOError);
            }
        }

        // Of its controlDict nothing is wanted
        dictionary controlDict;
        controlDict.add("deltaT", 1);
        controlDict.add("endTime", 1);
        controlDict.add("writeInterval", 1);

        ownTime.reset
        (
            new Time
            (
                controlDict,
                root,
                caseName,
                "system",
                "constant",
                false,
                false
            )
        );
        ownMesh.reset
        (
            new polyMesh
            (
                IOobject
                (
                    polyMesh::defaultRegion,
                    ownTime->constant(),
                    *ownTime,
                    IOobject::MUST_READ
                )
            )
        );
        mesh = ownMesh.get();
    }

    time = findTime(dict);

    // What else is known about the sound

    dictionary replayed = left
    (
        "replay", time, *mesh, {"frequency", "harmonics", "gas"}
    );

    if (replayed.empty())
    {
        replayed = left
        (
            "harmonics", time, *mesh, {"frequency", "harmonics"}
        );
    }

    nHarmonics = replayed.getOrDefault<label>("harmonics", -1);
    magnitudes = replayed.subOrEmptyDict("magnitudes");
    quality = replayQuality::read(replayed);

    if (replayed.found("frequency"))
    {
        frequency = readPositive(replayed, "frequency", dimless/dimTime);
    }

    if (dict.found("frequency"))
    {
        const scalar given = readPositive(dict, "frequency", dimless/dimTime);

        if (frequency > 0 && mag(given - frequency) > 1e-6*frequency)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'frequency' of " << dict.name() << " is " << given
                << ", but the sound that is replayed was solved at "
                << frequency << " Hz, by its file in "
                << mesh->time().path()/time/"uniform" << exit(FatalIOError);
        }

        frequency = given;
    }
    else if (frequency == 0)
    {
        FatalIOErrorInFunction(dict)
            << "Give the frequency of the sound that is replayed: there is"
            << " neither uniform/replay nor uniform/harmonics in "
            << mesh->time().path()/time << exit(FatalIOError);
    }

    const dictionary known =
        dict.found("gas") ? dict.subDict("gas")
      : replayed.found("gas") ? replayed.subDict("gas")
      : left("undisturbedGas", time, *mesh, gasNames());

    if (known.empty() && !dict.found("gas"))
    {
        WarningInFunction
            << "The gas of the sound that is replayed is not known: air of"
            << " 20 C is taken. Give 'gas' in line " << dict.startLineNumber()
            << " of " << dict.name() << " if it is another" << endl;
    }

    gas = gasProperties::read(known);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::acoustics::replay::chamber::findTime
(
    const dictionary& dict
) const
{
    const fileName& path = mesh->time().path();

    // Those that have the field of the mean
    wordList times;
    scalarList values;

    for (const instant& i : fileHandler().findTimes(path, "constant"))
    {
        if
        (
            i.name() != "constant"
         && found(object(harmonicFlow::name(0), i.name(), "", *mesh))
        )
        {
            times.append(i.name());
            values.append(i.value());
        }
    }

    bool latest = true;

    if (dict.found("time"))
    {
        requireValue(dict, "time");
        const ITstream& is = dict.lookup("time");

        latest =
            is.size() == 1 && is[0].isWord()
         && is[0].wordToken() == "latestTime";
    }

    if (times.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No time directory of " << path << " has a field "
            << harmonicFlow::name(0) << " to be replayed. " << nl
            << harmonicFlow::origin << exit(FatalIOError);
    }

    if (latest)
    {
        return times.last();
    }

    const scalar wanted = readFinite(dict, "time", dimTime);

    forAll(times, i)
    {
        if (mag(values[i] - wanted) <= 1e-9*mag(wanted))
        {
            return times[i];
        }
    }

    FatalIOErrorInFunction(dict)
        << "Entry 'time' of " << dict.name() << " is " << wanted
        << ", but no time directory of " << path << " of that time has a field "
        << harmonicFlow::name(0) << "; those that have are " << times
        << " (or latestTime)" << exit(FatalIOError);

    return word();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::replay::replay(std::unique_ptr<const chamber>&& chamber)
:
    soundField(chamber->frequency),
    chamber_(std::move(chamber)),
    flow_
    (
        *chamber_->mesh,
        chamber_->frequency,
        harmonicFlow::read
        (
            *chamber_->mesh,
            chamber_->time,
            chamber_->nHarmonics
        )
    ),
    largestAmplitude_(flow_.largestAmplitude())
{
    Info<< "    replayed from " << chamber_->mesh->time().path()
        << ", time " << chamber_->time << ": " << frequency() << " Hz, "
        << flow_.nHarmonics() << " harmonics with the fundamental, up to "
        << largestAmplitude_ << " m/s, on a mean flow of at most "
        << flow_.largestMean() << " m/s" << endl;

    harmonicFlow::requireSame
    (
        *chamber_->mesh, flow_.inCells(), chamber_->magnitudes
    );
    chamber_->quality.report();
}


Foam::acoustics::replay::replay(const fvMesh& mesh, const dictionary& dict)
:
    replay(std::unique_ptr<const chamber>(new chamber(mesh, dict)))
{}


Foam::acoustics::replay::~replay() = default;


// ************************************************************************* //
