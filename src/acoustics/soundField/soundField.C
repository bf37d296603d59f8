/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundField.H"

#include "airProperties.H"
#include "describe.H"
#include "fvMesh.H"
#include "checkedDictionary.H"
#include "propertiesFile.H"
#include "runGuard.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(soundField, 0);
    defineRunTimeSelectionTable(soundField, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::soundField::soundField(const scalar frequency)
:
    frequency_(frequency)
{}


Foam::autoPtr<Foam::acoustics::soundField> Foam::acoustics::soundField::New
(
    const fvMesh& mesh
)
{
    const IOdictionary properties
    (
        readProperties("acousticProperties", mesh)
    );
    requireDictionaries(properties, {"sound"});

    const runGuard::activity what
    (
        "making the sound of constant/acousticProperties"
    );

    const dictionary& dict = properties.subDict("sound");

    Info<< "Sound: " << describe(dict).c_str() << endl;

    // What the sounds say about themselves is for people, whatever
    // writePrecision is
    const int precision = Sout.precision(6);

    autoPtr<soundField> sound
    (
        selectModel<soundField>
        (
            dict,
            "sound",
            dictionaryConstructorTablePtr_,
            mesh,
            dict
        )
    );

    Info<< "Gas: " << sound->gas() << nl << endl;

    Sout.precision(precision);

    return sound;
}


// ************************************************************************* //
