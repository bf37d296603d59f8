/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Clouds at random and from lists: what is in them, that no two spheres overlap
// (by brute force), and that bad input is refused with its reason.

#include "IStringStream.H"
#include "OSspecific.H"
#include "domain.H"
#include "error.H"
#include "messageStream.H"
#include "particleSource.H"
#include "sizeDistribution.H"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>

using namespace Foam;
using namespace Foam::aerosol;

namespace
{

//- A box away from the origin, periodic where `period` is not 0
class testBox
:
    public aerosol::domain
{
    const boundBox bounds_;
    const Eigen::Array3d period_;

public:

    explicit testBox
    (
        const vector& span,
        const Eigen::Array3d& periodic = Eigen::Array3d::Ones()
    )
    :
        bounds_(vector(0.06, -1e-4, 0), vector(0.06, -1e-4, 0) + span),
        period_(periodic*Eigen::Array3d(span.x(), span.y(), span.z()))
    {}

    const boundBox& bounds() const override
    {
        return bounds_;
    }

    scalar volume() const override
    {
        return bounds_.volume();
    }

    Eigen::Array3d period() const override
    {
        return period_;
    }

    void confine(vectors&) const override
    {}
};


const testBox cube(vector::uniform(1e-3));


dictionary entries(const std::string& text)
{
    IStringStream is("density 2300; " + text);

    return dictionary(is);
}


particleArrays create
(
    const std::string& text,
    const aerosol::domain& region = cube
)
{
    particleArrays particles;

    particleSource::New(entries(text))->create(region, particles);

    return particles;
}


std::string complaint
(
    const std::string& text,
    const aerosol::domain& region = cube
)
{
    try
    {
        create(text, region);
    }
    catch (const IOerror& e)
    {
        return e.message();
    }

    return "";
}


void expectRefused
(
    const std::string& text,
    const std::string& because,
    const aerosol::domain& region = cube
)
{
    const std::string message(complaint(text, region));

    EXPECT_FALSE(message.empty()) << "accepted: " << text;
    EXPECT_NE(message.find(because), std::string::npos)
        << text << " gives: " << message;
}


//- Particles that overlap the nearest image of another or one of their own
int overlaps(const particleArrays& particles, const aerosol::domain& region)
{
    const Eigen::Array3d period(region.period());
    int n = 0;

    for (int i = 0; i < particles.size(); ++i)
    {
        n += (period > 0 && period < particles.d(i)).any();

        for (int j = 0; j < i; ++j)
        {
            double squaredDistance = 0;

            for (int k = 0; k < 3; ++k)
            {
                double distance =
                    std::abs(particles.x(k, i) - particles.x(k, j));

                if (period(k) > 0)
                {
                    distance = std::min(distance, period(k) - distance);
                }

                squaredDistance += distance*distance;
            }

            const double contact = 0.5*(particles.d(i) + particles.d(j));

            n += squaredDistance < contact*contact;
        }
    }

    return n;
}


//- A twentieth of the box, of diameters from 20 to 200 um
const std::string dense
(
    "source distribution;"
    " size { type lognormal; median 4e-5; GSD 1.6; min 2e-5; max 2e-4; }"
    " count 600;"
);


class temporaryFile
{
    const std::string name_;

public:

    explicit temporaryFile(const std::string& text)
    :
        name_
        (
            testing::TempDir() + "particleSourceTest."
          + std::to_string(Foam::pid()) + ".csv"
        )
    {
        std::ofstream(name_) << text;
    }

    ~temporaryFile()
    {
        std::remove(name_.c_str());
    }

    std::string entries() const
    {
        return "source list; file \"" + name_ + "\";";
    }
};

} // End anonymous namespace


TEST(distributionSource, arraysAreFilled)
{
    const auto particles = create
    (
        "source distribution; size { type monodisperse; diameter 5e-6; }"
        " numberConcentration 2.0004e12;"
    );

    ASSERT_EQ(particles.size(), 2000);

    for (int i = 0; i < particles.size(); ++i)
    {
        EXPECT_EQ(particles.id(i), i);
        EXPECT_EQ(particles.primaries(i), 1);
        EXPECT_EQ(particles.d(i), 5e-6);
        EXPECT_NEAR(particles.m(i), 1.5053464798451093e-13, 1e-26);
        EXPECT_EQ(particles.v.col(i).norm(), 0);
    }
}


