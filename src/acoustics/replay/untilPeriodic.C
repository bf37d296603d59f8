/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "untilPeriodic.H"

#include "addToRunTimeSelectionTable.H"
#include "cellField.H"
#include "checkedDictionary.H"
#include "gasEntries.H"
#include "levelControl.H"
#include "selectModel.H"
#include "soundSources.H"
#include "volFields.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    defineTypeNameAndDebug(untilPeriodic, 0);
    addToRunTimeSelectionTable(soundField, untilPeriodic, dictionary);
}
}

const Foam::word Foam::acoustics::untilPeriodic::stateName("replay");


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::vectorField&
Foam::acoustics::untilPeriodic::solvedVelocity() const
{
    return mesh_.lookupObject<volVectorField>("U").primitiveField();
}


void Foam::acoustics::untilPeriodic::makeFlow
(
    const harmonicFlow::terms& terms
)
{
    flow_.reset(new harmonicFlow(mesh_, frequency(), terms));

    for (const boundBox& region : regions_)
    {
        flow_->prepare(region);
    }
}


void Foam::acoustics::untilPeriodic::endPeriod()
{
    // All terms: the change does not depend on what is left out
    change_.add(harmonicFlow::significant(sum_, 0));
    quality_.change = change_.ofAll();

    Info<< "Sound, period " << label(std::lround(sum_.end()*frequency()))
        << ": the velocity has changed by " << 100*change_.ofAll() << " %, "
        << 100*change_.ofMean() << " % by its mean" << endl;

    const auto* control = mesh_.cfindObject<levelControl>("levelControl");
    const bool periodic =
        change_.steady() && (!control || control->periodic());

    if (periodic || sum_.end() > startTime_ - 1e-6/frequency())
    {
        makeFlow(harmonicFlow::significant(sum_, harmonicTolerance_));

        Info<< "    The sound is "
            << (periodic ? "periodic" : "taken for periodic")
            << ": one more period is solved, and compared with its mean and "
            << flow_->nHarmonics() << " harmonics" << endl;

        comparison_ = replayComparison(sum_.end() + 1/frequency());
    }
}


void Foam::acoustics::untilPeriodic::compare()
{
    const scalar t = mesh_.time().value();

    comparison_.add(t, solvedVelocity(), *flow_, regions_.size());

    if (t > comparison_.end() - 1e-6/frequency())
    {
        handOver();
    }
}


void Foam::acoustics::untilPeriodic::handOver()
{
    const scalar amplitude = replayComparison::amplitude
    (
        mesh_.time().value(), frequency(), *flow_, regions_.size()
    );

    const scalar perCent = 100/max(amplitude, VSMALL);

    quality_.difference = comparison_.rms()/max(amplitude, VSMALL);

    Info<< "    Over the last period the replay differs from what was solved"
        << " by " << 100*quality_.difference << " % rms, and "
        << perCent*comparison_.largest()
        << " % at most, of the velocity amplitude of " << amplitude
        << " m/s" << nl
        << "    From here on the sound is replayed" << endl;

    quality_.warn();

    replaying_ = true;
    handOver_ = mesh_.time().value();

    if (!resolveEvery_)
    {
        // The solver and its fields
        solved_.reset(nullptr);

        // The thermodynamics leave their temperature behind
        if (auto* T = mesh_.getObjectPtr<volScalarField>("T"))
        {
            T->checkOut();
        }
    }

    state_.add("frequency", frequency(), true);
    state_.add("handOver", handOver_, true);
    state_.add("expectedAmplitude", expectedAmplitude_, true);
    state_.set("harmonics", flow_->nHarmonics());
    state_.set("gas", gasEntries(gas_));
    state_.set
    (
        "magnitudes", harmonicFlow::magnitudes(mesh_, flow_->inCells())
    );
    quality_.write(state_);
    state_.writeOpt() = IOobject::AUTO_WRITE;

    makeFields();
}


void Foam::acoustics::untilPeriodic::resume()
{
    Info<< "Sound, period "
        << label(std::lround((handOver_*frequency()) + resolveEvery_))
        << ": solved again" << endl;

    replaying_ = false;
    change_.clear();

    // A restart in between solves
    fields_.clear();
    flow_.reset();
    state_.writeOpt() = IOobject::NO_WRITE;
}


