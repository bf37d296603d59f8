/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wakeTools.H"
#include "error.H"

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pi = EIGEN_PI;

std::vector<vec> disturbances(const std::vector<source>& sources)
{
    return disturbances("Oseen", sources);
}


vec disturbance(const vec& r, const vec& slip, const double radius)
{
    return disturbances({{r, slip, radius}})[0];
}


//- As printed: components along r and theta, with 18 digits
vec polarForm(const source& s)
{
    const gasProperties gas = gasProperties::air();

    const longVec r = s.r.cast<long double>();
    const longVec U = s.slip.cast<long double>();

    const long double speed = U.norm();
    const longVec axis = U/speed;
    const longVec er = r/r.norm();

    const long double c = axis.dot(er);
    const longVec across = axis - c*er;
    const long double sine = across.norm();

    const long double R = r.norm()/s.radius;
    const long double Re = 2*s.radius*speed*gas.rho/gas.mu;

    // 1 - cos(theta) without cancellation downstream
    const long double versine = c > 0 ? sine*sine/(1 + c) : 1 - c;

    const long double E = std::exp(-R*Re/4*versine);
    const long double oneLessE = -std::expm1(-R*Re/4*versine);

    const long double radial =
        c/(2*R*R*R) - 3*(1 + c)*E/(4*R) + 3*oneLessE/(Re*R*R);
    const long double angular = sine/(4*R*R*R) + 3*sine*E/(4*R);

    longVec v = speed*radial*er;

    if (sine > 0)
    {
        // theta grows away from the axis
        v -= speed*angular/sine*across;
    }

    return v.cast<double>();
}


//- How fast two identical spheres with the same slip part, relative to U
double parting
(
    const double theta,
    const double r,
    const double slip,
    const double radius
)
{
    const vec e(std::cos(theta), std::sin(theta), 0);
    const vec U(slip, 0, 0);

    const std::vector<vec> w =
        disturbances({{r*e, U, radius}, {-r*e, U, radius}});

    return (w[0] - w[1]).dot(e)/slip;
}


