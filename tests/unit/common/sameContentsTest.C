/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    When two dictionaries say the same.

\*---------------------------------------------------------------------------*/

#include "sameContents.H"

#include "IStringStream.H"
#include "OStringStream.H"
#include "dictionary.H"

#include <gtest/gtest.h>

namespace
{

bool same(const std::string& a, const std::string& b)
{
    Foam::IStringStream isA(a);
    Foam::IStringStream isB(b);

    return Foam::sameContents(Foam::dictionary(isA), Foam::dictionary(isB));
}


// What a restart reads: the dictionary as it was written into a file of state
bool sameWhenReread(const std::string& text)
{
    Foam::IStringStream is(text);
    const Foam::dictionary now(is);

    Foam::OStringStream os;
    os.precision(17);
    now.write(os, false);

    Foam::IStringStream again(os.str());
    const Foam::dictionary then(again);

    return Foam::sameContents(then, now);
}

} // End anonymous namespace


TEST(sameContents, doesNotDependOnHowNumbersAreWritten)
{
    EXPECT_TRUE(same("n 30e6;", "n 30000000;"));
    EXPECT_TRUE(same("n 30e6;", "n 3e+07;"));
    EXPECT_TRUE(same("n 30e12;", "n 30000000000000;"));
    EXPECT_TRUE(same("n 1;", "n 1.0;"));
    EXPECT_TRUE(same("v (0.1 2 3e0);", "v (1e-1 2.0 3);"));
    EXPECT_TRUE(same("f [0 0 -1 0 0 0 0] 1400;", "f [0 0 -1 0 0 0 0] 1.4e3;"));
}


TEST(sameContents, doesNotDependOnTheOrderOfEntries)
{
    EXPECT_TRUE(same("a 1; b { c x; d 2; }", "b { d 2; c x; } a 1;"));
}


TEST(sameContents, seesEveryDifference)
{
    // Also in digits that a writePrecision of 6 would cut
    EXPECT_FALSE(same("n 1.0000001;", "n 1.0000002;"));
    EXPECT_FALSE(same("n 1000000;", "n 1000001;"));
    EXPECT_FALSE(same("n 30000000000000;", "n 30000000000001;"));
    EXPECT_FALSE(same("a 1;", "a 1; b 2;"));
    EXPECT_FALSE(same("a 1; b 2;", "a 1;"));
    EXPECT_FALSE(same("a 1;", "b 1;"));
    EXPECT_FALSE(same("a x;", "a y;"));
    EXPECT_FALSE(same("a x;", "a x y;"));
    EXPECT_FALSE(same("a x;", "a { x 1; }"));
    EXPECT_FALSE(same("a 1;", "a one;"));
    EXPECT_FALSE(same("v (1 2 3);", "v (1 3 2);"));
    EXPECT_FALSE(same("b { c { d 1; } }", "b { c { d 2; } }"));
}


TEST(sameContents, holdsForWhatWasWrittenAndRead)
{
    EXPECT_TRUE
    (
        sameWhenReread
        (
            "n 30e6; N 30e12; m 1234567; x 0.1; y 1.00000001; t word;"
            "s \"text\"; v (1e-3 2e6 0.3333333333333333);"
            "list ((1 2) (3 4)); bins 3(1 2 3); b { c 1400.816326530612; }"
        )
    );
}
