/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Quantiles against distribution functions that are computed here, samples
// against the exact moments of what they are drawn from.

#include "IStringStream.H"
#include "OSspecific.H"
#include "counterRandom.H"
#include "error.H"
#include "normalQuantile.H"
#include "sizeDistribution.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

using namespace Foam;
using namespace Foam::aerosol;

namespace
{

autoPtr<sizeDistribution> make(const std::string& entries)
{
    IStringStream is(entries);

    return sizeDistribution::New(dictionary(is));
}


//- What the user is told; empty if there is no error
std::string complaint(const std::string& entries)
{
    try
    {
        make(entries);
    }
    catch (const IOerror& e)
    {
        return e.message();
    }

    return "";
}


void expectRefused(const std::string& entries, const std::string& because)
{
    EXPECT_NE(complaint(entries).find(because), std::string::npos)
        << entries << " gives: " << complaint(entries);
}


std::vector<double> sample(const sizeDistribution& size, const int n)
{
    const counterRandom random(1);
    std::vector<double> d(n);

    for (int i = 0; i < n; ++i)
    {
        d[i] = size.quantile
        (
            random.uniforms(i, 0, counterRandom::stream::size)[0]
        );
    }

    return d;
}


//- A lognormal distribution between two limits, from the textbook
struct lognormalReference
{
    double median, GSD, min, max;

    double z(const double d) const
    {
        return std::log(d/median)/std::log(GSD);
    }

    static double density(const double z)
    {
        return std::exp(-0.5*z*z)/std::sqrt(2*M_PI);
    }

    //- Fraction of a standard normal distribution between a and b
    static double between(const double a, const double b)
    {
        const double s = std::sqrt(0.5);

        return
            a > 0
          ? 0.5*(std::erfc(s*a) - std::erfc(s*b))
          : 0.5*(std::erfc(-s*b) - std::erfc(-s*a));
    }

    double fractionBelow(const double d) const
    {
        return between(z(min), z(d))/between(z(min), z(max));
    }

    double trueMedian() const
    {
        double lower = min, upper = max;

        for (int i = 0; i < 200; ++i)
        {
            const double middle = 0.5*(lower + upper);

            (fractionBelow(middle) < 0.5 ? lower : upper) = middle;
        }

        return lower;
    }

    //- Mean of the logarithm
    double meanLog() const
    {
        const double a = z(min), b = z(max);

        return
            std::log(median)
          + std::log(GSD)*(density(a) - density(b))/between(a, b);
    }

    //- Standard deviation of the logarithm
    double sigma() const
    {
        const double a = z(min), b = z(max), all = between(a, b);
        const double mean = (density(a) - density(b))/all;

        return std::log(GSD)*std::sqrt
        (
            1 + (a*density(a) - b*density(b))/all - mean*mean
        );
    }

    std::string entries() const
    {
        char text[200];

        std::snprintf
        (
            text, sizeof(text),
            "type lognormal; median %.17g; GSD %.17g; min %.17g; max %.17g;",
            median, GSD, min, max
        );

        return text;
    }
};


//- The aerosol of the documentation, a narrow one, one wide open, and some of
//  which only a tail is left, down to 1e-5 of the particles
const lognormalReference lognormals[] =
{
    {1.5e-6, 1.8, 0.3e-6, 10e-6},
    {1e-6, 1.05, 0.9e-6, 1.2e-6},
    {1e-6, 2.5, 1e-12, 1},
    {0.1e-6, 1.8, 0.4e-6, 5e-6},
    {5e-6, 1.8, 0.1e-6, 1e-6},
    {1e-6, 1.8, 12.5e-6, 100e-6}
};


//- A file that lives as long as the test
class temporaryFile
{
    const std::string name_;

public:

    explicit temporaryFile(const std::string& text)
    :
        name_
        (
            testing::TempDir() + "sizeDistributionTest."
          + std::to_string(Foam::pid()) + ".csv"
        )
    {
        std::ofstream(name_) << text;
    }

    ~temporaryFile()
    {
        std::remove(name_.c_str());
    }

