/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unsteadyDrag.H"
#include "noUnsteadyDrag.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(unsteadyDrag, 0);
    defineRunTimeSelectionTable(unsteadyDrag, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::unsteadyDrag> Foam::aerosol::unsteadyDrag::New
(
    const dictionary& laws,
    const scalar frequency
)
{
    if (!laws.found("unsteadyDrag"))
    {
        return autoPtr<unsteadyDrag>(new noUnsteadyDrag());
    }

    const dictionary& dict = laws.subDict("unsteadyDrag");

    return selectModel<unsteadyDrag>
    (
        dict,
        "unsteady drag",
        dictionaryConstructorTablePtr_,
        dict,
        frequency
    );
}


// ************************************************************************* //
