/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "distributionSource.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "communicator.H"
#include "domain.H"
#include "neighbourList.H"

#include <algorithm>
#include <iomanip>
#include <limits>
#include <sstream>
#include <unistd.h>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(distributionSource, 0);
    addToRunTimeSelectionTable(particleSource, distributionSource, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Of the whole run at its largest, per particle and rank, without and with
//  wakes; tests/benchmarks/scaling measures them
constexpr double leastBytes = 600;
constexpr double usualBytes = 1250;

//- Fraction of the mass above the largest particle from which on the log says
//  so, and warns
constexpr double leastLacking = 0.01;
constexpr double muchLacking = 0.2;


//- A vector of one element
template<class Type>
std::vector<Type> single(Type&& one)
{
    std::vector<Type> all;
    all.push_back(std::move(one));

    return all;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

int Foam::aerosol::distributionSource::count
(
    const domain& region,
    const population& all
) const
{
    const dictionary& dict = all.dict;

    const wordList ways({"numberConcentration", "massConcentration", "count"});
    word given;

    for (const word& way : ways)
    {
        if (dict.found(way) && !given.empty())
        {
            FatalIOErrorInFunction(dict)
                << "The number of particles follows from one of " << ways
                << ", but " << dict.name() << " has both '" << given
                << "' and '" << way << "'"
                << exit(FatalIOError);
        }
        if (dict.found(way))
        {
            given = way;
        }
    }

    if (given.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The number of particles follows from one of " << ways
            << ", but " << dict.name() << " has neither of them"
            << exit(FatalIOError);
    }

    const scalar n =
        given == "numberConcentration"
      ? std::round
        (
            region.volume()*readPositive(dict, given, dimless/dimVolume)
        )
      : given == "massConcentration"
      ? std::round
        (
            region.volume()*readPositive(dict, given, dimDensity)
           /(all.density*EIGEN_PI/6*all.size->moment(3))
        )
      : readPositive(dict, given, dimless);

    if (n < 1 || n > std::numeric_limits<int>::max() || n != std::floor(n))
    {
        FatalIOErrorInFunction(dict)
            << "The number of particles in the domain of volume "
            << region.volume() << " m3 is " << n
            << ", but it must be a whole number from 1 to "
            << std::numeric_limits<int>::max() << "; change '" << given
            << "' of " << dict.name()
            << (given == "count" ? "" : " or the size of the domain")
            << exit(FatalIOError);
    }

    return static_cast<int>(n);
}


void Foam::aerosol::distributionSource::requireMemory(const scalar n) const
{
    if (n > std::numeric_limits<int>::max())
    {
        FatalIOErrorInFunction(dict_)
            << "There are " << n << " particles, but there can be "
            << std::numeric_limits<int>::max() << " at most; give "
            << dict_.name() << " fewer, or a smaller domain"
            << exit(FatalIOError);
    }

    // At the start every rank has all particles
    const scalar each = n*communicator::nRanks();
    const scalar memory =
        scalar(sysconf(_SC_PHYS_PAGES))*scalar(sysconf(_SC_PAGESIZE));

    const auto GB = [](const scalar bytes) { return std::ceil(1e-9*bytes); };

    if (each*leastBytes > memory)
    {
        FatalIOErrorInFunction(dict_)
            << label(n) << " particles need at least " << GB(each*leastBytes)
            << " GB of memory, but this computer has "
            << std::floor(1e-9*memory)
            << "; change the concentration or the 'count' of " << dict_.name()
            << " or the size of the domain"
            << exit(FatalIOError);
    }

    if (each*usualBytes > memory)
    {
        WarningInFunction
            << label(n) << " particles with wakes need about "
            << GB(each*usualBytes) << " GB of memory, but this computer has "
            << std::floor(1e-9*memory) << endl;
    }
}


void Foam::aerosol::distributionSource::report
(
    const domain& region,
    const population& all,
    const particleArrays& particles,
    const int begin,
    const int end
)
{
    const sizeDistribution& size = *all.size;

    if (size.max() <= size.min())
    {
        return;
    }

    const scalars d = particles.d.segment(begin, end - begin);
    const scalar n = end - begin;
    const scalar largest = d.maxCoeff();

    const scalar cubes = size.moment(3);
    const scalar lacking = 1 - size.moment(3, largest)/cubes;

    Info<< "The sample of " << all.dict.dictName() << " has "
        << 100*d.cube().sum()/(n*cubes)
        << " % of the mass of its distribution, whose median diameters are "
        << size.quantileOf(0, 0.5) << " m by number and "
        << size.quantileOf(3, 0.5) << " m by volume" << nl;

    if (lacking < leastLacking)
    {
        return;
    }

    // Half of what lacks is in larger ones than this
    const scalar rare = size.quantileOf(3, 1 - 0.5*lacking);
    const scalar oneIn = 1/std::max(1 - size.moment(0, rare), VSMALL);

    std::ostringstream os;

    os  << std::setprecision(2) << 100*lacking
        << " % of the mass of the distribution of "
        << all.dict.dictName().c_str() << " is in particles above the largest"
        << " one drawn, of " << largest << " m; one of " << rare
        << " m or more needs " << oneIn << " particles, the domain has "
        << std::setprecision(6) << n;

    if (lacking > muchLacking)
    {
        IOWarningInFunction(all.dict)
            << os.str().c_str() << ": what the coarse ones would collect is"
            << " not computed. Take a larger domain, or a 'max' that says"
            << " where the distribution ends" << endl;
    }
    else
    {
        Info<< os.str().c_str() << nl;
    }
}


void Foam::aerosol::distributionSource::place
(
    const domain& region,
    const label attempt,
    const int i,
    particleArrays& particles
) const
{
    const auto u = random_.uniforms
    (
        particles.id(i),
        attempt,
        counterRandom::stream::position
    );

    for (int k = 0; k < 3; ++k)
    {
        const scalar margin = region.period()[k] > 0 ? 0 : 0.5*particles.d(i);

        const scalar lower = region.bounds().min()[k] + margin;
        const scalar upper = region.bounds().max()[k] - margin;

        particles.x(k, i) = lower + u[k]*(upper - lower);
    }
}


std::vector<int> Foam::aerosol::distributionSource::inTheWay
(
    const domain& region,
    const particleArrays& particles
)
{
    const std::vector<particlePair> pairs =
        neighbourList::touching(region, particles.x, 0.5*particles.d);

    std::vector<int> indices;

    for (const particlePair& pair : pairs)
    {
        const auto [early, late] = std::minmax(pair.i, pair.j);

        indices.push_back
        (
            particles.d(late) > particles.d(early) ? early : late
        );
    }

    std::sort(indices.begin(), indices.end());
    indices.erase(std::unique(indices.begin(), indices.end()), indices.end());

    return indices;
}


Foam::aerosol::distributionSource::population
Foam::aerosol::distributionSource::read
(
    const dictionary& dict,
    const scalar density,
    const wordList& besides
)
{
    wordList valid
    ({
        "density", "size", "numberConcentration", "massConcentration", "count",
        "sample"
    });
    valid.append(besides);

    requireOnly(dict, valid);

    const word sample(valueOr<word>(dict, "sample", "random"));

    if (sample != "random" && sample != "stratified")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'sample' of " << dict.name() << " is '"
            << visible(sample).c_str()
            << "', but it must be random or stratified"
            << exit(FatalIOError);
    }

    return
    {
        dict,
        dict.found("density") || density < 0
      ? readPositive(dict, "density", dimDensity)
      : density,
        sizeDistribution::New(dict.subDict("size")),
        sample == "stratified"
    };
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::distributionSource::distributionSource(const dictionary& dict)
:
    particleSource(dict),
    populations_
    (
        single(read(dict, density_, {"source", "initialVelocity", "seed"}))
    ),
    random_(readSeed(dict))
{}


Foam::aerosol::distributionSource::distributionSource
(
    const dictionary& dict,
    const scalar density,
    std::vector<population>&& populations
)
:
    particleSource(dict, density),
    populations_(std::move(populations)),
    random_(readSeed(dict))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::distributionSource::create
(
    const domain& region,
    particleArrays& particles
) const
{
    // Where each population ends
    std::vector<int> ends;
    scalar total = 0;

    for (const population& all : populations_)
    {
        total += count(region, all);
        requireMemory(total);
        ends.push_back(static_cast<int>(total));
    }

    const int n = ends.back();

    const vector span(region.bounds().span());

    if (region.volume() < (1 - 1e-9)*region.bounds().volume())
    {
        FatalIOErrorInFunction(dict_)
            << "Source distribution fills cuboids only, but the domain fills "
            << region.volume()/region.bounds().volume()
            << " of the smallest box that holds it; give the particles as a"
            << " list"
            << exit(FatalIOError);
    }

    for (const population& all : populations_)
    {
        if (all.size->max() > cmptMin(span))
        {
            FatalIOErrorInFunction(all.dict)
                << "The largest particles, of diameter " << all.size->max()
                << " m, do not fit into the domain, whose edges are " << span
                << " m; the diameters in " << all.dict.name()
                << " are in metres"
                << exit(FatalIOError);
        }
    }

    start(particles, n);

    int begin = 0;

    for (std::size_t k = 0; k < populations_.size(); ++k)
    {
        const population& all = populations_[k];
        const int end = ends[k];

        for (int i = begin; i < end; ++i)
        {
            const scalar u =
                random_.uniforms(i, 0, counterRandom::stream::size)[0];

            particles.d(i) = all.size->quantile
            (
                all.stratified ? (i - begin + u)/(end - begin) : u
            );
            particles.m(i) = all.density*particles.volume(i);
        }

        report(region, all, particles, begin, end);

        begin = end;
    }

    const scalar fraction =
        EIGEN_PI/6*particles.d.cube().sum()/region.volume();

    if (fraction > 0.1)
    {
        FatalIOErrorInFunction(dict_)
            << "The " << n << " particles fill " << 100*fraction
            << " % of the domain, but an aerosol has no more than 10 %; give "
            << dict_.name() << " fewer or smaller particles"
            << exit(FatalIOError);
    }

    for (int i = 0; i < n; ++i)
    {
        place(region, 0, i, particles);
    }

    const label maxAttempts = 1000;

    for (label attempt = 1; ; ++attempt)
    {
        const std::vector<int> again(inTheWay(region, particles));

        if (again.empty())
        {
            return;
        }

        if (attempt == maxAttempts)
        {
            FatalIOErrorInFunction(dict_)
                << "Found no place for " << again.size() << " of " << n
                << " particles in " << maxAttempts
                << " attempts: the domain, whose edges are " << span
                << " m, is too narrow for so many; give " << dict_.name()
                << " fewer or smaller particles, or a larger domain"
                << exit(FatalIOError);
        }

        for (const int i : again)
        {
            place(region, attempt, i, particles);
        }
    }
}


// ************************************************************************* //
