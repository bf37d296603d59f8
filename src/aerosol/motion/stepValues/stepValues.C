/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "stepValues.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::vectors Foam::aerosol::stepValues::at(const scalar s) const
{
    if (!u1.cols())
    {
        return u0;
    }

    if (!um.cols())
    {
        return u0 + s*(u1 - u0);
    }

    return
        (1 - s)*(1 - 2*s)*u0 + 4*s*(1 - s)*um + s*(2*s - 1)*u1;
}


Foam::aerosol::vectors Foam::aerosol::stepValues::change
(
    const scalar s,
    const scalar h
) const
{
    if (!u1.cols())
    {
        return vectors::Zero(3, u0.cols());
    }

    if (!um.cols())
    {
        return (u1 - u0)/h;
    }

    return ((4*s - 3)*u0 + (4 - 8*s)*um + (4*s - 1)*u1)/h;
}


Foam::aerosol::stepValues Foam::aerosol::stepValues::part
(
    const scalar from,
    const scalar to
) const
{
    stepValues some;
    some.u0 = at(from);

    if (um.cols())
    {
        some.um = at(0.5*(from + to));
    }
    if (u1.cols())
    {
        some.u1 = at(to);
    }

    return some;
}


// ************************************************************************* //
