/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Which rank owns a point, and where the subdomains are.

\*---------------------------------------------------------------------------*/

#include "decomposition.H"
#include "dictionary.H"
#include "eigenVector.H"
#include "IStringStream.H"
#include "periodicBox.H"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

using namespace Foam;
using namespace Foam::aerosol;

namespace
{

periodicBox box(const std::string& length)
{
    return periodicBox
    (
        dictionary
        (
            IStringStream("centre (1e-3 0 0); length " + length + ";")()
        )
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(decomposition, isOfEqualBoxesThatFillTheDomain)
{
    const periodicBox domain = box("(1e-3 2e-3 3e-3)");

    for (const int n : {1, 2, 3, 7, 12, 64})
    {
        const decomposition parts(domain, n);
        ASSERT_EQ(parts.n(), n);

        const double share = domain.volume()/n;
        std::vector<int> found(n, 0);

        for (int rank = 0; rank < n; ++rank)
        {
            const Eigen::Array3d span = parts.upper(rank) - parts.lower(rank);
            EXPECT_NEAR(span.prod(), share, 1e-12*share);

            const Eigen::Vector3d middle =
                0.5*(parts.lower(rank) + parts.upper(rank));
            ++found[parts.rankOf(middle)];
            EXPECT_EQ(parts.rankOf(middle), rank);
        }

        EXPECT_EQ(found, std::vector<int>(n, 1));
    }
}


TEST(decomposition, hasEachPointInTheSubdomainOfItsRank)
{
    const periodicBox domain = box("(1e-3 2e-3 3e-3)");
    const decomposition parts(domain, 12);

    std::srand(1);
    for (int k = 0; k < 1000; ++k)
    {
        const Eigen::Array3d x =
            toEigen(domain.bounds().midpoint()).array()
          + 0.5*Eigen::Array3d::Random()
           *toEigen(domain.bounds().span()).array();
        const int rank = parts.rankOf(x);

        EXPECT_TRUE((x >= parts.lower(rank) - 1e-18).all());
        EXPECT_TRUE((x <= parts.upper(rank) + 1e-18).all());
    }
}


TEST(decomposition, ownsWhatIsALittleOutside)
{
    const periodicBox domain = box("(1e-3 2e-3 3e-3)");
    const decomposition parts(domain, 8);

    EXPECT_EQ(parts.rankOf(toEigen(domain.bounds().min()).array() - 1e-6), 0);
    EXPECT_EQ(parts.rankOf(toEigen(domain.bounds().max()).array() + 1e-6), 7);
}


TEST(decomposition, hasCompactSubdomains)
{
    // The surface of a rank's ghosts: a slender domain is cut into slices, a
    // cube into cubes
    const decomposition slices(box("(1e-3 1e-3 8e-3)"), 8);
    const decomposition cubes(box("(1e-3 1e-3 1e-3)"), 8);

    for (const decomposition* parts : {&slices, &cubes})
    {
        const Eigen::Array3d span = parts->upper(3) - parts->lower(3);
        EXPECT_NEAR(span.maxCoeff(), span.minCoeff(), 1e-15);
    }
}


// ************************************************************************* //
