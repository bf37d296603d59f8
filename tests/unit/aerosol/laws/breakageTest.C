/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Bonds, and breakage by drag and by shear: forces, work and stresses against
    the formulae, or what these come from; that aggregates break just when they
    must.

\*---------------------------------------------------------------------------*/

#include "bond.H"
#include "breakageTools.H"
#include "dragBreakage.H"
#include "error.H"
#include "measured.H"
#include "shearBreakage.H"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(bond, hasTheStrengthOfTheFormulae)
{
    // Primaries of 1 um, whatever their number: R* = 0.25 um
    const particleArrays p =
        clusters({2, 500}, 1e-6, {vec::Zero(), vec::Zero()});

    for (const int i : {0, 1})
    {
        EXPECT_NEAR
        (
            bond(parse("type JKR; workOfAdhesion 0.05;")).strength(p, i)
           /(1.5*pi*0.05*0.25e-6),
            1, 1e-14
        );

        EXPECT_NEAR
        (
            bond
            (
                parse("type Rumpf; HamakerConstant 1e-19; asperity 10e-9;")
            ).strength(p, i)
           /(
                1e-19/6
               *(10e-9/(0.4e-9*0.4e-9) + 0.25e-6/(10.4e-9*10.4e-9))
            ),
            1, 1e-14
        );

        // Smooth: A R*/(6 z0^2)
        EXPECT_NEAR
        (
            bond
            (
                parse("type Rumpf; HamakerConstant 1e-19; separation 0.3e-9;")
            ).strength(p, i)
           /(1e-19*0.25e-6/(6*0.3e-9*0.3e-9)),
            1, 1e-14
        );
    }
}


TEST(breakage, refusesWhatMakesNoSense)
{
    for
    (
        const std::string text :
        {
            "type drag;", "type drag; bond { type glue; }",
            "type drag; bond { type JKR; }",
            "type drag; bond { type JKR; workOfAdhesion -1; }",
            "type drag; bond { type JKR; workOfAdhesion 1; asperity 1e-9; }",
            "type drag; fragments three; bond { type JKR; workOfAdhesion 1; }",
            "type drag; share 0.2; bond { type JKR; workOfAdhesion 1; }",
            "type shear; fragments two; share 0.7;"
            "bond { type JKR; workOfAdhesion 1; }",
            "type drag; fragment two; bond { type JKR; workOfAdhesion 1; }",
            "type hammer;"
        }
    )
    {
        EXPECT_THROW(fragmentation(parse(text)), IOerror) << text;
    }

    EXPECT_FALSE(fragmentation(dictionary()).active());
    EXPECT_FALSE(fragmentation(parse("type none;")).active());
}


TEST(dragBreakage, hasTheTensionOfARigidPair)
{
    // A spring between the two that are dragged, until it stretches no more
    const equationOfMotion motion = laws("Cunningham");

    for (const int N : {2, 10, 300})
    {
        particleArrays two =
            clusters({N, 1}, 1e-6, {vec::Zero(), vec::Zero()});
        motion.laws().refresh(two);

        const double U = 0.3;
        const double k0 = two.m(0)*two.rate(0);
        const double k1 = two.m(1)*two.rate(1);

        // Relative motion, with the velocities of both near zero, where the
        // slip is U: a damped oscillator about the tension
        const double m = two.m(0)*two.m(1)/two.m.sum();
        const double stiffness = 1e6*m*two.rate.square().maxCoeff();
        const double damping = 2*std::sqrt(stiffness*m);
        const double h = 0.01*std::sqrt(m/stiffness);

        double stretch = 0;
        double rate = 0;
        for (int n = 0; n < 10000; ++n)
        {
            const double force = stiffness*stretch + damping*rate;

            rate +=
                h
               *(
                    (k1*U - force)/two.m(1)
                  - (k0*U + force)/two.m(0)
                );
            stretch += h*rate;
        }

        EXPECT_NEAR
        (
            dragBreakage::tension(two)*U/(stiffness*stretch), 1, 1e-9
        ) << N;

        EXPECT_NEAR
        (
            dragBreakage::tension(two)
           /((k1*two.m(0) - k0*two.m(1))/two.m.sum()),
            1, 1e-12
        );
    }
}


