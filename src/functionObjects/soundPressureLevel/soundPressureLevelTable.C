/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundPressureLevel.H"

#include "largestValue.H"
#include "phasor.H"
#include "soundLevel.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tableFolder Foam::functionObjects::soundPressureLevel::tables() const
{
    // A stock solver knows the time of its start by its name only; a new row
    // is a whole period later
    return tableFolder
    (
        baseFileDir()/prefix_,
        tabled_,
        0.5*mesh_.time().deltaTValue(),
        false
    );
}


void Foam::functionObjects::soundPressureLevel::openTables()
{
    const auto amplitudes = [&](const std::string& of, const std::string& unit)
    {
        std::vector<std::string> names;
        for (label k = 1; k <= nHarmonics_; ++k)
        {
            names.push_back(of + "Amp" + std::to_string(k) + unit);
        }
        return names;
    };

    const auto joined = []
    (
        std::initializer_list<std::vector<std::string>> parts
    )
    {
        std::vector<std::string> all;
        for (const std::vector<std::string>& part : parts)
        {
            all.insert(all.end(), part.begin(), part.end());
        }
        return all;
    };

    const tableFolder folder(tables());

    table_ = folder.events
    (
        typeName,
        joined
        ({
            {
                "time_s", "period", "frequency_Hz", "SPL_dB", "x_m", "y_m",
                "z_m"
            },
            amplitudes("p", "_Pa"),
            {"SWR", "UAmp1_m_per_s", "UMean_m_per_s"}
        })
    );

    if (points_.empty())
    {
        return;
    }

    pointTable_ = folder.events
    (
        typeName + "AtPoints",
        joined
        ({
            {
                "time_s", "period", "point", "x_m", "y_m", "z_m", "SPL_dB",
                "pPhase_rad", "UMean_x_m_per_s", "UMean_y_m_per_s",
                "UMean_z_m_per_s"
            },
            amplitudes("p", "_Pa"),
            amplitudes("U", "_m_per_s")
        })
    );
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

    const scalar SWR = gMax(pAmp[1])/max(gMin(pAmp[1]), VSMALL);
    const scalar UMean = gMax(mag(U_->mean())());
    const List<scalarList> values(atPoints());

    if (!Pstream::master() || !writeToFile())
    {
        return;
    }
    if (!table_)
    {
        openTables();
    }

    const label period = std::lround(p_->end()*frequency_);
    tabled_ = p_->end();

    tableFile& table = *table_;

    table
        << p_->end() << period << frequency_ << soundLevel::SPL(loudest.value)
        << loudest.place.x() << loudest.place.y() << loudest.place.z();

    for (label k = 1; k <= nHarmonics_; ++k)
    {
        table << there[k];
    }

    table << SWR << UAmp << UMean;
    table.endRow();
    table.flush();

    forAll(values, i)
    {
        const point& x = points_[i].position();
        tableFile& row = *pointTable_;

        row << p_->end() << period << i << x.x() << x.y() << x.z();
        for (const scalar value : values[i])
        {
            row << value;
        }
        row.endRow();
    }

    if (pointTable_)
    {
        pointTable_->flush();
    }
}


// ************************************************************************* //
