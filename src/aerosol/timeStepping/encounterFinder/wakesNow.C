/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "encounterFinder.H"
#include "communicator.H"
#include "StokesResponse.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- If a source has more neighbours than this within its oscillation amplitude,
//  on average, lists are made anew in every step
constexpr double crowd = 200;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::encounterFinder::wakesNow
(
    const particleArrays& p,
    const stepGas& gas,
    const scalar h,
    vectors& w
)
{
    if (!motion_.wakes().active())
    {
        return {};
    }

    const double omega = 2*EIGEN_PI*sound_.frequency();
    const double u0 = std::max(sound_.velocityAmplitude(), 0.0);
    const int n = p.size();

    // The slip of Stokes' response, times the radius; and how far a source gets
    // as it oscillates: a particle out of range now may come into range then
    scalars strength(n);
    scalars reach = p.range;
    for (int j = 0; j < n; ++j)
    {
        const double slip = StokesResponse(p.rate(j), omega).slip()*u0;

        strength(j) = 0.5*p.mobilityDiameter(j)*slip;

        if (omega > 0 && reach(j) > 0)
        {
            reach(j) += 2*slip/omega;
        }
    }

    // Pairs per particle
    const double all = communicator::sum(n);
    const double volume = domain_.volume();
    const double meanDistance = std::cbrt(volume/all);

    vectors spheres = vectors::Zero(3, n);
    spheres.row(0) =
        4*EIGEN_PI/3*(reach/meanDistance).cube().matrix().transpose();

    if (communicator::mean(spheres)(0) > crowd)
    {
        return scalars::Constant(n, -1);
    }

    wakes_.search(grid_, p, p.x, reach);

    const ghosts& layer = wakes_.list().layer();

    vectors ghostX;
    layer.fill
    ({
        {p.x, ghostX, layer, true},
        {strength, layer},
    });

    scalars speed = scalars::Zero(n);

    for (const particlePair& pair : wakes_.list().pairs())
    {
        const vectors& xj = pair.j < n ? p.x : ghostX;
        const int column = pair.j < n ? pair.j : pair.j - n;
        const double r = (p.x.col(pair.i) - xj.col(column)).norm();

        speed(pair.i) +=
            1.5*strength(pair.j)/std::max(r, 0.5*p.collisionDiameter(pair.i));
    }

    wakes_.involve(p);
    w = wakes_.now(p, gas, h);

    return speed;
}


// ************************************************************************* //
