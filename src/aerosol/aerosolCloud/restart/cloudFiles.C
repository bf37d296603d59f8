/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cloudFiles.H"

#include "allDigits.H"
#include "cellPlaces.H"
#include "foamVersion.H"
#include "IOdictionary.H"
#include "IOField.H"
#include "ListOps.H"
#include "Pstream.H"
#include "Time.H"
#include "passiveParticleCloud.H"
#include "polyMesh.H"
#include "restartableTime.H"
#include "stateDictionary.H"

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


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::cloudFiles::cloudFiles
(
    const polyMesh& mesh,
    const word& cloudName
)
:
    mesh_(mesh),
    cloud_(newEmptyCloud<passiveParticleCloud>(mesh, cloudName)),
    fields_(mesh, *cloud_)
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


void Foam::aerosol::cloudFiles::requireNoneBefore() const
{
    const Time& runTime = mesh_.time();

    const auto has = [&](const instant& time)
    {
        return !fileHandler().filePath
        (
            runTime.path()/time.name()/"uniform"/(cloud_->name() + "State")
        ).empty();
    };

    for (const instant& time : runTime.times())
    {
        if
        (
            time.value() < runTime.value() - 0.5*runTime.deltaTValue()
         && has(time)
        )
        {
            FatalErrorInFunction
                << "Time " << runTime.timeName() << " has no particles, but"
                << " time " << time.name() << " has. The run was interrupted"
                << " while it wrote; remove " << runTime.timePath()
                << " to continue from an earlier time"
                << exit(FatalError);
        }
    }
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

    const Field<label> id(fields_.read<label>("id", sizes));

    if (id.size() != size)
    {
        FatalIOErrorInFunction(state)
            << "There were " << size << " particles, but the files 'id' "
            << fields_.place().c_str() << " have " << id.size() << " values"
            << exit(FatalIOError);
    }

    const Field<label> primaries(fields_.read<label>("primaries", sizes));
    const Field<scalar> d(fields_.read<scalar>("d", sizes));
    const Field<scalar> mass(fields_.read<scalar>("mass", sizes));
    const Field<vector> position(fields_.read<vector>("position", sizes));
    const Field<vector> U(fields_.read<vector>("U", sizes));

    fields_.requirePositive("primaries", primaries);
    fields_.requirePositive("d", d);
    fields_.requirePositive("mass", mass);

    // Files that are there only with Brownian motion, or unsteady drag; others
    // may be left from an earlier run
    const Field<vector> UBrownian
    (
        state.getOrDefault("UBrownian", false)
      ? fields_.read<vector>("UBrownian", sizes)
      : Field<vector>(size, Zero)
    );

    List<Field<vector>> history(state.getOrDefault<label>("histories", 0));
    Field<scalar> step;

    if (history.size())
    {
        step = fields_.read<scalar>("historyStep", sizes);

        forAll(history, j)
        {
            history[j] = fields_.read<vector>(historyName(j), sizes);
        }
    }

    Field<vector> framePosition;
    Field<vector> frameU;

    if (state.getOrDefault("frame", false))
    {
        framePosition = fields_.read<vector>("framePosition", sizes);
        frameU = fields_.read<vector>("frameU", sizes);
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
                << " files " << fields_.place().c_str()
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

    const cellPlaces places(mesh_, p);
    const labelList& mine = places.mine();

    // The counter is common to all clouds of the program: not ours to advance
    const label counter = particle::particleCount_;

    for (const label i : mine)
    {
        const tetIndices& place = places[i];

        auto onDisk = autoPtr<passiveParticle>::New
        (
            mesh_,
            place.tet(mesh_).pointToBarycentric
            (
                cellPlaces::position(p, i)
            ),
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
    fields_.removeIfEmpty(mine.empty());

    const Time& runTime = mesh_.time();

    bool ok = writeObject
    (
        *cloud_,
        runTime.writeFormat(),
        runTime.writeCompression(),
        !mine.empty()
    );

    cloud_->clear();

    ok &= fields_.write<label>("id", mine, [&](label i) { return p.id(i); });
    ok &= fields_.write<label>
    (
        "primaries", mine, [&](label i) { return p.primaries(i); }
    );
    ok &= fields_.write<scalar>("d", mine, [&](label i) { return p.d(i); });
    ok &= fields_.write<scalar>("mass", mine, [&](label i) { return p.m(i); });
    ok &= fields_.write<vector>
    (
        "position", mine, [&](label i) { return column(p.x, i); }
    );
    ok &= fields_.write<vector>
    (
        "U", mine, [&](label i) { return column(p.v, i); }
    );

    const bool thermal =
        p.thermal.size() && p.thermal.cwiseAbs().maxCoeff() > 0;

    if (thermal)
    {
        ok &= fields_.write<vector>
        (
            "UBrownian", mine, [&](label i) { return column(p.thermal, i); }
        );
    }
    else
    {
        fields_.remove("UBrownian");
    }

    if (frame.x.cols())
    {
        ok &= fields_.write<vector>
        (
            "framePosition", mine, [&](label i) { return column(frame.x, i); }
        );
        ok &= fields_.write<vector>
        (
            "frameU", mine, [&](label i) { return column(frame.v, i); }
        );
    }
    else
    {
        fields_.remove("framePosition");
        fields_.remove("frameU");
    }

    if (p.history.rows())
    {
        ok &= fields_.write<scalar>
        (
            "historyStep", mine, [&](label i) { return p.history(0, i); }
        );

        for (int j = 0; 1 + 3*j < p.history.rows(); ++j)
        {
            ok &= fields_.write<vector>
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
        fields_.remove("historyStep");
    }

    const int histories = (p.history.rows() + 1)/3;

    // Left by a run that remembered more
    for (int j = histories; fields_.remove(historyName(j)); ++j)
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
