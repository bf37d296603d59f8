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
#include "error.H"
#include "measured.H"
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


//- Those of all sizes, in gas that swings along x with the amplitude u
std::vector<phasor> responses
(
    settings law,
    const double f,
    const int steps,
    const double u
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
            {u*exactResponse(d, omega).imag(), 0, 0}
        });
    }

    experiment e(arrays(spheres), 10e-3, law, f, vec(u, 0, 0));

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
        // Of gas with u sin(omega t)
        result.push_back(phasor(fit(4, i), fit(3, i))/u);
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
        double lowest = 0;
    };

    const std::vector<strategy> strategies
    {
        {"eventDriven", eventDriven, 50},
        {"eventDriven", eventDriven, 100},
        {"multipleTimeStep", "type multipleTimeStep; kp 1; kc 1;", 100},
        {"conventional", "type conventional; kc 1;", 100, 6000}
    };

    for (const strategy& one : strategies)
    {
        double amplitude = 0;
        double phase = 0;
        double Stokes = 0;

        for (const double f : frequencies)
        {
            // Steps of a diameter take their time
            if (f < one.lowest)
            {
                continue;
            }

            const std::vector<phasor> response =
                responses(unsteadyLaw(one.text), f, one.steps, 1);

            for (std::size_t i = 0; i < diameters.size(); ++i)
            {
                const double omega = 2*pi*f;
                const double d = diameters[i];
                const phasor exact = exactResponse(d, omega);
                const phasor off = response[i]/exact;

                // That of Stokes' drag alone
                const phasor slow =
                    1.0/phasor(1, omega*relaxationTime(d, density))/exact;

                measured
                (
                    "%s, T/%d, %.0f Hz, %.0f um: %.5f, %+.3f %%, %+.4f deg;"
                    " Stokes %+.1f %%, %+.1f deg\n",
                    one.name, one.steps, f, 1e6*d, std::abs(exact),
                    100*(std::abs(off) - 1), 180/pi*std::arg(off),
                    100*(std::abs(slow) - 1), 180/pi*std::arg(slow)
                );

                amplitude = std::max(amplitude, std::abs(std::abs(off) - 1));
                phase = std::max(phase, std::abs(std::arg(off)));
                Stokes = std::max(Stokes, 1 - std::abs(slow));
            }
        }

        measured
        (
            "%s, T/%d: amplitude within %.3f %%, phase within %.3f %% of a"
            " radian (Stokes' drag alone: %.0f %%)\n",
            one.name, one.steps, 100*amplitude, 100*phase, 100*Stokes
        );

        EXPECT_LT(amplitude, 1e-3);
        EXPECT_LT(phase, 1e-3);
        EXPECT_GT(Stokes, 0.4);
    }
}


TEST(unsteadyDrag, isTheSameWhereDragIsNearlyLinear)
{
    const double f = 2000;
    const double omega = 2*pi*f;

    // At these Reynolds numbers drag is that of Stokes, but for 1e-5
    settings law = unsteadyLaw(eventDriven);
    law.drag = "type SchillerNaumann; slipCorrection none;";

    const std::vector<phasor> response = responses(law, f, 50, 1e-6);

    for (std::size_t i = 0; i < diameters.size(); ++i)
    {
        const phasor off = response[i]/exactResponse(diameters[i], omega);

        EXPECT_LT(std::abs(off - 1.0), 1e-3) << diameters[i];
    }
}


