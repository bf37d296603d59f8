/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
-------------------------------------------------------------------------------
Description
    What an entry may be, and what the message says of one that it may not be.

\*---------------------------------------------------------------------------*/

#include "checkedDictionary.H"
#include "checkedEntry.H"
#include "dictionary.H"
#include "error.H"
#include "IStringStream.H"

#include <gtest/gtest.h>

#include <functional>
#include <string>

using namespace Foam;

namespace
{

dictionary parse(const std::string& text)
{
    return dictionary(IStringStream(text)());
}

//- What is said, or nothing
std::string message
(
    const std::string& text,
    const std::function<void(const dictionary&)>& read
)
{
    try
    {
        read(parse(text));
    }
    catch (const Foam::error& e)
    {
        return e.message();
    }

    return "";
}

void expectSaid(const std::string& said, const std::string& part)
{
    EXPECT_NE(said.find(part), std::string::npos) << said;
}

const dimensionSet perTime(0, 0, -1, 0, 0);

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(checkedEntry, isANumberInSIUnitsWithOrWithoutDimensions)
{
    EXPECT_EQ(readFinite(parse("f 1400;"), "f", perTime), 1400);
    EXPECT_EQ(readFinite(parse("f -1.5e3;"), "f", perTime), -1500);
    EXPECT_EQ
    (
        readFinite(parse("f [0 0 -1 0 0 0 0] 1400;"), "f", perTime), 1400
    );
}


TEST(checkedEntry, namesTheEntryAndWhatItMustBe)
{
    const auto positive = [](const dictionary& dict)
    {
        readPositive(dict, "f", perTime);
    };

    for (const char* text : {"f 0;", "f -1;"})
    {
        expectSaid(message(text, positive), "Entry 'f'");
        expectSaid(message(text, positive), "positive");
    }

    expectSaid(message("g 1;", positive), "'f'");
    expectSaid(message("f word;", positive), "must be a number");
    expectSaid(message("f 1 2;", positive), "does not hold one number");
    expectSaid(message("f { a 1; }", positive), "'f'");
    expectSaid(message("f [0 1 0 0 0 0 0] 1;", positive), "dimensions");
}


TEST(checkedEntry, hasADefaultOnlyWhereItIsMissing)
{
    EXPECT_EQ(readPositive(parse(""), "f", perTime, 3), 3);
    EXPECT_EQ(readPositive(parse("f 2;"), "f", perTime, 3), 2);
    EXPECT_THROW(readPositive(parse("f 0;"), "f", perTime, 3), Foam::error);

    EXPECT_EQ(readNonNegative(parse("f 0;"), "f", perTime, 3), 0);
    EXPECT_THROW(readNonNegative(parse("f -1;"), "f", perTime, 3), Foam::error);
}


TEST(checkedEntry, mayBeAFraction)
{
    EXPECT_EQ(readFraction(parse("s 1;"), "s"), 1);
    EXPECT_THROW(readFraction(parse("s 0;"), "s"), Foam::error);
    EXPECT_THROW(readFraction(parse("s 1.0001;"), "s"), Foam::error);
    EXPECT_EQ(readFraction(parse(""), "s", 0.25), 0.25);
}


TEST(checkedEntry, mayBeAWholeNumberWithinLimits)
{
    EXPECT_EQ(readInteger(parse("n 7;"), "n", 3, 2, 8), 7);
    EXPECT_EQ(readInteger(parse(""), "n", 3, 2, 8), 3);

    for (const char* text : {"n 1;", "n 9;", "n 2.5;"})
    {
        expectSaid
        (
            message
            (
                text,
                [](const dictionary& dict) { readInteger(dict, "n", 3, 2, 8); }
            ),
            "a whole number, 2 or more, up to 8"
        );
    }

    EXPECT_EQ(readSeed(parse("")), 1);
    EXPECT_THROW(readSeed(parse("seed -1;")), Foam::error);
}


TEST(checkedEntry, mayBeAVectorOrADirection)
{
    EXPECT_EQ
    (
        readVector(parse("v (1 2 3);"), "v", dimless, Zero), vector(1, 2, 3)
    );
    EXPECT_EQ
    (
        readDirection(parse("v (0 0 -4);"), "v", vector(1, 0, 0)),
        vector(0, 0, -1)
    );
    EXPECT_NEAR
    (
        mag(readDirection(parse("v (3e200 4e200 0);"), "v", Zero)), 1, 1e-15
    );
    EXPECT_THROW
    (
        readDirection(parse("v (0 0 0);"), "v", vector(1, 0, 0)), Foam::error
    );
    EXPECT_THROW
    (
        readVector(parse("v (1 2 3) 4;"), "v", dimless, Zero), Foam::error
    );
}


TEST(checkedEntry, isOneOfTheValidOnes)
{
    const auto only = [](const dictionary& dict)
    {
        requireOnly(dict, {"type", "value"});
    };

    EXPECT_EQ(message("type a; value 1;", only), "");
    expectSaid(message("type a; vlaue 1;", only), "'vlaue'");
    expectSaid(message("type a; vlaue 1;", only), "value");
}


// ************************************************************************* //
