/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Brownian coagulation has Smoluchowski's rate.
//
// The gas is a hundred times as viscous as air, so that the free paths of the
// particles are short. Fuchs' correction is estimated below 0.1 % for all sizes
// here: it lowers the rate by less than 4 D/(c R), which is 3e-4 for the
// smallest, with the mean speed c of the two relative to one another,
// c^2 = 8 kB T/pi (1/m1 + 1/m2).
//
// In a box of the volume V that is filled at random, n1 n2 K(t)/V contacts per
// time happen, with
//
//     K(t) = 4 pi R D (1 + R/sqrt(pi D t)),   R = (d1 + d2)/2, D = D1 + D2
//
// The second term is the depletion of those who were near in the beginning.

#include "measured.H"
#include "timeSteppingTools.H"
#include "addToRunTimeSelectionTable.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
namespace testTools
{

//- Those stick of which one is more than twice as large as the other
class unlikeStick
:
    public contactOutcome
{
public:

    TypeName("unlikeStick");

    explicit unlikeStick(const dictionary&)
    {}

    bool sticks(const particleArrays& p, const encounter& e) const override
    {
        const double ratio = p.d(e.i)/p.d(e.j);
        return ratio > 2 || ratio < 0.5;
    }
};

defineTypeNameAndDebug(unlikeStick, 0);
addToRunTimeSelectionTable(contactOutcome, unlikeStick, dictionary);

}
}
}


namespace
{

constexpr double kB = 1.380649e-23;
constexpr double density = 1000;


gasProperties viscousAir()
{
    gasProperties gas = gasProperties::air();
    gas.mu *= 100;

    return gas;
}


double diffusivity(const double d)
{
    const gasProperties gas = viscousAir();

    return kB*gas.T/(3*pi*gas.mu*d);
}


//- Integral of K(t) [m3]
double swept(const double R, const double D, const double t)
{
    return 4*pi*R*D*(t + 2*R*std::sqrt(t/(pi*D)));
}


//- Spheres at random that do not overlap, n of each diameter
std::vector<sphere> fill
(
    const std::vector<std::pair<int, double>>& sizes,
    const double length,
    const int seed
)
{
    randomNumbers random(seed);

    double largest = 0;
    for (const auto& size : sizes)
    {
        largest = std::max(largest, size.second);
    }

    const int nCells = static_cast<int>(length/largest);
    std::map<std::array<int, 3>, std::vector<int>> cells;
    std::vector<sphere> spheres;

    for (const auto& size : sizes)
    {
        for (int placed = 0; placed < size.first; )
        {
            sphere s;
            s.id = spheres.size();
            s.d = size.second;
            s.density = density;
            s.x = random.point(0.5*length);
            s.v.setZero();

            std::array<int, 3> cell;
            for (int k = 0; k < 3; ++k)
            {
                cell[k] =
                    static_cast<int>((s.x(k)/length + 0.5)*nCells) % nCells;
            }

            bool apart = true;
            for (int n = 0; n < 27 && apart; ++n)
            {
                const auto found = cells.find
                ({
                    (cell[0] + nCells + n % 3 - 1) % nCells,
                    (cell[1] + nCells + n/3 % 3 - 1) % nCells,
                    (cell[2] + nCells + n/9 - 1) % nCells
                });

                if (found == cells.end())
                {
                    continue;
                }
                for (const int other : found->second)
                {
                    vec r = spheres[other].x - s.x;
                    r -= length*(r/length).array().round().matrix();
                    apart =
                        apart && r.norm() > 0.5*(spheres[other].d + s.d);
                }
            }

            if (apart)
            {
                cells[cell].push_back(int(spheres.size()));
                spheres.push_back(s);
                ++placed;
            }
        }
    }

    return spheres;
}


settings coagulation(const std::string& stepping, const int seed = 1)
{
    settings s;
    s.stepping = stepping;
    s.gas = viscousAir();
    s.Brownian =
        "type OrnsteinUhlenbeck; seed " + std::to_string(seed) + ";";

    return s;
}


//- Equal spheres in a box
class equalSpheres
{
    const double d_;
    const double D_;
    const double length_;
    const double N0_;

    experiment e_;

public:

    equalSpheres
    (
        const int n,
        const double phi,
        const std::string& stepping,
        const int seed = 7
    )
    :
        d_(1e-6),
        D_(diffusivity(d_)),
        length_(d_*std::cbrt(n*pi/6/phi)),
        N0_(n),
        e_
        (
            arrays(fill({{n, d_}}, length_, seed)),
            length_,
            coagulation(stepping, seed)
        )
    {}

