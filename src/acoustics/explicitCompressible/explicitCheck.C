/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "explicitCheck.H"

#include "mathematicalConstants.H"
#include "messageStream.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A frequency that is 0.03 % low
constexpr double minCellsPerWavelength = 20;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::explicitCheck::explicitCheck
(
    const fvMesh& mesh,
    const scalar frequency,
    const scalar soundSpeed,
    const label parts,
    const scalar courantOfPart
)
:
    numericsCheck(mesh, frequency, soundSpeed),
    parts_(parts),
    courantOfPart_(courantOfPart)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::string Foam::acoustics::explicitCheck::courant() const
{
    std::ostringstream os;
    os  << parts_ << (parts_ == 1 ? " part" : " parts")
        << " per fluid step, acoustic Courant number " << courantOfPart_;

    return os.str();
}


void Foam::acoustics::explicitCheck::warn() const
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

    if (cellsPerWavelength_ < 0.99*minCellsPerWavelength)
    {
        WarningInFunction
            << "The resolution is coarse: at least " << minCellsPerWavelength
            << " cells per wavelength are advised." << nl
            << "    Expect a frequency that is "
            << 100*pow4(twoPi/cellsPerWavelength_)/30 << " % low" << endl;
    }
}


// ************************************************************************* //
