/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "turbulence.H"

#include "noTurbulence.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(turbulence, 0);
    defineRunTimeSelectionTable(turbulence, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::turbulence> Foam::aerosol::turbulence::New
(
    const dictionary& dict,
    const domain& region,
    acoustics::soundField& sound
)
{
    if (dict.empty())
    {
        return autoPtr<turbulence>(new noTurbulence(dict, region, sound));
    }

    return selectModel<turbulence>
    (
        dict,
        "turbulence model",
        dictionaryConstructorTablePtr_,
        dict,
        region,
        sound
    );
}

// ************************************************************************* //
