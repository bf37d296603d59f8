/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    acousticDEMFoam

Group
    grpLagrangianSolvers

Description
    Acoustic agglomeration of aerosols: the gas is advanced one fluid step,
    solved on the mesh or by a formula; every particle feels the gas and its
    neighbours' wakes; particles that meet become one.

    The sound is described in constant/acousticProperties, the aerosol in
    constant/aerosolProperties. Without the latter there is sound only.

\*---------------------------------------------------------------------------*/

#include "aerosolClouds.H"
#include "checkedDictionary.H"
#include "argList.H"
#include "caseLock.H"
#include "checkTimes.H"
#include "columnFvMesh.H"
#include "functionObjectList.H"
#include "functionObject.H"
#include "fvMesh.H"
#include "mapPolyMesh.H"
#include "profiling.H"
#include "progressReport.H"
#include "restartableTime.H"
#include "runGuard.H"
#include "soundField.H"
#include "Time.H"
#include "timeSelector.H"
#include "versionLine.H"
#include "writtenFiles.H"

#include <csignal>
#include <malloc.h>

using namespace Foam;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- FatalIOError if steps are to be adjusted: nothing here would do that
void requireFixedStep(const Time& runTime)
{
    const dictionary& control = runTime.controlDict();

    if (valueOr<bool>(control, "adjustTimeStep", false))
    {
        FatalIOErrorInFunction(control.lookup("adjustTimeStep"))
            << "Entry 'adjustTimeStep' is on, but the fluid step is deltaT"
            << " throughout: a part of the period of the sound. Set"
            << " adjustTimeStep off, and deltaT"
            << exit(FatalIOError);
    }
}


//- Memory that is freed is soon asked for again: keep it. By default large
//  arrays go back to the system each time, and come as new pages.
void keepMemory()
{
    mallopt(M_MMAP_THRESHOLD, 1 << 28);
    mallopt(M_TRIM_THRESHOLD, 1 << 28);
    mallopt(M_TOP_PAD, 1 << 24);
}


//- Warn of times of another run that are later than the start of this one
void warnOfLaterTimes(const Time& runTime)
{
    // The times are those to be looked at
    if (functionObject::postProcess)
    {
        return;
    }

    const instantList times = runTime.times();
    const scalar next = runTime.value() + 0.5*runTime.deltaTValue();

    for (const instant& time : times)
    {
        if (time.name() != runTime.constant() && time.value() > next)
        {
            WarningInFunction
                << "The run starts at time " << runTime.timeName() << ", but"
                << " there are later times already, from " << time.name()
                << " to " << times.last().name() << ". Those that this run does"
                << " not write again are of another one: remove them, or they"
                << " will be taken for its results" << endl;
            return;
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Acoustic agglomeration of aerosols: sound and particles, coupled"
    );

    #define NO_CONTROL
    #include "postProcess.H"

    argList::addBoolOption
    (
        "dry-run",
        "Read and check the case, report, and end before the first step"
    );

    #include "setRootCase.H"

    Info<< versionLine() << nl << endl;

    runGuard::begin();
    keepMemory();

    // A limit of the size of files is an error like a full disk, no signal
    std::signal(SIGXFSZ, SIG_IGN);

    // Until the program ends, by exit as well
    static const autoPtr<caseLock> lock
    (
        args.found("dry-run") ? nullptr : new caseLock(args.globalPath())
    );

    runGuard::reading numbers;

    Info<< "Create time\n" << endl;
    restartableTime runTime(Time::controlDictName, args);

    numbers.end();
    checkTimes(runTime);
    requireFixedStep(runTime);

    #include "createRealMesh.H"
    #include "createFields.H"

    if (args.found("dry-run"))
    {
        Info<< "\nNo time step: this is a dry run\n\nEnd\n" << endl;

        return 0;
    }

    writing([&] { clouds.begin(); });

    requireWritten(runTime.timePath()/"lagrangian");
    requireWritten(runTime.timePath()/"uniform");

    Info<< "\nStarting time loop\n" << endl;

    const auto goesOn = [&]
    {
        const runGuard::activity what
        (
            "running the function objects of " + runTime.systemPath()
           /"controlDict"
        );

        return runTime.run();
    };

    while (goesOn())
    {
        requireFixedStep(runTime);

        // The state at the end is kept, whatever writeInterval is
        if
        (
            runTime.value() + 1.5*runTime.deltaTValue()
         >= runTime.endTime().value()
        )
        {
            runTime.writeOnce();
        }

        ++runTime;

        const runGuard::activity what(progress.activity());

        sound->advance();
        clouds.evolve();

        runTime.writeWhole();

        if (progress.due())
        {
            progress.print(clouds.progress());
        }
    }

    clouds.end();

    Info<< clouds.effort().c_str() << nl << "\nEnd\n" << endl;

    return 0;
}


// ************************************************************************* //
