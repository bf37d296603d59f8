/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "eventDriven.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "communicator.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(eventDriven, 0);
    addToRunTimeSelectionTable(timeStepping, eventDriven, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::eventDriven::eventDriven
(
    const dictionary& dict,
    const tools& with
)
:
    timeStepping(with),
    finder_
    (
        with.sound,
        with.region,
        with.motion,
        with.collisions,
        sampler_,
        relative_,
        wakes_,
        counters_,
        readFraction(dict, "resolution", 0.25)
    ),
    ahead_(with.sound, with.region, with.motion, finder_, counters_)
{
    requireOnly(dict, {"type", "resolution"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::eventDriven::advanceAll
(
    particleArrays& p,
    const fluidStep& step
)
{
    if (!begin(p, step))
    {
        return;
    }

    const auto common = ahead_.displacement(p, step);
    bool looks = common && !observed() && ahead_.tries();

    const auto list = [&]()
    {
        timeStepping::migrate(p);

        if (looks && !finder_.listLasting(p, step, ahead_.response()))
        {
            looks = false;
            ahead_.pause();
        }
        if (!looks)
        {
            finder_.list(p, step);
        }
    };

    const bool expired = communicator::max(finder_.expired()) > 0;

    if (expired)
    {
        list();
    }

    if (looks && finder_.skin().lasting())
    {
        bool begun = ahead_.begin(p, step);

        if (!begun && !expired)
        {
            list();
            begun = looks && ahead_.begin(p, step);
        }

        bool last = false;

        if (begun && advanceBusy(step, last))
        {
            if (last)
            {
                endLookAhead(p);
            }
            return;
        }

        if (begun)
        {
            endLookAhead(p);
        }
        else if (looks)
        {
            ahead_.pause();
        }
    }

    const bool contacts = with_.collisions.active();
    const stepGas gas = sampler_.whenAsked(p, step, true);

    stepEnd end;
    std::vector<char> absorbed;

    mover_.moveWithoutWakes(step, p, gas, end);

    const Eigen::Vector3d mean = common.value_or(mover_.meanDisplacement());

    finder_.findWakes(p, end, mean);
    wakes_.move(step.h, p, gas, true, end);

    // Also without contacts: the lists of wakes depend on the skins
    if (contacts || with_.motion.wakes().active())
    {
        const encounters found = finder_.find(p, end, mean, step.h);

        if (contacts)
        {
            absorbed = collide(p, gas, found, step, 0, end);
        }
    }
    else
    {
        finder_.move(mean);
    }

    end.accept(p);

    if (contacts)
    {
        finder_.update(p, absorbed, exchange_.returned());
    }
}


bool Foam::aerosol::eventDriven::advanceBusy
(
    const fluidStep& step,
    bool& last
)
{
    particleArrays& p = ahead_.busy();
    stepGas gas;
    stepEnd end;
    bool within;
    bool goesOn;

    {
        const communicator::alone here;

        gas = sampler_.whenAsked(p, step, true);
        mover_.moveWithoutWakes(step, p, gas, end);
        ahead_.beginStep(step, end);
        finder_.findWakes(ahead_.wakes(), p, end, ahead_.displacement());
        wakes_.move(step.h, p, gas, true, end);
        within = ahead_.within(end);
    }

    if (communicator::max(!within) > 0)
    {
        ahead_.abandonStep();
        return false;
    }

    {
        const communicator::alone here;
        std::vector<char> absorbed;

        if (with_.collisions.active())
        {
            absorbed = collide
            (
                p,
                gas,
                finder_.find
                (
                    ahead_.contacts(), p, end, ahead_.displacement(), step.h
                ),
                step,
                0,
                end
            );
        }

        end.accept(p);
        goesOn = ahead_.endStep(exchange_.returned(), absorbed);
    }

    last = communicator::max(!goesOn) > 0;

    return true;
}


void Foam::aerosol::eventDriven::endLookAhead(particleArrays& p)
{
    if (!ahead_.running())
    {
        return;
    }

    std::vector<int> returned;
    std::vector<char> absorbed;

    finder_.move(ahead_.end(p, returned, absorbed));

    if (with_.collisions.active())
    {
        with_.collisions.share();
        finder_.update(p, absorbed, returned);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::eventDriven::advance
(
    particleArrays& p,
    const fluidStep& step
)
{
    if (ahead_.running() && ahead_.expected(step))
    {
        bool last = false;

        if (advanceBusy(step, last))
        {
            count(step);

            if (last)
            {
                endLookAhead(p);
            }
            return;
        }
    }

    endLookAhead(p);
    advanceAll(p, step);
}


void Foam::aerosol::eventDriven::migrate(particleArrays& p)
{
    endLookAhead(p);
    timeStepping::migrate(p);

    // A restart knows nothing of the steps before, and gives the same bits
    ahead_.forget();
    finder_.forget();
}


Foam::aerosol::particleArrays
Foam::aerosol::eventDriven::now(const particleArrays& p) const
{
    particleArrays all = p;
    ahead_.bring(all);

    return all;
}


// ************************************************************************* //
