/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudLog.H"

#include "checkedEntry.H"
#include "communicator.H"
#include "particleArrays.H"
#include "Pstream.H"
#include "stepCounters.H"
#include "Time.H"

#include <algorithm>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Diameter [m] that halves the sum of the k-th powers of all of them
double median(Foam::aerosol::scalars d, const int k)
{
    std::sort(d.begin(), d.end());

    const double half = 0.5*d.pow(k).sum();
    double sum = 0;
    int i = 0;

    for (; i < d.size() - 1 && sum < half; ++i)
    {
        sum += std::pow(d(i), k);
    }

    return d(i > 0 && sum >= half ? i - 1 : i);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::cloudLog::cloudLog(const word& name, const Time& time)
:
    name_(name),
    time_(time),
    patience_
    (
        readNonNegative(time.controlDict(), "reportInterval", dimTime, 5)
    ),
    reported_(clock::now())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::cloudLog::report(const scalar share)
{
    const clock::time_point now = clock::now();

    if
    (
        Pstream::master()
     && std::chrono::duration<scalar>(now - reported_).count() > patience_
    )
    {
        Info<< name_ << ": " << label(100*share)
            << " % of the fluid step to " << time_.timeName() << " s"
            << endl;

        reported_ = now;
    }
}


std::string Foam::aerosol::cloudLog::summary
(
    const particleArrays& particles,
    const scalar volume
)
{
    std::ostringstream os;

    os  << "Aerosol: " << particles.size() << " particles in " << volume
        << " m3, " << particles.size()/volume << " per m3, diameters "
        << particles.d.minCoeff() << " to " << particles.d.maxCoeff()
        << " m, median diameters " << median(particles.d, 0)
        << " m by number and " << median(particles.d, 3)
        << " m by volume, mass concentration " << particles.m.sum()/volume
        << " kg/m3";

    return os.str();
}


std::string Foam::aerosol::cloudLog::effort
(
    const stepCounters& done,
    const scalar fluidStep
)
{
    const scalar n = max(done.fluidSteps, 1.0);
    const scalar moved = communicator::sum(done.particleMoves);
    const scalar members = communicator::sum(done.clusterMembers);

    const scalar perFluid = done.particleSteps/n;

    std::ostringstream os;

    os  << "Steps, on average:\n    fluid     " << fluidStep << " s, "
        << moved/max(done.particleSteps, 1.0) << " particles, "
        << communicator::sum(done.wakePairs)/n << " wakes on particles, "
        << communicator::sum(done.contactPairs)/n << " pairs that may meet";

    if (perFluid > 1)
    {
        os  << "\n    particle  " << fluidStep/perFluid << " s, "
            << moved/max(done.particleSteps, 1.0) << " particles";
    }

    if (done.looksAhead > 0)
    {
        os  << "\n    ahead     " << done.stepsAhead/done.looksAhead
            << " fluid steps at a time, in which "
            << communicator::sum(done.busyMoves)/max(done.stepsAhead, 1.0)
            << " particles were busy";
    }

    if (done.lists > 0)
    {
        os  << "\n    lists     every " << n/done.lists << " fluid steps";
    }

    if (done.collisionSteps > 0)
    {
        os  << "\n    collision " << fluidStep*n/done.collisionSteps << " s, "
            << communicator::sum(done.collisionPairs)
              /max(done.particleSteps, 1.0)
            << " candidate pairs";
    }

    if (members > 0)
    {
        os  << "\n    cluster   " << members/n
            << " particles in clusters, on average "
            << communicator::sum(done.clusterMoves)/members
            << " steps each";
    }

    return os.str();
}


// ************************************************************************* //
