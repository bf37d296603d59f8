/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "slipCorrection.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(slipCorrection, 0);
    defineRunTimeSelectionTable(slipCorrection, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::slipCorrection>
Foam::aerosol::slipCorrection::New(const dictionary& dict)
{
    return selectModel<slipCorrection>
    (
        "slipCorrection",
        dict,
        "slip correction",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
