/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "aerosolCloud.H"
#include "checkedEntry.H"
#include "fvMesh.H"
#include "mathematicalConstants.H"
#include "particleSource.H"
#include "Time.H"
#include "vectorEntry.H"

#include <algorithm>
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
    domain_(domain::New(dict_.subDict("domain"))),
    sound_(sound, dict_.subOrEmptyDict("turbulence"), *domain_),
    bricks_(*domain_),
    motion_
    (
        dict_,
        sound.gas(),
        domain_->period(),
        {sound.frequency(), sound.expectedAmplitude()}
    ),
    contacts_(dict_),
    breakages_(dict_.subOrEmptyDict("breakage")),
    timeStepping_
    (
        timeStepping::New
        (
            dict_.subDict("timeStepping"),
            {sound_, *domain_, motion_, contacts_}
        )
    ),
    files_(mesh, name),
    reportsContacts_
    (
        dict_.subOrEmptyDict("report").lookupOrDefault<Switch>
        (
            "contacts",
            false
        )
    ),
    reportsBreakages_
    (
        dict_.subOrEmptyDict("report").lookupOrDefault<Switch>
        (
            "breakages",
            false
        )
    ),
    interval_
    (
        readPositive
        (
            dict_.subOrEmptyDict("report"),
            "interval",
            dimTime,
            sound.frequency() > 0
          ? 1/sound.frequency()
          : 100*mesh.time().deltaTValue()
        )
    ),
    nextRow_(0),
    step_(0),
    outgrown_(false),
    isNew_(true)
{
    cloudFiles::requireExact(mesh_.time());

    if
    (
        breakages_.active()
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

    contacts_.breakBy(breakages_.model());

    if (reportsContacts_)
    {
        contacts_.keepRecords();
    }
    if (reportsBreakages_)
    {
        breakages_.keepRecords();
    }

    isNew_ = !files_.found();

    if (isNew_)
    {
        prepareTravel(dictionary());
        makeParticles();
        applyLaws(dictionary());
        checkRanges();
    }
    else
    {
        const dictionary state = readParticles();

        prepareTravel(state);
        applyLaws(state);
        checkGrowth();
    }

    checkSound();
    reportSettling();
    checkBrownian();

    Info<< summary().c_str() << nl << rangesOfWakes().c_str() << endl;

    // Up to here every rank has all of them
    bricks_.keepOwn(particles_);
    searchGrid::sort(particles_);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dictionary& Foam::aerosol::aerosolCloud::requireKnownModels
(
    const dictionary& dict
)
{
    const wordList known
    ({
        "domain", "particles", "timeStepping", "drag", "unsteadyDrag",
        "gravity", "wake", "Brownian", "contact", "aggregate", "breakage",
        "report", "carried", "coupling", "turbulence"
    });

    // Other entries are variables of the user
    for (const entry& e : dict)
    {
        if (!e.isDict() && known.found(e.keyword()))
        {
            FatalIOErrorInFunction(dict)
                << "'" << e.keyword() << "' in line " << e.startLineNumber()
                << " must be a dictionary, such as " << e.keyword()
                << " { ... }" << exit(FatalIOError);
        }

        if
        (
            e.isDict()
         && e.keyword() != "FoamFile"
         && !known.found(e.keyword())
        )
        {
            FatalIOErrorInFunction(e.dict())
                << "Unknown dictionary '" << e.keyword() << "' in "
                << dict.name() << "; valid ones are " << known
                << exit(FatalIOError);
        }
    }

    requireOnly
    (
        dict.subOrEmptyDict("report"),
        {"interval", "sizeBins", "contacts", "breakages"}
    );

    return dict;
}


Foam::dictionary Foam::aerosol::aerosolCloud::readParticles()
{
    const dictionary state = files_.read(particles_);

    N0_ = state.get<label>("initialNumber");
    N0PM25_ = state.get<label>("initialNumberPM25");
    contacts_.setCount(state.get<label>("contacts"));
    contacts_.setRefusedPairs
    (
        state.lookupOrDefault<labelList>("refusedPairs", labelList())
    );
    sizeBins_ = state.subDict("sizeBins");

    // Before anything could break, ids were those of the start
    breakages_.begin
    (
        state.lookupOrDefault<label>("nextId", N0_),
        state.lookupOrDefault<label>("breakages", 0)
    );

    // A change of these would be ignored, or would move the particles
    const auto requireSame = [&](const word& name, const word& then)
    {
        const dictionary now = dict_.subOrEmptyDict(name);

        if (state.subOrEmptyDict(then).digest() != now.digest())
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
    requireSame("carried", "carriedWas");

    Info<< "Continuing with the " << particles_.size()
        << " particles of time " << mesh_.time().timeName() << nl;

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
        const scalar now = mesh_.time().value();

        sound_.velocity(now, particles_.x, particles_.v);
        travel_->leave(particles_, now);
    }

    const aerosolStatistics initial(particles_);

    N0_ = initial.size;
    breakages_.begin(N0_, 0);
    N0PM25_ = initial.sizePM25;
    sizeBins_ = agglomerationTables::sizeBins
    (
        dict_.subOrEmptyDict("report"),
        particles_.d
    );
}


void Foam::aerosol::aerosolCloud::requireNoneBefore() const
{
    const Time& runTime = mesh_.time();

    for (const instant& time : runTime.times())
    {
        if
        (
            time.value() < runTime.value() - 0.5*runTime.deltaTValue()
         && isFile(runTime.path()/time.name()/"uniform"/(name() + "State"))
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


void Foam::aerosol::aerosolCloud::prepareTravel(const dictionary& state)
{
    const boundBox& box = domain_->bounds();
    const boundBox chamber(mesh_.points(), true);
    const scalar start =
        state.lookupOrDefault<scalar>("began", mesh_.time().value());

    if (!chamber.contains(box))
    {
        FatalIOErrorInFunction(dict_.subDict("domain"))
            << "The domain of the particles, " << box.min() << " to "
            << box.max() << " m, leaves the mesh, which extends from "
            << chamber.min() << " to " << chamber.max() << " m"
            << exit(FatalIOError);
    }

    travel_.reset
    (
        new travel(dict_.subOrEmptyDict("carried"), box, chamber, start)
    );

    if (travel_->active())
    {
        Info<< "Carried along; the domain leaves the mesh at "
            << travel_->end() << " s, after " << travel_->end() - start
            << " s" << nl;
    }

    sound_.prepare(travel_->path());
    sound_.move(travel_->velocity(), start);

    if (state.found("gasWay"))
    {
        sound_.setWay(acoustics::toEigen(state.get<vector>("gasWay")));
    }
}


void Foam::aerosol::aerosolCloud::applyLaws(const dictionary& state)
{
    if (motion_.wakeModel().needsTolerance())
    {
        // Aggregates of a restart would give another one
        if (state.found("wakeTolerance"))
        {
            motion_.setTolerance(state.get<scalar>("wakeTolerance"));
        }
        else
        {
            motion_.chooseTolerance(particles_);
        }
    }

    // Not that of the time: decomposePar makes none for a rank without fields
    step_ = state.lookupOrDefault<label>("step", mesh_.time().timeIndex());

    checkTolerance();
    takeHistory(state);
    motion_.refresh(particles_);
}


void Foam::aerosol::aerosolCloud::takeHistory(const dictionary& state)
{
    const scalars& times = motion_.unsteady().times();

    const List<scalar> before
    (
        state.lookupOrDefault<List<scalar>>("historyTimes", List<scalar>())
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


void Foam::aerosol::aerosolCloud::checkTolerance() const
{
    const wake& model = motion_.wakeModel();
    const dictionary& dict = dict_.subDict("wake");

    const char* const remedy =
        "give 'range', a number of diameters of the source, in this dictionary";

    if
    (
        (model.needsTolerance() || model.tolerance() > 0)
     && sound_.frequency() > 0
     && sound_.expectedAmplitude() < 0
    )
    {
        FatalIOErrorInFunction(dict)
            << "The range of the wakes cannot be worked out from a tolerance:"
            << " the velocity amplitude of the sound is not known. Give its"
            << " expected level, 'SPL' or 'velocityAmplitude', in"
            << " constant/acousticProperties, or " << remedy
            << exit(FatalIOError);
    }

    if
    (
        model.needsTolerance()
     && (model.tolerance() <= 0 || model.tolerance() > 0.1*GREAT)
    )
    {
        FatalIOErrorInFunction(dict)
            << "The range of the wakes has no default: without sound it comes"
            << " from the settling speed of the particles, which is"
            << (model.tolerance() > 0 ? " unlimited without drag" : " zero")
            << ": " << remedy
            << exit(FatalIOError);
    }
}


std::string Foam::aerosol::aerosolCloud::rangesOfWakes() const
{
    std::ostringstream os;

    if (!motion_.hasWakes() || !particles_.size())
    {
        return os.str();
    }

    const wake& model = motion_.wakeModel();
    const int n = particles_.size();

    scalars range = particles_.range;
    std::sort(range.data(), range.data() + n);

    os  << "Wakes act up to " << 1e6*range(0) << " um (smallest), "
        << 1e6*range(n/2) << " um (median), " << 1e6*range(n - 1)
        << " um (largest range);\n    "
        << 4.0/3*constant::mathematical::pi*range.cube().sum()/domain_->volume()
        << " of them within reach of each particle; ";

    if (model.tolerance() > 0)
    {
        os  << "beyond, each is below the "
            << (model.needsTolerance() ? "default " : "") << "tolerance, "
            << model.tolerance() << " m/s"
            << (model.needsTolerance() || model.ends()
             ? ", or has no time to arise\n" : "\n");
    }
    else
    {
        os  << "a fixed number of diameters\n";
    }

    return os.str();
}


void Foam::aerosol::aerosolCloud::checkRanges() const
{
    const dictionary& dict = dict_.subDict("domain");
    const scalar shortest = domain_->bounds().minDim();

    // A particle must not feel a neighbour and its image at once
    const auto requireRange = [&]
    (
        const char* what,
        const scalar range,
        const char* remedy
    )
    {
        if (2*range > shortest)
        {
            FatalIOErrorInFunction(dict)
                << "The shortest edge of the domain, " << shortest
                << " m, is less than twice the largest " << what << ", "
                << range << " m: particles would meet a neighbour and its"
                << " periodic image at once. Make the domain larger or the "
                << what << " smaller" << remedy
                << exit(FatalIOError);
        }
    };

    requireRange("range of contact", particles_.collision.maxCoeff(), "");
    requireRange
    (
        "range of the wakes",
        particles_.range.maxCoeff(),
        motion_.wakeModel().tolerance() > 0
      ? ", by a larger 'tolerance' or by a fixed 'range' in the dictionary"
        " 'wake'"
      : ", by 'range' in the dictionary 'wake'"
    );
}


void Foam::aerosol::aerosolCloud::checkSound() const
{
    if (sound_.frequency() <= 0)
    {
        return;
    }

    const scalar steps =
        1/(sound_.frequency()*mesh_.time().deltaTValue());
    const scalar shortest = domain_->bounds().minDim();

    // Those that are carried along best and least move relative to each other
    const scalar omega = constant::mathematical::twoPi*sound_.frequency();
    const scalars tau = motion_.relaxationTime(particles_);
    const scalar s1 = min(omega*tau.minCoeff(), 1e8);
    const scalar s2 = min(omega*tau.maxCoeff(), 1e8);
    const scalar u12 =
        sound_.velocityAmplitude()*(s2 - s1)/sqrt((1 + s1*s1)*(1 + s2*s2));
    const scalar displacement = 2*u12/omega;
    const scalar layer = sqrt(2*sound_.gas().nu()/omega);

    std::ostringstream os;
    os  << "Fluid steps per period " << steps << " (k_f = " << 1/steps
        << ")\nRelative displacement of the smallest and the largest particle "
        << displacement << " m (peak to peak), Stokes layer " << layer
        << " m, shortest edge of the domain " << shortest << " m";

    Info<< os.str().c_str() << nl;

    if (steps < 20)
    {
        WarningInFunction
            << "With " << steps << " fluid steps per period the particles do"
            << " not see the sound as it is: use 20 at least, and 50 for"
            << " strategies other than eventDriven" << endl;
    }

    if
    (
        (contacts_.active() || motion_.hasWakes())
     && (shortest < displacement || shortest < 4*layer)
    )
    {
        WarningInFunction
            << "The domain is shorter than the relative displacement, "
            << displacement << " m, or than four Stokes layers, " << 4*layer
            << " m: particles meet periodic images that they would not meet"
            << " in the chamber, and agglomerate too fast" << endl;
    }
}


void Foam::aerosol::aerosolCloud::reportSettling() const
{
    if (!particles_.size() || particles_.rate.minCoeff() <= 0)
    {
        return;
    }

    const vectors speed =
        particles_.acceleration.array().rowwise()
       /particles_.rate.transpose();

    Eigen::Index i;
    const scalar fastest = speed.colwise().norm().maxCoeff(&i);

    if (fastest <= 0)
    {
        return;
    }

    const Time& time = mesh_.time();
    const scalar rest = time.endTime().value() - time.value();
    const Eigen::Array3d edges = acoustics::toEigen(domain_->bounds().span());

    std::ostringstream os;
    os  << "The fastest settles at " << fastest << " m/s: by " << rest*fastest
        << " m until the end, "
        << rest*(speed.col(i).array().abs()/edges).maxCoeff()
        << " times through the domain";

    Info<< os.str().c_str() << nl;
}


void Foam::aerosol::aerosolCloud::checkBrownian() const
{
    // Their noise of the step is known, and a bounce would have to reflect what
    // is left of it for both
    if (motion_.hasBrownian() && contacts_.bounces())
    {
        FatalIOErrorInFunction(dict_.subDict("contact"))
            << "Particles that bounce cannot have Brownian motion: set"
            << " 'Brownian' to none, or let them stick or pass"
            << exit(FatalIOError);
    }

    if (!motion_.hasBrownian() || !particles_.size())
    {
        return;
    }

    // Of two alike, relative to one another
    const scalars ways =
        Foam::sqrt(2.0)
       *motion_.reach(mesh_.time().deltaTValue(), particles_).x;

    Eigen::Index i;
    const scalar most = (ways/particles_.collision).maxCoeff(&i);

    Info<< "Brownian motion in a fluid step, of two alike relative to one"
        << " another: at most " << most << " diameters, at "
        << particles_.collision(i) << " m" << nl;

    if (most > 4)
    {
        WarningInFunction
            << "In one fluid step, particles of " << particles_.collision(i)
            << " m"
            << " stray by " << most << " of their diameters relative to one"
            << " another: eventDriven resolves up to four, and misses contacts"
            << " beyond. Reduce deltaT" << endl;
    }
}


void Foam::aerosol::aerosolCloud::checkGrowth()
{
    const scalar range = bricks::max
    (
        particles_.size()
      ? std::max(particles_.range.maxCoeff(), particles_.collision.maxCoeff())
      : 0.0
    );

    if (!outgrown_ && 2*range > domain_->bounds().minDim())
    {
        WarningInFunction
            << "At time " << mesh_.time().timeName() << " the largest aggregate"
            << " has grown so far that twice the range of its wake or its"
            << " diameter, " << range << " m, exceeds the shortest edge of the"
            << " domain: its neighbours feel it together with its periodic"
            << " images from now on" << endl;

        outgrown_ = true;
    }
}


bool Foam::aerosol::aerosolCloud::left(const scalar t) const
{
    return t > travel_->end() + 1e-6*mesh_.time().deltaTValue();
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
        const particleArrays all = bricks::gather(particles_);

        tables_->writeRow
        (
            now,
            aerosolStatistics(all),
            N0_,
            N0PM25_,
            domain_->volume(),
            contacts_.count()
        );

        // Rows at whole intervals, also after a restart
        nextRow_ = interval_*(std::floor(now/interval_ + 1e-6) + 1);
    }

    if (first || end)
    {
        tables_->writeSizes(now, bricks::gather(particles_).d);
    }
}


void Foam::aerosol::aerosolCloud::announce()
{
    acoustics::soundField::vectors u;
    sound_.velocity(mesh_.time().value(), particles_.x, u);

    coupling_->announce(particles_, motion_, u, mesh_.time().deltaTValue());
}


Foam::dictionary Foam::aerosol::aerosolCloud::state() const
{
    dictionary dict;

    dict.add("step", label(step_));
    dict.add("initialNumber", N0_);
    dict.add("initialNumberPM25", N0PM25_);
    dict.add("contacts", label(contacts_.count()));
    dict.add("refusedPairs", contacts_.refusedPairs());
    dict.add("nextId", label(breakages_.nextId()));
    dict.add("breakages", label(breakages_.count()));
    dict.add("sizeBins", sizeBins_);
    dict.add("domainWas", dict_.subDict("domain"));
    dict.add("particlesWere", dict_.subDict("particles"));
    dict.add("carriedWas", dict_.subOrEmptyDict("carried"));
    dict.add("began", travel_->start());

    if (motion_.wakeModel().needsTolerance())
    {
        dict.add("wakeTolerance", motion_.wakeModel().tolerance());
    }

    if (motion_.isUnsteady())
    {
        const scalars& times = motion_.unsteady().times();

        List<scalar> list(times.size());
        std::copy(times.data(), times.data() + times.size(), list.begin());

        dict.add("historyTimes", list);
    }

    if (sound_.turbulent())
    {
        const Eigen::Vector3d way = sound_.way();

        dict.add("gasWay", vector(way(0), way(1), way(2)));
    }

    return dict;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::aerosolCloud::couple(gasReaction& reaction)
{
    const dictionary& dict = dict_.subDict("coupling");

    if (travel_->active())
    {
        FatalIOErrorInFunction(dict)
            << "A domain that is carried along stands for no part of the"
            << " chamber: coupling must be of type none"
            << exit(FatalIOError);
    }

    coupling_.reset(new twoWayCoupling(dict, mesh_, *domain_, reaction));

    const scalar mass = bricks::sum(particles_.m.sum());
    const scalar gas = sound_.gas().rho*domain_->volume();

    std::ostringstream os;
    os  << name() << " acts on "
        << 100*coupling_->volume()/gSum(mesh_.V().field())
        << " % of the gas, with " << mass/gas << " times the mass of that";

    Info<< os.str().c_str() << nl;

    if (!reaction.continued())
    {
        announce();
    }
}


void Foam::aerosol::aerosolCloud::begin()
{
    if (isNew_)
    {
        // ParaView finds a cloud only if it is there from the first time on
        files_.write(bricks::gather(particles_), state());
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

    // In the mesh, others have to know where everybody is
    const bool settled = travel_->active() || coupling_;

    sound_.follow(end - h, h);

    travel_->enter(particles_, end - h);

    if (settled)
    {
        timeStepping_->settle(particles_);
    }

    if (coupling_)
    {
        coupling_->before(particles_, h);
    }

    ++step_;

    timeStepping_->advance
    (
        particles_,
        end - h,
        h,
        step_
    );

    if (coupling_)
    {
        domain_->confine(particles_.x);
        coupling_->after(particles_);
    }

    const bool broken = breakages_.apply
    (
        particles_,
        contacts_.takeImpacts(),
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

    if (settled || broken || mesh_.time().writeTime())
    {
        timeStepping_->settle(particles_);
    }

    travel_->leave(particles_, end);

    checkGrowth();

    tables_->writeContacts(contacts_.takeRecords());
    tables_->writeBreakages(breakages_.takeRecords());
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


std::string Foam::aerosol::aerosolCloud::progress() const
{
    std::ostringstream os;

    const scalar n = bricks::sum(particles_.size());

    os  << n << " of " << N0_
        << " particles left, agglomeration efficiency "
        << 100*(1 - n/N0_) << " %, "
        << contacts_.count() << " contacts";

    if (breakages_.active())
    {
        os  << ", " << breakages_.count() << " breakages";
    }

    if (left(mesh_.time().value()))
    {
        os  << "; left the mesh at " << travel_->end() << " s";
    }

    return os.str();
}


std::string Foam::aerosol::aerosolCloud::effort() const
{
    const timeStepping::effort& done = timeStepping_->done();

    const scalar n = max(done.fluidSteps, 1.0);
    const scalar moved = bricks::sum(done.particleMoves);
    const scalar members = bricks::sum(done.groupMembers);

    const scalar fluidStep = mesh_.time().deltaTValue();
    const scalar perFluid = done.particleSteps/n;

    std::ostringstream os;

    os  << "Steps, on average:\n    fluid     " << fluidStep << " s, "
        << moved/max(done.particleSteps, 1.0) << " particles, "
        << bricks::sum(done.wakePairs)/n << " wakes on particles, "
        << bricks::sum(done.contactPairs)/n << " pairs within reach";

    if (perFluid > 1)
    {
        os  << "\n    particle  " << fluidStep/perFluid << " s, "
            << moved/max(done.particleSteps, 1.0) << " particles";
    }

    if (done.collisionSteps > 0)
    {
        os  << "\n    collision " << fluidStep*n/done.collisionSteps << " s, "
            << bricks::sum(done.collisionPairs)/max(done.particleSteps, 1.0)
            << " pairs that may meet";
    }

    if (members > 0)
    {
        os  << "\n    groups    " << members/n
            << " particles in close company, moved "
            << bricks::sum(done.groupMoves)/members
            << " times in a step they meet in";
    }

    return os.str();
}


bool Foam::aerosol::aerosolCloud::writeObject(WRITE_OBJECT_ARGUMENTS) const
{
    particleArrays all = bricks::gather(particles_);

    // Between steps, some may be a little outside
    if (!travel_->active())
    {
        domain_->confine(all.x);
    }

    files_.write(all, state());

    return true;
}


// ************************************************************************* //
