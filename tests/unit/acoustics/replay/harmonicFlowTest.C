/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// A replayed sound is the sound itself

#include "block.H"
#include "harmonicFlow.H"

#include "error.H"

#include <gtest/gtest.h>

#include <cmath>

using namespace Foam;
using namespace Foam::acoustics;

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr double frequency = 1400;
constexpr double length = 0.1226;


//- A standing wave along x, streaming, and a second harmonic along y
vector exact(const vector& x, const double t)
{
    const double angle = 2*pi*frequency*t;
    const double k = pi/length;

    return vector
    (
        1.5*std::sin(k*x.x())*std::sin(angle + 0.7) + 0.003,
        0.06*std::sin(2*k*x.x())*std::cos(2*angle + 0.4),
        0
    );
}


//- The terms of what is sampled over one period, steps fitting it or not
harmonicFlow::terms solve(const polyMesh& mesh, const double steps)
{
    harmonicSum<vector> sum(frequency, 5);

    for (int i = 0; sum.nPeriods() < 2; ++i)
    {
        const double t = 7/frequency + i/(steps*frequency);
        vectorField U(mesh.nCells());
        forAll(U, celli)
        {
            U[celli] = exact(mesh.cellCentres()[celli], t);
        }
        sum.add(t, U);
    }

    return harmonicFlow::significant(sum, 1e-3);
}

} // End anonymous namespace


TEST(harmonicFlow, isTheStandingWaveThatWasSolved)
{
    const block tube({50, 2, 2}, {length, 0.004, 0.004});

    for (const double steps : {200.0, 187.3})
    {
        harmonicFlow flow(*tube.mesh, frequency, solve(*tube.mesh, steps));

        // As many harmonics as there are
        EXPECT_EQ(flow.nHarmonics(), 2);

        const boundBox region(point(0.055, 0, 0), point(0.065, 0.004, 0.004));
        flow.prepare(region);

        Eigen::Matrix3Xd x(3, 50);
        for (int i = 0; i < 50; ++i)
        {
            x.col(i) << 0.055 + 0.0002*i, 0.00007*i, 0.004 - 0.00007*i;
        }

        // In cells and at points, at any time later, in any order
        double inCells = 0;
        double atPoints = 0;
        for (const double periods : {9.0, 9.25, 9.125, 1234.567, 9.125, 9.0})
        {
            const double t = periods/frequency;

            const vectorField U(flow.inCells(t));
            forAll(U, celli)
            {
                const vector u = exact(tube.mesh->cellCentres()[celli], t);
                inCells = std::max(inCells, mag(U[celli] - u));
            }

            Eigen::Matrix3Xd u;
            flow.velocity(0, t, x, u);
            for (int i = 0; i < x.cols(); ++i)
            {
                const vector there =
                    exact(vector(x(0, i), x(1, i), x(2, i)), t);
                atPoints = std::max
                (
                    atPoints,
                    mag(vector(u(0, i), u(1, i), u(2, i)) - there)
                );
            }
        }

        std::printf
        (
            "%g steps per period: replay off by %.2e in cells, %.2e at points"
            " of the amplitude\n",
            steps, inCells/1.5, atPoints/1.5
        );

        // The sum is exact to rounding if the steps fit; between the nodes
        // 0.5 (pi/400)^2 is lost
        EXPECT_LT(inCells/1.5, steps == 200 ? 1e-9 : 1e-6);
        EXPECT_LT(atPoints/1.5, 6e-5);
    }
}


TEST(harmonicFlow, knowsTheLargestSpeed)
{
    const block tube({50, 2, 2}, {length, 0.004, 0.004});
    const harmonicFlow flow(*tube.mesh, frequency, solve(*tube.mesh, 200));

    EXPECT_GT(flow.largestAmplitude(), 1.5);
    EXPECT_LT(flow.largestAmplitude(), 1.57);
}


