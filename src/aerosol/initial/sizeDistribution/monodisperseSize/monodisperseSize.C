/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "monodisperseSize.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(monodisperseSize, 0);
    addToRunTimeSelectionTable(sizeDistribution, monodisperseSize, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::monodisperseSize::monodisperseSize(const dictionary& dict)
:
    diameter_(readPositive(dict, "diameter", dimLength))
{
    requireOnly(dict, {"type", "diameter"});
}


// ************************************************************************* //