TEST(dragBreakage, beginsAtTheStrength)
{
    // 20 primaries of 1 um, of which one comes off. By hand, without slip
    // correction: diameters of mobility N^0.46 of one.
    const double W = 1e-4;
    const double mu = gasProperties::air().mu;
    const double m = density*pi/6*1e-18;
    const double k0 = 3*pi*mu*1e-6*std::pow(19, 0.46);
    const double k1 = 3*pi*mu*1e-6;
    const double strength = 1.5*pi*W*0.25e-6;
    const double U = strength*20*m/(k1*19*m - k0*m);

    const vec direction = vec(1, -2, 0.5).normalized();

    for (const double share : {0.999, 1.001})
    {
        for (const double sign : {1.0, -1.0})
        {
            const vec v(0.1, 0.2, -0.1);

            particleArrays p = clusters({20}, 1e-6, {vec::Zero()}, v);
            const double mass = p.m(0);

            const bool broke = breaksIn
            (
                "type drag; " + JKR + "1e-4; }",
                p,
                anyGas(v + sign*share*U*direction)
            );

            EXPECT_EQ(broke, share > 1);

            if (!broke)
            {
                EXPECT_EQ(p.size(), 1);
                continue;
            }

            ASSERT_EQ(p.size(), 2);
            EXPECT_EQ(p.id(0), 0);
            EXPECT_EQ(p.id(1), 100);
            EXPECT_EQ(p.primaries(0), 19);
            EXPECT_EQ(p.primaries(1), 1);
            EXPECT_EQ(p.m.sum(), mass);
            EXPECT_NEAR(p.m(1)/m, 1, 1e-14);
            EXPECT_NEAR(p.d(1)/1e-6, 1, 1e-14);
            EXPECT_NEAR(p.d(0)/(std::cbrt(19)*1e-6), 1, 1e-14);
            EXPECT_EQ(p.v.col(0), v);
            EXPECT_EQ(p.v.col(1), v);

            // The light one goes ahead, with the wind
            const double touch =
                0.5*(p.collisionDiameter(0) + p.collisionDiameter(1));
            EXPECT_NEAR
            (
                (p.x.col(1) - p.x.col(0) - 1.001*touch*sign*direction).norm(),
                0, 1e-12*touch
            );
            EXPECT_NEAR((p.x*p.m.matrix()).norm()/mass, 0, 1e-12*touch);

            // Its own laws
            EXPECT_NEAR(p.rate(1)*p.m(1)/k1, 1, 1e-12);
            EXPECT_NEAR(p.rate(0)*p.m(0)/k0, 1, 1e-12);
        }
    }
}


TEST(dragBreakage, comesInTimeInASound)
{
    // On its periodic path, the slip of the aggregate is known: it breaks at
    // the end of the first step where that is enough, or never
    const double frequency = 1400;
    const double omega = 2*pi*frequency;
    const double u0 = 1.5;
    const double h = 1/(200*frequency);
    const int N = 12;

    const equationOfMotion motion = laws();
    particleArrays start = clusters({N}, 1e-6, {vec::Zero()});
    particleArrays pieces = clusters({N - 1, 1}, 1e-6, {vec(), vec()});
    motion.laws().refresh(start);
    motion.laws().refresh(pieces);

    const double tau = 1/start.rate(0);
    const std::complex<double> H = 1.0/std::complex<double>(1, omega*tau);
    const auto slip = [&](const double t)
    {
        return u0*((1.0 - H)*std::polar(1.0, omega*t)).imag();
    };
    const double tension = dragBreakage::tension(pieces);

    start.v(0, 0) = periodicVelocity(omega, tau, u0);

    for (const double share : {0.5, 0.99, 1.01})
    {
        const double W = share*tension*u0*std::abs(1.0 - H)/(1.5*pi*0.25e-6);

        std::ostringstream law;
        law.precision(17);
        law << "type drag; " << JKR << W << "; }";

        fragmentation all(parse(law.str()));
        all.begin(1, 0);

        settings s;
        s.stepping = eventDriven;
        s.aggregate = "type fractal; dimension 1.8;";
        experiment one(start, 1e-3, s, frequency, vec(u0, 0, 0));
        const swingingGas gas(frequency, vec(u0, 0, 0), s.gas);

        int expected = 0;
        int found = 0;

        for (int step = 1; step <= 400; ++step)
        {
            const double t = step*h;

            if
            (
                !expected
             && std::abs(slip(t))*tension > 1.5*pi*W*0.25e-6
            )
            {
                expected = step;
            }

            one.run(h, 1);

            if
            (
                !found
             && all.apply(one.p, {}, motion, gas, box(), t, h, step)
            )
            {
                found = step;

                // The light one is ahead
                EXPECT_GT(slip(t)*(one.p.x(0, 1) - one.p.x(0, 0)), 0);
            }
        }

        measured
        (
            "bond of %g of the largest tension: breaks after %d steps, of %d\n",
            share, found, expected
        );

        EXPECT_EQ(found, expected);
        EXPECT_EQ(found > 0, share < 1);

        // Not together again at once; in the next half period they may be
        EXPECT_EQ(one.p.primaries.sum(), N);
    }
}


