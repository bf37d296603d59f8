/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "externalForce.H"

#include "fvcDdt.H"
#include "fvmDdt.H"
#include "fvMatrices.H"
#include "fvmSup.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::acoustics::externalForce::update(const volVectorField& U)
{
    impulse_ =
        impulse_.oldTime()
      + mesh_.time().deltaT()
       *mesh_.lookupObject<volVectorField>("aerosolForce")
      - inertia()*(U - U.oldTime());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::externalForce::externalForce(const fvMesh& mesh)
:
    mesh_(mesh),
    impulse_
    (
        IOobject
        (
            "aerosolImpulse",
            mesh.time().timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh,
        dimensionedVector(dimDensity*dimVelocity, Zero)
    )
{
    // As for the other fields with a rate of change
    impulse_.oldTime().oldTime();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::volScalarField& Foam::acoustics::externalForce::inertia() const
{
    return mesh_.lookupObject<volScalarField>("aerosolInertia");
}


Foam::tmp<Foam::fvVectorMatrix> Foam::acoustics::externalForce::force
(
    volVectorField& U
)
{
    update(U);

    // What U changes from now on, by the same scheme
    return
        fvm::Su(fvc::ddt(impulse_) + inertia()*fvc::ddt(U), U)
      - inertia()*fvm::ddt(U);
}


Foam::tmp<Foam::volScalarField> Foam::acoustics::externalForce::power
(
    const volVectorField& U
)
{
    update(U);

    return fvc::ddt(impulse_) & U;
}


void Foam::acoustics::externalForce::finish(const volVectorField& U)
{
    update(U);

    mesh_.lookupObjectRef<volVectorField>("aerosolForce").primitiveFieldRef() =
        (impulse_.primitiveField() - impulse_.oldTime().primitiveField())
       /mesh_.time().deltaTValue();
}


// ************************************************************************* //
