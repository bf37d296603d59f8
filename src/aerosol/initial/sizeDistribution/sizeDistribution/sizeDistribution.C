/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "sizeDistribution.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(sizeDistribution, 0);
    defineRunTimeSelectionTable(sizeDistribution, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::sizeDistribution>
Foam::aerosol::sizeDistribution::New
(
    const dictionary& dict
)
{
    return selectModel<sizeDistribution>
    (
        dict,
        "size distribution",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