TEST(distributionSource, nothingOverlaps)
{
    const auto particles = create(dense);

    EXPECT_GT(particles.m.sum()/2300/cube.volume(), 0.03);
    EXPECT_EQ(overlaps(particles, cube), 0);
}


TEST(distributionSource, nothingOverlapsInNarrowBoxes)
{
    // As wide as two of the largest particles, so that images matter
    const testBox narrow(vector(4e-4, 4e-4, 1e-2));

    const auto particles = create(dense, narrow);

    EXPECT_GT(particles.d.maxCoeff(), 1e-4);
    EXPECT_EQ(overlaps(particles, narrow), 0);
}


// A large one never finds a gap among the small ones: they must make room
TEST(distributionSource, fewLargeAmongManySmallFindPlace)
{
    const auto particles = create
    (
        "source distribution; count 6000; size { type histogram;"
        " bins ((2e-5 2.1e-5 5990) (2e-4 2.1e-4 10)); }"
    );

    const int large = (particles.d > 1e-4).count();

    EXPECT_GT(large, 1);
    EXPECT_LT(large, 20);
    EXPECT_EQ(overlaps(particles, cube), 0);
}


TEST(distributionSource, spheresStayInsideOfWalls)
{
    const testBox channel(vector::uniform(1e-3), Eigen::Array3d(1, 0, 0));

    const auto particles = create(dense, channel);

    EXPECT_EQ(overlaps(particles, channel), 0);

    bool someReachOut = false;

    for (int i = 0; i < particles.size(); ++i)
    {
        const double r = 0.5*particles.d(i);

        for (int k = 0; k < 3; ++k)
        {
            const double lower = particles.x(k, i) - channel.bounds().min()[k];
            const double upper = channel.bounds().max()[k] - particles.x(k, i);

            if (k)
            {
                EXPECT_GE(std::min(lower, upper), r*(1 - 1e-12));
            }
            else
            {
                EXPECT_GE(std::min(lower, upper), 0);
                someReachOut = someReachOut || std::min(lower, upper) < r;
            }
        }
    }

    EXPECT_TRUE(someReachOut);
}


TEST(distributionSource, positionsAreUniform)
{
    const int n = 100000, bins = 20;

    const auto particles = create
    (
        "source distribution; size { type monodisperse; diameter 1e-7; }"
        " count 100000;"
    );

    for (int k = 0; k < 3; ++k)
    {
        Eigen::ArrayXd inBin = Eigen::ArrayXd::Zero(bins);

        for (int i = 0; i < n; ++i)
        {
            const double f =
                (particles.x(k, i) - cube.bounds().min()[k])
               /cube.bounds().span()[k];

            ASSERT_GE(f, 0);
            ASSERT_LT(f, 1);
            inBin(int(bins*f)) += 1;
        }

        // 19 degrees of freedom: mean 19, exceeds 60 in 4 of a million
        const double expected = double(n)/bins;

        EXPECT_LT((inBin - expected).square().sum()/expected, 60);
    }

    // A size that depends on the place would be a wrong cloud
    const auto sizes = create
    (
        "source distribution; count 100000;"
        " size { type lognormal; median 1e-7; GSD 2; min 1e-8; max 1e-6; }"
    );

    const Eigen::ArrayXd y = sizes.d.log() - sizes.d.log().mean();

    for (int k = 0; k < 3; ++k)
    {
        const Eigen::ArrayXd x =
            sizes.x.row(k).transpose().array() - sizes.x.row(k).mean();

        const double correlation =
            (x*y).sum()/std::sqrt(x.square().sum()*y.square().sum());

        EXPECT_LT(std::abs(correlation)*std::sqrt(n), 4);
    }
}


TEST(distributionSource, seedMakesTheCloud)
{
    const auto a = create(dense + "seed 7;");
    const auto same = create(dense + "seed 7;");
    const auto other = create(dense + "seed 8;");
    const auto first = create(dense + "seed 1;");
    const auto byDefault = create(dense);

    EXPECT_EQ(a.x, same.x);
    EXPECT_TRUE((a.d == same.d).all());

    EXPECT_TRUE((a.x.array() != other.x.array()).all());
    EXPECT_TRUE((a.d != other.d).all());

    EXPECT_EQ(first.x, byDefault.x);
    EXPECT_TRUE((first.d == byDefault.d).all());
}


