/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    The account of what breaks: what the pieces are, who is who, and a balance
    of merging and breaking.

\*---------------------------------------------------------------------------*/

#include "addToRunTimeSelectionTable.H"
#include "aggregate.H"
#include "breakageTools.H"
#include "counterRandom.H"
#include "measured.H"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace Foam;
using namespace Foam::aerosol;
using namespace Foam::aerosol::testTools;

// * * * * * * * * * * * * * * * * Test Models * * * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
namespace testTools
{

//- Each bond breaks with the same probability per time
class breaksAtRandom
:
    public breakage
{
        const scalar rate_;

public:

    TypeName("breaksAtRandom");

    explicit breaksAtRandom(const dictionary& dict)
    :
        rate_(dict.get<scalar>("rate"))
    {}

    bool breaks
    (
        const particleArrays& p,
        const int i,
        const particleArrays&,
        const surroundings& where,
        const gasProperties&,
        parting& apart
    ) const override
    {
        const auto bits = counterRandom(1).bits
        (
            p.id(i), where.step, counterRandom::stream::contact, 0, 0
        );

        apart.direction = vec::UnitX();

        return
            counterRandom::openUniform(bits[0])
          < -std::expm1(-rate_*where.h*(p.primaries(i) - 1));
    }
};

defineTypeNameAndDebug(breaksAtRandom, 0);
addToRunTimeSelectionTable(breakage, breaksAtRandom, dictionary);

} // End namespace testTools
} // End namespace aerosol
} // End namespace Foam


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(fragmentation, breakAggregatesOnlyAndShareThem)
{
    // Any slip breaks any bond; at the border of the box, too
    struct row
    {
        std::string fragments;
        int N;
        int smaller;
    };

    for
    (
        const row& r : std::vector<row>
        {
            {"fragments erosion;", 7, 1}, {"", 7, 1}, {"fragments two;", 7, 3},
            {"fragments two; share 0.3;", 7, 2},
            {"fragments two; share 0.01;", 7, 1}, {"fragments erosion;", 3, 1}
        }
    )
    {
        particleArrays p = clusters
        (
            {1, r.N, 1, r.N}, 1e-6,
            {vec::Zero(), vec(4.999e-4, 0, 0), vec(1e-4, 0, 0), vec(0, 1e-4, 0)}
        );
        const double mass = p.m(1);

        ASSERT_TRUE
        (
            breaksIn
            (
                "type drag; " + r.fragments + JKR + "1e-20; }", p,
                anyGas(vec(1, 0, 0))
            )
        );

        ASSERT_EQ(p.size(), 6);

        // In the order of the ids of the broken, 10 and 30
        const std::vector<std::int64_t> ids{0, 10, 20, 30, 100, 101};
        for (int i = 0; i < 6; ++i)
        {
            EXPECT_EQ(p.id(i), ids[i]);
        }

        for (const int i : {1, 3})
        {
            const int j = i == 1 ? 4 : 5;

            EXPECT_EQ(p.primaries(i), r.N - r.smaller);
            EXPECT_EQ(p.primaries(j), r.smaller);
            EXPECT_EQ(p.m(i) + p.m(j), mass);
            EXPECT_NEAR(p.m(j)/(mass*r.smaller/r.N), 1, 1e-14);
            EXPECT_NEAR
            (
                (std::pow(p.d(i), 3) + std::pow(p.d(j), 3))/(r.N*1e-18), 1,
                1e-14
            );
        }
    }
}


TEST(fragmentation, savesAndLoadsTheNextIdAndTheCount)
{
    const std::string model = "type drag; " + JKR + "1e-20; }";

    fragmentation first(parse(model));
    first.begin(7, 2);

    dictionary state;
    first.save(state);
    state.add("initialNumber", 5);

    fragmentation second(parse(model));
    second.load(state);

    EXPECT_EQ(second.nextId(), 7);
    EXPECT_EQ(second.count(), 2);

    // A state of before anything could break
    state.remove("nextId");
    state.remove("breakages");
    second.load(state);

    EXPECT_EQ(second.nextId(), 5);
    EXPECT_EQ(second.count(), 0);
}


