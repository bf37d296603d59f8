/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundPressureLevel.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "soundLevel.H"
#include "tableFolder.H"
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

    if (!p || !U)
    {
        // Sound that is a formula, or is replayed
        return false;
    }

    if (p->dimensions() != dimPressure)
    {
        FatalErrorInFunction
            << "The pressure " << pName_ << " of " << name() << " has the"
            << " dimensions " << p->dimensions() << ", not those of Pa: an"
            << " incompressible solver has no sound" << exit(FatalError);
    }

    if (!p_)
    {
        p_.reset(new acoustics::harmonicSum<scalar>(frequency_, nHarmonics_));
        pSquared_.reset(new acoustics::harmonicSum<scalar>(frequency_, 0));
        U_.reset(new acoustics::harmonicSum<vector>(frequency_, nHarmonics_));
        reference_ = gAverage(p->primitiveField());
    }

    const scalar t = mesh_.time().value();
    const scalarField fluctuation(p->primitiveField() - reference_);

    U_->add(t, U->primitiveField());
    pSquared_->add(t, sqr(fluctuation));

    return p_->add(t, fluctuation);
}


template<class Type>
const Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>&
Foam::functionObjects::soundPressureLevel::keep
(
    const word& name,
    const dimensionSet& dimensions,
    const Field<Type>& inCells
)
{
    using fieldType = GeometricField<Type, fvPatchField, volMesh>;

    if (!fields_.found(name))
    {
        if (mesh_.foundObject<regIOobject>(name))
        {
            FatalErrorInFunction
                << "There is a field " << name << " already: the function"
                << " object " << this->name() << " cannot make one"
                << exit(FatalError);
        }

        auto* field = acoustics::cellField
        (
            name, mesh_, dimensions, inCells
        ).ptr();

        // Into the registry, where other function objects find it
        field->checkIn();
        field->store();
        fields_.append(name);
    }

    auto& field = mesh_.lookupObjectRef<fieldType>(name);
    field.primitiveFieldRef() = inCells;
    field.correctBoundaryConditions();

    return field;
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

    const volScalarField& pRms = keep
    (
        "pRms",
        dimPressure,
        scalarField
        (
            sqrt(max(pSquared_->mean() - sqr(p_->mean()), scalar(0)))
        )
    );
    keep("pMean", dimPressure, scalarField(p_->mean() + reference_));
    keep("SPL", dimless, level(pRms));

    const volVectorField& UMean = keep("UMean", dimVelocity, U_->mean());

    List<const volScalarField*> pAmp(nHarmonics_ + 1, nullptr);
    List<const volScalarField*> UAmp(nHarmonics_ + 1, nullptr);

    for (label k = 1; k <= nHarmonics_; ++k)
    {
        const word number(std::to_string(k));

        pAmp[k] = &keep
        (
            "pAmp" + number,
            dimPressure,
            scalarField(sqrt(sqr(p_->cosine(k)) + sqr(p_->sine(k))))
        );
        UAmp[k] = &keep
        (
            "UAmp" + number,
            dimVelocity,
            amplitude(U_->cosine(k), U_->sine(k))
        );

        if (writeCoefficients_)
        {
            keep("UCos" + number, dimVelocity, U_->cosine(k));
            keep("USin" + number, dimVelocity, U_->sine(k));
        }
    }
    keep("pPhase", dimless, phase(p_->cosine(1), p_->sine(1)));


    // The table

    const largestValue loudest(mesh_, pRms);

    scalarList there(nHarmonics_ + 1, scalar(0));
    for (label k = 1; k <= nHarmonics_; ++k)
    {
        if (loudest.cell >= 0)
        {
            there[k] = (*pAmp[k])[loudest.cell];
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
        gMax(pAmp[1]->primitiveField())
       /max(gMin(pAmp[1]->primitiveField()), VSMALL)
    );
    row.append(gMax(UAmp[1]->primitiveField()));
    row.append(gMax(mag(UMean.primitiveField())()));

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
    const label nHarmonics = dict.getOrDefault<label>("harmonics", 3);

    if (nHarmonics < 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'harmonics' of " << dict.name() << " is " << nHarmonics
            << ", but it must be 1, the fundamental alone, or more"
            << exit(FatalIOError);
    }

    pName_ = dict.getOrDefault<word>("p", "p");
    UName_ = dict.getOrDefault<word>("U", "U");
    writeCoefficients_ = dict.getOrDefault("coefficients", false);

    points_.clear();
    for
    (
        const point& x
      : dict.getOrDefault<pointField>("probeLocations", pointField())
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

    return true;
}


bool Foam::functionObjects::soundPressureLevel::write()
{
    for (const word& name : fields_)
    {
        writeObject(name);
        requireWritten(mesh_.time().timePath()/name);
    }

    return true;
}


// ************************************************************************* //
