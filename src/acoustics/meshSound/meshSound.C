/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshSound.H"

#include "airProperties.H"
#include "checkedDictionary.H"
#include "fvMesh.H"
#include "gasEntries.H"
#include "levelControl.H"
#include "mathematicalConstants.H"
#include "regionSampler.H"
#include "runGuard.H"
#include "soundLevel.H"
#include "soundSources.H"
#include "thermodynamicConstants.H"
#include "waveTransmissiveFvPatchFields.H"

#include <algorithm>
#include <tuple>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::fvMesh& Foam::acoustics::meshSound::checked(const fvMesh& mesh)
{
    // In the cells and where a boundary condition says what it is
    const auto range = [&](const word& name, const dimensionSet& dimensions)
    {
        const runGuard::activity what
        (
            "reading " + mesh.time().timeName() + '/' + name
        );
        const runGuard::reading numbers;

        const volScalarField field
        (
            IOobject
            (
                name,
                mesh.time().timeName(),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh
        );

        if (field.dimensions() != dimensions)
        {
            FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, field.objectPath())
                << "The dimensions of " << name << " are "
                << field.dimensions() << ", but must be " << dimensions
                << exit(FatalIOError);
        }

        scalar least = gMin(field.primitiveField());
        scalar most = gMax(field.primitiveField());

        // Of fields with numbers that are none, these may be anything
        const scalar mean = gAverage(field.primitiveField());
        if (!std::isfinite(mean))
        {
            most = mean;
        }

        for (const fvPatchScalarField& patch : field.boundaryField())
        {
            if (patch.fixesValue())
            {
                least = min(least, gMin(patch));
                most = max(most, gMax(patch));
            }
        }

        return std::make_tuple(field.objectPath(), least, most);
    };

    const auto [pFile, pLeast, pMost] = range("p", dimPressure);
    const auto [TFile, TLeast, TMost] = range("T", dimTemperature);

    for (const scalar p : {pLeast, pMost})
    {
        requirePlausible(p, gasProperties::air().T, pFile);
    }
    for (const scalar T : {TLeast, TMost})
    {
        requirePlausible(atmosphere, T, TFile);
    }

    return mesh;
}


void Foam::acoustics::meshSound::checkBoundaries(const dictionary& dict) const
{
    if (U_.dimensions() != dimVelocity)
    {
        FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, U_.objectPath())
            << "The dimensions of U are " << U_.dimensions()
            << ", but must be " << dimVelocity << exit(FatalIOError);
    }

    const scalar p = thermo_->p().weightedAverage(mesh_.V()).value();
    const scalar gamma = thermo_->gamma()().weightedAverage(mesh_.V()).value();

    const soundSources sources(thermo_->p(), U_);
    sources.warnOfFrequency
    (
        frequency(),
        "'frequency' in " + dict.name()
    );
    sources.checkAmplitudes(p, gas_);

    for (const fvPatchScalarField& patch : thermo_->p().boundaryField())
    {
        const auto* wave = isA<waveTransmissiveFvPatchScalarField>(patch);

        if (wave && mag(wave->gamma() - gamma) > 0.01*gamma)
        {
            WarningInFunction
                << "'gamma' of the patch " << patch.patch().name() << " in "
                << thermo_->p().objectPath() << " is " << wave->gamma()
                << ", but Cp/Cv of the gas is " << gamma
                << ": sound that leaves is reflected in part" << endl;
        }
        if (wave && wave->lInf() > 0 && mag(wave->fieldInf() - p) > 0.01*p)
        {
            WarningInFunction
                << "'fieldInf' of the patch " << patch.patch().name() << " in "
                << thermo_->p().objectPath() << " is " << wave->fieldInf()
                << " Pa, but the mean pressure of the gas is " << p
                << " Pa: a flow sets in" << endl;
        }
    }
}


