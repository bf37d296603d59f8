/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "linearShear.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "eigenVector.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(linearShear, 0);
    addToRunTimeSelectionTable(soundField, linearShear, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::linearShear::linearShear(const dictionary& dict)
:
    analyticSound(0, dict),
    gradientDirection_
    (
        toEigen(readDirection(dict, "gradientDirection", vector(0, 1, 0)))
    ),
    origin_(toEigen(readVector(dict, "origin", dimLength, Zero))),
    velocity_(readFlow(dict)),
    velocityAmplitude_(0)
{
    requireOnly
    (
        dict,
        {"type", "shearRate", "flowDirection", "gradientDirection", "origin",
         "velocity", "gas"}
    );

    const Eigen::Vector3d flowDirection =
        toEigen(readDirection(dict, "flowDirection", vector(1, 0, 0)));

    if (std::abs(flowDirection.dot(gradientDirection_)) > 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "flowDirection and gradientDirection must be normal to each"
            << " other: the gas would be compressed for ever"
            << exit(FatalIOError);
    }

    shear_ = readFinite(dict, "shearRate", dimless/dimTime)*flowDirection;
}


Foam::acoustics::linearShear::linearShear
(
    const fvMesh&,
    const dictionary& dict
)
:
    linearShear(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::acoustics::linearShear::prepare(const boundBox& region)
{
    // The speed is convex: it is largest at a corner
    vectors corners(3, 8);

    for (int corner = 0; corner < 8; ++corner)
    {
        for (int i = 0; i < 3; ++i)
        {
            corners(i, corner) =
                (corner >> i) & 1 ? region.max()[i] : region.min()[i];
        }
    }

    vectors u;
    velocity(0, corners, u);
    u.colwise() -= velocity_;

    velocityAmplitude_ =
        std::max(velocityAmplitude_, u.colwise().norm().maxCoeff());

    return 0;
}


void Foam::acoustics::linearShear::velocity
(
    const scalar,
    const vectors& x,
    vectors& u
) const
{
    u = shear_*(gradientDirection_.transpose()*x);
    u.colwise() += velocity_ - shear_*gradientDirection_.dot(origin_);
}


// ************************************************************************* //
