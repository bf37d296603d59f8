/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "BrownianPath.H"
#include "meanDecay.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::BrownianPath::BrownianPath
(
    const Brownian& law,
    const gasProperties& gas
)
:
    law_(law),
    gas_(gas)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::BrownianPath::increment
(
    const scalar h,
    const particleArrays& p,
    const std::int64_t step,
    const std::uint64_t block,
    Brownian::increments& increment
) const
{
    law_.increment(p, p.rate, gas_, h, step, block, increment);
}


void Foam::aerosol::BrownianPath::bridge
(
    const scalar h,
    const particleArrays& p,
    const std::int64_t step,
    const std::uint64_t block,
    const int n,
    const Brownian::increments& whole,
    std::vector<Brownian::increments>& parts
) const
{
    law_.bridge(p, p.rate, gas_, h, step, block, n, whole, parts);
}


Foam::aerosol::Brownian::extent Foam::aerosol::BrownianPath::reach
(
    const scalar h,
    const particleArrays& p
) const
{
    return law_.reach(p, p.rate, gas_, h);
}


void Foam::aerosol::BrownianPath::cool
(
    const scalar h,
    const particleArrays& p,
    stepEnd& end
) const
{
    if (!active())
    {
        return;
    }

    end.thermal.resize(3, p.size());

    // One by one, that the result depends on the particle only
    for (int i = 0; i < p.size(); ++i)
    {
        end.thermal.col(i) =
            std::exp(-h*p.rate(i))*p.thermal.col(i) + end.increment.v.col(i);
    }
}


Foam::aerosol::stepEnd
Foam::aerosol::BrownianPath::halfway
(
    const scalar h,
    const particleArrays& p,
    const stepEnd& end
) const
{
    stepEnd middle;

    if (active())
    {
        middle.increment.x = 0.5*end.increment.x;
        middle.increment.v.setZero(3, p.size());
        cool(0.5*h, p, middle);
    }

    return middle;
}


void Foam::aerosol::BrownianPath::split
(
    const scalar h,
    const particleArrays& p,
    stepEnd& end
) const
{
    if (!active())
    {
        return;
    }

    const int n = p.size();

    cool(h, p, end);
    end.path0.resize(3, n);
    end.path1.resize(3, n);

    for (int i = 0; i < n; ++i)
    {
        const double z = h*p.rate(i);
        const double A = meanDecay(z);

        const Eigen::Vector3d before = p.thermal.col(i);
        const Eigen::Vector3d after = end.thermal.col(i);
        const Eigen::Vector3d mean = A*before + end.increment.x.col(i)/h;

        end.path0.col(i) = p.v.col(i) - (1 - A)*(before - mean);
        end.path1.col(i) = end.v.col(i) - (1 - A)*(after - mean);
    }
}


Foam::aerosol::vectors Foam::aerosol::BrownianPath::drift
(
    const vectors& v,
    const vectors& thermal
) const
{
    return active() ? vectors(v - thermal) : v;
}


// ************************************************************************* //
