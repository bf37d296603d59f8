/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "domain.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(domain, 0);
    defineRunTimeSelectionTable(domain, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::domain> Foam::aerosol::domain::New
(
    const dictionary& dict
)
{
    return selectModel<domain>
    (
        dict,
        "domain",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
