/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    Records in messages: what is written is read.

\*---------------------------------------------------------------------------*/

#include "packedRecord.H"

#include <gtest/gtest.h>

using namespace Foam;
using namespace Foam::aerosol;

// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(packedRecord, isReadAsItWasWritten)
{
    messages sent(3);

    for (const int rank : {0, 2})
    {
        for (int n = 0; n < 2; ++n)
        {
            recordWriter record(sent[rank]);

            record << 10.0*rank + n;
            double* const room = record.room(2);
            room[0] = 3;
            room[1] = 4;
            record << Eigen::Vector3d(5, 6, 7) << 8.0;
        }
    }

    const auto all = records(sent, 7);

    ASSERT_EQ(all.size(), 4u);

    for (std::size_t k = 0; k < all.size(); ++k)
    {
        EXPECT_EQ(all[k].second, k < 2 ? 0 : 2);

        recordReader record(all[k].first);

        EXPECT_EQ(record.number(), 10.0*all[k].second + k % 2);

        const double* const numbers = record.numbers(2);
        EXPECT_EQ(numbers[0], 3);
        EXPECT_EQ(numbers[1], 4);
        EXPECT_EQ(record.vector(), Eigen::Vector3d(5, 6, 7));
        EXPECT_EQ(record.number(), 8);
    }
}


// ************************************************************************* //
