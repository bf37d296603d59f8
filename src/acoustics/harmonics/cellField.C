/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellField.H"

#include "foamVersion.H"
#include "volFields.H"
#include "zeroGradientFvPatchFields.H"

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
