/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "measured.H"
#include "quiescent.H"
#include "syntheticTurbulence.H"
#include "timeSteppingTools.H"
#include "turbulentGas.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double nu = gasProperties::air().nu();

periodicBox boxOf(const std::string& lengths)
{
    return periodicBox(parse("centre (1e-3 0 0); length " + lengths + ";"));
}


//- Says nothing about itself here
template<class Make>
auto quietly(const Make& make)
{
    const int level = messageStream::level;
    messageStream::level = 0;
    auto made = make();
    messageStream::level = level;
    return made;
}


acoustics::soundField& restingGas()
{
    static std::unique_ptr<acoustics::soundField> rest
    (
        sound<acoustics::quiescent>("type quiescent;")
    );

    return *rest;
}


autoPtr<syntheticTurbulence> turbulenceOf
(
    const std::string& entries,
    const domain& box
)
{
    return quietly
    (
        [&]
        {
            return autoPtr<syntheticTurbulence>
            (
                new syntheticTurbulence
                (
                    parse("type syntheticTurbulence; " + entries),
                    box,
                    restingGas()
                )
            );
        }
    );
}


vec at(const turbulence& eddies, const double t, const vec& x)
{
    vectors u = vectors::Zero(3, 1);
    eddies.add(t, x, u);
    return u;
}


//- That of the gas as a whole, in a domain of these edges: waves of up to four
//  cycles have no mean over 5 x 5 x 5 points
vec asAWhole(const turbulence& eddies, const double t, const vec& edges)
{
    vectors x(3, 125);
    for (int n = 0; n < x.cols(); ++n)
    {
        x.col(n) = edges.cwiseProduct(vec(n % 5, n/5 % 5, n/25))/5;
    }

    vectors u = vectors::Zero(3, x.cols());
    eddies.add(t, x, u);
    return u.rowwise().mean();
}


//- Gradient du_i/dx_j, by differences of fourth order
Eigen::Matrix3d gradientAt
(
    const turbulence& eddies,
    const double t,
    const vec& x,
    const double h
)
{
    Eigen::Matrix3d gradient;

    for (int j = 0; j < 3; ++j)
    {
        const vec e = h*vec::Unit(j);

        gradient.col(j) =
            (
                8*(at(eddies, t, x + e) - at(eddies, t, x - e))
              - (at(eddies, t, x + 2*e) - at(eddies, t, x - 2*e))
            )/(12*h);
    }

    return gradient;
}


//- Gas with turbulence
turbulentGas* turbulent
(
    acoustics::soundField& gas,
    const std::string& entries,
    const domain& box
)
{
    return quietly
    (
        [&]
        {
            turbulentGas* result = new turbulentGas
            (
                gas, parse("type syntheticTurbulence; " + entries), box
            );
            result->prepare(box.bounds());
            return result;
        }
    );
}


//- Gas that is at rest but for turbulence
acoustics::soundField* turbulentRest
(
    const std::string& entries,
    const domain& box
)
{
    return turbulent(restingGas(), entries, box);
}

class turbulentKernel
:
    public testing::TestWithParam<std::string>
{};

//- By its edge [m]
class boxOfFlyAsh
:
    public testing::TestWithParam<double>
{};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

INSTANTIATE_TEST_SUITE_P
(
    timeStepping,
    turbulentKernel,
    testing::Values(multipleTimeStep, eventDriven),
    [](const testing::TestParamInfo<std::string>& stepping)
    {
        return stepping.index ? "eventDriven" : "multipleTimeStep";
    }
);


INSTANTIATE_TEST_SUITE_P
(
    turbulence,
    boxOfFlyAsh,
    testing::ValuesIn
    (
        full()
      ? std::vector<double>{0.5e-3, 1e-3, 2e-3}
      : std::vector<double>{0.5e-3}
    ),
    [](const testing::TestParamInfo<double>& edge)
    {
        return "of" + std::to_string(std::lround(1e6*edge.param)) + "um";
    }
);


