/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "LappleCollector.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(LappleCollector, 0);
    addToRunTimeSelectionTable(collector, LappleCollector, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::LappleCollector::LappleCollector(const dictionary& dict)
:
    d50_(readPositive(dict, "d50", dimLength))
{
    requireOnly(dict, {"type", "d50"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::aerosol::LappleCollector::efficiency(const double d) const
{
    const double ratio = d50_/d;

    return 1/(1 + ratio*ratio);
}


// ************************************************************************* //
