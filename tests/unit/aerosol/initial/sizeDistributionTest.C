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


namespace
{

//- By brute force: midpoints of the quantile
double bruteMoment
(
    const sizeDistribution& size,
    const int k,
    const double below = 1
)
{
    const int n = 100000;
    double sum = 0;

    for (int i = 0; i < n; ++i)
    {
        const double d = size.quantile((i + 0.5)/n);

        sum += d < below ? std::pow(d, k)/n : 0;
    }

    return sum;
}


//- A distribution that knows its quantile only, as one of a user's may
class rootSize
:
    public sizeDistribution
{
public:

    scalar quantile(const scalar p) const override
    {
        return 1e-6*(1 + std::sqrt(p));
    }

    scalar min() const override
    {
        return 1e-6;
    }

    scalar max() const override
    {
        return 2e-6;
    }
};


//- A table in a file, with the entries that say how to read it
autoPtr<sizeDistribution> table
(
    const std::string& text,
    const std::string& entries
)
{
    const temporaryFile file(text);

    return make("type table; file \"" + file.name() + "\"; " + entries);
}


std::string tableComplaint
(
    const std::string& text,
    const std::string& entries
)
{
    try
    {
        table(text, entries);
    }
    catch (const IOerror& e)
    {
        return e.message();
    }

    return "";
}


void expectSame(const sizeDistribution& a, const sizeDistribution& b)
{
    for (double p = 0.005; p < 1; p += 0.01)
    {
        EXPECT_NEAR(a.quantile(p), b.quantile(p), 1e-12*b.quantile(p)) << p;
    }
}

} // End anonymous namespace


TEST(sizeDistribution, momentsAreThoseOfTheQuantiles)
{
    const std::string all[] =
    {
        "type monodisperse; diameter 5e-6;",
        lognormals[0].entries(),
        lognormals[3].entries(),
        lognormals[4].entries(),
        "type histogram; bins ((1e-6 2e-6 1) (2e-6 8e-6 2) (1e-5 4e-5 1));",
        "type RosinRammler; d63 2e-5; n 1.5; min 2e-6; max 6e-5;"
    };

    for (const std::string& entries : all)
    {
        const auto size = make(entries);
        const double middle = size->quantile(0.6);

        for (const int k : {0, 1, 2, 3})
        {
            SCOPED_TRACE(entries + " moment " + std::to_string(k));

            const double exact = bruteMoment(*size, k);
            const double part = bruteMoment(*size, k, middle);

            EXPECT_NEAR(size->moment(k)/exact, 1, 5e-4);
            EXPECT_NEAR(size->moment(k, middle)/exact, part/exact, 5e-4);

            if (size->max() > size->min())
            {
                const double median = size->quantileOf(k, 0.5);

                EXPECT_NEAR(size->moment(k, median)/exact, 0.5, 5e-4);
            }
        }
    }

    // By quadrature
    const rootSize root;

    EXPECT_NEAR(root.moment(1), 1e-6*(1 + 2.0/3), 1e-10);
    EXPECT_NEAR(root.moment(0), 1, 1e-12);
    EXPECT_NEAR(root.quantileOf(0, 0.25), 1.5e-6, 1e-13);
    EXPECT_NEAR(root.moment(1, 1.5e-6), 1e-6*(0.25 + 0.125*2/3), 1e-11);
}


TEST(table, volumesBecomeNumbers)
{
    // Of equal volumes in two intervals
    const auto size = table
    (
        "lower;upper;volume\n1;2;50\n4;8;50\n",
        "separator semicolon; unit 1e-6; columns (lower upper volume);"
    );

    // The mean cube of either, with a uniform logarithm
    const double cube1 = 7e-18/(3*std::log(2.0));
    const double cube2 = 64*cube1;
    const double N1 = 1/cube1, N2 = 1/cube2;

    EXPECT_NEAR(size->moment(0, 3e-6), N1/(N1 + N2), 1e-12);
    EXPECT_NEAR(size->moment(3, 3e-6)/size->moment(3), 0.5, 1e-12);
    EXPECT_NEAR(size->moment(3)*(N1 + N2), 2, 1e-12);
    EXPECT_EQ(size->min(), 1e-6);
    EXPECT_EQ(size->max(), 8e-6);
}


