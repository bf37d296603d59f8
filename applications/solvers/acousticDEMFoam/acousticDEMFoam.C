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
#include "argList.H"
#include "columnFvMesh.H"
#include "functionObjectList.H"
#include "fvMesh.H"
#include "mapPolyMesh.H"
#include "profiling.H"
#include "progressReport.H"
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

    clouds.begin();

    Info<< "\nStarting time loop\n" << endl;

    while (runTime.run())
    {
        ++runTime;

        sound->advance();
        clouds.evolve();

        runTime.write();

        if (progress.due())
        {
            progress.print(clouds.progress());
        }
    }

    Info<< clouds.effort().c_str() << nl << "\nEnd\n" << endl;

    return 0;
}


// ************************************************************************* //
