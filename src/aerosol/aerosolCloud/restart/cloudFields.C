/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudFields.H"

#include "foamVersion.H"
#include "IOField.H"
#include "ListListOps.H"
#include "Pstream.H"
#include "Time.H"
#include "passiveParticleCloud.H"
#include "polyMesh.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::cloudFields::cloudFields
(
    const polyMesh& mesh,
    const passiveParticleCloud& cloud
)
:
    mesh_(mesh),
    cloud_(cloud)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::aerosol::cloudFields::place() const
{
    return
        "of the cloud " + cloud_.name() + " in time "
      + mesh_.time().timeName();
}


template<class Type>
Foam::Field<Type> Foam::aerosol::cloudFields::read
(
    const word& name,
    labelList& sizes
) const
{
    IOobject io(cloudFieldIO(cloud_, name, IOobject::MUST_READ));

    // A rank without particles has no files
    const bool mine = io.typeHeaderOk<IOField<Type>>(true);

    List<Field<Type>> parts(Pstream::nProcs());
    parts[Pstream::myProcNo()] = IOField<Type>(io, mine);
    gatherToAll(parts);

    const Field<Type> all
    (
        ListListOps::combine<Field<Type>>(parts, accessOp<Field<Type>>())
    );

    // The first one says how many there are on each rank
    const bool first = sizes.empty();
    sizes.setSize(parts.size());

    forAll(parts, proci)
    {
        if (first)
        {
            sizes[proci] = parts[proci].size();
        }
        else if (parts[proci].size() != sizes[proci])
        {
            const std::string onRank =
                Pstream::parRun() ? " on rank " + Foam::name(proci) : "";

            FatalIOErrorInFunction(io.objectPath())
                << "The file '" << name << "' " << place().c_str() << " has "
                << parts[proci].size() << " values"
                << onRank.c_str()
                << ", but there are " << sizes[proci] << " particles (of 'id')"
                << exit(FatalIOError);
        }
    }

    forAll(all, i)
    {
        if (!std::isfinite(scalar(mag(all[i]))))
        {
            FatalIOErrorInFunction(io.objectPath())
                << "The file '" << name << "' " << place().c_str()
                << " has the value " << all[i] << ", which is no finite number"
                << exit(FatalIOError);
        }
    }

    return all;
}


template<class Type>
void Foam::aerosol::cloudFields::requirePositive
(
    const word& name,
    const Field<Type>& values
) const
{
    for (const Type& value : values)
    {
        if (value <= 0)
        {
            FatalIOErrorInFunction
            (
                cloudFieldIO(cloud_, name, IOobject::NO_READ).objectPath()
            )
                << "The file '" << name << "' " << place().c_str()
                << " has the value " << value << ", but it must be positive"
                << exit(FatalIOError);
        }
    }
}


template<class Type>
bool Foam::aerosol::cloudFields::write
(
    const word& name,
    const labelUList& particles,
    const std::function<Type(label)>& value
) const
{
    IOField<Type> field
    (
        cloudFieldIO(cloud_, name, IOobject::NO_READ),
        particles.size()
    );

    forAll(particles, k)
    {
        field[k] = value(particles[k]);
    }

    return field.write(!particles.empty());
}


bool Foam::aerosol::cloudFields::remove(const word& name) const
{
    const fileName file = fileHandler().filePath
    (
        cloudFieldIO(cloud_, name, IOobject::NO_READ).objectPath()
    );

    return returnReduce(fileHandler().rm(file), orOp<bool>());
}


void Foam::aerosol::cloudFields::removeIfEmpty(const bool empty) const
{
    const fileName own =
        cloudFieldIO(cloud_, "id", IOobject::NO_READ).path();
    const fileName there = fileHandler().filePath(own);

    // Collated files are those of all ranks, and are written anew
    fileHandler().rmDir(empty && there == own ? own : fileName(), true);
}


// * * * * * * * * * * * * Explicit Instantiations * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{

#define makeCloudFields(Type)                                                  \
                                                                               \
    template Field<Type> cloudFields::read(const word&, labelList&) const;     \
                                                                               \
    template bool cloudFields::write                                           \
    (                                                                          \
        const word&, const labelUList&, const std::function<Type(label)>&      \
    ) const;

makeCloudFields(label)
makeCloudFields(scalar)
makeCloudFields(vector)

#undef makeCloudFields

template void cloudFields::requirePositive
(
    const word&, const Field<label>&
) const;
template void cloudFields::requirePositive
(
    const word&, const Field<scalar>&
) const;

} // End namespace aerosol
} // End namespace Foam


// ************************************************************************* //
