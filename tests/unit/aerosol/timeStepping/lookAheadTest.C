/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Which particles rest while others make their steps is a matter of cost: the
    result is that of all particles making each step. All bits are the same but
    for those that rounding takes where particles are wrapped into the box, when
    lists are made.

\*---------------------------------------------------------------------------*/

#include "standingWave.H"
#include "timeSteppingTools.H"
#include "travellingWave.H"

#include <gtest/gtest.h>

#include <string>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double frequency = 1400;
const double amplitude = 1.53;
const double h = 1/frequency/50;

acoustics::soundField* standing()
{
    return sound<acoustics::standingWave>
    (
        "type standingWave; frequency 1400; velocityAmplitude 1.53;"
    );
}

acoustics::soundField* travelling()
{
    return sound<acoustics::travellingWave>
    (
        "type travellingWave; frequency 1400; velocityAmplitude 1.53;"
    );
}

//- The velocity antinode of the standing wave, and a place beside it
vec antinode()
{
    return {0.25*gasProperties::air().c/frequency, 0, 0};
}

vec besideIt()
{
    return 0.6*antinode();
}


//- Fly ash, so many particles of it per m3
particleArrays ash(const int n, const double concentration, const int seed)
{
    return arrays
    (
        aerosolOf
        (
            n, std::cbrt(n/concentration), 0.6e-6, 5e-6, 2300, frequency,
            amplitude, seed
        )
    );
}


settings laws(const std::string& wake)
{
    settings s;
    s.stepping = eventDriven;
    s.wake = wake;
    s.gravity = "type uniform; value (0 0 -9.81);";
    s.contact = "type stick;";
    s.representative = true;
    return s;
}


//- The same particles at the same places in the box, and as fast, but for the
//  rounding of positions
void expectSame
(
    const experiment& box,
    const particleArrays& a,
    const particleArrays& b
)
{
    ASSERT_EQ(a.size(), b.size());
    EXPECT_TRUE((a.id == b.id).all());
    EXPECT_TRUE((a.d == b.d).all());

    for (int i = 0; i < a.size(); ++i)
    {
        EXPECT_LT(box.nearest(a.x.col(i) - b.x.col(i)).norm(), 1e-15);
    }

    EXPECT_LT((a.v - b.v).cwiseAbs().maxCoeff(), 1e-11);
}


//- With and without looking ahead; returns the contacts, and by how many of the
//  particles a step was made, as a share
struct outcome
{
    std::int64_t contacts;
    double busy;
};

outcome compare
(
    const particleArrays& start,
    const double concentration,
    const settings& s,
    const int steps,
    acoustics::soundField* (*make)() = standing,
    const vec& centre = antinode()
)
{
    const vec length =
        vec::Constant(std::cbrt(start.size()/concentration));

    particleArrays moved = start;
    moved.x.colwise() += centre;

    experiment all(moved, length, s, make(), centre);
    all.observe();
    all.run(h, steps);

    experiment ahead(moved, length, s, make(), centre);
    ahead.run(h, steps);

    expectSame(ahead, ahead.p, all.p);
    EXPECT_EQ(ahead.count(), all.count());
    EXPECT_EQ(all.done().looksAhead, 0);
    EXPECT_GT(ahead.done().stepsAhead, 0.3*steps);

    return
    {
        ahead.count(),
        ahead.done().busyMoves/(ahead.done().stepsAhead*start.size())
    };
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(lookAhead, changesNothingInEachWake)
{
    const double dense = 2e11;

    std::int64_t contacts = 0;

    for
    (
        const std::string wake :
        {"type none;", "type Oseen; range 12;", "type Oseen; range 10;",
         "type ProudmanPearson; range 12;", "type memory; range 12;",
         "type history; range 12;"}
    )
    {
        SCOPED_TRACE(wake);

        contacts +=
            compare(ash(1000, dense, 1), dense, laws(wake), 300).contacts;
    }

    EXPECT_GT(contacts, 5);
}


TEST(lookAhead, changesNothingInEachSound)
{
    const double dense = 2e11;
    const settings s = laws("type Oseen; range 12;");

    {
        SCOPED_TRACE("beside the antinode");
        compare(ash(1000, dense, 2), dense, s, 200, standing, besideIt());
    }
    {
        SCOPED_TRACE("travelling");
        compare(ash(1000, dense, 3), dense, s, 200, travelling);
    }
}


TEST(lookAhead, changesNothingWithDragAtFiniteReynoldsNumber)
{
    const double dense = 2e11;
    settings s = laws("type Oseen; range 12;");
    s.drag = "type SchillerNaumann; slipCorrection Cunningham;";

    compare(ash(1000, dense, 4), dense, s, 200);
}


TEST(lookAhead, changesNothingWhereParticlesBounce)
{
    const double dense = 2e11;
    settings s = laws("type Oseen; range 12;");
    s.contact = "type probability; sticking 0.3; restitution 0.8;";

    compare(ash(1000, dense, 5), dense, s, 300);
}


TEST(lookAhead, letsMostOfAThinAerosolRest)
{
    const double thin = 2.2e11;

    EXPECT_LT
    (
        compare(ash(1000, thin, 6), thin, laws("type none;"), 100).busy, 0.2
    );
    EXPECT_LT
    (
        compare
        (
            ash(1000, thin, 6), thin, laws("type Oseen; range 10;"), 100
        ).busy,
        0.6
    );
}


TEST(lookAhead, doesNotDependOnWhoLooksMeanwhile)
{
    const double dense = 2e11;
    const settings s = laws("type Oseen; range 12;");
    const vec length = vec::Constant(std::cbrt(1000/dense));

    particleArrays start = ash(1000, dense, 7);
    start.x.colwise() += antinode();

    experiment once(start, length, s, standing(), antinode());
    experiment often(start, length, s, standing(), antinode());

    // Within the steps that were looked ahead, and after them. One is wrapped
    // into the box each time, the other one is not.
    for (const int steps : {1, 7, 3, 19, 2, 8, 20})
    {
        const particleArrays seen = once.after(h, steps);
        often.run(h, steps);

        expectSame(once, seen, often.p);
    }
}


TEST(lookAhead, followsTwoThatMeetHeadOn)
{
    // On one line along the sound: their distance is zero when they meet
    particleArrays pair = arrays
    ({
        {0, 8e-6, 2300, vec(-40e-6, 0, 0), vec::Zero()},
        {1, 1e-6, 2300, vec(40e-6, 0, 0), vec::Zero()}
    });
    pair.x.colwise() += antinode();

    settings s = laws("type none;");
    s.gravity = "type none;";

    experiment box(pair, vec::Constant(1e-3), s, standing(), antinode());
    box.run(h, 60);

    EXPECT_EQ(box.count(), 1);
    EXPECT_GT(box.done().looksAhead, 0);
}


// ************************************************************************* //
