/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aerosolCloud.H"
#include "cellGrid.H"
#include "checkedDictionary.H"
#include "cloudModels.H"
#include "sameContents.H"
#include "fvMesh.H"
#include "particleSource.H"
#include "Time.H"
#include "writtenFiles.H"

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
    dict_(cloudModels::requireKnown(dict)),
    domain_(domainCheck::domainInMesh(dict_.subDict("domain"), mesh)),
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
    setupCheck_
    (
        dict_, mesh.time(), *domain_, sound_, motion_, collisions_, particles_
    ),
    domainCheck_
    (
        dict_, mesh.time(), *domain_, sound_, motion_, particles_
    ),
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
    tables_(optionalDict(dict_, "report"), mesh, sound.frequency()),
    log_(name, mesh.time()),
    step_(0),
    isNew_(true),
    wasCoupled_(false),
    reached_(mesh.time().value()),
    amplitude_(-1)
{
    cloudFiles::requireExact(mesh_.time());

    timeStepping_->onProgress
    (
        [this](const scalar share) { log_.report(share); }
    );

    if (fragmentation_.active())
    {
        cloudModels::warnOfIdle(dict_);
        timeStepping_->observe();
    }

    collisions_.breakBy(fragmentation_.model());

    if (tables_.contacts())
    {
        collisions_.keepRecords();
    }
    if (tables_.breakages())
    {
        fragmentation_.keepRecords();
    }

    isNew_ = !files_.found();

    if (isNew_)
    {
        prepareFrame(dictionary());
        makeParticles();
        applyLaws(dictionary());
        domainCheck_.refuse();
    }
    else
    {
        const dictionary state = readParticles();

        applyLaws(state);
        domainCheck_.warnOfGrowth();
    }

    Info<< cloudLog::summary(particles_, domain_->volume()).c_str() << nl
        << cloudModels::table(dict_).c_str() << nl;
    setupCheck_.report();
    Info<< endl;

    // Up to here every rank has all of them
    decomposition_.keepOwn(particles_);
    cellGrid::sort(particles_);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::aerosol::aerosolCloud::readParticles()
{
    cloudFiles::inFrame inFrame;
    const dictionary state = files_.read(particles_, inFrame);

    reached_ = state.getOrDefault<scalar>("reached", reached_);
    wasCoupled_ = state.getOrDefault("coupled", false);

    tables_.load(state);
    collisions_.load(state);
    fragmentation_.load(state);

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
    if (inFrame.x.cols() && frame_->isThatOf(state))
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
    files_.requireNoneBefore();

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

    tables_.start(particles_);
    fragmentation_.begin(particles_.size(), 0);
}


void Foam::aerosol::aerosolCloud::prepareFrame(const dictionary& state)
{
    const scalar now = mesh_.time().value();

    frame_.reset
    (
        new movingFrame
        (
            optionalDict(dict_, "frame"), *domain_, chamber(mesh_), now, state
        )
    );

    if (frame_->domainMoves())
    {
        Info<< "The domain moves, and leaves the mesh at "
            << frame_->end() << " s, after "
            << frame_->end() - frame_->start() << " s" << nl;
    }

    sound_.prepare(frame_->path());
    domainCheck_.requireAtRest(*frame_);

    if (domain_->representative())
    {
        sound_.represent(domain_->bounds());

        // All go with the mean flow
        if (const auto mean = sound_.meanFlow())
        {
            frame_->move(*mean, now, state);
        }
    }

    sound_.move(frame_->domainVelocity(), frame_->velocity(), frame_->start());
    domainCheck_.requireNoShear();

    // The same after a restart, though a replay may know it better then
    amplitude_ =
        state.getOrDefault<scalar>("amplitude", sound_.amplitude(now));
    motion_.laws().setAmplitude(amplitude_);

    sound_.load(state);
}


Foam::aerosol::particleArrays
Foam::aerosol::aerosolCloud::inChamber() const
{
    particleArrays all = decomposition::gather(timeStepping_->now(particles_));

    frame_->leave(all, reached_);

    return all;
}


void Foam::aerosol::aerosolCloud::applyLaws(const dictionary& state)
{
    motion_.laws().load(state, particles_);

    // Not that of the time: decomposePar makes none for a rank without fields
    step_ = state.getOrDefault<label>("step", mesh_.time().timeIndex());

    // If it is not known, a domain that moves is taken to move with it
    motion_.laws().setMeanFlow
    (
        sound_.meanFlow().value_or(Eigen::Vector3d::Zero())
    );
    setupCheck_.refuse();

    if (!motion_.laws().unsteadyModel().continues(state))
    {
        particles_.resizeHistory(0);

        if (!state.empty())
        {
            WarningInFunction
                << "The unsteady drag has changed since the particles of time "
                << mesh_.time().timeName() << " were written; it begins anew,"
                << " as if they had moved with the gas until now" << endl;
        }
    }

    motion_.laws().refresh(particles_);
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


void Foam::aerosol::aerosolCloud::tabulate(const bool last)
{
    if (tables_.due(last))
    {
        domainCheck_.warnOfGrowth();
        tables_.add
        (
            inChamber(),
            domain_->volume(),
            collisions_.count(),
            timeStepping_->counters(),
            last
        );
    }
}


void Foam::aerosol::aerosolCloud::announce()
{
    vectors x = particles_.x;
    domain_->confine(x);

    vectors u;
    sound_.velocityAt(mesh_.time().value(), x, particles_.response, u);

    coupling_->announce(particles_, motion_, u, mesh_.time().deltaTValue());
}


Foam::dictionary Foam::aerosol::aerosolCloud::state() const
{
    dictionary dict;

    dict.add("step", label(step_));
    dict.add("domainWas", dict_.subDict("domain"));
    dict.add("particlesWere", dict_.subDict("particles"));
    dict.add("frameWas", optionalDict(dict_, "frame"));
    dict.add("reached", reached_);
    dict.add("amplitude", amplitude_);

    // Not yet at the start: there are no forces to go on from
    if (coupling_ && step_ > 0)
    {
        dict.add("coupled", Switch(true));
    }

    tables_.save(dict);
    collisions_.save(dict);
    fragmentation_.save(dict);
    frame_->save(dict);
    motion_.laws().save(dict);
    sound_.save(dict);

    return dict;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::aerosolCloud::couple(gasReaction& reaction)
{
    domainCheck_.requireCoupling(*frame_);
    timeStepping_->observe();

    coupling_.reset
    (
        new twoWayCoupling
        (
            dict_.subDict("coupling"), mesh_, *domain_, reaction
        )
    );

    const scalar mass = communicator::sum(particles_.m.sum());
    const scalar gas = sound_.gas().rho*domain_->volume();

    std::ostringstream os;
    os  << name() << " acts on "
        << 100*coupling_->volume()/gSum(mesh_.V().field())
        << " % of the gas, with a mass loading of " << mass/gas;

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

    tables_.open(name(), isNew_);

    if (!left(mesh_.time().value()))
    {
        tabulate(lastStep());
    }
}


void Foam::aerosol::aerosolCloud::evolve()
{
    const scalar end = mesh_.time().value();
    const scalar h = mesh_.time().deltaTValue();

    if (left(end))
    {
        return;
    }

    log_.beginStep();

    costTable& cost = tables_.cost();
    using watch = costTable::watch;

    {
        const watch gas(cost, costTable::gas);
        sound_.follow(end - h, h);
    }

    domainCheck_.requirePeriodicSound(end);

    if (coupling_)
    {
        const watch coupling(cost, costTable::coupling);
        coupling_->before(particles_, h);
    }

    ++step_;
    reached_ = end;

    {
        const watch particles(cost, costTable::particles);
        timeStepping_->advance(particles_, {step_, end - h, h});
    }

    if (coupling_)
    {
        const watch coupling(cost, costTable::coupling);
        coupling_->after(particles_);
    }

    bool broken = false;
    {
        const watch breakages(cost, costTable::breakages);
        broken = fragmentation_.apply
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
    }

    if (coupling_)
    {
        const watch coupling(cost, costTable::coupling);
        announce();
    }

    if (broken || mesh_.time().writeTime())
    {
        const watch particles(cost, costTable::particles);
        timeStepping_->migrate(particles_);
    }

    tables_.add(collisions_.takeRecords(), fragmentation_.takeRecords());
    tabulate(lastStep());
}


void Foam::aerosol::aerosolCloud::end()
{
    if (tables_.lastRow() < reached_ - 0.5*mesh_.time().deltaTValue())
    {
        tabulate(true);
    }
}


std::string Foam::aerosol::aerosolCloud::progress() const
{
    std::ostringstream os;

    const scalar n = communicator::sum(particles_.size());

    os  << n << " of " << tables_.initialNumber()
        << " particles left, agglomeration efficiency "
        << 100*(1 - n/tables_.initialNumber()) << " %, "
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
    return cloudLog::effort
    (
        timeStepping_->counters(),
        mesh_.time().deltaTValue()
    );
}


bool Foam::aerosol::aerosolCloud::writeObject(WRITE_OBJECT_ARGUMENTS) const
{
    cloudFiles::inFrame inFrame;
    particleArrays all = decomposition::gather(timeStepping_->now(particles_));

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