TEST(distributionSource, badEntriesAreRefused)
{
    const std::string size(" size { type monodisperse; diameter 5e-6; } ");
    const std::string source("source distribution;" + size);

    EXPECT_EQ(complaint(source + "count 10;"), "");

    expectRefused(source, "neither");
    expectRefused(source + "count 10; numberConcentration 1e12;", "both");
    expectRefused(source + "count 10; massConcentration 1;", "both");
    expectRefused(source + "massConcentration 0;", "positive");
    expectRefused(source + "count 10; sample latin;", "random or stratified");
    expectRefused(source + "count 0;", "positive");
    expectRefused(source + "count -10;", "positive");
    expectRefused(source + "count 10.5;", "whole number");
    expectRefused(source + "count 1e10;", "whole number");
    expectRefused(source + "numberConcentration -1e12;", "positive");
    expectRefused(source + "numberConcentration 4e8;", "whole number");
    EXPECT_EQ(complaint(source + "numberConcentration 6e8;"), "");

    expectRefused("source distribution; count 10;", "size");
    expectRefused("source distributed;" + size, "valid sources are");
    expectRefused(size, "source");
    expectRefused(source + "count 10; initialVelocity fast;", "gas or rest");

    // A tenth of the box are 190.99 of these
    const std::string large
    (
        "source distribution; size { type monodisperse; diameter 1e-4; }"
    );

    EXPECT_EQ(complaint(large + "count 190;"), "");
    expectRefused(large + "count 191;", "no more than 10 %");

    expectRefused
    (
        "source distribution; size { type monodisperse; diameter 5; }"
        " count 10;",
        "do not fit"
    );

    IStringStream is("density -2300; " + source + "count 10;");

    EXPECT_THROW(particleSource::New(dictionary(is)), IOerror);
}


TEST(distributionSource, massConcentrationIsThatOfTheDistribution)
{
    // Of one size it is exact, to half a particle
    const auto same = create
    (
        "source distribution; size { type monodisperse; diameter 5e-6; }"
        " massConcentration 0.301;"
    );

    EXPECT_EQ(same.size(), int(std::round(0.301e-9/1.5053464798451093e-13)));

    // Else on average: the sample scatters
    const auto particles = create
    (
        "source distribution; massConcentration 1;"
        " size { type lognormal; median 1.5e-6; GSD 1.5; min 5e-7; max 1e-5; }"
    );

    const double mass = particles.m.sum();
    const double n = particles.size();
    const double mean = mass/n;
    const double error =
        std::sqrt(((particles.m - mean).square().sum()/n)*n);

    EXPECT_GT(n, 10000);
    EXPECT_NEAR(mass, 1e-9, 4*error);
}


TEST(distributionSource, stratifiedSamplesHaveOneParticleInEachPart)
{
    const int n = 1000;
    const std::string lognormal
    (
        "type lognormal; median 1e-6; GSD 1.8; min 1e-7; max 2e-5;"
    );
    const std::string size
    (
        "source distribution; count 1000; size { " + lognormal + " } "
    );

    IStringStream is(lognormal);
    const auto distribution = sizeDistribution::New(dictionary(is));

    scalar masses[2] = {0, 0};

    for (const int seed : {1, 2})
    {
        auto particles = create
        (
            size + "sample stratified; seed " + std::to_string(seed) + ";"
        );

        std::sort(particles.d.begin(), particles.d.end());

        for (int i = 0; i < n; ++i)
        {
            const double d = particles.d(i);

            ASSERT_LE(d, distribution->quantile((i + 1.0)/n*(1 - 1e-9)));
            ASSERT_GE(d, distribution->quantile((i + 1e-9)/n));
        }

        masses[seed - 1] = particles.m.sum();
    }

    EXPECT_NE(masses[0], masses[1]);

    // At random is the default
    EXPECT_TRUE
    (
        (create(size).d == create(size + "sample random;").d).all()
    );
    EXPECT_FALSE
    (
        (create(size).d == create(size + "sample stratified;").d).all()
    );
}


