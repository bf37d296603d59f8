/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "drag.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(drag, 0);
    defineRunTimeSelectionTable(drag, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::drag> Foam::aerosol::drag::New
(
    const dictionary& dict
)
{
    return selectModel<drag>
    (
        dict,
        "drag law",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
