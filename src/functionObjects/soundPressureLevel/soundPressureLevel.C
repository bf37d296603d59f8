/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundPressureLevel.H"
#include "cellField.H"
#include "largestValue.H"
#include "phasor.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "soundLevel.H"
#include "stateDictionary.H"
#include "soundSources.H"
#include "tableFolder.H"
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


Foam::regIOobject* Foam::functionObjects::soundPressureLevel::own
(
    const word& name
) const
{
    // The registry is asked each time: a sound that is replayed takes the names
    // of its terms for fields of its own, and gives them back
    auto* object = mesh_.getObjectPtr<regIOobject>(name);

    return
        object
     && object->ownedByRegistry()
     && object->note() == acoustics::cellFieldNote
      ? object
      : nullptr;
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


template<class Type>
void Foam::functionObjects::soundPressureLevel::keep
(
    const word& name,
    const dimensionSet& dimensions,
    const Field<Type>& inCells
)
{
    using fieldType = GeometricField<Type, fvPatchField, volMesh>;

    if (!fields_.found(name))
    {
        requireFree(name);
        fields_.append(name);
    }

    if (!mesh_.foundObject<regIOobject>(name))
    {
        auto* field = acoustics::cellField
        (
            name, mesh_, dimensions, inCells
        ).ptr();

        // Into the registry, where other function objects find it
        field->checkIn();
        field->store();
    }
    else if (own(name))
    {
        auto& field = mesh_.lookupObjectRef<fieldType>(name);
        field.primitiveFieldRef() = inCells;
        field.correctBoundaryConditions();
    }
}


void Foam::functionObjects::soundPressureLevel::requireFree
(
    const word& name
) const
{
    const auto* other = mesh_.cfindObject<regIOobject>(name);

    if (other && (own(name) || other->note() != acoustics::cellFieldNote))
    {
        FatalErrorInFunction
            << "There is a field " << name << " already, of another function"
            << " object, such as fieldAverage or another soundPressureLevel:"
            << " the function object " << this->name() << " cannot make one"
            << exit(FatalError);
    }
}


void Foam::functionObjects::soundPressureLevel::writeTableHeader(Ostream& os)
{
    writeHeader(os, "Sound pressure level");
    writeHeaderValue(os, "frequency [Hz]", frequency_);
    for (size_t i = 0; i < points_.size(); ++i)
    {
        writeHeaderValue
        (
            os,
            "point " + std::to_string(i),
            points_[i].position()
        );
    }

    writeCommented(os, "Time");
    for (const char* column : {"period", "SPL", "x", "y", "z"})
    {
        writeTabbed(os, column);
    }
    for (label k = 1; k <= nHarmonics_; ++k)
    {
        writeTabbed(os, "pAmp" + std::to_string(k));
    }
    for (const char* column : {"SWR", "UAmp1", "UMean"})
    {
        writeTabbed(os, column);
    }
    for (size_t i = 0; i < points_.size(); ++i)
    {
        const std::string at = '(' + std::to_string(i) + ')';

        for
        (
            const char* column
          : {"SPL", "pPhase", "UMeanx", "UMeany", "UMeanz"}
        )
        {
            writeTabbed(os, column + at);
        }
        for (const char* amplitude : {"pAmp", "UAmp"})
        {
            for (label k = 1; k <= nHarmonics_; ++k)
            {
                writeTabbed(os, amplitude + std::to_string(k) + at);
            }
        }
    }
    os  << endl;
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
    using acoustics::largestValue;
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
    keep("pRms", dimPressure, pRms);
    keep("pMean", dimPressure, scalarField(p_->mean() + reference_));
    keep("SPL", dimless, level(pRms));

    const vectorField& UMean = U_->mean();
    keep("UMean", dimVelocity, UMean);

    List<scalarField> pAmp(nHarmonics_ + 1);
    List<scalarField> UAmp(nHarmonics_ + 1);

    for (label k = 1; k <= nHarmonics_; ++k)
    {
        const word number(std::to_string(k));

        pAmp[k] = sqrt(sqr(p_->cosine(k)) + sqr(p_->sine(k)));
        keep("pAmp" + number, dimPressure, pAmp[k]);

        UAmp[k] = amplitude(U_->cosine(k), U_->sine(k));
        keep("UAmp" + number, dimVelocity, UAmp[k]);

        if (writeCoefficients_)
        {
            keep("UCos" + number, dimVelocity, U_->cosine(k));
            keep("USin" + number, dimVelocity, U_->sine(k));
        }
    }
    keep("pPhase", dimless, phase(p_->cosine(1), p_->sine(1)));

    if (writeCoefficients_)
    {
        judge(gMax(UAmp[1]));
    }


    // The table

    const largestValue loudest(mesh_, pRms);

    scalarList there(nHarmonics_ + 1, scalar(0));
    for (label k = 1; k <= nHarmonics_; ++k)
    {
        if (loudest.cell >= 0)
        {
            there[k] = pAmp[k][loudest.cell];
        }
        reduce(there[k], sumOp<scalar>());
    }

    DynamicList<scalar> row;

    row.append(soundLevel::SPL(loudest.value));
    for (direction d = 0; d < vector::nComponents; ++d)
    {
        row.append(loudest.place[d]);
    }
    for (label k = 1; k <= nHarmonics_; ++k)
    {
        row.append(there[k]);
    }
    row.append
    (
        gMax(pAmp[1])/max(gMin(pAmp[1]), VSMALL)
    );
    row.append(gMax(UAmp[1]));
    row.append(gMax(mag(UMean)()));

    if (!points_.empty())
    {
        // Three scalars at a time; not amplitudes, which have kinks at nodes
        const auto together =
            [](const scalarField& a, const scalarField& b)
            {
                vectorField result(a.size(), Zero);
                result.replace(vector::X, a);
                result.replace(vector::Y, b);
                return result;
            };

        List<scalarList> values(points_.size());

        forAll(values, i)
        {
            const acoustics::meshPoint& point = points_[i];
            const vector squares = point.interpolate
            (
                together(pSquared_->mean(), p_->mean())
            );
            const vector mean = point.interpolate(UMean);

            scalarList& value = values[i];
            value.setSize(5 + 2*nHarmonics_, scalar(0));
            value[0] = soundLevel::SPL
            (
                std::sqrt
                (
                    max(squares.x() - sqr(squares.y()), scalar(0))
                )
            );
            for (direction d = 0; d < vector::nComponents; ++d)
            {
                value[2 + d] = mean[d];
            }

            for (label k = 1; k <= nHarmonics_; ++k)
            {
                const vector p = point.interpolate
                (
                    together(p_->cosine(k), p_->sine(k))
                );

                if (k == 1)
                {
                    value[1] = acoustics::phaseOf(p.x(), p.y());
                }
                value[4 + k] = std::hypot(p.x(), p.y());
                value[4 + nHarmonics_ + k] = acoustics::peak
                (
                    point.interpolate(U_->cosine(k)),
                    point.interpolate(U_->sine(k))
                );
            }
        }

        for (const scalarList& value : values)
        {
            row.append(value);
        }
    }

    if (Pstream::master() && writeToFile())
    {
        if (!table_)
        {
            table_ = tableFolder
            (
                baseFileDir()/prefix_,
                Time::timeName(startTime_)
            ).open(typeName);

            initStream(*table_);
            writeTableHeader(*table_);
        }

        OFstream& os = *table_;

        // As many digits of the time as tell apart periods far from zero
        os  << setprecision(15) << p_->end() << setprecision(writePrecision_)
            << token::TAB << label(std::lround(p_->end()*frequency_));
        for (const scalar value : row)
        {
            os  << token::TAB << value;
        }
        os  << nl;
        tableFolder::flush(os);
    }
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
    reference_(0)
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

    if (Pstream::master() && writeToFile())
    {
        requireFolder(baseFileDir());
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
    for (const word& name : fields_)
    {
        if (auto* field = own(name))
        {
            field->write();
            requireWritten(mesh_.time().timePath()/name);
        }
    }

    // Last: what it describes is complete
    if (terms_.size() && own("UMean"))
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