TEST(syntheticTurbulence, hasIsotropicGradientsWithoutDivergence)
{
    // <du_i/dx_j du_p/dx_q> = G^2/30 (4 d_ip d_jq - d_ij d_pq - d_iq d_jp), of
    // any incompressible isotropic field
    for (const char* const edges : {"1e-3", "(2.2e-3 1e-3 1.1e-3)"})
    {
        const periodicBox box = boxOf(edges);
        const auto eddies = turbulenceOf
        (
            "dissipation 10; timeScale 1e-3; accelerationFactor 0; seed 5;", box
        );
        const double G = std::sqrt(10/nu);
        EXPECT_NEAR(eddies->shearRate(), G, 1e-9*G);

        const int samples = 20000;
        randomNumbers random(1);
        Eigen::Matrix<double, 9, 9> covariance;
        covariance.setZero();
        double divergence = 0;
        double square = 0;

        for (int n = 0; n < samples; ++n)
        {
            // Each time has numbers of its own
            const double t = 3.1e-3*(n + random.uniform(0, 1));
            const vec x = random.point(2e-3);
            const Eigen::Matrix3d A = gradientAt(*eddies, t, x, 1e-6);
            const Eigen::Map<const Eigen::Matrix<double, 9, 1>> a(A.data());

            covariance += a*a.transpose()/samples;
            divergence = std::max(divergence, std::abs(A.trace()));
            square += at(*eddies, t, x).squaredNorm()/(3*samples);
        }

        double off = 0;

        for (int ij = 0; ij < 9; ++ij)
        {
            for (int pq = 0; pq < 9; ++pq)
            {
                const int i = ij % 3;
                const int j = ij/3;
                const int p = pq % 3;
                const int q = pq/3;
                const double exact =
                    (4*(i == p)*(j == q) - (i == j)*(p == q)
                  - (i == q)*(j == p))/30.0;

                off = std::max
                (
                    off, std::abs(covariance(ij, pq)/(G*G) - exact)
                );
            }
        }

        measured
        (
            "%s: <|grad u|^2> nu/epsilon %.4f, largest error of the covariance "
            "%.2g, divergence %.2g, speed %.4f of that expected\n",
            edges, covariance.trace()/(G*G), off, divergence/G,
            std::sqrt(square)/eddies->speed()
        );

        // Of 2/15 at most, whose sampling error is 2/15 sqrt(2/20000)
        EXPECT_NEAR(covariance.trace()/(G*G), 1, 0.01);
        EXPECT_LT(off, 5e-3);
        EXPECT_LT(divergence, 1e-7*G);
        EXPECT_NEAR(std::sqrt(square)/eddies->speed(), 1, 0.01);
    }
}


TEST(syntheticTurbulence, isPeriodicAndSmooth)
{
    const periodicBox box = boxOf("(2e-3 1e-3 3e-3)");
    const auto eddies =
        turbulenceOf("dissipation 1; accelerationFactor 0; seed 2;", box);
    const double T = eddies->timeScale();
    EXPECT_NEAR(T, 2.3*std::sqrt(nu), 1e-9*T);

    const double u = eddies->speed();
    randomNumbers random(1);
    double last = 0;

    for (int n = 0; n < 200; ++n)
    {
        const vec x = random.point(3e-3);
        const double t = random.uniform(0, 100*T);
        const vec image = x + vec(2e-3, -1e-3, 9e-3);

        EXPECT_LT((at(*eddies, t, x) - at(*eddies, t, image)).norm(), 1e-11*u);

        // In time, also where random numbers change
        const double interval = T/syntheticTurbulence::timeScaleOfInterval;
        const double change = n*interval;
        const double h = 1e-4*interval;
        const vec bend =
            at(*eddies, change + h, x) - 2*at(*eddies, change, x)
          + at(*eddies, std::max(change - h, 0.0), x);
        last = std::max(last, bend.norm());
        EXPECT_LT(bend.norm(), n ? 1e-8*u : 1e-7*u);
    }
}


