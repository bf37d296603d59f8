/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noTurbulence.H"

#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(noTurbulence, 0);
    addToRunTimeSelectionTable(turbulence, noTurbulence, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::noTurbulence::noTurbulence
(
    const dictionary&,
    const domain&,
    acoustics::soundField&
)
{}

// ************************************************************************* //
