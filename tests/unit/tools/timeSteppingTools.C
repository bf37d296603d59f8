/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeSteppingTools.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
namespace testTools
{
    defineTypeNameAndDebug(recordedStick, 0);
    addToRunTimeSelectionTable(contactOutcome, recordedStick, dictionary);

    defineTypeNameAndDebug(neverStick, 0);
    addToRunTimeSelectionTable(contactOutcome, neverStick, dictionary);
}
}
}



// ************************************************************************* //
