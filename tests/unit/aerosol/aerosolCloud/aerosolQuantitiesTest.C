/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// What the report says of an aerosol: optics, collectors and the other
// quantities, against numbers worked out by hand

#include "aerosolQuantities.H"

#include "IStringStream.H"
#include "mathematicalConstants.H"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>

using namespace Foam;
using namespace Foam::aerosol;

namespace
{

dictionary dictOf(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


particleArrays particlesOf(const std::vector<double>& d)
{
    particleArrays p;
    p.resize(d.size());

    for (int i = 0; i < p.size(); ++i)
    {
        p.d(i) = d[i];
        p.m(i) = 1000*p.volume(i);
        p.primaries(i) = 1;
    }

    return p;
}


std::map<std::string, double> valuesOf
(
    const std::string& report,
    const particleArrays& p,
    const double volume
)
{
    const aerosolQuantities quantities(dictOf(report));
    const auto found = quantities.of(p, volume);
    const auto names = quantities.names();

    EXPECT_EQ(names.size(), found.size());

    std::map<std::string, double> values;
    for (unsigned i = 0; i < found.size(); ++i)
    {
        EXPECT_EQ(names[i], found[i].first);
        values.insert(found[i]);
    }

    EXPECT_EQ(values.size(), found.size()) << "a name is there twice";

    return values;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * Tests * * * * * * * * * * * * * * * * * //

TEST(optics, isThatOfVanDeHulst)
{
    using constant::mathematical::pi;

    // With wavelength 2 pi and index 2, rho is the diameter. The efficiencies
    // are those of 40 digits.
    const optics light
    (
        dictOf("wavelength 6.283185307179586; refractiveIndex 2; path 2;")
    );

    for
    (
        const auto& [rho, Q] : std::map<double, double>
        ({
            {0.001, 4.999999722222229e-7},
            {0.0999, 0.004987239006867549},
            {0.1001, 0.005007216792954879},
            {1, 0.47290683729585510},
            {4.0857, 3.1731365603729600},
            {10, 2.2911713055188060}
        })
    )
    {
        EXPECT_NEAR(light.efficiency(rho)/Q, 1, 1e-10) << rho;
    }

    // No step where the series ends
    EXPECT_NEAR
    (
        light.efficiency(0.1*(1 + 1e-9))/light.efficiency(0.1*(1 - 1e-9)),
        1,
        1e-8
    );

    EXPECT_NEAR(light.efficiency(1e5), 2, 1e-4);
    EXPECT_NEAR
    (
        light.crossSection(1), light.efficiency(1)*pi/4, 1e-15
    );
    EXPECT_NEAR(light.transmittance(0.5), std::exp(-1.0), 1e-15);
    EXPECT_NEAR(optics::visibility(2), 3.912023005428146/2, 1e-14);
    EXPECT_EQ(optics::visibility(0), std::numeric_limits<double>::infinity());
}


TEST(optics, isNotThereInTheSameGas)
{
    const optics light
    (
        dictOf("wavelength 550e-9; refractiveIndex 1; path 1;")
    );

    EXPECT_EQ(light.efficiency(1e-6), 0);
}


TEST(collector, isThatOfLapple)
{
    const auto cyclone = collector::New(dictOf("type Lapple; d50 5e-6;"));

    EXPECT_EQ(cyclone->efficiency(5e-6), 0.5);
    EXPECT_NEAR(cyclone->efficiency(10e-6), 0.8, 1e-15);
    EXPECT_NEAR(cyclone->efficiency(2.5e-6), 0.2, 1e-15);
}


TEST(collector, isThatOfATable)
{
    char name[] = "/tmp/aerosolQuantitiesTestXXXXXX";
    ::close(mkstemp(name));

    const auto collectorOf = [&](const char* rows)
    {
        std::ofstream(name) << "diameter,efficiency\n" << rows;
        return collector::New
        (
            dictOf("type table; file \"" + std::string(name) + "\";")
        );
    };

    const auto filter = collectorOf("1e-6,0.1\n4e-6,0.5\n1e-5,0.9\n");

    EXPECT_EQ(filter->efficiency(0.5e-6), 0.1);
    EXPECT_NEAR(filter->efficiency(1e-6), 0.1, 1e-15);
    EXPECT_NEAR(filter->efficiency(2e-6), 0.3, 1e-14);
    EXPECT_NEAR(filter->efficiency(4e-6), 0.5, 1e-14);
    EXPECT_EQ(filter->efficiency(2e-5), 0.9);

    for
    (
        const char* rows :
        {
            "1e-6,0.1\n1e-6,0.2\n", "2e-6,0.1\n1e-6,0.2\n", "0,0.1\n",
            "1e-6,1.1\n", "1e-6,-0.1\n", ""
        }
    )
    {
        EXPECT_THROW(collectorOf(rows), Foam::error) << rows;
    }

    std::remove(name);
}


TEST(aerosolQuantities, areThoseOfHand)
{
    particleArrays p(particlesOf({1e-6, 1e-6, 2e-6, 4e-6}));
    p.primaries << 1, 2, 9, 40;

    const auto value = valuesOf
    (
        "thresholds (1e-6 2.5e-6); collector { type Lapple; d50 2e-6; }"
        "optics { wavelength 1e-6; refractiveIndex 1.33; path 3; }",
        p,
        2e-9
    );

    const auto near = [&](const char* name, const double expected)
    {
        ASSERT_EQ(value.count(name), 1u) << name;
        EXPECT_NEAR(value.at(name)/expected, 1, 1e-13) << name;
    };

    // Sums of d, d^2, d^3, d^4 in um: 8, 22, 74, 274
    near("number_per_m3", 2e9);
    near("mass_g_per_m3", 1e3*p.m.sum()/2e-9);
    near("d10_m", 2e-6);
    near("d32_m", 74e-6/22);
    near("d43_m", 274e-6/74);
    near("d50number_m", 1.5e-6);
    near("d50volume_m", 4e-6);
    near("numberShareAbove_1um", 0.5);
    near("numberShareAbove_2_5um", 0.25);
    near("volumeShareAbove_1um", 72.0/74);
    near("volumeShareAbove_2_5um", 64.0/74);
    near("primaries_1_per_m3", 0.5e9);
    near("primaries_2_per_m3", 0.5e9);
    EXPECT_EQ(value.at("primaries_3to4_per_m3"), 0);
    EXPECT_EQ(value.at("primaries_5to8_per_m3"), 0);
    near("primaries_9to16_per_m3", 0.5e9);
    near("primaries_above16_per_m3", 0.5e9);

    // 0.8, 0.8, 0.5 and 0.2 pass
    near("penetration_number", 2.3/4);
    near("penetration_mass", (0.8 + 0.8 + 0.5*8 + 0.2*64)/74);
    near("massBehind_g_per_m3", 18.4/74*1e3*p.m.sum()/2e-9);

    const double extinction = value.at("extinction_per_m");
    EXPECT_GT(extinction, 0);
    near("transmittance", std::exp(-3*extinction));
    near("visibility_m", 3.912023005428146/extinction);
    EXPECT_EQ(value.size(), 23u);
}


TEST(aerosolQuantities, ofNoParticles)
{
    const auto value = valuesOf
    (
        "thresholds (1e-6); collector { type Lapple; d50 2e-6; }"
        "optics { wavelength 1e-6; refractiveIndex 1.33; path 3; }",
        particlesOf({}),
        1
    );

    for (const auto& [name, x] : value)
    {
        const double expected =
            name == "transmittance" ? 1
          : name == "visibility_m" ? std::numeric_limits<double>::infinity()
          : 0;

        EXPECT_EQ(x, expected) << name;
    }
}


TEST(aerosolQuantities, areThoseThatAreAskedFor)
{
    const particleArrays p(particlesOf({1e-6}));

    EXPECT_TRUE(aerosolQuantities(dictOf("interval 1;")).names().empty());
    EXPECT_EQ(valuesOf("quantities (d32 number);", p, 1).size(), 2u);
    EXPECT_EQ(valuesOf("quantities ();", p, 1).size(), 0u);

    for
    (
        const char* wrong :
        {
            "quantities (d99);", "quantities (d32 d32);",
            "quantities (numberAbove);", "quantities (extinction);",
            "quantities (penetration);", "thresholds (1);",
            "thresholds (2e-6 1e-6);", "thresholds (1e-6 1e-6);",
            "quantities (d32); thresholds (1e-6);",
            "quantities (d32); collector { type Lapple; d50 1e-6; }",
            "collector { type Lapple; d50 0; }", "collector { type cyclone; }",
            "collector { type Lapple; d50 1e-6; d60 1e-6; }", "optics { }",
            "optics { wavelength 1e-6; refractiveIndex 1.3; path 0; }",
            "optics 1;", "collector Lapple;"
        }
    )
    {
        EXPECT_THROW(aerosolQuantities(dictOf(wrong)), Foam::error) << wrong;
    }
}


// ************************************************************************* //
