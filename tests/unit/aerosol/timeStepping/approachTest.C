/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "historyIntegral.H"
#include "measured.H"
#include "timeSteppingTools.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Time of contact of a pair that an experiment brings together; 0 if it
//  does not within the given time
double contactTime(experiment& pair, const double h, const double latest)
{
    while (meetings.empty() && pair.t < latest)
    {
        pair.run(h, 1);
    }

    return meetings.empty() ? 0 : meetings[0].time;
}


//- The pair of two-particle experiments in the literature: 8 um glass at 0.44
//  m/s, aligned with the sound, on the periodic path of isolated particles
const double pairDiameter = 8e-6;
const double pairDensity = 2400;
const double pairSpeed = 0.44;

double steppedPair
(
    const double frequency,
    const double distance,
    const int stepsPerPeriod,
    const std::string& stepping,
    const std::string& wake = "type Oseen; range 60;",
    const double speed = pairSpeed
)
{
    const vec v
    (
        periodicVelocity
        (
            2*pi*frequency,
            relaxationTime(pairDiameter, pairDensity),
            speed
        ),
        0,
        0
    );

    settings s;
    s.wake = wake;
    s.stepping = stepping;

    experiment pair
    (
        arrays
        ({
            {1, pairDiameter, pairDensity, {-0.5*distance, 0, 0}, v},
            {2, pairDiameter, pairDensity, {0.5*distance, 0, 0}, v}
        }),
        0.01,
        s,
        frequency,
        {speed, 0, 0}
    );

    return contactTime(pair, 1/frequency/stepsPerPeriod, 0.05);
}


//- The same by the classical Runge-Kutta method for velocities along the
//  line, with or without the dipole that matters next to the sphere only; if
//  wanted in a gas whose velocity follows straight lines between samples
double integratedPair
(
    const double frequency,
    const double distance,
    const bool dipole,
    const int samplesPerPeriod = 0
)
{
    const double nu = gasProperties::air().nu();
    const double a = 0.5*pairDiameter;
    const double tau = relaxationTime(pairDiameter, pairDensity);
    const double omega = 2*pi*frequency;

    const auto wake = [&](const double r, const double slip)
    {
        if (slip == 0)
        {
            return 0.0;
        }

        const double R = std::abs(r)/a;
        const double Re = 2*a*std::abs(slip)/nu;
        const bool downstream = (r > 0) == (slip > 0);
        const double near = dipole ? 0.5/(R*R*R) : 0;

        // Outward on the upstream side, towards the source downstream
        const double outward =
            downstream
          ? near - 1.5/R
          : -near - 3/(Re*R*R)*std::expm1(-0.5*R*Re);

        return std::abs(slip)*(r > 0 ? outward : -outward);
    };

    const auto gas = [&](const double t)
    {
        if (!samplesPerPeriod)
        {
            return pairSpeed*std::sin(omega*t);
        }

        const double interval = 1/frequency/samplesPerPeriod;
        const double begin = interval*std::floor(t/interval);
        const double share = (t - begin)/interval;

        return
            pairSpeed
           *(
                (1 - share)*std::sin(omega*begin)
              + share*std::sin(omega*(begin + interval))
            );
    };

    using state = Eigen::Vector4d;

    const auto rate = [&](const double t, const state& y)
    {
        const double u = gas(t);
        const double r = y(1) - y(0);

        return state
        (
            y(2),
            y(3),
            (u + wake(-r, u - y(3)) - y(2))/tau,
            (u + wake(r, u - y(2)) - y(3))/tau
        );
    };

    const double v = periodicVelocity(omega, tau, pairSpeed);
    state y(0, distance, v, v);

    const double h = 1/frequency/400;
    double t = 0;

    while (t < 0.05)
    {
        const state k1 = rate(t, y);
        const state k2 = rate(t + 0.5*h, y + 0.5*h*k1);
        const state k3 = rate(t + 0.5*h, y + 0.5*h*k2);
        const state k4 = rate(t + h, y + h*k3);
        const state next = y + h/6*(k1 + 2*k2 + 2*k3 + k4);

        const double gap = y(1) - y(0) - pairDiameter;
        const double nextGap = next(1) - next(0) - pairDiameter;

        if (nextGap <= 0)
        {
            return t + h*gap/(gap - nextGap);
        }

        y = next;
        t += h;
    }

    return 0;
}


