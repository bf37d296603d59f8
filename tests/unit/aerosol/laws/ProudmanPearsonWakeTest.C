/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wakeTools.H"
#include "error.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cfenv>
#include <cmath>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using mat = Eigen::Matrix3d;

const double nu = gasProperties::air().nu();

//- Radius of the source [m]
const double a = 4e-6;

std::vector<vec> disturbances(const std::vector<source>& sources)
{
    return disturbances("ProudmanPearson", sources);
}


//- In units of the radius and the slip speed U: at r, for the unit vector
//  `axis` of the slip
vec disturbance(const vec& r, const vec& axis, const double Re)
{
    const double U = Re*nu/(2*a);

    return disturbances({{a*r, U*axis, a}})[0]/U;
}


//- As printed by those who use it: components along r and theta, 18 digits
vec polarForm(const source& s)
{
    const longVec r = s.r.cast<long double>();
    const longVec U = s.slip.cast<long double>();

    const long double speed = U.norm();
    const longVec axis = U/speed;
    const longVec er = r/r.norm();

    const long double c = axis.dot(er);
    const longVec across = axis - c*er;
    const long double sine = across.norm();
    const long double cos2 = c*c - sine*sine;

    const long double R = r.norm()/s.radius;
    const long double R2 = R*R;
    const long double R4 = R2*R2;
    const long double Re = 2*s.radius*speed/nu;

    const long double nearRadial =
    (
        4*R*(16 + 3*Re + 3*R2*(-16 + (2*R - 3)*Re))*c
      - 3*(R - 1)*(R - 1)*(1 + R + 2*R2)*(1 + 3*cos2)*Re
    )/(128*R4);

    const long double nearAngular =
        sine
       *(
            R*(16 + 3*Re + 3*R2*(16 + (3 - 4*R)*Re))
          + 3*(-2 + R - 3*R2*R + 4*R4)*c*Re
        )/(64*R4);

    // 1 - cos(theta) without cancellation downstream
    const long double versine = c > 0 ? sine*sine/(1 + c) : 1 - c;
    const long double E = std::exp(-R*Re/4*versine);
    const long double oneLessE = -std::expm1(-R*Re/4*versine);

    const long double farRadial =
        c/(2*R2*R) - 3*(1 + c)*E/(4*R) + 3*oneLessE/(Re*R2);
    const long double farAngular = sine/(4*R2*R) + 3*sine*E/(4*R);

    const long double x = std::min(std::max((R - 2)/3, 0.0L), 1.0L);
    const long double S = x*x*(3 - 2*x);

    longVec v = speed*((1 - S)*nearRadial + S*farRadial)*er;

    if (sine > 0)
    {
        // theta grows away from the axis
        v -= speed*((1 - S)*nearAngular + S*farAngular)/sine*across;
    }

    return v.cast<double>();
}


//- Derivative of a field along h, by central differences of fourth order
template<class Field>
auto slope(const Field& field, const vec& x, const vec& h)
{
    return
    (
        (
            8*(field(x + h) - field(x - h))
          - (field(x + 2*h) - field(x - 2*h))
        )/(12*h.norm())
    ).eval();
}


//- Its gradient: the column k holds the derivative along k
template<class Field>
mat gradient(const Field& field, const vec& x, const double h)
{
    mat result;

    for (int k = 0; k < 3; ++k)
    {
        result.col(k) = slope(field, x, h*vec::Unit(k));
    }

    return result;
}


