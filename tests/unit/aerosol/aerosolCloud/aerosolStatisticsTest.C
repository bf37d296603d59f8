/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// What the tables of a run are made of: the statistics of an aerosol, against
// numbers worked out by hand and a lognormal sample, and the tables themselves

#include "aerosolStatistics.H"
#include "agglomerationTables.H"

#include "OSspecific.H"
#include "tableFolder.H"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

using namespace Foam;
using namespace Foam::aerosol;

namespace
{

particleArrays particlesOf(const std::vector<double>& d)
{
    particleArrays p;
    p.resize(d.size());

    for (int i = 0; i < p.size(); ++i)
    {
        p.id(i) = i;
        p.d(i) = d[i];
        p.m(i) = 1000*p.volume(i);
        p.x.col(i).setZero();
        p.v.col(i) << 3, i, -2;
        p.primaries(i) = 1;
    }

    return p;
}


//- Tables in a temporary directory
class temporaryFolder
{
    const fileName dir_;

    static fileName newDirectory()
    {
        char name[] = "/tmp/aerosolStatisticsTestXXXXXX";
        return mkdtemp(name);
    }

public:

    temporaryFolder()
    :
        dir_(newDirectory())
    {}

    ~temporaryFolder()
    {
        rmDir(dir_);
    }

    tableFolder tables(const double start = 0, const bool isNew = true) const
    {
        return tableFolder(dir_, start, 1e-6, isNew);
    }

    fileName write(const fileName& name, const std::string& text) const
    {
        std::ofstream(dir_/name) << text;
        return dir_/name;
    }

    std::string text(const fileName& name) const
    {
        std::ifstream file(dir_/name);
        return {std::istreambuf_iterator<char>(file), {}};
    }

    std::vector<std::string> lines(const fileName& name) const
    {
        std::istringstream file(text(name));
        std::vector<std::string> result;
        for (std::string line; std::getline(file, line); )
        {
            result.push_back(line);
        }
        return result;
    }
};


//- Of a row
std::vector<std::string> values(const std::string& line)
{
    std::istringstream in(line);
    std::vector<std::string> result;
    for (std::string value; std::getline(in, value, ','); )
    {
        result.push_back(value);
    }
    return result;
}


dictionary someBins()
{
    return agglomerationTables::sizeBins
    (
        dictionary(),
        particlesOf({1e-6, 2e-6}).d
    );
}

} // End anonymous namespace


TEST(aerosolStatistics, byHand)
{
    // Masses 1, 8, 27, 64 (in units of the smallest): half of 100 is reached
    // with the fourth; ln d are 0, ln 2, ln 3, ln 4
    const aerosolStatistics s(particlesOf({2e-6, 1e-6, 4e-6, 3e-6}));
    const double m1 = 1000*M_PI/6*1e-18;

    EXPECT_EQ(s.size, 4);
    EXPECT_EQ(s.sizePM25, 2);
    EXPECT_DOUBLE_EQ(s.countMedianDiameter, 2.5e-6);
    EXPECT_DOUBLE_EQ(s.massMedianDiameter, 4e-6);
    EXPECT_DOUBLE_EQ(s.largestDiameter, 4e-6);
    EXPECT_NEAR(s.GSD, 1.824248, 1e-6);  // exp(sqrt(1.084207/3))
    EXPECT_NEAR(s.mass, 100*m1, 1e-12*m1);
    EXPECT_NEAR(s.momentum.x(), 300*m1, 1e-12*m1);
    EXPECT_NEAR(s.momentum.y(), (8*0 + 1*1 + 64*2 + 27*3)*m1, 1e-12*m1);
    EXPECT_NEAR(s.momentum.z(), -200*m1, 1e-12*m1);
}


TEST(aerosolStatistics, oddNumber)
{
    const aerosolStatistics s(particlesOf({3e-6, 1e-6, 7e-6}));

    EXPECT_DOUBLE_EQ(s.countMedianDiameter, 3e-6);
    EXPECT_DOUBLE_EQ(s.massMedianDiameter, 7e-6);
}