TEST(table, allKindsOfColumnsSayTheSame)
{
    const auto reference = table
    (
        "1,2,30\n2,4,50\n4,6,20\n", "unit 1e-6; columns (lower upper volume);"
    );

    const double log2 = std::log10(2.0);

    const struct { std::string text, entries; } same[] =
    {
        {"1e-6,2e-6,30\n2e-6,4e-6,50\n4e-6,6e-6,20\n",
         "columns (lower upper mass);"},
        // A line of text, further columns, decimal commas, tabs
        {"Instrument 7\nx;y;\n1;1,0;2,0;30,0;\n2;2;4;50\n3;4;6;20;\n",
         "unit 1e-6; separator semicolon; decimalComma yes;"
         " columns (skip lower upper volume);"},
        {"1\t2\t30\n2\t4\t50\n4\t6\t20\n",
         "unit 1e-6; separator tab; columns (lower upper volume);"},
        {"  1   2  30\n  2   4  50\n  4   6  20\n",
         "unit 1e-6; separator \" \"; columns (lower upper volume);"},
        {"1,2,30\n2,4,80\n4,6,100\n",
         "unit 1e-6; columns (lower upper volumeUndersize);"},
        {"1,0\n2,0.3\n4,0.8\n6,1\n",
         "unit 1e-6; columns (diameter massUndersize);"},
        {"1,2," + std::to_string(30/log2) + "\n2,4," + std::to_string(50/log2)
       + "\n4,6," + std::to_string(20/std::log10(1.5)) + "\n",
         "unit 1e-6; columns (lower upper dVdlogd);"}
    };

    for (const auto& one : same)
    {
        SCOPED_TRACE(one.text + one.entries);

        const auto size = table(one.text, one.entries);

        for (double p = 0.005; p < 1; p += 0.01)
        {
            EXPECT_NEAR
            (
                size->quantile(p)/reference->quantile(p), 1, 1e-6
            ) << p;
        }
    }

    expectSame
    (
        *table
        (
            "1,2,30\n2,4,50\n4,6,20\n",
            "unit 1e-6; columns (lower upper number);"
        ),
        *make
        (
            "type histogram;"
            " bins ((1e-6 2e-6 30) (2e-6 4e-6 50) (4e-6 6e-6 20));"
        )
    );
    expectSame
    (
        *table
        (
            "1,0\n2,30\n4,80\n6,100\n",
            "unit 1e-6; columns (diameter numberUndersize);"
        ),
        *make
        (
            "type histogram;"
            " bins ((1e-6 2e-6 30) (2e-6 4e-6 50) (4e-6 6e-6 20));"
        )
    );
}


TEST(table, middlesHaveTheirIntervalsBetweenThem)
{
    // As a mobility spectrometer writes it: equal intervals of the logarithm
    expectSame
    (
        *table
        (
            "1,10\n2,20\n4,10\n",
            "unit 1e-6; columns (diameter dNdlogd);"
        ),
        *table
        (
            "0.70710678118654752,1.41421356237309505,10\n"
            "1.41421356237309505,2.8284271247461901,20\n"
            "2.8284271247461901,5.6568542494923802,10\n",
            "unit 1e-6; columns (lower upper number);"
        )
    );
}


TEST(table, withinAnIntervalItIsAsAskedFor)
{
    const std::string text("1,4,1\n");
    const std::string entries("unit 1e-6; columns (lower upper volume); ");

    // The geometric mean halves the numbers, or the volume
    const auto numbers = table(text, entries + "within logUniform;");
    const auto volumes = table(text, entries + "within logUniformVolume;");

    EXPECT_NEAR(numbers->quantile(0.5), 2e-6, 1e-18);
    EXPECT_NEAR(numbers->moment(0, 2e-6), 0.5, 1e-12);
    EXPECT_NEAR(volumes->moment(3, 2e-6)/volumes->moment(3), 0.5, 1e-12);
    EXPECT_NEAR(volumes->quantileOf(3, 0.5), 2e-6, 1e-18);

    // dN goes as d^-4 dd
    EXPECT_NEAR
    (
        volumes->moment(0, 2e-6), (1 - 1.0/8)/(1 - 1.0/64), 1e-12
    );
    EXPECT_NEAR(volumes->quantile((1 - 1.0/8)/(1 - 1.0/64)), 2e-6, 1e-16);
}


TEST(table, samplesHaveTheMomentsOfTheTable)
{
    // What a laser instrument says of a powder, in volumes
    const double edges[] = {0.5, 0.8, 1.3, 2, 3.2, 5, 8};
    const double volumes[] = {2, 6, 15, 30, 33, 14};
    std::string text;

    for (int i = 0; i < 6; ++i)
    {
        text +=
            std::to_string(edges[i]) + "," + std::to_string(edges[i + 1]) + ","
          + std::to_string(volumes[i]) + "\n";
    }

    for (const char* within : {"logUniform", "logUniformVolume"})
    {
        const auto size = table
        (
            text,
            std::string("unit 1e-6; columns (lower upper volume); within ")
          + within + ";"
        );

        const int n = 200000;
        const auto d = sample(*size, n);

        // Shares of the volume below each edge, against the table itself
        for (int k = 1; k < 6; ++k)
        {
            double below = 0;

            for (int i = 0; i < k; ++i)
            {
                below += volumes[i]/100;
            }

            double sum = 0, sumBelow = 0, squares = 0;

            for (const double x : d)
            {
                const double v = x*x*x;

                sum += v;
                sumBelow += x < 1e-6*edges[k] ? v : 0;
            }
            for (const double x : d)
            {
                const double v = x*x*x;
                const double r = (x < 1e-6*edges[k] ? v : 0) - below*v;

                squares += r*r;
            }

            EXPECT_NEAR(sumBelow/sum, below, 4*std::sqrt(squares)/sum)
                << within << ' ' << edges[k];
        }

        // Mean powers, with their standard errors
        for (const int k : {1, 2, 3})
        {
            double sum = 0, squares = 0;

            for (const double x : d)
            {
                sum += std::pow(x, k);
                squares += std::pow(x, 2*k);
            }

            const double mean = sum/n;
            const double error = std::sqrt((squares/n - mean*mean)/n);

            EXPECT_NEAR(size->moment(k), mean, 4*error) << within << k;
        }
    }
}


