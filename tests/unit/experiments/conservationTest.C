/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Mass and momentum of a crowd of which most merge, in a time stepping:
    collisionsTest does without one.

\*---------------------------------------------------------------------------*/

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

using longVec = Eigen::Matrix<long double, 3, 1>;

//- What must not change, and what it is compared with
struct sums
{
    long double mass = 0;
    longVec momentum = longVec::Zero();
    long double speeds = 0;
    std::int64_t primaries = 0;

    explicit sums(const particleArrays& p)
    {
        for (int i = 0; i < p.size(); ++i)
        {
            const long double m = p.m(i);
            const longVec v = p.v.col(i).cast<long double>();

            mass += m;
            momentum += m*v;
            speeds += m*v.norm();
            primaries += p.primaries(i);
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

class conservation
:
    public testing::TestWithParam<std::string>
{};

INSTANTIATE_TEST_SUITE_P
(
    timeStepping,
    conservation,
    testing::Values("type multipleTimeStep; kp 1; kc 0.5;", eventDriven)
);


TEST_P(conservation, throughManyMerges)
{
    // Without drag; rows of four head for their middles, where they
    // merge in any order
    const double pitch = 30e-6;
    const int side = full() ? 33 : 10;
    const double length = side*pitch;

    randomNumbers random(1);
    std::vector<sphere> spheres;

    for (int cell = 0; cell < side*side*side; ++cell)
    {
        const vec centre =
            pitch*vec(cell % side, cell/side % side, cell/(side*side))
          - vec::Constant(0.5*length - 0.5*pitch);
        const vec e = random.direction();
        const vec drift = random.point(0.5);

        for (const double place : {-6e-6, -2e-6, 2e-6, 6e-6})
        {
            spheres.push_back
            ({
                std::int64_t(spheres.size()), 2e-6*random.uniform(1, 2),
                random.uniform(500, 3000),
                centre + place*e + random.point(0.2e-6),
                drift - place*random.uniform(0.3e6, 0.4e6)*e
            });
        }
    }

    const int n = spheres.size();
    particleArrays start = arrays(spheres);

    // Whole multiples of a unit, so that all sums of masses are exact
    start.m = (start.m*std::ldexp(1, 80)).round()*std::ldexp(1, -80);
    const sums before(start);

    settings law;
    law.stepping = GetParam();
    law.drag = "type none;";
    law.contact = "type stick;";

    experiment crowd(start, length, law);

    crowd.run(1.5e-6, 4);

    const sums after(crowd.p);

    EXPECT_GE(crowd.count(), 0.99*3*side*side*side);
    EXPECT_EQ(crowd.p.size() + crowd.count(), n);

    EXPECT_EQ(after.mass, before.mass);
    EXPECT_EQ(after.primaries, before.primaries);

    // The velocities at contact are read off the paths, differences of
    // positions over a step of a tenth of a microsecond: each is rounded by
    // 1e-12 m/s, at random
    const double lost =
        double((after.momentum - before.momentum).norm()/before.speeds);

    measured
    (
        "%s %lld mergers, %d left: mass changed by %.1Lg, momentum"
        " by %.2g of the sum of m |v|\n",
        GetParam().c_str(), static_cast<long long>(crowd.count()),
        crowd.p.size(), after.mass - before.mass, lost
    );

    EXPECT_LT(lost, 3e-13/std::sqrt(double(crowd.count())));
}


// ************************************************************************* //