    const std::string& name() const
    {
        return name_;
    }

    std::string entries() const
    {
        return "type histogram; file \"" + name_ + "\";";
    }
};

} // End anonymous namespace


TEST(normalQuantile, invertsTheNormalDistribution)
{
    for (double exponent = -300; exponent < -0.31; exponent += 0.37)
    {
        const double p = std::pow(10, exponent);
        const double z = normalQuantile(p);

        // The error of z that explains the error of p
        const double error =
            (0.5*std::erfc(-z/std::sqrt(2.0)) - p)
           /lognormalReference::density(z);

        EXPECT_NEAR(error/std::max(1.0, std::abs(z)), 0, 1e-14) << p;

        if (p > 1e-3)
        {
            EXPECT_NEAR(normalQuantile(1 - p), -z, 1e-12) << p;
        }
    }

    EXPECT_EQ(normalQuantile(0.5), 0);

    // Table 3 of Wichura
    EXPECT_NEAR(normalQuantile(0.25), -0.6744897501960817, 1e-15);
    EXPECT_NEAR(normalQuantile(0.001), -3.090232306167814, 1e-14);
    EXPECT_NEAR(normalQuantile(1e-20), -9.262340089798408, 1e-14);
}


TEST(monodisperse, allDiametersAreEqual)
{
    const auto size = make("type monodisperse; diameter 5e-6;");

    EXPECT_EQ(size->quantile(1e-3), 5e-6);
    EXPECT_EQ(size->quantile(0.999), 5e-6);
    EXPECT_EQ(size->min(), 5e-6);
    EXPECT_EQ(size->max(), 5e-6);
}


TEST(lognormal, quantileInvertsTheDistributionFunction)
{
    for (const auto& reference : lognormals)
    {
        const auto size = make(reference.entries());

        EXPECT_EQ(size->min(), reference.min);
        EXPECT_EQ(size->max(), reference.max);

        for (double p = 1e-4; p < 1; p += 1e-3)
        {
            EXPECT_NEAR
            (
                reference.fractionBelow(size->quantile(p)), p, 1e-12
            ) << reference.entries();
        }

        // Far into either tail
        for (double p = 1e-16; p < 1e-3; p *= 10)
        {
            const double lower = size->quantile(p);
            const double upper = size->quantile(1 - p);

            EXPECT_GE(lower, reference.min);
            EXPECT_LE(upper, reference.max);

            EXPECT_NEAR(reference.fractionBelow(lower), p, 1e-14);
            EXPECT_NEAR(reference.fractionBelow(upper), 1 - p, 1e-14);
        }
    }
}


TEST(lognormal, samplesHaveTheExactMedianAndGSD)
{
    const int n = 100000;

    for (const auto& reference : lognormals)
    {
        auto d = sample(make(reference.entries())(), n);

        std::sort(d.begin(), d.end());

        // Half of the sample below the true median: a coin tossed n times
        const double below =
            std::lower_bound(d.begin(), d.end(), reference.trueMedian())
          - d.begin();

        EXPECT_NEAR(below/n, 0.5, 4*0.5/std::sqrt(n)) << reference.entries();

        double sum = 0, sumSquares = 0, sumFourth = 0;

        for (const double x : d)
        {
            const double y = std::log(x) - reference.meanLog();

            sum += y;
            sumSquares += y*y;
            sumFourth += y*y*y*y;
        }

        const double variance = sumSquares/n;

        EXPECT_NEAR(sum/n, 0, 4*reference.sigma()/std::sqrt(n))
            << reference.entries();

        EXPECT_NEAR
        (
            variance,
            reference.sigma()*reference.sigma(),
            4*std::sqrt((sumFourth/n - variance*variance)/n)
        ) << reference.entries();
    }
}


