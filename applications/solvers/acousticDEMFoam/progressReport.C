/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "progressReport.H"
#include "checkedEntry.H"
#include "FixedList.H"
#include "foamVersion.H"
#include "Pstream.H"
#include "Time.H"

#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Years, hours, minutes or seconds, whichever reads well
std::string duration(const Foam::scalar seconds)
{
    constexpr Foam::scalar year = 365.25*86400;

    if (seconds > year)
    {
        std::ostringstream os;
        os.precision(3);
        os  << seconds/year << " years";

        return os.str();
    }

    const long s = std::lround(seconds);

    if (s < 100)
    {
        return std::to_string(s) + " s";
    }
    if (s < 6000)
    {
        return std::to_string(s/60) + " min " + std::to_string(s%60) + " s";
    }
    return std::to_string(s/3600) + " h " + std::to_string(s/60%60) + " min";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::progressReport::progressReport(const Time& time)
:
    time_(time),
    interval_
    (
        readNonNegative(time.controlDict(), "reportInterval", dimTime, 5)
    ),
    lastClock_(time.elapsedClockTime()),
    lastStep_(time.timeIndex()),
    looked_(clock::now()),
    every_(1),
    nextLook_(time.timeIndex())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::progressReport::due()
{
    if (time_.value() > time_.endTime().value() - 0.5*time_.deltaTValue())
    {
        return true;
    }
    if (time_.timeIndex() < nextLook_)
    {
        return false;
    }

    const clock::time_point now = clock::now();
    const scalar seconds =
        std::chrono::duration<scalar>(now - looked_).count();

    looked_ = now;

    // The clocks of the ranks differ: the first one decides, for all steps up
    // to the next look
    FixedList<label, 2> decision;
    decision[0] = time_.elapsedClockTime() >= lastClock_ + interval_;
    decision[1] = static_cast<label>
    (
        min(max(lookShare*interval_*every_/max(seconds, SMALL), 1), mostSteps)
    );
    broadcast(decision);

    every_ = decision[1];
    nextLook_ = time_.timeIndex() + every_;

    return decision[0];
}


std::string Foam::progressReport::activity() const
{
    return
        "computing the step to time " + time_.timeName() + " s, of which "
      + time_.systemPath()/"controlDict" + " and the files in "
      + time_.constantPath() + " are the input";
}


void Foam::progressReport::print(const std::string& model)
{
    const scalar clock = time_.elapsedClockTime();
    const scalar rate =
        (time_.timeIndex() - lastStep_)/max(clock - lastClock_, scalar(1e-3));
    const scalar stepsLeft =
        (time_.endTime().value() - time_.value())/time_.deltaTValue();

    // OpenFOAM's clock counts whole seconds
    std::ostringstream speed;
    if (clock > lastClock_)
    {
        speed.precision(3);
        speed
            << rate << " steps/s, "
            << duration(max(stepsLeft, scalar(0))/max(rate, SMALL))
            << " to the end";
    }

    Info<< "Time = " << time_.timeName() << nl;

    for (const std::string& line : {model, speed.str()})
    {
        if (!line.empty())
        {
            Info<< "    " << line.c_str() << nl;
        }
    }

    Info<< "ExecutionTime = " << time_.elapsedCpuTime() << " s"
        << "  ClockTime = " << clock << " s" << nl << endl;

    lastClock_ = clock;
    lastStep_ = time_.timeIndex();
}


// ************************************************************************* //
