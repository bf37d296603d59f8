/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// A cloud on disk: it comes back exactly, and nothing is lost silently.

#include "cloudFiles.H"

#include "IOdictionary.H"
#include "OSspecific.H"
#include "Time.H"
#include "cellModel.H"
#include "passiveParticleCloud.H"
#include "polyMesh.H"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

using namespace Foam;
using namespace Foam::aerosol;

namespace
{

//- A case of n cells in a row, from (0 0 0) to (n 1 1)*length, in a temporary
//  directory
class temporaryCase
{
    fileName dir_;

public:

    std::unique_ptr<Time> runTime;
    std::unique_ptr<polyMesh> mesh;

    explicit temporaryCase
    (
        const word& format = "binary",
        const label precision = 6,
        const label n = 4,
        const scalar length = 0.1
    )
    {
        char name[] = "/tmp/cloudFilesTestXXXXXX";
        dir_ = mkdtemp(name);

        dictionary controlDict;
        controlDict.add("deltaT", 1);
        controlDict.add("endTime", 10);
        controlDict.add("writeInterval", 1);
        controlDict.add("writeFormat", format);
        controlDict.add("writePrecision", precision);

        runTime.reset
        (
            new Time
            (
                controlDict,
                dir_.path(),
                dir_.name(),
                "system",
                "constant",
                false,
                false
            )
        );

        // Point (i j k)*length, i along the row
        const auto vertex = [](label i, label j, label k)
        {
            return 4*i + 2*j + k;
        };

        pointField points(4*(n + 1));
        for (label i = 0; i <= n; ++i)
        {
            for (const label j : {0, 1})
            {
                for (const label k : {0, 1})
                {
                    points[vertex(i, j, k)] = length*vector(i, j, k);
                }
            }
        }

        cellShapeList cells;
        faceList walls;
        for (label i = 0; i < n; ++i)
        {
            cells.append
            (
                cellShape
                (
                    cellModel::ref(cellModel::HEX),
                    labelList
                    ({
                        vertex(i, 0, 0), vertex(i+1, 0, 0),
                        vertex(i+1, 1, 0), vertex(i, 1, 0),
                        vertex(i, 0, 1), vertex(i+1, 0, 1),
                        vertex(i+1, 1, 1), vertex(i, 1, 1)
                    })
                )
            );

            const faceList faces(cells.last().faces());
            for (label facei = i == 0 ? 0 : 1; facei < faces.size(); ++facei)
            {
                // Faces 0 and 1 of a hex are those along the row
                if (facei != 1 || i == n - 1)
                {
                    walls.append(faces[facei]);
                }
            }
        }

        mesh.reset
        (
            new polyMesh
            (
                IOobject
                (
                    polyMesh::defaultRegion,
                    runTime->constant(),
                    *runTime
                ),
                std::move(points),
                cells,
                faceListList(1, walls),
                wordList(1, "walls"),
                wordList(1, "wall"),
                "none",
                "empty",
                wordList()
            )
        );
    }

    ~temporaryCase()
    {
        mesh.reset();
        runTime.reset();
        rmDir(dir_);
    }
};


//- n particles all over the case, with values that need all their digits
particleArrays manyParticles(const int n, const double length = 0.1)
{
    particleArrays p;
    p.resize(n);

    for (int i = 0; i < n; ++i)
    {
        // A quasi-random sequence, never on a face
        const auto r = [i](const double a)
        {
            return std::fmod((i + 1)*a, 1.0);
        };

        p.id(i) = 3*i;
        p.x.col(i) << 4*length*r(0.8191725134), length*r(0.6710436067),
            length*r(0.5497004779);
        p.v.col(i) << 1.0/(i + 3), -M_PI*i, 1e-9/(i + 7);
        p.d(i) = 1e-6*M_E/(i + 1);
        p.m(i) = 1e-18/(3*i + 1);
        p.primaries(i) = 1 + i % 5;
    }

    return p;
}


void expectIdentical(const particleArrays& a, const particleArrays& b)
{
    ASSERT_EQ(a.size(), b.size());
    EXPECT_TRUE((a.id == b.id).all());
    EXPECT_TRUE((a.x.array() == b.x.array()).all());
    EXPECT_TRUE((a.v.array() == b.v.array()).all());
    EXPECT_TRUE((a.d == b.d).all());
    EXPECT_TRUE((a.m == b.m).all());
    EXPECT_TRUE((a.primaries == b.primaries).all());
}


//- What an error says
template<class Action>
std::string errorOf(const Action& action)
{
    try
    {
        action();
    }
    catch (const Foam::error& err)
    {
        return err.message();
    }

    return "";
}


class cloudFilesTest
:
    public testing::TestWithParam<const char*>
{};

} // End anonymous namespace


