/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitCompressibleSound.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "checkedEntry.H"
#include "explicitCheck.H"
#include "fvMatrices.H"
#include "fvMesh.H"
#include "fvOptions.H"
#include "volFields.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(explicitCompressibleSound, 0);
    addToRunTimeSelectionTable
    (
        soundField,
        explicitCompressibleSound,
        dictionary
    );
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Largest acoustic Courant number of a step. The four stages are stable up to
//  2.06 without the filter, and to 1.003 with it in three dimensions.
constexpr double maxCourant = 1;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::acoustics::centralFluxes::gas
Foam::acoustics::explicitCompressibleSound::constants
(
    const psiThermo& thermo,
    const gasProperties& undisturbed
)
{
    const auto constant = [&](const volScalarField& field, const char* name)
    {
        const scalar low = gMin(field.primitiveField());
        const scalar high = gMax(field.primitiveField());

        if (high - low > 1e-9*high)
        {
            FatalIOErrorInFunction(thermo)
                << "The sound explicitCompressible is for a perfect gas with a"
                << " constant heat capacity (hConst, perfectGas), but " << name
                << " varies from " << low << " to " << high
                << exit(FatalIOError);
        }
        return high;
    };

    centralFluxes::gas gas;
    gas.gamma = constant(thermo.gamma(), "Cp/Cv");
    gas.R = 1/constant(thermo.psi()*thermo.T(), "p/(rho R T)");
    gas.mu = undisturbed.mu;
    gas.kappa =
        thermo.kappa()().weightedAverage(thermo.T().mesh().V()).value();
    gas.c = undisturbed.c;
    gas.rho = undisturbed.rho;
    gas.p = undisturbed.rho*sqr(undisturbed.c)/gas.gamma;

    return gas;
}


