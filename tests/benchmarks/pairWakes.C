/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later

    The inner loops by themselves, in Google Benchmark. Particles are spread
    evenly at random in a cube, at the concentration of the other benchmarks.
\*---------------------------------------------------------------------------*/

#include "equationOfMotion.H"
#include "IStringStream.H"
#include "cellGrid.H"

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

using namespace Foam;
using namespace Foam::aerosol;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

constexpr double concentration = 2.4e11;  // [1/m3]
constexpr double speed = 1.5;  // [m/s]

//- Of a wake that knows the sound, or does not ask for it
std::string settings(const std::string& wake)
{
    return
        "type " + wake + "; range 20;"
      + (
            wake == "memory" || wake == "history" ? " frequency 1400;" : ""
        );
}


equationOfMotion laws(const std::string& wake, const std::string& drag)
{
    return equationOfMotion
    (
        dictionary
        (
            IStringStream
            (
                "drag { type " + drag + "; slipCorrection Cunningham; }"
                "gravity { type uniform; value (0 0 -9.81); }"
                "wake { " + settings(wake) + " } aggregate { type none; }"
            )()
        ),
        gasProperties::air(),
        Eigen::Array3d::Constant(GREAT)
    );
}


//- Particles of lognormal sizes, sorted as the time steppings sort them
particleArrays aerosolOf(const int n)
{
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::normal_distribution<double> normal;

    const double edge = std::cbrt(n/concentration);

    particleArrays p;
    p.resize(n);

    for (int i = 0; i < n; ++i)
    {
        p.id(i) = i;
        p.d(i) = 1.5e-6*std::pow(1.8, normal(generator));
        p.m(i) = 2300*EIGEN_PI/6*std::pow(p.d(i), 3);
        p.primaries(i) = 1;

        for (int k = 0; k < 3; ++k)
        {
            p.x(k, i) = edge*uniform(generator);
            p.v(k, i) = speed*(uniform(generator) - 0.5);
        }
    }

    cellGrid::sort(p);

    return p;
}


//- Ordered pairs of particles that have so many neighbours on average
std::vector<particlePair> neighbours(const particleArrays& p, const double n)
{
    const double reach = std::cbrt(n/(concentration*4/3*EIGEN_PI));

    cellGrid grid;
    grid.build(p.x, scalars::Constant(p.size(), reach));

    std::vector<particlePair> pairs;
    grid.acting(p.size(), p.id.cast<double>(), pairs);

    for (particlePair& pair : pairs)
    {
        pair.image = {0, 0, 0};
    }

    return pairs;
}


void perItem(benchmark::State& state, const std::string& what, const double n)
{
    using benchmark::Counter;

    state.counters[what + "/s"] =
        Counter(n, Counter::kIsIterationInvariantRate);
    state.counters["s/" + what] =
        Counter
        (
            n,
            static_cast<Counter::Flags>
            (
                Counter::kIsIterationInvariantRate | Counter::kInvert
            )
        );
}


//- Wakes of n particles with so many neighbours each
void wakes
(
    benchmark::State& state,
    const std::string& type,
    const int n,
    const double nNeighbours
)
{
    const particleArrays p = aerosolOf(n);
    const std::vector<particlePair> pairs = neighbours(p, nNeighbours);
    const equationOfMotion motion = laws(type, "Stokes");
    const wakeInteraction::sources sources{p.x, p.v, p.d, p.range, p.v};
    vectors w;

    for (auto _ : state)
    {
        motion.wakes().sum(sources, pairs, n, w);
        benchmark::DoNotOptimize(w.data());
        benchmark::ClobberMemory();
    }

    perItem(state, "pair", static_cast<double>(pairs.size()));
}