TEST(shearBreakage, hasTheStressOnHalfASphere)
{
    // The sum of 5 mu E.n over one half; a simple shear, in any direction
    const double mu = gasProperties::air().mu;
    const double G = 1e5;
    const int N = 30;
    const double a = 0.5e-6*std::pow(N, 0.46);

    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(0.7, vec(1, 2, 3).normalized()).toRotationMatrix();

    Eigen::Matrix3d shear = Eigen::Matrix3d::Zero();
    shear(0, 1) = G;
    const vec axis = turn*vec(1, 1, 0).normalized();
    const Eigen::Matrix3d gradient = turn*shear*turn.transpose();
    const Eigen::Matrix3d E = 0.5*(gradient + gradient.transpose());

    // By a midpoint rule in the polar angle from the axis, and the azimuth
    const vec e2 = axis.unitOrthogonal();
    const vec e3 = axis.cross(e2);
    const int steps = 400;
    vec force = vec::Zero();

    for (int k = 0; k < steps; ++k)
    {
        const double theta = 0.5*pi*(k + 0.5)/steps;

        for (int l = 0; l < 64; ++l)
        {
            const double phi = 2*pi*(l + 0.5)/64;
            const vec n =
                std::cos(theta)*axis
              + std::sin(theta)*(std::cos(phi)*e2 + std::sin(phi)*e3);

            force +=
                5*mu*(E*n)*a*a*std::sin(theta)*(0.5*pi/steps)*(2*pi/64);
        }
    }

    const double tension = force.dot(axis);
    EXPECT_NEAR(tension/(2.5*pi*mu*a*a*G), 1, 1e-5);

    const double W = tension/(1.5*pi*0.25e-6);

    for (const double share : {0.999, 1.001})
    {
        std::ostringstream law;
        law.precision(17);
        law << "type shear; fragments two; " << JKR << W/share << "; }";

        // Far from the middle: the gradient matters, not the velocity
        particleArrays p =
            clusters({N}, 1e-6, {vec(1e-4, -2e-4, 3e-4)}, vec(5, 0, 0));

        EXPECT_EQ
        (
            breaksIn(law.str(), p, anyGas(vec(1, 2, 3), gradient)), share > 1
        );

        if (share > 1)
        {
            ASSERT_EQ(p.size(), 2);
            EXPECT_EQ(p.primaries(0), 15);
            EXPECT_EQ(p.primaries(1), 15);

            const vec r = (p.x.col(1) - p.x.col(0)).normalized();
            EXPECT_NEAR(std::abs(r.dot(axis)), 1, 1e-6);
        }
    }

    // Turning gas strains nothing
    particleArrays p = clusters({N}, 1e-6, {vec::Zero()});
    EXPECT_FALSE
    (
        breaksIn
        (
            "type shear; fragments two; " + JKR + "1e-12; }",
            p,
            anyGas(vec::Zero(), gradient - gradient.transpose())
        )
    );
}


// ************************************************************************* //
