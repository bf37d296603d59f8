/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "collisions.H"
#include "error.H"
#include "IStringStream.H"
#include "randomNumbers.H"
#include "sortById.H"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>

using namespace Foam;
using namespace Foam::aerosol;

using testTools::randomNumbers;
using encounter = Foam::aerosol::contactOutcome::encounter;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using vec = Eigen::Vector3d;

const double period = 1e-3;

dictionary parse(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


//- A model that lives as long as the tests
const aggregate& model(const std::string& type)
{
    static std::vector<std::unique_ptr<aggregate>> all;

    all.emplace_back(aggregate::New(parse("type " + type + ';')).ptr());

    return *all.back();
}


collisions make
(
    const std::string& contact = "stick",
    const std::string& merging = "equivalentSphere"
)
{
    return
    {
        parse("contact { type " + contact + "; }"), model(merging)
    };
}


//- Particles with random positions, velocities, diameters and densities
particleArrays randomParticles
(
    const int n,
    randomNumbers& random,
    const double sizeRatio
)
{
    particleArrays p;
    p.resize(n);

    for (int i = 0; i < n; ++i)
    {
        p.id(i) = 7*i + 3;
        p.x.col(i) = random.point(0.5*period);
        p.v.col(i) = random.point(1);
        p.d(i) = 1e-7*std::pow(sizeRatio, random.uniform(0, 1));
        p.m(i) = random.uniform(500, 3000)*EIGEN_PI/6*std::pow(p.d(i), 3);
        p.primaries(i) = 1 + random.whole(5);
    }

    return p;
}


//- The particles touch, j as its image, somewhere near to where they are
encounter touching
(
    const particleArrays& p,
    const int i,
    const int j,
    const vec& shift,
    const vec& direction
)
{
    encounter pair;
    pair.i = i;
    pair.j = j;
    pair.xi = p.x.col(i);
    pair.xj = pair.xi + 0.5*(p.d(i) + p.d(j))*direction;
    pair.shift = shift;
    pair.vi = p.v.col(i);
    pair.vj = p.v.col(j);
    pair.time = 0;

    return pair;
}


//- Sums with 18 digits
struct sums
{
    long double mass = 0;
    long double volume = 0;
    long double speeds = 0;
    Eigen::Matrix<long double, 3, 1> momentum;
    std::int64_t primaries = 0;

    explicit sums(const particleArrays& p)
    :
        momentum(0, 0, 0)
    {
        for (int i = 0; i < p.size(); ++i)
        {
            const long double m = p.m(i);
            const long double d = p.d(i);

            mass += m;
            volume += d*d*d;
            momentum += m*p.v.col(i).cast<long double>();
            speeds += m*p.v.col(i).norm();
            primaries += p.primaries(i);
        }
    }
};

//- Remove the absorbed particles, as a time stepping does
void sweep(collisions& meetings, particleArrays& p)
{
    p.remove(meetings.takeAbsorbed(p.size()));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(collisions, conserveWhatTwoParticlesHave)
{
    randomNumbers random(1);

    for (int n = 0; n < 2000; ++n)
    {
        const particleArrays before = randomParticles(2, random, 1000);
        const vec direction = random.point(1).normalized();

        // Across a face, an edge or a corner, in any direction, or inside
        const vec shift
        (
            period*(random.whole(3) - 1),
            period*(random.whole(3) - 1),
            period*(random.whole(3) - 1)
        );

        const int i = random.whole(2);
        const int j = 1 - i;

        const encounter pair = touching(before, i, j, shift, direction);

        particleArrays p = before;
        collisions meetings = make();
        const int survivor = meetings.meet(p, pair);

        ASSERT_TRUE(survivor == 0 || survivor == 1);
        EXPECT_EQ(meetings.count(), 1);
        EXPECT_TRUE(meetings.absorbed(1 - survivor));
        EXPECT_FALSE(meetings.absorbed(survivor));

        const int heavier = before.m(0) >= before.m(1) ? 0 : 1;

        EXPECT_EQ(survivor, heavier);

        sweep(meetings, p);

        ASSERT_EQ(p.size(), 1);
        EXPECT_EQ(p.id(0), before.id(heavier));
        EXPECT_EQ(p.m(0), before.m(0) + before.m(1));
        EXPECT_EQ(p.primaries(0), before.primaries(0) + before.primaries(1));

        const sums old(before);
        const sums now(p);

        EXPECT_NEAR(double(now.volume/old.volume), 1, 3e-15);
        EXPECT_LT
        (
            double((now.momentum - old.momentum).norm()),
            4e-16*double(old.speeds)
        );

        // In the frame of i, or in that of j, which is one shift away
        const vec centre =
            pair.xi
          + before.m(j)/(before.m(0) + before.m(1))*(pair.xj - pair.xi)
          - (heavier == i ? vec(0, 0, 0) : shift);

        EXPECT_LT((p.x.col(0) - centre).norm(), 1e-18);

        // Not farther than the sum of radii from where the heavier was
        const vec own = heavier == i ? pair.xi : vec(pair.xj - shift);
        EXPECT_LT
        (
            (p.x.col(0) - own).norm(),
            0.5*(before.d(0) + before.d(1))
        );
    }
}


TEST(collisions, keepSmallPartnersOutOfRounding)
{
    // 1e-9 of the mass, and a centre that moves by 5e-16 m at 1e-3 m
    randomNumbers random(2);
    particleArrays p = randomParticles(2, random, 1);

    p.d << 1e-6, 1e-9;
    p.m << 1e-15, 1e-24;
    p.x.setZero();
    p.v.setZero();
    p.v(0, 1) = 3;

    encounter pair = touching(p, 0, 1, vec::Zero(), vec::UnitX());
    const double gap = pair.xj.x();

    make().meet(p, pair);

    EXPECT_EQ(p.m(0), 1e-15 + 1e-24);
    EXPECT_NEAR(p.x(0, 0)/(1e-9*gap), 1, 2e-9);
    EXPECT_NEAR(p.v(0, 0)/3e-9, 1, 2e-9);
}


TEST(collisions, leaveTheHeavierOrElseTheLowerId)
{
    for (const int i : {0, 1})
    {
        for (const bool heavierFirst : {true, false})
        {
            randomNumbers random(3);
            particleArrays p = randomParticles(2, random, 10);

            p.m << (heavierFirst ? 2e-15 : 1e-15),
                   (heavierFirst ? 1e-15 : 2e-15);

            // Size does not count
            p.d << (heavierFirst ? 1e-6 : 2e-6),
                   (heavierFirst ? 2e-6 : 1e-6);

            const encounter pair =
                touching(p, i, 1 - i, vec::Zero(), vec::UnitX());

            EXPECT_EQ(make().meet(p, pair), heavierFirst ? 0 : 1);
        }

        for (const bool lowerFirst : {true, false})
        {
            randomNumbers random(4);
            particleArrays p = randomParticles(2, random, 10);

            p.m.setConstant(1e-15);
            p.id << (lowerFirst ? 5 : 9), (lowerFirst ? 9 : 5);

            const encounter pair =
                touching(p, i, 1 - i, vec::Zero(), vec::UnitX());

            collisions meetings = make();
            EXPECT_EQ(meetings.meet(p, pair), lowerFirst ? 0 : 1);

            sweep(meetings, p);
            ASSERT_EQ(p.size(), 1);
            EXPECT_EQ(p.id(0), 5);
        }
    }
}


TEST(collisions, conserveThroughTenThousandMerges)
{
    const int n = 10001;
    randomNumbers random(5);
    particleArrays p = randomParticles(n, random, 100);
    const sums before(p);

    collisions meetings = make();

    while (p.size() > 1)
    {
        // Among those that are left, some chains within one sweep
        const int batch = std::min(p.size() - 1, 1 + random.whole(200));
        std::vector<int> alive(p.size());
        std::iota(alive.begin(), alive.end(), 0);

        for (int b = 0; b < batch; ++b)
        {
            const int a = random.whole(int(alive.size()));
            std::swap(alive[a], alive.back());
            const int c = random.whole(int(alive.size()) - 1);

            const encounter pair = touching
            (
                p, alive[c], alive.back(), vec::Zero(), vec::UnitY()
            );

            const int survivor = meetings.meet(p, pair);

            ASSERT_TRUE(survivor == alive[c] || survivor == alive.back());
            ASSERT_TRUE
            (
                meetings.absorbed(survivor == pair.i ? pair.j : pair.i)
            );

            alive[c] = survivor;
            alive.pop_back();
        }

        sweep(meetings, p);
        ASSERT_EQ(p.size(), int(alive.size()));
    }

    EXPECT_EQ(meetings.count(), n - 1);

    const sums after(p);

    EXPECT_NEAR(double(after.mass/before.mass), 1, 1e-12);
    EXPECT_NEAR(double(after.volume/before.volume), 1, 1e-12);
    EXPECT_LT
    (
        double((after.momentum - before.momentum).norm()/before.speeds), 1e-12
    );
    EXPECT_EQ(after.primaries, before.primaries);
}


TEST(collisions, sweepKeepsTheOrder)
{
    randomNumbers random(6);
    const particleArrays before = randomParticles(50, random, 10);
    particleArrays p = before;

    collisions meetings = make();

    // Nothing to sweep
    sweep(meetings, p);
    EXPECT_EQ(p.size(), 50);

    for (const auto& pair : {std::pair<int, int>{0, 49}, {7, 8}, {20, 3}})
    {
        meetings.meet
        (
            p,
            touching(p, pair.first, pair.second, vec::Zero(), vec::UnitZ())
        );
    }

    std::vector<int> left;
    for (int i = 0; i < 50; ++i)
    {
        if (!meetings.absorbed(i))
        {
            left.push_back(i);
        }
    }

    const particleArrays merged = p;
    sweep(meetings, p);
    testTools::sortById(p);

    ASSERT_EQ(p.size(), 47);
    ASSERT_EQ(left.size(), 47u);

    for (int i = 0; i < 47; ++i)
    {
        EXPECT_EQ(p.id(i), before.id(left[i]));
        EXPECT_EQ(p.x.col(i), merged.x.col(left[i]));
        EXPECT_EQ(p.v.col(i), merged.v.col(left[i]));
        EXPECT_EQ(p.d(i), merged.d(left[i]));
        EXPECT_EQ(p.m(i), merged.m(left[i]));
        EXPECT_EQ(p.primaries(i), merged.primaries(left[i]));
        EXPECT_FALSE(meetings.absorbed(i));
    }

    // A second sweep has nothing left to do
    sweep(meetings, p);
    EXPECT_EQ(p.size(), 47);
}


TEST(collisions, withoutAggregatesAreCountedAndChangeNothing)
{
    randomNumbers random(7);
    const particleArrays before = randomParticles(2, random, 10);
    particleArrays p = before;

    collisions meetings = make("stick", "none");

    EXPECT_TRUE(meetings.active());
    EXPECT_FALSE(meetings.refused(p.id(0), p.id(1)));

    EXPECT_EQ
    (
        meetings.meet(p, touching(p, 0, 1, vec::Zero(), vec::UnitX())), -1
    );
    EXPECT_EQ(meetings.count(), 1);
    EXPECT_TRUE(meetings.refused(p.id(0), p.id(1)));
    EXPECT_TRUE(meetings.refused(p.id(1), p.id(0)));
    EXPECT_FALSE(meetings.absorbed(0));
    EXPECT_FALSE(meetings.absorbed(1));

    sweep(meetings, p);

    ASSERT_EQ(p.size(), 2);
    EXPECT_EQ(p.x, before.x);
    EXPECT_EQ(p.v, before.v);
    EXPECT_TRUE((p.m == before.m).all());
    EXPECT_TRUE((p.d == before.d).all());
}


TEST(collisions, noneAreNotLookedFor)
{
    EXPECT_FALSE(make("none").active());
    EXPECT_TRUE(make("stick").active());
}


TEST(collisions, goOnCountingAfterARestart)
{
    randomNumbers random(8);
    particleArrays p = randomParticles(2, random, 10);
    collisions meetings = make();

    EXPECT_EQ(meetings.count(), 0);

    // More than a 32-bit number holds
    const std::int64_t many = 5000000000;
    meetings.setCount(many);
    meetings.meet(p, touching(p, 0, 1, vec::Zero(), vec::UnitX()));

    EXPECT_EQ(meetings.count(), many + 1);
}


TEST(collisions, saveAndLoadTheirCountAndRefusedPairs)
{
    randomNumbers random(8);
    particleArrays p = randomParticles(4, random, 10);
    collisions first = make("probability; sticking 0");

    first.meet(p, touching(p, 0, 3, vec::Zero(), vec::UnitX()));
    first.meet(p, touching(p, 2, 1, vec::Zero(), vec::UnitX()));

    dictionary state;
    first.save(state);

    collisions second = make("probability; sticking 0");
    second.load(state);

    EXPECT_EQ(second.count(), 2);
    EXPECT_TRUE(second.refused(p.id(3), p.id(0)));
    EXPECT_TRUE(second.refused(p.id(1), p.id(2)));
    EXPECT_FALSE(second.refused(p.id(0), p.id(1)));

    // A state of before pairs were kept
    state.remove("refusedPairs");
    collisions third = make();
    third.load(state);

    EXPECT_EQ(third.count(), 2);
}


TEST(collisions, keepRecordsOnlyIfAskedTo)
{
    randomNumbers random(9);
    particleArrays p = randomParticles(2, random, 10);
    collisions meetings = make();

    meetings.meet(p, touching(p, 0, 1, vec::Zero(), vec::UnitX()));
    EXPECT_TRUE(meetings.takeRecords().empty());
}


TEST(collisions, recordWhatHappenedByTime)
{
    randomNumbers random(10);
    particleArrays p = randomParticles(4, random, 10);
    p.m << 1, 2, 3, 4;
    const particleArrays before = p;

    collisions meetings = make();
    meetings.keepRecords();

    // Survivors are 1 and 3; the later contact comes first. Head-on is 0, and
    // the frame of the pair does not matter
    const vec wind(3, -5, 7);
    encounter late = touching(p, 0, 1, vec(0, 0, period), vec::UnitX());
    late.time = 2;
    late.vi = wind + vec(0.5, 0, 0);
    late.vj = wind - vec(1.5, 0, 0);

    encounter early = touching(p, 3, 2, vec::Zero(), vec::UnitY());
    early.time = 1;
    early.vi = wind + vec(3, 3, 0);
    early.vj = wind;

    meetings.meet(p, late);
    meetings.meet(p, early);

    const std::vector<collisions::record> met = meetings.takeRecords();

    ASSERT_EQ(met.size(), 2u);
    EXPECT_TRUE(meetings.takeRecords().empty());

    EXPECT_EQ(met[0].time, 1);
    EXPECT_EQ(met[0].id1, before.id(3));
    EXPECT_EQ(met[0].id2, before.id(2));
    EXPECT_EQ(met[0].d1, before.d(3));
    EXPECT_EQ(met[0].d2, before.d(2));
    EXPECT_NEAR(met[0].speed, std::sqrt(18), 1e-14);
    EXPECT_NEAR(met[0].angle, EIGEN_PI/4, 1e-15);
    EXPECT_TRUE(met[0].merged);

    EXPECT_EQ(met[1].time, 2);
    EXPECT_EQ(met[1].id1, before.id(1));
    EXPECT_EQ(met[1].id2, before.id(0));
    EXPECT_EQ(met[1].d1, before.d(1));
    EXPECT_EQ(met[1].d2, before.d(0));
    EXPECT_EQ(met[1].speed, 2);
    EXPECT_EQ(met[1].angle, 0);
    EXPECT_TRUE(met[1].merged);

    // Without aggregates, and moving apart
    collisions passing = make("stick", "none");
    passing.keepRecords();
    std::swap(late.vi, late.vj);
    p = before;
    passing.meet(p, late);

    const std::vector<collisions::record> passed = passing.takeRecords();

    ASSERT_EQ(passed.size(), 1u);
    EXPECT_EQ(passed[0].id1, before.id(0));
    EXPECT_DOUBLE_EQ(passed[0].angle, EIGEN_PI);
    EXPECT_FALSE(passed[0].merged);
}


TEST(collisions, rejectUnknownNames)
{
    EXPECT_THROW(make("glue"), IOerror);
    EXPECT_THROW(make("stick", "snowman"), IOerror);
}


// ************************************************************************* //
