/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Brownian.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(Brownian, 0);
    defineRunTimeSelectionTable(Brownian, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::Brownian> Foam::aerosol::Brownian::New
(
    const dictionary& dict
)
{
    return selectModel<Brownian>
    (
        dict,
        "Brownian motion",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
