/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "compressibleSound.H"

#include "constrainHbyA.H"
#include "constrainPressure.H"
#include "externalForce.H"
#include "fvcDdt.H"
#include "fvcDiv.H"
#include "fvcFlux.H"
#include "fvcGrad.H"
#include "fvcMeshPhi.H"
#include "fvmDdt.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::acoustics::compressibleSound::loop()
{
    // It announces every corrector: two lines per step
    const int level = messageStream::level;
    if (!logSolvers_)
    {
        messageStream::level = 0;
    }

    const bool more = pimple_.loop();

    messageStream::level = level;

    return more;
}


void Foam::acoustics::compressibleSound::solveContinuity()
{
    fvScalarMatrix rhoEqn
    (
        fvm::ddt(rho_)
      + fvc::div(phi_)
     ==
        fvOptions_(rho_)
    );

    fvOptions_.constrain(rhoEqn);

    rhoEqn.solve();

    fvOptions_.correct(rho_);
}


Foam::tmp<Foam::fvVectorMatrix>
Foam::acoustics::compressibleSound::solveMomentum()
{
    tmp<fvVectorMatrix> tUEqn
    (
        fvm::ddt(rho_, U_)
      + fvm::div(phi_, U_)
      + turbulence_->divDevRhoReff(U_)
     ==
        fvOptions_(rho_, U_)
    );
    fvVectorMatrix& UEqn = tUEqn.ref();

    if (force_)
    {
        UEqn -= force_->force(U_);
    }

    UEqn.relax();

    fvOptions_.constrain(UEqn);

    if (pimple_.momentumPredictor())
    {
        solve(UEqn == -fvc::grad(p_));

        fvOptions_.correct(U_);
        K_ = 0.5*magSqr(U_);
    }

    return tUEqn;
}


void Foam::acoustics::compressibleSound::solveEnergy()
{
    fvScalarMatrix EEqn
    (
        fvm::ddt(rho_, e_)
      + fvm::div(phi_, e_)
      + fvc::ddt(rho_, K_)
      + fvc::div(phi_, K_)
      + fvc::div(phi_/fvc::interpolate(rho_), p_, "div(phiv,p)")
      - fvm::laplacian(turbulence_->alphaEff(), e_)
     ==
        fvOptions_(rho_, e_)
    );

    if (force_)
    {
        EEqn -= fvm::Su(force_->power(U_), e_);
    }

    EEqn.relax();

    fvOptions_.constrain(EEqn);

    EEqn.solve();

    fvOptions_.correct(e_);

    thermo_->correct();
}


void Foam::acoustics::compressibleSound::correctPressure
(
    const fvVectorMatrix& UEqn
)
{
    rho_ = thermo_->rho();

    const volScalarField rAU(1.0/UEqn.A());
    const surfaceScalarField rhorAUf("rhorAUf", fvc::interpolate(rho_*rAU));
    const volVectorField HbyA(constrainHbyA(rAU*UEqn.H(), U_, p_));

    // Volume flux without the pressure gradient
    const surfaceScalarField rhof(fvc::interpolate(rho_));
    surfaceScalarField ddtCorr(fvc::ddtCorr(rho_, U_, phi_));

    // What follows the gas has its old velocity, too
    if (force_)
    {
        ddtCorr *= 1 + fvc::interpolate(force_->inertia())/rhof;
    }

    const surfaceScalarField phivHbyA
    (
        fvc::flux(HbyA) + rhorAUf*ddtCorr/rhof
    );
    const surfaceScalarField phid("phid", fvc::interpolate(psi_)*phivHbyA);

    // Next to an oscillating wall the pressure has a gradient
    constrainPressure(p_, rho_, U_, rhof*phivHbyA, rhorAUf);

    while (pimple_.correctNonOrthogonal())
    {
        fvScalarMatrix pEqn
        (
            fvm::ddt(psi_, p_)
          + fvm::div(phid, p_)
          - fvm::laplacian(rhorAUf, p_)
         ==
            fvOptions_(psi_, p_, rho_.name())
        );

        pEqn.solve();

        if (pimple_.finalNonOrthogonalIter())
        {
            phi_ = pEqn.flux();
        }
    }

    forAll(p_, celli)
    {
        checkState(p_[celli], thermo_->T()[celli], celli);
    }

    solveContinuity();

    U_ = HbyA - rAU*fvc::grad(p_);
    U_.correctBoundaryConditions();
    fvOptions_.correct(U_);
    K_ = 0.5*magSqr(U_);
}


// ************************************************************************* //