TEST(distributionSource, stratifiedSamplesScatterLess)
{
    // Not a line for each sample
    const int level = messageStream::level;
    messageStream::level = 0;

    // Standard deviations over seeds of the mass of 500 particles
    const auto scatter = [](const std::string& sample)
    {
        const int nSeeds = 40;
        double sum = 0, squares = 0;

        for (int seed = 1; seed <= nSeeds; ++seed)
        {
            const double mass = create
            (
                "source distribution; count 500; size { type lognormal;"
                " median 1.5e-6; GSD 1.8; min 3e-7; max 1e-5; } sample "
              + sample + "; seed " + std::to_string(seed) + ";"
            ).m.sum();

            sum += mass;
            squares += mass*mass;
        }

        return std::sqrt(squares/nSeeds - sum*sum/(nSeeds*nSeeds))*nSeeds/sum;
    };

    const double random = scatter("random");
    const double stratified = scatter("stratified");

    messageStream::level = level;

    std::cout
        << "Mass over seeds, standard deviation over mean: " << random
        << " at random, " << stratified << " stratified" << std::endl;

    EXPECT_LT(stratified, 0.25*random);
}


TEST(mixtureSource, populationsHaveTheirOwnDensities)
{
    const std::string fine
    (
        "fine { count 1000; size { type monodisperse; diameter 1e-6; } }"
    );
    const auto particles = create
    (
        "source mixture; seed 3; populations { " + fine
      + " seeds { density 1000; massConcentration 0.1;"
        " size { type monodisperse; diameter 2e-5; } } }"
    );

    // 0.1 kg/m3 of water in drops of 4.19e-12 kg, in a cubic millimetre
    const int n = std::round(0.1e-9/(1000*M_PI/6*8e-15));

    ASSERT_EQ(particles.size(), 1000 + n);
    EXPECT_EQ(overlaps(particles, cube), 0);

    for (int i = 0; i < particles.size(); ++i)
    {
        const bool isFine = i < 1000;

        EXPECT_EQ(particles.id(i), i);
        EXPECT_EQ(particles.d(i), isFine ? 1e-6 : 2e-5);
        EXPECT_NEAR
        (
            particles.m(i)/particles.volume(i), isFine ? 2300 : 1000, 1e-9
        );
    }

    // The first population is that of the same source on its own
    const auto alone = create
    (
        "source distribution; seed 3; count 1000;"
        " size { type monodisperse; diameter 1e-6; }"
    );

    EXPECT_TRUE((particles.m.head(1000) == alone.m).all());
}


TEST(mixtureSource, badEntriesAreRefused)
{
    const std::string size("size { type monodisperse; diameter 1e-6; } ");
    const auto mixture = [&](const std::string& populations)
    {
        return "source mixture; populations { " + populations + " }";
    };

    EXPECT_EQ(complaint(mixture("a { count 1; " + size + "}")), "");

    expectRefused("source mixture;", "'populations'");
    expectRefused(mixture(""), "'populations'");
    expectRefused(mixture("a 1;"), "no dictionary");
    expectRefused(mixture("a { " + size + "}"), "neither");
    expectRefused(mixture("a { count 1; seed 2; " + size + "}"), "seed");
    expectRefused(mixture("a { count 1; density 0; " + size + "}"), "positive");
    expectRefused("source mixture; count 1; " + size, "count");

    // No density anywhere
    IStringStream is(mixture("a { count 1; " + size + "}"));

    EXPECT_THROW(particleSource::New(dictionary(is)), IOerror);
}


TEST(distributionSource, domainsOfOtherShapesAreRefused)
{
    class ball
    :
        public testBox
    {
        using testBox::testBox;

        scalar volume() const override
        {
            return 0.52*bounds().volume();
        }
    };

    expectRefused
    (
        "source distribution; size { type monodisperse; diameter 5e-6; }"
        " count 10;",
        "cuboids",
        ball(vector::uniform(1e-3))
    );
}


