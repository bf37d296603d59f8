/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "oscillatingWake.H"
#include "error.H"
#include "measured.H"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

double meanFactor(const double x)
{
    const phasor l = phasor(1, 1)*x;
    const phasor B =
        6.0/(l*l) - 2.0*std::exp(-l)*(1.0 + 3.0/l + 3.0/(l*l));

    return -2*B.imag()/(x*x);
}


} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(historyIntegral, isTheOscillatoryStokesletOfASmallAmplitude)
{
    randomNumbers from(3);

    for (const double x : {0.1, 0.5, 1.0, 2.0, 4.0})
    {
        const vec r = from.point(1).normalized()*x*delta;
        const complexVec U = randomSlip(from, 1e-4*x*omega*delta);

        // Pozrikidis, Boundary Integral and Singularity Methods, 1992, 2.6
        const phasor l = phasor(1, 1)*x;
        const phasor A =
            2.0*std::exp(-l)*(1.0 + 1.0/l + 1.0/(l*l)) - 2.0/(l*l);
        const phasor B =
            6.0/(l*l) - 2.0*std::exp(-l)*(1.0 + 3.0/l + 3.0/(l*l));
        const complexVec n = r.normalized().cast<phasor>();
        const complexVec exact =
           -0.75*radius/r.norm()*(A*U + B*n*(n.transpose()*U)(0));

        EXPECT_LT
        (
            (integrated(r, U).second - exact).norm(), 1e-4*exact.norm()
        ) << x;
    }
}


TEST(historyIntegral, hasTheMeanThatWasDerived)
{
    struct published
    {
        double x;
        double Phi;
    };

    for
    (
        const published& one :
        {
            published{0.5, 0.741}, published{1, 0.519},
            published{2, 0.223}, published{4, 0.030}
        }
    )
    {
        const double U = 0.01*omega*delta;

        for (const double theta : {0.0, 0.7, 1.5})
        {
            const vec n(std::cos(theta), std::sin(theta), 0);
            const double c = n(0);
            const double unit =
               -3.0/16*radius*U*U/nu*(3*c*c - 1)/2;

            const double Phi =
                integrated(one.x*delta*n, complexVec(U, 0, 0)).first.dot(n)
               /unit;

            EXPECT_NEAR(Phi, one.Phi, 0.0007) << one.x << ' ' << theta;
            EXPECT_NEAR(Phi, meanFactor(one.x), 2e-4) << one.x << ' ' << theta;
        }
    }
}


TEST(historyIntegral, isOseensWakeOfASteadySlip)
{
    const double U = 0.5;

    for (const double theta : {0.0, 0.3, 1.0, 2.0, 3.0, pi})
    {
        for (const double r : {10e-6, 100e-6})
        {
            const double c = std::cos(theta);
            const double s = std::sin(theta);
            const double R = r/radius;
            const double Re = 2*radius*U/nu;
            const double E = std::exp(-R*Re/4*(1 - c));

            // Without the dipole
            const double radial =
                U*(-3*(1 + c)*E/(4*R) + 3*(1 - E)/(Re*R*R));
            const double angular = U*3*s*E/(4*R);

            const vec steady(-U, 0, 0);
            const vec w = historyIntegral
            (
                r*vec(c, s, 0),
                [&](const double time) -> vec
                {
                    return time*steady;
                },
                [&](const double) -> vec
                {
                    return steady;
                },
                radius, nu, 1.0, 1e4*nu/(U*U)
            );

            const vec exact
            (
                radial*c - angular*s, radial*s + angular*c, 0
            );

            // Straight downstream the rest decays as end^-1/2
            EXPECT_LT((w - exact).norm(), 0.01*U/R) << theta << ' ' << r;
        }
    }
}


TEST(memoryWake, isTheHistoryIntegralOfASmallAmplitude)
{
    const auto code = oscillatingWake("memory", "frequency 1000; range 20;");
    randomNumbers from(7);

    for (const double x : {0.08, 0.2, 0.29, 0.31, 0.6, 1.0, 1.7, 3.0})
    {
        // Also one that goes round in an ellipse
        const vec r = from.point(1).normalized()*x*delta;
        const complexVec U =
            randomSlip(from, 0.01*std::min(x, 1.0)*omega*delta);

        const auto exact = integrated(r, U);
        const auto found = analyse
        (
            [&](const double phase) -> vec
            {
                const vec now = (U*std::polar(1.0, phase)).real();
                return disturbance(*code, r, U, phase) - dipole(r, now);
            }
        );

        const double linear = exact.second.norm();
        EXPECT_LT((found.second - exact.second).norm(), 2e-4*linear) << x;

        const double mean = exact.first.norm();
        EXPECT_LT((found.first - exact.first).norm(), 0.003*mean) << x;
    }
}


TEST(memoryWake, isStokesFlowAndOseensMeanNextToTheParticle)
{
    const auto code = oscillatingWake("memory", "frequency 1000; range 20;");
    const auto quasiSteady = wake::New(parse("type Oseen; range 20;"));
    const vec r(0.6e-6, 0.8e-6, 0.3e-6);
    const complexVec U(phasor(1e-3, 2e-3), phasor(0, 1e-3), 2e-3);
    const double a = 0.1e-6;
    const vec n = r.normalized();

    const auto found = analyse
    (
        [&](const double phase)
        {
            return disturbance(*code, r, U, phase, a);
        }
    );

    // What is missing is of the order of r/delta
    const complexVec m = n.cast<phasor>();
    const phasor along = (m.transpose()*U)(0);
    const double q = a/r.norm();
    const complexVec Stokes =
        -0.75*q*(U + along*m) - 0.25*q*q*q*(U - 3.0*along*m);
    EXPECT_LT
    (
        (found.second - Stokes).norm(), 2*r.norm()/delta*Stokes.norm()
    );

    const vec mean = analyse
    (
        [&](const double phase)
        {
            return disturbance(*quasiSteady, r, U, phase, a);
        }
    ).first;
    EXPECT_LT((found.first - mean).norm(), 2*r.norm()/delta*mean.norm());
}


