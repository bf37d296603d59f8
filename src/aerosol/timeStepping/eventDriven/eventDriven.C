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
    )
{
    requireOnly(dict, {"type", "resolution"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::eventDriven::advance
(
    particleArrays& p,
    const fluidStep& step
)
{
    if (!begin(p, step))
    {
        return;
    }

    if (communicator::max(finder_.expired()) > 0)
    {
        timeStepping::migrate(p);
        finder_.list(p, step);
    }

    const bool contacts = with_.collisions.active();
    const stepGas gas = sampler_.whenAsked(p, step, true);

    stepEnd end;
    std::vector<char> absorbed;

    mover_.moveWithoutWakes(step, p, gas, end);

    const Eigen::Vector3d& mean = mover_.meanDisplacement();

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

    end.accept(p);

    if (contacts)
    {
        finder_.update(p, absorbed, exchange_.returned());
    }
}


void Foam::aerosol::eventDriven::migrate(particleArrays& p)
{
    timeStepping::migrate(p);
    finder_.expire();
}


// ************************************************************************* //
