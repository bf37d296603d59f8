/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudFiles.H"

#include "allDigits.H"
#include "foamVersion.H"
#include "IOdictionary.H"
#include "IOField.H"
#include "ListListOps.H"
#include "ListOps.H"
#include "Pstream.H"
#include "Time.H"
#include "passiveParticleCloud.H"
#include "polyMesh.H"
#include "polyMeshTetDecomposition.H"
#include "restartableTime.H"
#include "stateDictionary.H"
#include "treeDataCell.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::vector column(const Foam::aerosol::vectors& v, const int i)
{
    return Foam::vector(v(0, i), v(1, i), v(2, i));
}


//- File of the j-th three numbers of a history
Foam::word historyName(const int j)
{
    return "history" + Foam::name(j);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::aerosol::cloudFiles::stateIO
(
    const IOobject::readOption readOption
) const
{
    return IOobject
    (
        cloud_->name() + "State",
        mesh_.time().timeName(),
        "uniform",
        mesh_,
        readOption,
        IOobject::NO_WRITE,
        false
    );
}


Foam::List<Foam::tetIndices> Foam::aerosol::cloudFiles::locate
(
    const vectors& x
) const
{
    List<tetIndices> places(x.cols());

    if (!mesh_.nCells())
    {
        return places;
    }

    // Neighbours in the arrays are often neighbours in space
    label hint = -1;

    forAll(places, i)
    {
        if (!x.col(i).allFinite())
        {
            continue;
        }

        const point p(column(x, i));

        if (hint >= 0)
        {
            places[i] = polyMeshTetDecomposition::findTet(mesh_, hint, p);
        }

        if (places[i].cell() < 0)
        {
            const label celli = mesh_.cellTree().findInside(p);

            if (celli >= 0)
            {
                places[i] = polyMeshTetDecomposition::findTet(mesh_, celli, p);
                hint = celli;
            }
        }
    }

    return places;
}


Foam::labelList Foam::aerosol::cloudFiles::mine
(
    const particleArrays& particles,
    const UList<tetIndices>& places
) const
{
    const label nobody = Pstream::nProcs();

    labelList writer(places.size(), nobody);

    forAll(places, i)
    {
        if (places[i].cell() >= 0)
        {
            writer[i] = Pstream::myProcNo();
        }
    }

    combineToAll(writer, minEqOp<label>());

    const label lost = writer.find(nobody);

    if (lost >= 0)
    {
        FatalErrorInFunction
            << std::count(writer.cbegin(), writer.cend(), nobody) << " of the "
            << particles.size() << " particles are outside the mesh, which"
            << " lies within " << mesh_.bounds() << nl
            << "The first of them, of id " << particles.id(lost) << ", is at "
            << column(particles.x, lost)
            << exit(FatalError);
    }

    return findIndices(writer, Pstream::myProcNo());
}


bool Foam::aerosol::cloudFiles::remove(const word& name) const
{
    const fileName file = fileHandler().filePath
    (
        cloudFieldIO(*cloud_, name, IOobject::NO_READ).objectPath()
    );

    return returnReduce(fileHandler().rm(file), orOp<bool>());
}


void Foam::aerosol::cloudFiles::removeIfEmpty(const bool empty) const
{
    const fileName own =
        cloudFieldIO(*cloud_, "id", IOobject::NO_READ).path();
    const fileName there = fileHandler().filePath(own);

    // Collated files are those of all ranks, and are written anew
    fileHandler().rmDir(empty && there == own ? own : fileName(), true);
}


template<class Type>
void Foam::aerosol::cloudFiles::requirePositive
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
                cloudFieldIO(*cloud_, name, IOobject::NO_READ).objectPath()
            )
                << "The file '" << name << "' " << place().c_str()
                << " has the value " << value << ", but it must be positive"
                << exit(FatalIOError);
        }
    }
}


template<class Type, class Value>
bool Foam::aerosol::cloudFiles::writeField
(
    const word& name,
    const labelUList& particles,
    const Value& value
) const
{
    IOField<Type> field
    (
        cloudFieldIO(*cloud_, name, IOobject::NO_READ),
        particles.size()
    );

    forAll(particles, k)
    {
        field[k] = value(particles[k]);
    }

    return field.write(!particles.empty());
}


bool Foam::aerosol::cloudFiles::writeState
(
    const dictionary& state,
    const label size
) const
{
    stateDictionary io(stateIO(IOobject::NO_READ), state);

    io.set("particles", size);

    return writeObject(io, IOstream::ASCII, IOstream::UNCOMPRESSED, true);
}


Foam::string Foam::aerosol::cloudFiles::place() const
{
    return
        "of the cloud " + cloud_->name() + " in time "
      + mesh_.time().timeName();
}