TEST(memoryWake, isOffByTheSquareOfTheAmplitude)
{
    const auto code = oscillatingWake("memory", "frequency 1000; range 20;");

    measured("drift on the axis over that of the integral\n");
    measured
    (
        "%8s%10s%10s%10s%10s%10s%10s\n",
        "A/delta", "x=0.1", "0.25", "0.5", "1", "2", "4"
    );

    for (const double amplitude : {0.3, 0.6, 1.2, 2.4})
    {
        const complexVec U(amplitude*delta*omega, 0, 0);
        measured("%8.1f", amplitude);

        for (const double x : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0})
        {
            const vec r(x*delta, 0, 0);
            const double exact = integrated(r, U).first(0);
            const double found = analyse
            (
                [&](const double phase)
                {
                    return disturbance(*code, r, U, phase);
                }
            ).first(0);

            measured("%10.3f", found/exact);

            // An error of second order in the amplitude
            EXPECT_LT(std::abs(found/exact - 1), 0.2*amplitude*amplitude)
                << amplitude << ' ' << x;
        }
        measured("\n");
    }
}


TEST(memoryWake, isBelowTheToleranceOutOfRange)
{
    randomNumbers from(11);

    for (const double tolerance : {1e-4, 1e-3, 1e-2})
    {
        const auto code = oscillatingWake
        (
            "memory",
            "frequency 1000; tolerance " + std::to_string(tolerance) + ';'
        );

        for (int n = 0; n < 2000; ++n)
        {
            const double a = from.logUniform(0.3e-6, 10e-6);
            const double speed = from.logUniform(1e-3, 2);
            const double range = code->range
            (
                scalars::Constant(1, 2*a), scalars::Constant(1, speed)
            )(0);
            const vec r =
                from.point(1).normalized()
               *std::max(range, a)*from.logUniform(1.0, 20);
            const vec axis = from.point(1).normalized();
            const complexVec U = speed*axis.cast<phasor>();

            const auto found = analyse
            (
                [&](const double phase)
                {
                    return disturbance(*code, r, U, phase, a);
                }
            );

            EXPECT_LT(found.second.norm(), 1.0001*tolerance);
            EXPECT_LT(found.first.norm(), 1.0001*tolerance/(10*pi));
        }
    }
}


TEST(memoryWake, endsAfterFourLayersByDefault)
{
    auto code = oscillatingWake("memory", "", omega);
    code->setTolerance(1e-9);

    EXPECT_EQ(code->omega(), omega);
    EXPECT_TRUE(code->needsTolerance());
    EXPECT_NEAR
    (
        code->range(scalars::Constant(1, 8e-6), scalars::Constant(1, 0.4))(0),
        4*delta + 2*0.4/omega,
        1e-12
    );
}


TEST(memoryWake, refusesASoundWithoutFrequency)
{
    for (const std::string& entries : strings{"", "frequency -1; "})
    {
        EXPECT_THROW
        (
            oscillatingWake("memory", entries + "range 20;"), Foam::IOerror
        );
    }
}


TEST(memoryWake, knowsTheQuadratureOfASwingingParticle)
{
    const double u0 = 0.44;
    const gasProperties gas = gasProperties::air();

    particleArrays p = arrays
    ({
        {1, 1e-6, 2400, {0, 0, 0}, {0, 0, 0}},
        {2, 8e-6, 2400, {0, 0, 0}, {0, 0, 0}},
        {3, 20e-6, 2400, {0, 0, 0}, {0, 0, 0}}
    });

    equationOfMotion motion
    (
        parse
        (
            "drag { type Stokes; slipCorrection none; }"
            "gravity { type uniform; value (0 0 -9.81); }"
            "aggregate { type none; }"
            "wake { type memory; frequency 1000; range 20; }"
        ),
        gas,
        Eigen::Array3d::Ones()
    );
    motion.laws().refresh(p);

    // In a mean flow, which does not swing
    const vec mean(0.3, -0.2, 0);
    motion.laws().setMeanFlow(mean);

    // A parabola through three instants of the sound
    const double h = 1/frequency/200;
    const auto gasAt = [&](const double phase)
    {
        return vectors
        (
            (mean + vec(u0*std::cos(phase), 0, 0)).replicate(1, 3)
        );
    };

    for (const double phase : {0.0, 0.4, 2.0, 5.0})
    {
        const stepValues step
        {
            gasAt(phase), gasAt(phase + 0.5*omega*h), gasAt(phase + omega*h)
        };

        for (const double part : {0.0, 0.5, 1.0})
        {
            const vectors found =
                motion.wakes().imaginarySlip(p.rate, step, part, h);

            for (int i = 0; i < 3; ++i)
            {
                const double s = omega/p.rate(i);
                const phasor U =
                    u0*phasor(0, s)/phasor(1, s)
                   *std::polar(1.0, phase + part*omega*h);

                EXPECT_LT
                (
                    (found.col(i) - vec(U.imag(), 0, 0)).norm(),
                    std::pow(omega*h, 2)/10*std::abs(U)
                );
            }
        }
    }
}


// ************************************************************************* //
