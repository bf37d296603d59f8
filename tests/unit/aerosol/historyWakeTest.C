/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "swingingWake.H"
#include "measured.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- The integral for the slip U exp(i phase), with the dipole of the size
vec exactly(const vec& r, const complexVec& U, const double phase)
{
    return
        oscillatingHistory
        (
            r, complexVec(-U/complex(0, omega)), phase, omega, radius, nu
        )
      + dipole(r, (U*std::polar(1.0, phase)).real());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(historyWake, isTheIntegralOfAnyAmplitude)
{
    const auto code = swingingWake("history", "frequency 1000; range 20;");
    randomNumbers from(5);

    measured("error over the Stokeslet of the amplitude\n");
    measured
    (
        "%8s%12s%10s%12s%10s\n",
        "A/delta", "lines: rms", "largest", "circles: rms", "largest"
    );

    for (const double amplitude : {0.01, 0.3, 1.0, 2.0, 3.0, 4.0})
    {
        measured("%8g", amplitude);

        for (const bool straight : {true, false})
        {
            double sum = 0;
            double largest = 0;
            constexpr int n = 100;

            for (int k = 0; k < n; ++k)
            {
                const double x = from.logUniform(0.06, 6);
                const vec r = from.point(1).normalized()*x*delta;

                // Towards the other one, more or less
                complexVec U =
                    straight
                  ? complexVec
                    (
                        (r + 0.3*x*delta*from.point(1)).cast<complex>()
                    )
                  : randomSlip(from, 1);
                U *= amplitude*delta*omega/U.norm();

                const double phase = 2*pi*k/n;
                const double error =
                    (
                        disturbance(*code, r, U, phase)
                      - exactly(r, U, phase)
                    ).norm()
                   /(0.75*radius/r.norm()*U.norm());

                sum += error*error;
                largest = std::max(largest, error);
            }

            const double rms = std::sqrt(sum/n);
            measured("%12.4f%10.4f", rms, largest);
            EXPECT_LT(rms, straight ? 0.03 : 0.06) << amplitude;
            EXPECT_LT(largest, straight ? 0.12 : 0.2) << amplitude;
        }
        measured("\n");
    }
}


TEST(historyWake, hasTheMeanOfTheIntegral)
{
    const auto code = swingingWake("history", "frequency 1000; range 20;");

    measured("drift along the line of centres over that of the integral\n");
    measured
    (
        "%8s%8s%10s%10s%10s%10s%10s%10s\n",
        "theta", "A/delta", "x=0.1", "0.25", "0.5", "1", "2", "4"
    );

    for (const double theta : {0.0, 1.2})
    {
        const vec n(std::cos(theta), std::sin(theta), 0);

        for (const double amplitude : {0.3, 0.6, 1.2, 2.4, 3.9})
        {
            const complexVec U(amplitude*delta*omega, 0, 0);
            measured("%8.1f%8.1f", theta, amplitude);

            for (const double x : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0})
            {
                const vec r = x*delta*n;
                const double exact = integrated(r, U).first.dot(n);
                const double found = analyse
                (
                    [&](const double phase)
                    {
                        return disturbance(*code, r, U, phase);
                    }
                ).first.dot(n);

                measured("%10.3f", found/exact);
                EXPECT_NEAR(found/exact, 1, x < 3 ? 0.01 : 0.05)
                    << theta << ' ' << amplitude << ' ' << x;
            }
            measured("\n");
        }
    }
}


TEST(historyWake, isOseensWakeAsTheFrequencyGoesToZero)
{
    const auto Oseen = wake::New(parse("type Oseen; range 20;"));
    const complexVec U(0.3, complex(0, 0.2), 0.1);
    const double Stokeslet = 0.75*radius*U.norm();

    double before = 1;

    for (const char* const slow : {"100", "1", "0.01"})
    {
        const auto code = swingingWake
        (
            "history", std::string("range 20; frequency ") + slow + ';'
        );
        randomNumbers from(2);
        double largest = 0;

        for (int k = 0; k < 100; ++k)
        {
            const vec r =
                from.point(1).normalized()*from.logUniform(1e-5, 1e-4);
            const vec difference =
                disturbance(*code, r, U, 0.1*k)
              - disturbance(*Oseen, r, U, 0.1*k);

            largest = std::max
            (
                largest, difference.norm()*r.norm()/Stokeslet
            );
        }

        measured("%s Hz: %g\n", slow, largest);
        EXPECT_LT(largest, before);
        before = 0.2*largest;
    }

    EXPECT_LT(before, 0.002);
}