TEST(listSource, entriesAreRead)
{
    const auto particles = create
    (
        "source list; particles ("
        " { position (0.0601 0 1e-4); diameter 5e-6; velocity (1 2 3); }"
        " { position (0.0602 1e-5 2e-4); diameter 8e-6; velocity (4 5 6);"
        " primaries 3; } );"
    );

    ASSERT_EQ(particles.size(), 2);
    EXPECT_EQ(particles.id(0), 0);
    EXPECT_EQ(particles.id(1), 1);
    EXPECT_EQ(particles.x.col(0), Eigen::Vector3d(0.0601, 0, 1e-4));
    EXPECT_EQ(particles.x.col(1), Eigen::Vector3d(0.0602, 1e-5, 2e-4));
    EXPECT_EQ(particles.v.col(1), Eigen::Vector3d(4, 5, 6));
    EXPECT_EQ(particles.d(0), 5e-6);
    EXPECT_EQ(particles.d(1), 8e-6);
    EXPECT_NEAR(particles.m(0), 1.5053464798451093e-13, 1e-26);
    EXPECT_EQ(particles.primaries(0), 1);
    EXPECT_EQ(particles.primaries(1), 3);
}


TEST(listSource, fileIsReadAsTheSameEntries)
{
    const temporaryFile file
    (
        "# two of them\n"
        "x, y, z, d, vx, vy, vz\n"
        "0.0601, 0, 1e-4, 5e-6, 1, 2, 3\n"
        "0.0602, 1e-5, 2e-4, 8e-6, 4, 5, 6\n"
    );

    const auto fromFile = create(file.entries());
    const auto fromEntries = create
    (
        "source list; particles ("
        " { position (0.0601 0 1e-4); diameter 5e-6; velocity (1 2 3); }"
        " { position (0.0602 1e-5 2e-4); diameter 8e-6; velocity (4 5 6); } );"
    );

    EXPECT_EQ(fromFile.x, fromEntries.x);
    EXPECT_EQ(fromFile.v, fromEntries.v);
    EXPECT_TRUE((fromFile.d == fromEntries.d).all());
    EXPECT_TRUE((fromFile.m == fromEntries.m).all());

    const temporaryFile withoutVelocity("x,y,z,d\n0.0601,0,1e-4,5e-6\n");

    EXPECT_TRUE((create(withoutVelocity.entries()).v.array() == 0).all());

    // Aggregates
    const temporaryFile moving
    (
        "x,y,z,d,vx,vy,vz,primaries\n0.0601,0,1e-4,5e-6,1,2,3,12\n"
    );
    EXPECT_EQ(create(moving.entries()).primaries(0), 12);
    EXPECT_EQ(create(moving.entries()).v(2, 0), 3);

    const temporaryFile resting("x,y,z,d,primaries\n0.0601,0,1e-4,5e-6,7\n");
    EXPECT_EQ(create(resting.entries()).primaries(0), 7);
    EXPECT_EQ(create(resting.entries()).v(2, 0), 0);
}


TEST(particleSource, velocityAtTheStart)
{
    const auto followsGas = [](const std::string& text)
    {
        return particleSource::New(entries(text))->followsGas();
    };

    const std::string distribution
    (
        "source distribution; size { type monodisperse; diameter 5e-6; }"
        " count 1; "
    );
    const std::string list
    (
        "source list; particles ({ position (0.0601 0 0); diameter 5e-6; }); "
    );
    const std::string moving
    (
        "source list; particles"
        " ({ position (0.0601 0 0); diameter 5e-6; velocity (0 0 0); }); "
    );

    EXPECT_TRUE(followsGas(distribution));
    EXPECT_TRUE(followsGas(distribution + "initialVelocity gas;"));
    EXPECT_FALSE(followsGas(distribution + "initialVelocity rest;"));

    EXPECT_TRUE(followsGas(list));
    EXPECT_FALSE(followsGas(list + "initialVelocity rest;"));
    EXPECT_FALSE(followsGas(moving));

    expectRefused(moving + "initialVelocity gas;", "initialVelocity");
}


