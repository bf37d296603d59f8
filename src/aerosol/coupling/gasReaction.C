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


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::aerosol::gasReaction::requireAllOrNone()
{
    label found = force_.headerOk() + inertia_.headerOk() + debt_.headerOk();
    reduce(found, sumOp<label>());

    if (found != 0 && found != 3*Pstream::nProcs())
    {
        FatalErrorInFunction
            << "Of the fields " << force_.name() << ", " << inertia_.name()
            << " and " << debt_.name() << " in time "
            << force_.time().timeName() << ", by which the particles go on"
            << " acting on the gas, some are missing or not whole. Go on from"
            << " an earlier time"
            << exit(FatalError);
    }

    return found;
}


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
    debt_
    (
        stored("aerosolDebt", mesh),
        mesh,
        dimensionedVector(dimDensity*dimVelocity, Zero)
    ),
    continued_(requireAllOrNone())
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

void Foam::aerosol::gasReaction::begin()
{
    debt_.primitiveFieldRef() -=
        debt_.time().deltaTValue()*force_.primitiveField();

    force_.primitiveFieldRef() = Zero;
    inertia_.primitiveFieldRef() = Zero;
}


void Foam::aerosol::gasReaction::add(const Eigen::MatrixXd& impulse)
{
    vectorField& debt = debt_.primitiveFieldRef();

    forAll(debt, celli)
    {
        debt[celli] += vector
        (
            impulse(0, celli),
            impulse(1, celli),
            impulse(2, celli)
        );
    }
}


void Foam::aerosol::gasReaction::announce
(
    const Eigen::MatrixXd& impulseAndInertia
)
{
    vectorField& force = force_.primitiveFieldRef();
    scalarField& inertia = inertia_.primitiveFieldRef();
    const scalar h = force_.time().deltaTValue();

    forAll(force, celli)
    {
        const auto amounts = impulseAndInertia.col(celli);

        force[celli] += vector(amounts(0), amounts(1), amounts(2))/h;
        inertia[celli] += amounts(3);
    }
}


void Foam::aerosol::gasReaction::end()
{
    force_.primitiveFieldRef() +=
        debt_.primitiveField()/debt_.time().deltaTValue();

    // For faces between ranks
    force_.correctBoundaryConditions();
    inertia_.correctBoundaryConditions();
}


// ************************************************************************* //