void Foam::acoustics::untilPeriodic::removeLeft() const
{
    // What an earlier run has left at the same time would be taken for a sound
    // that is replayed
    const fileName left = fileHandler().filePath
    (
        mesh_.time().timePath()/"uniform"/stateName
    );

    if (!left.empty())
    {
        fileHandler().rm(left);
    }
}


void Foam::acoustics::untilPeriodic::makeFields()
{
    const auto make =
        [this](const word& name, const vectorField& inCells)
        {
            volVectorField* field = cellField
            (
                name, mesh_, dimVelocity, inCells
            ).ptr();
            field->writeOpt() = IOobject::AUTO_WRITE;

            // A soundPressureLevel makes another one afterwards
            if (auto* other = mesh_.getObjectPtr<regIOobject>(name))
            {
                if (other->note() != cellFieldNote)
                {
                    WarningInFunction
                        << "The field " << name << " of a function object, as"
                        << " fieldAverage of U makes it, is replaced by that of"
                        << " the sound that is replayed. The function object"
                        << " must have ended by now (timeEnd): what it writes"
                        << " later cannot be replayed" << endl;
                }
                other->checkOut();
            }
            field->checkIn();
            return field;
        };

    const harmonicFlow::terms& terms = flow_->inCells();

    fields_.setSize(terms.size());
    forAll(terms, i)
    {
        fields_.set(i, make(harmonicFlow::name(i), terms[i]));
    }

    if (!solved_)
    {
        U_.reset(make("U", flow_->inCells(mesh_.time().value())));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::untilPeriodic::untilPeriodic
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    soundField
    (
        readPositive(dict.subDict("solve"), "frequency", dimless/dimTime)
    ),
    mesh_(mesh),
    startTime_
    (
        dict.found("startTime") ? readFinite(dict, "startTime", dimTime) : GREAT
    ),
    harmonicTolerance_
    (
        readPositive(dict, "harmonicTolerance", dimless, 1e-3)
    ),
    resolveEvery_(readInteger(dict, "resolveEvery", 0, 0)),
    state_
    (
        stateName,
        mesh,
        {"frequency", "handOver", "expectedAmplitude", "harmonics", "gas"},
        IOobject::NO_WRITE
    ),
    expectedAmplitude_(-1),
    sum_(frequency(), readInteger(dict, "harmonics", 5, 1, 100)),
    change_(mesh, readPositive(dict, "tolerance", dimless, 1e-3)),
    replaying_(state_.size()),
    handOver_(0)
{
    requireOnly
    (
        dict,
        {"type", "solve", "tolerance", "startTime", "harmonics",
         "harmonicTolerance", "resolveEvery"}
    );

    const scalar steps = 1/(frequency()*mesh.time().deltaTValue());
    if (resolveEvery_ && mag(steps - std::round(steps)) > 1e-5*steps)
    {
        FatalIOErrorInFunction(dict)
            << "A sound that is solved again goes on where it was in the"
            << " period: with resolveEvery the time step must fit the period,"
            << " which has " << steps << " of them" << exit(FatalIOError);
    }

    if (replaying_)
    {
        const scalar then =
            readPositive(state_, "frequency", dimless/dimTime);

        if (mag(then - frequency()) > 1e-9*frequency())
        {
            FatalIOErrorInFunction(dict)
                << "The sound was solved, and is replayed, at a frequency of "
                << then << " Hz; for another one, start anew"
                << exit(FatalIOError);
        }

        gas_ = gasProperties::read(state_.subDict("gas"));
        expectedAmplitude_ = state_.get<scalar>("expectedAmplitude");
        handOver_ = state_.get<scalar>("handOver");
        state_.writeOpt() = IOobject::AUTO_WRITE;

        makeFlow
        (
            harmonicFlow::read
            (
                mesh,
                mesh.time().timeName(),
                state_.get<label>("harmonics")
            )
        );
        harmonicFlow::requireSame
        (
            mesh, flow_->inCells(), state_.subOrEmptyDict("magnitudes")
        );
        quality_ = replayQuality::read(state_);

        Info<< "    replayed, as at the end of the last run: "
            << frequency() << " Hz, " << flow_->nHarmonics()
            << " harmonics with the fundamental" << endl;

        quality_.report();

        if (!resolveEvery_)
        {
            makeFields();
            return;
        }
    }

    const dictionary& solve = dict.subDict("solve");

    solved_ = selectModel<soundField>
    (
        solve,
        "sound",
        dictionaryConstructorTablePtr_,
        mesh,
        solve
    );

    if (!mesh.foundObject<volVectorField>("U"))
    {
        FatalIOErrorInFunction(solve)
            << "The sound " << solved_->type() << " is not solved on the mesh:"
            << " there is nothing to be saved by a replay"
            << exit(FatalIOError);
    }

    gas_ = solved_->gas();
    expectedAmplitude_ = solved_->expectedAmplitude();

    if (!dict.found("startTime"))
    {
        soundSources
        (
            mesh.lookupObject<volScalarField>("p"),
            mesh.lookupObject<volVectorField>("U")
        ).requirePeriod(frequency(), solve);
    }

    if (replaying_)
    {
        makeFields();
        return;
    }

    // The state at the start belongs to the first period
    sum_.add(mesh.time().value(), solvedVelocity());
}


Foam::acoustics::untilPeriodic::~untilPeriodic() = default;


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

bool Foam::acoustics::untilPeriodic::rests(const fvMesh& mesh)
{
    const auto* state = mesh.cfindObject<stateDictionary>(stateName);

    // At the very time of the hand-over the fields have just been solved
    return
        state
     && state->writeOpt() == IOobject::AUTO_WRITE
     && mesh.time().value()
      > state->get<scalar>("handOver") + 0.5*mesh.time().deltaTValue();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::untilPeriodic::velocityAmplitude() const
{
    return
        replaying_ ? flow_->largestAmplitude() : solved_->velocityAmplitude();
}


Foam::label Foam::acoustics::untilPeriodic::prepare(const boundBox& region)
{
    regions_.push_back(region);

    if (solved_)
    {
        solved_->prepare(region);
    }
    if (flow_)
    {
        flow_->prepare(region);
    }

    return regions_.size() - 1;
}


bool Foam::acoustics::untilPeriodic::feelsForces()
{
    WarningInFunction
        << "While the sound is replayed, the aerosol does not act on it"
        << (resolveEvery_ ? "" : ": set resolveEvery to solve it at times")
        << endl;

    return !solved_ || solved_->feelsForces();
}


void Foam::acoustics::untilPeriodic::advance()
{
    const scalar begin =
        mesh_.time().value() - mesh_.time().deltaTValue();
    const scalar rest = resolveEvery_/frequency();

    if
    (
        replaying_
     && resolveEvery_
     && begin > handOver_ + rest - 0.5*mesh_.time().deltaTValue()
    )
    {
        resume();
    }

    if (!replaying_)
    {
        solved_->advance();

        if (flow_)
        {
            compare();
        }
        else if (sum_.add(mesh_.time().value(), solvedVelocity()))
        {
            endPeriod();
        }

        if (!replaying_ && mesh_.time().writeTime())
        {
            removeLeft();
        }
    }
    else if (U_ && mesh_.time().writeTime())
    {
        U_->primitiveFieldRef() = flow_->inCells(mesh_.time().value());
        U_->correctBoundaryConditions();
    }
}


void Foam::acoustics::untilPeriodic::velocity
(
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    velocityIn(0, t, x, u);
}


void Foam::acoustics::untilPeriodic::velocityIn
(
    const label region,
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    if (replaying_)
    {
        flow_->velocity(region, t, x, u);
    }
    else
    {
        solved_->velocityIn(region, t, x, u);
    }
}


std::optional<Foam::acoustics::soundField::vectorPhasors>
Foam::acoustics::untilPeriodic::harmonics
(
    const label region,
    const Eigen::Vector3d& x
) const
{
    if (!replaying_)
    {
        return std::nullopt;
    }

    return flow_->harmonics(region, x);
}


// ************************************************************************* //
