/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gasProperties.H"

#include "dictionary.H"
#include "error.H"
#include "IStringStream.H"

#include <gtest/gtest.h>

using Foam::acoustics::gasProperties;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

namespace
{

// Air at 20 C and one atmosphere
constexpr double mu = 1.81e-5;
constexpr double rho = 1.204;
constexpr double T = 293.15;
constexpr double M = 28.97;

gasProperties readFrom(const char* text)
{
    Foam::IStringStream is(text);

    return gasProperties::read(Foam::dictionary(is));
}

} // End namespace


TEST(gasProperties, meanFreePathOfAirIsThatOfTheTextbooks)
{
    // mu = 0.499 rho cBar lambda, and cBar = 463 m/s: Hinds, Aerosol Technology
    EXPECT_NEAR
    (
        gasProperties::kineticMeanFreePath(mu, rho, T, M),
        mu/(0.499*rho*463),
        0.005*66e-9
    );
}


TEST(gasProperties, meanFreePathScalesAsKineticTheorySays)
{
    const double lambda = gasProperties::kineticMeanFreePath(mu, rho, T, M);
    const auto ratio = [&](double mu, double rho, double T, double M)
    {
        return gasProperties::kineticMeanFreePath(mu, rho, T, M)/lambda;
    };

    EXPECT_NEAR(ratio(3*mu, rho, T, M), 3, 1e-14);
    EXPECT_NEAR(ratio(mu, 4*rho, T, M), 0.25, 1e-15);
    EXPECT_NEAR(ratio(mu, rho, 4*T, M), 0.5, 1e-15);
    EXPECT_NEAR(ratio(mu, rho, T, 4*M), 2, 1e-14);
}


TEST(gasProperties, entriesOfTheDictionaryReplaceThoseOfAir)
{
    const gasProperties air = gasProperties::air();
    const gasProperties gas = readFrom("rho 0.9; T 390;");

    EXPECT_EQ(gas.rho, 0.9);
    EXPECT_EQ(gas.T, 390);
    EXPECT_EQ(gas.mu, air.mu);
    EXPECT_EQ(gas.c, air.c);
    EXPECT_EQ(gas.nu(), air.mu/0.9);
}


TEST(gasProperties, refusesWhatCannotBe)
{
    EXPECT_THROW(readFrom("rho 0;"), Foam::error);
    EXPECT_THROW(readFrom("mu -1.8e-5;"), Foam::error);
}


// ************************************************************************* //
