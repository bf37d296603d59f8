/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The drift of particles in a standing wave, u = U sin(k x) sin(omega t): to
    second order in the amplitude, with s = omega tau,
        v = -1/(4 omega) d(U^2 sin^2(k x))/dx s/(1 + s^2),
    whatever the phase. With the displacement xi = Re(X exp(i omega t)) around
    the mean place, X = U(x)/(i omega (1 + i s)), the gas that the particle
    meets has the mean <xi du/dx>. What this leaves out is smaller by
    (U/c)^2 = 1e-5.

\*---------------------------------------------------------------------------*/

#include "measured.H"
#include "standingWave.H"
#include "timeSteppingTools.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double frequency = 1400;
const double omega = 2*pi*frequency;
const double U = 1;
const double tau = 110e-6;
const double density = 2300;

//- Drift over its theory, at several places in units of the wavelength
Eigen::ArrayXd drift
(
    const std::string& stepping,
    const int steps,
    const std::vector<double>& places
)
{
    const double k = omega/gasProperties::air().c;
    const double wavelength = 2*pi/k;
    const double d = std::sqrt(18*gasProperties::air().mu*tau/density);
    const double s = omega*tau;

    std::vector<sphere> spheres;
    for (const double place : places)
    {
        // On the periodic path
        const double x = place*wavelength;
        const double v = periodicVelocity(omega, tau, U*std::sin(k*x));
        const double off =
            U*std::sin(k*x)/omega
           *(1.0/(std::complex<double>(0, 1)*std::complex<double>(1, s)))
           .imag();

        spheres.push_back
        ({
            std::int64_t(spheres.size()), d, density, {x + off, 0, 0}, {v, 0, 0}
        });
    }

    settings law;
    law.stepping = stepping;
    law.contact = "type none;";

    experiment wave
    (
        arrays(spheres),
        vec(1.01*wavelength, 1e-3, 1e-3),
        law,
        sound<acoustics::standingWave>
        (
            "type standingWave; frequency 1400; velocityAmplitude 1;"
        )
    );

    const double h = 1/(frequency*steps);
    const int periods = 30;

    // Mean places over whole periods: what is at one phase drifts with the
    // change of the displacement there as well
    const auto meanPlaces = [&]()
    {
        vectors mean = vectors::Zero(3, wave.p.size());
        for (int n = 0; n < steps; ++n)
        {
            wave.run(h, 1);
            mean += wave.p.x/steps;
        }
        return mean;
    };

    // The transient is over after ten periods, 65 relaxation times
    wave.run(h, 10*steps);
    const vectors begin = meanPlaces();
    wave.run(h, (periods - 1)*steps);
    const vectors end = meanPlaces();

    Eigen::ArrayXd result(places.size());
    for (int i = 0; i < wave.p.size(); ++i)
    {
        const double x = 0.5*(begin(0, i) + end(0, i));
        const double theory =
           -U*U*k*std::sin(2*k*x)/(4*omega)*s/(1 + s*s);

        const double v = (end(0, i) - begin(0, i))*frequency/periods;

        measured
        (
            "%s, T/%d, x = %.4f wavelengths: drift %.5f mm/s, theory %.5f,"
            " %+.3f %%\n",
            stepping.c_str(), steps, places[i], 1e3*v, 1e3*theory,
            100*(v/theory - 1)
        );
        result(i) = v/theory;
    }

    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_P(eachTimeStepping, driftsInAStandingWaveAsTheorySays)
{
    // In all four quarters, at the fastest drift and between
    const std::vector<double> places{-0.375, -0.2, 0.06, 0.125, 0.2, 0.33};

    // Of second order in the step, the fluid step or that of the contacts
    const double coarse =
        (drift(GetParam(), 50, places) - 1).abs().maxCoeff();
    EXPECT_LT(coarse, 0.005);

    if (GetParam() != conventional)
    {
        const double fine =
            (drift(GetParam(), 100, places) - 1).abs().maxCoeff();
        EXPECT_LT(fine, 0.3*coarse);
    }
}


TEST(driftInAStandingWave, isThatOfTheExample)
{
    // U = 1 m/s at 1.4 kHz, 110 us: 0.364 mm/s at most
    const double s = omega*tau;
    EXPECT_NEAR(U*U/(4*gasProperties::air().c)*s/(1 + s*s), 0.364e-3, 1e-6);
}


// ************************************************************************* //
