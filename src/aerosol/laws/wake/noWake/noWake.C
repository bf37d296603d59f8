/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noWake.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(noWake, 0);
    addToRunTimeSelectionTable(wake, noWake, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::noWake::noWake(const dictionary&)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::noWake::range
(
    const scalars& d,
    const scalars&
) const
{
    return scalars::Zero(d.size());
}


void Foam::aerosol::noWake::evaluate
(
    block& pairs,
    const acoustics::gasProperties&
) const
{
    for (blockScalars& component : pairs.velocity)
    {
        component.setZero();
    }
}


// ************************************************************************* //
