/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "levelControl.H"

#include "acousticPistonFvPatchVectorField.H"
#include "acousticPressureFvPatchScalarField.H"
#include "checkedDictionary.H"
#include "foamVersion.H"
#include "mathematicalConstants.H"
#include "soundLevel.H"
#include "soundSources.H"
#include "volFields.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(levelControl, 0);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Periods from which the response is found
constexpr size_t nRemembered = 4;


const Foam::fvPatchVectorField& velocityAt
(
    const Foam::fvMesh& mesh,
    const Foam::label patchi
)
{
    return
        mesh.lookupObject<Foam::volVectorField>("U").boundaryField()[patchi];
}


const Foam::fvPatchScalarField& pressureAt
(
    const Foam::fvMesh& mesh,
    const Foam::label patchi
)
{
    return
        mesh.lookupObject<Foam::volScalarField>("p").boundaryField()[patchi];
}


bool hasPiston(const Foam::fvMesh& mesh, const Foam::label patchi)
{
    return Foam::isA<Foam::acoustics::acousticPistonFvPatchVectorField>
    (
        velocityAt(mesh, patchi)
    );
}


bool hasSource(const Foam::fvMesh& mesh, const Foam::label patchi)
{
    return
        hasPiston(mesh, patchi)
     || Foam::isA<Foam::acoustics::acousticPressureFvPatchScalarField>
        (
            pressureAt(mesh, patchi)
        );
}


Foam::scalar degrees(const Foam::scalar radians)
{
    return radians*180/Foam::constant::mathematical::pi;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::wordList Foam::acoustics::levelControl::sources
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    DynamicList<word> all;
    forAll(mesh.boundary(), patchi)
    {
        if (hasSource(mesh, patchi))
        {
            all.append(mesh.boundary()[patchi].name());
        }
    }

    const wordList patches =
        valueOr<wordList>(dict, "patches", wordList(all));

    for (const word& name : patches)
    {
        if (!all.found(name))
        {
            FatalIOErrorInFunction(dict)
                << "The patch " << name << " has no source to control: no"
                << " acousticPiston for U and no acousticPressure for p."
                << nl << "Patches with sources are " << all
                << exit(FatalIOError);
        }
    }

    if (patches.empty())
    {
        FatalIOErrorInFunction(dict)
            << "There is no source to control: no patch has an acousticPiston"
            << " for U or an acousticPressure for p"
            << exit(FatalIOError);
    }

    return patches;
}


bool Foam::acoustics::levelControl::drivesVelocity() const
{
    return hasPiston(mesh_, mesh_.boundary().findPatchID(patches_[0]));
}


Foam::scalar Foam::acoustics::levelControl::drive() const
{
    const label patchi = mesh_.boundary().findPatchID(patches_[0]);
    const scalarField& area = mesh_.boundary()[patchi].magSf();

    // With the sign of the first source: it is the phase's reference
    const scalar sum =
        drivesVelocity()
      ? -gSum
        (
            velocityAt(mesh_, patchi) & mesh_.boundary()[patchi].Sf()
        )
      : gSum((pressureAt(mesh_, patchi) - reference_)*area);

    return sum/gSum(area);
}


void Foam::acoustics::levelControl::checkReach
(
    const scalar response,
    const largestValue& loudest,
    const scalar wantedDrive
) const
{
    const scalar wantedMost = target_*std::sqrt(2.0)*loudest.value/response;

    if (response < 0.02*loudest.value)
    {
        FatalErrorInFunction
            << "The point " << point_->position() << " lies in a node of the"
            << " pressure: the amplitude there is "
            << 100*response/loudest.value << " % of that at " << loudest.place
            << "." << nl << soundLevel::SPL(target_) << " dB at the node"
            << " would be " << soundLevel::SPL(wantedMost/std::sqrt(2.0))
            << " dB there. Choose another point for the level control, or the"
            << " maximum" << exit(FatalError);
    }

    if (wantedMost > 0.5*reference_)
    {
        FatalErrorInFunction
            << "A level of " << soundLevel::SPL(target_) << " dB is out of"
            << " reach: it would need an amplitude of " << wantedMost
            << " Pa at " << loudest.place << ", at a mean pressure of "
            << reference_ << " Pa. Lower the SPL of the sound, or choose a"
            << " place for the level control that is nearer to a maximum"
            << exit(FatalError);
    }

    if (wantedDrive > (drivesVelocity() ? 0.3*soundSpeed_ : reference_))
    {
        FatalErrorInFunction
            << "A level of " << soundLevel::SPL(target_) << " dB is out of"
            << " reach: the source at " << patches_[0] << " would need an"
            << " amplitude of " << wantedDrive
            << (drivesVelocity() ? " m/s" : " Pa") << "." << nl
            << "The source hardly reaches the place of the level control at "
            << frequency_ << " Hz: the frequency is far from a resonance, or"
            << " the sources cancel each other, or they are at nodes"
            << exit(FatalError);
    }
}


