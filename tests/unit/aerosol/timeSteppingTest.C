/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "addToRunTimeSelectionTable.H"
#include "error.H"
#include "IStringStream.H"
#include "periodicBox.H"
#include "timeStepping.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <random>

// * * * * * * * * * * * * * * * Test Doubles  * * * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{

//- A contact as it was found
struct meeting
{
    std::int64_t idI;
    std::int64_t idJ;
    Eigen::Vector3d xi;
    Eigen::Vector3d xj;
    Eigen::Vector3d vi;
    Eigen::Vector3d vj;
    double touch;
    double time;

    std::pair<std::int64_t, std::int64_t> pair() const
    {
        return std::minmax(idI, idJ);
    }
};

static std::vector<meeting> meetings;


//- Sticks, and keeps a record
class recordedStick
:
    public contactOutcome
{
public:

    TypeName("recordedStick");

    explicit recordedStick(const dictionary&)
    {}

    bool sticks(const particleArrays& p, const encounter& e) const override
    {
        meetings.push_back
        ({
            p.id(e.i), p.id(e.j), e.xi, e.xj, e.vi, e.vj,
            0.5*(p.d(e.i) + p.d(e.j)), e.time
        });
        return true;
    }
};

//- Nothing sticks: who touches goes on through the other one
class neverStick
:
    public contactOutcome
{
public:

    TypeName("neverStick");

    explicit neverStick(const dictionary&)
    {}

    bool sticks(const particleArrays&, const encounter&) const override
    {
        return false;
    }
};

defineTypeNameAndDebug(neverStick, 0);
addToRunTimeSelectionTable(contactOutcome, neverStick, dictionary);

defineTypeNameAndDebug(recordedStick, 0);
addToRunTimeSelectionTable(contactOutcome, recordedStick, dictionary);

} // End namespace aerosol
} // End namespace Foam


using namespace Foam;
using namespace Foam::aerosol;