TEST(aerosolStatistics, massMedianWithin)
{
    // Masses 1, 1, 1, 1.331, 3.375: of 7.706 in all, 3 up to 1 um, 4.331 up to
    // 1.1 um
    const aerosolStatistics s
    (
        particlesOf({1e-6, 1e-6, 1e-6, 1.5e-6, 1.1e-6})
    );

    EXPECT_DOUBLE_EQ(s.massMedianDiameter, 1.1e-6);
}


TEST(aerosolStatistics, borderOfPM25Belongs)
{
    EXPECT_EQ
    (
        aerosolStatistics(particlesOf({2.5e-6, 2.5000001e-6})).sizePM25,
        1
    );
}


TEST(aerosolStatistics, oneParticle)
{
    const aerosolStatistics s(particlesOf({2e-6}));

    EXPECT_EQ(s.size, 1);
    EXPECT_EQ(s.GSD, 1);
    EXPECT_EQ(s.countMedianDiameter, 2e-6);
    EXPECT_EQ(s.massMedianDiameter, 2e-6);
}


TEST(aerosolStatistics, noParticles)
{
    const aerosolStatistics s(particlesOf({}));

    EXPECT_EQ(s.size, 0);
    EXPECT_EQ(s.mass, 0);
    EXPECT_EQ(s.GSD, 0);
    EXPECT_EQ(s.countMedianDiameter, 0);
    EXPECT_EQ(s.momentum, Eigen::Vector3d::Zero());
}


TEST(aerosolStatistics, lognormal)
{
    // The quantiles of a lognormal distribution, at equal steps of probability
    const double median = 1e-6, sigma = std::log(1.8);
    const int n = 20001;

    // Bisection: slow, and beyond doubt
    const auto quantile = [](const double q)
    {
        double low = -10, high = 10;
        while (high - low > 1e-12)
        {
            const double middle = 0.5*(low + high);
            (0.5*std::erfc(-middle/M_SQRT2) < q ? low : high) = middle;
        }
        return low;
    };

    std::vector<double> d;
    for (int i = 0; i < n; ++i)
    {
        d.push_back(median*std::exp(sigma*quantile((i + 0.5)/n)));
    }

    const aerosolStatistics s(particlesOf(d));

    EXPECT_NEAR(s.countMedianDiameter, median, 1e-10*median);
    EXPECT_NEAR(s.GSD, 1.8, 1e-3);

    // Hatch and Choate: MMD = CMD exp(3 ln^2 GSD), and the mean of d^3 is
    // CMD^3 exp(4.5 ln^2 GSD). The sample ends at 1/40000 and misses some of
    // the large.
    const double massMedian = median*std::exp(3*sigma*sigma);
    EXPECT_NEAR(s.massMedianDiameter, massMedian, 5e-3*massMedian);
    const double mass =
        n*1000*M_PI/6*std::pow(median, 3)*std::exp(4.5*sigma*sigma);
    EXPECT_NEAR(s.mass, mass, 5e-3*mass);

    const double fine = 0.5*std::erfc(-std::log(2.5)/sigma/M_SQRT2);
    EXPECT_NEAR(s.sizePM25, n*fine, 1);
}


TEST(aerosolStatistics, logarithmicBins)
{
    const scalars edges = aerosolStatistics::logarithmicBins(1e-7, 1e-5, 4);

    ASSERT_EQ(edges.size(), 5);
    EXPECT_EQ(edges(0), 1e-7);
    EXPECT_EQ(edges(4), 1e-5);
    for (int k = 0; k < 4; ++k)
    {
        EXPECT_NEAR(edges(k + 1)/edges(k), std::sqrt(10), 1e-14);
    }
}


TEST(aerosolStatistics, histogram)
{
    scalars edges(4), d(9);
    edges << 1, 2, 4, 8;
    d << 0.5, 1, 1.5, 1.99, 2, 5, 7, 8, 100;

    integers expected(5);
    expected << 1, 3, 1, 2, 2;

    EXPECT_TRUE((aerosolStatistics::histogram(d, edges) == expected).all());
    EXPECT_EQ(aerosolStatistics::histogram(d, edges).sum(), d.size());
}


