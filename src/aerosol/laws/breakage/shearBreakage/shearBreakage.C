/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "shearBreakage.H"
#include "addToRunTimeSelectionTable.H"

#include <Eigen/Eigenvalues>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(shearBreakage, 0);
    addToRunTimeSelectionTable(breakage, shearBreakage, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::shearBreakage::shearBreakage(const dictionary& dict)
:
    bond_(dict.subDict("bond"))
{
    requireOnly(dict, {"bond"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::shearBreakage::limit
(
    const particleArrays& p,
    const int i,
    const acoustics::gasProperties& gas
) const
{
    const scalar a = 0.5*p.mobilityDiameter(i);

    return bond_.strength(p, i)/(5*EIGEN_PI*gas.mu*a*a);
}


bool Foam::aerosol::shearBreakage::mayBreak
(
    const particleArrays& p,
    const int i,
    const surroundings& where,
    const acoustics::gasProperties& gas
) const
{
    // No rate of strain is larger
    return where.gradient.norm() > limit(p, i, gas);
}


bool Foam::aerosol::shearBreakage::breaks
(
    const particleArrays& p,
    const int i,
    const particleArrays&,
    const surroundings& where,
    const acoustics::gasProperties& gas,
    parting& apart
) const
{
    const Eigen::Matrix3d strain =
        0.5*(where.gradient + where.gradient.transpose());

    // In increasing order
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(strain);

    if (principal.eigenvalues()(2) <= limit(p, i, gas))
    {
        return false;
    }

    apart.direction = principal.eigenvectors().col(2);

    return true;
}


// ************************************************************************* //
