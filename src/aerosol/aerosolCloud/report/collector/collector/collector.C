/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "collector.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(collector, 0);
    defineRunTimeSelectionTable(collector, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::collector> Foam::aerosol::collector::New
(
    const dictionary& dict
)
{
    return selectModel<collector>
    (
        dict,
        "collector",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