TEST(listSource, overlapsAreRefused)
{
    const auto pair = [](const std::string& x1, const std::string& x2)
    {
        return
            "source list; particles ("
            " { position (0.0605 0 5e-4); diameter 4e-6; }"
            " { position (" + x1 + "); diameter 5e-6; }"
            " { position (" + x2 + "); diameter 8e-6; } );";
    };

    // Touching, apart by a digit, overlapping by a digit
    EXPECT_EQ(complaint(pair("0.0601 0 1e-4", "0.0601065 0 1e-4")), "");
    EXPECT_EQ(complaint(pair("0.0601 0 1e-4", "0.06010651 0 1e-4")), "");

    const std::string overlap(pair("0.0601 0 1e-4", "0.06010649 0 1e-4"));

    expectRefused(overlap, "number 2 of 'particles'");
    expectRefused(overlap, "number 3 of 'particles'");
    expectRefused(overlap, "distance is 6.49e-06");
    expectRefused(overlap, "radii 6.5e-06");

    // Across the border, which only periodic boxes have
    const std::string across(pair("0.060001 0 1e-4", "0.060999 0 1e-4"));
    const testBox closed(vector::uniform(1e-3), Eigen::Array3d::Zero());

    expectRefused(across, "an image of");
    expectRefused(across, "distance is 2e-06");
    EXPECT_EQ(complaint(across, closed), "");

    // An image of itself
    const std::string large
    (
        "source list; particles"
        " ({ position (0.0605 0 5e-4); diameter 1.1e-3; });"
    );

    expectRefused(large, "its own image");
}


TEST(listSource, badEntriesAreRefused)
{
    const auto list = [](const std::string& text)
    {
        return "source list; particles (" + text + ");";
    };

    const std::string ok("{ position (0.0601 0 0); diameter 5e-6; }");

    EXPECT_EQ(complaint(list(ok)), "");

    expectRefused("source list;", "neither");
    expectRefused(list(ok) + "file \"a.csv\";", "both");
    expectRefused(list(""), "empty");
    expectRefused(list("{ diameter 5e-6; }"), "position");
    expectRefused(list("{ position (0.0601 0 0); }"), "diameter");
    expectRefused
    (
        list("{ position (0.0601 0 0); diameter -5e-6; }"),
        "positive"
    );
    expectRefused
    (
        list
        (
            ok
          + "{ position (0.0602 0 0); diameter 5e-6; velocity (0 0 1); }"
        ),
        "1 of the 2 particles"
    );
    expectRefused
    (
        list(ok + "{ position (0 0 0); diameter 5e-6; }"),
        "number 2 of 'particles', is outside"
    );
    for (const std::string primaries : {"0", "1.5", "-3"})
    {
        expectRefused
        (
            list
            (
                "{ position (0.0601 0 0); diameter 5e-6; primaries "
              + primaries + "; }"
            ),
            "number 1 of 'particles' are " + primaries
        );
    }
    expectRefused("source list; file \"/no/such/file\";", "/no/such/file");
}


TEST(listSource, badFilesAreRefusedByLine)
{
    const auto refusal = [](const std::string& text) -> std::string
    {
        const temporaryFile file(text);

        try
        {
            create(file.entries());
        }
        catch (const IOerror& e)
        {
            return
                e.message() + " @" + std::to_string(e.ioStartLineNumber());
        }

        return "accepted";
    };

    const auto expect = [](const std::string& message, const std::string& part)
    {
        EXPECT_NE(message.find(part), std::string::npos) << message;
    };

    const std::string header("x,y,z,d\n");

    expect(refusal("0.0601,0,0,5e-6\n"), "'x,y,z,d' or 'x,y,z,d,vx,vy,vz'");
    expect(refusal(header + "0.0601,0,0\n"), "3 columns instead of 4 @2");
    expect
    (
        refusal(header + "0.0601,0,0,5e-6,1,2,3\n"),
        "7 columns instead of 4 @2"
    );
    expect(refusal(header + "\n0.0601,0,0,-5e-6\n"), "line 3 of");
    expect(refusal(header + "\n0.0601,0,0,0\n"), "must be positive");
    expect(refusal(header + "0.0601,0,0,5e-6\n0,0,0,5e-6\n"), "line 3 of");
    expect
    (
        refusal(header + "0.0601,0,0,5e-6\n0.0601,1e-6,0,5e-6\n"),
        "line 2 of"
    );
}
