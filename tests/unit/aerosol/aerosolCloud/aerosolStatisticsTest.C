/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// What the tables of a run are made of: the statistics of an aerosol, against
// numbers worked out by hand and a lognormal sample, and the tables themselves

#include "aerosolStatistics.H"
#include "agglomerationTables.H"

#include "OSspecific.H"
#include "Time.H"

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


//- A case without a mesh in a temporary directory
class temporaryTime
{
    const fileName dir_;

    static fileName newDirectory()
    {
        char name[] = "/tmp/aerosolStatisticsTestXXXXXX";
        return mkdtemp(name);
    }

    static dictionary controlDict(const scalar startTime)
    {
        dictionary dict;
        dict.add("startFrom", word("startTime"));
        dict.add("startTime", startTime);
        dict.add("deltaT", 1);
        dict.add("endTime", 10);
        dict.add("writeInterval", 1);
        return dict;
    }

public:

    Time runTime;

    explicit temporaryTime(const scalar startTime = 0)
    :
        dir_(newDirectory()),
        runTime
        (
            controlDict(startTime),
            dir_.path(),
            dir_.name(),
            "system",
            "constant",
            false,
            false
        )
    {}

    ~temporaryTime()
    {
        rmDir(dir_);
    }

    //- A file of postProcessing/aerosol, line by line
    std::vector<std::string> lines(const fileName& name) const
    {
        std::ifstream file(dir_/"postProcessing"/"aerosol"/name);
        std::vector<std::string> result;
        for (std::string line; std::getline(file, line); )
        {
            result.push_back(line);
        }
        return result;
    }
};


std::vector<std::string> words(const std::string& line)
{
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
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
    temporaryTime c;
    agglomerationTables tables(c.runTime, someBins());
    const particleArrays p(particlesOf({1e-6, 2e-6, 4e-6}));
    const aerosolStatistics now(p);

    tables.writeRow(1.0/3, now, 12, 4, 1e-9, 1234567890123);

    // Read while the tables are still open: nothing may wait in a buffer
    const auto lines = c.lines("0/agglomeration.dat");
    ASSERT_GT(lines.size(), 1u);

    const auto names = words(lines[lines.size() - 2]);
    const auto row = words(lines.back());

    // One name for each column, and # before them
    ASSERT_EQ(row.size(), 14u);
    ASSERT_EQ(names.size(), 15u);
    EXPECT_EQ(names[0], "#");

    std::map<std::string, std::string> value;
    for (unsigned k = 0; k < row.size(); ++k)
    {
        value[names[k + 1]] = row[k];
    }

    EXPECT_EQ(value["time[s]"], "3.333333333333333e-01");
    EXPECT_EQ(value["particles"], "3");
    EXPECT_EQ(value["concentration[1/m3]"], "3.000000000e+09");
    EXPECT_EQ(value["efficiency"], "7.500000000e-01");
    EXPECT_EQ(value["efficiencyPM2.5"], "5.000000000e-01");
    EXPECT_EQ(value["CMD[m]"], "2.000000000e-06");
    EXPECT_EQ(value["MMD[m]"], "4.000000000e-06");
    EXPECT_EQ(value["dMax[m]"], "4.000000000e-06");
    EXPECT_EQ(value["contacts"], "1234567890123");
    EXPECT_NEAR(std::stod(value["GSD"]), now.GSD, 1e-9);
    EXPECT_NEAR(std::stod(value["mass[kg]"])/now.mass, 1, 2e-15);
    for (const int cmpt : {0, 1, 2})
    {
        const std::string name
        (
            std::string("momentum") + "XYZ"[cmpt] + "[kg.m/s]"
        );
        EXPECT_NEAR(std::stod(value[name])/now.momentum(cmpt), 1, 2e-15);
    }
}


TEST(agglomerationTables, sizesAreReadable)
{
    temporaryTime c;
    agglomerationTables tables(c.runTime, someBins());

    tables.writeSizes(0.5, particlesOf({0.9e-6, 1e-6, 1e-6, 7.9e-6, 8e-6}).d);

    const auto lines = c.lines("0/sizeDistribution.dat");
    ASSERT_GT(lines.size(), 2u);

    const auto edges = words(lines[lines.size() - 3]);
    ASSERT_EQ(edges.size(), 2u + 33);
    EXPECT_EQ(edges[1], "edges[m]");
    EXPECT_EQ(std::stod(edges[2]), 1e-6);
    EXPECT_EQ(std::stod(edges.back()), 8e-6);

    const auto row = words(lines.back());
    ASSERT_EQ(row.size(), 1u + 34);
    EXPECT_EQ(std::stod(row[0]), 0.5);
    EXPECT_EQ(row[1], "1") << "below the bins";
    EXPECT_EQ(row[2], "2") << "the first bin";
    EXPECT_EQ(row[3], "0");
    EXPECT_EQ(row[33], "1") << "the last bin";
    EXPECT_EQ(row[34], "1") << "above the bins";
}


TEST(agglomerationTables, replaceNoFile)
{
    temporaryTime c(2);
    const aerosolStatistics s(particlesOf({1e-6}));

    for (const label contacts : {1, 2, 3})
    {
        agglomerationTables tables(c.runTime, someBins());
        tables.writeRow(2, s, 1, 1, 1, contacts);
    }

    const auto contacts = [&c](const fileName& name)
    {
        const auto lines = c.lines(name);
        return lines.empty() ? "no such file" : words(lines.back()).at(9);
    };

    EXPECT_EQ(contacts("2/agglomeration.dat"), "1");
    EXPECT_EQ(contacts("2/agglomeration_2.dat"), "2");
    EXPECT_EQ(contacts("2/agglomeration_3.dat"), "3");
}


// ************************************************************************* //
