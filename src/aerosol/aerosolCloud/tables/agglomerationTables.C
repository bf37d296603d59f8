/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "agglomerationTables.H"

#include "Time.H"
#include "checkedDictionary.H"
#include "tableFolder.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::agglomerationTables::writeCount
(
    Ostream& os,
    const std::int64_t value
) const
{
    // As text: Ostream would cut it to the size of a label
    os  << tab << setw(charWidth()) << std::to_string(value).c_str();
}


void Foam::aerosol::agglomerationTables::writeNumber
(
    Ostream& os,
    const scalar value,
    const int digits
) const
{
    os  << tab << setprecision(digits - 1) << setw(digits + addChars) << value;
}


void Foam::aerosol::agglomerationTables::writeTime
(
    Ostream& os,
    const scalar time
) const
{
    // As many digits as tell apart steps far from zero
    os  << setprecision(15) << setw(16 + addChars) << time;
}


void Foam::aerosol::agglomerationTables::endRow(OFstream& os)
{
    // Each by itself: a kill leaves whole rows
    os  << nl;
    tableFolder::flush(os);
}


void Foam::aerosol::agglomerationTables::writeAgglomerationHeader
(
    Ostream& os
) const
{
    writeHeader(os, "Agglomeration of the aerosol");
    writeHeader(os, "efficiency      1 - N/N0 of all particles");
    writeHeader
    (
        os,
        "efficiencyPM2.5 the same of particles with a geometric diameter of at"
        " most 2.5e-6 m"
    );
    writeHeader(os, "CMD, MMD        count and mass median diameter");
    writeHeader(os, "GSD             geometric standard deviation of d");
    writeHeader(os, "Diameters of aggregates: of the spheres of their volumes");

    writeCommented(os, "time[s]");

    for
    (
        const char* column :
        {
            "particles", "concentration[1/m3]", "efficiency",
            "efficiencyPM2.5", "CMD[m]", "MMD[m]", "GSD", "dMax[m]",
            "contacts"
        }
    )
    {
        writeTabbed(os, column);
    }
    for
    (
        const char* column :
        {
            "mass[kg]", "momentumX[kg.m/s]", "momentumY[kg.m/s]",
            "momentumZ[kg.m/s]"
        }
    )
    {
        os  << tab << setw(16 + addChars) << column;
    }

    os  << endl;
}


void Foam::aerosol::agglomerationTables::writeSizesHeader(Ostream& os) const
{
    writeHeader(os, "Number of particles by diameter");

    writeCommented(os, "edges[m]");
    for (const scalar edge : edges_)
    {
        writeNumber(os, edge, 16);
    }
    os  << nl;

    writeCommented(os, "time[s]");
    writeTabbed(os, "below");
    for (Eigen::Index k = 1; k < edges_.size(); ++k)
    {
        writeTabbed(os, "bin" + Foam::name(label(k)));
    }
    writeTabbed(os, "above");

    os  << endl;
}


void Foam::aerosol::agglomerationTables::writeContactsHeader(Ostream& os) const
{
    writeHeader(os, "Contacts, by time");
    writeHeader(os, "id1, d1   of the survivor; diameters are those before");
    writeHeader(os, "speed     relative speed of the two");
    writeHeader
    (
        os,
        "angle     between relative velocity and line of centres; 0: head-on,"
        " 90: grazing"
    );

    writeCommented(os, "time[s]");

    for
    (
        const char* column :
        {
            "id1", "id2", "d1[m]", "d2[m]", "speed[m/s]", "angle[deg]",
            "outcome"
        }
    )
    {
        writeTabbed(os, column);
    }

    os  << endl;
}


