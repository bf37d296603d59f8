/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleStep.H"
#include "communicator.H"
#include "randomBlock.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Particles that are moved together
constexpr int runLength = 512;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::particleStep::particleStep
(
    const equationOfMotion& motion,
    stepCounters& counters
)
:
    motion_(motion),
    counters_(counters),
    meanDisplacement_(Eigen::Vector3d::Zero())
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

void Foam::aerosol::particleStep::inRuns
(
    const particleArrays& p,
    const std::function<void(const int first, const int size)>& task
)
{
    for (int first = 0; first < p.size(); first += runLength)
    {
        task(first, std::min(runLength, p.size() - first));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::aerosol::particleStep::begin
(
    particleArrays& p,
    const gasSampler& sampler,
    const fluidStep& step
)
{
    ++counters_.fluidSteps;

    if (!p.refreshed())
    {
        motion_.laws().refresh(p);
    }

    // The gas is sampled here, and again when particles are moved: lists of
    // neighbours, which come between, need these accelerations, and to keep the
    // gas of all particles would take nine numbers of each
    if (motion_.unsteady().active())
    {
        const stepGas gas = sampler.whenAsked(p, step, true);
        stepEnd end;

        inRuns
        (
            p,
            [&](const int first, const int size)
            {
                motion_.unsteady().find
                (
                    step.h, gas.run(first, size), first, p, end
                );
            }
        );
    }

    return communicator::max(p.size()) > 0;
}


void Foam::aerosol::particleStep::moveWithoutWakes
(
    const fluidStep& step,
    const particleArrays& p,
    const stepGas& gas,
    stepEnd& end
)
{
    const scalar h = step.h;

    ++counters_.particleSteps;
    counters_.particleMoves += p.size();

    motion_.noise().increment
    (
        h, p, step.index, randomBlock(noise::whole, step.part), end.increment
    );

    // Also where there are none, or none any more
    end.x.resize(3, p.size());
    end.v.resize(3, p.size());

    inRuns
    (
        p,
        [&](const int first, const int size)
        {
            motion_.exact().moveAlone
            (
                h, p, gas.run(first, size), end, first
            );
        }
    );

    meanDisplacement_ = h*communicator::mean((end.x - p.x)/h);
}


// ************************************************************************* //
