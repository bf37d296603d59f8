/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "distributionSource.H"
#include "addToRunTimeSelectionTable.H"
#include "communicator.H"
#include "checkedEntry.H"
#include "domain.H"
#include "neighbourList.H"

#include <algorithm>
#include <limits>
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

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

int Foam::aerosol::distributionSource::count(const domain& region) const
{
    const bool byConcentration = dict_.found("numberConcentration");

    if (byConcentration == dict_.found("count"))
    {
        FatalIOErrorInFunction(dict_)
            << "Source distribution needs either 'numberConcentration' or"
            << " 'count', but " << dict_.name() << " has "
            << (byConcentration ? "both" : "neither")
            << exit(FatalIOError);
    }

    const scalar n =
        byConcentration
      ? std::round
        (
            region.volume()
           *readPositive(dict_, "numberConcentration", dimless/dimVolume)
        )
      : readPositive(dict_, "count", dimless);

    if (n < 1 || n > std::numeric_limits<int>::max() || n != std::floor(n))
    {
        FatalIOErrorInFunction(dict_)
            << "The number of particles in the domain of volume "
            << region.volume() << " m3 is " << n
            << ", but it must be a whole number from 1 to "
            << std::numeric_limits<int>::max() << "; change '"
            << (byConcentration ? "numberConcentration" : "count")
            << "' of " << dict_.name()
            << (byConcentration ? " or the size of the domain" : "")
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
            << "; change '"
            << (byConcentration ? "numberConcentration" : "count")
            << "' of " << dict_.name() << " or the size of the domain"
            << exit(FatalIOError);
    }

    if (each*usualBytes > memory)
    {
        WarningInFunction
            << label(n) << " particles with wakes need about "
            << GB(each*usualBytes) << " GB of memory, but this computer has "
            << std::floor(1e-9*memory) << endl;
    }

    return static_cast<int>(n);
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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::distributionSource::distributionSource(const dictionary& dict)
:
    particleSource(dict),
    size_(sizeDistribution::New(dict.subDict("size"))),
    random_(readSeed(dict))
{
    requireOnly
    (
        dict,
        {"density", "source", "initialVelocity", "size",
         "numberConcentration", "count", "seed"}
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::distributionSource::create
(
    const domain& region,
    particleArrays& particles
) const
{
    const int n = count(region);

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

    if (size_->max() > cmptMin(span))
    {
        FatalIOErrorInFunction(dict_)
            << "The largest particles, of diameter " << size_->max()
            << " m, do not fit into the domain, whose edges are " << span
            << " m; the diameters in " << dict_.name() << " are in metres"
            << exit(FatalIOError);
    }

    start(particles, n);

    for (int i = 0; i < n; ++i)
    {
        particles.d(i) = size_->quantile
        (
            random_.uniforms(i, 0, counterRandom::stream::size)[0]
        );
    }

    setMasses(particles);

    const scalar fraction = particles.m.sum()/(density_*region.volume());

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
