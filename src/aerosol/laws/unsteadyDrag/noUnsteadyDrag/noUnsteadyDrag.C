/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noUnsteadyDrag.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(noUnsteadyDrag, 0);
    addToRunTimeSelectionTable(unsteadyDrag, noUnsteadyDrag, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::noUnsteadyDrag::noUnsteadyDrag
(
    const dictionary& dict,
    const scalar
)
{
    requireOnly(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::noUnsteadyDrag::begin
(
    const scalar,
    const vectors& U0,
    const vectors&,
    const acoustics::gasProperties&,
    const int,
    particleArrays&,
    vectors& p,
    scalars& q
) const
{
    p.setZero(3, U0.cols());
    q.setZero(U0.cols());
}


// ************************************************************************* //
