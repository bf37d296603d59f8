/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "BassetDrag.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "meanDecay.H"
#include "Tuple2.H"

#include <Eigen/QR>

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(BassetDrag, 0);
    addToRunTimeSelectionTable(unsteadyDrag, BassetDrag, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using phasor = std::complex<double>;
using Foam::aerosol::scalars;

//- By default, in frequencies of the sound
constexpr double lowest = 0.1;
constexpr double highest = 20;

//- A narrower range needs no less, and its terms would cancel one another
constexpr double narrowest = 10;

//- The shortest and the longest time, in periods over 2 pi of the highest and
//  the lowest frequency: those beyond have a share that the others can take
constexpr double shortestTime = 0.5;
constexpr double longestTime = 13;

//- From one time to the next, at most: for 0.5 % of the kernel
constexpr double logRatio = 1.3;


//- exp(-z) and its mean E over the step for all times
struct decay
{
    double h;
    scalars whole;
    scalars mean;

    decay(const double step, const scalars& times)
    :
        h(step),
        whole((-step/times).exp()),
        mean(times.size())
    {
        for (int j = 0; j < times.size(); ++j)
        {
            mean(j) = Foam::meanDecay(h/times(j));
        }
    }
};

using Foam::acoustics::gasProperties;
using Foam::aerosol::particleArrays;

//- Strength of the history force of particle i, over its mass [1/s^0.5]
double history(const gasProperties& gas, const particleArrays& p, const int i)
{
    const double outer = p.mobilityDiameter(i);

    return 1.5*std::sqrt(EIGEN_PI*gas.rho*gas.mu)*outer*outer/p.m(i);
}

//- Mass of the displaced gas, over that of particle i
double displacedMass
(
    const gasProperties& gas,
    const particleArrays& p,
    const int i
)
{
    return gas.rho*p.volume(i)/p.m(i);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::BassetDrag::BassetDrag
(
    const dictionary& dict,
    const scalar frequency
)
{
    requireOnly(dict, {"type", "frequencies"});

    if (!dict.found("frequencies") && frequency <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "The sound has no frequency. Give two, in Hz, between which the"
            << " history of the slip is to be exact, such as"
            << " 'frequencies (10 10000)'"
            << exit(FatalIOError);
    }

    const Tuple2<scalar, scalar> range =
        dict.getOrDefault<Tuple2<scalar, scalar>>
        (
            "frequencies", {lowest*frequency, highest*frequency}
        );

    if
    (
        !(range.first() > 0)
     || !(range.second() >= narrowest*range.first())
     || !(range.second() < GREAT)
    )
    {
        FatalIOErrorInFunction(dict)
            << "'frequencies' are " << range << ", but must be two numbers"
            << " above zero, in Hz, the second of them at least "
            << narrowest << " times the first"
            << exit(FatalIOError);
    }

    const double low = 2*EIGEN_PI*range.first();
    const double high = 2*EIGEN_PI*range.second();
    const double shortest = shortestTime/high;
    const double span = std::log(longestTime/low/shortest);
    const int n = 1 + static_cast<int>(std::ceil(span/logRatio));

    times_ = shortest*scalars::LinSpaced(n, 0, span).exp();

    // In units that make the unknowns alike, and of the kernel at each
    // frequency; real parts, then imaginary ones
    const int nFrequencies = 40*n;
    Eigen::MatrixXd terms(2*nFrequencies, n + 1);
    Eigen::VectorXd wanted(2*nFrequencies);

    for (int k = 0; k < nFrequencies; ++k)
    {
        const phasor s(0, low*std::pow(high/low, k/(nFrequencies - 1.0)));
        const phasor kernel = std::sqrt(double(EIGEN_PI)/s);

        for (int j = 0; j <= n; ++j)
        {
            const phasor term =
            (
                j < n ? std::sqrt(times_(j))/(1.0 + s*times_(j))
              : phasor(std::sqrt(1/high))
            )/kernel;

            terms(k, j) = term.real();
            terms(nFrequencies + k, j) = term.imag();
        }

        wanted(k) = 1;
        wanted(nFrequencies + k) = 0;
    }

    const Eigen::VectorXd found = terms.colPivHouseholderQr().solve(wanted);

    amplitudes_ = found.head(n).array()/times_.sqrt();
    pulse_ = found(n)/std::sqrt(high);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::complex<double> Foam::aerosol::BassetDrag::transform
(
    const scalar omega
) const
{
    phasor sum = pulse_;

    for (int j = 0; j < times_.size(); ++j)
    {
        sum += amplitudes_(j)*times_(j)/phasor(1, omega*times_(j));
    }

    return sum;
}


Foam::aerosol::unsteadyDrag::phasors Foam::aerosol::BassetDrag::periodic
(
    const scalar omega,
    const acoustics::gasProperties& gas,
    const particleArrays& p,
    const int i
) const
{
    const double displaced = displacedMass(gas, p, i);

    return {history(gas, p, i)*transform(omega) + 0.5*displaced, displaced};
}


void Foam::aerosol::BassetDrag::begin
(
    const scalar h,
    const vectors& U0,
    const vectors& du,
    const acoustics::gasProperties& gas,
    const int first,
    particleArrays& particles,
    vectors& p,
    scalars& q
) const
{
    const int n = static_cast<int>(U0.cols());
    const int nTimes = static_cast<int>(times_.size());

    const decay now(h, times_);
    decay last = now;

    // Of the mean over the step, what is left and what is added
    const scalars left = amplitudes_*now.mean;
    const double added =
        (pulse_ + (amplitudes_*times_*(1 - now.mean)).sum())/h;

    p.resize(3, n);
    q.resize(n);

    for (int i = 0; i < n; ++i)
    {
        double* const past =
            particles.history.data() + particles.history.rows()*(first + i);

        // Also of none, for new particles
        if (past[0] != last.h)
        {
            last = decay(past[0], times_);
        }

        const double b = history(gas, particles, first + i);
        const double displaced = displacedMass(gas, particles, first + i);

        Eigen::Map<Eigen::Vector3d> slip(past + 1);
        Eigen::Map<Eigen::Matrix3Xd> y(past + 4, 3, nTimes);

        const Eigen::Vector3d change = U0.col(i) - slip;
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();

        for (int j = 0; j < nTimes; ++j)
        {
            y.col(j) = last.whole(j)*y.col(j) + last.mean(j)*change;
            sum += left(j)*y.col(j);
        }

        past[0] = h;
        slip = U0.col(i);
        p.col(i) = b*sum + displaced/h*du.col(i);

        q(i) = b*added + 0.5*displaced/h;
    }
}


// ************************************************************************* //