TEST(unsteadyDrag, settlesAsTheExactSolution)
{
    const gasProperties gas = gasProperties::air();
    const double d = 20e-6;

    // The latter as light as a bubble of glass, for which history counts
    for (const double solid : {2300.0, 50.0})
    {
        const double tau = relaxationTime(d, solid);
        const double share = gas.rho/solid;
        const double k = 1/tau;
        const double alpha = 1 + 0.5*share;
        const double c = std::sqrt(4.5*share*k);
        const double g = 9.81*(1 - share);

        // Of exp(-q^2 t), by Simpson's rule
        const auto exact = [&](const double t)
        {
            const int n = 200000;
            const double most = 200*std::sqrt(k);
            double sum = 0;

            for (int j = 0; j <= n; ++j)
            {
                const double q = j*most/n;
                const double r = k - alpha*q*q;

                sum +=
                    (j == 0 || j == n ? 1 : j % 2 ? 4 : 2)
                   *k*c*std::exp(-q*q*t)/(r*r + c*c*q*q);
            }

            return g*tau*(1 - 2/pi*sum*most/n/3);
        };

        settings law = unsteadyLaw(eventDriven);
        law.gravity = "type uniform; value (0 0 -9.81);";

        std::ostringstream text;
        text<< "type Basset; frequencies (" << 2e-3/tau << " " << 20/tau
            << ");";
        law.unsteadyDrag = text.str();

        experiment e(arrays({{0, d, solid, {0, 0, 0}, {0, 0, 0}}}), 10e-3, law);

        const int steps = 20;
        double worst = 0;

        for (const int taus : {1, 1, 1, 2, 5, 10})
        {
            e.run(tau/steps, taus*steps);

            const double off = -e.p.v(2, 0)/exact(e.t) - 1;

            measured
            (
                "%.0f kg/m3, %2.0f tau: %.4f of the end, %+.3f %% (Stokes'"
                " drag alone: %.4f)\n",
                solid, e.t/tau, exact(e.t)/(g*tau), 100*off,
                -std::expm1(-e.t/tau)
            );

            worst = std::max(worst, std::abs(off));
        }

        EXPECT_LT(worst, 5e-4) << solid;
    }
}


TEST(unsteadyDrag, isThatOfTheDriftInBrownianMotion)
{
    vectors drifts[2];

    for (const bool Brownian : {false, true})
    {
        settings law = unsteadyLaw(eventDriven);
        law.unsteadyDrag += " frequencies (140 28000);";

        if (Brownian)
        {
            law.Brownian = "type OrnsteinUhlenbeck;";
        }

        experiment e
        (
            arrays
            ({
                {0, 0.5e-6, density, {0, 0, 0}, {0, 0, 0}},
                {1, 10e-6, density, {0, 1e-3, 0}, {0, 0, 0}}
            }),
            10e-3, law, 1400, vec(1, 0, 0)
        );
        e.run(1/(1400*50.0), 75);

        drifts[Brownian] = e.p.v - e.p.thermal;
    }

    EXPECT_LT((drifts[1] - drifts[0]).norm(), 1e-12);
    EXPECT_GT(drifts[0].norm(), 0.1);
}


TEST(unsteadyDrag, hasOneHistoryForTwoThatMerge)
{
    for (const std::string& stepping : {eventDriven, multipleTimeStep})
    {
        settings law = unsteadyLaw(stepping);
        law.unsteadyDrag += " frequencies (140 28000);";
        law.contact = "type recordedStick;";

        const std::vector<sphere> two
        {
            {0, 5e-6, density, {0, 0, 0}, {0, 0, 0}},
            {1, 8e-6, density, {10e-6, 0, 0}, {0, 0, 0}}
        };

        experiment e(arrays(two), 1e-3, law, 1400, vec(1, 0, 0));

        // What both had before; apart, nothing of it would change in a step
        // but by the step itself
        law.contact = "type none;";
        experiment apart(arrays(two), 1e-3, law, 1400, vec(1, 0, 0));

        const double h = 1/(1400*100.0);

        while (e.p.size() == 2 && e.step < 100)
        {
            e.run(h, 1);
            apart.run(h, 1);
        }

        ASSERT_EQ(e.p.size(), 1);
        EXPECT_GT(e.step, 2);

        const Eigen::VectorXd sum =
            apart.p.history*apart.p.m.matrix()/apart.p.m.sum();

        // Without its first number, the length of the step
        const double off =
            (e.p.history.col(0) - sum).tail(sum.size() - 1).norm()
           /sum.tail(sum.size() - 1).norm();

        measured("off by %.0e\n", off);

        EXPECT_LT(off, 1e-12);
        EXPECT_EQ(e.p.history(0, 0), h);

        // No jump in what follows: of the order of what it was before
        const double before = apart.p.unsteady.col(1).norm();
        e.run(h, 1);
        EXPECT_LT(e.p.unsteady.col(0).norm(), 2*before);
    }
}


