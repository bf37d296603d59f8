/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gasReaction.H"

#include "fvMesh.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::IOobject stored(const Foam::word& name, const Foam::fvMesh& mesh)
{
    return Foam::IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        Foam::IOobject::READ_IF_PRESENT,
        Foam::IOobject::AUTO_WRITE
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::gasReaction::gasReaction
(
    const fvMesh& mesh,
    acoustics::soundField& sound
)
:
    force_
    (
        stored("aerosolForce", mesh),
        mesh,
        dimensionedVector(dimForce/dimVolume, Zero)
    ),
    inertia_
    (
        stored("aerosolInertia", mesh),
        mesh,
        dimensionedScalar(dimDensity, Zero)
    ),
    continued_(force_.headerOk())
{
    if (!sound.feelsForces())
    {
        FatalErrorInFunction
            << "The particles are to act on the gas (coupling, type twoWay, in"
            << " constant/aerosolProperties), but the sound of type "
            << sound.type() << " is not changed by forces. Use a sound that is"
            << " solved, such as 'compressible', or coupling of type none"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::gasReaction::settle()
{
    force_.primitiveFieldRef() *= -1;
    inertia_.primitiveFieldRef() = Zero;
}


void Foam::aerosol::gasReaction::add(const Eigen::MatrixXd& densities)
{
    vectorField& force = force_.primitiveFieldRef();
    scalarField& inertia = inertia_.primitiveFieldRef();
    const scalar h = force_.time().deltaTValue();

    forAll(force, celli)
    {
        for (direction k = 0; k < vector::nComponents; ++k)
        {
            force[celli][k] += densities(k, celli)/h;
        }

        inertia[celli] += densities(3, celli);
    }
}


// ************************************************************************* //
