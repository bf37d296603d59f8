/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "movingFrame.H"
#include "checkedEntry.H"
#include "eigenVector.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::movingFrame::movingFrame
(
    const dictionary& dict,
    const domain& region,
    const chamber& room,
    const scalar now,
    const dictionary& state
)
:
    domain_(region),
    domainVelocity_(Eigen::Vector3d::Zero()),
    start_(state.getOrDefault<scalar>("began", now)),
    end_(GREAT),
    path_(region.bounds()),
    velocity_(Eigen::Vector3d::Zero()),
    origin_(start_)
{
    const boundBox& box = region.bounds();

    requireOnly(dict, {"velocity"});

    const vector V = readVector(dict, "velocity", dimVelocity, vector::zero);

    domainVelocity_ = toEigen(V);

    if (domainMoves())
    {
        scalar longest = room.first(box, V).time;

        // Out of a mesh of one layer there is no wall
        for (direction k = 0; k < vector::nComponents; ++k)
        {
            const boundBox& bounds = room.bounds();

            // Compared before divided: no division by nearly nothing
            const scalar way =
                V[k] > 0
              ? bounds.max()[k] - box.max()[k]
              : box.min()[k] - bounds.min()[k];

            if (mag(V[k])*longest > way)
            {
                longest = std::max(way, 0.0)/mag(V[k]);
            }
        }

        end_ = start_ + longest;

        path_.add(box.min() + V*longest);
        path_.add(box.max() + V*longest);
    }

    velocity_ = domainVelocity_;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::aerosol::movingFrame::hadThisVelocity(const dictionary& state) const
{
    const auto was = [&](const word& component)
    {
        return state.getOrDefault<scalar>(component, VGREAT);
    };

    return
        was("frameVelocityX") == velocity_(0)
     && was("frameVelocityY") == velocity_(1)
     && was("frameVelocityZ") == velocity_(2);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::movingFrame::move
(
    const Eigen::Vector3d& velocity,
    const scalar now,
    const dictionary& state
)
{
    velocity_ = velocity;
    origin_ =
        hadThisVelocity(state) ? state.get<scalar>("frameOrigin") : now;
}


void Foam::aerosol::movingFrame::save(dictionary& state) const
{
    state.add("began", start_);
    state.add("frameOrigin", origin_);

    // A vector would lose digits here
    state.add("frameVelocityX", velocity_(0));
    state.add("frameVelocityY", velocity_(1));
    state.add("frameVelocityZ", velocity_(2));
}


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