//- Angle at which attraction turns into repulsion, in degrees
template<class Parting>
double neutralAngle(const Parting& parting)
{
    double low = 0;
    double high = 0.5*pi;

    EXPECT_LT(parting(low), 0);
    EXPECT_GT(parting(high), 0);

    for (int n = 0; n < 50; ++n)
    {
        const double theta = 0.5*(low + high);

        (parting(theta) < 0 ? low : high) = theta;
    }

    return low*180/pi;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(OseenWake, isThePolarForm)
{
    const double nu = gasProperties::air().nu();
    randomNumbers random(1);
    std::vector<source> sources;

    for (int n = 0; n < 20000; ++n)
    {
        source s;
        s.radius = random.logUniform(0.1e-6, 50e-6);
        s.slip =
            random.logUniform(1e-8, 5)*nu/(2*s.radius)*random.direction();

        // From the surface to far away
        const double distance = s.radius*random.logUniform(1.0001, 200);
        s.r = distance*random.direction();

        // Some in line, up- or downstream, but for rounding
        if (n % 10 == 0)
        {
            s.r = (n % 20 ? 1 : -1)*distance*s.slip.normalized();
        }
        // Some nearly so
        if (n % 10 == 1)
        {
            s.r =
                distance
               *(s.slip.normalized() + 1e-5*random.direction()).normalized();
        }

        sources.push_back(s);
    }

    const std::vector<vec> v = disturbances(sources);

    for (std::size_t n = 0; n < sources.size(); ++n)
    {
        const source& s = sources[n];
        const vec expected = polarForm(s);

        // The terms are of this size, their sum may be smaller
        const double scale = s.slip.norm()*s.radius/s.r.norm();

        ASSERT_LT((v[n] - expected).norm(), 1e-10*scale)
            << n << ": r " << s.r.transpose() << ", slip "
            << s.slip.transpose() << ", radius " << s.radius;
    }
}


TEST(OseenWake, isStokesFlowAtSmallReynoldsNumber)
{
    randomNumbers random(2);
    const double a = 1e-6;

    for (int n = 0; n < 200; ++n)
    {
        const vec e = random.direction();
        const vec U = 1e-9*random.direction();
        const double R = random.logUniform(1, 100);

        // Stokeslet and potential dipole, as a textbook's tensors
        const vec expected =
          - 0.75/R*(U + e*e.dot(U)) - 0.25/(R*R*R)*(U - 3*e*e.dot(U));

        EXPECT_LT((disturbance(a*R*e, U, a) - expected).norm(), 1e-16);
    }
}


TEST(OseenWake, carriesTheGasAtTheSurfaceWithTheSphere)
{
    randomNumbers random(3);
    const double a = 3e-6;

    for (int n = 0; n < 200; ++n)
    {
        const vec U = 1e-9*random.direction();

        EXPECT_LT
        (
            (disturbance(a*random.direction(), U, a) + U).norm(), 1e-9*U.norm()
        );
    }
}


TEST(OseenWake, isFreeOfDivergence)
{
    const double nu = gasProperties::air().nu();
    randomNumbers random(4);

    for (int n = 0; n < 300; ++n)
    {
        const double a = 5e-6;
        const double R = random.logUniform(1.1, 30);
        const double Re = random.logUniform(1e-4, 5);
        const vec x = a*R*random.direction();
        const vec U = Re*nu/(2*a)*random.direction();

        // Fourth-order central differences
        const double h = 1e-3*a*R;
        double divergence = 0;
        double gradient = 0;

        for (int k = 0; k < 3; ++k)
        {
            const vec s = h*vec::Unit(k);
            const vec slope =
            (
                8*(disturbance(x + s, U, a) - disturbance(x - s, U, a))
              - (disturbance(x + 2*s, U, a) - disturbance(x - 2*s, U, a))
            )/(12*h);

            divergence += slope(k);
            gradient += slope.norm();
        }

        EXPECT_LT(std::abs(divergence), 1e-7*gradient) << R << ' ' << Re;
    }
}


TEST(OseenWake, bringsAsMuchGasAsItTakesAway)
{
    const double nu = gasProperties::air().nu();
    const double a = 5e-6;

    for (const double Re : {1e-6, 0.1, 2.0})
    {
        for (const double R : {1.5, 10.0})
        {
            // Flow through a sphere by the mid-point rule in cos(theta), with
            // the substitution c = 1 - s^2 that resolves the wake
            const vec U(Re*nu/(2*a), 0, 0);
            const int n = 4000;
            double in = 0;
            double out = 0;

            for (int m = 0; m < n; ++m)
            {
                const double s = std::sqrt(2.0)*(m + 0.5)/n;
                const double c = 1 - s*s;
                const vec e(c, std::sqrt(1 - c*c), 0);
                const double flow = 2*s*disturbance(a*R*e, U, a).dot(e);

                (flow < 0 ? in : out) += flow;
            }

            EXPECT_LT(in, 0);
            EXPECT_NEAR(out/in, -1, 1e-6) << Re << ' ' << R;
        }
    }
}


TEST(OseenWake, leavesAWakeDownstreamOnly)
{
    const double a = 4e-6;
    const vec U(0.5, 0, 0);

    for (const double R : {20.0, 100.0, 400.0})
    {
        const vec down = disturbance({a*R, 0, 0}, U, a);
        EXPECT_NEAR(down.x()*R/U.x(), -1.5, 0.6/(R*R));
        EXPECT_EQ(down.y(), 0);
        EXPECT_EQ(down.z(), 0);
    }

    // Upstream a source remains, 3/(Re R^2)
    const double Re = 2*a*0.5/gasProperties::air().nu();
    const double R = 400;
    const vec up = disturbance({-a*R, 0, 0}, U, a);

    EXPECT_NEAR(-up.x()/U.x(), 3/(Re*R*R), 0.01*3/(Re*R*R));

    // The wake changes sides when the slip turns round
    EXPECT_LT
    (
        (disturbance({-a*R, 0, 0}, -U, a) + disturbance({a*R, 0, 0}, U, a))
       .norm(),
        1e-18
    );
}


TEST(OseenWake, isNothingWithoutSlip)
{
    std::feclearexcept(FE_ALL_EXCEPT);

    EXPECT_EQ(disturbance({1e-5, -2e-5, 3e-6}, vec::Zero(), 1e-6).norm(), 0);

    // Nor do tiny or huge values harm
    for (const double speed : {1e-300, 1e-30, 1e3})
    {
        for (const double r : {1e-9, 1e-6, 1.0})
        {
            const vec w = disturbance({r, 0, -r}, {speed, 0, 0}, 1e-6);
            EXPECT_TRUE(w.allFinite());
            EXPECT_LE(w.norm(), 3*speed);
        }
    }

    EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW));
}


