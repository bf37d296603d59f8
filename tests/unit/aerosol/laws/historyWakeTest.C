/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "oscillatingWake.H"
#include "measured.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

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
            r, complexVec(-U/phasor(0, omega)), phase, omega, radius, nu
        )
      + dipole(r, (U*std::polar(1.0, phase)).real());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(historyWake, isTheIntegralOfAnyAmplitude)
{
    const auto code = oscillatingWake("history", "frequency 1000; range 20;");
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
                        (r + 0.3*x*delta*from.point(1)).cast<phasor>()
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
    const auto code = oscillatingWake("history", "frequency 1000; range 20;");

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
                EXPECT_NEAR(found/exact, 1, 0.01)
                    << theta << ' ' << amplitude << ' ' << x;
            }
            measured("\n");
        }
    }
}


TEST(historyWake, isOseensWakeAsTheFrequencyGoesToZero)
{
    const auto Oseen = wake::New(parse("type Oseen; range 20;"));
    const complexVec U(0.3, phasor(0, 0.2), 0.1);
    const double Stokeslet = 0.75*radius*U.norm();

    double before = 1;

    for (const char* const slow : {"100", "1", "0.01"})
    {
        const auto code = oscillatingWake
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
    const auto code = oscillatingWake("history", "frequency 1000; range 20;");
    const complexVec U(0.3, phasor(0, 0.2), 0.1);
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
    randomNumbers from(13);
    int nTried = 0;

    for (const double tolerance : {1e-3, 1e-2, 5e-2})
    {
        const auto code = oscillatingWake
        (
            "history",
            "frequency 1000; tolerance " + std::to_string(tolerance) + ';'
        );

        for (int n = 0; n < 60; ++n)
        {
            const double speed = from.logUniform(0.03, 4);
            const double range = code->range
            (
                scalars::Constant(1, 2*radius), scalars::Constant(1, speed)
            )(0);

            if (range > 0.999*(4*delta + 2*speed/omega))
            {
                continue;
            }

            // In line it is largest
            const vec r =
                from.point(1).normalized()*range*from.logUniform(1.0, 1.2);
            const vec axis =
                (r.normalized() + 0.2*from.point(1)).normalized();
            const auto exact = integrated(r, speed*axis.cast<phasor>());

            // But for the dipole of the particle's size
            const double size = std::pow(radius/r.norm(), 3)*speed;
            EXPECT_LT(exact.second.norm(), 1.0001*tolerance + size);
            EXPECT_LT(exact.first.norm(), 1.0001*tolerance/(10*pi))
                << range/delta << ' ' << speed/omega/delta;
            ++nTried;
        }
    }

    EXPECT_GT(nTried, 50);
}


TEST(historyWake, endsWhereLittleIsLeft)
{
    const auto code = oscillatingWake("history", "range 50;", omega);
    randomNumbers from(17);

    measured("left out, of the drift of Oseen next to the particle\n");
    measured("%8s%14s%14s\n", "A/delta", "both swing", "one at rest");

    for (const double amplitude : {0.1, 0.5, 1.0, 2.0, 4.0})
    {
        const double speed = amplitude*delta*omega;
        const double unit = 3.0/16*radius*speed*speed/nu;
        std::array<double, 2> largest{0, 0};
        std::array<int, 2> nFar{0, 0};

        for (int n = 0; n < 48; ++n)
        {
            const vec axis = from.point(1).normalized();
            const vec mean =
                from.point(1).normalized()
               *from.logUniform(2.5*delta, 5*delta + 2*speed/omega);
            const bool bothSwing = n % 2;
            constexpr int nPhases = 8;
            double least = 1;
            double most = 0;
            vec drift = vec::Zero();

            for (int k = 0; k < nPhases; ++k)
            {
                const complexVec U =
                    speed*std::polar(1.0, 2*pi*k/nPhases)
                   *axis.cast<phasor>();
                const double other = bothSwing ? 1 : 0;
                vectors P(3, 2);
                vectors Q(3, 2);
                P << U.real(), other*U.real();
                Q << U.imag(), other*U.imag();

                // Of the source from its mean place
                const vec r =
                    bothSwing ? mean : vec(mean + U.imag()/omega);
                const auto paths = code->paths(P, Q);

                const double share = paths[0].share(r.data(), paths[1]);

                least = std::min(least, share);
                most = std::max(most, share);
                drift += (1 - share)*exactly(r, U, 0)/nPhases;
            }

            // It does not come and go
            EXPECT_LT(most - least, 1e-9) << amplitude;

            largest[bothSwing] =
                std::max(largest[bothSwing], drift.norm()/unit);
            nFar[bothSwing] += most == 0;
        }

        measured("%8g%14.4f%14.4f\n", amplitude, largest[1], largest[0]);
        EXPECT_GT(std::min(nFar[0], nFar[1]), 5);
        EXPECT_LT(largest[0], 0.03);
        EXPECT_LT(largest[1], 0.03);
    }
}


TEST(historyWake, isAppliedToThePairsThatAreNear)
{
    equationOfMotion motion
    (
        parse
        (
            "drag { type Stokes; slipCorrection none; }"
            "gravity { type none; } aggregate { type none; }"
            "wake { type history; frequency 1000; range 200; }"
        ),
        gasProperties::air(),
        Eigen::Array3d::Constant(GREAT)
    );
    const wake& code = motion.laws().wakeModel();

    constexpr int n = 30;
    randomNumbers from(23);
    wakeInteraction::sources all
    {
        vectors(3, n), vectors(3, n), scalars::Constant(n, 2*radius),
        scalars::Constant(n, GREAT), vectors::Zero(3, n), vectors(3, n)
    };
    std::vector<particlePair> pairs;

    for (int j = 0; j < n; ++j)
    {
        const complexVec U =
            randomSlip(from, from.logUniform(0.1, 3)*delta*omega);
        all.x.col(j) = 6*delta*from.point(1);
        all.slip.col(j) = U.real();
        all.imaginary.col(j) = U.imag();

        for (int i = 0; i < n; ++i)
        {
            if (i != j)
            {
                pairs.push_back(particlePair{i, j, {0, 0, 0}});
            }
        }
    }

    vectors found;
    motion.wakes().sum(all, pairs, n, found);

    const auto paths = code.paths(all.slip, all.imaginary);
    int nNear = 0;

    for (int i = 0; i < n; ++i)
    {
        vec sum = vec::Zero();

        for (int j = 0; j < n; ++j)
        {
            const vec r = all.x.col(i) - all.x.col(j);
            const double share =
                i == j ? 0 : paths[j].share(r.data(), paths[i]);

            if (share > 0)
            {
                const complexVec U =
                    all.slip.col(j).cast<phasor>()
                  + phasor(0, 1)*all.imaginary.col(j).cast<phasor>();
                sum += share*disturbance(code, r, U);
                ++nNear;
            }
        }

        EXPECT_LT((found.col(i) - sum).norm(), 1e-9) << i;
    }

    EXPECT_GT(nNear, 100);
    EXPECT_LT(nNear, n*(n - 1) - 100);
}


TEST(wakesOfSound, takeSettlingForWhatHasAlwaysBeen)
{
    const auto Oseen = wake::New(parse("type Oseen; range 20;"));
    const vec r(30e-6, 10e-6, -20e-6);
    const vec settling(0, 0, 5e-3);
    const complexVec U(0.3, phasor(0, 0.2), 0.1);

    for (const std::string& type : strings{"memory", "history"})
    {
        const auto code = oscillatingWake(type, "frequency 1000; range 20;");
        const vec alone =
            disturbance
            (
                *code, r, complexVec::Zero(), 0, radius, settling
            );
        const vec exact =
            disturbance(*Oseen, r, settling.cast<phasor>());

        EXPECT_LT((alone - exact).norm(), 1e-6*exact.norm()) << type;

        // Beside a swing it adds to that
        const vec more =
            disturbance(*code, r, U, 0, radius, settling)
          - disturbance(*code, r, U);

        EXPECT_LT((more - exact).norm(), 1e-4*exact.norm()) << type;
    }
}


TEST(wakesOfSound, letAPairFallAsInOseensWake)
{
    const auto fallen = [](const std::string& wake, const std::string& stepping)
    {
        settings s;
        s.wake =
            "type " + wake + (wake == "none" ? ";" : "; range 60;");
        s.stepping = stepping;
        s.gravity = "type uniform; value (0 0 -9.81);";

        const double tau = relaxationTime(8e-6, 2400);
        const vec v(0, 0, -9.81*tau);

        experiment pair
        (
            arrays
            ({
                {1, 8e-6, 2400, {0, 0, 0}, v},
                {2, 5e-6, 2400, {20e-6, 0, 30e-6}, v*25/64.0}
            }),
            0.01, s, frequency, {0, 0, 0}
        );
        pair.run(1/frequency/50, 500);

        return vec(pair.p.x.col(1) - pair.p.x.col(0));
    };

    for
    (
        const std::string& stepping :
        {eventDriven, std::string("type multipleTimeStep; kc 0.01; kp 1;")}
    )
    {
        const vec exact = fallen("Oseen", stepping);
        const vec alone = fallen("none", stepping);
        ASSERT_GT((exact - alone).norm(), 1e-7);

        // But for their answers to one another's wake, which are taken for a
        // swing
        for (const std::string& wake : strings{"memory", "history"})
        {
            EXPECT_LT
            (
                (fallen(wake + "; frequency 1000", stepping) - exact).norm(),
                0.05*(exact - alone).norm()
            ) << wake;
        }
    }
}


// ************************************************************************* //
