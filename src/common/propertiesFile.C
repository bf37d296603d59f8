/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "propertiesFile.H"

#include "OSspecific.H"
#include "polyMesh.H"
#include "runGuard.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::IOobject propertiesObject
(
    const Foam::word& name,
    const Foam::polyMesh& mesh
)
{
    return Foam::IOobject
    (
        name,
        mesh.time().constant(),
        mesh,
        Foam::IOobject::MUST_READ,
        Foam::IOobject::NO_WRITE,
        false
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::hasProperties(const word& name, const polyMesh& mesh)
{
    const IOobject io(propertiesObject(name, mesh));

    // As IOdictionary finds it
    if (!io.globalFilePath(IOdictionary::typeName).empty())
    {
        return true;
    }

    for (const fileName& root : {mesh.time().path(), mesh.time().globalPath()})
    {
        const fileName path(root/mesh.time().constant()/name);

        // The link itself, not what it leads to
        if (type(path, false) != fileName::UNDEFINED)
        {
            FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, path)
                << path << " is no file that can be read: it is "
                <<
                (
                    isDir(path) ? "a folder" : "a link to nowhere, or protected"
                )
                << exit(FatalIOError);
        }
    }

    return false;
}


Foam::IOdictionary Foam::readProperties
(
    const word& name,
    const polyMesh& mesh
)
{
    if (!hasProperties(name, mesh))
    {
        FatalErrorInFunction
            << "Cannot find the file "
            << mesh.time().globalPath()/mesh.time().constant()/name
            << exit(FatalError);
    }

    const runGuard::activity what
    (
        "reading " + mesh.time().constant()/name
    );
    const runGuard::reading numbers;

    return IOdictionary(propertiesObject(name, mesh));
}


// ************************************************************************* //
