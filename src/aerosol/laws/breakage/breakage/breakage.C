/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "breakage.H"
#include "checkedEntry.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(breakage, 0);
    defineRunTimeSelectionTable(breakage, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::aerosol::breakage::requireOnly
(
    const dictionary& dict,
    const wordList& own
)
{
    wordList valid({"type", "fragments", "share"});
    valid.append(own);

    Foam::requireOnly(dict, valid);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::breakage> Foam::aerosol::breakage::New
(
    const dictionary& dict
)
{
    return selectModel<breakage>
    (
        dict,
        "breakage",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