TEST(agglomerationTables, defaultBinsLeaveRoomToGrow)
{
    const dictionary bins(someBins());

    EXPECT_EQ(bins.get<scalar>("min"), 1e-6);
    EXPECT_EQ(bins.get<scalar>("max"), 8e-6);
    EXPECT_EQ(bins.get<label>("n"), 32);
}


TEST(agglomerationTables, givenBinsAreChecked)
{
    const auto bins = [](const char* text)
    {
        return agglomerationTables::sizeBins
        (
            dictionary(IStringStream(text)()),
            particlesOf({1e-6, 2e-6}).d
        );
    };

    EXPECT_EQ(bins("sizeBins { max 9e-6; }").get<scalar>("max"), 9e-6);
    EXPECT_EQ(bins("sizeBins { n 5; }").get<label>("n"), 5);
    EXPECT_THROW(bins("sizeBins { n 0; }"), Foam::error);
    EXPECT_THROW(bins("sizeBins { min 1e-5; }"), Foam::error);
    EXPECT_THROW(bins("sizeBins { min -1; }"), Foam::error);
}


TEST(agglomerationTables, rowsAreReadable)
{
    temporaryFolder c;
    agglomerationTables tables(c.tables(), someBins());
    const particleArrays p(particlesOf({1e-6, 2e-6, 4e-6}));
    const aerosolStatistics now(p);

    tables.writeRow(1.0/3, now, 12, 4, 1e-9, 1234567890123);

    // Read while the tables are still open: nothing may wait in a buffer
    const auto lines = c.lines("agglomeration.csv");
    ASSERT_EQ(lines.size(), 2u);

    const auto names = values(lines[0]);
    const auto row = values(lines[1]);

    ASSERT_EQ(row.size(), 14u);
    ASSERT_EQ(names.size(), 14u);

    std::map<std::string, std::string> value;
    for (unsigned k = 0; k < row.size(); ++k)
    {
        value[names[k]] = row[k];
    }

    EXPECT_EQ(std::stod(value["time_s"]), 1.0/3);
    EXPECT_EQ(value["number"], "3");
    EXPECT_NEAR(std::stod(value["concentration_per_m3"]), 3e9, 1e-5);
    EXPECT_EQ(value["efficiency"], "0.75");
    EXPECT_EQ(value["efficiency_PM2_5"], "0.5");
    EXPECT_EQ(value["CMD_m"], "2e-06");
    EXPECT_EQ(value["MMD_m"], "4e-06");
    EXPECT_EQ(value["dMax_m"], "4e-06");
    EXPECT_EQ(value["contacts"], "1234567890123");
    EXPECT_EQ(std::stod(value["GSD"]), now.GSD);
    EXPECT_EQ(std::stod(value["mass_kg"]), now.mass);
    for (const int cmpt : {0, 1, 2})
    {
        const std::string name
        (
            std::string("momentum_") + "xyz"[cmpt] + "_kg_m_per_s"
        );
        EXPECT_EQ(std::stod(value[name]), now.momentum(cmpt));
    }
}


TEST(agglomerationTables, sizesAreReadable)
{
    temporaryFolder c;
    agglomerationTables tables(c.tables(), someBins());
    const particleArrays p
    (
        particlesOf({0.9e-6, 1e-6, 1e-6, 7.9e-6, 8e-6})
    );

    tables.writeSizes(0.5, p, 1);

    const auto lines = c.lines("sizeDistribution.csv");
    ASSERT_EQ(lines.size(), 1u + 34);
    EXPECT_EQ(lines[0], "time_s,lower_m,upper_m,number,mass_kg");

    const auto below = values(lines[1]);
    EXPECT_EQ(below[0], "0.5");
    EXPECT_EQ(below[1], "0");
    EXPECT_EQ(below[2], "1e-06");
    EXPECT_EQ(below[3], "1");

    EXPECT_EQ(values(lines[2])[3], "2") << "the first bin";
    EXPECT_EQ(std::stod(values(lines[2])[4]), p.m(1) + p.m(2));
    EXPECT_EQ(values(lines[3])[3], "0");
    EXPECT_EQ(values(lines[33])[3], "1") << "the last bin";

    const auto above = values(lines[34]);
    EXPECT_EQ(above[1], "8e-06");
    EXPECT_EQ(above[2], "inf");
    EXPECT_EQ(above[3], "1");
    EXPECT_EQ(std::stod(above[4]), p.m(4));
}


