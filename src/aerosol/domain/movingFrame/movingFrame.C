/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "movingFrame.H"
#include "checkedEntry.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::movingFrame::movingFrame
(
    const dictionary& dict,
    const domain& region,
    const boundBox& chamber,
    const scalar start
)
:
    domain_(region),
    domainVelocity_(Eigen::Vector3d::Zero()),
    start_(start),
    end_(GREAT),
    path_(region.bounds()),
    velocity_(Eigen::Vector3d::Zero()),
    origin_(start)
{
    const boundBox& box = region.bounds();

    requireOnly(dict, {"velocity"});

    const vector V = readVector(dict, "velocity", dimVelocity, vector::zero);

    scalar longest = GREAT;

    for (direction k = 0; k < vector::nComponents; ++k)
    {
        domainVelocity_(k) = V[k];

        // Compared before divided: no division by nearly nothing
        const scalar room =
            V[k] > 0
          ? chamber.max()[k] - box.max()[k]
          : box.min()[k] - chamber.min()[k];

        if (mag(V[k])*longest > room)
        {
            longest = std::max(room, 0.0)/mag(V[k]);
        }
    }

    if (carried())
    {
        end_ = start_ + longest;

        path_.add(box.min() + V*longest);
        path_.add(box.max() + V*longest);
    }

    velocity_ = domainVelocity_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::movingFrame::leave(particleArrays& p, const scalar t) const
{
    // Between steps some may be a little outside
    p.x.colwise() += (velocity_ - domainVelocity_)*(t - origin_);
    domain_.confine(p.x);

    if (moves())
    {
        p.x.colwise() += domainVelocity_*(t - start_);
        p.v.colwise() += velocity_;
    }
}


void Foam::aerosol::movingFrame::enter(particleArrays& p, const scalar t) const
{
    if (moves())
    {
        p.x.colwise() -=
            domainVelocity_*(t - start_)
          + (velocity_ - domainVelocity_)*(t - origin_);
        p.v.colwise() -= velocity_;
        domain_.confine(p.x);
    }
}


// ************************************************************************* //