template<class Field>
vec curl(const Field& field, const vec& x, const double h)
{
    const mat g = gradient(field, x, h);

    return {g(2, 1) - g(1, 2), g(0, 2) - g(2, 0), g(1, 0) - g(0, 1)};
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(ProudmanPearsonWake, isThePolarForm)
{
    randomNumbers random(1);
    std::vector<source> sources;

    for (int n = 0; n < 20000; ++n)
    {
        source s;
        s.radius = random.logUniform(0.1e-6, 50e-6);
        s.slip =
            random.logUniform(1e-8, 5)*nu/(2*s.radius)*random.direction();

        // Blocks from the surface on, and without pairs close to it
        const double nearest[] = {1.0001, 2, 4.9};
        const double distance =
            s.radius*random.logUniform(nearest[n/wake::blockSize % 3], 8);
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

        ASSERT_LT((v[n] - polarForm(s)).norm(), 1e-13*s.slip.norm())
            << n << ": r " << s.r.transpose() << ", slip "
            << s.slip.transpose() << ", radius " << s.radius;
    }
}


TEST(ProudmanPearsonWake, carriesTheGasAtTheSurfaceWithTheSphere)
{
    randomNumbers random(2);

    for (const double Re : {1e-9, 1e-3, 0.1, 1.0, 5.0, 100.0})
    {
        for (int n = 0; n < 50; ++n)
        {
            const vec U = Re*nu/(2*a)*random.direction();
            const vec e = random.direction();

            // Up to the rounding of |e|
            const vec surface = disturbances({{a*e, U, a}})[0];
            EXPECT_LT((surface + U).norm(), 1e-14*(1 + Re)*U.norm()) << Re;

            // Within the sphere without any
            for (const double R : {0.99, 0.5, 1e-9})
            {
                EXPECT_TRUE(disturbances({{R*a*e, U, a}})[0] == -U) << Re;
            }
        }
    }
}


TEST(ProudmanPearsonWake, isStokesFlowAtSmallReynoldsNumber)
{
    randomNumbers random(3);

    for (int n = 0; n < 500; ++n)
    {
        const vec e = random.direction();
        const vec axis = random.direction();
        const double R = random.logUniform(1, 20);

        // Stokeslet and potential dipole, as a textbook's tensors
        const vec expected =
          - 0.75/R*(axis + e*e.dot(axis))
          - 0.25/(R*R*R)*(axis - 3*e*e.dot(axis));

        EXPECT_LT((disturbance(R*e, axis, 1e-11) - expected).norm(), 1e-11);
    }
}


TEST(ProudmanPearsonWake, solvesNavierStokesToFirstOrderNearTheSphere)
{
    // Steady, in units of the radius and U: the curl of
    //     (Re/2) u.grad u - laplacian u
    // vanishes. Without the part of order Re of the flow, or with a wrong one,
    // it is of order Re.
    randomNumbers random(4);
    const double Re = 0.01;
    const double h = 0.03;

    for (int n = 0; n < 30; ++n)
    {
        const vec x = random.uniform(1.3, 1.7)*random.direction();
        const vec axis = random.direction();

        const auto flow = [&](const vec& y)
        {
            return vec(axis + disturbance(y, axis, Re));
        };

        // The Stokes flow has none, but for the error of the differences
        const auto change = [&](const vec& y)
        {
            return
                vec(disturbance(y, axis, Re) - disturbance(y, axis, 1e-11));
        };

        const auto inertia = [&](const vec& y)
        {
            return vec(0.5*Re*gradient(flow, y, h)*flow(y));
        };

        // laplacian u = -curl curl u
        const auto vorticity = [&](const vec& y)
        {
            return curl(change, y, h);
        };
        const auto friction = [&](const vec& y)
        {
            return curl(vorticity, y, h);
        };

        const vec byInertia = curl(inertia, x, h);
        const vec byFriction = curl(friction, x, h);

        EXPECT_LT((byInertia + byFriction).norm(), 0.1*Re*Re + 1e-3*Re)
            << byInertia.transpose() << " and " << byFriction.transpose();
    }
}


TEST(ProudmanPearsonWake, isFreeOfDivergenceUpToTwoRadii)
{
    randomNumbers random(5);

    for (int n = 0; n < 300; ++n)
    {
        const double h = 1e-3;
        const vec x = random.uniform(1.01, 1.99)*random.direction();
        const vec axis = random.direction();
        const double Re = random.logUniform(1e-4, 5);

        const mat g = gradient
        (
            [&](const vec& y) { return disturbance(y, axis, Re); }, x, h
        );

        EXPECT_LT(std::abs(g.trace()), 1e-9*g.norm()) << x.norm() << ' ' << Re;
    }
}


TEST(ProudmanPearsonWake, hasLittleDivergenceInBetween)
{
    randomNumbers random(6);
    const vec axis(0, 1, 0);

    // Up to this, which the description promises
    const auto expectBelow = [&](const double limit, const double Re)
    {
        double largest = 0;

        for (int n = 0; n < 500; ++n)
        {
            // Also where it is largest
            const double R = random.uniform(2.01, 4.99);
            const vec x = n % 5 ? vec(R*random.direction()) : vec(-R*axis);

            const double divergence = gradient
            (
                [&](const vec& y) { return disturbance(y, axis, Re); }, x, 1e-3
            ).trace();

            largest = std::max(largest, std::abs(divergence));
        }

        EXPECT_LT(largest, limit) << Re;
        EXPECT_GT(largest, 0.9*limit) << Re;
    };

    expectBelow(0.080*0.001, 0.001);
    expectBelow(0.079*0.01, 0.01);
    expectBelow(0.071*0.1, 0.1);
    expectBelow(0.0256, 1);
    expectBelow(0.080*5, 5);
}


TEST(ProudmanPearsonWake, bringsAsMuchGasAsItTakesAway)
{
    for (const double Re : {1e-3, 0.3, 3.0})
    {
        for (const double R : {1.3, 2.5, 3.5, 4.9})
        {
            // Flow through a sphere by the mid-point rule in cos(theta)
            const int n = 4000;
            double in = 0;
            double out = 0;

            for (int m = 0; m < n; ++m)
            {
                const double c = -1 + 2*(m + 0.5)/n;
                const vec e(c, std::sqrt(1 - c*c), 0);
                const double flow = disturbance(R*e, {1, 0, 0}, Re).dot(e);

                (flow < 0 ? in : out) += flow;
            }

            EXPECT_LT(in, 0);
            EXPECT_NEAR(out/in, -1, 2e-6) << Re << ' ' << R;
        }
    }
}


TEST(ProudmanPearsonWake, isOseensFlowFromFiveRadiiOn)
{
    randomNumbers random(7);

    // Blocks with and without pairs nearby
    for (const double nearest : {1.0, 5.01})
    {
        std::vector<source> sources;

        for (int n = 0; n < 1000; ++n)
        {
            const double radius = random.logUniform(0.1e-6, 50e-6);

            sources.push_back
            ({
                radius*random.logUniform(nearest, 40)*random.direction(),
                random.logUniform(1e-6, 5)*nu/radius*random.direction(),
                radius
            });
        }

        const std::vector<vec> v = disturbances(sources);
        const std::vector<vec> Oseen = disturbances("Oseen", sources);

        for (std::size_t n = 0; n < sources.size(); ++n)
        {
            const source& s = sources[n];
            const double R = s.r.norm()/s.radius;

            if (R > 5.001)
            {
                EXPECT_TRUE(v[n] == Oseen[n]) << R;
            }
            if (R < 1.5)
            {
                EXPECT_FALSE(v[n] == Oseen[n]) << R;
            }
        }
    }
}


TEST(ProudmanPearsonWake, isContinuousInValueAndSlope)
{
    randomNumbers random(8);

    for (int n = 0; n < 200; ++n)
    {
        const vec e = random.direction();
        const vec axis = random.direction();
        const double Re = random.logUniform(1e-3, 5);

        for (const double R : {2.0, 5.0})
        {
            const double h = 1e-3;

            const auto at = [&](const double distance)
            {
                return disturbance(distance*e, axis, Re);
            };

            EXPECT_LT((at(R + 1e-9) - at(R - 1e-9)).norm(), 1e-8*(1 + Re));

            // One-sided differences of fourth order
            const auto slopeTowards = [&](const double s)
            {
                return vec
                (
                    (
                      - 25*at(R) + 48*at(R + s) - 36*at(R + 2*s)
                      + 16*at(R + 3*s) - 3*at(R + 4*s)
                    )/(12*s)
                );
            };

            EXPECT_LT
            (
                (slopeTowards(h) - slopeTowards(-h)).norm(), 1e-9*(1 + Re)
            )
                << R << ' ' << Re;
        }
    }
}


TEST(ProudmanPearsonWake, changesSidesWithTheSlip)
{
    randomNumbers random(9);

    for (int n = 0; n < 200; ++n)
    {
        const vec r = random.logUniform(1, 8)*random.direction();
        const vec axis = random.direction();

        EXPECT_TRUE
        (
            disturbance(r, axis, 0.7) == -disturbance(-r, -axis, 0.7)
        );
    }

    // At Re > 0 more of the gas is carried along downstream
    EXPECT_LT
    (
        1.1*std::abs(disturbance({-1.8, 0, 0}, {1, 0, 0}, 0.7).x()),
        std::abs(disturbance({1.8, 0, 0}, {1, 0, 0}, 0.7).x())
    );
}


TEST(ProudmanPearsonWake, isNothingWithoutSlip)
{
    std::feclearexcept(FE_ALL_EXCEPT);

    for (const double R : {0.5, 1.0, 1.5, 3.0, 7.0})
    {
        const vec r = 1e-6*R*vec(0.6, 0, -0.8);

        EXPECT_EQ(disturbances({{r, vec::Zero(), 1e-6}})[0].norm(), 0);

        // Nor do tiny or huge values harm
        for (const double speed : {1e-300, 1e-160, 1e-30, 1e3})
        {
            const vec w = disturbances({{r, {0, speed, 0}, 1e-6}})[0];
            const double Re = 2e-6*speed/nu;

            EXPECT_TRUE(w.allFinite());
            EXPECT_LE(w.norm(), (1 + Re)*speed);
        }
    }

    EXPECT_TRUE
    (
        disturbances({{{1.0, 0, -1.0}, {1e3, 0, 0}, 1e-6}})[0].allFinite()
    );

    EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW));
}


TEST(ProudmanPearsonWake, isSelectedLikeOseens)
{
    const auto model = make("type ProudmanPearson; range 20;");

    scalars d(2);
    d << 1e-6, 2e-5;

    EXPECT_TRUE(model->active());
    EXPECT_EQ(model->type(), "ProudmanPearson");
    EXPECT_NEAR(model->range(d, 0*d)(0), 2e-5, 1e-18);
    EXPECT_NEAR(model->range(d, 0*d)(1), 4e-4, 1e-17);

    EXPECT_TRUE(make("type ProudmanPearson;")->needsTolerance());
    EXPECT_THROW(make("type ProudmanPearson; range -20;"), IOerror);
}


// ************************************************************************* //
