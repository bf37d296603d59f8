/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundPressureLevel.H"
#include "phasor.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "soundLevel.H"
#include "stateDictionary.H"
#include "soundSources.H"
#include "untilPeriodic.H"
#include "volFields.H"
#include "writtenFiles.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(soundPressureLevel, 0);
    addToRunTimeSelectionTable(functionObject, soundPressureLevel, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::functionObjects::soundPressureLevel::add()
{
    const auto* p = mesh_.cfindObject<volScalarField>(pName_);
    const auto* U = mesh_.cfindObject<volVectorField>(UName_);

    if (!p || !U || acoustics::untilPeriodic::rests(mesh_))
    {
        // A sound that is a formula, or is replayed
        return false;
    }

    if (p->dimensions() != dimPressure)
    {
        FatalErrorInFunction
            << "The pressure " << pName_ << " of " << name() << " has the"
            << " dimensions " << p->dimensions() << ", not those of Pa: an"
            << " incompressible solver has no sound" << exit(FatalError);
    }

    const scalar t = mesh_.time().value();

    if (postProcess && p_ && !isResolved(t - lastTime_))
    {
        if (!warned_)
        {
            WarningInFunction
                << "soundPressureLevel " << name() << " has nothing to do: the"
                << " times that are read are " << t - lastTime_ << " s apart,"
                << " but it needs those of whole periods of " << 1/frequency_
                << " s, at least " << 2*nHarmonics_ + 2 << " in each. Put it"
                << " into the functions of system/controlDict before the run"
                << endl;
        }
        warned_ = true;
        p_.reset();

        return false;
    }
    lastTime_ = t;

    if (!p_)
    {
        p_.reset(new acoustics::harmonicSum<scalar>(frequency_, nHarmonics_));
        pSquared_.reset(new acoustics::harmonicSum<scalar>(frequency_, 0));
        U_.reset(new acoustics::harmonicSum<vector>(frequency_, nHarmonics_));
        USquared_.reset(new acoustics::harmonicSum<scalar>(frequency_, 0));
        terms_.clear();
        reference_ = gAverage(p->primitiveField());

        acoustics::soundSources(*p, *U).warnOfFrequency
        (
            frequency_,
            "'frequency' of the function object " + name()
        );
    }

    const scalarField fluctuation(p->primitiveField() - reference_);

    U_->add(t, U->primitiveField());
    USquared_->add(t, magSqr(U->primitiveField()));
    pSquared_->add(t, sqr(fluctuation));

    return p_->add(t, fluctuation);
}


bool Foam::functionObjects::soundPressureLevel::isResolved
(
    const scalar step
) const
{
    return step > 0 && step*frequency_*(2*nHarmonics_ + 1) < 1;
}


void Foam::functionObjects::soundPressureLevel::warnOfUnknown
(
    const dictionary& dict
)
{
    const wordList own
    ({
        "frequency", "harmonics", "p", "U", "coefficients", "probeLocations"
    });

    // Those of any function object, in one version of OpenFOAM or another
    const wordList common
    ({
        "type", "libs", "functionObjectLibs", "region", "subRegion", "enabled",
        "errors", "log", "timeStart", "timeEnd", "triggerStart", "triggerEnd",
        "controlMode", "nStepsToStartTimeChange", "executeControl",
        "executeInterval", "writeControl", "writeInterval", "writeFrequency",
        "outputControl", "outputInterval", "writeToFile", "writePrecision",
        "updateHeader", "useNamePrefix", "useUserTime"
    });

    for (const word& key : dict.toc())
    {
        if (!own.found(key) && !common.found(key))
        {
            IOWarningInFunction(dict)
                << "Unknown entry '" << visible(key).c_str() << "' in "
                << dict.name() << "; valid entries are " << own << endl;
        }
    }
}


void Foam::functionObjects::soundPressureLevel::judge(const scalar amplitude)
{
    using acoustics::harmonicFlow;

    const harmonicFlow::terms now(harmonicFlow::first(*U_, nHarmonics_));
    const scalarField& V = mesh_.V().field();

    // Square of what the terms leave of the velocity, by Parseval's theorem
    scalarField rest(USquared_->mean());
    scalar all = 0;
    scalar difference = 0;

    forAll(now, i)
    {
        const scalar share = i == 0 ? 1 : 0.5;
        rest -= share*magSqr(now[i]);

        all += gSum(V*magSqr(now[i]));
        if (terms_.size() == now.size())
        {
            difference += gSum(V*magSqr(now[i] - terms_[i]));
        }
    }

    const scalar left =
        gSum(V*max(rest, scalar(0)))/gSum(V);

    quality_.difference = std::sqrt(left)/max(amplitude, VSMALL);
    quality_.change =
        terms_.size() == now.size()
      ? std::sqrt(difference/max(all, VSMALL))
      : 1;

    terms_ = now;
}


void Foam::functionObjects::soundPressureLevel::calculate()
{
    using acoustics::soundLevel;

    const auto level = [](const scalarField& pRms)
    {
        scalarField SPL(pRms.size());
        forAll(SPL, celli)
        {
            SPL[celli] = soundLevel::SPL(pRms[celli]);
        }
        return SPL;
    };
    const auto amplitude = [](const vectorField& a, const vectorField& b)
    {
        scalarField result(a.size());
        forAll(result, celli)
        {
            result[celli] = acoustics::peak(a[celli], b[celli]);
        }
        return result;
    };
    const auto phase = [](const scalarField& a, const scalarField& b)
    {
        scalarField result(a.size());
        forAll(result, celli)
        {
            result[celli] = acoustics::phaseOf(a[celli], b[celli]);
        }
        return result;
    };

    const scalarField pRms
    (
        sqrt(max(pSquared_->mean() - sqr(p_->mean()), scalar(0)))
    );
    fields_.keep("pRms", dimPressure, pRms);
    fields_.keep("pMean", dimPressure, scalarField(p_->mean() + reference_));
    fields_.keep("SPL", dimless, level(pRms));

    const vectorField& UMean = U_->mean();
    fields_.keep("UMean", dimVelocity, UMean);

    List<scalarField> pAmp(nHarmonics_ + 1);
    List<scalarField> UAmp(nHarmonics_ + 1);

    for (label k = 1; k <= nHarmonics_; ++k)
    {
        const word number(std::to_string(k));

        pAmp[k] = sqrt(sqr(p_->cosine(k)) + sqr(p_->sine(k)));
        fields_.keep("pAmp" + number, dimPressure, pAmp[k]);

        UAmp[k] = amplitude(U_->cosine(k), U_->sine(k));
        fields_.keep("UAmp" + number, dimVelocity, UAmp[k]);

        if (writeCoefficients_)
        {
            fields_.keep("UCos" + number, dimVelocity, U_->cosine(k));
            fields_.keep("USin" + number, dimVelocity, U_->sine(k));
        }
    }
    fields_.keep("pPhase", dimless, phase(p_->cosine(1), p_->sine(1)));

    if (writeCoefficients_)
    {
        judge(gMax(UAmp[1]));
    }

    writeRow(pRms, pAmp, gMax(UAmp[1]));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::soundPressureLevel::soundPressureLevel
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    writeFile(obr_, name, typeName),
    frequency_(0),
    nHarmonics_(0),
    writeCoefficients_(false),
    warned_(false),
    lastTime_(0),
    reference_(0),
    tabled_(runTime.value()),
    fields_(mesh_, name)
{
    read(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::soundPressureLevel::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);
    writeFile::read(dict);

    const scalar frequency = readPositive(dict, "frequency", dimless/dimTime);
    const label nHarmonics = readInteger(dict, "harmonics", 3, 1, 100);

    warnOfUnknown(dict);

    pName_ = valueOr<word>(dict, "p", "p");
    UName_ = valueOr<word>(dict, "U", "U");
    writeCoefficients_ = valueOr<bool>(dict, "coefficients", false);

    points_.clear();
    for
    (
        const point& x
      : valueOr<pointField>(dict, "probeLocations", pointField())
    )
    {
        points_.emplace_back(mesh_, x);
    }

    if (frequency != frequency_ || nHarmonics != nHarmonics_)
    {
        frequency_ = frequency;
        nHarmonics_ = nHarmonics;
        p_.reset();
    }

    // Changed while running: the columns may have changed, too
    table_.reset(nullptr);
    pointTable_.reset(nullptr);

    // What this run will write again is not to wait for that
    if (!postProcess && writeToFile())
    {
        tables();
    }

    // The state at the start belongs to the first period
    if (!p_)
    {
        add();
    }

    return true;
}


bool Foam::functionObjects::soundPressureLevel::execute()
{
    if (add())
    {
        calculate();
    }

    if (!p_ && !warned_)
    {
        WarningInFunction
            << "soundPressureLevel " << name() << " has nothing to do: there"
            << " is no pressure '" << pName_ << "' or no velocity '" << UName_
            << "'. Of fields there are "
            << mesh_.sortedNames(volScalarField::typeName) << " and "
            << mesh_.sortedNames(volVectorField::typeName)
            << "; "
            << (
                   postProcess
                 ? "postProcess reads those that it is told: -fields '(p U)'"
                 : "a sound that is a formula, or is replayed, has no pressure"
               )
            << endl;

        warned_ = true;
    }

    return true;
}


bool Foam::functionObjects::soundPressureLevel::end()
{
    if (p_ && fields_.empty() && !warned_)
    {
        WarningInFunction
            << "soundPressureLevel " << name() << " has no result: it has seen"
            << " no whole period of " << 1/frequency_ << " s" << endl;
    }

    return true;
}


bool Foam::functionObjects::soundPressureLevel::write()
{
    fields_.write();

    // Last: what it describes is complete
    if (terms_.size() && fields_.found("UMean"))
    {
        dictionary dict;

        dict.add("frequency", frequency_);
        dict.add("harmonics", nHarmonics_);
        dict.add
        (
            "magnitudes", acoustics::harmonicFlow::magnitudes(mesh_, terms_)
        );
        quality_.write(dict);

        stateDictionary
        (
            IOobject
            (
                "harmonics",
                mesh_.time().timeName(),
                "uniform",
                mesh_,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            dict
        ).regIOobject::write();
    }

    return true;
}


// ************************************************************************* //
