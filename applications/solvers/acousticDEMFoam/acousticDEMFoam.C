/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Application
    acousticDEMFoam

Group
    grpLagrangianSolvers

Description
    Acoustic agglomeration of aerosols: the sound, solved on the mesh or given
    by a formula.

    The sound is described in constant/acousticProperties.

    One line is printed every `reportInterval` steps of system/controlDict
    (default 100) and at each time that is written.

\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "columnFvMesh.H"
#include "functionObjectList.H"
#include "fvMesh.H"
#include "mapPolyMesh.H"
#include "profiling.H"
#include "soundField.H"
#include "Time.H"
#include "timeSelector.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Acoustic agglomeration of aerosols: sound and particles, coupled"
    );

    #define NO_CONTROL
    #include "postProcess.H"

    #include "addCheckCaseOptions.H"
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createMesh.H"
    #include "createFields.H"

    const label reportInterval =
        runTime.controlDict().lookupOrDefault<label>("reportInterval", 100);

    Info<< "\nStarting time loop\n" << endl;

    while (runTime.run())
    {
        ++runTime;

        sound->advance();

        runTime.write();

        if (runTime.writeTime() || runTime.timeIndex() % reportInterval == 0)
        {
            Info<< "Time = " << runTime.timeName() << nl;
            runTime.printExecutionTime(Info);
        }
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
