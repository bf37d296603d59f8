/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "numericsCheck.H"

#include "fvMesh.H"
#include "mathematicalConstants.H"
#include "pimpleControl.H"
#include "volFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr double minStepsPerPeriod = 100;
constexpr double minCellsPerWavelength = 50;

//- Of the explicit scheme: a frequency that is 0.03 % low
constexpr double minCellsExplicit = 20;

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
    stepsPerPeriod_(1/(frequency*mesh.time().deltaTValue()))
{
    vector smallest(vector::max);
    vector largest(vector::zero);

    for (const labelList& points : mesh.cellPoints())
    {
        const vector size = boundBox(mesh.points(), points, false).span();

        smallest = min(smallest, size);
        largest = max(largest, size);
    }

    reduce(smallest, minOp<vector>());
    reduce(largest, maxOp<vector>());

    // Sound does not propagate across a mesh that is one cell thick
    const vector span = mesh.bounds().span();
    scalar smallestCell = GREAT;
    scalar largestCell = 0;

    for (direction d = 0; d < 3; ++d)
    {
        if (mesh.solutionD()[d] != -1 && largest[d] < 0.99*span[d])
        {
            smallestCell = min(smallestCell, smallest[d]);
            largestCell = max(largestCell, largest[d]);
        }
    }

    cellsPerWavelength_ = soundSpeed/frequency/max(largestCell, SMALL);
    acousticCourant_ = soundSpeed*mesh.time().deltaTValue()/smallestCell;
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
