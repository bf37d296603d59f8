/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Unsteady drag against exact solutions of slow flow around a sphere.

    In gas that swings, with the time factor exp(i omega t), Stokes layer
    delta, Lambda = (1 + i)a/delta and K = 6 pi mu a(1 + Lambda + Lambda^2/9),
        v/u = (K + i omega m_f)/(K + i omega m_p).

    Released at rest in gas at rest, with c the strength of the history force,
    alpha the inertia with added mass and k the rate of Stokes' drag, all per
    mass of the particle, it falls with (the transform is
    1/(s (alpha s + c sqrt(s) + k)), cut along s < 0)
        v/v_inf = 1 - 2/pi int k c exp(-q^2 t)
                              /((k - alpha q^2)^2 + c^2 q^2) dq.

\*---------------------------------------------------------------------------*/

#include "BassetDrag.H"
#include "measured.H"
#include "quiescent.H"
#include "timeSteppingTools.H"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using phasor = std::complex<double>;

const double density = 2300;

const std::vector<double> diameters{1e-6, 2e-6, 4e-6, 8e-6, 12e-6, 22e-6};
const std::vector<double> frequencies{200, 630, 2000, 6300, 20000};


phasor exactResponse(const double d, const double omega)
{
    const gasProperties gas = gasProperties::air();
    const double a = 0.5*d;
    const double volume = 4*pi/3*a*a*a;
    const phasor i(0, 1);
    const phasor Lambda = (1.0 + i)*a/std::sqrt(2*gas.nu()/omega);
    const phasor K =
        6*pi*gas.mu*a*(1.0 + Lambda + Lambda*Lambda/9.0);

    return
        (K + i*omega*volume*gas.rho)/(K + i*omega*volume*density);
}


//- Those of all sizes, in gas that swings along x with unit amplitude
std::vector<phasor> responses
(
    settings law,
    const double f,
    const int steps
)
{
    const double omega = 2*pi*f;

    law.unsteadyDrag += " frequencies (" + std::to_string(0.1*f) + " "
      + std::to_string(20*f) + ");";

    std::vector<sphere> spheres;
    for (const double d : diameters)
    {
        const int n = static_cast<int>(spheres.size());

        // On its path in the end, but for what is left of the beginning
        spheres.push_back
        ({
            n, d, density, {0, 1e-3*n, 0},
            {exactResponse(d, omega).imag(), 0, 0}
        });
    }

    experiment e(arrays(spheres), 10e-3, law, f, vec(1, 0, 0));

    const double h = 1/(f*steps);

    // The slowest transients take milliseconds, longer than this: over few
    // periods they are lines, which are taken off
    const int begin = 40;
    const int periods = 4;
    const int n = periods*steps;

    for (int s = 0; s < begin*steps; ++s)
    {
        e.run(h, 1);
    }

    Eigen::MatrixXd basis(n, 5);
    Eigen::MatrixXd v(n, diameters.size());

    for (int s = 0; s < n; ++s)
    {
        e.run(h, 1);

        const double time = double(s)/n;
        basis.row(s)
            << 1, time, time*time, std::cos(omega*e.t), std::sin(omega*e.t);
        v.row(s) = e.p.v.row(0);
    }

    const Eigen::MatrixXd fit = basis.colPivHouseholderQr().solve(v);

    std::vector<phasor> result;
    for (int i = 0; i < fit.cols(); ++i)
    {
        // u = sin(omega t)
        result.push_back(phasor(fit(4, i), fit(3, i)));
    }

    return result;
}


settings unsteadyLaw(const std::string& stepping)
{
    settings law;
    law.stepping = stepping;
    law.contact = "type none;";
    law.unsteadyDrag = "type Basset;";
    return law;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(BassetDrag, hasTheKernelBetweenItsFrequencies)
{
    for (const double ratio : {10.0, 30.0, 200.0, 1e3, 1e4, 1e6})
    {
        std::ostringstream text;
        text<< "type Basset; frequencies (50 " << 50*ratio << ");";

        const BassetDrag drag(parse(text.str()), 0);

        double worst = 0;
        for (double f = 50; f <= 50*ratio; f *= 1.01)
        {
            const double omega = 2*pi*f;

            worst = std::max
            (
                worst,
                std::abs
                (
                    drag.transform(omega)*std::sqrt(phasor(0, omega)/pi) - 1.0
                )
            );
        }

        measured
        (
            "%.0f: %d exponentials, off by %.2f %%\n",
            ratio, int(drag.times().size()), 100*worst
        );

        EXPECT_LT(worst, 5e-3) << ratio;
        EXPECT_GT(drag.amplitudes().minCoeff(), 0) << ratio;
    }
}


TEST(unsteadyDrag, hasTheResponseOfSlowFlow)
{
    struct strategy
    {
        const char* name;
        std::string text;
        int steps;
    };

    const std::vector<strategy> strategies
    {
        {"eventDriven", eventDriven, 50},
        {"eventDriven", eventDriven, 100},
        {"multipleTimeStep", "type multipleTimeStep; kp 1; kc 1;", 100}
    };

    for (const strategy& one : strategies)
    {
        double amplitude = 0;
        double phase = 0;
        double Stokes = 0;

        for (const double f : frequencies)
        {
            const std::vector<phasor> response =
                responses(unsteadyLaw(one.text), f, one.steps);

            for (std::size_t i = 0; i < diameters.size(); ++i)
            {
                const double omega = 2*pi*f;
                const double d = diameters[i];
                const phasor exact = exactResponse(d, omega);
                const phasor off = response[i]/exact;

                measured
                (
                    "%s, T/%d, %.0f Hz, %.0f um: %.5f, %+.3f %%, %+.4f deg\n",
                    one.name, one.steps, f, 1e6*d, std::abs(exact),
                    100*(std::abs(off) - 1), 180/pi*std::arg(off)
                );

                amplitude = std::max(amplitude, std::abs(std::abs(off) - 1));
                phase = std::max(phase, std::abs(std::arg(off)));

                const phasor slow
                (
                    1, omega*relaxationTime(d, density)
                );
                Stokes = std::max(Stokes, 1 - 1/std::abs(exact*slow));
            }
        }

        measured
        (
            "%s, T/%d: amplitude within %.3f %%, phase within %.3f %% of a"
            " radian (Stokes' drag alone: %.0f %%)\n",
            one.name, one.steps, 100*amplitude, 100*phase, 100*Stokes
        );

        EXPECT_LT(amplitude, 5e-3);
        EXPECT_LT(phase, 5e-3);
        EXPECT_GT(Stokes, 0.4);
    }
}


// ************************************************************************* //
