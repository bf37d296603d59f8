/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeStepping.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(timeStepping, 0);
    defineRunTimeSelectionTable(timeStepping, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Fluid steps after which particles that were close in memory are no longer so
//  in space
constexpr int sortInterval = 50;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::timeStepping::timeStepping(const tools& with)
:
    decomposition_(with.region),
    index_(0),
    sorted_(0),
    observed_(false),
    with_(with),
    sampler_(with.sound, with.region, with.motion),
    relative_(with.motion, with.region),
    mover_(with.motion, counters_),
    wakes_(with.region, with.motion, counters_),
    exchange_(with.motion, with.collisions, counters_),
    solver_
    (
        clusterSolver::New
        (
            with.motion, with.collisions, with.region.period(), counters_
        )
    )
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::timeStepping>
Foam::aerosol::timeStepping::New
(
    const dictionary& dict,
    const tools& with
)
{
    return selectModel<timeStepping>
    (
        dict,
        "time stepping",
        dictionaryConstructorTablePtr_,
        dict,
        with
    );
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

bool Foam::aerosol::timeStepping::begin
(
    particleArrays& p,
    const fluidStep& step
)
{
    index_ = step.index;

    return mover_.begin(p, sampler_, step);
}


std::vector<char> Foam::aerosol::timeStepping::collide
(
    particleArrays& p,
    const stepGas& gas,
    const encounters& found,
    const fluidStep& step,
    const int nCollision,
    stepEnd& end
)
{
    std::vector<cluster> clusters =
        exchange_.gather(p, gas, end.increment, wakes_, found);

    for (cluster& one : clusters)
    {
        solver_->solve(one, step, nCollision);
    }

    with_.collisions.share();

    return exchange_.scatter(clusters, p, end);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::timeStepping::migrate(particleArrays& p)
{
    with_.region.confine(p.x);
    decomposition_.migrate(p);

    if (index_ - sorted_ >= sortInterval)
    {
        cellGrid::sort(p);
        sorted_ = index_;
    }
}


// ************************************************************************* //