TEST(harmonicFlow, flattensTheMean)
{
    const block room({10, 8, 6}, {0.05, 0.03, 0.02});
    const boundBox box(point(0.02, 0.011, 0.004), point(0.023, 0.013, 0.009));

    const tensor A(3, -7, 2, 11, -5, 0.5, -1, 4, 2);
    const vector b(0.1, -0.2, 0.3);
    const auto swing = [](const vector& x)
    {
        return vector(1 - 20*x.y(), 2 + 30*x.z(), -1 + 40*x.x());
    };

    const vectorField& C = room.mesh->cellCentres();
    harmonicFlow::terms terms(3, vectorField(C.size()));

    forAll(C, celli)
    {
        // grad u has the components du_j/dx_i
        terms[0][celli] = b + (C[celli] & A);
        terms[1][celli] = swing(C[celli]);
        terms[2][celli] = -2*swing(C[celli]);
    }

    harmonicFlow flow(*room.mesh, frequency, terms);
    flow.prepare(box);
    flow.prepare(box);

    Eigen::Matrix3Xd x(3, 20);
    for (int i = 0; i < x.cols(); ++i)
    {
        x.col(i) << 0.02 + 0.00015*i, 0.011 + 0.0001*i, 0.009 - 0.00025*i;
    }

    const auto off = [&](const label region, const bool flat)
    {
        const double t = 0.3/frequency;
        const double factor = std::cos(0.6*pi) - 2*std::sin(0.6*pi);

        Eigen::Matrix3Xd u;
        flow.velocity(region, t, x, u);

        double largest = 0;
        for (int i = 0; i < x.cols(); ++i)
        {
            const vector at(x(0, i), x(1, i), x(2, i));
            const vector exact =
                b + ((flat ? box.centre() : at) & A) + factor*swing(at);

            largest = std::max
            (
                largest, mag(vector(u(0, i), u(1, i), u(2, i)) - exact)
            );
        }
        return largest;
    };

    EXPECT_LT(off(1, false), 1e-12);

    const vector middle = b + (box.centre() & A);
    const Eigen::Vector3d mean(middle.x(), middle.y(), middle.z());
    EXPECT_LT((flow.meanInMiddle(1) - mean).norm(), 1e-12);

    const double G = flow.flattenMean(1);

    std::printf
    (
        "mean flow: gradient off by %.1e, velocity by %.1e m/s\n",
        G/mag(A) - 1, off(1, true)
    );

    EXPECT_NEAR(G/mag(A), 1, 1e-10);
    EXPECT_LT(off(1, true), 1e-12);

    // Not elsewhere, and not twice
    EXPECT_LT(off(0, false), 1e-12);
    EXPECT_EQ(flow.flattenMean(1), 0);
}


TEST(harmonicFlow, knowsAMeanWithoutGradient)
{
    const block room({10, 8, 6}, {0.05, 0.03, 0.02});
    const label n = room.mesh->nCells();

    harmonicFlow flow
    (
        *room.mesh, frequency,
        {vectorField(n, vector(5, 1, 0.3)), vectorField(n, vector(1, 0, 0)),
         vectorField(n, Zero)}
    );
    flow.prepare(boundBox(point(0.01, 0.01, 0.01), point(0.02, 0.02, 0.02)));

    EXPECT_EQ(flow.flattenMean(0), 0);
}


TEST(harmonicFlow, namesItsFields)
{
    EXPECT_EQ(harmonicFlow::name(0), "UMean");
    EXPECT_EQ(harmonicFlow::name(1), "UCos1");
    EXPECT_EQ(harmonicFlow::name(2), "USin1");
    EXPECT_EQ(harmonicFlow::name(5), "UCos3");
}


TEST(harmonicFlow, missesFieldsWithAMessage)
{
    const block tube({5, 1, 1}, {length, 0.004, 0.004});
    EXPECT_THROW(harmonicFlow::read(*tube.mesh, "0.1", -1), Foam::error);
}


// ************************************************************************* //