TEST_P(cloudFilesTest, roundTripIsExact)
{
    temporaryCase c(GetParam(), 16);
    const particleArrays written(manyParticles(100));

    cloudFiles(*c.mesh).write(written, dictionary());

    particleArrays read;
    cloudFiles(*c.mesh).read(read);

    expectIdentical(written, read);
}


TEST_P(cloudFilesTest, readSortsById)
{
    temporaryCase c(GetParam(), 16);
    const particleArrays sorted(manyParticles(10));
    particleArrays reversed(sorted);
    reversed.id.reverseInPlace();
    reversed.x = sorted.x.rowwise().reverse();
    reversed.v = sorted.v.rowwise().reverse();
    reversed.d.reverseInPlace();
    reversed.m.reverseInPlace();
    reversed.primaries.reverseInPlace();

    cloudFiles(*c.mesh).write(reversed, dictionary());

    particleArrays read;
    cloudFiles(*c.mesh).read(read);

    expectIdentical(sorted, read);
}


TEST_P(cloudFilesTest, stateKeepsAllDigits)
{
    temporaryCase c(GetParam(), 6);

    dictionary state;
    state.add("third", 1.0/3);
    state.add("name", word("lognormal"));
    dictionary bins;
    bins.add("max", M_PI);
    state.add("bins", bins);

    cloudFiles(*c.mesh).write(manyParticles(1), state);
    const unsigned int precision = IOstream::defaultPrecision();

    particleArrays p;
    const dictionary read(cloudFiles(*c.mesh).read(p));

    EXPECT_EQ(read.get<scalar>("third"), 1.0/3);
    EXPECT_EQ(read.get<word>("name"), "lognormal");
    EXPECT_EQ(read.subDict("bins").get<scalar>("max"), M_PI);
    EXPECT_EQ(precision, 6u) << "writing must leave the precision as it was";
}


TEST_P(cloudFilesTest, openFOAMSeesTheCloud)
{
    temporaryCase c(GetParam(), 16);
    const particleArrays written(manyParticles(20));
    cloudFiles(*c.mesh).write(written, dictionary());

    const passiveParticleCloud cloud(*c.mesh, "aerosol");

    ASSERT_EQ(cloud.size(), 20);

    label i = 0;
    for (const passiveParticle& p : cloud)
    {
        EXPECT_EQ(p.origId(), written.id(i));
        for (const int cmpt : {0, 1, 2})
        {
            EXPECT_NEAR(p.position()[cmpt], written.x(cmpt, i), 1e-15);
        }
        ++i;
    }
}


INSTANTIATE_TEST_SUITE_P
(
    formats,
    cloudFilesTest,
    testing::Values("ascii", "binary")
);


TEST(cloudFiles, foundOnlyWhereWritten)
{
    temporaryCase c;
    const cloudFiles files(*c.mesh);

    EXPECT_FALSE(files.found());
    files.write(manyParticles(3), dictionary());
    EXPECT_TRUE(files.found());
    ++*c.runTime;
    EXPECT_FALSE(files.found());
}


TEST(cloudFiles, emptyCloud)
{
    temporaryCase c;
    const cloudFiles files(*c.mesh);
    particleArrays none;

    // The files of the earlier cloud must not be taken for those of the empty
    files.write(manyParticles(3), dictionary());
    files.write(none, dictionary());
    EXPECT_TRUE(files.found());

    particleArrays read(manyParticles(3));
    files.read(read);
    EXPECT_EQ(read.size(), 0);
}


TEST(cloudFiles, writesAgainAndAgain)
{
    temporaryCase c;
    const cloudFiles files(*c.mesh);

    for (const int n : {5, 3, 8})
    {
        ++*c.runTime;
        files.write(manyParticles(n), dictionary());
        particleArrays read;
        files.read(read);
        expectIdentical(manyParticles(n), read);

        EXPECT_EQ(passiveParticleCloud(*c.mesh, "aerosol").size(), n);
    }
}


