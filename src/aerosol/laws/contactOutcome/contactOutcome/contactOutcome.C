/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contactOutcome.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(contactOutcome, 0);
    defineRunTimeSelectionTable(contactOutcome, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::contactOutcome> Foam::aerosol::contactOutcome::New
(
    const dictionary& dict
)
{
    return selectModel<contactOutcome>
    (
        dict,
        "contact outcome",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
