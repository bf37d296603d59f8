/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "numericsCheck.H"

#include "fvMesh.H"
#include "mathematicalConstants.H"
#include "pimpleControl.H"
#include "surfaceFields.H"
#include "syncTools.H"
#include "volFields.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr double minStepsPerPeriod = 100;
constexpr double minCellsPerWavelength = 50;

//- Of the explicit scheme: a frequency that is 0.03 % low
constexpr double minCellsExplicit = 20;

//- Ratio of the volumes of neighbours: grading is less, refinement is more
constexpr double maxRatio = 1.9;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::acoustics::numericsCheck::checkScheme
(
    const word& term,
    const label nOuterCorrectors
) const
{
    ITstream& is = mesh_.ddtScheme(term);
    const word scheme(is);

    if (scheme == "backward")
    {
        scalar coefficient = -1;
        if (!is.eof())
        {
            token next(is);
            if (next.isNumber())
            {
                coefficient = next.number();
            }
        }

        if (nOuterCorrectors < 2)
        {
            WarningInFunction
                << term << ' ' << scheme << " with one outer corrector makes"
                << " sound grow, by 2.6 % per period and more, and diverges on"
                << " fine meshes. Set nOuterCorrectors 2 in PIMPLE" << endl;
        }

        if (coefficient != 1)
        {
            WarningInFunction
                << term << ": `" << scheme << "` without the coefficient 1"
                << " corrects the flux only in part: 0.20 % of the amplitude"
                << " are lost per period at 200 steps per period instead of"
                << " 0.005 %. Set `backward 1`" << endl;
        }
    }
    else if (scheme == "Euler")
    {
        const scalar loss =
            2*sqr(constant::mathematical::pi)/stepsPerPeriod_;

        WarningInFunction
            << term << ' ' << scheme << " loses about " << 100*loss
            << " % of the amplitude per period at " << stepsPerPeriod_
            << " steps per period. Set `backward 1`" << endl;
    }
    else if (scheme == "CrankNicolson")
    {
        WarningInFunction
            << term << ' ' << scheme << " ended in a crash at every mesh and"
            << " time step that was tried. Set `backward 1`" << endl;
    }
    else
    {
        WarningInFunction
            << term << ' ' << scheme << " has not been tried with sound. Use"
            << " `backward 1`" << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::numericsCheck::numericsCheck
(
    const fvMesh& mesh,
    const scalar frequency,
    const scalar soundSpeed
)
:
    mesh_(mesh),
    stepsPerPeriod_(1/(frequency*mesh.time().deltaTValue())),
    nUnequal_(0),
    largestRatio_(1)
{
    // From cell to cell, whatever the direction of the mesh is. Across a mesh
    // that is one cell thick, sound does not propagate.
    const surfaceScalarField& perDistance = mesh.deltaCoeffs();

    scalar least = GREAT;
    scalar most = 0;

    const auto add = [&](const scalarField& values)
    {
        for (const scalar value : values)
        {
            least = min(least, value);
            most = max(most, value);
        }
    };

    add(perDistance.primitiveField());
    for (const fvsPatchScalarField& patch : perDistance.boundaryField())
    {
        if (patch.coupled())
        {
            add(patch);
        }
    }

    reduce(least, minOp<scalar>());
    reduce(most, maxOp<scalar>());

    if (most == 0)
    {
        FatalErrorInFunction
            << "The mesh has one cell: it can hold no sound"
            << exit(FatalError);
    }

    // Coupled faces are seen from both sides
    const auto compare = [&](const scalar a, const scalar b, const label sides)
    {
        const scalar ratio = max(a/b, b/a);

        largestRatio_ = max(largestRatio_, ratio);
        nUnequal_ += ratio > maxRatio ? sides : 0;
    };

    const scalarField& V = mesh.cellVolumes();

    forAll(mesh.faceNeighbour(), facei)
    {
        compare(V[mesh.faceOwner()[facei]], V[mesh.faceNeighbour()[facei]], 2);
    }

    scalarField Vb;
    syncTools::swapBoundaryCellList(mesh, V, Vb);

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                const label facei = patch.start() + i;

                compare
                (
                    V[mesh.faceOwner()[facei]],
                    Vb[facei - mesh.nInternalFaces()],
                    1
                );
            }
        }
    }

    reduce(nUnequal_, sumOp<label>());
    nUnequal_ /= 2;
    reduce(largestRatio_, maxOp<scalar>());

    cellsPerWavelength_ = soundSpeed/frequency*least;
    acousticCourant_ = soundSpeed*mesh.time().deltaTValue()*most;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::numericsCheck::report(Ostream& os) const
{
    os  << "    resolution: " << stepsPerPeriod_
        << " steps per period (k_f = deltaT/T_a = " << 1/stepsPerPeriod_
        << "), " << cellsPerWavelength_
        << " cells per wavelength, acoustic Courant number "
        << acousticCourant_ << endl;
}


