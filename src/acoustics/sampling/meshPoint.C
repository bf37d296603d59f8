/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshPoint.H"
#include "boundBox.H"
#include "eigenVector.H"
#include "fvMesh.H"
#include "regionSampler.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::meshPoint::meshPoint
(
    const fvMesh& mesh,
    const point& position
)
:
    position_(position),
    sampler_(new regionSampler(mesh, boundBox(position, position)))
{}


Foam::acoustics::meshPoint::meshPoint(meshPoint&&) = default;


Foam::acoustics::meshPoint::~meshPoint() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::acoustics::meshPoint::interpolate
(
    const vectorField& inCells
) const
{
    velocityLattice::values atNodes;
    sampler_->sample(inCells, atNodes);

    const Eigen::Matrix3Xd x = toEigen(position_);
    Eigen::Matrix3Xd value;
    sampler_->lattice().interpolate(atNodes, x, value);

    return toFoam(value.col(0));
}


// ************************************************************************* //