Foam::acoustics::gasProperties Foam::acoustics::meshSound::undisturbedGas()
{
    if (continued_)
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
    gas.c = std::sqrt(mean(thermo_->gamma())*mean(thermo_->p())/gas.rho);

    gas.Cp = mean(thermo_->Cp());
    gas.kappa = mean(thermo_->kappa());

    // psi = W/(R T)
    const scalar W = mean(thermo_->psi())*constant::thermodynamic::RR*gas.T;
    gas.meanFreePath =
        gasProperties::kineticMeanFreePath(gas.mu, gas.rho, gas.T, W);

    storedGas_.merge(gasEntries(gas));

    return gas;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::acoustics::meshSound::stored
(
    const word& name,
    const fvMesh& mesh,
    const IOobject::readOption read
)
{
    return IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        read,
        IOobject::AUTO_WRITE
    );
}


void Foam::acoustics::meshSound::checkState
(
    const scalar p,
    const scalar T,
    const label celli
) const
{
    // Not true for numbers that are none
    if (!(p > 0 && p < GREAT && T > 0 && T < GREAT))
    {
        FatalErrorInFunction
            << "The gas has p = " << p << " Pa, T = " << T << " K at "
            << mesh_.cellCentres()[celli] << ", time "
            << mesh_.time().timeName() << " s." << nl
            << "The solution has diverged: see the warnings at the start"
            << " of the log about schemes, outer correctors and"
            << " resolution, and check the amplitude of the source"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::meshSound::meshSound
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    soundField(readPositive(dict, "frequency", dimless/dimTime)),
    expectedVelocity_(-1),
    storedGas_("undisturbedGas", mesh, gasNames()),
    continued_(storedGas_.size()),
    mesh_(checked(mesh)),
    thermo_(psiThermo::New(mesh)),
    rho_(stored("rho", mesh, IOobject::READ_IF_PRESENT), thermo_->rho()),
    U_(stored("U", mesh, IOobject::MUST_READ), mesh)
{
    gas_ = undisturbedGas();

    checkBoundaries(dict);

    if (dict.found("SPL") || dict.found("velocityAmplitude"))
    {
        const soundLevel level = soundLevel::read(dict, gas_);
        expectedVelocity_ = level.uAmplitude();

        Info<< "    expected level " << level << endl;
    }

    if (dict.found("control"))
    {
        optionalDict(dict, "control");

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


Foam::acoustics::meshSound::~meshSound() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::meshSound::velocityAmplitude() const
{
    return
        expectedVelocity_ >= 0
      ? expectedVelocity_
      : std::sqrt(gMax(magSqr(U_.primitiveField())()));
}


Foam::label Foam::acoustics::meshSound::prepare(const boundBox& region)
{
    samplers_.push_back(std::make_unique<regionSampler>(mesh_, region));

    regionSampler& sampler = *samplers_.back();
    sampler.reset(U_, U_);

    const Eigen::Array3d& spacing = sampler.lattice().spacing();
    const scalar error = sampler.interpolationError
    (
        constant::mathematical::twoPi*frequency()/gas_.c
    );

    Info<< "    gas velocity at the particles: interpolated from nodes ("
        << spacing[0] << ' ' << spacing[1] << ' ' << spacing[2]
        << ") m apart, with an error of up to " << 100*error
        << " % of the amplitude" << endl;

    if (error > 1e-3)
    {
        WarningInFunction
            << "The region in which the gas velocity is needed is so large, or"
            << " the mesh so coarse, that the nodes do not resolve the sound"
            << " well: " << 100*error << " % of the velocity amplitude are"
            << " lost between them" << endl;
    }

    return samplers_.size() - 1;
}


void Foam::acoustics::meshSound::advance()
{
    step();

    for (const auto& sampler : samplers_)
    {
        sampler->advance(U_);
    }

    if (control_)
    {
        control_->advance();
    }
}


void Foam::acoustics::meshSound::velocity
(
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    velocityIn(0, t, x, u);
}


void Foam::acoustics::meshSound::velocityIn
(
    const label region,
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    if (region >= label(samplers_.size()))
    {
        FatalErrorInFunction
            << "The gas velocity is asked for before a region was announced"
            << exit(FatalError);
    }

    // Both ends of the step are exact, whatever rounding did to the time
    const scalar end = mesh_.time().value();
    const scalar step = mesh_.time().deltaTValue();
    const scalar fraction = 1 + (t - end)/step;

    samplers_[region]->velocity(std::clamp(fraction, 0.0, 1.0), x, u);
}


// ************************************************************************* //