TEST(OseenWake, hasTheValueOfTheSurfaceInsideTheSphere)
{
    randomNumbers random(5);
    const double a = 2e-6;

    for (int n = 0; n < 100; ++n)
    {
        const vec e = random.direction();
        const vec U = 0.3*random.direction();
        const vec surface = disturbance(a*e, U, a);

        for (const double R : {0.9, 0.5, 1e-3, 1e-9})
        {
            EXPECT_LT
            (
                (disturbance(R*a*e, U, a) - surface).norm(), 1e-14*U.norm()
            );
        }
    }
}


TEST(OseenWake, attractsInLineAndRepelsAbreast)
{
    // Re to 0: 3 cos^2 = 1
    EXPECT_NEAR
    (
        neutralAngle
        (
            [](double t) { return parting(t, 50e-6, 1e-5, 4e-6); }
        ),
        std::acos(std::sqrt(1.0/3))*180/pi,
        0.01
    );

    // Mean over a cycle of 8 um, 0.44 m/s at 200 um
    const auto mean = [](const double theta)
    {
        double sum = 0;
        const int n = 40;

        for (int m = 0; m < n; ++m)
        {
            const double slip = 0.44*std::sin(pi*(m + 0.5)/n);
            sum += slip*parting(theta, 200e-6, slip, 4e-6);
        }

        return sum/n;
    };

    EXPECT_NEAR(neutralAngle(mean), 51.9, 0.2);
}


TEST(OseenWake, attractsAnAlignedPairAsDerived)
{
    const double a = 4e-6;
    const double nu = gasProperties::air().nu();

    for (const double r : {20e-6, 100e-6, 500e-6})
    {
        for (const double U : {0.01, 0.1, 0.44})
        {
            const double chi = r*U/nu;
            const double expected =
              - 1.5*a/r*(1 + std::expm1(-chi)/chi);

            EXPECT_NEAR(parting(0, r, U, a)/expected, 1, 1e-10);
        }
    }
}


TEST(OseenWake, reachesSoManyDiametersOfTheSource)
{
    scalars d(3);
    d << 1e-6, 5e-6, 2e-5;

    const scalars range = make("type Oseen; range 20;")->range(d, 0*d);

    ASSERT_EQ(range.size(), 3);
    EXPECT_NEAR(range(0), 2e-5, 1e-18);
    EXPECT_NEAR(range(1), 1e-4, 1e-17);
    EXPECT_NEAR(range(2), 4e-4, 1e-17);

    EXPECT_TRUE(make("type Oseen; range 20;")->active());
    EXPECT_FALSE(make("type none;")->active());
    EXPECT_TRUE((make("type none;")->range(d, d) == 0).all());
}