TEST(fragmentation, areRecorded)
{
    const equationOfMotion motion = laws();
    const anyGas gas(vec(1, 0, 0));

    fragmentation all(parse("type drag; " + JKR + "1e-20; }"));
    all.begin(7, 2);
    all.keepRecords();

    // Later ones get later ids; only one comes off at a time. Two alike are
    // dragged alike.
    particleArrays p = clusters({1, 4}, 1e-6, {vec::Zero(), vec(1e-4, 0, 0)});
    motion.laws().refresh(p);

    EXPECT_TRUE(all.apply(p, {}, motion, gas, box(), 0.5, 1e-5, 1));
    EXPECT_TRUE(all.apply(p, {}, motion, gas, box(), 0.6, 1e-5, 2));
    EXPECT_FALSE(all.apply(p, {}, motion, gas, box(), 0.7, 1e-5, 3));

    EXPECT_EQ(p.size(), 4);
    EXPECT_EQ(all.nextId(), 9);
    EXPECT_EQ(all.count(), 4);

    const auto records = all.takeRecords();
    ASSERT_EQ(records.size(), 2u);
    EXPECT_TRUE(all.takeRecords().empty());

    EXPECT_EQ(records[0].time, 0.5);
    EXPECT_EQ(records[0].id, 10);
    EXPECT_EQ(records[0].newId, 7);
    EXPECT_EQ(records[0].primaries, 4);
    EXPECT_EQ(records[0].primariesNew, 1);
    EXPECT_NEAR(records[0].d/(std::cbrt(4)*1e-6), 1, 1e-14);
    EXPECT_NEAR(records[0].dNew/1e-6, 1, 1e-14);
    EXPECT_EQ(records[1].newId, 8);
    EXPECT_EQ(records[1].primaries, 3);
}


TEST(fragmentation, balanceMerging)
{
    // Any two merge with the same rate K, and each bond breaks with the rate b,
    // whatever the pieces: of P primaries, the number of particles N follows
    //     dN/dt = b (P - N) - K N^2/2
    // and ends where both are equal (P. J. Blatz, A. V. Tobolsky, Journal of
    // Physical Chemistry 49, 1945)
    const int P = 1000;
    const double b = 1;
    const double meanSize = 5;
    const double K = 2*b*P*(1 - 1/meanSize)/sqr(P/meanSize);

    // Short enough that hardly any would break twice in a step
    const double h = full() ? 2.5e-4 : 1e-3;
    const int steps = full() ? 40000 : 4000;

    const equationOfMotion motion = laws();
    const anyGas gas(vec::Zero());
    const autoPtr<aggregate> model =
        aggregate::New(parse("type fractal; dimension 1.8;"));

    for (const std::string fragments : {"erosion", "two"})
    {
        randomNumbers random(9);

        particleArrays p = clusters
        (
            std::vector<int>(P, 1), 1e-6, std::vector<vec>(P, vec::Zero())
        );
        for (int i = 0; i < P; ++i)
        {
            p.id(i) = i;
        }
        motion.laws().refresh(p);

        fragmentation all
        (
            parse("type breaksAtRandom; rate 1; fragments " + fragments + ";")
        );
        all.begin(P, 0);

        double sum = 0;
        int samples = 0;
        double merges = 0;

        for (int s = 0; s < steps; ++s)
        {
            merges += 0.5*K*h*p.size()*(p.size() - 1);

            for (; merges > 0 && p.size() > 1; --merges)
            {
                contactOutcome::encounter pair{};
                pair.i = int(random.uniform(0, p.size()));
                pair.j = int(random.uniform(0, p.size() - 1));
                pair.j += pair.j >= pair.i;
                pair.xi = pair.xj = pair.vi = pair.vj = vec::Zero();

                model->merge(p, pair);
                motion.laws().refresh(p, pair.i);

                std::vector<char> absorbed(p.size(), 0);
                absorbed[pair.j] = 1;
                p.remove(absorbed);
            }

            all.apply(p, {}, motion, gas, box(), s*h, h, s);

            // Nine relaxation times later
            if (s*h > 1/b)
            {
                sum += p.size();
                ++samples;
            }
        }

        const double size = P*samples/sum;

        measured
        (
            "%s: mean size %.4f, of %g; %lld breakages\n",
            fragments.c_str(), size, meanSize,
            static_cast<long long>(all.count())
        );

        EXPECT_EQ(p.primaries.sum(), P);

        std::set<std::int64_t> ids(p.id.data(), p.id.data() + p.size());
        EXPECT_EQ(int(ids.size()), p.size());
        EXPECT_EQ(all.nextId(), P + all.count());

        // Some thirty independent samples of a number that scatters by 5 %, and
        // those that should break twice in a step, of the order of a percent
        EXPECT_NEAR(size/meanSize, 1, 0.03);
    }
}


// ************************************************************************* //