TEST(syntheticTurbulence, isAFunctionOfSeedAndTime)
{
    const periodicBox box = boxOf("1e-3");
    const auto one = turbulenceOf("shearRate 500; seed 2;", box);
    const auto other = turbulenceOf("shearRate 500; seed 2;", box);
    const auto third = turbulenceOf("shearRate 500; seed 3;", box);

    vectors x(3, 700);
    randomNumbers random(1);
    for (int i = 0; i < x.cols(); ++i)
    {
        x.col(i) = random.point(1e-3);
    }

    at(*other, 17.3, x.col(3));

    for (const double t : {0.0, 0.0123, 4.0})
    {
        vectors u = vectors::Zero(3, x.cols());
        one->add(t, x, u);

        for (int i = 0; i < x.cols(); ++i)
        {
            // To the last bit, wherever it is in the array
            EXPECT_EQ(u.col(i), at(*other, t, x.col(i)));
            EXPECT_NE(u.col(i), at(*third, t, x.col(i)));
        }
    }
}


TEST(syntheticTurbulence, acceleratesTheGasAsTurbulenceDoesInAnyBox)
{
    // Saffman and Turner: 1.3 epsilon^1.5 nu^-0.5 of each component along the
    // path of the gas, whatever the size of the box and the waves; and normally
    // distributed, which the rate of contacts depends on
    const double G = 200;
    const double expected = 1.3*nu*G*G*G;

    for
    (
        const auto& [edge, wavelength] :
        std::vector<std::pair<double, double>>
        {
            {0.5e-3, 0}, {1e-3, 0}, {2e-3, 0}, {2e-3, 1e-3}, {2e-3, 0.5e-3},
            {6e-3, 0}
        }
    )
    {
        const periodicBox box = boxOf(std::to_string(edge));
        const auto eddies = turbulenceOf
        (
            "shearRate 200;"
          + (
                wavelength > 0
              ? " wavelength " + std::to_string(wavelength) + ";"
              : std::string()
            ),
            box
        );

        // Each time has numbers of its own
        const int samples = 10000;
        const int points = 4;
        const double h = 1e-3/G;
        randomNumbers random(1);
        double square = 0;
        double size = 0;
        double later = 0;
        double gradient = 0;

        for (int n = 0; n < samples; ++n)
        {
            const double t = 8/G*(n + random.uniform(0, 1));

            for (int k = 0; k < points; ++k)
            {
                const vec x = random.point(edge);
                const vec u = at(*eddies, t, x);
                const vec after = at(*eddies, t + h, x + h*u);
                const vec before = at(*eddies, t - h, x - h*u);
                const vec a = (after - before)/(2*h);

                square += a.squaredNorm()/(3*samples*points);
                size += a.cwiseAbs().sum()/(3*samples*points);

                if (k == 0)
                {
                    gradient +=
                        gradientAt(*eddies, t, x, 1e-3*edge).squaredNorm()
                       /samples;
                }
            }

            if (n % 5 == 0)
            {
                const auto change = [&](const double at)
                {
                    const vec edges = vec::Constant(edge);

                    return vec
                    (
                        asAWhole(*eddies, at + h, edges)
                      - asAWhole(*eddies, at - h, edges)
                    );
                };

                later +=
                    change(t).dot(change(t + 2.2/G))/(4*h*h)/(3*samples/5);
            }
        }

        const double normal = size/std::sqrt(2/pi*square);

        measured
        (
            "box %.2g m, wavelength %.2g: <a^2>/theory %.4f, mean modulus over "
            "that of a normal distribution %.4f, correlation after 2.2/G %.3f, "
            "<|grad u|^2> nu/epsilon %.4f\n",
            edge, wavelength, square/expected, normal, later/expected,
            gradient/(G*G)
        );

        // Samples of the gas as a whole depend little on chance, as its
        // amplitudes are known; of the waves, a quarter at most, each time
        // has sqrt(2/52)
        EXPECT_NEAR(square/expected, 1, 0.03);
        EXPECT_NEAR(normal, 1, 0.015);
        EXPECT_NEAR(later/expected, 0, 0.1);
        EXPECT_NEAR(gradient/(G*G), 1, 0.02);
    }
}


