/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "replay.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "fvMesh.H"
#include "localIOdictionary.H"
#include "OSspecific.H"
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

//- A dictionary that a sound has left, empty if it has not
Foam::dictionary left
(
    const Foam::word& name,
    const Foam::word& time,
    const Foam::polyMesh& mesh
)
{
    using namespace Foam;

    const IOobject io
    (
        name,
        time,
        "uniform",
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    );

    return
        isFile(io.objectPath())
      ? dictionary(localIOdictionary(io, "dictionary"))
      : dictionary();
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

        fileName caseName = path.name();
        if (Pstream::parRun())
        {
            caseName =
                caseName/("processor" + std::to_string(Pstream::myProcNo()));
        }

        bool found = isDir(path.path()/caseName/"constant"/"polyMesh");
        reduce(found, andOp<bool>());
        if (!found)
        {
            FatalIOErrorInFunction(dict)
                << "The source " << path << " of the replay has no mesh"
                << (Pstream::parRun()
                  ? " in one of processor0, processor1, ...: decompose it into"
                    " as many parts as this case"
                  : " in constant/polyMesh")
                << exit(FatalIOError);
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
                path.path(),
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

    // Where the fields are

    const fileName& root = mesh->time().path();

    if (dict.found("time") && dict.get<word>("time") != "latestTime")
    {
        const scalar wanted = readFinite(dict, "time", dimTime);
        time = Time::timeName(wanted, 12);
        for (const instant& i : Time::findTimes(root))
        {
            if (mag(i.value() - wanted) < 1e-9*max(mag(wanted), SMALL))
            {
                time = i.name();
            }
        }
    }
    else
    {
        time = "constant";
        for (const instant& i : Time::findTimes(root))
        {
            if (isFile(root/i.name()/harmonicFlow::name(0)))
            {
                time = i.name();
            }
        }
    }

    // What else is known about the sound

    const dictionary replayed = left("replay", time, *mesh);

    if (dict.found("frequency"))
    {
        frequency = readPositive(dict, "frequency", dimless/dimTime);

        if
        (
            replayed.found("frequency")
         && mag(replayed.get<scalar>("frequency") - frequency)
          > 1e-5*frequency
        )
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'frequency' of " << dict.name() << " is "
                << frequency << " Hz, but the sound that is replayed was solved"
                << " at " << replayed.get<scalar>("frequency") << " Hz"
                << exit(FatalIOError);
        }
    }
    else if (replayed.found("frequency"))
    {
        frequency = readPositive(replayed, "frequency", dimless/dimTime);
    }
    else
    {
        FatalIOErrorInFunction(dict)
            << "Give the frequency of the sound that is replayed: there is no"
            << " uniform/replay in " << root/time << exit(FatalIOError);
    }

    const dictionary known =
        dict.found("gas") ? dict.subDict("gas")
      : replayed.found("gas") ? replayed.subDict("gas")
      : left("undisturbedGas", time, *mesh);

    if (known.empty() && !dict.found("gas"))
    {
        WarningInFunction
            << "The gas of the sound that is replayed is not known: air of"
            << " 20 C is taken. Give 'gas' in line " << dict.startLineNumber()
            << " of " << dict.name() << " if it is another" << endl;
    }

    gas = gasProperties::read(known);
}


Foam::acoustics::replay::replay(std::unique_ptr<const chamber>&& chamber)
:
    soundField(chamber->frequency),
    chamber_(std::move(chamber)),
    flow_
    (
        *chamber_->mesh,
        chamber_->frequency,
        harmonicFlow::read(*chamber_->mesh, chamber_->time)
    ),
    largestAmplitude_(flow_.largestAmplitude())
{
    Info<< "    replayed from " << chamber_->mesh->time().path()
        << ", time " << chamber_->time << ": " << frequency() << " Hz, "
        << flow_.nHarmonics() << " harmonics with the fundamental, up to "
        << largestAmplitude_ << " m/s, on a mean flow of at most "
        << flow_.largestMean() << " m/s" << endl;
}


Foam::acoustics::replay::replay(const fvMesh& mesh, const dictionary& dict)
:
    replay(std::unique_ptr<const chamber>(new chamber(mesh, dict)))
{}


Foam::acoustics::replay::~replay() = default;


// ************************************************************************* //
