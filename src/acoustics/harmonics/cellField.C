/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellField.H"

#include "foamVersion.H"
#include "regionSampler.H"
#include "volFields.H"
#include "zeroGradientFvPatchFields.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const char* const Foam::acoustics::cellFieldNote = "acousticDEM";


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::tmp<Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>>
Foam::acoustics::cellField
(
    const word& name,
    const fvMesh& mesh,
    const dimensionSet& dimensions,
    const Field<Type>& inCells
)
{
    auto field = tmp<GeometricField<Type, fvPatchField, volMesh>>::New
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::NO_WRITE,
            false
        ),
        mesh,
        dimensioned<Type>(dimensions, Zero),
        zeroGradientFvPatchField<Type>::typeName
    );

    field.ref().note() = cellFieldNote;
    field.ref().primitiveFieldRef() = inCells;
    field.ref().correctBoundaryConditions();

    return field;
}


Foam::scalar Foam::acoustics::peak(const vector& a, const vector& b)
{
    const scalar mean = 0.5*(magSqr(a) + magSqr(b));
    const scalar difference = 0.5*(magSqr(a) - magSqr(b));

    return std::sqrt(mean + std::hypot(difference, a & b));
}


Foam::scalar Foam::acoustics::phaseOf(const scalar a, const scalar b)
{
    return std::atan2(a, b);
}


Foam::acoustics::largestValue::largestValue
(
    const fvMesh& mesh,
    const scalarField& inCells
)
:
    value(-VGREAT),
    place(Zero),
    processor(-1),
    cell(-1)
{
    forAll(inCells, celli)
    {
        if (inCells[celli] > value)
        {
            value = inCells[celli];
            cell = celli;
        }
    }

    scalarField values(Pstream::nProcs(), -VGREAT);
    pointField places(Pstream::nProcs(), Zero);
    values[Pstream::myProcNo()] = value;
    if (cell >= 0)
    {
        places[Pstream::myProcNo()] = mesh.cellCentres()[cell];
    }
    gatherToAll(values);
    gatherToAll(places);

    processor = findMax(values);
    value = values[processor];
    place = places[processor];
    if (processor != Pstream::myProcNo())
    {
        cell = -1;
    }
}


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


Foam::vector Foam::acoustics::meshPoint::interpolate
(
    const vectorField& inCells
) const
{
    velocityLattice::values atNodes;
    sampler_->sample(inCells, atNodes);

    const Eigen::Matrix3Xd x =
        Eigen::Vector3d(position_.x(), position_.y(), position_.z());
    Eigen::Matrix3Xd value;
    sampler_->lattice().interpolate(atNodes, x, value);

    return vector(value(0, 0), value(1, 0), value(2, 0));
}


// * * * * * * * * * * * * * * Instantiations  * * * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    template tmp<volScalarField> cellField
    (
        const word&, const fvMesh&, const dimensionSet&, const Field<scalar>&
    );
    template tmp<volVectorField> cellField
    (
        const word&, const fvMesh&, const dimensionSet&, const Field<vector>&
    );
}
}


// ************************************************************************* //
