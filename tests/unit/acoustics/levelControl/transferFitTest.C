/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// The settled response of a chamber, from periods in which it has not settled

#include "transferFit.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam::acoustics;

namespace
{

using phasor = std::complex<double>;

//- Response of one mode to a drive, from silence
std::vector<phasor> respond
(
    const phasor& pole,
    const phasor& gain,
    const std::vector<phasor>& drive
)
{
    std::vector<phasor> response;
    phasor A = 0;
    for (const phasor& D : drive)
    {
        A = pole*A + gain*D;
        response.push_back(A);
    }
    return response;
}

} // End anonymous namespace


TEST(transferFit, tellsTheSettledResponseBeforeItIsReached)
{
    const phasor gain(0.3, -2);

    // At resonance with a quality of 20 and 200, and a mode that rings beside
    for
    (
        const phasor& pole
      : {phasor(0.855, 0), phasor(0.984, 0), std::polar(0.999, 2.5)}
    )
    {
        // A drive that changes
        const std::vector<phasor> drive({1, 1.2, 2, 2, 1.5});
        const transferFit fit(respond(pole, gain, drive), drive);
        const phasor exact = gain/(1.0 - pole);

        EXPECT_NEAR(std::abs(fit.transfer()/exact - 1.0), 0, 1e-3) << pole;
        EXPECT_NEAR(std::abs(fit.pole() - pole), 0, 1e-4);
    }
}


TEST(transferFit, isTheRatioOfWhatIsSettled)
{
    const std::vector<phasor> response(4, phasor(3, 4));
    const std::vector<phasor> drive(4, phasor(0, 0.1));

    const transferFit fit(response, drive);

    EXPECT_NEAR(std::abs(fit.transfer()*drive[0]/response[0] - 1.0), 0, 1e-5);
}


TEST(transferFit, needsNoMoreThanNumbersThatAreFinite)
{
    // Silence, and growth that no passive chamber shows
    const std::vector<phasor> none(4, phasor(0, 0));
    EXPECT_TRUE(std::isfinite(std::abs(transferFit(none, none).transfer())));

    const std::vector<phasor> growing({1, 2, 4, 8});
    const transferFit fit(growing, {1, 1, 1, 1});
    EXPECT_TRUE(std::isfinite(std::abs(fit.transfer())));
    EXPECT_LT(std::abs(fit.pole()), 1);
}


// ************************************************************************* //