//- The model alone, one block that stays in the cache
void block(benchmark::State& state, const std::string& type)
{
    const particleArrays p = aerosolOf(wake::blockSize + 1);
    const gasProperties gas = gasProperties::air();
    const dictionary dict(IStringStream(settings(type))());
    autoPtr<wake> model = wake::New(dict);
    model->setSound(dict, 0, gas);
    wake::block pairs;

    for (int b = 0; b < wake::blockSize; ++b)
    {
        for (int k = 0; k < 3; ++k)
        {
            pairs.r[k](b) = p.x(k, b) - p.x(k, b + 1);
            pairs.slip[k](b) = p.v(k, b);
            pairs.imaginary[k](b) = p.v(k, b + 1);
            pairs.steady[k](b) = 0;
        }
        pairs.radius(b) = 0.5*p.d(b);
    }

    for (auto _ : state)
    {
        model->evaluate(pairs, gas);
        benchmark::DoNotOptimize(&pairs);
        benchmark::ClobberMemory();
    }

    perItem(state, "pair", wake::blockSize);
}


void move(benchmark::State& state, const std::string& drag, const int n)
{
    particleArrays p = aerosolOf(n);
    const equationOfMotion motion = laws("Oseen", drag);
    motion.laws().refresh(p);

    stepValues gas;
    gas.u0 = vectors::Constant(3, n, speed);
    gas.u1 = vectors::Constant(3, n, -speed);
    stepEnd end;

    for (auto _ : state)
    {
        motion.exact().move(1e-5, p, gas, {}, false, end);
        benchmark::DoNotOptimize(end.x.data());
        benchmark::ClobberMemory();
    }

    perItem(state, "particle", n);
}


//- What a search costs: building the grid, and the pairs, which are as many as
//  the ranges of wakes or the ways of a short step make them
void search(benchmark::State& state, const std::string& what, const int n)
{
    const particleArrays p = aerosolOf(n);
    const scalars id = p.id.cast<double>();
    const scalars reach = what == "acting" ? (20*p.d).eval() : (6*p.d).eval();
    cellGrid grid;
    std::vector<particlePair> pairs;

    if (what != "build")
    {
        grid.build(p.x, reach);
    }

    for (auto _ : state)
    {
        pairs.clear();

        if (what == "build")
        {
            grid.build(p.x, reach);
        }
        else if (what == "acting")
        {
            grid.acting(n, id, pairs);
        }
        else
        {
            grid.touching(n, id, pairs);
        }
        benchmark::ClobberMemory();
    }

    if (what != "build")
    {
        state.counters["pairs"] = static_cast<double>(pairs.size());
    }
    perItem(state, "particle", n);
}


BENCHMARK_CAPTURE(wakes, Oseen/1000/all, "Oseen", 1000, 1e6);
BENCHMARK_CAPTURE(wakes, Oseen/10000/50, "Oseen", 10000, 50);
BENCHMARK_CAPTURE
(
    wakes, ProudmanPearson/1000/all, "ProudmanPearson", 1000, 1e6
);
BENCHMARK_CAPTURE
(
    wakes, ProudmanPearson/10000/50, "ProudmanPearson", 10000, 50
);
BENCHMARK_CAPTURE(wakes, memory/1000/all, "memory", 1000, 1e6);
BENCHMARK_CAPTURE(wakes, memory/10000/50, "memory", 10000, 50);
BENCHMARK_CAPTURE(wakes, history/1000/all, "history", 1000, 1e6);
BENCHMARK_CAPTURE(wakes, history/10000/50, "history", 10000, 50);

BENCHMARK_CAPTURE(block, Oseen, "Oseen");
BENCHMARK_CAPTURE(block, ProudmanPearson, "ProudmanPearson");
BENCHMARK_CAPTURE(block, memory, "memory");
BENCHMARK_CAPTURE(block, history, "history");

BENCHMARK_CAPTURE(move, Stokes/10000, "Stokes", 10000);
BENCHMARK_CAPTURE(move, SchillerNaumann/10000, "SchillerNaumann", 10000);

BENCHMARK_CAPTURE(search, build/10000, "build", 10000);
BENCHMARK_CAPTURE(search, build/100000, "build", 100000);
BENCHMARK_CAPTURE(search, acting/10000, "acting", 10000);
BENCHMARK_CAPTURE(search, acting/100000, "acting", 100000);
BENCHMARK_CAPTURE(search, touching/10000, "touching", 10000);
BENCHMARK_CAPTURE(search, touching/100000, "touching", 100000);

} // End anonymous namespace


BENCHMARK_MAIN();


// ************************************************************************* //