template<class Type>
Foam::Field<Type> Foam::aerosol::cloudFiles::readField
(
    const word& name,
    labelList& sizes
) const
{
    IOobject io(cloudFieldIO(*cloud_, name, IOobject::MUST_READ));

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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::cloudFiles::cloudFiles
(
    const polyMesh& mesh,
    const word& cloudName
)
:
    mesh_(mesh),
    cloud_(newEmptyCloud<passiveParticleCloud>(mesh, cloudName))
{
    cloud_->regIOobject::checkOut();
}


Foam::aerosol::cloudFiles::~cloudFiles() = default;


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::aerosol::cloudFiles::found() const
{
    bool here = stateIO(IOobject::MUST_READ).typeHeaderOk<IOdictionary>(true);

    for (const word name : {"coordinates", "positions"})
    {
        IOobject io(cloudFieldIO(*cloud_, name, IOobject::MUST_READ));

        here = io.typeHeaderOk<IOField<vector>>(false) || here;
    }

    return returnReduce(here, orOp<bool>());
}


Foam::dictionary Foam::aerosol::cloudFiles::readState() const
{
    const Time& time = mesh_.time();
    IOobject io(stateIO(IOobject::MUST_READ));

    if (io.typeHeaderOk<IOdictionary>(true))
    {
        return IOdictionary(io);
    }

    // decomposePar does not link it where it made no time for a rank
    const fileName undecomposed
    (
        time.globalPath()/time.timeName()/"uniform"/io.name()
    );

    if (Pstream::parRun() && fileHandler().isFile(undecomposed))
    {
        return dictionary(fileHandler().NewIFstream(undecomposed)());
    }

    FatalErrorInFunction
        << "The cloud " << cloud_->name() << " of time "
        << time.timeName() << " comes without the file "
        << io.objectPath()
        << ", so that the run cannot be continued from there. Go on from an"
        << " earlier time; or, to begin anew, remove "
        << (restartableTime::onAllRanks(time)/cloud::prefix).c_str()
        << exit(FatalError);

    return dictionary();
}


Foam::dictionary Foam::aerosol::cloudFiles::read
(
    particleArrays& particles,
    inFrame& frame
) const
{
    const dictionary state(readState());

    // The last one that is written
    stateDictionary::require(state, {"particles"});
    const label size = state.get<label>("particles");

    labelList sizes;

    const Field<label> id(readField<label>("id", sizes));

    if (id.size() != size)
    {
        FatalIOErrorInFunction(state)
            << "There were " << size << " particles, but the files 'id' "
            << place().c_str() << " have " << id.size() << " values"
            << exit(FatalIOError);
    }

    const Field<label> primaries(readField<label>("primaries", sizes));
    const Field<scalar> d(readField<scalar>("d", sizes));
    const Field<scalar> mass(readField<scalar>("mass", sizes));
    const Field<vector> position(readField<vector>("position", sizes));
    const Field<vector> U(readField<vector>("U", sizes));

    requirePositive("primaries", primaries);
    requirePositive("d", d);
    requirePositive("mass", mass);

    // Files that are there only with Brownian motion, or unsteady drag; others
    // may be left from an earlier run
    const Field<vector> UBrownian
    (
        state.getOrDefault("UBrownian", false)
      ? readField<vector>("UBrownian", sizes)
      : Field<vector>(size, Zero)
    );

    List<Field<vector>> history(state.getOrDefault<label>("histories", 0));
    Field<scalar> step;

    if (history.size())
    {
        step = readField<scalar>("historyStep", sizes);

        forAll(history, j)
        {
            history[j] = readField<vector>(historyName(j), sizes);
        }
    }

    Field<vector> framePosition;
    Field<vector> frameU;

    if (state.getOrDefault("frame", false))
    {
        framePosition = readField<vector>("framePosition", sizes);
        frameU = readField<vector>("frameU", sizes);
    }

    frame.x.resize(3, framePosition.size());
    frame.v.resize(3, frameU.size());

    labelList order;
    sortedOrder(id, order);

    particles.resizeHistory(history.empty() ? 0 : 1 + 3*history.size());
    particles.resize(size);

    forAll(order, i)
    {
        const label k = order[i];

        if (i && id[k] == id[order[i-1]])
        {
            FatalIOErrorInFunction(state)
                << "The particle of id " << id[k] << " is there twice in the"
                << " files " << place().c_str()
                << exit(FatalIOError);
        }

        particles.id(i) = id[k];
        particles.primaries(i) = primaries[k];
        particles.d(i) = d[k];
        particles.m(i) = mass[k];

        for (direction cmpt = 0; cmpt < vector::nComponents; ++cmpt)
        {
            particles.x(cmpt, i) = position[k][cmpt];
            particles.v(cmpt, i) = U[k][cmpt];
            particles.thermal(cmpt, i) = UBrownian[k][cmpt];

            forAll(history, j)
            {
                particles.history(1 + 3*j + cmpt, i) = history[j][k][cmpt];
            }
        }

        if (history.size())
        {
            particles.history(0, i) = step[k];
        }

        for (direction cmpt = 0; i < frame.x.cols() && cmpt < 3; ++cmpt)
        {
            frame.x(cmpt, i) = framePosition[k][cmpt];
            frame.v(cmpt, i) = frameU[k][cmpt];
        }
    }

    return state;
}


void Foam::aerosol::cloudFiles::write
(
    const particleArrays& p,
    const dictionary& state,
    const inFrame& frame
) const
{
    for (int i = 0; i < p.size(); ++i)
    {
        if
        (
            p.id(i) < 0
         || p.id(i) > labelMax
         || p.primaries(i) > labelMax
        )
        {
            FatalErrorInFunction
                << "Particle " << std::to_string(p.id(i)).c_str()
                << " of "
                << std::to_string(p.primaries(i)).c_str()
                << " primaries cannot be written:"
                << " with the labels of this OpenFOAM, both numbers must be"
                << " within 0 and " << labelMax
                << exit(FatalError);
        }
    }

    const List<tetIndices> places(locate(p.x));
    const labelList mine(this->mine(p, places));

    // The counter is common to all clouds of the program: not ours to advance
    const label counter = particle::particleCount_;

    for (const label i : mine)
    {
        const tetIndices& place = places[i];

        auto onDisk = autoPtr<passiveParticle>::New
        (
            mesh_,
            place.tet(mesh_).pointToBarycentric(column(p.x, i)),
            place.cell(),
            place.face(),
            place.tetPt()
        );

        onDisk->origId() = label(p.id(i));
        onDisk->origProc() = 0;

        cloud_->addParticle(onDisk.ptr());
    }

    particle::particleCount_ = counter;

    const allDigits asText;

    // A rank without particles writes no files; those of an earlier run with
    // the same time would be taken for its own
    removeIfEmpty(mine.empty());

    const Time& runTime = mesh_.time();

    bool ok = writeObject
    (
        *cloud_,
        runTime.writeFormat(),
        runTime.writeCompression(),
        !mine.empty()
    );

    cloud_->clear();

    ok &= writeField<label>("id", mine, [&](label i) { return p.id(i); });
    ok &= writeField<label>
    (
        "primaries", mine, [&](label i) { return p.primaries(i); }
    );
    ok &= writeField<scalar>("d", mine, [&](label i) { return p.d(i); });
    ok &= writeField<scalar>("mass", mine, [&](label i) { return p.m(i); });
    ok &= writeField<vector>
    (
        "position", mine, [&](label i) { return column(p.x, i); }
    );
    ok &= writeField<vector>
    (
        "U", mine, [&](label i) { return column(p.v, i); }
    );

    const bool thermal =
        p.thermal.size() && p.thermal.cwiseAbs().maxCoeff() > 0;

    if (thermal)
    {
        ok &= writeField<vector>
        (
            "UBrownian", mine, [&](label i) { return column(p.thermal, i); }
        );
    }
    else
    {
        remove("UBrownian");
    }

    if (frame.x.cols())
    {
        ok &= writeField<vector>
        (
            "framePosition", mine, [&](label i) { return column(frame.x, i); }
        );
        ok &= writeField<vector>
        (
            "frameU", mine, [&](label i) { return column(frame.v, i); }
        );
    }
    else
    {
        remove("framePosition");
        remove("frameU");
    }

    if (p.history.rows())
    {
        ok &= writeField<scalar>
        (
            "historyStep", mine, [&](label i) { return p.history(0, i); }
        );

        for (int j = 0; 1 + 3*j < p.history.rows(); ++j)
        {
            ok &= writeField<vector>
            (
                historyName(j),
                mine,
                [&](label i)
                {
                    const auto numbers = p.history.col(i).segment<3>(1 + 3*j);

                    return vector(numbers(0), numbers(1), numbers(2));
                }
            );
        }
    }
    else
    {
        remove("historyStep");
    }

    const int histories = (p.history.rows() + 1)/3;

    // Left by a run that remembered more
    for (int j = histories; remove(historyName(j)); ++j)
    {}

    // Last: what it describes is complete
    dictionary whole(state);
    whole.set("UBrownian", Switch(thermal));
    whole.set("histories", label(histories));
    whole.set("frame", Switch(frame.x.cols() > 0));
    ok &= writeState(whole, p.size());

    if (!returnReduce(ok, andOp<bool>()))
    {
        FatalErrorInFunction
            << "The cloud " << cloud_->name() << " could not be written to "
            << runTime.timePath() << "; is the disk full?"
            << exit(FatalError);
    }
}


void Foam::aerosol::cloudFiles::requireExact(const Time& runTime)
{
    if
    (
        runTime.writeFormat() == IOstream::ASCII
     && IOstream::defaultPrecision() < 16
    )
    {
        const dictionary& dict = runTime.controlDict();
        const entry* precision = dict.findEntry("writePrecision");

        // The line of the entry, if there is one
        FatalIOError
        (
            FUNCTION_NAME,
            __FILE__,
            __LINE__,
            dict.name(),
            precision ? precision->startLineNumber() : dict.startLineNumber(),
            precision ? precision->endLineNumber() : dict.endLineNumber()
        )
            << "writePrecision " << IOstream::defaultPrecision()
            << " with writeFormat ascii moves particles at each restart. Use"
            << nl << "    writeFormat     binary;" << nl
            << "or" << nl << "    writePrecision  16;    // or more"
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
