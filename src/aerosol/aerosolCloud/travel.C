/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "travel.H"
#include "checkedEntry.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::travel::travel
(
    const dictionary& dict,
    const boundBox& domain,
    const boundBox& chamber,
    const scalar start
)
:
    velocity_(Eigen::Vector3d::Zero()),
    start_(start),
    end_(GREAT),
    path_(domain)
{
    requireOnly(dict, {"velocity"});

    const vector V = readVector(dict, "velocity", dimVelocity, vector::zero);

    scalar longest = GREAT;

    for (direction k = 0; k < vector::nComponents; ++k)
    {
        velocity_(k) = V[k];

        // Compared before divided: no division by nearly nothing
        const scalar room =
            V[k] > 0
          ? chamber.max()[k] - domain.max()[k]
          : domain.min()[k] - chamber.min()[k];

        if (mag(V[k])*longest > room)
        {
            longest = std::max(room, 0.0)/mag(V[k]);
        }
    }

    if (active())
    {
        end_ = start_ + longest;

        path_.add(domain.min() + V*longest);
        path_.add(domain.max() + V*longest);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::travel::enter(particleArrays& p, const scalar t) const
{
    if (active())
    {
        p.x.colwise() -= way(t);
        p.v.colwise() -= velocity_;
    }
}


void Foam::aerosol::travel::leave(particleArrays& p, const scalar t) const
{
    if (active())
    {
        p.x.colwise() += way(t);
        p.v.colwise() += velocity_;
    }
}


// ************************************************************************* //
