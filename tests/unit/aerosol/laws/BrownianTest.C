/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Brownian motion has the temperature of the gas and Einstein's diffusion at
// any step, and may be looked into more closely without being changed.

#include "Brownian.H"
#include "OrnsteinUhlenbeck.H"
#include "drag.H"
#include "error.H"
#include "IStringStream.H"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>

using namespace Foam;
using namespace Foam::aerosol;

using law = OrnsteinUhlenbeck::law;
using lanes = OrnsteinUhlenbeck::lanes;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pi = EIGEN_PI;
constexpr double kB = 1.380649e-23;

//- Exceeded once in a million samples
constexpr double normalLimit = 4.89;
constexpr double KolmogorovLimit = 2.69;


autoPtr<Brownian> make(const std::string& text)
{
    return Brownian::New(dictionary(IStringStream(text)()));
}


autoPtr<Brownian> process(const int seed = 1)
{
    return make("type OrnsteinUhlenbeck; seed " + std::to_string(seed) + ";");
}


particleArrays cloud(const int n, const double m = 1e-17)
{
    particleArrays p;
    p.resize(n);

    for (int i = 0; i < n; ++i)
    {
        p.id(i) = 1000 + i;
    }

    p.x.setZero();
    p.v.setZero();
    p.d.setConstant(1e-6);
    p.m.setConstant(m);
    p.primaries.setOnes();

    return p;
}


//- Velocities of the equilibrium
vectors thermal(const int n, const double variance)
{
    std::mt19937_64 engine(5);
    std::normal_distribution<double> normal(0, std::sqrt(variance));

    return vectors::NullaryExpr(3, n, [&]() { return normal(engine); });
}


//- One step of a particle that nothing but the noise and the drag moves
void advance
(
    const double h,
    const double rate,
    const Brownian::increments& k,
    vectors& x,
    vectors& v
)
{
    x += -std::expm1(-rate*h)/rate*v + k.x;
    v = std::exp(-rate*h)*v + k.v;
}


//- Covariance of (v, x) of a law, in its units
Eigen::Matrix2d covariance(const law& l)
{
    const double vv = l.v(0)*l.v(0);
    const double vx = l.slope(0)*vv;

    Eigen::Matrix2d C;
    C << vv, vx, vx, l.slope(0)*vx + l.x(0)*l.x(0);

    return C;
}


//- The same in those of the formulas
Eigen::Matrix2d formulas(const double z)
{
    const double e = -std::expm1(-z);

    Eigen::Matrix2d C;
    C << e*(2 - e), e*e/z, e*e/z, (2*z - 2*e - e*e)/(z*z);

    return C;
}


double worst(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
    return (a.array()/b.array() - 1).abs().maxCoeff();
}


