/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundPressureLevel.H"

#include "largestValue.H"
#include "phasor.H"
#include "soundLevel.H"
#include "tableFolder.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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


Foam::List<Foam::scalarList>
Foam::functionObjects::soundPressureLevel::atPoints() const
{
    using acoustics::soundLevel;

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
        const vector mean = point.interpolate(U_->mean());

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

    return values;
}


void Foam::functionObjects::soundPressureLevel::writeRow
(
    const scalarField& pRms,
    const UList<scalarField>& pAmp,
    const scalar UAmp
)
{
    using acoustics::largestValue;
    using acoustics::soundLevel;

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
    row.append(UAmp);
    row.append(gMax(mag(U_->mean())()));

    for (const scalarList& value : atPoints())
    {
        row.append(value);
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


// ************************************************************************* //
