/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wakeStep.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::wakeStep::wakeStep
(
    const exponentialStep& exact,
    const BrownianPath& noise,
    const wakeInteraction& wakes
)
:
    exact_(exact),
    noise_(noise),
    wakes_(wakes)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::wakeStep::move
(
    const scalar h,
    const particleArrays& p,
    const stepValues& gas,
    const wakesOfStep& wakesAt,
    const int iterations,
    stepValues& w,
    stepEnd& end
) const
{
    w.um.resize(3, 0);
    w.u1.resize(3, 0);
    wakesAt(0, p.x, noise_.drift(p.v, p.thermal), gas.u0, w.u0);

    // With the wakes at the end, where the particles are now
    const auto correct = [&]()
    {
        wakesAt(1, end.x, noise_.drift(end.v, end.thermal), gas.u1, w.u1);
        exact_.move(h, p, gas, w, true, end);
    };

    if (iterations == linear)
    {
        exact_.move(h, p, gas, w, false, end);
        correct();
        return;
    }

    stepEnd middle = noise_.halfway(h, p, end);
    const stepValues firstHalf = gas.part(0, 0.5);

    for (int n = 0; n < iterations; ++n)
    {
        // First with the wakes of the beginning, later with those just found
        const bool again = n > 0;

        exact_.move
        (
            0.5*h, p, firstHalf, again ? w.part(0, 0.5) : w, again, middle
        );
        wakesAt
        (
            0.5,
            middle.x,
            noise_.drift(middle.v, middle.thermal),
            firstHalf.u1,
            w.um
        );

        if (!again)
        {
            w.u1 = 2*w.um - w.u0;
            exact_.move(h, p, gas, w, false, end);
        }

        correct();
    }
}


void Foam::aerosol::wakeStep::moveTogether
(
    const scalar h,
    const particleArrays& p,
    const std::vector<particlePair>& pairs,
    const stepValues& gas,
    const stepValues& outside,
    const int iterations,
    stepEnd& end
) const
{
    if (!wakes_.active())
    {
        exact_.moveAlone(h, p, gas, end);
        noise_.split(h, p, end);
        return;
    }

    // The thermal velocity at the end is that of drag and noise alone
    noise_.cool(h, p, end);

    const auto wakesAt =
    [&]
    (
        const scalar s,
        const vectors& x,
        const vectors& v,
        const vectors& u,
        vectors& result
    )
    {
        wakes_.sum
        (
            p, pairs, x, v, u, result,
            wakes_.imaginarySlip(p.rate, gas, s, h)
        );

        if (outside.u0.cols())
        {
            result += outside.at(s);
        }
    };

    stepValues w;
    move(h, p, gas, wakesAt, iterations, w, end);

    noise_.split(h, p, end);
}


// ************************************************************************* //