TEST(lognormal, badEntriesAreRefused)
{
    const std::string ok("type lognormal; median 1e-6; GSD 2; ");

    EXPECT_EQ(complaint(ok + "min 1e-7; max 1e-5;"), "");

    expectRefused("type lognormal; GSD 2; min 1e-7; max 1e-5;", "median");
    expectRefused(ok + "max 1e-5;", "min");
    expectRefused(ok + "min 1e-7;", "max");
    expectRefused(ok + "min 0; max 1e-5;", "'min'");
    expectRefused(ok + "min -1e-7; max 1e-5;", "'min'");
    expectRefused(ok + "min 1e-5; max 1e-7;", "less than 'max'");
    expectRefused(ok + "min 1e-6; max 1e-6;", "less than 'max'");

    // Microns for metres
    expectRefused(ok + "min 0.1; max 10;", "one in a million");

    for (const char* GSD : {"1", "0.5", "0", "-2"})
    {
        expectRefused
        (
            std::string("type lognormal; median 1e-6; min 1e-7; max 1e-5; GSD ")
          + GSD + ';',
            "GSD"
        );
    }

    // A length with the dimensions of a time
    EXPECT_THROW
    (
        make
        (
            "type lognormal; median [0 0 1 0 0 0 0] 1e-6; GSD 2;"
            " min 1e-7; max 1e-5;"
        ),
        error
    );
}