//- The same with the integral over all that the particles have done in the gas
//  that swings, which was for ever what isolated particles do, and Stokes'
//  dipole. The force on the gas is that of the drag, which counts the wake of
//  the other one, or that of the slip against the undisturbed gas. The wakes
//  go on in a straight line for a step; the rest is exact.
double pairWithHistory
(
    const double frequency,
    const double distance,
    const int stepsPerPeriod,
    const bool ofDrag,
    const double gasSpeed = pairSpeed
)
{
    using complex = std::complex<double>;

    const double nu = gasProperties::air().nu();
    const double a = 0.5*pairDiameter;
    const double tau = relaxationTime(pairDiameter, pairDensity);
    const double omega = 2*pi*frequency;
    const double h = 1/frequency/stepsPerPeriod;

    // What isolated particles do relative to the gas
    const complex slow = 1.0/complex(1, omega*tau) - 1.0;
    const auto speed = [&](const double t)
    {
        return gasSpeed*(slow*std::polar(1.0, omega*t)).imag();
    };
    const auto place = [&](const double t)
    {
        return
            gasSpeed
           *(slow/complex(0, omega)*std::polar(1.0, omega*t)).imag();
    };

    struct particle
    {
        // In addition, at the steps; f is what moves the gas
        std::vector<double> x;
        std::vector<double> v;
        std::vector<double> f;
        double lastWake;

        //- Between them; at rest before
        double at(const double steps) const
        {
            const int last = static_cast<int>(x.size()) - 1;

            if (steps <= 0 || !last)
            {
                return x[0];
            }

            const int n = std::min(static_cast<int>(steps), last - 1);
            return x[n] + (steps - n)*(x[n + 1] - x[n]);
        }

        double forceAt(const double steps) const
        {
            const int last = static_cast<int>(x.size()) - 1;

            if (steps <= 0 || !last)
            {
                return 0;
            }

            const int n = std::min(static_cast<int>(steps), last - 1);
            return f[n] + (steps - n)*(f[n + 1] - f[n]);
        }
    };

    std::array<particle, 2> both
    {{
        {{0}, {0}, {0}, 0}, {{distance}, {0}, {0}, 0}
    }};

    const double decay = std::exp(-h/tau);

    for (int step = 0; step*h < 0.06; ++step)
    {
        const double t = step*h;
        std::array<double, 2> wake;

        for (int i = 0; i < 2; ++i)
        {
            const particle& from = both[1 - i];
            const double r = both[i].x.back() - from.x.back();
            const double here = place(t) + from.x.back();

            wake[i] = historyIntegral
            (
                vec(r, 0, 0),
                [&](const double s) -> vec
                {
                    const double n = step - s/h;
                    return vec(here - place(t - s) - from.at(n), 0, 0);
                },
                [&](const double s) -> vec
                {
                    return vec(speed(t - s) + from.forceAt(step - s/h), 0, 0);
                },
                a, nu, 1/frequency/16, 8/frequency
            )(0);

            wake[i] -=
                0.5*std::pow(a/std::abs(r), 3)*(speed(t) + from.f.back());
        }

        for (int i = 0; i < 2; ++i)
        {
            particle& p = both[i];

            const double w =
                step ? 1.5*wake[i] - 0.5*p.lastWake : wake[i];
            const double v = p.v.back();

            p.x.push_back(p.x.back() + h*w + tau*(1 - decay)*(v - w));
            p.v.push_back(v*decay + (1 - decay)*w);
            p.f.push_back
            (
                p.v.back()
              - (ofDrag ? w + 0.5*(wake[i] - (step ? p.lastWake : w)) : 0)
            );
            p.lastWake = wake[i];
        }

        const int n = step + 1;
        const double gap = both[1].x[step] - both[0].x[step] - pairDiameter;
        const double next = both[1].x[n] - both[0].x[n] - pairDiameter;

        if (next <= 0)
        {
            return t + h*gap/(gap - next);
        }
    }

    return 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(multipleTimeStep, bringsAPairTogetherInTheTimeThatWasDerived)
{
    struct published
    {
        double frequency;
        double distance;
        double time;
    };

    for
    (
        const published& pair :
        {
            published{200, 100e-6, 21.5e-3},
            published{1000, 100e-6, 8.94e-3},
            published{1000, 200e-6, 23.2e-3}
        }
    )
    {
        const double far =
            integratedPair(pair.frequency, pair.distance, false);
        const double near =
            integratedPair(pair.frequency, pair.distance, true);

        EXPECT_NEAR(far/pair.time, 1, 0.003);
        EXPECT_NEAR(near/far, 1, 0.001);

        for (const std::string& kp : strings{"0.1", "0.5", "1"})
        {
            for (const int n : {50, 100, 200})
            {
                const double time = steppedPair
                (
                    pair.frequency, pair.distance, n,
                    "type multipleTimeStep; kc 0.01; kp " + kp + ";"
                );

                EXPECT_NEAR(time/near, 1, n == 50 ? 0.01 : 0.003)
                    << pair.frequency << " Hz, " << pair.distance << " m, kp "
                    << kp << ", " << n << " steps per period";
            }
        }
    }
}


TEST(memoryWake, bringsAPairTogetherInTheTimeOfTheHistoryIntegral)
{
    struct published
    {
        double distance;
        double time;
        double tolerance;
    };

    const double frequency = 1000;
    const double omega = 2*pi*frequency;
    const double nu = gasProperties::air().nu();
    const double delta = std::sqrt(2*nu/omega);
    const double s = omega*relaxationTime(pairDiameter, pairDensity);
    const double slip = pairSpeed*s/std::sqrt(1 + s*s);

    measured
    (
        "   um   mean drift   integral of slip    of drag [ms]"
        "   model over the last\n"
    );

    for
    (
        const published& pair :
        {
            published{100e-6, 9.2e-3, 0.07},
            published{200e-6, 42.1e-3, 0.02}
        }
    )
    {
        // What was derived is the mean drift of point forces, without inertia
        double mean = 0;
        constexpr int nParts = 10000;
        const double part = (pair.distance - pairDiameter)/nParts;

        for (int n = 0; n < nParts; ++n)
        {
            const double x = (pairDiameter + (n + 0.5)*part)/delta;
            const std::complex<double> l(x, x);
            const std::complex<double> B =
                6.0/(l*l) - 2.0*std::exp(-l)*(1.0 + 3.0/l + 3.0/(l*l));

            mean +=
                part
               /(0.375*0.5*pairDiameter*slip*slip/nu*(-2*B.imag()/(x*x)));
        }

        EXPECT_NEAR(mean/pair.time, 1, 0.006);

        const double exact =
            pairWithHistory(frequency, pair.distance, 100, true);

        measured
        (
            "%5.0f%13.2f%19.2f%16.2f   ",
            1e6*pair.distance,
            1e3*mean,
            1e3*pairWithHistory(frequency, pair.distance, 100, false),
            1e3*exact
        );

        for
        (
            const std::string& stepping :
            {eventDriven, std::string("type multipleTimeStep; kc 0.01; kp 1;")}
        )
        {
            for (const int n : {50, 100})
            {
                const double time = steppedPair
                (
                    frequency, pair.distance, n, stepping,
                    "type memory; range 60; frequency 1000;"
                );

                measured("%8.3f", time/exact);
                EXPECT_NEAR(time/exact, 1, pair.tolerance)
                    << pair.distance << " m, " << n << " steps, " << stepping;
            }
        }
        measured("\n");
    }
}


TEST(historyWake, bringsAPairTogetherInTheTimeOfTheHistoryIntegral)
{
    const double frequency = 1000;

    measured
    (
        "  m/s   um   integral of slip, drag [ms]   history over them"
        "   memory over them\n"
    );

    for (const double speed : {0.44, 1.0, 1.5})
    {
        for (const double distance : {100e-6, 200e-6})
        {
            const double ofSlip =
                pairWithHistory(frequency, distance, 100, false, speed);
            const double ofDrag =
                pairWithHistory(frequency, distance, 100, true, speed);

            const auto time = [&](const std::string& type)
            {
                return steppedPair
                (
                    frequency, distance, 100, eventDriven,
                    "type " + type + "; range 60; frequency 1000;", speed
                );
            };
            const double found = time("history");
            const double memory = time("memory");

            measured
            (
                "%5.2f%5.0f%16.2f%10.2f%14.3f%9.3f%12.3f%9.3f\n",
                speed, 1e6*distance, 1e3*ofSlip, 1e3*ofDrag,
                found/ofSlip, found/ofDrag, memory/ofSlip, memory/ofDrag
            );

            // The model is that of the slip, the gas is moved by the drag
            EXPECT_NEAR(found/ofSlip, 1, 0.05) << speed << ' ' << distance;
            EXPECT_NEAR(found/ofDrag, 1, 0.02) << speed << ' ' << distance;
        }
    }
}


TEST(multipleTimeStep, renewsTheWakesInEveryParticleStep)
{
    // Few fluid steps of many particle steps are as good as the gas between
    // its samples: straight lines
    EXPECT_NEAR
    (
        steppedPair
        (
            200, 100e-6, 20, "type multipleTimeStep; kc 0.01; kp 0.02;"
        )/integratedPair(200, 100e-6, true, 20),
        1,
        0.001
    );
}


TEST(multipleTimeStep, leavesNoWakeOfWhatWasAbsorbed)
{
    // Two that merge within a step are one alone from then on
    const double frequency = 500;
    const double u = 0.5;
    const double density = 2000;
    const double h = 1e-5;

    for (const std::string& kp : strings{"1", "0.003"})
    {
        settings s;
        s.wake = "type Oseen; range 60;";
        s.stepping = "type multipleTimeStep; kc 0.01; kp " + kp + ";";

        experiment pair
        (
            arrays
            ({
                {1, 10e-6, density, {0, 0, 0}, {0.3, 0, 0}},
                {2, 8e-6, density, {12e-6, 1e-6, 0}, {-0.2, 0.1, 0}}
            }),
            0.01, s, frequency, {u, 0, 0}
        );

        contactTime(pair, h, 1e-3);

        ASSERT_EQ(meetings.size(), 1u);
        ASSERT_EQ(pair.p.size(), 1);

        const meeting& m = meetings[0];
        const double share = (m.idI == 1 ? 512 : 1000)/1512.0;

        const freePath alone
        (
            m.time,
            m.xi + share*(m.xj - m.xi),
            m.vi + share*(m.vj - m.vi),
            pair.p.d(0), pair.p.m(0), 2*pi*frequency, u
        );

        // Straight lines between samples of the gas cost this share of the
        // particle's change of velocity; a partner's wake is a good part of u
        ASSERT_LT(m.time, pair.t - 0.1*h);

        EXPECT_LT
        (
            (pair.p.v.col(0) - alone.v(pair.t)).norm(),
            1e-3*(alone.v(pair.t) - alone.v(m.time)).norm()
        );

        pair.run(h, 100);

        EXPECT_LT
        (
            (pair.p.x.col(0) - alone.x(pair.t)).norm(), 20e-9
        );
    }
}


TEST(conventional, bringsAPairTogetherInTheSameTime)
{
    EXPECT_NEAR
    (
        steppedPair(1000, 100e-6, 100, conventional)
       /integratedPair(1000, 100e-6, true),
        1,
        0.003
    );
}


TEST(eventDriven, bringsAPairTogetherInTheSameTime)
{
    for (const double distance : {100e-6, 200e-6})
    {
        const double exact = integratedPair(1000, distance, true);

        for (const int n : {20, 50, 100})
        {
            const double time = steppedPair(1000, distance, n, eventDriven);

            EXPECT_NEAR(time/exact, 1, n == 20 ? 0.02 : 0.003)
                << distance << " m, " << n << " steps per period";
        }
    }
}


// ************************************************************************* //