TEST(OseenWake, nowhereExceedsItsBound)
{
    const double nu = gasProperties::air().nu();
    const double a = 3e-6;
    randomNumbers random(6);

    for (const char* type : {"Oseen", "ProudmanPearson"})
    {
        const bool all = type == std::string("Oseen");
        std::vector<source> sources;

        const auto add = [&]
        (
            const double R, const double Re, const double c, const vec& across
        )
        {
            const double s = std::sqrt(std::max(0.0, 1 - c*c));
            sources.push_back
            ({
                a*R*(c*vec::UnitX() + s*across),
                vec(Re*nu/(2*a), 0, 0),
                a
            });
        };

        for (double R = all ? 1 : 5; R < 1e5; R *= 1.3)
        {
            for (double Re = 1e-8; Re < 1e3; Re *= 3)
            {
                for (int m = 0; m <= 40; ++m)
                {
                    add(R, Re, std::cos(pi*m/40), vec::UnitY());
                }

                // The edge of the wake, chi of order one
                add
                (
                    R, Re,
                    std::max(-1.0, 1 - random.logUniform(0.01, 100)/(R*Re)),
                    vec::UnitZ()
                );
            }
        }

        const std::vector<vec> v = disturbances(type, sources);
        double largest = 0;

        for (std::size_t n = 0; n < v.size(); ++n)
        {
            const source& s = sources[n];
            const double bound = 1.5*s.slip.norm()*s.radius/s.r.norm();

            largest = std::max(largest, v[n].norm()/bound);
        }

        EXPECT_LT(largest, 1 + 1e-12) << type;

        // and it is not larger than it need be
        EXPECT_GT(largest, 1 - 1e-6) << type;
    }
}


TEST(OseenWake, reachesToWhereItIsBelowTheTolerance)
{
    scalars d(3);
    d << 1e-6, 5e-6, 2e-5;
    scalars slip(3);
    slip << 0, 0.1, 1.2;

    const auto Oseen = make("type Oseen; tolerance 5e-3;");
    const scalars range = Oseen->range(d, slip);

    EXPECT_EQ(range(0), 0);
    EXPECT_NEAR(range(1)/(1.5*2.5e-6*0.1/5e-3), 1, 1e-14);
    EXPECT_NEAR(range(2)/(1.5*1e-5*1.2/5e-3), 1, 1e-14);
    EXPECT_EQ(Oseen->tolerance(), 5e-3);
    EXPECT_FALSE(Oseen->needsTolerance());

    // Near the source another flow, of which the bound is not one: in full up
    // to five radii
    const scalars other =
        make("type ProudmanPearson; tolerance 5e-3;")->range(d, slip);

    EXPECT_NEAR(other(0), std::sqrt(2)*2.5e-6, 1e-20);
    EXPECT_NEAR(other(1), 75e-6, 1e-18);
    EXPECT_EQ(other(2), range(2));

    // Left to be chosen
    auto open = make("type Oseen;");
    EXPECT_TRUE(open->needsTolerance());
    EXPECT_THROW(open->range(d, slip), error);
    open->setTolerance(5e-3);
    EXPECT_TRUE((open->range(d, slip) == range).all());

    EXPECT_EQ(make("type Oseen; range 20;")->tolerance(), 0);
    EXPECT_FALSE(make("type Oseen; range 20;")->needsTolerance());
    EXPECT_FALSE(make("type none;")->needsTolerance());
}


TEST(OseenWake, rejectsWhatMakesNoSense)
{
    EXPECT_THROW(make("type Oseen; range 20; tolerance 5e-3;"), IOerror);
    EXPECT_THROW(make("type Oseen; tolerance 0;"), IOerror);
    EXPECT_THROW(make("type Oseen; tolerance -1;"), IOerror);
    EXPECT_THROW(make("type Oseen; tolerence 1;"), IOerror);
    EXPECT_THROW(make("type Oseen; range 0;"), IOerror);
    EXPECT_THROW(make("type Oseen; range -20;"), IOerror);
    EXPECT_THROW(make("type Osen; range 20;"), IOerror);
}


// ************************************************************************* //
