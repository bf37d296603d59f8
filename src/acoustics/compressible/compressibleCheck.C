/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "compressibleCheck.H"

#include "fvMesh.H"
#include "HashSet.H"
#include "mathematicalConstants.H"
#include "StringStream.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr double minStepsPerPeriod = 100;
constexpr double minCellsPerWavelength = 50;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::acoustics::compressibleCheck::checkScheme(const word& term) const
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

        if (nOuterCorrectors_ < 2)
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


void Foam::acoustics::compressibleCheck::warn() const
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
    HashSet<string> seen;

    for (const word& term : terms_)
    {
        OStringStream scheme;
        for (const token& part : mesh_.ddtScheme(term))
        {
            scheme << part << ' ';
        }

        if (seen.insert(scheme.str()))
        {
            checkScheme(term);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::compressibleCheck::compressibleCheck
(
    const fvMesh& mesh,
    const scalar frequency,
    const scalar soundSpeed,
    const wordList& terms,
    const label nOuterCorrectors
)
:
    numericsCheck(mesh, frequency, soundSpeed),
    terms_(terms),
    nOuterCorrectors_(nOuterCorrectors)
{}


// ************************************************************************* //