void Foam::acoustics::levelControl::control()
{
    // Complex amplitudes A of Re[A exp(iwt)]
    period now;
    now.drive = complex(drive_.cosine(1)[0], -drive_.sine(1)[0]);
    now.p.resize(mesh_.nCells());

    scalarField pAmp(mesh_.nCells());
    forAll(pAmp, celli)
    {
        now.p[celli] = complex(p_.cosine(1)[celli], -p_.sine(1)[celli]);
        pAmp[celli] = std::abs(now.p[celli]);
    }

    const largestValue loudest(mesh_, pAmp);


    // Change since the last period

    scalar change = 1;
    {
        scalar difference = 0;
        scalar all = 0;
        forAll(pAmp, celli)
        {
            const scalar V = mesh_.V()[celli];
            all += V*std::norm(now.p[celli]);
            if (!periods_.empty())
            {
                difference +=
                    V*std::norm(now.p[celli] - periods_.back().p[celli]);
            }
        }
        reduce(difference, sumOp<scalar>());
        reduce(all, sumOp<scalar>());
        if (!periods_.empty())
        {
            change = std::sqrt(difference/max(all, VSMALL));
        }
    }

    periods_.push_back(now);
    if (periods_.size() > nRemembered)
    {
        periods_.pop_front();
    }


    // The response at the place in the last periods, and the level

    std::vector<complex> response(periods_.size());
    std::vector<complex> drive(periods_.size());
    scalar pRms = 0;

    const scalarField meanSquare(pSquared_.mean() - sqr(p_.mean()));

    if (point_)
    {
        vectorField values(mesh_.nCells(), Zero);

        for (size_t j = 0; j < periods_.size(); ++j)
        {
            forAll(values, celli)
            {
                values[celli].x() = periods_[j].p[celli].real();
                values[celli].y() = periods_[j].p[celli].imag();
                values[celli].z() = meanSquare[celli];
            }
            const vector there = point_->interpolate(values);
            response[j] = complex(there.x(), there.y());
            pRms = std::sqrt(max(there.z(), scalar(0)));
        }
    }
    else
    {
        scalarField values(2*periods_.size() + 1, Zero);
        if (loudest.cell >= 0)
        {
            for (size_t j = 0; j < periods_.size(); ++j)
            {
                values[2*j] = periods_[j].p[loudest.cell].real();
                values[2*j + 1] = periods_[j].p[loudest.cell].imag();
            }
            values.last() = std::sqrt(max(meanSquare[loudest.cell], scalar(0)));
        }
        combineToAll(values, plusEqOp<scalar>());

        for (size_t j = 0; j < periods_.size(); ++j)
        {
            response[j] = complex(values[2*j], values[2*j + 1]);
        }
        pRms = values.last();
    }

    for (size_t j = 0; j < periods_.size(); ++j)
    {
        drive[j] = periods_[j].drive;
    }

    // What is to be done

    const scalar target = soundLevel::SPL(target_);
    const scalar level = soundLevel::SPL(pRms);
    const scalar error = level - target;

    const complex lastUnit = driveOfUnit_;
    driveOfUnit_ = complex(drive_.cosine(1)[1], -drive_.sine(1)[1]);

    const scalar unit = std::abs(driveOfUnit_);
    const bool starting =
        unit < VSMALL || std::abs(driveOfUnit_ - lastUnit) > 2e-3*unit;
    nStarted_ = starting ? 0 : nStarted_ + 1;

    // Before the sound arrives there is but rounding
    const bool silent = level < 0;

    Info<< "Level, period " << label(std::lround(p_.end()*frequency_)) << ": ";

    if (silent)
    {
        Info<< "below 0";
    }
    else
    {
        Info<< level;
    }

    Info<< " dB at " << (point_ ? point_->position() : loudest.place)
        << ", drive " << std::abs(now.drive)
        << (drivesVelocity() ? " m/s" : " Pa");

    if (!silent)
    {
        if (unit > VSMALL)
        {
            Info<< ", phase "
                << degrees(std::arg(response.back()*std::conj(driveOfUnit_)))
                << " deg";
        }

        Info<< ", change " << 100*change << " %";
    }

    if (starting || nStarted_ < crossing_ || response.size() < 3)
    {
        nHeld_ = 0;
        Info<< (starting ? "; the sources start" : "; the sound is on its way")
            << endl;
        return;
    }

    const transferFit fit(response, drive);
    const scalar factor = factor_.last();

    // The fundamental that goes with the wanted level, harmonics included
    const scalar wanted =
        target_*std::abs(response.back())/max(pRms, VSMALL);
    const scalar wantedDrive = wanted/max(std::abs(fit.transfer()), VSMALL);

    const scalar settledError = 20*std::log10(factor*unit/wantedDrive);

    Info<< ", settles at " << target + settledError << " dB" << endl;

    if (nStarted_ > 3 + crossing_)
    {
        checkReach(std::abs(response.back()), loudest, wantedDrive);
    }

    // Let the last change be over for two periods, and the field answer
    // everywhere
    const bool quiet =
        nStarted_ >= 3 + crossing_
     && mesh_.time().value() > factor_.end() + (1.9 + crossing_)/frequency_;

    // What holds is not touched for a trifle: the field would never repeat
    const scalar trifle = (nHeld_ < 3 ? 0.3 : 0.7)*tolerance_;

    if (quiet && mag(settledError) > trifle)
    {
        const scalar most = std::log(30.0);
        const scalar change =
            min(max(std::log(wantedDrive/(factor*unit)), -most), most);

        // Slowly, lest other modes are struck, but small changes need not be
        const scalar periods =
            max(rampPeriods_*min(3*mag(change), scalar(1)), scalar(1));

        factor_.change
        (
            factor*std::exp(change),
            mesh_.time().value(),
            periods/frequency_
        );
    }

    const bool holds =
        mag(error) < tolerance_ && mag(settledError) < tolerance_;

    nHeld_ = holds ? nHeld_ + 1 : 0;
    nSteady_ = change < periodicTolerance_ ? nSteady_ + 1 : 0;

    if (nHeld_ == 3)
    {
        Info<< "The level of " << target << " dB holds within " << tolerance_
            << " dB, with a factor of " << factor << " of the drive" << endl;
    }

    const bool before = periodic_;
    periodic_ = nHeld_ >= 3 && nSteady_ >= 2;

    if (periodic_ && !before)
    {
        Info<< "The field is periodic: it changes by " << 100*change
            << " % per period" << endl;
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::levelControl::levelControl
(
    const fvMesh& mesh,
    const dictionary& dict,
    const scalar frequency,
    const scalar pRms,
    const scalar soundSpeed
)
:
    regIOobject
    (
        IOobject(typeName, mesh.time().timeName(), mesh)
    ),
    mesh_(mesh),
    frequency_(frequency),
    target_(pRms),
    soundSpeed_(soundSpeed),
    tolerance_(readPositive(dict, "tolerance", dimless, 0.1)),
    periodicTolerance_
    (
        readPositive(dict, "periodicTolerance", dimless, 1e-3)
    ),
    rampPeriods_(readPositive(dict, "rampPeriods", dimless, 6)),
    patches_(sources(mesh, dict)),
    factor_(mesh, patches_),
    reference_
    (
        gAverage(mesh.lookupObject<volScalarField>("p").primitiveField())
    ),
    p_(frequency, 1),
    pSquared_(frequency, 0),
    drive_(frequency, 1),
    crossing_(std::floor(mesh.bounds().mag()*frequency/soundSpeed)),
    driveOfUnit_(0),
    nStarted_(0),
    nHeld_(0),
    nSteady_(0),
    periodic_(false)
{
    requireOnly
    (
        dict,
        {"place", "point", "tolerance", "patches", "periodicTolerance",
         "rampPeriods"}
    );

    soundSources
    (
        mesh.lookupObject<volScalarField>("p"),
        mesh.lookupObject<volVectorField>("U")
    ).requireFrequency(frequency, patches_, dict);

    const word place = valueOr<word>(dict, "place", "maximum");

    if (place != "maximum" && place != "point")
    {
        FatalIOErrorInFunction(dict)
            << "Unknown place '" << place << "' of the level control; valid"
            << " places are maximum and point" << exit(FatalIOError);
    }
    if ((place == "point") != dict.found("point"))
    {
        FatalIOErrorInFunction(dict)
            << "Give the entry point exactly if the place is one"
            << exit(FatalIOError);
    }
    if (place == "point")
    {
        point_.reset(new meshPoint(mesh, getVector(dict, "point", dimLength)));
    }

    Info<< "    level control: " << soundLevel::SPL(target_) << " dB within "
        << tolerance_ << " dB at "
        << (point_ ? "a point" : "the maximum")
        << ", by the sources at " << patches_ << endl;

    // The state at the start belongs to the first period
    advance();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::levelControl::advance()
{
    const scalar t = mesh_.time().value();
    const scalarField p
    (
        mesh_.lookupObject<volScalarField>("p").primitiveField() - reference_
    );

    scalarField drives(2, drive());
    drives[1] /= max(factor_.value(t), SMALL);

    drive_.add(t, drives);
    pSquared_.add(t, sqr(p));

    if (p_.add(t, p))
    {
        control();
    }
}


// ************************************************************************* //
