/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "OseenDrag.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(OseenDrag, 0);
    addToRunTimeSelectionTable(drag, OseenDrag, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::OseenDrag::OseenDrag(const dictionary& dict)
:
    StokesDrag(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::OseenDrag::factor
(
    const scalars& Re
) const
{
    return 1 + 3.0/16.0*Re;
}


// ************************************************************************* //
