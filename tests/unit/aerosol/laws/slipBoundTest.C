/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "equationOfMotion.H"
#include "wakeTools.H"
#include "error.H"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <sstream>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pi = EIGEN_PI;
const double omega = 2*pi*1400;

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


dictionary laws(const std::string& wake)
{
    return dictionary
    (
        IStringStream
        (
            "drag { type Stokes; slipCorrection Cunningham; }"
            "gravity { type uniform; value (0 0 -9.81); }"
            "wake { " + wake + " } aggregate { type none; }"
        )()
    );
}


//- Slip in a sound of 1.53 m/s at 1400 Hz, by hand
double slip(const particleArrays& p, const int i)
{
    const gasProperties gas = gasProperties::air();
    const double Kn = 2*gas.meanFreePath/p.d(i);
    const double Cc = 1 + Kn*(1.257 + 0.4*std::exp(-1.1/Kn));
    const double tau = p.m(i)*Cc/(3*pi*gas.mu*p.d(i));
    const double s = omega*tau;
    const double displaced = gas.rho*pi/6*std::pow(p.d(i), 3);

    return s/std::sqrt(1 + s*s)*1.53 + tau*9.81*(1 - displaced/p.m(i));
}


//- Momentum of the gas up to r, less its density, in the direction of the slip:
//  of a sphere of radius a much smaller than r, with slip U
double momentum(const double a, const double U, const double r)
{
    const int shells = 60;
    const int angles = 400;
    std::vector<source> sources;
    std::vector<double> weights;

    for (int k = 0; k < shells; ++k)
    {
        const double R = r*(k + 0.5)/shells;

        for (int m = 0; m < angles; ++m)
        {
            // 1 - cos(theta) = s^2 resolves the wake
            const double s = std::sqrt(2.0)*(m + 0.5)/angles;
            const double c = 1 - s*s;

            sources.push_back
                ({R*vec(c, std::sqrt(1 - c*c), 0), vec(U, 0, 0), a});
            weights.push_back
                (2*pi*R*R*r/shells*2*s*std::sqrt(2.0)/angles);
        }
    }

    const std::vector<vec> v = disturbances("Oseen", sources);
    double sum = 0;

    for (std::size_t n = 0; n < v.size(); ++n)
    {
        sum -= weights[n]*v[n].x();
    }

    return sum;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(slipBound, isEntrainmentAndSettling)
{
    scalars rate(3);
    rate << 1e2, 1e4, 1e12;
    vectors g = vectors::Zero(3, 3);
    g.row(2).setConstant(-9.81);

    const scalars all = slipBound(1400, 1.53).slip(rate, g);
    const scalars fall = slipBound().slip(rate, g);

    for (int i = 0; i < 3; ++i)
    {
        const double s = omega/rate(i);

        EXPECT_NEAR(fall(i)*rate(i)/9.81, 1, 1e-14);
        EXPECT_NEAR
        (
            all(i)/(1.53*s/std::sqrt(1 + s*s) + 9.81/rate(i)), 1, 1e-13
        );
    }

    // Steady gas of any velocity
    EXPECT_TRUE((slipBound(0, 10).slip(rate, g) == fall).all());

    // Without drag: the gas passes, and nothing limits the fall
    const scalars none = scalars::Zero(3);
    EXPECT_TRUE((slipBound().slip(none, g) == GREAT).all());
    EXPECT_TRUE
    (
        (slipBound(1400, 1.53).slip(none, 0*g) - 1.53).abs().maxCoeff() < 1e-15
    );
}


TEST(slipBound, boundsTheSlipInASound)
{
    // On the periodic path that Stokes' drag leads to
    const slipBound bound(1400, 1.53);

    for (const double tau : {1e-7, 1e-5, 1e-4, 1e-2})
    {
        const std::complex<double> H =
            1.0 - 1.0/std::complex<double>(1, omega*tau);

        EXPECT_NEAR
        (
            bound.slip(scalars::Constant(1, 1/tau), vectors::Zero(3, 1))(0)
           /(1.53*std::abs(H)),
            1,
            1e-12
        );
    }
}


TEST(slipBound, limitsTheMomentumOfAWakeToThatOfTheDrag)
{
    const double nu = gasProperties::air().nu();
    const double a = 1e-9;

    for (const double U : {1e-4, 0.01, 0.1, 0.5, 1.5, 10.0})
    {
        for (const double f : {100.0, 1400.0, 20000.0})
        {
            const double r = slipBound(f, 1).longestRange(U, nu);
            const double given = 6*pi*nu*a*U/(2*pi*f);

            EXPECT_LT(momentum(a, U, r)/given, 1.12) << U << ' ' << f;
            EXPECT_GT(momentum(a, U, r)/given, 0.98) << U << ' ' << f;
        }
    }

    // Its limits: 1.2 Stokes layers, or the amplitude of the slip
    const slipBound sound(1400, 1);
    EXPECT_NEAR
    (
        sound.longestRange(0, nu), std::sqrt(1.5)*std::sqrt(2*nu/omega), 1e-12
    );
    EXPECT_NEAR(sound.longestRange(1e3, nu)*omega/1e3, 1, 1e-3);
    EXPECT_EQ(slipBound().longestRange(1, nu), GREAT);
}


TEST(slipBound, saysHowFastWakesAreWhereTheyFade)
{
    // In the wake, far away, Oseen's is 3U/2R; by default a coarse one is there
    // far above the tolerance, as its range is limited
    const gasProperties gas = gasProperties::air();
    particleArrays p = spheres({0.3e-6, 1e-6, 3e-6, 10e-6}, 2300);

    for (const char* type : {"Oseen", "ProudmanPearson", "memory", "history"})
    {
        equationOfMotion motion
        (
            laws(std::string("type ") + type + ';'),
            gas,
            Eigen::Array3d::Ones(),
            {1400, 1.53}
        );
        motion.laws().chooseTolerance(p);
        motion.laws().refresh(p);

        const double r = std::sqrt(0.5)*p.range(3);
        const double bound = 1.5*5e-6*slip(p, 3)/r;
        const double speed = motion.wakes().fadingSpeed(p, 3);

        if (motion.laws().wakeModel().omega() > 0)
        {
            EXPECT_GT(speed, 0) << type;
            EXPECT_LT(speed, 0.2*bound) << type;
        }
        else
        {
            EXPECT_NEAR(speed/bound, 1, 0.02) << type;
            EXPECT_GT(speed, 5*motion.laws().wakeModel().tolerance()) << type;
        }
    }
}


TEST(slipBound, givesTheRangesOfTheWakes)
{
    const gasProperties gas = gasProperties::air();
    particleArrays p = spheres({0.3e-6, 1e-6, 3e-6, 10e-6}, 2300);

    const auto refresh = [&](const std::string& wake, const slipBound& slips)
    {
        equationOfMotion motion
            (laws(wake), gas, Eigen::Array3d::Ones(), slips);

        if (motion.laws().wakeModel().needsTolerance())
        {
            motion.laws().chooseTolerance(p);
        }
        motion.laws().refresh(p);

        return motion.laws().wakeModel().tolerance();
    };

    refresh("type Oseen; range 20;", {1400, 1.53});
    for (int i = 0; i < p.size(); ++i)
    {
        EXPECT_NEAR(p.range(i)/(20*p.d(i)), 1, 1e-14);
    }

    EXPECT_EQ(refresh("type Oseen; tolerance 2e-3;", {1400, 1.53}), 2e-3);
    for (int i = 0; i < p.size(); ++i)
    {
        EXPECT_NEAR(p.range(i)/(0.75*p.d(i)*slip(p, i)/2e-3), 1, 1e-12);
    }

    // By default half a mean radius; the large ones meet the limit
    const double t = refresh("type Oseen;", {1400, 1.53});
    EXPECT_NEAR(t/(0.5*omega*0.5*14.3e-6/4), 1, 1e-13);

    int limited = 0;
    for (int i = 0; i < p.size(); ++i)
    {
        const double A = slip(p, i)/omega;
        const double limit = A/2 + std::sqrt(A*A/4 + 3*gas.nu()/omega);
        const double range = 0.75*p.d(i)*slip(p, i)/t;

        EXPECT_NEAR(p.range(i)/std::min(range, limit), 1, 1e-12);
        limited += limit < range;
    }
    EXPECT_EQ(limited, 2);

    // Without sound a quarter of the mean settling speed
    const double still = refresh("type Oseen;", {});
    const scalars speed = slipBound::settling(p.rate, p.acceleration);

    EXPECT_NEAR(still/(0.25*speed.mean()), 1, 1e-13);
    for (int i = 0; i < p.size(); ++i)
    {
        EXPECT_NEAR(p.range(i)/(0.75*p.d(i)*speed(i)/still), 1, 1e-12);
    }

    // One that has grown has the range of its new size
    equationOfMotion motion
        (laws("type Oseen;"), gas, Eigen::Array3d::Ones(), {1400, 1.53});
    motion.laws().setTolerance(t);
    p = spheres({2e-6}, 2300);
    motion.laws().refresh(p);
    EXPECT_NEAR(p.range(0)/(0.75*2e-6*slip(p, 0)/t), 1, 1e-12);
}


TEST(slipBound, keepsWhatIsLeftOutBelowTheTolerance)
{
    const gasProperties gas = gasProperties::air();
    const double length = 1e-3;
    randomNumbers random(1);

    std::vector<double> d;
    for (int i = 0; i < 300; ++i)
    {
        d.push_back(random.logUniform(0.5e-6, 10e-6));
    }

    particleArrays p = spheres(d, 2300);
    const vectors u = vectors::Zero(3, p.size());
    std::vector<particlePair> pairs;

    for (int i = 0; i < p.size(); ++i)
    {
        p.x.col(i) =
            length*random.logUniform(0.1, 1)*random.direction();

        // Up to what sound and gravity can do together
        p.v.col(i) = slip(p, i)*random.logUniform(0.3, 1)*random.direction();

        for (int j = 0; j < p.size(); ++j)
        {
            if (i != j)
            {
                pairs.push_back({i, j, {0, 0, 0}});
            }
        }
    }

    for (const char* type : {"Oseen", "ProudmanPearson"})
    {
        double tolerance = 0.04;
        scalars before;
        vectors w0;
        double largest = 0;

        for (int n = 0; n < 6; ++n)
        {
            std::ostringstream wake;
            wake << "type " << type << "; tolerance " << tolerance << ';';

            equationOfMotion motion
            (
                laws(wake.str()),
                gas,
                Eigen::Array3d::Ones(),
                {1400, 1.53}
            );
            motion.laws().refresh(p);

            vectors w;
            motion.wakes().sum(p, pairs, p.x, p.v, u, w);

            for (int i = 0; n && i < p.size(); ++i)
            {
                int added = 0;

                for (int j = 0; j < p.size(); ++j)
                {
                    const double r = (p.x.col(i) - p.x.col(j)).norm();
                    added +=
                        j != i && r > 0.7*before(j) && r <= p.range(j);
                }

                const double change = (w.col(i) - w0.col(i)).norm();

                EXPECT_LE(change, 1.02*2*tolerance*added + 1e-12);
                largest = std::max(largest, change);
            }

            before = p.range;
            w0 = w;
            tolerance /= 2;
        }

        // Something has changed
        EXPECT_GT(largest, 1e-3) << type;
    }
}


// ************************************************************************* //