void Foam::acoustics::numericsCheck::warnOfRefinement(const char* what) const
{
    if (nUnequal_)
    {
        WarningInFunction
            << "At " << nUnequal_ << " faces the volumes of the cells on both"
            << " sides differ by a factor of up to " << largestRatio_
            << ", as where a mesh is refined 2:1." << nl << "    " << what
            << endl;
    }
}


void Foam::acoustics::numericsCheck::warn
(
    const volScalarField& rho,
    const volVectorField& U,
    const volScalarField& psi,
    const volScalarField& p,
    const volScalarField& e,
    const pimpleControl& pimple
) const
{
    using constant::mathematical::twoPi;

    if
    (
        stepsPerPeriod_ < 0.99*minStepsPerPeriod
     || cellsPerWavelength_ < 0.99*minCellsPerWavelength
    )
    {
        const scalar loss = min(390/pow3(stepsPerPeriod_), scalar(1));
        const scalar shift =
            sqr(twoPi/cellsPerWavelength_)/24 + sqr(twoPi/stepsPerPeriod_)/3;

        WarningInFunction
            << "The resolution is coarse: at least " << minStepsPerPeriod
            << " steps per period and " << minCellsPerWavelength
            << " cells per wavelength are advised." << nl
            << "    Expect a loss of " << 100*loss
            << " % of the amplitude per period and a frequency that is "
            << 100*shift << " % low" << endl;
    }

    warnOfRefinement
    (
        "The interpolation between them is of first order: a part of the sound"
        " is reflected there, the more the coarser the cells are. Refine the"
        " whole length of the sound, or grade the cells"
    );

    // The terms usually share one scheme: one warning for each scheme that
    // differs is enough
    const wordList terms
    ({
        "ddt(" + rho.name() + ',' + U.name() + ')',
        "ddt(" + rho.name() + ')',
        "ddt(" + psi.name() + ',' + p.name() + ')',
        "ddt(" + rho.name() + ',' + e.name() + ')',
        "ddt(" + rho.name() + ",K)"
    });

    HashSet<string> seen;

    for (const word& term : terms)
    {
        OStringStream scheme;
        for (const token& part : mesh_.ddtScheme(term))
        {
            scheme << part << ' ';
        }

        if (seen.insert(scheme.str()))
        {
            checkScheme(term, pimple.nCorrPIMPLE());
        }
    }
}


void Foam::acoustics::numericsCheck::warnExplicit() const
{
    using constant::mathematical::twoPi;

    std::ostringstream slower;
    slower << 100*sqr(twoPi/cellsPerWavelength_)/6;

    warnOfRefinement
    (
        (
            "There the scheme is of second order, not of fourth: where the"
            " cells are largest, sound is up to "
          + slower.str() + " % slow, and a part of it is reflected. Refine the"
            " whole length of the sound, or grade the cells"
        ).c_str()
    );

    if (cellsPerWavelength_ < 0.99*minCellsExplicit)
    {
        WarningInFunction
            << "The resolution is coarse: at least " << minCellsExplicit
            << " cells per wavelength are advised." << nl
            << "    Expect a frequency that is "
            << 100*pow4(twoPi/cellsPerWavelength_)/30 << " % low" << endl;
    }
}


// ************************************************************************* //
