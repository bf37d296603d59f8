/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gravity.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(gravity, 0);
    defineRunTimeSelectionTable(gravity, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::gravity> Foam::aerosol::gravity::New
(
    const dictionary& dict
)
{
    return selectModel<gravity>
    (
        dict,
        "gravity model",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
