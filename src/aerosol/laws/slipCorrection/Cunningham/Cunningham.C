/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "Cunningham.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(Cunningham, 0);
    addToRunTimeSelectionTable(slipCorrection, Cunningham, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::Cunningham::Cunningham(const dictionary&)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::Cunningham::factor
(
    const scalars& d,
    const gasProperties& gas
) const
{
    const scalars Kn = 2*gas.meanFreePath/d;

    return 1 + Kn*(1.257 + 0.4*(-1.1/Kn).exp());
}


// ************************************************************************* //
