/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "compressibleSound.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "fvMesh.H"
#include "levelControl.H"
#include "mathematicalConstants.H"
#include "numericsCheck.H"
#include "regionSampler.H"
#include "soundLevel.H"
#include "surfaceInterpolate.H"
#include "thermodynamicConstants.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(compressibleSound, 0);
    addToRunTimeSelectionTable(soundField, compressibleSound, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A field that a restart finds again
Foam::IOobject stored
(
    const Foam::word& name,
    const Foam::fvMesh& mesh,
    const Foam::IOobject::readOption read
)
{
    return Foam::IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        read,
        Foam::IOobject::AUTO_WRITE
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::autoPtr<Foam::psiThermo> Foam::acoustics::compressibleSound::makeThermo
(
    const fvMesh& mesh
)
{
    autoPtr<psiThermo> thermo(psiThermo::New(mesh));

    if (thermo->he().name() != "e")
    {
        FatalIOErrorInFunction(*thermo)
            << "The sound is solved for the internal energy; this thermoType"
            << " is for '" << thermo->he().name() << "'." << nl
            << "The enthalpy form amplifies sound (0.9 % per period with two"
            << " outer correctors)." << nl
            << "Set `energy sensibleInternalEnergy;` in thermoType"
            << exit(FatalIOError);
    }

    return thermo;
}


Foam::acoustics::gasProperties
Foam::acoustics::compressibleSound::undisturbedGas()
{
    if (storedGas_.size())
    {
        return gasProperties::read(storedGas_);
    }

    const auto mean = [this](const volScalarField& field)
    {
        return field.weightedAverage(mesh_.V()).value();
    };

    gasProperties gas;

    gas.rho = mean(rho_);
    gas.mu = mean(thermo_->mu());
    gas.T = mean(thermo_->T());
    gas.c = std::sqrt(mean(thermo_->gamma())*mean(p_)/gas.rho);

    // psi = W/(R T)
    const scalar W = mean(psi_)*constant::thermodynamic::RR*gas.T;
    gas.meanFreePath =
        gasProperties::kineticMeanFreePath(gas.mu, gas.rho, gas.T, W);

    storedGas_.add("rho", gas.rho);
    storedGas_.add("mu", gas.mu);
    storedGas_.add("T", gas.T);
    storedGas_.add("c", gas.c);
    storedGas_.add("meanFreePath", gas.meanFreePath);

    return gas;
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
    soundField(readPositive(dict, "frequency", dimless/dimTime)),
    mesh_(mesh),
    expectedVelocity_(-1),
    logSolvers_(dict.lookupOrDefault("logSolvers", false)),
    // It marks the last corrector in the mesh, hence not const
    pimple_(const_cast<fvMesh&>(mesh), "PIMPLE", false),
    thermo_(makeThermo(mesh)),
    p_(thermo_->p()),
    e_(thermo_->he()),
    psi_(thermo_->psi()),
    rho_(stored("rho", mesh, IOobject::READ_IF_PRESENT), thermo_->rho()),
    U_(stored("U", mesh, IOobject::MUST_READ), mesh),
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
    fvOptions_(fv::options::New(mesh)),
    storedGas_
    (
        IOobject
        (
            "undisturbedGas",
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    gas_(undisturbedGas())
{
    requireOnly
    (
        dict,
        {"type", "frequency", "SPL", "velocityAmplitude", "logSolvers",
         "control"}
    );

    mesh.setFluxRequired(p_.name());
    turbulence_->validate();
    keepOldLevels();

    if (!logSolvers_)
    {
        solverPerformance::debug = 0;
        SolverPerformance<vector>::debug = 0;
    }

    Info<< "    gas: rho " << gas_.rho << " kg/m3, mu " << gas_.mu
        << " Pa s, T " << gas_.T << " K, c " << gas_.c
        << " m/s, mean free path " << gas_.meanFreePath << " m" << endl;

    if (dict.found("SPL") || dict.found("velocityAmplitude"))
    {
        const soundLevel level = soundLevel::read(dict, gas_);
        expectedVelocity_ = level.uAmplitude();

        Info<< "    expected level " << level << endl;
    }

    const numericsCheck check(mesh, frequency(), gas_.c);
    check.report(Info);
    check.warn(rho_, U_, psi_, p_, e_, pimple_);

    if (dict.found("control"))
    {
        control_.reset
        (
            new levelControl
            (
                mesh,
                dict.subDict("control"),
                frequency(),
                soundLevel::read(dict, gas_).pRms(),
                gas_.c
            )
        );
    }
}


Foam::acoustics::compressibleSound::~compressibleSound() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::compressibleSound::velocityAmplitude() const
{
    return
        expectedVelocity_ >= 0
      ? expectedVelocity_
      : std::sqrt(2*gMax(K_.primitiveField()));
}


void Foam::acoustics::compressibleSound::prepare(const boundBox& region)
{
    sampler_.reset(new regionSampler(mesh_, region));
    sampler_->reset(U_.oldTime(), U_);

    const Eigen::Array3d& spacing = sampler_->lattice().spacing();
    const scalar error = sampler_->interpolationError
    (
        constant::mathematical::twoPi*frequency()/gas_.c
    );

    Info<< "    gas velocity from nodes (" << spacing[0] << ' ' << spacing[1]
        << ' ' << spacing[2] << ") m apart: up to " << 100*error
        << " % of the amplitude are lost between them" << endl;

    if (error > 1e-3)
    {
        WarningInFunction
            << "The region in which the gas velocity is needed is so large, or"
            << " the mesh so coarse, that the nodes do not resolve the sound"
            << " well: " << 100*error << " % of the velocity amplitude are"
            << " lost between them" << endl;
    }
}


void Foam::acoustics::compressibleSound::advance()
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

    if (sampler_)
    {
        sampler_->advance(U_);
    }

    if (control_)
    {
        control_->advance();
    }
}


void Foam::acoustics::compressibleSound::velocity
(
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    if (!sampler_)
    {
        FatalErrorInFunction
            << "The gas velocity is asked for before a region was announced"
            << exit(FatalError);
    }

    // Both ends of the step are exact, whatever rounding did to the time
    const scalar end = mesh_.time().value();
    const scalar step = mesh_.time().deltaTValue();
    const scalar fraction = 1 + (t - end)/step;

    sampler_->velocity(std::clamp(fraction, 0.0, 1.0), x, u);
}


// ************************************************************************* //
