/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "restartableTime.H"

#include "argList.H"
#include "foamVersion.H"
#include "IOdictionary.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "writtenFiles.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::scalar Foam::restartableTime::nameTolerance = 0.1;


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

const Foam::word& Foam::restartableTime::requireSameLatest
(
    const word& controlDict,
    const argList& args
)
{
    scalar latest = -GREAT;
    word name;

    for (const instant& time : Time::findTimes(args.path()))
    {
        if (time.name() != "constant" && time.value() > latest)
        {
            latest = time.value();
            name = time.name();
        }
    }

    const scalar last = returnReduce(latest, maxOp<scalar>());

    if (returnReduce(latest == last, andOp<bool>()))
    {
        return controlDict;
    }

    // A rank that has it says whether it was being written. All ranks ask: some
    // file handlers let the master look.
    const fileName folder = args.path()/name;
    const bool marked = fileHandler().isFile(folder/"uniform"/"incomplete");
    const label files =
        fileHandler().readDir(folder, fileName::FILE).size()
      + fileHandler().readDir(folder/"uniform", fileName::FILE).size();

    const bool torn = returnReduce
    (
        latest == last && (marked || !files),
        orOp<bool>()
    );

    if (torn)
    {
        // The digits of names are not read yet
        wordList names(Pstream::nProcs());
        names[Pstream::myProcNo()] = latest == last ? name : word::null;
        gatherToAll(names);
        stableSort(names);

        const dictionary control
        (
            fileHandler().NewIFstream
            (
                args.globalPath()/"system"/controlDict
            )()
        );

        if
        (
            control.getOrDefault<word>("startFrom", "latestTime")
         == "latestTime"
        )
        {
            refuse(last, args.globalPath()/"processor*"/names.last());
        }
    }

    return controlDict;
}


void Foam::restartableTime::refuse(const scalar time, const fileName& folders)
{
    FatalErrorInFunction
        << "The run was interrupted while it wrote the time " << time
        << ": its files are not whole. To go on from the time before it,"
        << " remove " << folders.c_str()
        << exit(FatalError);
}


Foam::fileName Foam::restartableTime::onAllRanks(const Time& time)
{
    if (!time.processorCase())
    {
        return time.timePath();
    }

    // Collated files of all ranks are in one folder
    const fileName collated =
        time.globalPath()/("processors" + Foam::name(Pstream::nProcs()))
       /time.timeName();

    return
        isDir(collated)
      ? collated
      : time.globalPath()/"processor*"/time.timeName();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::restartableTime::mark() const
{
    // Where the file handler writes
    return fileHandler().objectPath
    (
        IOobject("incomplete", timeName(), "uniform", *this),
        word::null
    );
}


void Foam::restartableTime::requireWhole() const
{
    const bool marked = returnReduce
    (
        !fileHandler().filePath(timePath()/"uniform"/"incomplete").empty(),
        orOp<bool>()
    );

    // Killed before there was a mark. A folder that a user has made may be
    // empty, too, but comes first.
    bool first = true;
    for (const instant& time : times())
    {
        if (time.name() != constant() && time.value() < value() - SMALL)
        {
            first = false;
        }
    }

    // Without a folder the time has another name
    bool exists = false;
    label files = 0;
    for (const fileName& path : {timePath(), timePath()/"uniform"})
    {
        const fileName folder = fileHandler().filePath(path);

        exists = exists || !folder.empty();
        files += fileHandler().readDir(folder, fileName::FILE).size();
    }
    reduce(exists, orOp<bool>());
    reduce(files, sumOp<label>());

    if (marked || (exists && !first && !files))
    {
        refuse(value(), onAllRanks(*this));
    }
}


void Foam::restartableTime::findFolder()
{
    if
    (
        returnReduce
        (
            !fileHandler().filePath(timePath()).empty(),
            orOp<bool>()
        )
    )
    {
        return;
    }

    // OpenFOAM tries more digits than timePrecision, but not always as many as
    // the name has
    const scalar step = deltaTValue();
    const instantList times = this->times();
    const label i = findClosestTimeIndex(times, value(), constant());

    if (i < 0 || mag(times[i].value() - value()) > nameTolerance*step)
    {
        return;
    }

    // With the index of the step, but not with its length
    setTime(times[i], timeIndex());
    deltaT_ = step;
    startTimeIndex_ = timeIndex();
}


void Foam::restartableTime::restoreValue()
{
    const IOdictionary written
    (
        IOobject
        (
            "time",
            timeName(),
            "uniform",
            *this,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );

    // Some file handlers let the master look: all ranks ask
    const fileName file =
        fileHandler().filePath(timePath()/"uniform"/"time");

    // The master reads it for all ranks, some of which may have no such file
    const bool empty = Pstream::master() && !file.empty() && written.empty();

    if (returnReduce(empty, orOp<bool>()))
    {
        refuse(value(), onAllRanks(*this));
    }

    if (timeToUserTime(value()) != value())
    {
        return;
    }

    const scalar exact = written.getOrDefault<scalar>("value", value());
    const scalar step = written.getOrDefault<scalar>("deltaT", deltaTValue());

    // Of a folder that was renamed, or copied, the name counts. The step is
    // written with few digits.
    if (mag(exact - value()) < 1.01*nameTolerance*step)
    {
        value() = exact;
    }
}


void Foam::restartableTime::nameTime()
{
    const scalar exact = timeToUserTime(value());

    precision_ = controlDict().getOrDefault("timePrecision", 6);

    while
    (
        precision_ < maxPrecision_
     && mag(instant(word(timeName(exact))).value() - exact)
      > nameTolerance*deltaTValue()
    )
    {
        ++precision_;
    }

    setTime(value(), timeIndex());
}


void Foam::restartableTime::purge()
{
    if (!purgeWrite_)
    {
        return;
    }

    if (previousWriteTimes_.empty() || previousWriteTimes_.top() != timeName())
    {
        previousWriteTimes_.push(timeName());
    }

    while (previousWriteTimes_.size() > purgeWrite_)
    {
        fileHandler().rmDir
        (
            fileHandler().filePath
            (
                objectRegistry::path(previousWriteTimes_.pop())
            )
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::restartableTime::restartableTime
(
    const word& controlDict,
    const argList& args
)
:
    Time(requireSameLatest(controlDict, args), args)
{
    findFolder();
    requireWhole();
    restoreValue();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::Time& Foam::restartableTime::operator++()
{
    // OpenFOAM adds digits whenever a name differs from the time by more than
    // the last digit, for the rest of the run, and says so. It has nothing to
    // add to all digits.
    precision_ = maxPrecision_;
    Time::operator++();
    nameTime();

    return *this;
}


void Foam::restartableTime::writeWhole()
{
    if (!writeTime())
    {
        return;
    }

    const fileName mark = this->mark();

    fileHandler().mkDir(mark.path());
    fileHandler().NewOFstream(mark)()
        << "While this file is here, the others of this time are not whole."
        << nl;

    // No rank begins before all have their mark, or removes it before all have
    // written
    bool ok = returnReduce(true, andOp<bool>());

    // Not to purge while the mark is there
    const label purgeWrite = purgeWrite_;
    purgeWrite_ = 0;
    writing([&] { ok = write(); });
    purgeWrite_ = purgeWrite;

    fileHandler().flush();
    requireWritten(timePath());

    if (!returnReduce(ok, andOp<bool>()))
    {
        FatalErrorInFunction
            << "Cannot write all of " << timePath() << ": is the disk full?"
            << exit(FatalError);
    }

    fileHandler().rm(mark);
    purge();
}


// ************************************************************************* //