namespace
{

const double pi = EIGEN_PI;

using vec = Eigen::Vector3d;
using complex = std::complex<double>;
using strings = std::vector<std::string>;


//- The whole gas swings with u sin(omega t)
class swingingGas
:
    public acoustics::soundField
{
        const gasProperties gas_;
        const vec u_;

public:

    swingingGas(const double frequency, const vec& u)
    :
        soundField(frequency),
        gas_(gasProperties::air()),
        u_(u)
    {}

    const gasProperties& gas() const override
    {
        return gas_;
    }

    scalar velocityAmplitude() const override
    {
        return u_.norm();
    }

    void advance() override
    {}

    void velocity(const scalar t, const vectors& x, vectors& u) const override
    {
        u = (std::sin(2*pi*frequency()*t)*u_).replicate(1, x.cols());
    }
};


dictionary parse(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


const std::string multipleTimeStep = "type multipleTimeStep; kp 0.5; kc 0.1;";
const std::string conventional = "type conventional; kc 0.1;";
const std::string eventDriven = "type eventDriven;";


struct settings
{
    std::string stepping = multipleTimeStep;
    std::string drag = "type Stokes; slipCorrection none;";
    std::string wake = "type none;";
    std::string gravity = "type none;";
    std::string contact = "type recordedStick;";
    std::string aggregate = "type equivalentSphere;";
};

//- Particles, gas and all that moves them
class experiment
{
        swingingGas sound_;
        periodicBox box_;
        equationOfMotion motion_;
        contacts contacts_;
        autoPtr<timeStepping> stepping_;

        static dictionary laws(const settings& s)
        {
            return parse
            (
                "drag {" + s.drag + "} gravity {" + s.gravity + "}"
                "wake {" + s.wake + "} contact {" + s.contact + "}"
                "aggregate {" + s.aggregate + "}"
            );
        }

public:

    particleArrays p;
    double t = 0;

    experiment
    (
        const particleArrays& particles,
        const double length,
        const settings& s,
        const double frequency = 0,
        const vec& u = vec::Zero()
    )
    :
        sound_(frequency, u),
        box_
        (
            parse("centre (0 0 0); length " + std::to_string(length) + ";")
        ),
        motion_(laws(s), sound_.gas(), box_.period()),
        contacts_(laws(s)),
        stepping_
        (
            timeStepping::New
            (
                parse(s.stepping), {sound_, box_, motion_, contacts_}
            )
        ),
        p(particles)
    {
        meetings.clear();
        box_.confine(p);
    }

    experiment(const experiment&) = delete;

    void run(const double h, const int steps)
    {
        for (int s = 0; s < steps; ++s)
        {
            stepping_->advance(p, t, h);
            t += h;
        }
    }

    std::int64_t count() const
    {
        return contacts_.count();
    }

    const timeStepping::effort& done() const
    {
        return stepping_->done();
    }

    //- The nearest image of a difference of positions
    vec nearest(vec r) const
    {
        for (int k = 0; k < 3; ++k)
        {
            r(k) -= box_.period()(k)*std::round(r(k)/box_.period()(k));
        }
        return r;
    }
};


class randomNumbers
{
    std::mt19937_64 engine_;

public:

    explicit randomNumbers(const int seed)
    :
        engine_(seed)
    {}

    double uniform(const double low, const double high)
    {
        return low + (high - low)*std::ldexp(double(engine_() >> 11), -53);
    }

    double logUniform(const double low, const double high)
    {
        return std::exp(uniform(std::log(low), std::log(high)));
    }

    vec point(const double extent)
    {
        return
        {
            uniform(-extent, extent),
            uniform(-extent, extent),
            uniform(-extent, extent)
        };
    }
};


struct sphere
{
    std::int64_t id;
    double d;
    double density;
    vec x;
    vec v;
};


particleArrays arrays(const std::vector<sphere>& spheres)
{
    particleArrays p;
    p.resize(static_cast<int>(spheres.size()));

    for (int i = 0; i < p.size(); ++i)
    {
        const sphere& s = spheres[i];

        p.id(i) = s.id;
        p.x.col(i) = s.x;
        p.v.col(i) = s.v;
        p.d(i) = s.d;
        p.m(i) = s.density*pi/6*s.d*s.d*s.d;
        p.primaries(i) = 1;
    }

    return p;
}


double relaxationTime(const double d, const double density)
{
    return density*d*d/(18*gasProperties::air().mu);
}


//- Velocity at t = 0 on the periodic path of an isolated particle
double periodicVelocity(const double omega, const double tau, const double u)
{
    return u*(1.0/complex(1, omega*tau)).imag();
}


//- Spheres at random that do not overlap, with periodic velocities
std::vector<sphere> aerosolOf
(
    const int n,
    const double length,
    const double smallest,
    const double largest,
    const double density,
    const double frequency,
    const double u,
    const int seed
)
{
    randomNumbers random(seed);
    std::vector<sphere> spheres;

    while (static_cast<int>(spheres.size()) < n)
    {
        sphere s;
        s.id = spheres.size();
        s.d = random.logUniform(smallest, largest);
        s.density = density;
        s.x = random.point(0.5*length);
        s.v = vec
        (
            periodicVelocity
            (
                2*pi*frequency, relaxationTime(s.d, density), u
            ),
            0,
            0
        );

        const bool apart = std::none_of
        (
            spheres.begin(), spheres.end(),
            [&](const sphere& other)
            {
                vec r = other.x - s.x;
                r -= length*(r/length).array().round().matrix();
                return r.norm() < 0.55*(s.d + other.d);
            }
        );

        if (apart)
        {
            spheres.push_back(s);
        }
    }

    return spheres;
}


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
    const std::string& stepping
)
{
    const vec v
    (
        periodicVelocity
        (
            2*pi*frequency,
            relaxationTime(pairDiameter, pairDensity),
            pairSpeed
        ),
        0,
        0
    );

    settings s;
    s.wake = "type Oseen; range 60;";
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
        {pairSpeed, 0, 0}
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


//- A path in swinging gas without neighbours, in closed form
class freePath
{
        double begin_;
        vec x_;
        vec v_;
        double tau_;
        double omega_;
        double u_;
        complex H_;

        //- The periodic part, along x
        double velocity(const double t) const
        {
            return u_*(H_*std::polar(1.0, omega_*t)).imag();
        }

        double position(const double t) const
        {
            return
                u_*(H_/complex(0, omega_)*std::polar(1.0, omega_*t)).imag();
        }

public:

    double d;
    double m;

    freePath
    (
        const double begin,
        const vec& x,
        const vec& v,
        const double diameter,
        const double mass,
        const double omega,
        const double u
    )
    :
        begin_(begin),
        x_(x),
        v_(v),
        tau_(mass/(3*pi*gasProperties::air().mu*diameter)),
        omega_(omega),
        u_(u),
        H_(1.0/complex(1, omega*tau_)),
        d(diameter),
        m(mass)
    {}

    vec x(const double t) const
    {
        const vec transient = v_ - vec(velocity(begin_), 0, 0);

        return
            x_
          - tau_*std::expm1(-(t - begin_)/tau_)*transient
          + vec(position(t) - position(begin_), 0, 0);
    }

    vec v(const double t) const
    {
        const vec transient = v_ - vec(velocity(begin_), 0, 0);

        return
            std::exp(-(t - begin_)/tau_)*transient + vec(velocity(t), 0, 0);
    }
};


//- Each strategy
class eachTimeStepping
:
    public testing::TestWithParam<std::string>
{
protected:

    settings with(const std::string& drag) const
    {
        settings s;
        s.stepping = GetParam();
        s.drag = drag;
        return s;
    }
};

INSTANTIATE_TEST_SUITE_P
(
    timeStepping,
    eachTimeStepping,
    testing::Values(multipleTimeStep, conventional, eventDriven)
);

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST_P(eachTimeStepping, findsTheTimeAndPlaceOfAContact)
{
    const double length = 100e-6;
    const double kc = 0.1;

    // In the middle of the box, across a face, an edge and a corner
    for
    (
        const vec& centre :
        {vec(0, 0, 0), vec(50e-6, 0, 0), vec(0, -50e-6, 50e-6),
         vec(50e-6, 50e-6, -50e-6)}
    )
    {
        for
        (
            const vec& direction :
            {vec(1, 0, 0), vec(-1, 1, -1), vec(0.3, -2, 1)}
        )
        {
            for (const bool heavierFirst : {true, false})
            {
                const vec e = direction.normalized();
                const double gap = 20e-6;

                std::vector<sphere> spheres
                {
                    {4, 4e-6, 1000, centre - 12e-6*e, e},
                    {9, 2e-6, 1500, centre + 11e-6*e, -0.5*e}
                };

                const particleArrays start = arrays(spheres);
                const double share = start.m(1)/start.m.sum();

                if (!heavierFirst)
                {
                    std::swap(spheres[0], spheres[1]);
                }

                experiment e2(arrays(spheres), length, with("type none;"));

                const double h = 5e-6;
                const double expected = gap/1.5;
                e2.run(h, 4);

                ASSERT_EQ(meetings.size(), 1u);
                ASSERT_EQ(e2.p.size(), 1);
                EXPECT_EQ(e2.count(), 1);
                EXPECT_EQ(e2.p.id(0), 4);

                const meeting& m = meetings[0];

                // u_c is at least the relative speed, for which a collision
                // step is the longest
                const double late = m.time - expected;
                EXPECT_GE(late, -1e-15);
                EXPECT_LE(late, kc*2e-6/1.5);

                const vec x4 = m.idI == 4 ? m.xi : m.xj;
                const vec x9 = m.idI == 4 ? m.xj : m.xi;

                EXPECT_LT
                (
                    e2.nearest(x4 - (start.x.col(0) + m.time*e)).norm(), 1e-17
                );
                EXPECT_LT
                (
                    e2.nearest(x9 - (start.x.col(1) - 0.5*m.time*e)).norm(),
                    1e-17
                );

                // Without the image the two would be far apart
                EXPECT_NEAR((x9 - x4).norm(), m.touch - 1.5*late, 1e-16);

                // And on it goes with the momentum of both
                const vec v = (1 - 1.5*share)*e;
                const vec x = start.x.col(0) + share*23e-6*e + 4*h*v;

                EXPECT_LT((e2.p.v.col(0) - v).norm(), 1e-14);
                EXPECT_LT(e2.nearest(e2.p.x.col(0) - x).norm(), 1e-16);
                EXPECT_LE(e2.p.x.col(0).cwiseAbs().maxCoeff(), 0.5*length);
            }
        }
    }
}


TEST_P(eachTimeStepping, mergesThreeInARowWithinOneStep)
{
    const double kc = 0.1;
    int order[3] = {0, 1, 2};

    do
    {
        // Each of the three is once the heaviest, the lightest and between
        for
        (
            const vec& density :
            {vec(1000, 5000, 2000), vec(9000, 1000, 2000),
             vec(1000, 3000, 9000), vec(500, 3000, 9000)}
        )
        {
            for (const vec& centre : {vec(0, 0, 0), vec(vec::Constant(150e-6))})
            {
                const vec e = vec(1, -2, 2)/3;

                const double dA = 3e-6;
                const double dB = 2e-6;
                const double dC = 2.5e-6;
                const double xB = 5e-6 + 0.5*(dA + dB);
                const double xC = xB + 5e-6 + 0.5*(dB + dC);

                const std::vector<sphere> row
                {
                    {1, dA, density(0), centre, e},
                    {2, dB, density(1), centre + xB*e, vec::Zero()},
                    {3, dC, density(2), centre + xC*e, vec::Zero()}
                };

                const particleArrays start = arrays(row);
                const double mA = start.m(0);
                const double mB = start.m(1);
                const double mC = start.m(2);

                const double t1 = 5e-6;
                const double dAB = std::cbrt(dA*dA*dA + dB*dB*dB);

                // Its centre of mass does not depend on when it was made
                const double t2 =
                    ((xC - 0.5*(dAB + dC))*(mA + mB) - mB*xB)/mA;

                const double h = 50e-6;
                ASSERT_LT(t2, h);

                experiment three
                (
                    arrays({row[order[0]], row[order[1]], row[order[2]]}),
                    300e-6,
                    with("type none;")
                );

                const double V = mA/(mA + mB + mC);
                const double step = kc*dB/(2*std::max(2.0/3, 1 - V));

                three.run(h, 1);

                ASSERT_EQ(meetings.size(), 2u);
                ASSERT_EQ(three.p.size(), 1);

                EXPECT_EQ(meetings[0].pair(), std::make_pair(1l, 2l));
                EXPECT_GE(meetings[0].time, t1*(1 - 1e-12));
                EXPECT_LE(meetings[0].time, t1 + 1.5*step);

                EXPECT_EQ
                (
                    meetings[1].pair(), std::make_pair(mA > mB ? 1l : 2l, 3l)
                );
                EXPECT_NEAR(meetings[1].touch, 0.5*(dAB + dC), 1e-18);
                EXPECT_GE(meetings[1].time, t2*(1 - 1e-12));
                EXPECT_LE(meetings[1].time, t2 + 1.5*step);

                int heaviest;
                start.m.maxCoeff(&heaviest);
                EXPECT_EQ(three.p.id(0), heaviest + 1);
                EXPECT_EQ(three.p.primaries(0), 3);

                const vec x =
                    centre + (mB*xB + mC*xC + mA*h)/(mA + mB + mC)*e;

                EXPECT_LT((three.p.v.col(0) - V*e).norm(), 1e-13);
                EXPECT_LT(three.nearest(three.p.x.col(0) - x).norm(), 1e-16);
            }
        }
    }
    while (std::next_permutation(order, order + 3));
}


TEST_P(eachTimeStepping, lookForWhatTheAbsorbedOneWouldHaveMet)
{
    // A fast one hits a heavier one at rest, which in the rest of the step
    // carries it to a third: too far for the heavier one alone to look for
    const double h = 50e-6;
    const vec e = vec(1, -2, 2)/3;

    for (const double d : {2e-6, 240e-6})
    {
        for (const double corner : {0.0, 500e-6, -500e-6})
        {
            for (const double away : {-1.5e-6, 0.0, 3e-6, 12e-6})
            {
                // The face of the box passes between any two of them
                const vec centre = vec(corner, -corner, corner) + away*e;

                const double share = 0.45;
                const double xFast = -4e-6;
                const double t1 = 2e-6;
                const double t2 = 40e-6;
                const double both = 2e-6*std::cbrt(2.0);
                const double xThird =
                    share*(xFast + t2) + 0.5*(both + d);

                std::vector<sphere> spheres
                {
                    {1, 2e-6, 1000*share/(1 - share), centre + xFast*e, e},
                    {2, 2e-6, 1000, centre, vec::Zero()},
                    {3, d, 1000, centre + xThird*e, vec::Zero()}
                };

                // So that the mean velocity is nearly that of those at rest
                for (int n = 0; n < 40; ++n)
                {
                    spheres.push_back
                    ({
                        4 + n, 2e-6, 1000,
                        centre + vec(20e-6*n - 400e-6, 350e-6, 350e-6),
                        vec::Zero()
                    });
                }

                for (const bool reversed : {false, true})
                {
                    if (reversed)
                    {
                        std::reverse(spheres.begin(), spheres.end());
                    }

                    experiment box(arrays(spheres), 1e-3, with("type none;"));
                    box.run(h, 1);

                    ASSERT_EQ(meetings.size(), 2u);
                    EXPECT_EQ(meetings[0].pair(), std::make_pair(1l, 2l));
                    EXPECT_EQ(meetings[1].pair(), std::make_pair(2l, 3l));

                    const double late = 0.1*2e-6;
                    EXPECT_GE(meetings[0].time, t1*(1 - 1e-9));
                    EXPECT_LE(meetings[0].time, t1 + late);
                    EXPECT_GE(meetings[1].time, t2*(1 - 1e-9));
                    EXPECT_LE(meetings[1].time, t2 + late);
                }
            }
        }
    }
}


TEST_P(eachTimeStepping, doesNotLetTheFastTunnel)
{
    // 400 diameters closer in one step, past one another in a 40th of it
    for (const double offset : {0.0, 0.5e-6, 0.9e-6})
    {
        experiment pair
        (
            arrays
            ({
                {1, 1e-6, 1000, {-100e-6, 0, 0}, {20, 0, 0}},
                {2, 1e-6, 1000, {100e-6, offset, 0}, {-20, 0, 0}}
            }),
            1e-3,
            with("type none;")
        );

        pair.run(10e-6, 1);

        ASSERT_EQ(meetings.size(), 1u);

        const double expected =
            (200e-6 - std::sqrt(1e-12 - offset*offset))/40;

        EXPECT_GE(meetings[0].time, expected*(1 - 1e-12));
        EXPECT_LE(meetings[0].time, expected + 0.1*1e-6/40);
    }

    // A hundredth of a diameter too far to touch
    experiment miss
    (
        arrays
        ({
            {1, 1e-6, 1000, {-100e-6, 0, 0}, {20, 0, 0}},
            {2, 1e-6, 1000, {100e-6, 1.01e-6, 0}, {-20, 0, 0}}
        }),
        1e-3,
        with("type none;")
    );

    miss.run(10e-6, 1);

    EXPECT_EQ(meetings.size(), 0u);
    EXPECT_EQ(miss.p.size(), 2);
}


TEST_P(eachTimeStepping, countsAContactThatDoesNotStickOnce)
{
    // Through one another within 10 fluid steps, and once more around the box
    settings law = with("type none;");
    law.contact = "type neverStick;";

    experiment pair
    (
        arrays
        ({
            {1, 10e-6, 1000, {-20e-6, 1e-6, 0}, {1, 0, 0}},
            {2, 10e-6, 1000, {20e-6, 0, 0}, {-1, 0, 0}}
        }),
        100e-6,
        law
    );

    // They touch after 15 us, part after 25 us, and meet again after 65 us
    pair.run(1e-6, 12);
    EXPECT_EQ(pair.count(), 0);
    pair.run(1e-6, 40);
    EXPECT_EQ(pair.count(), 1);
    pair.run(1e-6, 20);
    EXPECT_EQ(pair.count(), 2);
    EXPECT_EQ(pair.p.size(), 2);
}


TEST_P(eachTimeStepping, leavesThoseAloneThatRestInOneAnother)
{
    // Equal and overlapping, they move alike and never part
    settings law = with("type none;");
    law.aggregate = "type none;";

    experiment pair
    (
        arrays
        ({
            {1, 10e-6, 1000, {0, 0, 0}, {1, 0, 0}},
            {2, 10e-6, 1000, {5e-6, 0, 0}, {1, 0, 0}}
        }),
        100e-6,
        law
    );

    pair.run(1e-6, 10);

    EXPECT_EQ(pair.count(), 1);
    EXPECT_EQ(pair.p.size(), 2);
}


TEST_P(eachTimeStepping, movesASingleParticleAndNoneAtAll)
{
    experiment none(arrays({}), 1e-3, with("type none;"));
    none.run(1e-5, 3);
    EXPECT_EQ(none.p.size(), 0);

    // In a box that is smaller than its path: it never meets its image
    experiment one
    (
        arrays({{5, 8e-6, 1000, {0, 0, 0}, {1, -2, 0.5}}}),
        20e-6,
        with("type none;")
    );
    one.run(1e-5, 7);

    ASSERT_EQ(one.p.size(), 1);
    EXPECT_EQ(one.count(), 0);
    EXPECT_LT
    (
        one.nearest(one.p.x.col(0) - 7e-5*vec(1, -2, 0.5)).norm(), 1e-18
    );
}


TEST_P(eachTimeStepping, conservesMassAndMomentum)
{
    // Fast particles without drag, crowded: most of them merge
    randomNumbers random(1);
    std::vector<sphere> spheres =
        aerosolOf(300, 100e-6, 1e-6, 8e-6, 1000, 0, 0, 1);

    for (sphere& s : spheres)
    {
        s.v = random.point(1);
    }

    particleArrays start = arrays(spheres);

    // Whole multiples of a unit, so that sums are exact in any order
    start.m = (start.m*std::ldexp(1, 80)).round()*std::ldexp(1, -80);

    experiment gas(start, 100e-6, with("type none;"));

    const vec momentum = start.v*start.m.matrix();
    const double scale =
        start.m.matrix().dot(start.v.colwise().norm().transpose());

    for (int n = 0; n < 10; ++n)
    {
        gas.run(4e-6, 1);

        EXPECT_EQ(gas.p.m.sum(), start.m.sum());
        EXPECT_EQ(gas.p.primaries.sum(), 300);
        EXPECT_EQ(gas.p.size(), 300 - gas.count());
        EXPECT_LT((gas.p.v*gas.p.m.matrix() - momentum).norm(), 1e-13*scale);
        EXPECT_NEAR(gas.p.d.cube().sum()/start.d.cube().sum(), 1, 1e-13);
    }

    EXPECT_GT(gas.count(), 60);
    EXPECT_EQ(gas.count(), int(meetings.size()));

    for (const meeting& m : meetings)
    {
        EXPECT_LE((m.xi - m.xj).norm(), m.touch*(1 + 1e-12));
    }
}


TEST_P(eachTimeStepping, findsWhatBruteForceFinds)
{
    const double length = 200e-6;
    const double frequency = 2000;
    const double omega = 2*pi*frequency;
    const double u = 0.6;
    const double density = 1500;

    const std::vector<sphere> spheres =
        aerosolOf(160, length, 3e-6, 20e-6, density, frequency, u, 3);

    // All pairs in tiny steps, on paths in closed form
    std::vector<std::unique_ptr<freePath>> paths;

    for (const sphere& s : spheres)
    {
        paths.emplace_back
        (
            new freePath
            (
                0, s.x, s.v, s.d, s.density*pi/6*s.d*s.d*s.d, omega, u
            )
        );
    }

    const int steps = 6000;
    const double end = 1.2/frequency;
    std::vector<meeting> expected;
    vectors x(3, spheres.size());

    for (int s = 0; s <= steps; ++s)
    {
        const double t = s*end/steps;

        for (std::size_t i = 0; i < paths.size(); ++i)
        {
            if (paths[i])
            {
                x.col(i) = paths[i]->x(t);
            }
        }

        for (std::size_t i = 0; i < paths.size(); ++i)
        {
            for (std::size_t j = i + 1; paths[i] && j < paths.size(); ++j)
            {
                if (!paths[j])
                {
                    continue;
                }

                const double touch = 0.5*(paths[i]->d + paths[j]->d);
                vec r = x.col(j) - x.col(i);

                // Most are apart in the first direction
                for (int k = 0; k < 3; ++k)
                {
                    r(k) -= length*std::nearbyint(r(k)/length);
                    if (std::abs(r(k)) > touch)
                    {
                        break;
                    }
                }

                if (r.squaredNorm() > touch*touch)
                {
                    continue;
                }

                const double mi = paths[i]->m;
                const double mj = paths[j]->m;
                const double m = mi + mj;

                expected.push_back
                ({
                    std::int64_t(i), std::int64_t(j), {}, {}, {}, {}, touch, t
                });

                std::unique_ptr<freePath> both
                (
                    new freePath
                    (
                        t,
                        x.col(i) + mj/m*r,
                        (mi*paths[i]->v(t) + mj*paths[j]->v(t))/m,
                        std::cbrt
                        (
                            std::pow(paths[i]->d, 3) + std::pow(paths[j]->d, 3)
                        ),
                        m,
                        omega,
                        u
                    )
                );

                const std::size_t survivor = mi >= mj ? i : j;
                paths[i].reset();
                paths[j].reset();
                paths[survivor] = std::move(both);
                x.col(survivor) = paths[survivor]->x(t);
            }
        }
    }

    settings law = with("type Stokes; slipCorrection none;");
    experiment box(arrays(spheres), length, law, frequency, {u, 0, 0});
    box.run(end/240, 240);

    // Not a test of nothing
    EXPECT_GT(expected.size(), 10u);
    ASSERT_EQ(meetings.size(), expected.size());

    // A collision step at the largest possible relative speed, plus what the
    // straight lines between samples of the gas and the brute force cost
    const double late = 0.1*3e-6/u + end/steps;

    for (std::size_t n = 0; n < expected.size(); ++n)
    {
        const auto same = std::find_if
        (
            meetings.begin(), meetings.end(),
            [&](const meeting& m) { return m.pair() == expected[n].pair(); }
        );

        ASSERT_TRUE(same != meetings.end())
            << expected[n].idI << ' ' << expected[n].idJ << " at "
            << expected[n].time;
        EXPECT_NEAR(same->time, expected[n].time, late);
    }

    // And all are where they should be at the end
    for (int i = 0; i < box.p.size(); ++i)
    {
        const auto& path = paths[box.p.id(i)];
        ASSERT_TRUE(path);
        EXPECT_LT(box.nearest(box.p.x.col(i) - path->x(end)).norm(), 0.3e-6);
    }
}


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


TEST(multipleTimeStep, meetsTheSamePairsEveryPeriodWithoutAggregates)
{
    // What passes another one passes it again in every period
    const double frequency = 1400;
    settings s;
    s.aggregate = "type none;";

    experiment box
    (
        arrays(aerosolOf(400, 250e-6, 2e-6, 12e-6, 2000, frequency, 0.5, 5)),
        250e-6, s, frequency, {0.5, 0, 0}
    );

    std::vector<int> counts;
    for (int period = 0; period < 4; ++period)
    {
        const int before = box.count();
        box.run(1/frequency/100, 100);
        counts.push_back(box.count() - before);
    }

    EXPECT_EQ(box.p.size(), 400);
    EXPECT_GT(counts[0], 30);
    EXPECT_EQ(counts[1], counts[0]);
    EXPECT_EQ(counts[2], counts[0]);
    EXPECT_EQ(counts[3], counts[0]);
}


TEST(multipleTimeStep, stopsAgglomeratingByOrthokineticMotionAlone)
{
    // Nothing refills the volume that a particle has swept
    const double frequency = 1400;

    experiment box
    (
        arrays(aerosolOf(1000, 350e-6, 2e-6, 12e-6, 2000, frequency, 0.5, 6)),
        350e-6, settings(), frequency, {0.5, 0, 0}
    );

    box.run(1/frequency/100, 100);
    const int first = box.count();

    // Aggregates relax to a path of their own, and may meet others once
    box.run(1/frequency/100, 300);
    const int settling = box.count() - first;

    box.run(1/frequency/100, 500);
    const int late = box.count() - first - settling;

    EXPECT_GT(first, 30);
    EXPECT_LT(settling, 0.5*first);
    EXPECT_LT(late, 0.05*first);
}


TEST(multipleTimeStep, findsTheSamePairsAsConventional)
{
    const double frequency = 1400;
    settings s;
    s.wake = "type Oseen; range 12;";
    s.gravity = "type uniform; value (0 -9.81 0);";
    s.drag = "type SchillerNaumann; slipCorrection Cunningham;";

    using pairs = std::vector<std::pair<std::int64_t, std::int64_t>>;

    const auto pairsMet = [&](const std::string& stepping, const int seed)
    {
        s.stepping = stepping;

        experiment box
        (
            arrays
            (
                aerosolOf(80, 200e-6, 3e-6, 15e-6, 2000, frequency, 0.5, seed)
            ),
            200e-6, s, frequency, {0.5, 0, 0}
        );

        box.run(1/frequency/200, 200);

        pairs met;
        for (const meeting& m : meetings)
        {
            met.push_back(m.pair());
        }
        return met;
    };

    for (const int seed : {7, 8})
    {
        const pairs met = pairsMet(multipleTimeStep, seed);

        EXPECT_GE(met.size(), 4u);
        EXPECT_EQ(met, pairsMet(conventional, seed));
    }
}


TEST(multipleTimeStep, nestsItsStepsAsItsFactorsSay)
{
    // tau of the smaller one 7.1 us at 2 um: 14 particle steps of 0.5 tau in
    // 100 us; u_c 2 m/s: 0.1*2 um/(2 m/s) = 0.1 us
    experiment pair
    (
        arrays
        ({
            {1, 2e-6, 580, {0, 100e-6, 0}, {1, 0, 0}},
            {2, 8e-6, 580, {0, 0, 0}, {-1, 0, 0}}
        }),
        1e-3,
        settings()
    );

    const double h = 100e-6;
    pair.run(h, 1);

    const double tau = relaxationTime(2e-6, 580);
    const int particleSteps = int(std::ceil(h/(0.5*tau)));
    const int collisionSteps =
        int(std::ceil(h/particleSteps*2/(0.1*2e-6)));

    EXPECT_EQ(pair.done().fluidSteps, 1);
    EXPECT_EQ(pair.done().particleSteps, particleSteps);
    EXPECT_EQ(pair.done().collisionSteps, particleSteps*collisionSteps);
    EXPECT_EQ(pair.done().wakePairs, 0);
}


TEST(timeStepping, rejectsWhatMakesNoSense)
{
    const auto make = [](const std::string& stepping)
    {
        settings s;
        s.stepping = stepping;
        experiment none(arrays({}), 1e-3, s);
    };

    EXPECT_THROW(make("type conventional;"), IOerror);
    EXPECT_THROW(make("type conventional; kc 0;"), IOerror);
    EXPECT_THROW(make("type multipleTimeStep; kc 0.1;"), IOerror);
    EXPECT_THROW(make("type multipleTimeStep; kc 0.1; kp -1;"), IOerror);
    EXPECT_THROW(make("type fast; kc 0.1; kp 1;"), IOerror);
}


// ************************************************************************* //