TEST(syntheticTurbulence, disperses)
{
    // Where it changes much faster than it moves anything, <x^2> = 2 u^2 T t in
    // each direction, with the integral time scale T
    const periodicBox box = boxOf("1e-3");
    const double T = 1e-5;
    const auto eddies = turbulenceOf
    (
        "shearRate 500; timeScale 1e-5; accelerationFactor 0;", box
    );
    const double interval = T/syntheticTurbulence::timeScaleOfInterval;

    const int paths = 600;
    const int intervals = 40;
    const int steps = 10;
    const double h = interval/steps;
    double square = 0;
    double t = 0;

    for (int path = 0; path < paths; ++path)
    {
        // Between the numbers that others have
        t += 2*interval;
        const vec start(1e-4, 3e-4, -2e-4);
        vec x = start;

        for (int n = 0; n < intervals*steps; ++n)
        {
            x += h*at(*eddies, t + 0.5*h, x);
            t += h;
        }

        square += (x - start).squaredNorm()/(3*paths);
    }

    // A path over n intervals is the sum of n + 1 random numbers: 2 I of each,
    // with the integral I of the sine of theta, but I of the first and the last
    double I = 0;
    for (int n = 0; n < 1000; ++n)
    {
        const double s = (n + 0.5)/1000;
        I += std::sin(0.5*pi*s*s*s*(10 - s*(15 - 6*s)))/1000;
    }
    EXPECT_NEAR(2*I*I, syntheticTurbulence::timeScaleOfInterval, 1e-6);

    const double expected =
        eddies->speed()*eddies->speed()*interval*interval
       *(4*(intervals - 1) + 2)*I*I;

    measured
    (
        "<x^2>/theory %.3f; over 2 u^2 T t %.3f\n", square/expected,
        square/(2*std::pow(eddies->speed(), 2)*T*intervals*interval)
    );

    // 1800 displacements, normally distributed and independent
    EXPECT_NEAR(square/expected, 1, 4*std::sqrt(2.0/(3*paths)));
}


TEST_P(turbulentKernel, bringsParticlesTogetherAtSaffmanAndTurnersRate)
{
    // K = sqrt(8 pi/15) G (d1 + d2)^3/8 of spheres that follow the gas and pass
    // through one another: exact for a Gaussian gradient, whether it lasts or
    // not, as all places are independent at all times. Here the waves are 100
    // diameters long, for which it is 0.1 % less.
    const double G = 1000;
    const double d = 10e-6;
    const double tau = 0.01/G;
    const double density = 18*gasProperties::air().mu*tau/(d*d);
    const double length = 1e-3;
    const int number = 4000;
    const double end = (full() ? 600 : 50)/G;
    const double h = 0.1/G;

    randomNumbers random(1);
    std::vector<sphere> spheres;
    for (int i = 0; i < number; ++i)
    {
        spheres.push_back
        ({
            i, d, density, length*random.point(0.5), vec::Zero()
        });
    }

    settings law;
    law.stepping = GetParam();
    law.contact = "type stick;";
    law.aggregate = "type none;";

    const periodicBox box = boxOf("1e-3");
    experiment gas
    (
        arrays(spheres), vec::Constant(length), law,
        turbulentRest("shearRate 1000;", box)
    );

    // From rest, until they follow the gas
    gas.run(h, 2);
    gas.records();
    const double begin = gas.t;
    gas.run(h, static_cast<int>(std::lround(end/h)));

    std::map<std::pair<std::int64_t, std::int64_t>, int> times;
    for (const collisions::record& r : gas.records())
    {
        ++times[std::minmax(r.id1, r.id2)];
    }
    double contacts = 0;
    double squares = 0;
    for (const auto& met : times)
    {
        contacts += met.second;
        squares += met.second*met.second;
    }

    const double expected =
        0.5*number*(number - 1.0)/(length*length*length)
       *std::sqrt(8*pi/15)*G*d*d*d*(gas.t - begin);

    // A pair that meets several times is one event; and the gradients of 26
    // random amplitudes of 2 components, of which the square has a relative
    // error of sqrt(2/52) per integral time scale or two
    const double amplitudes =
        std::sqrt(2.0/52)/2/std::sqrt((gas.t - begin)/(2*2.3/G));
    const double error = std::hypot(std::sqrt(squares)/contacts, amplitudes);

    measured
    (
        "%s: K/theory %.4f +- %.4f (%.0f contacts)\n",
        GetParam().c_str(), contacts/expected, error, contacts
    );

    EXPECT_LT(error, full() ? 0.03 : 0.08);
    EXPECT_NEAR(contacts/expected, 1, 3*error);
}