TEST(table, canBeCutOff)
{
    const auto size = table
    (
        "1,2,10\n2,4,20\n4,8,10\n",
        "unit 1e-6; columns (lower upper number); min 1.41421356237309505e-6;"
        " max 4e-6;"
    );

    EXPECT_NEAR(size->min(), 1.41421356237309505e-6, 1e-18);
    EXPECT_NEAR(size->max(), 4e-6, 1e-18);
    EXPECT_NEAR(size->moment(0, 2e-6), 0.2, 1e-9);
}


TEST(table, badEntriesAreRefused)
{
    const std::string text("lower,upper,volume\n1,2,30\n2,4,50\n");
    const std::string columns("columns (lower upper volume);");
    const std::string ok("unit 1e-6; " + columns);

    const struct { std::string text, entries, because; } all[] =
    {
        {text, ok, ""},
        {text, columns, "no particle is a metre large"},
        {text, "unit 1e-6;", "columns"},
        {text, "unit 1e-6; columns (lower upper);", "one of the amounts"},
        {text, "unit 1e-6; columns (lower volume skip);", "either lower and"},
        {text, "unit 1e-6; columns (lower upper diameter volume);", "either"},
        {text, "unit 1e-6; columns (lower upper vol);", "'vol'"},
        {text, "unit 1e-6; columns (lower upper volume mass);", "second one"},
        {text, ok + "separator bar;", "comma, semicolon, tab or space"},
        {text, ok + "separator \";\";", "no line of 3 numbers"},
        {text, ok + "separator ,;", ""},
        {text, ok + "decimalComma yes;", "cannot separate"},
        {text, ok + "within flat;", "logUniform"},
        {text, ok + "min 3e-6; max 2e-6;", "less than 'max'"},
        {text, ok + "min 5e-6;", "add up to 0"},
        {text, ok + "mim 5e-6;", "mim"},
        {"1,2,30\n2,4\n", ok, "2 columns instead of 3"},
        {"1,2,30\n2,4,x\n", ok, "'x' is not a finite number"},
        {"1,2,30\n1.5,4,5\n", ok, "must rise"},
        {"a,b,c\n", ok, "no line of 3 numbers"},
        {"1,10\n2,20\n", "unit 1e-6; columns (diameter volumeUndersize);",
         "not zero"},
        {"1,0\n2,20\n3,19\n",
         "unit 1e-6; columns (diameter volumeUndersize);", "must not fall"},
        {"2,0\n1,20\n", "unit 1e-6; columns (diameter volumeUndersize);",
         "rise"},
        {"1,5\n", "unit 1e-6; columns (diameter volume);", "no interval"}
    };

    for (const auto& one : all)
    {
        const std::string message(tableComplaint(one.text, one.entries));

        SCOPED_TRACE(one.text + one.entries + " gives: " + message);

        if (one.because.empty())
        {
            EXPECT_EQ(message, "");
        }
        else
        {
            EXPECT_NE(message.find(one.because), std::string::npos);
        }
    }
}


TEST(RosinRammler, volumesAreThoseOfTheFormula)
{
    const double d63 = 2e-5, n = 1.5, min = 1e-6, max = 6e-5;
    const auto size =
        make("type RosinRammler; d63 2e-5; n 1.5; min 1e-6; max 6e-5;");

    const auto above = [&](const double d)
    {
        return std::exp(-std::pow(d/d63, n));
    };

    for (double d = 1.5e-6; d < max; d *= 1.3)
    {
        EXPECT_NEAR
        (
            size->moment(3, d)/size->moment(3),
            (above(min) - above(d))/(above(min) - above(max)),
            1e-5
        ) << d;
    }
}


TEST(RosinRammler, badEntriesAreRefused)
{
    const std::string ok("type RosinRammler; d63 2e-5; ");

    EXPECT_EQ(complaint(ok + "n 1.5; min 1e-6; max 6e-5;"), "");
    // No floating-point errors far out
    EXPECT_EQ(complaint(ok + "n 1000; min 1e-9; max 0.9;"), "");

    expectRefused(ok + "min 1e-6; max 6e-5;", "'n'");
    expectRefused(ok + "n 0; min 1e-6; max 6e-5;", "positive");
    expectRefused(ok + "n 1.5; min 6e-5; max 1e-6;", "less than 'max'");
    expectRefused(ok + "n 1.5; min 1e-2; max 0.1;", "one in a million");
}
