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
    const gasProperties gas =
        readFrom("rho 0.9; mu 2e-5; c 400; meanFreePath 1e-7;");

    EXPECT_EQ(gas.rho, 0.9);
    EXPECT_EQ(gas.T, air.T);
    EXPECT_EQ(gas.mu, 2e-5);
    EXPECT_EQ(gas.c, 400);
    EXPECT_EQ(gas.nu(), 2e-5/0.9);
    EXPECT_EQ(gas.meanFreePath, 1e-7);
}


TEST(gasProperties, withoutEntriesItIsAirOfTwentyDegrees)
{
    const gasProperties air = gasProperties::air();

    for (const char* text : {"", "T 293.15;", "p 101325;"})
    {
        const gasProperties gas = readFrom(text);

        EXPECT_EQ(gas.rho, air.rho) << text;
        EXPECT_EQ(gas.mu, air.mu) << text;
        EXPECT_EQ(gas.T, air.T) << text;
        EXPECT_EQ(gas.c, air.c) << text;
        EXPECT_EQ(gas.meanFreePath, air.meanFreePath) << text;
    }
}


//- What a table of the literature says, and by how much it may differ
void expectNear(const double value, const double tabulated, const double share)
{
    EXPECT_NEAR(value, tabulated, share*tabulated);
}


TEST(gasProperties, ofATemperatureAreThoseOfTables)
{
    // Dry air. 250 to 600 K at 1 bar: Incropera, Fundamentals of Heat and Mass
    // Transfer, table A.4; 20, 150 and 500 C at one atmosphere: Cengel, Heat
    // Transfer, table A-15. The speeds of sound are those of a perfect gas with
    // the Cp there.
    const struct { double T, p, rho, mu, c, Cp, kappa; } rows[] =
    {
        {250, 1e5, 1.3947, 1.596e-5, 317, 1006, 22.3e-3},
        {293.15, 101325, 1.204, 1.825e-5, 343.2, 1007, 25.14e-3},
        {400, 1e5, 0.8711, 2.301e-5, 400.4, 1014, 33.8e-3},
        {423.15, 101325, 0.8345, 2.391e-5, 411.3, 1017, 34.43e-3},
        {600, 1e5, 0.5804, 3.058e-5, 487.4, 1051, 46.9e-3},
        {773.15, 101325, 0.4565, 3.563e-5, 548.6, 1093, 55.72e-3}
    };

    for (const auto& row : rows)
    {
        const gasProperties gas =
            readFrom
            (
                (
                    "type air; T " + std::to_string(row.T)
                  + "; p " + std::to_string(row.p) + ";"
                ).c_str()
            );

        SCOPED_TRACE(row.T);

        expectNear(gas.rho, row.rho, 0.002);
        // The laws of Sutherland are within 2 % of measurements, and the
        // conductivities of the two tables differ by that
        expectNear(gas.mu, row.mu, 0.02);
        expectNear(gas.kappa, row.kappa, 0.03);
        expectNear(gas.c, row.c, 0.002);
        expectNear(gas.Cp, row.Cp, 0.004);

        // The usual 66 nm at 20 C are 1.6 % more than those of kinetics
        expectNear
        (
            gasProperties::kineticMeanFreePath(gas.mu, gas.rho, row.T, M),
            gas.meanFreePath,
            0.02
        );
    }
}


TEST(gasProperties, ofAMixtureAreThoseOfTables)
{
    // Incropera, table A.4, at 1 bar (H2O: at one atmosphere)
    const struct { const char* gas; double T, rho, mu, Cp, kappa; } rows[] =
    {
        {"N2 1;", 300, 1.1233, 178.2e-7, 1041, 25.9e-3},
        {"N2 1;", 600, 0.5615, 290.8e-7, 1075, 44.6e-3},
        {"CO2 1;", 300, 1.7730, 149e-7, 851, 16.55e-3},
        {"CO2 1;", 600, 0.8938, 270e-7, 1076, 40.7e-3},
        {"O2 1;", 300, 1.284, 207.2e-7, 920, 26.8e-3},
        {"H2O 1;", 600, 0.365, 214e-7, 2026, 42.2e-3},
        // Air of its parts
        {"N2 0.781; O2 0.21; Ar 0.009;", 400, 0.8711, 230.1e-7, 1014, 33.8e-3}
    };

    for (const auto& row : rows)
    {
        const std::string text
        (
            std::string("type mixture; composition { ") + row.gas + " } T "
          + std::to_string(row.T) + ";"
        );
        const gasProperties gas = readFrom(text.c_str());

        SCOPED_TRACE(text);

        expectNear(gas.rho, row.rho, 0.015);
        expectNear(gas.mu, row.mu, 0.04);
        expectNear(gas.kappa, row.kappa, 0.09);
        expectNear(gas.Cp, row.Cp, 0.015);
    }
}


TEST(gasProperties, aMixtureOfEqualsIsThatGas)
{
    // Wilke's rule must not depend on how the same is written
    const gasProperties one =
        readFrom("type mixture; composition { N2 1; } T 500;");
    const gasProperties two =
        readFrom("type mixture; composition { N2 1; O2 1e-12; } T 500;");

    expectNear(two.mu, one.mu, 1e-10);
    expectNear(two.kappa, one.kappa, 1e-10);
    expectNear(two.c, one.c, 1e-10);
}


TEST(gasProperties, singleEntriesWin)
{
    const gasProperties gas = readFrom
    (
        "type mixture; composition { N2 0.8; CO2 0.2; } T 400; mu 3e-5; c 350;"
        " rho 0.9; Cp 1100; kappa 0.04; meanFreePath 1e-7;"
    );

    EXPECT_EQ(gas.mu, 3e-5);
    EXPECT_EQ(gas.c, 350);
    EXPECT_EQ(gas.rho, 0.9);
    EXPECT_EQ(gas.Cp, 1100);
    EXPECT_EQ(gas.kappa, 0.04);
    EXPECT_EQ(gas.meanFreePath, 1e-7);
    EXPECT_EQ(gas.T, 400);
}


TEST(gasProperties, goWithThePressureAsOfAPerfectGas)
{
    const gasProperties one = readFrom("T 350; p 1e5;");
    const gasProperties two = readFrom("T 350; p 2e5;");

    EXPECT_NEAR(two.rho, 2*one.rho, 1e-14);
    EXPECT_NEAR(two.meanFreePath, 0.5*one.meanFreePath, 1e-20);
    EXPECT_EQ(two.mu, one.mu);
    EXPECT_EQ(two.c, one.c);
}


TEST(gasProperties, refuseDegreesCelsiusAndGaugePressures)
{
    for (const char* text : {"T 20;", "T -3;", "p 0;", "p 1.013;", "p 1e10;"})
    {
        EXPECT_THROW(readFrom(text), Foam::error) << text;
    }
}


TEST(gasProperties, refusesWhatCannotBe)
{
    EXPECT_THROW(readFrom("rho 0;"), Foam::error);
    EXPECT_THROW(readFrom("mu -1.8e-5;"), Foam::error);
    EXPECT_THROW(readFrom("type water;"), Foam::error);
    EXPECT_THROW(readFrom("type mixture;"), Foam::error);
    EXPECT_THROW(readFrom("composition { N2 1; }"), Foam::error);

    for (const char* text : {"", "N2 0.5;", "N2 74; O2 26;", "N2 1; He 0;"})
    {
        const std::string all
        (
            std::string("type mixture; composition { ") + text + " }"
        );

        EXPECT_THROW(readFrom(all.c_str()), Foam::error) << text;
    }
}


// ************************************************************************* //