TEST(unsteadyDrag, isCarriedAlongWithTheParticle)
{
    const auto make = [](const int n)
    {
        particleArrays p;
        p.resizeHistory(7);
        p.resize(n);
        p.resizeLaws();
        p.rate.setOnes();
        p.range.setOnes();
        p.mobilityDiameter.setOnes();
        p.collisionDiameter.setOnes();
        p.acceleration.setOnes();
        p.x.setOnes();
        p.v.setOnes();
        p.d.setOnes();
        p.m.setOnes();
        p.primaries.setOnes();

        for (int i = 0; i < n; ++i)
        {
            p.id(i) = i;
            p.history.col(i).setLinSpaced(10*i, 10*i + 6);
            p.unsteady.col(i).setConstant(-i);
        }
        return p;
    };

    const auto expectOwn = [](const particleArrays& p)
    {
        ASSERT_EQ(p.history.cols(), p.size());
        ASSERT_EQ(p.unsteady.cols(), p.size());

        for (int i = 0; i < p.size(); ++i)
        {
            EXPECT_EQ(p.history(6, i), 10*p.id(i) + 6);
            EXPECT_EQ(p.unsteady(2, i), -p.id(i));
        }
    };

    const particleArrays p = make(5);

    expectOwn(p.select({3, 1}));

    particleArrays q = p;
    q.reorder({4, 2, 0, 1, 3});
    expectOwn(q);
    q.remove({0, 1, 0, 0, 0});
    EXPECT_EQ(q.size(), 4);
    expectOwn(q);

    // The pieces of one that breaks
    q = p;
    q.replace(2, p.select({2, 2}));
    EXPECT_EQ(q.size(), 6);
    expectOwn(q);

    std::vector<double> numbers(p.packedNumbers());
    p.pack(3, numbers.data());
    q = make(1);
    q.unpack(0, numbers.data());
    EXPECT_EQ(q.id(0), 3);
    expectOwn(q);

    // Nothing of it without unsteady drag
    particleArrays none;
    none.resize(2);
    EXPECT_EQ(none.packedNumbers(), particleArrays::nNumbers);
    EXPECT_EQ(none.unsteady.cols(), 0);
    EXPECT_EQ(none.history.size(), 0);
}


TEST(unsteadyDrag, refusesWhatMakesNoSense)
{
    const auto make = [](const std::string& text, const double frequency)
    {
        unsteadyDrag::New(parse("unsteadyDrag {" + text + "}"), frequency);
    };

    EXPECT_NO_THROW(make("type Basset;", 1400));
    EXPECT_NO_THROW(make("type Basset; frequencies (10 100);", 0));
    EXPECT_NO_THROW(make("type none;", 0));

    for
    (
        const std::string& text :
        strings
        {
            "type Basset;",
            "type Basset; frequencies (100 10);",
            "type Basset; frequencies (10 99);",
            "type Basset; frequencies (0 100);",
            "type Basset; frequencies (-10 100);",
            "type Basset; frequencies 100;",
            "type Basset; frequencies (10 100 1000);",
            "type Basset; terms 5;",
            "type Boussinesq;",
            "type none; frequencies (10 100);"
        }
    )
    {
        EXPECT_THROW(make(text, 0), IOerror) << text;
    }

    EXPECT_FALSE(unsteadyDrag::New(dictionary(), 0)->nHistory());
}


// ************************************************************************* //
