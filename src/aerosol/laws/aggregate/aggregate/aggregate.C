/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aggregate.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(aggregate, 0);
    defineRunTimeSelectionTable(aggregate, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::aggregate> Foam::aerosol::aggregate::New
(
    const dictionary& dict
)
{
    return selectModel<aggregate>
    (
        dict,
        "aggregate model",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