TEST(agglomerationTables, distributionsArePerDecade)
{
    temporaryFolder c;
    agglomerationTables tables(c.tables(), someBins(), false, false, true);
    const particleArrays p
    (
        particlesOf({0.5e-6, 1e-6, 1e-6, 7.9e-6, 8e-6})
    );

    tables.writeSizes(0.5, p, 2);

    const auto lines = c.lines("distributions.csv");
    ASSERT_EQ(lines.size(), 1u + 32);

    const double decades = std::log10(8)/32;
    const double V = 1e-3*p.m.sum();

    const auto near = [&](const std::vector<double>& expected, const int line)
    {
        const auto row = values(lines[line]);
        ASSERT_EQ(row.size(), 3 + expected.size());
        for (unsigned k = 0; k < expected.size(); ++k)
        {
            EXPECT_NEAR(std::stod(row[3 + k])/expected[k], 1, 1e-12) << k;
        }
    };

    const double two = 2e-3*p.m(1);
    near
    (
        {
            1, two/2, 1/decades, two/2/decades,
            0.6, 1e-3*(p.m(0) + p.m(1) + p.m(2))/V
        },
        1
    );
    near
    (
        {
            0.5, 0.5e-3*p.m(3), 0.5/decades, 0.5e-3*p.m(3)/decades,
            0.8, 1 - 1e-3*p.m(4)/V
        },
        32
    );
}


TEST(agglomerationTables, areContinued)
{
    temporaryFolder c;
    const aerosolStatistics s(particlesOf({1e-6}));

    const auto run = [&](const double start, const bool isNew)
    {
        agglomerationTables tables(c.tables(start, isNew), someBins());
        for (int k = 0; k < 3; ++k)
        {
            tables.writeRow(start + k, s, 1, 1, 1, 0);
        }

        std::string times;
        for (const std::string& line : c.lines("agglomeration.csv"))
        {
            times += values(line)[0] + ' ';
        }
        return times;
    };

    EXPECT_EQ(run(0, true), "time_s 0 1 2 ");
    EXPECT_EQ(run(2, false), "time_s 0 1 2 3 4 ");
    EXPECT_EQ(run(1, false), "time_s 0 1 2 3 ");
    EXPECT_TRUE(c.lines("agglomeration.csv.previous").empty());

    EXPECT_EQ(run(5, true), "time_s 5 6 7 ");
    EXPECT_EQ(c.lines("agglomeration.csv.previous").size(), 5u);

    // From before all that is there: that is of another run
    EXPECT_EQ(run(3, false), "time_s 3 4 5 ");
    EXPECT_EQ(c.lines("agglomeration.csv.previous").size(), 4u);
}


TEST(tableFile, rowsThatAreCutOffAreRemoved)
{
    temporaryFolder c;
    const std::string whole("time_s,a\n0,1\n1,2\n");

    const std::vector<std::pair<std::string, std::string>> cases
    ({
        {whole + "2,", whole},
        {whole + "2", whole},
        {whole + "2\n3,4\n", whole},
        {whole + std::string(20, '\0') + '\n', whole},
        {whole + "2,3\n1,4\n", whole},
        {"time_s,a\n", "time_s,a\n"},
        {"time", ""},
        {"", ""}
    });

    for (const auto& [before, after] : cases)
    {
        const fileName file(c.write("a.csv", before));
        tableFile::removeAfter(file, 1, 1e-9);
        EXPECT_EQ(c.text("a.csv"), after) << before;
    }
}


TEST(tableFile, numbersAreExact)
{
    for (const double x : {0.1, 1.0/3, 1e-300, -2.5e-6, 1.5e6 + 5e-6, 1e22})
    {
        EXPECT_EQ(std::stod(tableFile::text(x)), x);
    }
    EXPECT_EQ(tableFile::text(0.1), "0.1");
    EXPECT_EQ(tableFile::text(3), "3");
}


// ************************************************************************* //
