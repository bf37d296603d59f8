/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Pairs and their ghosts, when particles are removed: as if they were listed
    anew.

\*---------------------------------------------------------------------------*/

#include "IStringStream.H"
#include "neighbourList.H"
#include "periodicBox.H"
#include "randomNumbers.H"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

using namespace Foam;
using namespace Foam::aerosol;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr int nParticles = 200;

using key = std::tuple<int, int, int, int, int>;

//- The pairs by ids and image
std::multiset<key> keys(const neighbourList& list, const scalars& id)
{
    std::multiset<key> found;

    for (const particlePair& pair : list.pairs())
    {
        const int n = list.layer().n();
        const periods image = list.layer().image(pair.j);
        const double idJ = pair.j < n ? id(pair.j) : list.ghostId()(pair.j - n);

        found.insert({int(id(pair.i)), int(idJ), image[0], image[1], image[2]});
    }

    return found;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(neighbourList, removesParticlesAsIfItWereListedAnew)
{
    const periodicBox box
    (
        dictionary(IStringStream("centre (0 0 0); length 1;")())
    );

    testTools::randomNumbers random(3);

    vectors x(3, nParticles);
    scalars reach(nParticles);
    scalars id(nParticles);

    for (int i = 0; i < nParticles; ++i)
    {
        x.col(i) = random.point(0.5);
        reach(i) = random.uniform(0.04, 0.12);
        id(i) = 1000 - i;
    }

    cellGrid grid;
    neighbourList list(box);
    list.findTouching(grid, id, x, reach);

    const int all = list.layer().nGhosts();
    const auto before = keys(list, id);
    list.keepNeededGhosts();

    EXPECT_GT(before.size(), 200u);
    EXPECT_EQ(keys(list, id).size(), before.size());
    EXPECT_LT(list.layer().nGhosts(), all);
    list.fillIds(id);
    EXPECT_EQ(keys(list, id), before);

    // A quarter of the particles goes; the last ones take their places
    std::vector<char> marked(nParticles, 0);
    std::vector<int> places(nParticles);
    int left = 0;

    for (int i = 0; i < nParticles; ++i)
    {
        marked[i] = i % 4 == 1;
        places[i] = marked[i] ? -1 : i;
        left += !marked[i];
    }
    for (const auto& move : moves(marked))
    {
        places[move.first] = move.second;
    }

    list.remove(marked, places, left);
    remove(x, marked);
    remove(reach, marked);
    remove(id, marked);
    list.fillIds(id);

    neighbourList anew(box);
    anew.findTouching(grid, id, x, reach);

    EXPECT_LT(keys(list, id).size(), before.size());
    EXPECT_EQ(keys(list, id), keys(anew, id));
}


TEST(neighbourList, findsWhatActsOrTouchesAboutBoxes)
{
    const Eigen::Array3d period(1.0, 1.3, 0.9);
    const periodicBox box
    (
        dictionary(IStringStream("centre (0 0 0); length (1 1.3 0.9);")())
    );

    testTools::randomNumbers random(5);

    vectors x(3, nParticles);
    vectors extent(3, nParticles);
    scalars size(nParticles);
    scalars range(nParticles);
    scalars id(nParticles);

    for (int i = 0; i < nParticles; ++i)
    {
        x.col(i) = (random.point(0.5).array()*period).matrix();
        extent.col(i) <<
            random.uniform(0, 0.2), random.uniform(0, 0.02), 0;
        size(i) = random.logUniform(0.001, 0.05);
        range(i) = i % 3 ? random.logUniform(0.002, 0.1) : 0;
        id(i) = 1000 - i;
    }

    verletSkin skin;
    skin.make(x, extent, size);

    cellGrid grid;
    neighbourList acting(box);
    neighbourList touching(box);
    acting.findActing(grid, id, skin, range, touching);
    touching.fillIds(id);
    acting.fillIds(id);

    // Every particle against every image of every other one
    std::multiset<key> act;
    std::multiset<key> touch;

    for (int i = 0; i < nParticles; ++i)
    {
        for (int j = 0; j < nParticles; ++j)
        {
            for (int image = 0; i != j && image < 27; ++image)
            {
                const Eigen::Array3d m
                    (image/9 - 1, image/3%3 - 1, image%3 - 1);
                const Eigen::Array3d r =
                    (x.col(j) - x.col(i)).array() + m*period;

                double gapSqr = 0;
                for (int k = 0; k < 3; ++k)
                {
                    const double gap =
                        std::abs(r(k)) - extent(k, i) - extent(k, j);
                    gapSqr += gap > 0 ? gap*gap : 0;
                }

                const double gap = std::sqrt(gapSqr) - size(i) - size(j);
                const key one
                    (id(i), id(j), int(m(0)), int(m(1)), int(m(2)));

                if (range(j) > 0 && gap <= range(j))
                {
                    act.insert(one);
                }
                if (id(i) < id(j) && gap <= 0)
                {
                    touch.insert(one);
                }
            }
        }
    }

    EXPECT_EQ(keys(acting, id), act);
    EXPECT_EQ(keys(touching, id), touch);
    EXPECT_GT(touch.size(), 20u);
    EXPECT_GT(act.size(), touch.size());
}


// ************************************************************************* //