void Foam::aerosol::agglomerationTables::writeBreakagesHeader
(
    Ostream& os
) const
{
    writeHeader(os, "Breakages, by time");
    writeHeader(os, "id, d, primaries   of the aggregate; the larger piece");
    writeHeader(os, "                   keeps the id");
    writeHeader(os, "newId, ...         of the smaller piece");

    writeCommented(os, "time[s]");

    for
    (
        const char* column :
        {"id", "newId", "d[m]", "newD[m]", "primaries", "newPrimaries"}
    )
    {
        writeTabbed(os, column);
    }

    os  << endl;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::agglomerationTables::agglomerationTables
(
    const objectRegistry& mesh,
    const dictionary& sizeBins,
    const bool withContacts,
    const word& cloudName,
    const bool withBreakages
)
:
    writeFile(mesh, cloudName),
    edges_
    (
        aerosolStatistics::logarithmicBins
        (
            sizeBins.get<scalar>("min"),
            sizeBins.get<scalar>("max"),
            sizeBins.get<label>("n")
        )
    )
{
    // Sets the width of the columns
    writePrecision_ = 10;

    if (!Pstream::master())
    {
        return;
    }

    const tableFolder folder
    (
        baseFileDir()/prefix_,
        Time::timeName(startTime_)
    );

    const auto open = [&](const word& name)
    {
        autoPtr<OFstream> os(folder.open(name));
        initStream(*os);
        return os;
    };

    agglomeration_ = open("agglomeration");
    writeAgglomerationHeader(*agglomeration_);

    sizes_ = open("sizeDistribution");
    writeSizesHeader(*sizes_);

    if (withContacts)
    {
        collisions_ = open("contacts");
        writeContactsHeader(*collisions_);
    }
    if (withBreakages)
    {
        fragmentation_ = open("breakages");
        writeBreakagesHeader(*fragmentation_);
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
    if (!agglomeration_.valid())
    {
        return;
    }

    OFstream& os = *agglomeration_;

    // Of a kind that was never there, nothing has agglomerated
    const auto efficiency = [](const label N, const label N0)
    {
        return N0 ? 1 - scalar(N)/N0 : 0;
    };

    writeTime(os, time);
    writeCount(os, now.size);
    writeNumber(os, now.size/volume);
    writeNumber(os, efficiency(now.size, N0));
    writeNumber(os, efficiency(now.sizePM25, N0PM25));
    writeNumber(os, now.countMedianDiameter);
    writeNumber(os, now.massMedianDiameter);
    writeNumber(os, now.GSD);
    writeNumber(os, now.largestDiameter);
    writeCount(os, contacts);
    writeNumber(os, now.mass, 16);
    writeNumber(os, now.momentum.x(), 16);
    writeNumber(os, now.momentum.y(), 16);
    writeNumber(os, now.momentum.z(), 16);
    endRow(os);
}


void Foam::aerosol::agglomerationTables::writeSizes
(
    const scalar time,
    const scalars& d
)
{
    if (!sizes_.valid())
    {
        return;
    }

    OFstream& os = *sizes_;

    writeTime(os, time);
    for (const std::int64_t count : aerosolStatistics::histogram(d, edges_))
    {
        writeCount(os, count);
    }
    endRow(os);
}


void Foam::aerosol::agglomerationTables::writeContacts
(
    const std::vector<collisions::record>& met
)
{
    if (!collisions_.valid() || met.empty())
    {
        return;
    }

    OFstream& os = *collisions_;

    for (const collisions::record& contact : met)
    {
        writeTime(os, contact.time);
        writeCount(os, contact.id1);
        writeCount(os, contact.id2);
        writeNumber(os, contact.d1);
        writeNumber(os, contact.d2);
        writeNumber(os, contact.speed);
        writeNumber(os, radToDeg(contact.angle));
        writeTabbed
        (
            os,
            contact.merged ? "stick" : contact.bounced ? "bounce" : "none"
        );
        endRow(os);
    }
}


void Foam::aerosol::agglomerationTables::writeBreakages
(
    const std::vector<fragmentation::record>& broken
)
{
    if (!fragmentation_.valid() || broken.empty())
    {
        return;
    }

    OFstream& os = *fragmentation_;

    for (const fragmentation::record& one : broken)
    {
        writeTime(os, one.time);
        writeCount(os, one.id);
        writeCount(os, one.newId);
        writeNumber(os, one.d);
        writeNumber(os, one.dNew);
        writeCount(os, one.primaries);
        writeCount(os, one.primariesNew);
        endRow(os);
    }
}


// ************************************************************************* //
