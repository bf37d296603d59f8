/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "counterRandom.H"
#include "neighbourList.H"
#include "periodicBox.H"
#include "periodicPairs.H"
#include "IStringStream.H"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

using namespace Foam;
using namespace Foam::aerosol;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using pairKey = std::tuple<int, int, int, int, int>;
using pairSet = std::multiset<pairKey>;

periodicBox makeBox(const std::string& length)
{
    return periodicBox
    (
        dictionary
        (
            IStringStream("centre (0.1 -0.2 0.3); length " + length + ";")()
        )
    );
}


//- Unordered pairs have their smaller index first, seen from there
pairKey key(const particlePair& p, const bool ordered)
{
    if (ordered || p.i < p.j)
    {
        return {p.i, p.j, p.image[0], p.image[1], p.image[2]};
    }
    return {p.j, p.i, -p.image[0], -p.image[1], -p.image[2]};
}


pairSet keys(const std::vector<particlePair>& pairs, const bool ordered)
{
    pairSet set;
    for (const particlePair& p : pairs)
    {
        set.insert(key(p, ordered));
    }
    return set;
}


//- Every particle against every image of every other one
template<class Reaches>
pairSet bruteForce
(
    const vectors& x,
    const Eigen::Array3d& period,
    const bool ordered,
    const Reaches& reaches
)
{
    pairSet set;
    const int n = static_cast<int>(x.cols());

    for (int i = 0; i < n; ++i)
    {
        for (int j = ordered ? 0 : i + 1; j < n; ++j)
        {
            for (int image = 0; i != j && image < 27; ++image)
            {
                const Eigen::Array3d m
                    (image/9 - 1, image/3%3 - 1, image%3 - 1);

                const double r =
                    (x.col(j).array() + m*period - x.col(i).array())
                   .matrix().norm();

                if (r <= reaches(i, j))
                {
                    set.insert({i, j, int(m(0)), int(m(1)), int(m(2))});
                }
            }
        }
    }

    return set;
}


//- Both searches against brute force
void compare
(
    const domain& box,
    const vectors& x,
    const scalars& reach
)
{
    EXPECT_EQ
    (
        keys(neighbourList::touching(box, x, reach), false),
        bruteForce
        (
            x, box.period(), false,
            [&](int i, int j) { return reach(i) + reach(j); }
        )
    );

    EXPECT_EQ
    (
        keys(testTools::actingPairs(box, x, reach), true),
        bruteForce
        (
            x, box.period(), true,
            [&](int, int j) { return reach(j) > 0 ? reach(j) : -1; }
        )
    );
}


//- Random positions in the box, snapped to a lattice if n > 0
vectors positions
(
    const domain& box,
    const int n,
    const int seed,
    const int lattice = 0
)
{
    const counterRandom random(seed);
    vectors x(3, n);

    for (int i = 0; i < n; ++i)
    {
        for (int k = 0; k < 3; ++k)
        {
            double s =
                random.uniforms(i, 0, counterRandom::stream::position)[k];

            if (lattice)
            {
                s = std::floor(s*lattice)/lattice;
            }

            x(k, i) = box.bounds().min()[k] + s*box.bounds().span()[k];
        }
    }

    return x;
}


scalars reaches(const int n, const int seed, const double ratio)
{
    const counterRandom random(seed + 1000);
    scalars reach(n);

    for (int i = 0; i < n; ++i)
    {
        const double s =
            random.uniforms(i, 0, counterRandom::stream::size)[0];
        reach(i) = 0.4/ratio*std::pow(ratio, s);
    }

    return reach;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(cellGrid, findsAllPairsOfRandomPolydisperseSets)
{
    const periodicBox box = makeBox("1");

    for (int seed = 0; seed < 10; ++seed)
    {
        // Reaches up to 0.4 in a box of 1: sums up to 0.8 find two images
        compare(box, positions(box, 300, seed), 0.5*reaches(300, seed, 100));
    }
}


TEST(cellGrid, findsTheImagesInAnElongatedBox)
{
    const periodicBox box = makeBox("(2 0.9 1.3)");

    for (int seed = 0; seed < 5; ++seed)
    {
        compare(box, positions(box, 200, seed), reaches(200, seed, 10));
    }
}


TEST(cellGrid, findsParticlesOnTheFacesOfCells)
{
    const periodicBox box = makeBox("1");

    // Distances that equal the reach but for rounding are left out
    const scalars reach = scalars::Constant(216, 0.13);

    for (const int lattice : {2, 4, 5, 6, 8, 10})
    {
        compare(box, positions(box, 216, lattice, lattice), reach);
    }
}


TEST(cellGrid, findsPairsAcrossACorner)
{
    const periodicBox box = makeBox("1");
    const vector lower = box.bounds().min();
    const vector upper = box.bounds().max();

    vectors x(3, 2);
    x << lower.x() + 1e-3, upper.x() - 1e-3,
         lower.y() + 1e-3, upper.y() - 1e-3,
         lower.z() + 1e-3, upper.z() - 1e-3;

    const std::vector<particlePair> pairs =
        neighbourList::touching(box, x, scalars::Constant(2, 2e-3));

    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(key(pairs[0], false), pairKey(0, 1, -1, -1, -1));
}


TEST(cellGrid, findsParticlesThatLeftTheBounds)
{
    const periodicBox box = makeBox("1");

    vectors x = positions(box, 200, 3);
    x.array() += 0.05;

    compare(box, x, reaches(200, 3, 100)*0.5);
}


TEST(cellGrid, ignoresWhatHasNoReach)
{
    const periodicBox box = makeBox("1");

    scalars reach = reaches(100, 1, 100)*0.5;
    reach.head(50).setZero();

    compare(box, positions(box, 100, 1), reach);
}


TEST(cellGrid, acceptsNoParticles)
{
    const periodicBox box = makeBox("1");

    const vectors x(3, 0);
    EXPECT_TRUE(neighbourList::touching(box, x, scalars(0)).empty());
    EXPECT_TRUE(testTools::actingPairs(box, x, scalars(0)).empty());
}


// ************************************************************************* //
