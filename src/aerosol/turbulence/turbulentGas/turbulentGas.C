/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "turbulentGas.H"
#include "eigenVector.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::turbulentGas::turbulentGas
(
    acoustics::soundField& sound,
    const dictionary& dict,
    const domain& region
)
:
    localSound(sound),
    dict_(dict),
    domain_(region),
    period_(region.period()),
    begin_(0),
    step_(0),
    speeds_(Eigen::Matrix3d::Zero()),
    displacement_(Eigen::Vector3d::Zero())
{
    centre_ = toEigen(region.bounds().centre());
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Eigen::Vector3d
Foam::aerosol::turbulentGas::rounded(const Eigen::Vector3d& displacement) const
{
    const Eigen::Array3d within =
        displacement.array() - period_*(displacement.array()/period_).round();

    return ((within*0x1p56).round()*0x1p-56).matrix();
}


Eigen::Vector3d
Foam::aerosol::turbulentGas::displacementAt(const scalar t) const
{
    if (step_ <= 0)
    {
        return displacement_;
    }

    const scalar s = (t - begin_)/step_;

    // The velocity as a parabola
    const Eigen::Vector3d share
    (
        s*(1 - s*(1.5 - s*2/3)),
        s*s*(2 - s*4/3),
        s*s*(-0.5 + s*2/3)
    );

    return displacement_ + step_*(speeds_*share);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::aerosol::turbulentGas::prepare(const boundBox& region)
{
    const label number = localSound::prepare(region);

    turbulence_ = turbulence::New(dict_, domain_, *this);

    return number;
}


void Foam::aerosol::turbulentGas::follow(const scalar t, const scalar h)
{
    localSound::follow(t, h);

    if (!turbulent())
    {
        return;
    }

    displacement_ = displacement();
    begin_ = t;
    step_ = h;

    vectors u;

    for (int i = 0; i < 3; ++i)
    {
        localSound::velocity(t + 0.5*i*h, centre_, u);
        speeds_.col(i) = u;
    }
}


Eigen::Vector3d Foam::aerosol::turbulentGas::displacement() const
{
    return rounded(displacementAt(begin_ + step_));
}


void Foam::aerosol::turbulentGas::setDisplacement
(
    const Eigen::Vector3d& displacement
)
{
    step_ = 0;
    displacement_ = rounded(displacement);
}


void Foam::aerosol::turbulentGas::save(dictionary& state) const
{
    localSound::save(state);

    if (turbulent())
    {
        const Eigen::Vector3d end = displacement();

        // A vector would lose digits here
        state.add("gasWayX", end(0));
        state.add("gasWayY", end(1));
        state.add("gasWayZ", end(2));
    }
}


void Foam::aerosol::turbulentGas::load(const dictionary& state)
{
    localSound::load(state);

    if (state.found("gasWayX"))
    {
        setDisplacement
        ({
            state.get<scalar>("gasWayX"),
            state.get<scalar>("gasWayY"),
            state.get<scalar>("gasWayZ")
        });
    }
}


void Foam::aerosol::turbulentGas::velocity
(
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    localSound::velocity(t, x, u);

    if (turbulent())
    {
        turbulence_->add(t, x.colwise() - displacementAt(t), u);
    }
}


void Foam::aerosol::turbulentGas::velocityAt
(
    const scalar t,
    const vectors& x,
    const phasors& response,
    vectors& u
) const
{
    localSound::velocityAt(t, x, response, u);

    if (turbulent())
    {
        turbulence_->add(t, x.colwise() - displacementAt(t), u);
    }
}


// ************************************************************************* //
