/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "listSource.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "csvTable.H"
#include "domain.H"
#include "neighbourList.H"
#include "eigenVector.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(listSource, 0);
    addToRunTimeSelectionTable(particleSource, listSource, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::listSource::addPrimaries
(
    const scalar primaries,
    const std::size_t i
)
{
    if
    (
        primaries < 1
     || primaries > labelMax
     || std::trunc(primaries) < primaries
    )
    {
        FatalIOErrorInFunction(dict_)
            << "The 'primaries' in " << where_[i].c_str() << " are "
            << primaries << ", but they must be a whole number from 1 to "
            << labelMax
            << exit(FatalIOError);
    }

    primaries_.push_back(static_cast<std::int64_t>(primaries));
}


void Foam::aerosol::listSource::readFile()
{
    const csvTable table
    (
        dict_,
        "file",
        {
            "x,y,z,d", "x,y,z,d,vx,vy,vz", "x,y,z,d,primaries",
            "x,y,z,d,vx,vy,vz,primaries"
        }
    );

    for (std::size_t i = 0; i < table.rows().size(); ++i)
    {
        const auto& row = table.rows()[i];

        positions_.emplace_back(row[0], row[1], row[2]);
        diameters_.push_back(row[3]);
        where_.push_back(table.where(i));

        if (row.size() >= 7)
        {
            velocities_.emplace_back(row[4], row[5], row[6]);
        }

        const bool counted = row.size() == 5 || row.size() == 8;
        addPrimaries(counted ? row.back() : 1, i);

        if (row[3] <= 0)
        {
            FatalIOErrorInFunction(dict_)
                << "The diameter in " << where_[i].c_str() << " is " << row[3]
                << ", but it must be positive"
                << exit(FatalIOError);
        }
    }
}


void Foam::aerosol::listSource::readEntries()
{
    const auto entries = dict_.get<List<dictionary>>("particles");

    forAll(entries, i)
    {
        const dictionary& entry = entries[i];

        requireOnly(entry, {"position", "diameter", "velocity", "primaries"});

        positions_.push_back
        (
            toEigen(getVector(entry, "position", dimLength))
        );
        diameters_.push_back(readPositive(entry, "diameter", dimLength));
        where_.push_back("number " + std::to_string(i + 1) + " of 'particles'");
        addPrimaries(valueOr<scalar>(entry, "primaries", 1), i);

        if (entry.found("velocity"))
        {
            velocities_.push_back
            (
                toEigen(getVector(entry, "velocity", dimVelocity))
            );
        }
    }

    if (!velocities_.empty() && velocities_.size() != positions_.size())
    {
        FatalIOErrorInFunction(dict_)
            << velocities_.size() << " of the " << positions_.size()
            << " particles in " << dict_.name()
            << " have a 'velocity'; give it to all of them or to none"
            << exit(FatalIOError);
    }
}


void Foam::aerosol::listSource::checkInside(const domain& region) const
{
    for (std::size_t i = 0; i < positions_.size(); ++i)
    {
        const vector x
        (
            positions_[i].x(),
            positions_[i].y(),
            positions_[i].z()
        );

        if (!region.bounds().contains(x))
        {
            FatalIOErrorInFunction(dict_)
                << "The particle at " << x << ", " << where_[i].c_str()
                << ", is outside of the domain, which extends from "
                << region.bounds().min() << " to " << region.bounds().max()
                << exit(FatalIOError);
        }

        for (int k = 0; k < 3; ++k)
        {
            if (region.period()[k] > 0 && diameters_[i] > region.period()[k])
            {
                FatalIOErrorInFunction(dict_)
                    << "The particle of diameter " << diameters_[i] << ", "
                    << where_[i].c_str() << ", overlaps its own image in the"
                    << " domain with the edges " << region.bounds().span()
                    << exit(FatalIOError);
            }
        }
    }
}


void Foam::aerosol::listSource::checkOverlaps
(
    const domain& region,
    const particleArrays& particles
) const
{
    // Positions are decimal numbers: spheres that are meant to touch overlap by
    // the rounding error
    const double touch = 1 - 1e-9;

    const std::vector<particlePair> pairs =
        neighbourList::touching(region, particles.x, 0.5*touch*particles.d);

    if (!pairs.empty())
    {
        const auto [i, j, image] = pairs.front();

        const Eigen::Array3d shift
        (
            Eigen::Array3d(image[0], image[1], image[2])*region.period()
        );

        const scalar distance =
            (particles.x.col(j) - particles.x.col(i) + shift.matrix()).norm();

        FatalIOErrorInFunction(dict_)
            << "Particles overlap: " << where_[i].c_str() << " and "
            << (shift.isZero() ? "" : "an image of ") << where_[j].c_str()
            << ". Their distance is " << distance
            << " m, the sum of their radii "
            << 0.5*(particles.d(i) + particles.d(j)) << " m"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::listSource::listSource(const dictionary& dict)
:
    particleSource(dict)
{
    requireOnly
    (
        dict, {"density", "source", "initialVelocity", "particles", "file"}
    );

    if (dict.found("particles") == dict.found("file"))
    {
        FatalIOErrorInFunction(dict)
            << "Source list needs either 'particles' or 'file', but "
            << dict.name() << " has "
            << (dict.found("file") ? "both" : "neither")
            << exit(FatalIOError);
    }

    if (dict.found("file"))
    {
        readFile();
    }
    else
    {
        readEntries();
    }

    if (positions_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "The list 'particles' of " << dict.name() << " is empty"
            << exit(FatalIOError);
    }

    if (!velocities_.empty() && dict.found("initialVelocity"))
    {
        FatalIOErrorInFunction(dict)
            << "The particles of " << dict.name() << " have velocities of"
            << " their own; remove these or 'initialVelocity'"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::listSource::create
(
    const domain& region,
    particleArrays& particles
) const
{
    checkInside(region);

    start(particles, static_cast<int>(positions_.size()));

    for (int i = 0; i < particles.size(); ++i)
    {
        particles.x.col(i) = positions_[i];
        particles.d(i) = diameters_[i];
        particles.primaries(i) = primaries_[i];

        if (!velocities_.empty())
        {
            particles.v.col(i) = velocities_[i];
        }
    }

    setMasses(particles);
    checkOverlaps(region, particles);
}


// ************************************************************************* //
