/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "restartableTime.H"

#include "argList.H"
#include "IOdictionary.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include "writtenFiles.H"

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
            refuse(last, args.globalPath()/"processor*"/Time::timeName(last));
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
    const fileName all =
        time.processorCase() ? time.globalPath()/"processor*" : time.path();

    return all/time.timeName();
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

    const scalar exact =
        timeToUserTime(value()) == value()
      ? written.getOrDefault<scalar>("value", value())
      : value();

    // Of a folder that was renamed, or copied, the name counts
    if (exact != value() && timeName(exact) == timeName())
    {
        setTime(exact, timeIndex());
    }
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
    requireWhole();
    restoreValue();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

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