TEST(historyWake, isTheValueAtTheSurfaceWithin)
{
    const auto code = swingingWake("history", "frequency 1000; range 20;");
    const complexVec U(0.3, complex(0, 0.2), 0.1);
    const vec n = vec(1, 2, 3).normalized();

    EXPECT_LT
    (
        (
            disturbance(*code, 0.2*radius*n, U)
          - disturbance(*code, radius*n, U)
        ).norm(),
        1e-12
    );
}


TEST(historyWake, isBelowTheToleranceOutOfRange)
{
    // What is left out of the integral itself. Where nothing is left of a
    // period's vorticity it ends with any tolerance.
    const double tolerance = 1e-3;
    const auto code = swingingWake
    (
        "history", "frequency 1000; tolerance " + std::to_string(tolerance)
      + ';'
    );
    randomNumbers from(13);
    int nTried = 0;

    for (int n = 0; n < 200; ++n)
    {
        const double speed = from.logUniform(0.03, 2);
        const double range = code->range
        (
            scalars::Constant(1, 2*radius), scalars::Constant(1, speed)
        )(0);

        if (range > 0.999*(4*delta + 2*speed/omega))
        {
            continue;
        }

        const vec r =
            from.point(1).normalized()*range*from.logUniform(1.0, 3);
        const vec axis = from.point(1).normalized();
        const auto exact = integrated(r, speed*axis.cast<complex>());

        // But for the dipole of the particle's size
        const double size = std::pow(radius/r.norm(), 3)*speed;
        EXPECT_LT(exact.second.norm(), 1.0001*tolerance + size);
        EXPECT_LT(exact.first.norm(), 1.0001*tolerance/(10*pi));
        ++nTried;
    }

    EXPECT_GT(nTried, 40);
}


TEST(historyWake, isLittleFarFromThePath)
{
    auto code = swingingWake("history", "", omega);
    code->setTolerance(1e-9);
    randomNumbers from(17);

    double drift = 0;
    double swing = 0;
    int nFar = 0;

    for (int n = 0; n < 400; ++n)
    {
        const double amplitude = from.logUniform(0.1, 4);
        const double speed = amplitude*delta*omega;
        const vec r =
            from.point(1).normalized()
           *from.logUniform(2*delta, 4*delta + 2*speed/omega);
        const complexVec U =
            n % 2
          ? randomSlip(from, speed)
          : complexVec
            (
                speed*std::polar(1.0, from.logUniform(1, 2*pi + 1))
               *from.point(1).normalized().cast<complex>()
            );
        const vec P = U.real();
        const vec Q = U.imag();
        const auto place = [&](const double phase) -> vec
        {
            return (P*std::sin(phase) + Q*(1 - std::cos(phase)))/omega;
        };

        double distance = GREAT;

        for (int k = 0; k < 400; ++k)
        {
            distance = std::min(distance, (r - place(2*pi*k/400)).norm());
        }

        const bool near = code->paths(P, Q)[0].isNear(r.data());

        // It is an upper bound of the reach
        EXPECT_TRUE(near || distance > 3.99*delta);
        EXPECT_TRUE(!near || distance < 8*delta);

        if (!near)
        {
            const vec w = exactly(r, U, 0);
            swing = std::max(swing, w.norm()*r.norm()/(0.75*radius*speed));

            // Over what two of a kind that nearly touch have
            if (n % 2 == 0)
            {
                drift = std::max
                (
                    drift,
                    integrated(r, U).first.norm()
                   /(3.0/16*radius*speed*speed/nu)
                );
            }
            ++nFar;
        }
    }

    measured
    (
        "%d far: at most %.3f of the Stokeslet, drift %.4f of Oseen's\n",
        nFar, swing, drift
    );
    EXPECT_GT(nFar, 50);
    EXPECT_LT(swing, 0.25);
    EXPECT_LT(drift, 0.03);
}


// ************************************************************************* //
