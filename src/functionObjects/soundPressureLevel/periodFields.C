/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodFields.H"

#include "cellField.H"
#include "volFields.H"
#include "writtenFiles.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::periodFields::periodFields
(
    const fvMesh& mesh,
    const word& maker
)
:
    mesh_(mesh),
    maker_(maker)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::regIOobject* Foam::functionObjects::periodFields::own
(
    const word& name
) const
{
    // The registry is asked each time: a sound that is replayed takes the names
    // of its terms for fields of its own, and gives them back
    auto* object = mesh_.getObjectPtr<regIOobject>(name);

    return
        object
     && object->ownedByRegistry()
     && object->note() == acoustics::cellFieldNote
      ? object
      : nullptr;
}


void Foam::functionObjects::periodFields::requireFree
(
    const word& name
) const
{
    const auto* other = mesh_.cfindObject<regIOobject>(name);

    if (other && (own(name) || other->note() != acoustics::cellFieldNote))
    {
        FatalErrorInFunction
            << "There is a field " << name << " already, of another function"
            << " object, such as fieldAverage or another soundPressureLevel:"
            << " the function object " << maker_ << " cannot make one"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::functionObjects::periodFields::keep
(
    const word& name,
    const dimensionSet& dimensions,
    const Field<Type>& inCells
)
{
    using fieldType = GeometricField<Type, fvPatchField, volMesh>;

    if (!names_.found(name))
    {
        requireFree(name);
        names_.append(name);
    }

    if (!mesh_.foundObject<regIOobject>(name))
    {
        auto* field = acoustics::cellField
        (
            name, mesh_, dimensions, inCells
        ).ptr();

        // Into the registry, where other function objects find it
        field->checkIn();
        field->store();
    }
    else if (own(name))
    {
        auto& field = mesh_.lookupObjectRef<fieldType>(name);
        field.primitiveFieldRef() = inCells;
        field.correctBoundaryConditions();
    }
}


void Foam::functionObjects::periodFields::write() const
{
    for (const word& name : names_)
    {
        if (auto* field = own(name))
        {
            field->write();
            requireWritten(mesh_.time().timePath()/name);
        }
    }
}


// * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * * //

template void Foam::functionObjects::periodFields::keep
(
    const word&, const dimensionSet&, const Field<scalar>&
);
template void Foam::functionObjects::periodFields::keep
(
    const word&, const dimensionSet&, const Field<vector>&
);


// ************************************************************************* //
