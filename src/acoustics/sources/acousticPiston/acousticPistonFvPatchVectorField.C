/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "acousticPistonFvPatchVectorField.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "mathematicalConstants.H"
#include "volFields.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    makePatchTypeField(fvPatchVectorField, acousticPistonFvPatchVectorField);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::acoustics::acousticPistonFvPatchVectorField::count(const scalar t)
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


Foam::scalar Foam::acoustics::acousticPistonFvPatchVectorField::speed
(
    const scalar t
) const
{
    using constant::mathematical::pi;
    using constant::mathematical::twoPi;

    if (t < startTime_)
    {
        return 0;
    }

    const scalar ramp =
        periods_ < rampPeriods_
      ? 0.5*(1 - std::cos(pi*periods_/rampPeriods_))
      : 1;

    scalar amplitude = amplitude_->value(t);
    if (amplitudeIsDisplacement_)
    {
        amplitude *= twoPi*frequency_->value(t);
    }

    // Whole periods are taken off before they cost digits
    const scalar angle = twoPi*(periods_ - std::floor(periods_)) + phase_;

    return ramp*amplitude*std::sin(angle);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::acousticPistonFvPatchVectorField::
acousticPistonFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF),
    amplitudeIsDisplacement_(false),
    phase_(0),
    rampPeriods_(0),
    startTime_(0),
    direction_(Zero),
    periods_(0),
    countedTime_(0)
{}


Foam::acoustics::acousticPistonFvPatchVectorField::
acousticPistonFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict, false),
    amplitudeIsDisplacement_(dict.found("displacementAmplitude")),
    frequency_(Function1<scalar>::New("frequency", dict)),
    phase_(dict.found("phase") ? readFinite(dict, "phase", dimless) : 0),
    rampPeriods_(readNonNegative(dict, "rampPeriods", dimless, 0)),
    startTime_
    (
        dict.found("startTime") ? readFinite(dict, "startTime", dimTime) : 0
    ),
    direction_(Zero),
    periods_(dict.lookupOrDefault<scalar>("periods", 0)),
    countedTime_(dict.lookupOrDefault<scalar>("countedTime", startTime_))
{
    if (amplitudeIsDisplacement_ == dict.found("velocityAmplitude"))
    {
        FatalIOErrorInFunction(dict)
            << "Give exactly one of the entries velocityAmplitude (m/s, peak)"
            << " and displacementAmplitude (m, peak)"
            << exit(FatalIOError);
    }

    amplitude_ = Function1<scalar>::New
    (
        amplitudeIsDisplacement_
      ? "displacementAmplitude"
      : "velocityAmplitude",
        dict
    );

    const scalar now = db().time().timeOutputValue();

    if (frequency_->value(max(now, startTime_)) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "The frequency of the piston is "
            << frequency_->value(max(now, startTime_))
            << " Hz, but it must be positive"
            << exit(FatalIOError);
    }

    if (dict.found("direction"))
    {
        direction_ = readDirection(dict, "direction", Zero);
    }

    fvPatchVectorField::operator=
    (
        dict.found("value")
      ? vectorField("value", dict, p.size())
      : vectorField(p.size(), Zero)
    );
}


Foam::acoustics::acousticPistonFvPatchVectorField::
acousticPistonFvPatchVectorField
(
    const acousticPistonFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(ptf, p, iF, mapper),
    amplitude_(ptf.amplitude_.clone()),
    amplitudeIsDisplacement_(ptf.amplitudeIsDisplacement_),
    frequency_(ptf.frequency_.clone()),
    phase_(ptf.phase_),
    rampPeriods_(ptf.rampPeriods_),
    startTime_(ptf.startTime_),
    direction_(ptf.direction_),
    periods_(ptf.periods_),
    countedTime_(ptf.countedTime_)
{}


Foam::acoustics::acousticPistonFvPatchVectorField::
acousticPistonFvPatchVectorField
(
    const acousticPistonFvPatchVectorField& ptf
)
:
    acousticPistonFvPatchVectorField(ptf, ptf.internalField())
{}


Foam::acoustics::acousticPistonFvPatchVectorField::
acousticPistonFvPatchVectorField
(
    const acousticPistonFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(ptf, iF),
    amplitude_(ptf.amplitude_.clone()),
    amplitudeIsDisplacement_(ptf.amplitudeIsDisplacement_),
    frequency_(ptf.frequency_.clone()),
    phase_(ptf.phase_),
    rampPeriods_(ptf.rampPeriods_),
    startTime_(ptf.startTime_),
    direction_(ptf.direction_),
    periods_(ptf.periods_),
    countedTime_(ptf.countedTime_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::acousticPistonFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    const scalar t = db().time().timeOutputValue();

    count(t);

    if (magSqr(direction_) > 0)
    {
        operator==(vectorField(size(), speed(t)*direction_));
    }
    else
    {
        operator==(-speed(t)*patch().nf());
    }

    fixedValueFvPatchVectorField::updateCoeffs();
}


void Foam::acoustics::acousticPistonFvPatchVectorField::write
(
    Ostream& os
) const
{
    fvPatchVectorField::write(os);

    amplitude_->writeData(os);
    frequency_->writeData(os);
    os.writeEntry("phase", phase_);
    os.writeEntry("rampPeriods", rampPeriods_);
    os.writeEntry("startTime", startTime_);
    if (magSqr(direction_) > 0)
    {
        os.writeEntry("direction", direction_);
    }

    // In full, or the phase would jump at a restart
    const int precision = os.precision
    (
        std::numeric_limits<scalar>::max_digits10
    );
    os.writeEntry("periods", periods_);
    os.writeEntry("countedTime", countedTime_);
    os.precision(precision);

    writeEntry("value", os);
}


// ************************************************************************* //
