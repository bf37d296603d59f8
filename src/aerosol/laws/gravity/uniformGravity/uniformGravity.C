/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "uniformGravity.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "eigenVector.H"
#include "vector.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(uniformGravity, 0);
    addToRunTimeSelectionTable(gravity, uniformGravity, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::uniformGravity::uniformGravity(const dictionary& dict)
{
    requireOnly(dict, {"type", "value"});

    g_ = toEigen(getVector(dict, "value", dimAcceleration));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::vectors Foam::aerosol::uniformGravity::acceleration
(
    const particleArrays& p,
    const acoustics::gasProperties& gas
) const
{
    const scalars displaced = gas.rho*EIGEN_PI/6*p.d.cube();

    return g_*(1 - displaced/p.m).matrix().transpose();
}


// ************************************************************************* //
