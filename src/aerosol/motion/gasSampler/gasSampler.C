/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gasSampler.H"
#include "eigenVector.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::gasSampler::gasSampler
(
    const acoustics::soundField& sound,
    const domain& region,
    const equationOfMotion& motion
)
:
    sound_(sound),
    domain_(region),
    motion_(motion)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::stepValues Foam::aerosol::gasSampler::at
(
    vectors x,
    const vectors& v,
    const phasors& response,
    const fluidStep& step,
    const bool parabola
) const
{
    const scalar h = step.h;
    stepValues gas;

    // Where all places are alike, they need not be known
    if (sound_.alike())
    {
        sound_.velocityAt(step.t, x, response, gas.u0);
        sound_.velocityAt(step.t + h, x, response, gas.u1);
        if (parabola)
        {
            sound_.velocityAt(step.t + 0.5*h, x, response, gas.um);
        }
        return gas;
    }

    // Sample outside positions at their wrapped place
    domain_.confine(x);

    sound_.velocityAt(step.t, x, response, gas.u0);

    // Where a particle will be at the end matters to second order; just across
    // the border of the domain the gas is that at the border
    const Eigen::Vector3d lower = toEigen(domain_.bounds().min());
    const Eigen::Vector3d upper = toEigen(domain_.bounds().max());

    vectors x1(3, x.cols());

    for (int i = 0; i < x.cols(); ++i)
    {
        x1.col(i) =
            (x.col(i) + h*v.col(i)).cwiseMax(lower).cwiseMin(upper);
    }

    sound_.velocityAt(step.t + h, x1, response, gas.u1);

    if (parabola)
    {
        x1 = 0.5*(x + x1);
        sound_.velocityAt(step.t + 0.5*h, x1, response, gas.um);
    }

    return gas;
}


Foam::aerosol::stepValues Foam::aerosol::gasSampler::atAll
(
    const particleArrays& p,
    const fluidStep& step
) const
{
    return at(p.x, motion_.noise().drift(p.v, p.thermal), p.response, step);
}


Foam::aerosol::stepGas Foam::aerosol::gasSampler::whenAsked
(
    const particleArrays& p,
    const fluidStep& step,
    const bool parabola
) const
{
    return
    {
        [this, &p, step, parabola](const int first, const int size)
        {
            return at
            (
                p.x.middleCols(first, size),
                motion_.noise().drift
                (
                    p.v.middleCols(first, size),
                    p.thermal.middleCols(first, size)
                ),
                p.response.segment(first, size),
                step, parabola
            );
        },
        [this, &p, step, parabola](const std::vector<int>& some)
        {
            return at
            (
                p.x(Eigen::all, some),
                motion_.noise().drift
                (
                    p.v(Eigen::all, some), p.thermal(Eigen::all, some)
                ),
                p.response(some),
                step, parabola
            );
        },
        parabola
    };
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::aerosol::stepGas
Foam::aerosol::gasSampler::atHand(const stepValues& gas)
{
    const auto of = [&gas](const auto& choose)
    {
        return stepValues
        {
            choose(gas.u0),
            gas.um.cols() ? choose(gas.um) : vectors(3, 0),
            gas.u1.cols() ? choose(gas.u1) : vectors(3, 0)
        };
    };

    return
    {
        [of](const int first, const int size)
        {
            return of
            (
                [&](const vectors& u)
                {
                    return vectors(u.middleCols(first, size));
                }
            );
        },
        [of](const std::vector<int>& some)
        {
            return of
            (
                [&](const vectors& u) { return vectors(u(Eigen::all, some)); }
            );
        },
        gas.um.cols() > 0
    };
}


// ************************************************************************* //