TEST(cloudFiles, leavesTheRegistryAlone)
{
    temporaryCase c;
    const cloudFiles files(*c.mesh);
    const wordList before(c.mesh->sortedNames());
    EXPECT_FALSE(c.mesh->found("aerosol"));

    files.write(manyParticles(3), dictionary());
    particleArrays p;
    files.read(p);

    EXPECT_EQ(before, c.mesh->sortedNames());
}


TEST(cloudFiles, bordersBelongToTheMesh)
{
    temporaryCase c;
    particleArrays p(manyParticles(3));
    p.x.col(0) << 0, 0, 0;            // a corner of the mesh
    p.x.col(1) << 0.2, 0.05, 0.05;    // on a face between cells
    p.x.col(2) << 0.4, 0.1, 0.03;     // on an edge of the mesh

    cloudFiles(*c.mesh).write(p, dictionary());
    particleArrays read;
    cloudFiles(*c.mesh).read(read);

    expectIdentical(p, read);
}


TEST(cloudFiles, particleOutsideTheMesh)
{
    temporaryCase c;
    particleArrays p(manyParticles(10));
    p.x.col(7) << 0.15, 0.1001, 0.05;

    const std::string message
    (
        errorOf([&]{ cloudFiles(*c.mesh).write(p, dictionary()); })
    );

    EXPECT_NE
    (
        message.find("1 of the 10 particles are outside"),
        std::string::npos
    );
    EXPECT_NE
    (
        message.find("id 21, is at (0.15 0.1001 0.05)"),
        std::string::npos
    );
}


TEST(cloudFiles, particleNowhere)
{
    temporaryCase c;
    particleArrays p(manyParticles(2));
    p.x(0, 1) = std::nan("");

    EXPECT_THROW
    (
        cloudFiles(*c.mesh).write(p, dictionary()),
        Foam::error
    );
}


TEST(cloudFiles, idTooLargeForTheFiles)
{
    temporaryCase c;
    particleArrays p(manyParticles(2));
    p.id(1) = std::int64_t(labelMax) + 1;

    EXPECT_THROW
    (
        cloudFiles(*c.mesh).write(p, dictionary()),
        Foam::error
    );
}


TEST(cloudFiles, missingParticles)
{
    temporaryCase c;
    const cloudFiles files(*c.mesh);
    files.write(manyParticles(3), dictionary());
    rmDir(c.runTime->timePath()/"lagrangian");

    particleArrays p;
    const std::string message(errorOf([&]{ files.read(p); }));

    EXPECT_NE(message.find("There were 3 particles"), std::string::npos);
}


TEST(cloudFiles, missingField)
{
    temporaryCase c;
    const cloudFiles files(*c.mesh);
    files.write(manyParticles(3), dictionary());
    rm(c.runTime->timePath()/"lagrangian"/"aerosol"/"mass");

    particleArrays p;
    const std::string message(errorOf([&]{ files.read(p); }));

    EXPECT_NE(message.find("'mass'"), std::string::npos);
}


TEST(cloudFiles, missingState)
{
    temporaryCase c;
    const cloudFiles files(*c.mesh);
    files.write(manyParticles(3), dictionary());
    rm(c.runTime->timePath()/"uniform"/"aerosolState");

    EXPECT_TRUE(files.found());

    particleArrays p;
    const std::string message(errorOf([&]{ files.read(p); }));

    EXPECT_NE(message.find("aerosolState"), std::string::npos);
}


TEST(cloudFiles, doubledParticle)
{
    temporaryCase c;
    particleArrays p(manyParticles(3));
    p.id(2) = p.id(0);
    const cloudFiles files(*c.mesh);
    files.write(p, dictionary());

    const std::string message(errorOf([&]{ files.read(p); }));

    EXPECT_NE(message.find("id 0 is there twice"), std::string::npos);
}


TEST(cloudFiles, refusesTooFewDigits)
{
    EXPECT_NE
    (
        errorOf
        (
            []{ cloudFiles::requireExact(*temporaryCase("ascii", 6).runTime); }
        ).find("writeFormat     binary"),
        std::string::npos
    );
    EXPECT_NO_THROW
    (
        cloudFiles::requireExact(*temporaryCase("ascii", 16).runTime)
    );
    EXPECT_NO_THROW
    (
        cloudFiles::requireExact(*temporaryCase("binary", 6).runTime)
    );
}


// ************************************************************************* //
