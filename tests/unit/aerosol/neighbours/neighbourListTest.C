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


// ************************************************************************* //
