/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aerosolCloud.H"
#include "checkedDictionary.H"
#include "describe.H"
#include "sameContents.H"
#include "fvMesh.H"
#include "particleSource.H"
#include "Time.H"
#include "eigenVector.H"
#include "writtenFiles.H"

#include <algorithm>
#include <iomanip>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(aerosolCloud, 0);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::aerosolCloud::aerosolCloud
(
    const word& name,
    const dictionary& dict,
    const fvMesh& mesh,
    acoustics::soundField& sound
)
:
    regIOobject
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            "uniform",
            mesh.time(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    dict_(requireKnownModels(dict)),
    domain_(domainInMesh(dict_.subDict("domain"), mesh)),
    sound_(sound, optionalDict(dict_, "turbulence"), *domain_),
    decomposition_(*domain_),
    motion_
    (
        dict_,
        sound.gas(),
        domain_->period(),
        {sound.frequency(), sound.expectedAmplitude()}
    ),
    collisions_(dict_, motion_.laws().aggregateModel()),
    setupCheck_(dict_, mesh.time(), *domain_, sound_, motion_, collisions_),
    fragmentation_(optionalDict(dict_, "breakage")),
    timeStepping_
    (
        timeStepping::New
        (
            dict_.subDict("timeStepping"),
            {sound_, *domain_, motion_, collisions_}
        )
    ),
    files_(mesh, name),
    reportsContacts_
    (
        optionalDict(dict_, "report").getOrDefault<Switch>
        (
            "contacts",
            false
        )
    ),
    reportsBreakages_
    (
        optionalDict(dict_, "report").getOrDefault<Switch>
        (
            "breakages",
            false
        )
    ),
    interval_
    (
        readPositive
        (
            optionalDict(dict_, "report"),
            "interval",
            dimTime,
            sound.frequency() > 0
          ? 1/sound.frequency()
          : 100*mesh.time().deltaTValue()
        )
    ),
    nextRow_(0),
    patience_
    (
        readNonNegative
        (
            mesh.time().controlDict(),
            "reportInterval",
            dimTime,
            5
        )
    ),
    step_(0),
    outgrown_(false),
    isNew_(true),
    wasCoupled_(false),
    reached_(mesh.time().value()),
    amplitude_(-1),
    largestAmplitude_(0)
{
    cloudFiles::requireExact(mesh_.time());

    timeStepping_->onProgress([this](const scalar share) { report(share); });

    if
    (
        fragmentation_.active()
     && (
            dict_.subDict("contact").get<word>("type") == "none"
         || dict_.subDict("aggregate").get<word>("type") == "none"
        )
    )
    {
        WarningInFunction
            << "Nothing sticks, by 'contact' or 'aggregate': there will be no"
            << " new aggregates for 'breakage' to break, and no impacts that"
            << " break any" << endl;
    }

    collisions_.breakBy(fragmentation_.model());

    if (reportsContacts_)
    {
        collisions_.keepRecords();
    }
    if (reportsBreakages_)
    {
        fragmentation_.keepRecords();
    }

    isNew_ = !files_.found();

    if (isNew_)
    {
        prepareFrame(dictionary());
        makeParticles();
        applyLaws(dictionary());
        setupCheck_.requireRanges(particles_);
    }
    else
    {
        const dictionary state = readParticles();

        applyLaws(state);
        checkGrowth();
    }

    Info<< summary().c_str() << nl << models().c_str() << nl;
    setupCheck_.report(particles_);
    Info<< endl;

    // Up to here every rank has all of them
    decomposition_.keepOwn(particles_);
    cellGrid::sort(particles_);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::wordList& Foam::aerosol::aerosolCloud::modelNames()
{
    static const wordList names
    ({
        "domain", "particles", "timeStepping", "drag", "unsteadyDrag",
        "gravity", "wake", "Brownian", "contact", "aggregate", "breakage",
        "report", "frame", "coupling", "turbulence"
    });

    return names;
}


const Foam::dictionary& Foam::aerosol::aerosolCloud::requireKnownModels
(
    const dictionary& dict
)
{
    if (dict.found("carried"))
    {
        FatalIOErrorInFunction(dict.optionalSubDict("carried"))
            << "Dictionary 'carried' is named 'frame' now: rename it"
            << exit(FatalIOError);
    }

    requireDictionaries(dict, modelNames());

    requireOnly
    (
        optionalDict(dict, "report"),
        {"interval", "sizeBins", "contacts", "breakages"}
    );

    return dict;
}


Foam::autoPtr<Foam::aerosol::domain>
Foam::aerosol::aerosolCloud::domainInMesh
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    autoPtr<domain> made(domain::New(dict));

    const boundBox& box = made->bounds();
    const chamber room(mesh);

    if (!room.contains(box))
    {
        OStringStream where;

        if (room.bounds().contains(box))
        {
            const chamber::encounter wall = room.first(box, Zero);

            where << ". That is not of the shape of a box";
            if (wall.time == 0)
            {
                where << ": a part of its boundary, at " << wall.place
                    << ", lies in the domain";
            }
        }

        FatalIOErrorInFunction(dict)
            << "The domain of the particles, " << box.min() << " to "
            << box.max() << " m, leaves the mesh, which extends from "
            << room.bounds().min() << " to " << room.bounds().max() << " m"
            << where.str().c_str() << exit(FatalIOError);
    }

    return made;
}


Foam::dictionary Foam::aerosol::aerosolCloud::readParticles()
{
    cloudFiles::inFrame inFrame;
    const dictionary state = files_.read(particles_, inFrame);

    reached_ = state.getOrDefault<scalar>("reached", reached_);
    N0_ = state.get<label>("initialNumber");
    N0PM25_ = state.get<label>("initialNumberPM25");
    collisions_.setCount(state.get<label>("contacts"));
    collisions_.setRefusedPairs
    (
        state.getOrDefault<labelList>("refusedPairs", labelList())
    );
    sizeBins_ = state.subDict("sizeBins");
    wasCoupled_ = state.getOrDefault("coupled", false);

    // Before anything could break, ids were those of the start
    fragmentation_.begin
    (
        state.getOrDefault<label>("nextId", N0_),
        state.getOrDefault<label>("breakages", 0)
    );

    // A change of these would be ignored, or would move the particles
    const auto requireSame = [&](const word& name, const word& then)
    {
        const dictionary now = dict_.subOrEmptyDict(name);

        if (!sameContents(state.subOrEmptyDict(then), now))
        {
            FatalIOErrorInFunction(now)
                << "The dictionary '" << name << "' has changed since the"
                << " particles of time " << mesh_.time().timeName()
                << " were made. To begin anew, remove all times, and"
                << " lagrangian and uniform of the first one; to continue,"
                << " restore the dictionary"
                << exit(FatalIOError);
        }
    };

    requireSame("domain", "domainWas");
    requireSame("particles", "particlesWere");
    requireSame("frame", "frameWas");

    Info<< "Continuing with the " << particles_.size()
        << " particles of time " << mesh_.time().timeName() << nl;

    prepareFrame(state);

    // Of another frame, where the mean flow has changed
    const auto then = [&](const word& name)
    {
        return state.getOrDefault<scalar>(name, VGREAT);
    };
    const bool sameFrame =
        then("frameOrigin") == frame_->origin()
     && then("frameVelocityX") == frame_->velocity()(0)
     && then("frameVelocityY") == frame_->velocity()(1)
     && then("frameVelocityZ") == frame_->velocity()(2);

    if (inFrame.x.cols() && sameFrame)
    {
        particles_.x = inFrame.x;
        particles_.v = inFrame.v;
    }
    else
    {
        frame_->enter(particles_, reached_);
    }

    return state;
}


void Foam::aerosol::aerosolCloud::makeParticles()
{
    requireNoneBefore();

    const autoPtr<particleSource> source =
        particleSource::New(dict_.subDict("particles"));

    source->create(*domain_, particles_);

    if (source->followsGas())
    {
        sound_.velocity(mesh_.time().value(), particles_.x, particles_.v);
    }
    else
    {
        frame_->enter(particles_, reached_);
    }

    const aerosolStatistics initial(particles_);

    N0_ = initial.size;
    fragmentation_.begin(N0_, 0);
    N0PM25_ = initial.sizePM25;
    sizeBins_ = agglomerationTables::sizeBins
    (
        optionalDict(dict_, "report"),
        particles_.d
    );
}


void Foam::aerosol::aerosolCloud::requireNoneBefore() const
{
    const Time& runTime = mesh_.time();

    const auto has = [&](const instant& time)
    {
        return !fileHandler().filePath
        (
            runTime.path()/time.name()/"uniform"/(name() + "State")
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


void Foam::aerosol::aerosolCloud::prepareFrame(const dictionary& state)
{
    const scalar now = mesh_.time().value();
    const scalar start = state.getOrDefault<scalar>("began", now);

    frame_.reset
    (
        new movingFrame
        (
            optionalDict(dict_, "frame"), *domain_, chamber(mesh_), start
        )
    );

    if (frame_->domainMoves())
    {
        Info<< "The domain moves, and leaves the mesh at "
            << frame_->end() << " s, after " << frame_->end() - start
            << " s" << nl;
    }

    sound_.prepare(frame_->path());

    if (!domain_->representative() && frame_->domainMoves())
    {
        FatalIOErrorInFunction(dict_.subDict("domain"))
            << "A domain that moves cannot have a resolved sound: leave out"
            << " 'frame', or set 'sound' to representative"
            << exit(FatalIOError);
    }

    if (domain_->representative())
    {
        sound_.represent(domain_->bounds());

        // All go with the mean flow
        if (const auto mean = sound_.meanFlow())
        {
            const auto before = [&](const word& component)
            {
                return state.getOrDefault<scalar>(component, VGREAT);
            };
            const bool same =
                before("frameVelocityX") == (*mean)(0)
             && before("frameVelocityY") == (*mean)(1)
             && before("frameVelocityZ") == (*mean)(2);

            frame_->move
            (
                *mean,
                same ? state.get<scalar>("frameOrigin") : now
            );
        }
    }

    sound_.move(frame_->domainVelocity(), frame_->velocity(), start);
    requireNoShear();

    // The same after a restart, though a replay may know it better then
    amplitude_ =
        state.getOrDefault<scalar>("amplitude", sound_.amplitude(now));
    motion_.laws().setAmplitude(amplitude_);

    if (state.found("lastPeriod"))
    {
        const List<scalar> numbers(state.get<List<scalar>>("lastPeriod"));

        sound_.setLastPeriod({numbers.cbegin(), numbers.cend()});
    }

    if (state.found("gasWayX"))
    {
        sound_.setDisplacement
        ({
            state.get<scalar>("gasWayX"),
            state.get<scalar>("gasWayY"),
            state.get<scalar>("gasWayZ")
        });
    }
}


void Foam::aerosol::aerosolCloud::requireNoShear() const
{
    if (!domain_->representative() || sound_.frequency() > 0)
    {
        return;
    }

    const Eigen::Matrix3d gradient = sound_.gradient(mesh_.time().value());

    if (!gradient.isZero(0))
    {
        FatalIOErrorInFunction(dict_.subDict("domain"))
            << "The gas has a steady velocity gradient of " << gradient.norm()
            << " 1/s, and a periodic domain has not: the images of a particle"
            << " would have the velocity of the particle itself, not that of"
            << " the gas where they are. For rates of collision in a shear,"
            << " use 'turbulence' with its 'shearRate' in a gas that is"
            << " quiescent"
            << exit(FatalIOError);
    }
}


void Foam::aerosol::aerosolCloud::requirePeriodicSound(const scalar t)
{
    // Nine points of each face
    const boundBox& box = domain_->bounds();

    // Not that of the moment, if no level is expected
    largestAmplitude_ = std::max(largestAmplitude_, sound_.velocityAmplitude());
    const scalar amplitude =
        sound_.expectedAmplitude() >= 0 ? sound_.expectedAmplitude()
      : largestAmplitude_;

    for (direction k = 0; k < vector::nComponents; ++k)
    {
        vectors low(3, 9);
        vectors high(3, 9);

        for (int n = 0; n < 9; ++n)
        {
            vector place(0, 0, 0);
            place[(k + 1) % 3] = 0.1 + 0.4*(n % 3);
            place[(k + 2) % 3] = 0.1 + 0.4*(n/3);

            const point onLow = box.min() + cmptMultiply(place, box.span());

            low.col(n) = toEigen(onLow);
            high.col(n) = low.col(n);
            high(k, n) = box.max()[k];
        }

        vectors before, after;
        sound_.acoustics::localSound::velocity(t, low, before);
        sound_.acoustics::localSound::velocity(t, high, after);

        const scalar difference =
            (after - before).colwise().norm().maxCoeff();

        if (difference > 0.01*amplitude + 1e-9)
        {
            FatalIOErrorInFunction(dict_.subDict("domain"))
                << "At time " << mesh_.time().timeName() << " the gas at"
                << " opposite faces of the domain, normal to direction "
                << label(k) << ", differs by " << difference << " m/s, of a"
                << " velocity amplitude of " << amplitude << " m/s. With"
                << " 'sound resolved' it must be the same there, as in a box"
                << " from one wall at rest to another, or as long as whole"
                << " wavelengths: set 'sound' to representative"
                << exit(FatalIOError);
        }
    }
}


Foam::aerosol::particleArrays
Foam::aerosol::aerosolCloud::inChamber() const
{
    particleArrays all = decomposition::gather(particles_);

    frame_->leave(all, reached_);

    return all;
}


void Foam::aerosol::aerosolCloud::applyLaws(const dictionary& state)
{
    if (motion_.laws().wakeModel().needsTolerance())
    {
        // Aggregates of a restart would give another one
        if (state.found("wakeTolerance"))
        {
            motion_.laws().setTolerance(state.get<scalar>("wakeTolerance"));
        }
        else
        {
            motion_.laws().chooseTolerance(particles_);
        }
    }

    // Not that of the time: decomposePar makes none for a rank without fields
    step_ = state.getOrDefault<label>("step", mesh_.time().timeIndex());

    // If it is not known, a domain that moves is taken to move with it
    motion_.laws().setMeanFlow
    (
        sound_.meanFlow().value_or(Eigen::Vector3d::Zero())
    );
    setupCheck_.requireTolerance();
    takeHistory(state);
    motion_.laws().refresh(particles_);
}


void Foam::aerosol::aerosolCloud::takeHistory(const dictionary& state)
{
    const scalars& times = motion_.laws().unsteadyModel().times();

    const List<scalar> before
    (
        state.getOrDefault<List<scalar>>("historyTimes", List<scalar>())
    );

    bool same = before.size() == times.size() && !state.empty();

    for (int j = 0; same && j < times.size(); ++j)
    {
        same = mag(before[j] - times(j)) < 1e-4*times(j);
    }

    if (same)
    {
        return;
    }

    particles_.resizeHistory(0);

    if (!state.empty())
    {
        WarningInFunction
            << "The unsteady drag has changed since the particles of time "
            << mesh_.time().timeName() << " were written; it begins anew, as"
            << " if they had moved with the gas until now" << endl;
    }
}


void Foam::aerosol::aerosolCloud::checkGrowth()
{
    const scalar range = communicator::max
    (
        particles_.size()
      ? std::max
        (
            particles_.range.maxCoeff(),
            particles_.collisionDiameter.maxCoeff()
        )
      : 0.0
    );

    if (!outgrown_ && 2*range > domain_->bounds().minDim())
    {
        WarningInFunction
            << "At time " << mesh_.time().timeName() << " twice the range of"
            << " the wake, or of contact, of the largest aggregate, "
            << 2*range << " m, exceeds the shortest edge of the domain, "
            << domain_->bounds().minDim() << " m (it has grown, or 'wake' has"
            << " changed): its neighbours feel it together with its periodic"
            << " images from now on" << endl;

        outgrown_ = true;
    }
}


bool Foam::aerosol::aerosolCloud::left(const scalar t) const
{
    return t > frame_->end() + 1e-6*mesh_.time().deltaTValue();
}


bool Foam::aerosol::aerosolCloud::lastStep() const
{
    const Time& runTime = mesh_.time();
    const scalar now = runTime.value();
    const scalar h = runTime.deltaTValue();

    return now > runTime.endTime().value() - 0.5*h || left(now + h);
}


void Foam::aerosol::aerosolCloud::tabulate()
{
    const Time& runTime = mesh_.time();
    const scalar now = runTime.value();
    const bool first = runTime.timeIndex() == runTime.startTimeIndex();
    const bool end = runTime.writeTime() || lastStep();

    if (first || end || now > nextRow_ - 0.5*runTime.deltaTValue())
    {
        tables_->writeRow
        (
            now,
            aerosolStatistics(inChamber()),
            N0_,
            N0PM25_,
            domain_->volume(),
            collisions_.count()
        );

        // Rows at whole intervals, also after a restart
        const scalar reached = now + 0.5*runTime.deltaTValue();
        nextRow_ = interval_*(std::floor(reached/interval_ + 1e-6) + 1);
    }

    if (first || end)
    {
        tables_->writeSizes(now, decomposition::gather(particles_).d);
    }
}


void Foam::aerosol::aerosolCloud::announce()
{
    acoustics::soundField::vectors u;
    sound_.velocityAt
    (
        mesh_.time().value(), particles_.x, particles_.response, u
    );

    coupling_->announce(particles_, motion_, u, mesh_.time().deltaTValue());
}


Foam::dictionary Foam::aerosol::aerosolCloud::state() const
{
    dictionary dict;

    dict.add("step", label(step_));
    dict.add("initialNumber", N0_);
    dict.add("initialNumberPM25", N0PM25_);
    dict.add("contacts", label(collisions_.count()));
    dict.add("refusedPairs", collisions_.refusedPairs());
    dict.add("nextId", label(fragmentation_.nextId()));
    dict.add("breakages", label(fragmentation_.count()));
    dict.add("sizeBins", sizeBins_);
    dict.add("domainWas", dict_.subDict("domain"));
    dict.add("particlesWere", dict_.subDict("particles"));
    dict.add("frameWas", optionalDict(dict_, "frame"));
    dict.add("began", frame_->start());
    dict.add("reached", reached_);
    dict.add("amplitude", amplitude_);
    dict.add("frameOrigin", frame_->origin());
    dict.add("frameVelocityX", frame_->velocity()(0));
    dict.add("frameVelocityY", frame_->velocity()(1));
    dict.add("frameVelocityZ", frame_->velocity()(2));

    // Not yet at the start: there are no forces to go on from
    if (coupling_ && step_ > 0)
    {
        dict.add("coupled", Switch(true));
    }

    if (motion_.laws().wakeModel().needsTolerance())
    {
        dict.add("wakeTolerance", motion_.laws().wakeModel().tolerance());
    }

    if (motion_.unsteady().active())
    {
        const scalars& times = motion_.laws().unsteadyModel().times();

        List<scalar> list(times.size());
        std::copy(times.data(), times.data() + times.size(), list.begin());

        dict.add("historyTimes", list);
    }

    const std::vector<scalar> lastPeriod = sound_.lastPeriod();

    if (lastPeriod.size())
    {
        // As text, but with all digits
        const unsigned int precision = IOstream::defaultPrecision(17);

        List<scalar> list(lastPeriod.size());
        std::copy(lastPeriod.cbegin(), lastPeriod.cend(), list.begin());
        dict.add("lastPeriod", list);

        IOstream::defaultPrecision(precision);
    }

    if (sound_.turbulent())
    {
        const Eigen::Vector3d displacement = sound_.displacement();

        // A vector would lose digits here
        dict.add("gasWayX", displacement(0));
        dict.add("gasWayY", displacement(1));
        dict.add("gasWayZ", displacement(2));
    }

    return dict;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::aerosolCloud::couple(gasReaction& reaction)
{
    const dictionary& dict = dict_.subDict("coupling");

    if (frame_->domainMoves())
    {
        FatalIOErrorInFunction(dict)
            << "A domain that moves stands for no part of the chamber:"
            << " coupling must be of type none"
            << exit(FatalIOError);
    }

    // Particles act where they are, and feel the gas at the centre
    const scalar longest = 0.05*sound_.gas().c/max(sound_.frequency(), SMALL);

    const scalar edge = cmptMax(domain_->bounds().span());

    if (domain_->representative() && edge > longest)
    {
        FatalIOErrorInFunction(dict_.subDict("domain"))
            << "A domain that acts on the gas, and is longer than "
            << longest << " m, a twentieth of the wavelength, must have a"
            << " resolved sound: its particles act on the gas where they"
            << " are, and must feel it there. Set 'sound' to resolved"
            << exit(FatalIOError);
    }

    coupling_.reset(new twoWayCoupling(dict, mesh_, *domain_, reaction));

    const scalar mass = communicator::sum(particles_.m.sum());
    const scalar gas = sound_.gas().rho*domain_->volume();

    std::ostringstream os;
    os  << name() << " acts on "
        << 100*coupling_->volume()/gSum(mesh_.V().field())
        << " % of the gas, with " << mass/gas << " times the mass of that";

    Info<< os.str().c_str() << nl;

    if (reaction.continued())
    {
        return;
    }

    if (wasCoupled_)
    {
        FatalErrorInFunction
            << "The particles of time " << mesh_.time().timeName() << " acted"
            << " on the gas, but the fields aerosolForce, aerosolInertia and"
            << " aerosolDebt of that time are not there. Go on from an earlier"
            << " time"
            << exit(FatalError);
    }

    announce();
}


void Foam::aerosol::aerosolCloud::begin()
{
    if (isNew_)
    {
        requireFolder(time().timePath()/"lagrangian"/name());
        requireFolder(time().timePath()/"uniform"/"lagrangian"/name());

        // ParaView finds a cloud only if it is there from the first time on
        write();
    }

    tables_.reset
    (
        new agglomerationTables
        (
            mesh_, sizeBins_, reportsContacts_, name(), reportsBreakages_
        )
    );
    tabulate();
}


void Foam::aerosol::aerosolCloud::evolve()
{
    const scalar end = mesh_.time().value();
    const scalar h = mesh_.time().deltaTValue();

    if (left(end))
    {
        return;
    }

    reported_ = clock::now();

    sound_.follow(end - h, h);

    if (!domain_->representative())
    {
        requirePeriodicSound(end);
    }

    if (coupling_)
    {
        timeStepping_->migrate(particles_);
        coupling_->before(particles_, h);
    }

    ++step_;
    reached_ = end;

    timeStepping_->advance(particles_, {step_, end - h, h});

    if (coupling_)
    {
        domain_->confine(particles_.x);
        coupling_->after(particles_);
    }

    const bool broken = fragmentation_.apply
    (
        particles_,
        collisions_.takeImpacts(),
        motion_,
        sound_,
        *domain_,
        end,
        h,
        step_
    );

    if (coupling_)
    {
        domain_->confine(particles_.x);
        announce();
    }

    if (coupling_ || broken || mesh_.time().writeTime())
    {
        timeStepping_->migrate(particles_);
    }

    checkGrowth();

    tables_->writeContacts(collisions_.takeRecords());
    tables_->writeBreakages(fragmentation_.takeRecords());
    tabulate();
}


std::string Foam::aerosol::aerosolCloud::summary() const
{
    const scalar volume = domain_->volume();

    std::ostringstream os;

    os  << "Aerosol: " << particles_.size() << " particles in " << volume
        << " m3, " << particles_.size()/volume << " per m3, diameters "
        << particles_.d.minCoeff() << " to " << particles_.d.maxCoeff()
        << " m, mass concentration " << particles_.m.sum()/volume << " kg/m3";

    return os.str();
}


std::string Foam::aerosol::aerosolCloud::models() const
{
    std::ostringstream os;
    std::string without;

    os  << "Models";

    for (const word& name : modelNames())
    {
        if (dict_.isDict(name))
        {
            os  << "\n    " << std::left << std::setw(13) << name
                << describe(dict_.subDict(name));
        }
        else
        {
            without += ' ' + name;
        }
    }

    if (!without.empty())
    {
        os  << "\n    by default:" << without;
    }

    return os.str();
}


void Foam::aerosol::aerosolCloud::report(const scalar share)
{
    const clock::time_point now = clock::now();

    if
    (
        Pstream::master()
     && std::chrono::duration<scalar>(now - reported_).count() > patience_
    )
    {
        Info<< name() << ": " << label(100*share)
            << " % of the fluid step to " << mesh_.time().timeName() << " s"
            << endl;

        reported_ = now;
    }
}


std::string Foam::aerosol::aerosolCloud::progress() const
{
    std::ostringstream os;

    const scalar n = communicator::sum(particles_.size());

    os  << n << " of " << N0_
        << " particles left, agglomeration efficiency "
        << 100*(1 - n/N0_) << " %, "
        << collisions_.count() << " contacts";

    if (fragmentation_.active())
    {
        os  << ", " << fragmentation_.count() << " breakages";
    }

    if (left(mesh_.time().value()))
    {
        os  << "; left the mesh at " << frame_->end() << " s";
    }

    return os.str();
}


std::string Foam::aerosol::aerosolCloud::effort() const
{
    const stepCounters& done = timeStepping_->counters();

    const scalar n = max(done.fluidSteps, 1.0);
    const scalar moved = communicator::sum(done.particleMoves);
    const scalar members = communicator::sum(done.clusterMembers);

    const scalar fluidStep = mesh_.time().deltaTValue();
    const scalar perFluid = done.particleSteps/n;

    std::ostringstream os;

    os  << "Steps, on average:\n    fluid     " << fluidStep << " s, "
        << moved/max(done.particleSteps, 1.0) << " particles, "
        << communicator::sum(done.wakePairs)/n << " wakes on particles, "
        << communicator::sum(done.contactPairs)/n << " pairs within reach";

    if (perFluid > 1)
    {
        os  << "\n    particle  " << fluidStep/perFluid << " s, "
            << moved/max(done.particleSteps, 1.0) << " particles";
    }

    if (done.collisionSteps > 0)
    {
        os  << "\n    collision " << fluidStep*n/done.collisionSteps << " s, "
            << communicator::sum(done.collisionPairs)
              /max(done.particleSteps, 1.0)
            << " candidate pairs";
    }

    if (members > 0)
    {
        os  << "\n    cluster   " << members/n
            << " particles in clusters, on average "
            << communicator::sum(done.clusterMoves)/members
            << " steps each";
    }

    return os.str();
}


bool Foam::aerosol::aerosolCloud::writeObject(WRITE_OBJECT_ARGUMENTS) const
{
    cloudFiles::inFrame inFrame;
    particleArrays all = decomposition::gather(particles_);

    if (frame_->moves())
    {
        inFrame.x = all.x;
        inFrame.v = all.v;
    }

    frame_->leave(all, reached_);
    files_.write(all, state(), inFrame);

    return true;
}


// ************************************************************************* //
