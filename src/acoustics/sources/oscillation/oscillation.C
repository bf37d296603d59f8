/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "oscillation.H"

#include "checkedDictionary.H"
#include "mathematicalConstants.H"
#include "wordList.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- A function of time, and nothing after it
Foam::autoPtr<Foam::Function1<Foam::scalar>> readFunction
(
    const Foam::dictionary& dict,
    const Foam::word& key
)
{
    auto function = Foam::Function1<Foam::scalar>::New(key, dict);

    Foam::requireAllRead(dict, key);

    return function;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::acoustics::oscillation::count(const scalar t)
{
    const scalar t0 = max(countedTime_, startTime_);

    if (t > t0)
    {
        // Simpson's rule: not every Function1 knows its integral
        periods_ +=
            (t - t0)/6
           *(
                frequency_->value(t0)
              + 4*frequency_->value(0.5*(t0 + t))
              + frequency_->value(t)
            );
    }

    countedTime_ = t;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::oscillation::oscillation()
:
    differentiate_(false),
    phase_(0),
    rampPeriods_(0),
    startTime_(0),
    periods_(0),
    countedTime_(0)
{}


Foam::acoustics::oscillation::oscillation
(
    const dictionary& dict,
    const word& amplitudeName,
    const scalar now,
    const bool differentiate
)
:
    amplitude_(readFunction(dict, amplitudeName)),
    frequency_(readFunction(dict, "frequency")),
    differentiate_(differentiate),
    phase_(dict.found("phase") ? readFinite(dict, "phase", dimless) : 0),
    rampPeriods_(readNonNegative(dict, "rampPeriods", dimless, 0)),
    startTime_
    (
        dict.found("startTime") ? readFinite(dict, "startTime", dimTime) : 0
    ),
    periods_(dict.found("periods") ? readFinite(dict, "periods", dimless) : 0),
    countedTime_
    (
        dict.found("countedTime")
      ? readFinite(dict, "countedTime", dimTime)
      : startTime_
    )
{
    const scalar f = frequency(now);

    // Not true for a number that is none
    if (!(f > 0 && f < GREAT))
    {
        FatalIOErrorInFunction(dict)
            << "The frequency of the source is " << f
            << " Hz, but it must be positive"
            << exit(FatalIOError);
    }
}


Foam::acoustics::oscillation::oscillation(const oscillation& other)
:
    amplitude_(other.amplitude_.clone()),
    frequency_(other.frequency_.clone()),
    differentiate_(other.differentiate_),
    phase_(other.phase_),
    rampPeriods_(other.rampPeriods_),
    startTime_(other.startTime_),
    periods_(other.periods_),
    countedTime_(other.countedTime_)
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::wordList Foam::acoustics::oscillation::entries(const word& amplitudeName)
{
    return
    {
        amplitudeName, amplitudeName + "Coeffs", "frequency",
        "frequencyCoeffs", "phase", "rampPeriods", "startTime", "periods",
        "countedTime"
    };
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::oscillation::frequency(const scalar t) const
{
    return frequency_->value(max(t, startTime_));
}


Foam::scalar Foam::acoustics::oscillation::amplitude(const scalar t) const
{
    const scalar amplitude = amplitude_->value(max(t, startTime_));

    return
        differentiate_
      ? constant::mathematical::twoPi*frequency(t)*amplitude
      : amplitude;
}


Foam::scalar Foam::acoustics::oscillation::value(const scalar t)
{
    using constant::mathematical::pi;
    using constant::mathematical::twoPi;

    count(t);

    if (t < startTime_)
    {
        return 0;
    }

    const scalar ramp =
        periods_ < rampPeriods_
      ? 0.5*(1 - std::cos(pi*periods_/rampPeriods_))
      : 1;

    // Whole periods are taken off before they cost digits
    const scalar angle = twoPi*(periods_ - std::floor(periods_)) + phase_;

    return ramp*amplitude(t)*std::sin(angle);
}


void Foam::acoustics::oscillation::write(Ostream& os) const
{
    // In full, or the sound would jump at a restart
    const int precision = os.precision
    (
        std::numeric_limits<scalar>::max_digits10
    );
    amplitude_->writeData(os);
    frequency_->writeData(os);
    os.writeEntry("phase", phase_);
    os.writeEntry("rampPeriods", rampPeriods_);
    os.writeEntry("startTime", startTime_);
    os.writeEntry("periods", periods_);
    os.writeEntry("countedTime", countedTime_);
    os.precision(precision);
}


// ************************************************************************* //
