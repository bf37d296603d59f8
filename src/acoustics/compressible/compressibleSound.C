/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "compressibleSound.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "checkedEntry.H"
#include "evaluateOrRefuse.H"
#include "compressibleCheck.H"
#include "externalForce.H"
#include "fvMesh.H"
#include "surfaceInterpolate.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(compressibleSound, 0);
    addToRunTimeSelectionTable(soundField, compressibleSound, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::psiThermo& Foam::acoustics::compressibleSound::internalEnergy()
{
    if (thermo_->he().name() != "e")
    {
        FatalIOErrorInFunction(*thermo_)
            << "The sound is solved for the internal energy; this thermoType"
            << " is for '" << thermo_->he().name() << "'." << nl
            << "The enthalpy form amplifies sound (0.9 % per period with two"
            << " outer correctors)." << nl
            << "Set `energy sensibleInternalEnergy;` in thermoType"
            << exit(FatalIOError);
    }

    return *thermo_;
}


void Foam::acoustics::compressibleSound::requireAllLevels() const
{
    const wordList names({"phi", "phi_0", "rho_0", "U_0", "p_0", "T_0"});

    label found = 0;
    for (const word& name : names)
    {
        IOobject io
        (
            name,
            mesh_.time().timeName(),
            mesh_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );

        found += io.typeHeaderOk<volScalarField>(false, true, false);
    }
    reduce(found, sumOp<label>());

    if (found != 0 && found != names.size()*Pstream::nProcs())
    {
        FatalErrorInFunction
            << "Of the fields " << names << " in time "
            << mesh_.time().timeName() << ", with which the sound compressible"
            << " goes on as if it had not been interrupted, some are missing or"
            << " not whole. Go on from an earlier time; or remove all of them,"
            << " and the sound begins anew from p, T and U"
            << exit(FatalError);
    }
}


void Foam::acoustics::compressibleSound::keepOldLevels()
{
    // OpenFOAM writes the old level of a field that has two, and reads what it
    // finds. The energy's old level follows from that of T.
    U_.oldTime().oldTime();
    p_.oldTime().oldTime();
    thermo_->T().oldTime().oldTime();
    rho_.oldTime().oldTime();
    phi_.oldTime().oldTime();

    K_.oldTime() == 0.5*magSqr(U_.oldTime());
    K_.oldTime().oldTime();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::compressibleSound::compressibleSound
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    meshSound(mesh, dict),
    logSolvers_(valueOr<bool>(dict, "logSolvers", false)),
    // It marks the last corrector in the mesh, hence not const
    pimple_(const_cast<fvMesh&>(mesh), "PIMPLE", false),
    p_(internalEnergy().p()),
    e_(thermo_->he()),
    psi_(thermo_->psi()),
    phi_
    (
        stored("phi", mesh, IOobject::READ_IF_PRESENT),
        linearInterpolate(rho_*U_) & mesh.Sf()
    ),
    turbulence_
    (
        compressible::turbulenceModel::New(rho_, U_, phi_, *thermo_)
    ),
    K_("K", 0.5*magSqr(U_)),
    fvOptions_(fv::options::New(mesh))
{
    requireOnly
    (
        dict,
        {"type", "frequency", "SPL", "velocityAmplitude", "logSolvers",
         "control"}
    );

    if (continued())
    {
        requireAllLevels();
    }

    mesh.setFluxRequired(p_.name());
    turbulence_->validate();
    keepOldLevels();

    // Copies: a restart keeps the values that it has read. Not those that wait
    // for the gradient that the pressure equation gives to them.
    const wordList waiting
    ({
        "fixedFluxPressure", "fixedFluxExtrapolatedPressure"
    });

    const auto tryOut = [&](const auto& field)
    {
        for (const auto& condition : field.boundaryField())
        {
            if (!condition.coupled() && !waiting.found(condition.type()))
            {
                evaluateOrRefuse(condition.clone().ref(), "compressible");
            }
        }
    };

    tryOut(p_);
    tryOut(thermo_->T());
    tryOut(U_);

    if (!logSolvers_)
    {
        solverPerformance::debug = 0;
        SolverPerformance<vector>::debug = 0;
    }

    compressibleCheck
    (
        mesh,
        frequency(),
        gas().c,
        {
            "ddt(" + rho_.name() + ',' + U_.name() + ')',
            "ddt(" + rho_.name() + ')',
            "ddt(" + psi_.name() + ',' + p_.name() + ')',
            "ddt(" + rho_.name() + ',' + e_.name() + ')',
            "ddt(" + rho_.name() + ",K)"
        },
        pimple_.nCorrPIMPLE()
    ).report();
}


Foam::acoustics::compressibleSound::~compressibleSound() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::acoustics::compressibleSound::feelsForces()
{
    force_.reset(new externalForce(mesh_));

    return true;
}


void Foam::acoustics::compressibleSound::step()
{
    solveContinuity();

    while (loop())
    {
        const tmp<fvVectorMatrix> UEqn = solveMomentum();

        solveEnergy();

        while (pimple_.correct())
        {
            correctPressure(UEqn());
        }

        if (pimple_.turbCorr())
        {
            turbulence_->correct();
        }
    }

    rho_ = thermo_->rho();

    if (force_)
    {
        force_->finish(U_);
    }
}


// ************************************************************************* //
