/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stick.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(stick, 0);
    addToRunTimeSelectionTable(contactOutcome, stick, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::stick::stick(const dictionary& dict)
{
    requireOnly(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::aerosol::stick::sticks
(
    const particleArrays&,
    const encounter&
) const
{
    return true;
}


// ************************************************************************* //