TEST_P(boxOfFlyAsh, hasSaffmanAndTurnersRateWithInertia)
{
    // Spheres of 2 and 6 um, of 2300 kg/m3, in G = 200/s: by gradients alone
    // the rate would be a fourteenth
    const double length = GetParam();
    const double G = 200;
    const double diameters[2] = {2e-6, 6e-6};
    const double density = 2300;
    const int each =
        static_cast<int>(std::lround(std::min(2e6*length, 3000.0)));
    const double h = 0.1/G;
    const int steps = full() ? 5000 : 500;

    // They pass through one another, and may overlap at the start
    randomNumbers random(1);
    std::vector<sphere> spheres;
    for (int i = 0; i < 2*each; ++i)
    {
        spheres.push_back
        ({
            i, diameters[i/each], density, length*random.point(0.5), vec::Zero()
        });
    }

    settings law;
    law.stepping = eventDriven;
    law.contact = "type stick;";
    law.aggregate = "type none;";

    const std::string edge = std::to_string(length);
    const periodicBox box = boxOf(edge);
    experiment gas
    (
        arrays(spheres), vec::Constant(length), law,
        turbulentRest("shearRate 200;", box)
    );

    // From rest, until they follow the gas
    gas.run(h, 10);
    gas.records();

    // Contacts of the first with the second, and of the second, in parts of
    // time that are nearly independent
    const int parts = 20;
    const double volume = length*length*length;
    Eigen::Array2d sum = Eigen::Array2d::Zero();
    Eigen::Array2d squares = Eigen::Array2d::Zero();

    for (int part = 0; part < parts; ++part)
    {
        gas.run(h, steps/parts);

        Eigen::Array2d K = Eigen::Array2d::Zero();
        for (const collisions::record& r : gas.records())
        {
            const int coarse = (r.id1 >= each) + (r.id2 >= each);
            if (coarse)
            {
                K(coarse - 1) += 1;
            }
        }

        K(0) /= double(each)*each;
        K(1) /= 0.5*each*(each - 1.0);
        K *= volume/(steps/parts*h);
        sum += K/parts;
        squares += K*K/parts;
    }

    const Eigen::Array2d scatter =
        ((squares - sum*sum).max(0)/(parts - 1.0)).sqrt();

    const auto theory = [&](const double d1, const double d2)
    {
        const double R = 0.5*(d1 + d2);
        const double slip =
            relaxationTime(d2, density) - relaxationTime(d1, density);

        return
            2*std::sqrt(2*pi)*R*R
           *std::sqrt(R*R*G*G/15 + slip*slip*1.3*nu*G*G*G);
    };
    const double unequal = theory(diameters[0], diameters[1]);
    const double equal = theory(diameters[1], diameters[1]);

    measured
    (
        "box %g mm: K/theory %.4f +- %.4f of 2 and 6 um, %.4f +- %.4f of 6 and "
        "6 um\n",
        1e3*length, sum(0)/unequal, scatter(0)/unequal, sum(1)/equal,
        scatter(1)/equal
    );

    EXPECT_LT(scatter(0)/unequal, full() ? 0.05 : 0.15);
    EXPECT_NEAR(sum(0)/unequal, 1, 3*scatter(0)/unequal);
    EXPECT_NEAR(sum(1)/equal, 1, 3*scatter(1)/equal);
}