bool same(const Brownian::increments& a, const Brownian::increments& b)
{
    return a.v == b.v && a.x == b.x;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

// <v^2>, <v x>/z and <x^2>/z^2 in units of the thermal speed and the
// relaxation time, worked out with 40 digits
TEST(Brownian, hasTheVariancesOfUhlenbeckAndOrnstein)
{
    const double reference[][4] =
    {
        {1e-8, 1.99999998000000013e-8, 9.99999990000000058e-9,
            6.6666666166666669e-9},
        {1e-3, 0.00199800133266693324, 0.000999000583083419419,
            0.000666166899916691264},
        {0.02, 0.0392105608476767906, 0.0196046269406302499,
            0.0131351867449986101},
        {0.5, 0.632120558828557678, 0.309636243492350949,
            0.232972790716365491},
        {0.999, 0.864393775345810306, 0.399510726153016869,
            0.336055568882658425},
        {1, 0.864664716763387308, 0.399576400893728049, 0.336182481449156594},
        {1.001, 0.864935116839650917, 0.399641750192769214,
            0.336309144675928584},
        {2, 0.98168436111126582, 0.373822536207754398, 0.380756373514429147},
        {10, 0.999999997938846378, 0.0999909202201628653, 0.170001815976578963},
        {100, 1, 0.01, 0.0197},
        {1e6, 1, 1e-6, 1.999997e-6}
    };

    for (const auto& [z, vv, vx, xx] : reference)
    {
        const law l(lanes::Constant(z));

        Eigen::Matrix2d C;
        C << vv, vx, vx, xx;

        EXPECT_LT(worst(covariance(l), C), 1e-13) << z;
        EXPECT_NEAR(l.decay(0), std::exp(-z), 1e-15) << z;
        EXPECT_NEAR(-l.gain(0)*z/std::expm1(-z), 1, 1e-13) << z;
    }
}


TEST(Brownian, doesNotKnowHowManySteps)
{
    for (int p = -32; p <= 24; ++p)
    {
        const double z = std::pow(10, 0.25*p);

        for (const int n : {2, 7})
        {
            const law part(lanes::Constant(z/n));

            Eigen::Matrix2d Phi;
            Phi << part.decay(0), 0, part.gain(0)/n, 1;

            // Lengths in those of the whole step
            const Eigen::DiagonalMatrix<double, 2> scale(1, 1.0/n);
            const Eigen::Matrix2d one = scale*covariance(part)*scale;

            Eigen::Matrix2d C = one;
            for (int j = 1; j < n; ++j)
            {
                C = (Phi*C*Phi.transpose() + one).eval();
            }

            EXPECT_LT
            (
                worst(C, covariance(law(lanes::Constant(z)))), 1e-12
            ) << z << ' ' << n;
        }
    }
}


// What a seed gives must not change from version to version. The bits are
// those of the test of counterRandom; the numbers were worked out of them by
// Box and Muller's formula with 30 digits.
TEST(Brownian, drawsAsEver)
{
    const double expected[2][3] =
    {
        {-0.9052581951799856, 1.58605365967429123, -0.864275704158212988},
        {0.411182022976975198, -0.283261401135656296, -0.553941654350617508}
    };

    particleArrays p = cloud(1);
    p.id(0) = 2;

    const double k = 1e6;
    const double h = 1.5e-6;
    const gasProperties gas = gasProperties::air();

    Brownian::increments increment;
    process()->increment(p, scalars::Constant(1, k), gas, h, 3, 4, increment);

    const double speed = std::sqrt(kB*gas.T/p.m(0));
    const Eigen::Matrix2d L = formulas(k*h).llt().matrixL();

    for (int c = 0; c < 3; ++c)
    {
        const Eigen::Vector2d expectation =
            L*Eigen::Vector2d(expected[0][c], expected[1][c]);

        EXPECT_NEAR(increment.v(c, 0)/speed, expectation(0), 1e-13);
        EXPECT_NEAR(increment.x(c, 0)/(speed*h), expectation(1), 1e-13);
    }
}


TEST(Brownian, kicksAreNormalWithTheCovarianceOfTheFormulas)
{
    const int n = 100000;
    const gasProperties gas = gasProperties::air();
    const double h = 3e-7;

    // No two are alike
    particleArrays p = cloud(n);
    scalars rate(n);

    for (int i = 0; i < n; ++i)
    {
        p.m(i) = 1e-17*(1 + i%17);
        rate(i) = 1e6*std::pow(10, 0.2*(i%13));
    }

    Brownian::increments increment;
    process()->increment(p, rate, gas, h, 7, 0, increment);

    Eigen::MatrixXd numbers(6, n);

    for (int i = 0; i < n; ++i)
    {
        const double speed = std::sqrt(kB*gas.T/p.m(i));
        const Eigen::Matrix2d L = formulas(rate(i)*h).llt().matrixL();

        Eigen::Matrix<double, 2, 3> vx;
        vx << increment.v.col(i).transpose()/speed,
            increment.x.col(i).transpose()/(speed*h);

        const Eigen::Matrix<double, 2, 3> z =
            L.triangularView<Eigen::Lower>().solve(vx);

        numbers.col(i) << z(0, 0), z(0, 1), z(0, 2), z(1, 0), z(1, 1), z(1, 2);
    }

    // The squares have the variance 2: independent, too
    const Eigen::MatrixXd C = numbers*numbers.transpose()/n;
    const Eigen::MatrixXd squares =
        ((numbers.array().square() - 1)/std::sqrt(2.0)).matrix();
    const Eigen::MatrixXd S = squares*squares.transpose()/n;

    for (int a = 0; a < 6; ++a)
    {
        EXPECT_NEAR(C(a, a), 1, normalLimit*std::sqrt(2.0/n));

        for (int b = 0; b < a; ++b)
        {
            EXPECT_NEAR(C(a, b), 0, normalLimit/std::sqrt(n));
            EXPECT_NEAR(S(a, b), 0, normalLimit/std::sqrt(n));
        }

        std::vector<double> sample(n);
        Eigen::Map<Eigen::RowVectorXd>(sample.data(), n) = numbers.row(a);
        std::sort(sample.begin(), sample.end());

        double distance = 0;
        for (int i = 0; i < n; ++i)
        {
            const double F = 0.5*std::erfc(-sample[i]/std::sqrt(2.0));
            distance =
                std::max({distance, F - i/double(n), (i + 1)/double(n) - F});
        }

        EXPECT_LT(distance*std::sqrt(n), KolmogorovLimit);
    }
}


// From equilibrium, and from rest: there one sees all that the noise brings
TEST(Brownian, keepsTheTemperatureOfTheGas)
{
    const int n = 20000;
    const int steps = 25;
    const double k = 1e6;
    const gasProperties gas = gasProperties::air();
    const particleArrays p = cloud(n);
    const double variance = kB*gas.T/p.m(0);
    const auto brownian = process();

    for (const double z : {0.01, 0.1, 1.0, 10.0, 100.0})
    {
        vectors v = thermal(n, variance);
        vectors fromRest = vectors::Zero(3, n);
        vectors x = vectors::Zero(3, n);
        Brownian::increments increment;

        for (int s = 0; s < steps; ++s)
        {
            brownian->increment
            (
                p, scalars::Constant(n, k), gas, z/k, s, 0, increment
            );
            advance(z/k, k, increment, x, v);
            advance(z/k, k, increment, x, fromRest);
        }

        const double tolerance = normalLimit*std::sqrt(2.0/(3*n));

        EXPECT_NEAR(v.squaredNorm()/n/(3*variance), 1, tolerance) << z;
        EXPECT_NEAR
        (
            fromRest.squaredNorm()/n/(-3*variance*std::expm1(-2*steps*z)),
            1,
            tolerance
        ) << z;
    }
}


// Stokes and Einstein: D = kB T Cc/(3 pi mu d), of 0.3 um
TEST(Brownian, diffusesAsEinsteinSays)
{
    const int n = 20000;
    const double d = 0.3e-6;
    const gasProperties gas = gasProperties::air();

    particleArrays p = cloud(n, 1000*pi/6*d*d*d);
    p.d.setConstant(d);
    p.mobilityDiameter = p.d;

    const scalars rate = drag::New
    (
        dictionary
        (
            IStringStream("type Stokes; slipCorrection Cunningham;")()
        )
    )->StokesRate(p, gas);

    const double Kn = 2*gas.meanFreePath/d;
    const double Cc = 1 + Kn*(1.257 + 0.4*std::exp(-1.1/Kn));
    const double D = kB*gas.T*Cc/(3*pi*gas.mu*d);
    const double tau = p.m(0)*D/(kB*gas.T);

    const double variance = kB*gas.T/p.m(0);
    const auto brownian = process();

    for (const double h : {0.1*tau, 2*tau, 1e4*tau})
    {
        const vectors v0 = thermal(n, variance);
        vectors v = v0;
        vectors x = vectors::Zero(3, n);
        Brownian::increments increment;

        for (int s = 1; s <= 30; ++s)
        {
            brownian->increment(p, rate, gas, h, s, 0, increment);
            advance(h, 1/tau, increment, x, v);

            if (s != 1 && s != 2 && s != 5 && s != 10 && s != 30)
            {
                continue;
            }

            const double t = s*h;
            const double memory = std::exp(-t/tau);

            EXPECT_NEAR
            (
                x.squaredNorm()/n/(6*D*(t - tau*(1 - memory))),
                1,
                normalLimit*std::sqrt(2.0/(3*n))
            ) << t/tau;

            EXPECT_NEAR
            (
                v.cwiseProduct(v0).sum()/(3*n*variance),
                memory,
                normalLimit*std::sqrt((1 + memory*memory)/(3*n))
            ) << t/tau;

            // The position knows the velocity that it came from, and that to
            // which it led: both <x v> are D (1 - memory)
            const double expected = D*(1 - memory);
            const double sigma = std::sqrt
            (
                (2*D*(t - tau*(1 - memory))*variance + expected*expected)/(3*n)
            );

            EXPECT_NEAR
            (
                x.cwiseProduct(v0).sum()/(3*n), expected, normalLimit*sigma
            ) << t/tau;
            EXPECT_NEAR
            (
                x.cwiseProduct(v).sum()/(3*n), expected, normalLimit*sigma
            ) << t/tau;
        }
    }

    // A textbook's value (Hinds): 6.9e-10 m2/s of 0.1 um, 2.7e-11 of 1 um
    EXPECT_GT(D, 2.7e-11);
    EXPECT_LT(D, 6.9e-10);
}


TEST(Brownian, partsComposeToTheWhole)
{
    const int n = 45;
    const double h = 2e-6;
    const gasProperties gas = gasProperties::air();
    const particleArrays p = cloud(n);
    const auto brownian = process();

    scalars rate(n);
    for (int i = 0; i < n; ++i)
    {
        rate(i) = std::pow(10, -6 + 0.25*i)/h;
    }

    Brownian::increments whole;
    brownian->increment(p, rate, gas, h, 3, 0, whole);

    // Whether it is likely or not
    whole.v.col(20) *= 30;
    whole.x.col(30).setZero();

    std::vector<Brownian::increments> parts;

    for (const int m : {1, 2, 3, 10, 100})
    {
        brownian->bridge(p, rate, gas, h, 3, 1, m, whole, parts);
        ASSERT_EQ(parts.size(), std::size_t(m));

        for (int i = 0; i < n; ++i)
        {
            vectors x = vectors::Zero(3, 1);
            vectors v = vectors::Zero(3, 1);

            for (const Brownian::increments& part : parts)
            {
                advance(h/m, rate(i), {part.v.col(i), part.x.col(i)}, x, v);
            }

            const law l(lanes::Constant(rate(i)*h));
            const double speed = std::sqrt(kB*gas.T/p.m(i));
            const Eigen::Matrix2d C = covariance(l);

            const double sigmaV = speed*std::sqrt(C(0, 0));
            const double sigmaX = speed*h*std::sqrt(C(1, 1));
            const double tolerance = 1e-13*std::sqrt(m);

            EXPECT_LT((v - whole.v.col(i)).norm(), 30*tolerance*sigmaV)
                << rate(i)*h << ' ' << m;
            EXPECT_LT((x - whole.x.col(i)).norm(), 30*tolerance*sigmaX)
                << rate(i)*h << ' ' << m;
        }
    }
}


TEST(Brownian, partsAreDistributedAsThoseOfAFreeParticle)
{
    const int n = 30000;
    const int m = 3;
    const double h = 2e-6;
    const gasProperties gas = gasProperties::air();
    const particleArrays p = cloud(n);
    const double speed = std::sqrt(kB*gas.T/p.m(0));
    const auto brownian = process();

    for (const double z : {1e-3, 0.03, 0.3, 3.0, 100.0})
    {
        const scalars rate = scalars::Constant(n, z/h);

        Brownian::increments whole;
        std::vector<Brownian::increments> parts;
        brownian->increment(p, rate, gas, h, 3, 0, whole);
        brownian->bridge(p, rate, gas, h, 3, 1, m, whole, parts);

        const law l(lanes::Constant(z/m));
        const double sigmaX = speed*l.x(0)*h/m;

        // All that is independent in a free particle
        Eigen::MatrixXd numbers(2*m, 3*n);
        for (int j = 0; j < m; ++j)
        {
            const vectors& v = parts[j].v;
            const vectors rest = (parts[j].x - l.slope(0)*h/m*v)/sigmaX;

            numbers.row(2*j) = v.reshaped().transpose()/(speed*l.v(0));
            numbers.row(2*j + 1) = rest.reshaped().transpose();
        }

        const Eigen::MatrixXd C = numbers*numbers.transpose()/(3*n);

        for (int a = 0; a < 2*m; ++a)
        {
            EXPECT_NEAR(C(a, a), 1, normalLimit*std::sqrt(2.0/(3*n))) << z;

            for (int b = 0; b < a; ++b)
            {
                EXPECT_NEAR(C(a, b), 0, normalLimit/std::sqrt(3*n))
                    << z << ' ' << a << ' ' << b;
            }
        }
    }
}


TEST(Brownian, belongsToTheParticleNotToItsPlace)
{
    const int n = 53;
    const double h = 1e-6;
    const gasProperties gas = gasProperties::air();
    const auto brownian = process();

    particleArrays p = cloud(n);
    scalars rate(n);
    for (int i = 0; i < n; ++i)
    {
        p.m(i) = 1e-17*(1 + i);
        rate(i) = 1e5*(1 + i);
    }

    // Others first, and not all of them
    const int m = 37;
    particleArrays q = cloud(m);
    scalars rateQ(m);
    const auto place = [&](const int i) { return (i*20 + 11)%n; };

    for (int i = 0; i < m; ++i)
    {
        q.id(i) = p.id(place(i));
        q.m(i) = p.m(place(i));
        rateQ(i) = rate(place(i));
    }

    Brownian::increments a, b;
    brownian->increment(p, rate, gas, h, 3, 0, a);
    brownian->increment(q, rateQ, gas, h, 3, 0, b);

    std::vector<Brownian::increments> partsA, partsB;
    brownian->bridge(p, rate, gas, h, 3, 1, 4, a, partsA);
    brownian->bridge(q, rateQ, gas, h, 3, 1, 4, b, partsB);

    for (int i = 0; i < m; ++i)
    {
        EXPECT_EQ(a.v.col(place(i)), b.v.col(i));
        EXPECT_EQ(a.x.col(place(i)), b.x.col(i));

        for (int j = 0; j < 4; ++j)
        {
            EXPECT_EQ(partsA[j].v.col(place(i)), partsB[j].v.col(i));
            EXPECT_EQ(partsA[j].x.col(place(i)), partsB[j].x.col(i));
        }
    }
}


TEST(Brownian, isRepeatedBySeedStepAndBlockOnly)
{
    const int n = 30000;
    const gasProperties gas = gasProperties::air();
    const particleArrays p = cloud(n);
    const scalars rate = scalars::Constant(n, 1e6);

    const auto draw = [&](const int seed, const int step, const int block)
    {
        Brownian::increments k;
        process(seed)->increment(p, rate, gas, 1e-6, step, block, k);
        return k;
    };

    const Brownian::increments k = draw(1, 2, 3);

    EXPECT_TRUE(same(draw(1, 2, 3), k));
    EXPECT_FALSE(same(draw(4, 2, 3), k));

    Brownian::increments byDefault;
    make("type OrnsteinUhlenbeck;")->increment
    (
        p, rate, gas, 1e-6, 2, 3, byDefault
    );
    EXPECT_TRUE(same(byDefault, k));

    for (const auto& other : {draw(4, 2, 3), draw(1, 4, 3), draw(1, 2, 4)})
    {
        EXPECT_NEAR
        (
            k.v.cwiseProduct(other.v).sum()/(k.v.norm()*other.v.norm()),
            0,
            normalLimit/std::sqrt(3*n)
        );
        EXPECT_NEAR
        (
            k.x.cwiseProduct(other.x).sum()/(k.x.norm()*other.x.norm()),
            0,
            normalLimit/std::sqrt(3*n)
        );
    }
}


TEST(Brownian, growsWithTheRootOfTemperatureOverMass)
{
    const int n = 20;
    const scalars rate = scalars::LinSpaced(n, 1e4, 1e8);
    const auto brownian = process();

    gasProperties gas = gasProperties::air();
    Brownian::increments cold, hot, heavy;

    brownian->increment(cloud(n), rate, gas, 1e-6, 0, 0, cold);
    gas.T *= 3;
    brownian->increment(cloud(n), rate, gas, 1e-6, 0, 0, hot);
    brownian->increment(cloud(n, 5e-17), rate, gas, 1e-6, 0, 0, heavy);

    EXPECT_LT(worst(hot.v, std::sqrt(3.0)*cold.v), 1e-14);
    EXPECT_LT(worst(hot.x, std::sqrt(3.0)*cold.x), 1e-14);
    EXPECT_LT(worst(heavy.v, std::sqrt(0.2)*hot.v), 1e-14);
    EXPECT_LT(worst(heavy.x, std::sqrt(0.2)*hot.x), 1e-14);
}


// Floating-point errors stop these tests
TEST(Brownian, doesNotMindExtremes)
{
    const int n = 20;
    const gasProperties gas = gasProperties::air();
    const particleArrays p = cloud(n);
    const auto brownian = process();

    for (const double z : {0.0, 1e-18, 1e-12, 1e4, 1e12})
    {
        for (const double h : {1e-12, 1e-6, 1.0})
        {
            const scalars rate = scalars::Constant(n, z/h);

            Brownian::increments whole;
            std::vector<Brownian::increments> parts;
            brownian->increment(p, rate, gas, h, 0, 0, whole);
            brownian->bridge(p, rate, gas, h, 0, 1, 5, whole, parts);

            ASSERT_TRUE(whole.v.allFinite() && whole.x.allFinite());

            for (const Brownian::increments& part : parts)
            {
                ASSERT_TRUE(part.v.allFinite() && part.x.allFinite());

                // Without drag the molecules do not meet the particle
                EXPECT_EQ(part.v.norm() == 0, z == 0);
                EXPECT_EQ(part.x.norm() == 0, z == 0);
            }

            EXPECT_EQ(whole.v.norm() == 0, z == 0);
            EXPECT_EQ(whole.x.norm() == 0, z == 0);
        }
    }

    Brownian::increments nobody;
    brownian->increment(cloud(0), scalars(0), gas, 1e-6, 0, 0, nobody);
    EXPECT_EQ(nobody.v.cols(), 0);
}


TEST(Brownian, straysAsTheBridgeDoes)
{
    const int n = 3000;
    const gasProperties gas = gasProperties::air();
    const double k = 1e5;
    const particleArrays p = cloud(n);
    const scalars rate = scalars::Constant(n, k);
    const double variance = kB*gas.T/p.m(0);

    for (const double z : {1e-6, 1e-3, 0.3, 3.0, 30.0, 1e6})
    {
        const double h = z/k;
        const Brownian::extent all = process()->reach(p, rate, gas, h);

        Brownian::increments whole;
        std::vector<Brownian::increments> parts;
        process()->increment(p, rate, gas, h, 1, 0, whole);

        // A known end: that at rest in the origin
        const Brownian::increments still{0*whole.v, 0*whole.x};
        process()->bridge(p, rate, gas, h, 1, 1, 2, still, parts);

        const double tolerance = normalLimit*std::sqrt(2.0/(3*n));
        const auto meanSqr = [&](const vectors& values)
        {
            return values.squaredNorm()/(3*n);
        };

        EXPECT_NEAR
        (
            meanSqr(whole.v)/(all.v(0)*all.v(0)), 1, tolerance
        ) << z;
        EXPECT_NEAR
        (
            meanSqr(whole.x)/(all.x(0)*all.x(0)), 1, tolerance
        ) << z;
        EXPECT_NEAR(4*meanSqr(parts[0].x)/all.stray(0), 1, tolerance) << z;

        // The cubic of integrated noise, and the line of Wiener's process
        if (z < 1e-2)
        {
            EXPECT_NEAR
            (
                all.stray(0)/(2*k*variance*h*h*h/48), 1, z + 1e-6
            );
        }
        if (z > 1e3)
        {
            EXPECT_NEAR(all.stray(0)/(2*variance/k*h), 1, 10/z);
        }
    }
}


TEST(Brownian, noneIsNothing)
{
    const auto none = make("type none;");

    EXPECT_FALSE(none->active());
    EXPECT_TRUE(process()->active());

    Brownian::increments k{vectors::Ones(3, 2), vectors::Ones(3, 2)};
    std::vector<Brownian::increments> parts{k};
    const scalars rate = scalars::Ones(2);

    none->increment(cloud(2), rate, gasProperties::air(), 1, 0, 0, k);
    none->bridge(cloud(2), rate, gasProperties::air(), 1, 0, 1, 3, k, parts);

    EXPECT_EQ(k.v.cols(), 0);
    EXPECT_EQ(k.x.cols(), 0);
    ASSERT_EQ(parts.size(), 3u);
    EXPECT_EQ(parts[0].v.cols(), 0);
}


TEST(Brownian, rejectsWhatItDoesNotKnow)
{
    EXPECT_THROW(make("type Wiener;"), IOerror);
    EXPECT_THROW(make("seed 1;"), IOerror);
    EXPECT_THROW(make("type OrnsteinUhlenbeck; sead 2;"), IOerror);
    EXPECT_THROW(make("type OrnsteinUhlenbeck; seed -1;"), IOerror);
    EXPECT_THROW(make("type OrnsteinUhlenbeck; seed 1.5;"), IOerror);
    EXPECT_NO_THROW(make("type OrnsteinUhlenbeck; seed 0;"));
}


// ************************************************************************* //
