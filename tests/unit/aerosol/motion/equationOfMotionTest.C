/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "equationOfMotion.H"
#include "IStringStream.H"
#include "periodicBox.H"
#include "periodicPairs.H"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <random>

using namespace Foam;
using namespace Foam::aerosol;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pi = EIGEN_PI;

using vec = Eigen::Vector3d;
using phasor = std::complex<double>;

dictionary parse(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


dictionary laws
(
    const std::string& drag,
    const std::string& wake = "type none;",
    const std::string& gravity = "type none;"
)
{
    return parse
    (
        "drag { type " + drag + "; slipCorrection none; }"
        "gravity { " + gravity + " } wake { " + wake + " }"
    );
}


particleArrays spheres(const std::vector<double>& d, const double density)
{
    particleArrays p;
    p.resize(static_cast<int>(d.size()));

    for (int i = 0; i < p.size(); ++i)
    {
        p.id(i) = i;
        p.d(i) = d[i];
        p.m(i) = density*pi/6*std::pow(d[i], 3);
        p.primaries(i) = 1;
    }

    p.x.setZero();
    p.v.setZero();

    return p;
}


//- Integral of exp(-z (1 - s)) s^(n-1)/(n-1)! over s from 0 to 1: what a gas
//  velocity that grows as a power of time gives
long double phi(const int n, const long double z)
{
    if (z < 4)
    {
        // Alternating series
        long double term = 1;
        for (int k = 2; k <= n; ++k)
        {
            term /= k;
        }

        long double sum = 0;
        for (int k = n; k < n + 60; ++k)
        {
            sum += term;
            term *= -z/(k + 1);
        }

        return sum;
    }

    return
        n == 1
      ? -std::expm1(-z)/z
      : ((n == 2 ? 1.0L : 0.5L) - phi(n - 1, z))/z;
}


//- Velocity and position after a step, by the variation of constants
struct exactStep
{
    long double v;
    long double x;

    exactStep
    (
        const long double k,
        const long double h,
        const long double v0,
        const long double u0,
        const long double u1,
        const long double g
    )
    {
        const long double z = k*h;

        // dv/dt at the beginning, and its growth
        const long double a = k*(u0 - v0) + g;
        const long double b = k*(u1 - u0);

        v = v0 + h*(a*phi(1, z) + b*phi(2, z));
        x = h*v0 + h*h*(a*phi(2, z) + b*phi(3, z));
    }
};


//- Flow about a sphere by Oseen, in components along and across r
vec OseenFlow
(
    const vec& r,
    const vec& slip,
    const double radius,
    const double nu
)
{
    const double speed = slip.norm();

    if (speed == 0)
    {
        return vec::Zero();
    }

    const vec e = r.normalized();
    const double R = r.norm()/radius;
    const double Re = 2*radius*speed/nu;
    const double c = std::min(1.0, std::max(-1.0, e.dot(slip)/speed));
    const double q = R*Re/4*(1 - c);
    const double E = std::exp(-q);

    const double sink = q > 1e-12 ? -std::expm1(-q)/q : 1;

    const double radial =
        0.5*c/(R*R*R) - 0.75*(1 + c)*E/R + 0.75*(1 - c)/R*sink;
    const double angular = 0.25/(R*R*R) + 0.75*E/R;

    return speed*(radial*e + angular*(c*e - slip/speed));
}


//- All pairs (i, j) in which j acts on i, in an infinite domain
std::vector<particlePair> everyPair(const int n)
{
    std::vector<particlePair> pairs;

    for (int i = 0; i < n; ++i)
    {
        for (int j = 0; j < n; ++j)
        {
            if (i != j)
            {
                pairs.push_back({i, j, {0, 0, 0}});
            }
        }
    }

    return pairs;
}


//- Interacting particles by the classical Runge-Kutta method
template<class Rate>
void RungeKutta
(
    particleArrays& p,
    const double h,
    const int steps,
    const Rate& acceleration
)
{
    double t = 0;

    for (int s = 0; s < steps; ++s)
    {
        const vectors x0 = p.x;
        const vectors v0 = p.v;

        const vectors a1 = acceleration(t, x0, v0);
        const vectors v2 = v0 + 0.5*h*a1;
        const vectors a2 = acceleration(t + 0.5*h, x0 + 0.5*h*v0, v2);
        const vectors v3 = v0 + 0.5*h*a2;
        const vectors a3 = acceleration(t + 0.5*h, x0 + 0.5*h*v2, v3);
        const vectors v4 = v0 + h*a3;
        const vectors a4 = acceleration(t + h, x0 + h*v3, v4);

        p.x = x0 + h/6*(v0 + 2*v2 + 2*v3 + v4);
        p.v = v0 + h/6*(a1 + 2*a2 + 2*a3 + a4);
        t += h;
    }
}


//- The code's steps in a gas of the same velocity everywhere
template<class Gas>
void advance
(
    particleArrays& p,
    equationOfMotion& motion,
    const std::vector<particlePair>& pairs,
    const double h,
    const int steps,
    const Gas& gas
)
{
    motion.refresh(p);

    equationOfMotion::state end;

    vectors u0 = gas(0.0).replicate(1, p.size());

    for (int s = 0; s < steps; ++s)
    {
        const vectors u1 = gas((s + 1)*h).replicate(1, p.size());

        motion.step(h, p, pairs, {u0, {}, u1}, {}, 1, end);

        p.x = end.x;
        p.v = end.v;
        u0 = u1;
    }
}


//- Order of convergence of errors from steps halved each time
double order(const std::vector<double>& errors)
{
    return std::log2(errors[errors.size() - 2]/errors.back());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(equationOfMotion, isExactInGasThatChangesLinearlyInTime)
{
    const gasProperties gas = gasProperties::air();
    const double h = 1e-5;
    const double g = 9.81;

    // Masses such that z = h/tau is what is wanted
    std::vector<double> z;
    for (double s = 1e-8; s < 1.01e4; s *= std::pow(10, 0.1))
    {
        z.push_back(s);
    }
    for (const double s : {0.0199, 0.019999999, 0.02, 0.020000001, 0.0201})
    {
        z.push_back(s);
    }

    particleArrays p = spheres(std::vector<double>(z.size(), 2e-6), 1000);
    scalars k(p.size());

    for (int i = 0; i < p.size(); ++i)
    {
        p.m(i) = 3*pi*gas.mu*p.d(i)*h/z[i];
        k(i) = 3*pi*gas.mu*p.d(i)/p.m(i);
    }

    equationOfMotion motion
    (
        laws("Stokes", "type none;", "type uniform; value (0 0 -9.81);"),
        gas,
        Eigen::Array3d::Ones()
    );
    motion.refresh(p);

    // Started from rest at the origin, nothing hides in rounding: x has gas at
    // a constant velocity, y one that rises from zero, z gravity
    vectors u0(3, p.size());
    vectors u1(3, p.size());
    u0.colwise() = vec(1.3, 0, 0);
    u1.colwise() = vec(1.3, 0.7, 0);

    equationOfMotion::state end;
    motion.step(h, p, {}, {u0, {}, u1}, {}, 1, end);

    for (int i = 0; i < p.size(); ++i)
    {
        const double fall =
            -g*(1 - gas.rho*pi/6*std::pow(p.d(i), 3)/p.m(i));

        const exactStep x(k(i), h, 0, 1.3, 1.3, 0);
        const exactStep y(k(i), h, 0, 0, 0.7, 0);
        const exactStep w(k(i), h, 0, 0, 0, fall);

        EXPECT_NEAR(end.v(0, i)/double(x.v), 1, 1e-13) << z[i];
        EXPECT_NEAR(end.v(1, i)/double(y.v), 1, 1e-11) << z[i];
        EXPECT_NEAR(end.v(2, i)/double(w.v), 1, 1e-11) << z[i];

        EXPECT_NEAR(end.x(0, i)/double(x.x), 1, 1e-11) << z[i];
        EXPECT_NEAR(end.x(1, i)/double(y.x), 1, 1e-9) << z[i];
        EXPECT_NEAR(end.x(2, i)/double(w.x), 1, 1e-11) << z[i];
    }

    // All at once, from anywhere at any velocity
    const vec x0(0.1, -0.2, 0.3);
    const vec v0(-2, 0.5, 1);
    p.x.colwise() = x0;
    p.v.colwise() = v0;
    u0.colwise() = vec(1, 2, 3);
    u1.colwise() = vec(-1, 2.5, 0);
    motion.step(h, p, {}, {u0, {}, u1}, {}, 1, end);

    for (int i = 0; i < p.size(); ++i)
    {
        const double fall =
            -g*(1 - gas.rho*pi/6*std::pow(p.d(i), 3)/p.m(i));

        for (int c = 0; c < 3; ++c)
        {
            const exactStep exact
            (
                k(i), h, v0(c), u0(c, i), u1(c, i), c == 2 ? fall : 0
            );

            EXPECT_NEAR(end.v(c, i), double(exact.v), 1e-13) << z[i];
            EXPECT_NEAR(end.x(c, i), x0(c) + double(exact.x), 2e-16) << z[i];
        }
    }
}


TEST(equationOfMotion, doesNotCareHowAStepIsDivided)
{
    // What is exact for a step is exact for its parts: one of h, or a
    // thousand on the other side of the series' limit
    const gasProperties gas = gasProperties::air();
    equationOfMotion motion(laws("Stokes"), gas, Eigen::Array3d::Ones());

    particleArrays once = spheres({0.5e-6, 3e-6, 20e-6}, 2300);
    once.v.setConstant(-0.3);
    particleArrays often = once;

    const auto rising = [](const double t)
    {
        return vec(0.4 + 2e4*t, -1e4*t, 0);
    };

    advance(once, motion, {}, 1e-5, 1, rising);
    advance(often, motion, {}, 1e-8, 1000, rising);

    EXPECT_LT((once.x - often.x).norm(), 1e-17);
    EXPECT_LT((once.v - often.v).norm(), 1e-12);
}


TEST(equationOfMotion, isEntrainedAsStokesSays)
{
    const gasProperties gas = gasProperties::air();

    struct sound
    {
        double frequency;
        double density;
        std::vector<double> d;
    };

    for
    (
        const sound& s :
        {
            sound{1400, 2300, {1e-6, 2e-6, 5e-6, 10e-6}},
            sound{5000, 2400, {8e-6}},
            sound{200, 2400, {8e-6}}
        }
    )
    {
        for (const int n : {50, 100, 200})
        {
            const double omega = 2*pi*s.frequency;
            const double u = 1.5;

            particleArrays p = spheres(s.d, s.density);
            equationOfMotion motion
                (laws("Stokes"), gas, Eigen::Array3d::Ones());

            const double h = 1/s.frequency/n;
            const auto gasVelocity = [&](const double t)
            {
                return vec(u*std::cos(omega*t), 0, 0);
            };

            // On its periodic path from the beginning
            std::vector<phasor> H;
            for (int i = 0; i < p.size(); ++i)
            {
                const double tau =
                    s.density*p.d(i)*p.d(i)/(18*gas.mu);

                H.push_back(1.0/phasor(1, omega*tau));
                p.v(0, i) = u*H[i].real();
            }

            motion.refresh(p);

            vectors u0 = gasVelocity(0).replicate(1, p.size());
            equationOfMotion::state end;
            std::vector<phasor> response(p.size());
            vectors start;

            for (int step = 0; step < 20*n; ++step)
            {
                const vectors u1 =
                    gasVelocity((step + 1)*h).replicate(1, p.size());

                motion.step(h, p, {}, {u0, {}, u1}, {}, 1, end);

                if (step == 19*n)
                {
                    start = p.x;
                }
                if (step >= 19*n)
                {
                    for (int i = 0; i < p.size(); ++i)
                    {
                        response[i] +=
                            2.0/n*end.v(0, i)
                           *std::polar(1.0, -omega*(step + 1)*h);
                    }
                }

                p.x = end.x;
                p.v = end.v;
                u0 = u1;
            }

            // The straight lines between the samples of the gas have an
            // amplitude that is too small by this share
            const double chord = std::pow(pi/n, 2)/3;

            for (int i = 0; i < p.size(); ++i)
            {
                EXPECT_NEAR
                (
                    std::abs(response[i])/(u*std::abs(H[i])), 1, 1.02*chord
                ) << n << ' ' << s.d[i];

                // H has the sign of exp(+i omega t): it lags
                EXPECT_NEAR
                (
                    std::arg(response[i]), std::arg(H[i]), 1e-4
                ) << n << ' ' << s.d[i];

                EXPECT_LT
                (
                    std::abs(p.x(0, i) - start(0, i)), 1e-6*u/omega
                ) << n << ' ' << s.d[i];
            }
        }
    }
}


TEST(equationOfMotion, hasThePublishedEntrainment)
{
    // One value as a number: 5 um, 2300 kg/m3, 1.4 kHz
    const gasProperties gas = gasProperties::air();
    particleArrays p = spheres({5e-6}, 2300);
    equationOfMotion motion(laws("Stokes"), gas, Eigen::Array3d::Ones());

    const double omega = 2*pi*1400;
    double largest = 0;

    for (int n = 0; n < 200; ++n)
    {
        const double begin = 10*n/(200*1400.0);

        advance
        (
            p, motion, {}, 1/(1400.0*200), 10,
            [&](const double t)
            {
                return vec(std::sin(omega*(begin + t)), 0, 0);
            }
        );

        if (n >= 180)
        {
            largest = std::max(largest, std::abs(p.v(0, 0)));
        }
    }

    EXPECT_LT(largest, 0.5415*1.0005);
    EXPECT_GT(largest, 0.5415*std::cos(pi/20)*0.999);
}


TEST(equationOfMotion, isOfSecondOrderWithWakes)
{
    const gasProperties gas = gasProperties::air();
    const double frequency = 1000;
    const double omega = 2*pi*frequency;

    const auto gasVelocity = [&](const double t)
    {
        return vec(0.44*std::sin(omega*t), 0.1*std::cos(omega*t), 0);
    };

    particleArrays start = spheres({8e-6, 8e-6, 5e-6}, 2400);
    start.x << 0, 25e-6, 10e-6,
               0, 5e-6, 30e-6,
               0, 0, -10e-6;
    start.v.setConstant(0.02);

    const scalars tau = 2400*start.d.square()/(18*gas.mu);

    particleArrays exact = start;
    RungeKutta
    (
        exact, 1/frequency/4000, 8000,
        [&](const double t, const vectors& x, const vectors& v)
        {
            vectors a(3, 3);
            for (int i = 0; i < 3; ++i)
            {
                vec u = gasVelocity(t);
                for (int j = 0; j < 3; ++j)
                {
                    if (j != i)
                    {
                        u += OseenFlow
                        (
                            x.col(i) - x.col(j),
                            gasVelocity(t) - v.col(j),
                            0.5*start.d(j),
                            gas.nu()
                        );
                    }
                }
                a.col(i) = (u - v.col(i))/tau(i);
            }
            return a;
        }
    );

    std::vector<double> apart;
    std::vector<double> place;

    for (const int n : {25, 50, 100, 200, 400})
    {
        particleArrays p = start;
        equationOfMotion motion
        (
            laws("Stokes", "type Oseen; range 100;"),
            gas,
            Eigen::Array3d::Ones()
        );

        advance
        (
            p, motion, everyPair(3), 1/frequency/n, 2*n, gasVelocity
        );

        place.push_back((p.x - exact.x).norm());
        apart.push_back
        (
            (
                (p.x.col(1) - p.x.col(0)) - (exact.x.col(1) - exact.x.col(0))
            ).norm()
        );
    }

    EXPECT_GT(order(place), 1.9);
    EXPECT_GT(order(apart), 1.9);

    // The wakes brought the pair closer by far more than what is missing
    const double moved =
        (exact.x.col(1) - exact.x.col(0)).norm()
      - (start.x.col(1) - start.x.col(0)).norm();

    EXPECT_GT(std::abs(moved), 1e-6);
    EXPECT_LT(apart[2], 0.01*std::abs(moved));
}


TEST(equationOfMotion, isOfSecondOrderAtFiniteReynoldsNumber)
{
    const gasProperties gas = gasProperties::air();

    const auto gasVelocity = [](const double t)
    {
        return vec(2*std::sin(2*pi*500*t), 0, 1);
    };

    particleArrays start = spheres({30e-6}, 2000);
    start.v.col(0) = vec(0, 3, 0);

    const double rate = 18*gas.mu/(2000*900e-12);

    particleArrays exact = start;
    RungeKutta
    (
        exact, 1e-6, 2000,
        [&](const double t, const vectors&, const vectors& v)
        {
            const vec slip = gasVelocity(t) - v.col(0);
            const double Re = slip.norm()*30e-6/gas.nu();

            return vectors(rate*(1 + 0.15*std::pow(Re, 0.687))*slip);
        }
    );

    std::vector<double> errors;

    for (const int n : {25, 50, 100, 200})
    {
        particleArrays p = start;
        equationOfMotion motion
            (laws("SchillerNaumann"), gas, Eigen::Array3d::Ones());

        advance(p, motion, {}, 0.002/n, n, gasVelocity);
        errors.push_back((p.x - exact.x).norm());
    }

    EXPECT_GT(order(errors), 1.9);
    EXPECT_LT(errors.back(), 1e-4*(exact.x - start.x).norm());
}


TEST(equationOfMotion, fadesWakesOutTowardsTheirRange)
{
    const gasProperties gas = gasProperties::air();
    equationOfMotion motion
    (
        laws("Stokes", "type Oseen; range 10;"), gas, Eigen::Array3d::Ones()
    );

    // The range is that of the source: 80 um for 8 um, 20 um for 2 um
    particleArrays p = spheres({8e-6, 2e-6}, 2000);
    motion.refresh(p);

    EXPECT_NEAR(p.range(0), 80e-6, 1e-18);
    EXPECT_NEAR(p.range(1), 20e-6, 1e-18);

    const vectors still = vectors::Zero(3, 2);
    p.v.setConstant(0.1);

    const vec direction = vec(1, 2, -2)/3;

    // By each at the other one, over Oseen's flow; those who are out of range
    // may be in the list or not
    const auto shares = [&](const double r)
    {
        p.x.col(0) = vec(0.1, 0.2, 0.3);
        p.x.col(1) = p.x.col(0) + r*direction;

        vectors w;
        motion.wakes(p, everyPair(2), p.x, p.v, still, w);

        const auto share = [&](const int source, const double sign)
        {
            return
                w.col(1 - source).norm()
               /OseenFlow
                (
                    sign*r*direction, -p.v.col(source), 0.5*p.d(source),
                    gas.nu()
                ).norm();
        };

        return std::array<double, 2>{share(0, 1), share(1, -1)};
    };

    for (const double r : {10e-6, 14.1e-6, 56.5e-6})
    {
        EXPECT_NEAR(shares(r)[0], 1, 1e-8) << r;
        EXPECT_EQ(shares(r)[1] > 0.999, r < 20e-6) << r;
    }

    // The half at sqrt(3)/2 of the range, nothing beyond it
    EXPECT_NEAR(shares(std::sqrt(0.75)*80e-6)[0], 0.5, 1e-8);
    EXPECT_NEAR(shares(std::sqrt(0.75)*20e-6)[1], 0.5, 1e-8);
    EXPECT_EQ(shares(80.01e-6)[0], 0);
    EXPECT_EQ(shares(20.01e-6)[1], 0);

    // Slope and curvature are continuous where it begins and ends
    for (const double h : {0.001, 0.01})
    {
        const double gone = 10*std::pow(2*h, 3);

        EXPECT_NEAR(1 - shares(80e-6*std::sqrt(0.5 + h))[0], gone, 0.1*gone);
        EXPECT_NEAR(shares(80e-6*std::sqrt(1 - h))[0], gone, 0.1*gone);
    }
}


TEST(equationOfMotion, sumsTheWakesOfAllImages)
{
    const gasProperties gas = gasProperties::air();
    const periodicBox box
        (parse("centre (0.01 0 0); length (180e-6 100e-6 140e-6);"));

    equationOfMotion motion
    (
        laws("Stokes", "type Oseen; range 20;"), gas, box.period()
    );

    // Up to 160 um: further than the box is long in two directions
    std::mt19937_64 engine(1);
    const auto random = [&]()
    {
        return std::ldexp(double(engine() >> 11), -53);
    };

    std::vector<double> d;
    for (int i = 0; i < 40; ++i)
    {
        d.push_back(1e-6*std::pow(8, random()));
    }

    particleArrays p = spheres(d, 2000);
    vectors u(3, p.size());

    for (int i = 0; i < p.size(); ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            p.x(k, i) =
                box.bounds().min()[k] + random()*box.bounds().span()[k];
            p.v(k, i) = random() - 0.5;
            u(k, i) = random() - 0.5;
        }
    }

    motion.refresh(p);

    const std::vector<particlePair> pairs =
        testTools::actingPairs(box, p.x, p.range);

    EXPECT_GT(pairs.size(), 500u);

    vectors w;
    motion.wakes(p, pairs, p.x, p.v, u, w);

    for (int i = 0; i < p.size(); ++i)
    {
        vec expected = vec::Zero();

        for (int j = 0; j < p.size(); ++j)
        {
            for (int image = 0; j != i && image < 125; ++image)
            {
                const vec m(image/25 - 2, image/5%5 - 2, image%5 - 2);
                const vec r =
                    p.x.col(i) - p.x.col(j) - m.cwiseProduct
                    (
                        box.period().matrix()
                    );

                // Overlapping spheres: as at the surface
                const double a = 0.5*p.d(j);

                if (r.norm() <= 20*p.d(j))
                {
                    const double s = std::max
                    (
                        2*std::pow(r.norm()/(20*p.d(j)), 2) - 1, 0.0
                    );

                    expected +=
                        (1 - 10*s*s*s + 15*s*s*s*s - 6*std::pow(s, 5))
                       *OseenFlow
                        (
                            r*std::max(1.0, a/r.norm()),
                            u.col(j) - p.v.col(j),
                            a,
                            gas.nu()
                        );
                }
            }
        }

        EXPECT_LT((w.col(i) - expected).norm(), 1e-10) << i;
    }
}


TEST(equationOfMotion, ignoresItsWakesWithoutAny)
{
    const gasProperties gas = gasProperties::air();
    equationOfMotion motion(laws("Stokes"), gas, Eigen::Array3d::Ones());

    particleArrays p = spheres({1e-6, 1e-6}, 2000);
    motion.refresh(p);

    EXPECT_FALSE(motion.hasWakes());
    EXPECT_TRUE((p.range == 0).all());
    EXPECT_TRUE((motion.gain(p, 1) == 0).all());

    vectors w;
    motion.wakes(p, everyPair(2), p.x, p.v, vectors::Ones(3, 2), w);

    ASSERT_EQ(w.cols(), 2);
    EXPECT_EQ(w.norm(), 0);
}


// ************************************************************************* //
