/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepPaths.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::stepPaths::fill
(
    const ghosts& layer,
    const particleArrays& p,
    const stepEnd& end,
    const scalar h
)
{
    n_ = layer.n();

    const bool Brownian = motion_.noise().active();

    std::vector<ghosts::quantity> quantities
    {
        {p.x, x0, layer, true},
        {Brownian ? end.path0 : p.v, v0, layer, false},
        {end.x, x1, layer, true},
        {Brownian ? end.path1 : end.v, v1, layer, false},
        {p.collisionDiameter, d, layer}
    };

    if (Brownian)
    {
        stray = motion_.noise().reach(h, p).stray;
        quantities.push_back({stray, ghostStray, layer});
    }

    layer.fill(quantities);
}


Foam::aerosol::particlePath Foam::aerosol::stepPaths::of
(
    const particleArrays& p,
    const stepEnd& end,
    const int i,
    const scalar h
) const
{
    if (i < n_)
    {
        return own(p, end, i, h);
    }

    const int c = i - n_;

    return {x0.col(c), v0.col(c), x1.col(c), v1.col(c), h};
}


// ************************************************************************* //
