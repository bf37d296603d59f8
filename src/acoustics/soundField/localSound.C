/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localSound.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::localSound::localSound(soundField& sound)
:
    soundField(sound.frequency()),
    sound_(sound),
    region_(0),
    velocity_(Eigen::Vector3d::Zero()),
    start_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::acoustics::localSound::prepare(const boundBox& region)
{
    region_ = sound_.prepare(region);

    return region_;
}


void Foam::acoustics::localSound::move
(
    const Eigen::Vector3d& velocity,
    const scalar start
)
{
    velocity_ = velocity;
    start_ = start;
}


void Foam::acoustics::localSound::velocity
(
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    if (velocity_ == Eigen::Vector3d::Zero())
    {
        sound_.velocityIn(region_, t, x, u);
        return;
    }

    const Eigen::Vector3d way = velocity_*(t - start_);

    sound_.velocityIn(region_, t, x.colwise() + way, u);
    u.colwise() -= velocity_;
}


// ************************************************************************* //
