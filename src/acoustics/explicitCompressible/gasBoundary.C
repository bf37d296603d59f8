/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gasBoundary.H"

#include "advectiveFvPatchFields.H"
#include "emptyFvPatch.H"
#include "evaluateOrRefuse.H"
#include "faceStencils.H"
#include "fvMesh.H"
#include "surfaceFields.H"
#include "surfaceInterpolate.H"
#include "Time.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

template<class Type>
Type Foam::acoustics::gasBoundary::side<Type>::at
(
    const scalar x,
    const label i
) const
{
    return
        moves
      ? 2*(x - 0.5)*(x - 1)*begin[i]
      + 4*x*(1 - x)*middle[i]
      + 2*x*(x - 0.5)*end[i]
      : end[i];
}


template<class Type>
Type Foam::acoustics::gasBoundary::side<Type>::slope
(
    const scalar x,
    const label i
) const
{
    return
        moves
      ? (4*x - 3)*begin[i] + (4 - 8*x)*middle[i] + (4*x - 1)*end[i]
      : Type(Zero);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
bool Foam::acoustics::gasBoundary::isAlone(const fvPatchField<Type>& field)
{
    return
        field.patch().coupled()
     || wordList
        ({
            "empty", "slip", "basicSymmetry", "symmetry", "symmetryPlane",
            "wedge", "zeroGradient", "calculated", "waveTransmissive",
            "fixedFluxPressure", "fixedFluxExtrapolatedPressure", "fixedValue",
            "uniformFixedValue", "noSlip", "acousticPiston", "acousticPressure"
        }).found(field.type());
}


template<class Type>
Foam::acoustics::gasBoundary::side<Type>
Foam::acoustics::gasBoundary::makeSide(fvPatchField<Type>& field)
{
    const word& type = field.type();
    const auto isOneOf = [&](const wordList& names)
    {
        return names.found(type);
    };

    side<Type> s;
    s.moves = false;

    if
    (
        isOneOf({"slip", "basicSymmetry", "symmetry", "symmetryPlane", "wedge"})
    )
    {
        s.is = rule::mirror;
    }
    else if
    (
        isOneOf
        ({
            "zeroGradient", "calculated", "waveTransmissive",
            "fixedFluxPressure", "fixedFluxExtrapolatedPressure"
        })
    )
    {
        s.is = rule::even;
    }
    else if
    (
        field.fixesValue()
     && !isOneOf
        ({
            "totalPressure", "uniformTotalPressure", "rotatingTotalPressure",
            "totalTemperature", "pressureInletVelocity",
            "pressureDirectedInletVelocity", "fluxCorrectedVelocity"
        })
    )
    {
        s.is = rule::value;
        s.moves = !isOneOf({"fixedValue", "noSlip"});

        // A file may have been written before its condition was
        evaluateOrRefuse(field, "explicitCompressible");
    }
    else
    {
        s.is = rule::evaluated;
        evaluateOrRefuse(field, "explicitCompressible");
    }

    s.begin = field;
    s.middle = field;
    s.end = field;

    return s;
}


template<class Type>
void Foam::acoustics::gasBoundary::ask
(
    fvPatchField<Type>& field,
    Field<Type>& values
)
{
    evaluateOrRefuse(field, "explicitCompressible");
    values = field;
}


void Foam::acoustics::gasBoundary::evaluate
(
    patch& b,
    const centralFluxes::state& q
)
{
    const labelUList& cells =
        p_.mesh().boundary()[b.index].faceCells();

    fvsPatchScalarField& phi = phi_->boundaryFieldRef()[b.index];
    fvPatchScalarField& rho = rho_.boundaryFieldRef()[b.index];

    forAll(cells, facei)
    {
        const label i = cells[facei];

        p_[i] = q[4][i];
        T_[i] = q[4][i]/(gas_.R*q[0][i]);
        U_[i] = vector(q[1][i], q[2][i], q[3][i]);

        rho[facei] = q[0][i];
        phi[facei] = q[0][i]*(U_[i] & phi.patch().Sf()[facei]);
    }

    const auto renew = [&](auto& side, auto& field)
    {
        if (side.is == rule::evaluated)
        {
            ask(field.boundaryFieldRef()[b.index], side.end);
        }
    };

    renew(b.p, p_);
    renew(b.T, T_);
    renew(b.U, U_);
}


void Foam::acoustics::gasBoundary::fill
(
    const patch& b,
    const scalar fraction,
    centralFluxes::state& q
) const
{
    const scalar impedance = gas_.rho*gas_.c;

    forAll(b.near, i)
    {
        const vector& n = b.normal[i];

        // The near and the far cell, and their ghosts
        const label place[2] = {b.near[i], b.far[i]};
        const scalar distance[2] = {b.nearDistance[i], b.farDistance[i]};
        const label ghost[2] =
            {b.firstGhost + i, b.firstGhost + i + second_};

        scalar p[2];
        vector U[2];
        for (int k = 0; k < 2; ++k)
        {
            const label c = place[k];
            p[k] = q[4][c];
            U[k] = vector(q[1][c], q[2][c], q[3][c]);
        }

        // The pressure and the normal velocity of a wave that leaves
        scalar pWave = 0;
        scalar uWave = 0;
        if (b.p.is == rule::radiating)
        {
            const scalar out =
                1.5*(p[0] + impedance*(U[0] & n))
              - 0.5*(p[1] + impedance*(U[1] & n));

            pWave = 0.5*(out + b.rest);
            uWave = 0.5*(out - b.rest)/impedance;
        }

        const vector Ub =
            b.U.is == rule::value || b.U.is == rule::evaluated
          ? b.U.at(fraction, i)
          : vector::zero;

        // Outwards
        const scalar gradient =
            b.U.moves
          ? -q[0][place[0]]*(b.U.slope(fraction, i) & n)/step_
          : 0;

        for (int k = 0; k < 2; ++k)
        {
            const scalar T = p[k]/(gas_.R*q[0][place[k]]);

            vector Ug = U[k];
            scalar pg = p[k] + 2*distance[k]*gradient;
            scalar Tg = T;

            if (b.p.is == rule::radiating)
            {
                Ug += 2*(uWave - (U[k] & n))*n;
                pg = 2*pWave - p[k];
            }
            else
            {
                switch (b.U.is)
                {
                    case rule::mirror:
                        Ug -= 2*(U[k] & n)*n;
                        break;
                    case rule::value:
                    case rule::evaluated:
                        Ug = 2*Ub - U[k];
                        break;
                    default:
                        break;
                }

                if (b.p.is == rule::value || b.p.is == rule::evaluated)
                {
                    pg = 2*b.p.at(fraction, i) - p[k];
                }
            }

            if (b.T.is == rule::value || b.T.is == rule::evaluated)
            {
                Tg = 2*b.T.at(fraction, i) - T;
            }

            const label g = ghost[k];
            q[0][g] = pg/(gas_.R*Tg);
            q[1][g] = Ug.x();
            q[2][g] = Ug.y();
            q[3][g] = Ug.z();
            q[4][g] = pg;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::gasBoundary::gasBoundary
(
    volScalarField& p,
    volScalarField& T,
    volVectorField& U,
    volScalarField& rho,
    const faceStencils& stencils,
    const centralFluxes::gas& gas
)
:
    p_(p),
    T_(T),
    U_(U),
    rho_(rho),
    second_(stencils.second()),
    gas_(gas),
    step_(1)
{
    const fvMesh& mesh = p.mesh();
    const vectorField& C = mesh.cellCentres();

    forAll(mesh.boundary(), patchi)
    {
        if
        (
            !phi_
         && !(
                isAlone(p.boundaryField()[patchi])
             && isAlone(T.boundaryField()[patchi])
             && isAlone(U.boundaryField()[patchi])
            )
        )
        {
            phi_.reset
            (
                new surfaceScalarField
                (
                    IOobject("phi", mesh.time().timeName(), mesh),
                    linearInterpolate(rho*U) & mesh.Sf()
                )
            );
        }
    }

    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& fvp = mesh.boundary()[patchi];

        // The conditions of a patch without faces on this rank are asked, too:
        // some add up over all ranks
        if (isA<emptyFvPatch>(fvp) || (fvp.coupled() && fvp.size() == 0))
        {
            continue;
        }

        const label start = fvp.start();
        const label firstGhost = fvp.size() ? stencils.ghost(start) : 0;

        if (fvp.coupled())
        {
            coupled_.emplace_back(patchi, firstGhost);
            continue;
        }

        const fvPatchScalarField& pressure = p.boundaryField()[patchi];

        if (pressure.type() == "advective")
        {
            FatalErrorInFunction
                << "The boundary condition advective of p at the patch "
                << fvp.name() << " cannot be used with the sound"
                << " explicitCompressible: it reflects sound. Use"
                << " waveTransmissive, which lets it out"
                << exit(FatalError);
        }

        patch b;
        b.index = patchi;
        b.p = makeSide(p.boundaryFieldRef()[patchi]);
        b.T = makeSide(T.boundaryFieldRef()[patchi]);
        b.U = makeSide(U.boundaryFieldRef()[patchi]);
        b.rest = gas.p;

        if (pressure.type() == "waveTransmissive")
        {
            b.p.is = rule::radiating;

            const auto& wave =
                refCast<const advectiveFvPatchScalarField>(pressure);

            if (wave.lInf() > 0)
            {
                b.rest = wave.fieldInf();
            }
        }

        b.firstGhost = firstGhost;
        b.near = fvp.faceCells();
        b.normal = fvp.nf();
        b.far.setSize(fvp.size());
        b.nearDistance.setSize(fvp.size());
        b.farDistance.setSize(fvp.size());

        forAll(b.near, i)
        {
            b.far[i] = stencils.inner(start + i);

            const point& Cf = fvp.Cf()[i];
            b.nearDistance[i] = (Cf - C[b.near[i]]) & b.normal[i];

            // Of a cell of another rank it is as far as on equal cells
            b.farDistance[i] =
                b.far[i] < mesh.nCells()
              ? (Cf - C[b.far[i]]) & b.normal[i]
              : 3*b.nearDistance[i];
        }

        patches_.push_back(std::move(b));
    }
}


Foam::acoustics::gasBoundary::~gasBoundary() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::gasBoundary::begin
(
    const scalar start,
    const scalar duration
)
{
    step_ = duration;

    Time& time = const_cast<Time&>(p_.time());
    const scalar now = time.value();

    for (patch& b : patches_)
    {
        const auto renew = [&](auto& side, auto& field)
        {
            if (side.moves)
            {
                auto& condition = field.boundaryFieldRef()[b.index];

                side.begin = side.end;
                time.value() = start + 0.5*duration;
                ask(condition, side.middle);
                time.value() = start + duration;
                ask(condition, side.end);
            }
        };

        renew(b.p, p_);
        renew(b.T, T_);
        renew(b.U, U_);
    }

    time.value() = now;
}


void Foam::acoustics::gasBoundary::fill
(
    const scalar fraction,
    centralFluxes::state& q
)
{
    for (patch& b : patches_)
    {
        if
        (
            b.p.is == rule::evaluated
         || b.T.is == rule::evaluated
         || b.U.is == rule::evaluated
        )
        {
            evaluate(b, q);
        }

        fill(b, fraction, q);
    }
}


void Foam::acoustics::gasBoundary::store(const centralFluxes::state& q)
{
    const auto set = [&](const label patchi, const label ghost, const scalar w)
    {
        const labelUList& cells = p_.mesh().boundary()[patchi].faceCells();

        scalarField p(cells.size());
        scalarField T(cells.size());
        scalarField rho(cells.size());
        vectorField U(cells.size());

        // The share w of the ghost, the rest of the cell
        forAll(cells, i)
        {
            const label c = cells[i];
            const label g = ghost + i;

            const auto mean = [&](const int k)
            {
                return w*q[k][g] + (1 - w)*q[k][c];
            };

            p[i] = mean(4);
            rho[i] = mean(0);
            T[i] =
                w*q[4][g]/(gas_.R*q[0][g]) + (1 - w)*q[4][c]/(gas_.R*q[0][c]);
            U[i] = vector(mean(1), mean(2), mean(3));
        }

        p_.boundaryFieldRef()[patchi] == p;
        T_.boundaryFieldRef()[patchi] == T;
        rho_.boundaryFieldRef()[patchi] == rho;
        U_.boundaryFieldRef()[patchi] == U;
    };

    for (const patch& b : patches_)
    {
        set(b.index, b.firstGhost, 0.5);
    }

    for (const auto& [patchi, ghost] : coupled_)
    {
        // That of a processor is the cell of the other side
        const bool processor =
            p_.mesh().boundary()[patchi].type().find("processor")
         == 0;

        set(patchi, ghost, processor ? 1 : 0.5);
    }

    if (phi_)
    {
        *phi_ = linearInterpolate(rho_*U_) & p_.mesh().Sf();
    }
}


// ************************************************************************* //
