/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "numericsCheck.H"

#include "fvMesh.H"
#include "surfaceFields.H"
#include "syncTools.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Ratio of the volumes of neighbours: grading is less, refinement is more
constexpr double maxRatio = 1.9;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::numericsCheck::numericsCheck
(
    const fvMesh& mesh,
    const scalar frequency,
    const scalar soundSpeed
)
:
    nUnequal_(0),
    largestRatio_(1),
    mesh_(mesh),
    stepsPerPeriod_(1/(frequency*mesh.time().deltaTValue()))
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


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

std::string Foam::acoustics::numericsCheck::courant() const
{
    std::ostringstream os;
    os  << "acoustic Courant number " << acousticCourant_;

    return os.str();
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::numericsCheck::report() const
{
    Info<< "    resolution: " << stepsPerPeriod_
        << " steps per period (k_f = deltaT/T_a = " << 1/stepsPerPeriod_
        << "), " << cellsPerWavelength_ << " cells per wavelength, "
        << courant().c_str() << endl;

    warn();
}


// ************************************************************************* //