TEST(syntheticTurbulence, doesNotMakeStrategiesDiffer)
{
    // With a sound, in which eventDriven reckons with particles that swing
    const double frequency = 1400;
    const periodicBox box = boxOf("1e-3");
    const std::vector<sphere> spheres =
        aerosolOf(4000, 1e-3, 6e-6, 12e-6, 1000, frequency, 0.3, 3);
    std::vector<std::vector<std::pair<std::int64_t, std::int64_t>>> found;

    for (const std::string& stepping : {eventDriven, multipleTimeStep})
    {
        settings law;
        law.stepping = stepping;

        static swingingGas swing
        (
            frequency, vec(0.3, 0, 0), gasProperties::air()
        );

        experiment gas
        (
            arrays(spheres), vec::Constant(1e-3), law,
            turbulent(swing, "shearRate 2000;", box)
        );

        const int steps = stepping == eventDriven ? 50 : 200;
        gas.run(1/(frequency*steps), steps);

        found.emplace_back();
        for (const meeting& m : meetings)
        {
            found.back().push_back(m.pair());
        }
        std::sort(found.back().begin(), found.back().end());
    }

    std::vector<std::pair<std::int64_t, std::int64_t>> common;
    std::set_intersection
    (
        found[0].begin(), found[0].end(), found[1].begin(), found[1].end(),
        std::back_inserter(common)
    );

    measured
    (
        "contacts: %d of eventDriven, %d of multipleTimeStep, %d common\n",
        int(found[0].size()), int(found[1].size()), int(common.size())
    );

    // Who just grazes may be seen by one only
    EXPECT_GT(common.size(), 50u);
    EXPECT_LE(found[0].size() - common.size(), 1u);
    EXPECT_LE(found[1].size() - common.size(), 1u);
}


TEST(turbulentGas, isCarriedAlong)
{
    // In gas that swings as a whole, the eddies swing with it, also after a
    // restart
    const periodicBox box = boxOf("1e-3");
    const std::string entries = "shearRate 500; timeScale 1;";
    const auto eddies = turbulenceOf(entries, box);

    const double frequency = 1400;
    const vec u0(1.5, 0, 0.2);
    swingingGas swing(frequency, u0, gasProperties::air());
    const std::unique_ptr<turbulentGas> first(turbulent(swing, entries, box));

    const int steps = 50;
    const double h = 1/(frequency*steps);
    const vec x(1.3e-3, 2e-4, -1e-4);
    double off = 0;

    for (int n = 0; n < 120; ++n)
    {
        first->follow(n*h, h);

        for (const double s : {0.0, 0.5, 1.0})
        {
            const double t = (n + s)*h;
            const double angle = 2*pi*frequency*t;
            const vec way = u0/(2*pi*frequency)*(1 - std::cos(angle));

            vectors u;
            first->velocity(t, x, u);
            const vec exact = u0*std::sin(angle) + at(*eddies, t, x - way);
            off = std::max(off, (u - exact).norm());
        }

        const std::unique_ptr<turbulentGas> second
        (
            turbulent(swing, entries, box)
        );
        second->setDisplacement(first->displacement());
        EXPECT_EQ(second->displacement(), first->displacement());
    }

    measured("off by %.2g of the speed\n", off/eddies->speed());

    // Where the way is 0.4 mm, Simpson's rule is off by 1e-5 of it at T/50
    EXPECT_LT(off, 1e-4*eddies->speed());
}


// ************************************************************************* //
