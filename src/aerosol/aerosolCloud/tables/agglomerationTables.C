/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "agglomerationTables.H"

#include "checkedDictionary.H"
#include "mathematicalConstants.H"
#include "tableFolder.H"
#include "unitConversion.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::agglomerationTables::agglomerationTables
(
    const tableFolder& folder,
    const dictionary& sizeBins,
    const bool withContacts,
    const bool withBreakages,
    const bool withDistributions
)
:
    edges_
    (
        aerosolStatistics::logarithmicBins
        (
            sizeBins.get<scalar>("min"),
            sizeBins.get<scalar>("max"),
            sizeBins.get<label>("n")
        )
    ),
    agglomeration_
    (
        folder.states
        (
            "agglomeration",
            {
                "time_s", "number", "concentration_per_m3", "efficiency",
                "efficiency_PM2_5", "CMD_m", "MMD_m", "GSD", "dMax_m",
                "contacts", "mass_kg", "momentum_x_kg_m_per_s",
                "momentum_y_kg_m_per_s", "momentum_z_kg_m_per_s"
            }
        )
    ),
    sizes_
    (
        folder.states
        (
            "sizeDistribution",
            {"time_s", "lower_m", "upper_m", "number", "mass_kg"}
        )
    )
{
    if (withContacts)
    {
        contacts_ = folder.events
        (
            "contacts",
            {
                "time_s", "id1", "id2", "d1_m", "d2_m", "speed_m_per_s",
                "angle_deg", "outcome"
            }
        );
    }
    if (withBreakages)
    {
        breakages_ = folder.events
        (
            "breakages",
            {
                "time_s", "id", "d_m", "primaries", "newId", "newD_m",
                "newPrimaries"
            }
        );
    }
    if (withDistributions)
    {
        distributions_ = folder.states
        (
            "distributions",
            {
                "time_s", "lower_m", "upper_m", "number_per_m3",
                "volume_m3_per_m3", "dN_dlogd_per_m3", "dV_dlogd_m3_per_m3",
                "numberShareBelow", "volumeShareBelow"
            }
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dictionary Foam::aerosol::agglomerationTables::sizeBins
(
    const dictionary& dict,
    const scalars& d
)
{
    const dictionary given(optionalDict(dict, "sizeBins"));

    requireOnly(given, {"min", "max", "n"});

    const scalar smallest = d.size() ? d.minCoeff() : 1e-7;
    const scalar largest = d.size() ? d.maxCoeff() : 1e-5;

    const scalar min = readPositive(given, "min", dimLength, smallest);
    const scalar max = readPositive(given, "max", dimLength, 4*largest);
    const label n = readInteger(given, "n", 32, 1, 100000);

    if (max <= min)
    {
        FatalIOErrorInFunction(dict.found("sizeBins") ? given : dict)
            << "sizeBins from min " << min << " to max " << max
            << "; but max must be above min"
            << exit(FatalIOError);
    }

    // As scalars, which are kept exactly
    dictionary bins;
    bins.add("min", min);
    bins.add("max", max);
    bins.add("n", n);

    return bins;
}


void Foam::aerosol::agglomerationTables::writeRow
(
    const scalar time,
    const aerosolStatistics& now,
    const label N0,
    const label N0PM25,
    const scalar volume,
    const std::int64_t contacts
)
{
    if (!agglomeration_)
    {
        return;
    }

    // Of a kind that was never there, nothing has agglomerated
    const auto efficiency = [](const label N, const label N0)
    {
        return N0 ? 1 - scalar(N)/N0 : 0;
    };

    *agglomeration_
        << time << now.size << now.size/volume
        << efficiency(now.size, N0) << efficiency(now.sizePM25, N0PM25)
        << now.countMedianDiameter << now.massMedianDiameter << now.GSD
        << now.largestDiameter << contacts << now.mass
        << now.momentum.x() << now.momentum.y() << now.momentum.z();

    agglomeration_->endRow();
    agglomeration_->flush();
}


void Foam::aerosol::agglomerationTables::writeSizes
(
    const scalar time,
    const particleArrays& all,
    const scalar volume
)
{
    if (!sizes_)
    {
        return;
    }

    const integers number = aerosolStatistics::histogram(all.d, edges_);
    const scalars mass = aerosolStatistics::histogram(all.d, edges_, all.m);

    for (Eigen::Index k = 0; k < number.size(); ++k)
    {
        *sizes_
            << time << (k > 0 ? edges_(k - 1) : 0)
            << (
                   k < edges_.size()
                 ? edges_(k)
                 : std::numeric_limits<double>::infinity()
               )
            << number(k) << mass(k);

        sizes_->endRow();
    }

    sizes_->flush();

    if (distributions_)
    {
        writeDistributions(time, all, volume);
    }
}


void Foam::aerosol::agglomerationTables::writeDistributions
(
    const scalar time,
    const particleArrays& all,
    const scalar volume
)
{
    using constant::mathematical::pi;

    const scalars one(scalars::Ones(all.size()));
    const scalars cube(pi/6*all.d.cube());
    const scalars N = aerosolStatistics::histogram(all.d, edges_, one);
    const scalars V = aerosolStatistics::histogram(all.d, edges_, cube);

    const scalar allN = max(N.sum(), SMALL);
    const scalar allV = max(V.sum(), VSMALL);
    scalar belowN = N(0);
    scalar belowV = V(0);

    for (Eigen::Index k = 1; k < edges_.size(); ++k)
    {
        const scalar decades = std::log10(edges_(k)/edges_(k - 1));

        belowN += N(k);
        belowV += V(k);

        *distributions_
            << time << edges_(k - 1) << edges_(k)
            << N(k)/volume << V(k)/volume
            << N(k)/volume/decades << V(k)/volume/decades
            << belowN/allN << belowV/allV;

        distributions_->endRow();
    }

    distributions_->flush();
}


void Foam::aerosol::agglomerationTables::writeContacts
(
    const std::vector<collisions::record>& met
)
{
    if (!contacts_)
    {
        return;
    }

    for (const collisions::record& contact : met)
    {
        *contacts_
            << contact.time << contact.id1 << contact.id2
            << contact.d1 << contact.d2
            << contact.speed << radToDeg(contact.angle)
            << (contact.merged ? "stick" : contact.bounced ? "bounce" : "none");

        contacts_->endRow();
    }

    contacts_->flush();
}


void Foam::aerosol::agglomerationTables::writeBreakages
(
    const std::vector<fragmentation::record>& broken
)
{
    if (!breakages_)
    {
        return;
    }

    for (const fragmentation::record& one : broken)
    {
        *breakages_
            << one.time << one.id << one.d << one.primaries
            << one.newId << one.dNew << one.primariesNew;

        breakages_->endRow();
    }

    breakages_->flush();
}


// ************************************************************************* //