    //- Go on for a time in d^2/D
    void run(const double time, const int steps)
    {
        e_.run(time*d_*d_/(D_*steps), steps);
    }

    //- Contacts until now
    double contacts() const
    {
        return N0_ - e_.p.size();
    }

    //- N0/N
    double decay() const
    {
        return N0_/e_.p.size();
    }

    //- The same by the kernel of equal spheres
    double expectedDecay() const
    {
        return
            1 + 0.5*N0_/std::pow(length_, 3)*swept(d_, 2*D_, e_.t);
    }

    //- Measured over expected kernel, in the mean
    double kernel() const
    {
        return (decay() - 1)/(expectedDecay() - 1);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(BrownianCoagulation, hasSmoluchowskisRateForEqualSpheres)
{
    // Fluid steps in which a pair moves by 1.5 and by 1 contact distance.
    // Without the contacts between the ends of its parts, a quarter of the
    // contact distance each, the rate is 0.84 of this.
    int seed = 7;
    double sum = 0;
    double contacts = 0;

    for (const int steps : {7, 16})
    {
        equalSpheres box(full() ? 8000 : 1500, 1e-3, eventDriven, seed++);
        box.run(4, steps);

        // Those who have merged are a little faster: 1.3 % for one that has
        // with one that has not, 0.2 % in the mean. That the aerosol is not
        // quite dilute may be worth 2 %: doc/verification.md
        const double error = 1/std::sqrt(box.contacts());
        EXPECT_NEAR(box.kernel(), 1.002, 3.5*error) << steps;

        sum += box.contacts()*box.kernel();
        contacts += box.contacts();
    }

    // Both together: 2.4 % with full statistics
    EXPECT_GT(contacts, full() ? 1700 : 300);
    EXPECT_NEAR(sum/contacts, 1.002, 3.5/std::sqrt(contacts));

    measured
    (
        "equal spheres: K/theory = %.3f +- %.3f\n",
        sum/contacts, 1/std::sqrt(contacts)
    );
}


TEST(BrownianCoagulation, hasSmoluchowskisRateForUnequalSpheres)
{
    // The parts are for the small ones among themselves, and fine for others.
    const int nSmall = full() ? 8000 : 1000;
    const int nLarge = nSmall/20;
    const double d = 1e-6;
    const double D = diffusivity(d) + diffusivity(5*d);
    const double length = d*std::cbrt(nLarge/4e-5);

    settings law = coagulation(eventDriven);
    law.contact = "type unlikeStick;";
    law.stepping = "type eventDriven; resolution 1;";

    experiment e
    (
        arrays(fill({{nLarge, 5*d}, {nSmall, d}}, length, 11)), length, law
    );

    const double t = 60*d*d/diffusivity(d);
    e.run(t/60, 60);

    // The large ones stay, and grow by 1 % at most
    const double left = e.p.size() - nLarge;
    const double expected = nLarge/std::pow(length, 3)*swept(3*d, D, t);
    const double error = 1/std::sqrt(nSmall - left);

    const double kernel = std::log(nSmall/left)/expected;

    EXPECT_LT(error, full() ? 0.031 : 0.1);
    EXPECT_NEAR(kernel, 1.003, 3.5*error);

    measured("unequal spheres: K/theory = %.3f +- %.3f\n", kernel, error);
}


TEST(BrownianCoagulation, letsAMonodisperseAerosolDecay)
{
    // N0/N = 1 + K N0 t/2 up to 1.3. In the long run the kernel is 1.07 times
    // that of equal spheres; here it is between the two.
    equalSpheres box(full() ? 5000 : 1000, 1e-3, eventDriven);

    for (int part = 1; part <= 2; ++part)
    {
        box.run(4, 12);

        const double error = 1/std::sqrt(box.contacts());

        EXPECT_GT(box.kernel(), 1 - 3*error);
        EXPECT_LT(box.kernel(), 1.04 + 3*error);

        measured
        (
            "decay: N0/N = %.3f, K/theory = %.3f +- %.3f\n",
            box.decay(), box.kernel(), error
        );
    }

    EXPECT_GT(box.decay(), full() ? 1.25 : 1.2);
    EXPECT_LT(box.decay(), full() ? 1.4 : 1.45);
}


// ************************************************************************* //