void Foam::acoustics::explicitCompressibleSound::checkLaminar() const
{
    const IOdictionary turbulence
    (
        IOobject
        (
            "turbulenceProperties",
            mesh_.time().constant(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );

    if
    (
        valueOr<word>(turbulence, "simulationType", "laminar")
     != "laminar"
    )
    {
        FatalIOErrorInFunction(turbulence)
            << "The sound explicitCompressible knows laminar flow only. Set"
            << " `simulationType laminar;`, or take the sound compressible"
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::acoustics::explicitCompressibleSound::courant() const
{
    return fastest_*finest_*mesh_.time().deltaTValue();
}


Foam::label Foam::acoustics::explicitCompressibleSound::parts() const
{
    // Diffusion: the explicit limit, 2/(4 sum 1/h^2), is far for sound
    const centralFluxes::gas& gas = fluxes_.properties();
    const scalar diffusivity = max
    (
        gas.mu*4/3,
        gas.kappa*(gas.gamma - 1)/gas.R
    )/gas.rho;
    const scalar diffusion =
        2*diffusivity*sqr(finest_)*mesh_.time().deltaTValue();

    return label
    (
        std::ceil(max(courant()/maxCourant, diffusion)*(1 - 1e-9))
    );
}


Foam::vectorField Foam::acoustics::explicitCompressibleSound::forces()
{
    vectorField force;

    if (fvOptions_.PtrList<fv::option>::size())
    {
        // Not U itself: a matrix updates its boundary conditions, at the end of
        // the step, and they would not be asked at the times between
        volVectorField U
        (
            IOobject
            (
                U_.name(),
                mesh_.time().timeName(),
                mesh_,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            mesh_,
            U_.dimensions()
        );
        U.primitiveFieldRef() = U_.primitiveField();

        fvVectorMatrix sources(fvOptions_(rho_, U));

        force = (sources & U)().primitiveField();
    }

    if (!force_.empty())
    {
        const vectorField& field =
            mesh_.lookupObject<volVectorField>(force_).primitiveField();

        if (force.empty())
        {
            force = field;
        }
        else
        {
            force += field;
        }
    }

    if (coupled_)
    {
        const vectorField& ofAerosol =
            mesh_.lookupObject<volVectorField>("aerosolForce")
           .primitiveField();

        inertia_ =
            mesh_.lookupObject<volScalarField>("aerosolInertia")
           .primitiveField();

        force.setSize(mesh_.nCells(), Zero);
        force += ofAerosol;
    }

    return force;
}


void Foam::acoustics::explicitCompressibleSound::makeSource
(
    const vectorField& force
)
{
    for (auto& values : source_)
    {
        std::fill(values.begin(), values.end(), 0.0);
    }

    const centralFluxes::gas& gas = fluxes_.properties();

    if (gas.mu > 0 || gas.kappa > 0)
    {
        centralFluxes::array& divergence = fluxes_.divergence(q_);

        for (size_t i = 0; i < perVolume_.size(); ++i)
        {
            divergence[i] *= perVolume_[i];
        }
        stencils_.complete(divergence);

        fluxes_.addViscous(q_, source_);
    }

    forAll(force, i)
    {
        const vector F = force[i]/perVolume_[i];
        const vector U(q_[1][i], q_[2][i], q_[3][i]);

        for (direction d = 0; d < 3; ++d)
        {
            source_[1 + d][i] -= F[d];
        }
        source_[4][i] -= F & U;
    }
}


void Foam::acoustics::explicitCompressibleSound::stage
(
    const scalar duration,
    const bool last
)
{
    fluxes_.addInviscid(q_, sum_);

    const scalar gammaMinus1 = fluxes_.properties().gamma - 1;
    const label n = perVolume_.size();

    const scalar* const perVolume = perVolume_.data();
    const scalar* source[5];
    scalar* s[5];
    scalar* c[5];
    scalar* q[5];
    for (int k = 0; k < 5; ++k)
    {
        source[k] = source_[k].data();
        s[k] = sum_[k].data();
        c[k] = conserved_[k].data();
        q[k] = q_[k].data();
    }

    const auto advance = [&](const label i, const int k)
    {
        const scalar out = s[k][i] + source[k][i];

        // For the next stage, while it is in the cache
        s[k][i] = 0;

        return c[k][i] - duration*perVolume[i]*out;
    };

    // Of inert bodies that take part in a change of the velocity
    const scalar* const inertia = inertia_.cdata();

    const auto advanceAll = [&](const auto withInertia)
    {
        #pragma GCC ivdep
        for (label i = 0; i < n; ++i)
        {
            const scalar rho = advance(i, 0);
            scalar x = advance(i, 1);
            scalar y = advance(i, 2);
            scalar z = advance(i, 3);
            scalar E = advance(i, 4);

            const scalar perRho = 1/rho;

            if (withInertia)
            {
                const scalar C = inertia[i];
                const scalar per0 = 1/c[0][i];
                const scalar u0 = per0*c[1][i];
                const scalar v0 = per0*c[2][i];
                const scalar w0 = per0*c[3][i];
                const scalar share = rho/(rho + C);

                x = share*(x + C*u0);
                y = share*(y + C*v0);
                z = share*(z + C*w0);
                E -=
                    0.5*C
                   *(
                        sqr(perRho)*(x*x + y*y + z*z)
                      - (u0*u0 + v0*v0 + w0*w0)
                    );
            }

            q[0][i] = rho;
            q[1][i] = x*perRho;
            q[2][i] = y*perRho;
            q[3][i] = z*perRho;
            q[4][i] = gammaMinus1*(E - 0.5*perRho*(x*x + y*y + z*z));

            if (last)
            {
                c[0][i] = rho;
                c[1][i] = x;
                c[2][i] = y;
                c[3][i] = z;
                c[4][i] = E;
            }
        }
    };

    if (inertia_.size())
    {
        advanceAll(std::true_type());
    }
    else
    {
        advanceAll(std::false_type());
    }

    // What has gone into ghosts is of no use
    for (int k = 0; k < 5; ++k)
    {
        std::fill(sum_[k].begin() + n, sum_[k].end(), 0.0);
    }
}


void Foam::acoustics::explicitCompressibleSound::store()
{
    const centralFluxes::gas& gas = fluxes_.properties();

    scalarField& p = thermo_->p().primitiveFieldRef();
    scalarField& T = thermo_->T().primitiveFieldRef();
    scalarField& rho = rho_.primitiveFieldRef();
    vectorField& U = U_.primitiveFieldRef();

    scalar speed = 0;
    scalar sound = 0;

    forAll(p, i)
    {
        p[i] = q_[4][i];
        rho[i] = q_[0][i];
        const scalar RT = p[i]/rho[i];
        T[i] = RT/gas.R;
        U[i] = vector(q_[1][i], q_[2][i], q_[3][i]);

        checkState(p[i], T[i], i);

        speed = max(speed, magSqr(U[i]));
        sound = max(sound, gas.gamma*RT);
    }

    boundary_.store(q_);

    fastest_ = std::sqrt(speed) + std::sqrt(sound);
    reduce(fastest_, maxOp<scalar>());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::explicitCompressibleSound::explicitCompressibleSound
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    meshSound(mesh, dict),
    force_(valueOr<word>(dict, "force", word::null)),
    fvOptions_(fv::options::New(mesh)),
    stencils_(mesh),
    fluxes_(constants(*thermo_, gas()), stencils_.faces()),
    boundary_
    (
        thermo_->p(), thermo_->T(), U_, rho_, stencils_, fluxes_.properties()
    ),
    perVolume_(mesh.nCells()),
    finest_(0),
    fastest_(0),
    mostParts_(0),
    coupled_(false)
{
    requireOnly
    (
        dict,
        {"type", "frequency", "SPL", "velocityAmplitude", "force", "control"}
    );

    const centralFluxes::gas& constants = fluxes_.properties();

    checkLaminar();

    for (int k = 0; k < 5; ++k)
    {
        // Ghosts that are not filled are gas too
        const scalar value = k == 0 ? constants.rho : k == 4 ? constants.p : 0;

        q_[k].assign(stencils_.size(), value);
        sum_[k].assign(stencils_.size(), 0);
        source_[k].assign(stencils_.size(), 0);
        conserved_[k].assign(mesh.nCells(), 0);
    }

    forAll(U_, i)
    {
        const scalar p = thermo_->p()[i];
        const vector& U = U_[i];
        const scalar rho = p/(constants.R*thermo_->T()[i]);

        q_[0][i] = rho;
        q_[4][i] = p;
        conserved_[0][i] = rho;
        conserved_[4][i] =
            p/(constants.gamma - 1) + 0.5*rho*magSqr(U);

        for (direction d = 0; d < 3; ++d)
        {
            q_[1 + d][i] = U[d];
            conserved_[1 + d][i] = rho*U[d];
        }
    }

    // Areas of opposite faces over the volume are 1/h. Across a mesh that is
    // one cell thick nothing propagates.
    scalarField squares(mesh.nCells(), 0);
    forAll(mesh.faceOwner(), facei)
    {
        const scalar half = 0.5*magSqr(mesh.faceAreas()[facei]);
        const label left = mesh.faceOwner()[facei];

        if (mesh.isInternalFace(facei))
        {
            squares[left] += half;
            squares[mesh.faceNeighbour()[facei]] += half;
        }
        else if (stencils_.isCoupled(facei) || stencils_.inner(facei) != left)
        {
            squares[left] += half;
        }
    }

    forAll(squares, i)
    {
        perVolume_[i] = 1/mesh.V()[i];
        finest_ = max(finest_, std::sqrt(squares[i])*perVolume_[i]);
    }
    reduce(finest_, maxOp<scalar>());

    stencils_.exchange(q_);
    boundary_.fill(0, q_);
    store();

    mostParts_ = max(parts(), label(1));

    explicitCheck
    (
        mesh, frequency(), gas().c, mostParts_, courant()/mostParts_
    ).report();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::explicitCompressibleSound::step()
{
    const label n = parts();
    const scalar duration = mesh_.time().deltaTValue()/n;
    const scalar start = mesh_.time().value() - mesh_.time().deltaTValue();

    if (n > mostParts_)
    {
        Info<< "    " << n << " parts per fluid step from now on, acoustic"
            << " Courant number " << courant()/n << endl;
        mostParts_ = n;
    }

    const vectorField force(forces());
    const vectorField U0
    (
        coupled_ ? vectorField(U_.primitiveField()) : vectorField()
    );

    for (label part = 0; part < n; ++part)
    {
        boundary_.begin(start + part*duration, duration);

        for (int k = 1; k <= 4; ++k)
        {
            // The state is that of the end of the stage before
            stencils_.exchange(q_);
            boundary_.fill(k == 1 ? 0 : 1.0/(6 - k), q_);

            if (k == 1)
            {
                makeSource(force);
            }

            stage(duration/(5 - k), k == 4);
        }
    }

    stencils_.exchange(q_);
    boundary_.fill(1, q_);
    store();

    if (coupled_)
    {
        // What the gas got
        mesh_.lookupObjectRef<volVectorField>("aerosolForce")
       .primitiveFieldRef() -=
            inertia_*(U_.primitiveField() - U0)/mesh_.time().deltaTValue();
    }
}


// ************************************************************************* //