TEST(histogram, quantilesAreExact)
{
    // 3/4 below the gap, an interval without particles, 1/4 above
    const auto size = make
    (
        "type histogram; bins ((1e-6 2e-6 1) (2e-6 8e-6 2) (8e-6 9e-6 0)"
        " (1e-5 4e-5 1) (5e-5 9e-5 0));"
    );

    EXPECT_DOUBLE_EQ(size->min(), 1e-6);
    EXPECT_DOUBLE_EQ(size->max(), 4e-5);

    EXPECT_DOUBLE_EQ(size->quantile(0.125), 1e-6*std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(size->quantile(0.25), 2e-6);
    EXPECT_DOUBLE_EQ(size->quantile(0.5), 4e-6);
    EXPECT_DOUBLE_EQ(size->quantile(0.875), 2e-5);

    EXPECT_NEAR(size->quantile(0.75 - 1e-12), 8e-6, 1e-16);
    EXPECT_NEAR(size->quantile(0.75 + 1e-12), 1e-5, 1e-16);
    EXPECT_NEAR(size->quantile(1 - 1e-12), 4e-5, 1e-15);
    EXPECT_NEAR(size->quantile(1e-12), 1e-6, 1e-16);
}


TEST(histogram, samplesFillTheIntervals)
{
    const int n = 100000;
    const double edges[] = {1e-6, 2e-6, 5e-6, 7e-6};
    const double fractions[] = {0.2, 0.5, 0.3};

    const auto d = sample
    (
        make
        (
            "type histogram;"
            " bins ((1e-6 2e-6 20) (2e-6 5e-6 50) (5e-6 7e-6 30));"
        )(),
        n
    );

    for (int k = 0; k < 3; ++k)
    {
        double inside = 0, meanLog = 0;

        for (const double x : d)
        {
            if (x > edges[k] && x < edges[k + 1])
            {
                inside += 1;
                meanLog += std::log(x/edges[k])/std::log(edges[k + 1]/edges[k]);
            }
        }

        EXPECT_NEAR
        (
            inside/n,
            fractions[k],
            4*std::sqrt(fractions[k]*(1 - fractions[k])/n)
        );

        EXPECT_NEAR(meanLog/inside, 0.5, 4/std::sqrt(12*inside));
    }
}


TEST(histogram, fileIsReadAsTheSameEntries)
{
    const temporaryFile file
    (
        "# SMPS, day 3\r\n"
        " lower, upper, count\r\n"
        "\r\n"
        "1e-6, 2e-6, 20  # thinly\r\n"
        "2e-6,5e-6,50\r\n"
        "5e-6,7e-6,30"
    );

    const auto fromFile = make(file.entries());
    const auto fromEntries = make
    (
        "type histogram; bins ((1e-6 2e-6 20) (2e-6 5e-6 50) (5e-6 7e-6 30));"
    );

    for (double p = 0.005; p < 1; p += 0.01)
    {
        EXPECT_EQ(fromFile->quantile(p), fromEntries->quantile(p));
    }
}


TEST(histogram, pathsAreRelativeToTheCase)
{
    const temporaryFile file("lower,upper,count\n1e-6,2e-6,1\n");

    const std::string before(getEnv("FOAM_CASE"));
    const auto slash = file.name().rfind('/');
    const std::string name(file.name().substr(slash + 1));

    setEnv("FOAM_CASE", file.name().substr(0, slash), true);

    EXPECT_EQ(complaint("type histogram; file \"" + name + "\";"), "");
    EXPECT_EQ(complaint("type histogram; file \"<case>/" + name + "\";"), "");

    setEnv("FOAM_CASE", "/no/such/case", true);

    expectRefused("type histogram; file \"" + name + "\";", "/no/such/case/");

    setEnv("FOAM_CASE", before, true);
}


TEST(histogram, badEntriesAreRefused)
{
    const auto bins = [](const std::string& list)
    {
        return "type histogram; bins (" + list + ");";
    };

    expectRefused("type histogram;", "neither");
    expectRefused("type histogram; bins ((1 2 3)); file \"a\";", "both");
    expectRefused("type histogram; file \"/no/such/file\";", "/no/such/file");

    expectRefused(bins(""), "add up to 0");
    expectRefused(bins("(1e-6 2e-6 0)"), "add up to 0");
    expectRefused(bins("(0 2e-6 1)"), "must be positive");
    expectRefused(bins("(-1e-6 2e-6 1)"), "must be positive");
    expectRefused(bins("(2e-6 2e-6 1)"), "exceed");
    expectRefused(bins("(2e-6 1e-6 1)"), "exceed");
    expectRefused(bins("(1e-6 2e-6 -1)"), "zero or more");
    expectRefused(bins("(1e-6 3e-6 1) (2e-6 4e-6 1)"), "number 2 of 'bins'");
    expectRefused(bins("(2e-6 3e-6 1) (1e-6 2e-6 1)"), "must rise");

    EXPECT_THROW(make(bins("(1e-6 2e-6)")), IOerror);
    EXPECT_THROW(make(bins("(1e-6 2e-6 1 1)")), IOerror);
}


TEST(histogram, badFilesAreRefusedByLine)
{
    const auto expectFileRefused =
        [](const std::string& text, const int line, const std::string& because)
    {
        const temporaryFile file(text);

        try
        {
            make(file.entries());
            ADD_FAILURE() << "accepted: " << text;
        }
        catch (const IOerror& e)
        {
            EXPECT_NE(e.message().find(because), std::string::npos)
                << e.message();

            if (line)
            {
                EXPECT_EQ(e.ioFileName(), file.name());
                EXPECT_EQ(e.ioStartLineNumber(), line);
            }
        }
    };

    const std::string header("# sizes\nlower,upper,count\n");

    expectFileRefused("", 0, "no numbers");
    expectFileRefused(header, 0, "no numbers");
    expectFileRefused("1e-6,2e-6,1\n", 1, "lower,upper,count");
    expectFileRefused("lower;upper;count\n", 1, "lower,upper,count");
    expectFileRefused(header + "1e-6,2e-6\n", 3, "2 columns instead of 3");
    expectFileRefused(header + "1e-6,2e-6,1,\n", 3, "4 columns instead of 3");
    expectFileRefused(header + "\n1e-6,2e-6,few\n", 4, "'few'");
    expectFileRefused(header + "1e-6,2e-6,\n", 3, "''");
    expectFileRefused(header + "1e-6,nan,1\n", 3, "'nan'");
    expectFileRefused(header + "1e-6,inf,1\n", 3, "'inf'");
    expectFileRefused(header + "1e-6,2e-6,1\n1e-6,3e-6,1\n", 0, "line 4 of");
}


TEST(sizeDistribution, badTypesAreRefused)
{
    expectRefused("type lognormale;", "lognormal");
    expectRefused("", "type");
    expectRefused("type monodisperse;", "diameter");
    expectRefused("type monodisperse; diameter 0;", "positive");
    expectRefused("type monodisperse; diameter -5e-6;", "positive");
}
