/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "localSound.H"

#include "mathematicalConstants.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Harmonics of a sound that is being solved
constexpr int nSolved = 3;

//- Half of the distance of central differences, in wavelengths at most
constexpr double longestStep = 0.005;

//- What a displacement may change without being noticed, in velocity amplitudes
constexpr double negligible = 1e-12;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::localSound::localSound(soundField& sound)
:
    soundField(sound.frequency()),
    sound_(sound),
    region_(0),
    representative_(false),
    centre_(Eigen::Vector3d::Zero()),
    step_(Eigen::Vector3d::Zero()),
    velocity_(Eigen::Vector3d::Zero()),
    frame_(Eigen::Vector3d::Zero()),
    start_(0),
    solved_(3, 0),
    oldest_(0)
{
    for (moment& m : moments_)
    {
        m.t = VGREAT;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::acoustics::localSound::keep(const scalar t)
{
    vectors u;
    sound_.velocityIn(region_, t, centre(t), u);

    times_.push_back(t);
    velocities_.push_back(u.col(0));

    // The period ends now; it may begin between two of the times
    const scalar begin = t - (1 + 1e-6)/frequency();

    std::size_t first = 0;
    while (first + 1 < times_.size() && times_[first + 1] <= begin)
    {
        ++first;
    }

    times_.erase(times_.begin(), times_.begin() + first);
    velocities_.erase(velocities_.begin(), velocities_.begin() + first);
}


void Foam::acoustics::localSound::analyse()
{
    const scalar period = 1/frequency();
    const scalar begin = times_.back() - period;

    // Before a whole period those of a replay, if there was one
    if (times_.front() > begin + 1e-6*period)
    {
        return;
    }

    solved_.setZero(3, nSolved);

    const auto factor = [&](const scalar t, const int k)
    {
        const scalar periods = t*frequency();

        return std::polar
        (
            2.0,
           -k*constant::mathematical::twoPi*(periods - std::floor(periods))
        );
    };

    // By the trapezoidal rule, the first interval cut where the period begins
    for (std::size_t i = 1; i < times_.size(); ++i)
    {
        scalar t0 = times_[i - 1];
        const scalar t1 = times_[i];
        Eigen::Vector3d u0 = velocities_[i - 1];
        const Eigen::Vector3d& u1 = velocities_[i];

        if (t1 <= begin)
        {
            continue;
        }

        if (t0 < begin)
        {
            u0 += (begin - t0)/(t1 - t0)*(u1 - u0);
            t0 = begin;
        }

        for (int k = 1; k <= nSolved; ++k)
        {
            solved_.col(k - 1) +=
                0.5*(t1 - t0)*frequency()
               *(u0*factor(t0, k) + u1*factor(t1, k));
        }
    }
}


const Foam::acoustics::localSound::moment&
Foam::acoustics::localSound::at(const scalar t) const
{
    for (const moment& m : moments_)
    {
        if (m.t == t)
        {
            return m;
        }
    }

    moment& m = moments_[oldest_];
    oldest_ = (oldest_ + 1) % moments_.size();

    // The centre, and both sides of it along each axis
    const Eigen::Vector3d x = centre(t);

    vectors points = x.replicate(1, 7);
    for (int k = 0; k < 3; ++k)
    {
        points(k, 1 + 2*k) -= step_(k);
        points(k, 2 + 2*k) += step_(k);
    }

    vectors u;
    sound_.velocityIn(region_, t, points, u);

    m.t = t;
    m.u = u.col(0) - frame_;
    m.oscillation.resize(3, 0);

    if (frequency() <= 0)
    {
        return m;
    }

    Eigen::Matrix3d gradient;
    for (int k = 0; k < 3; ++k)
    {
        gradient.col(k) = (u.col(2 + 2*k) - u.col(1 + 2*k))/(2*step_(k));
    }

    const vectorPhasors harmonics =
        sound_.harmonics(region_, x).value_or(solved_);

    const scalar omega = constant::mathematical::twoPi*frequency();
    const scalar periods = t*frequency();
    const scalar angle =
        constant::mathematical::twoPi*(periods - std::floor(periods));

    m.nOfSound = static_cast<int>(harmonics.cols());
    m.oscillation.resize(3, 2*harmonics.cols());

    for (int k = 1; k <= harmonics.cols(); ++k)
    {
        // The displacement of the gas
        const Eigen::Vector3cd displacement =
            harmonics.col(k - 1)*std::polar(1.0, k*angle)
           /std::complex<double>(0, k*omega);

        m.oscillation.col(2*k - 2) = gradient*displacement.real();
        m.oscillation.col(2*k - 1) = -gradient*displacement.imag();
    }

    // At an antinode they are only what rounding leaves
    if
    (
        harmonics.cols()
     && m.oscillation.cwiseAbs().maxCoeff()
      < negligible*harmonics.col(0).norm()
    )
    {
        m.oscillation.resize(3, 0);
    }

    return m;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::acoustics::localSound::prepare(const boundBox& region)
{
    region_ = sound_.prepare(region);

    return region_;
}


void Foam::acoustics::localSound::represent(const boundBox& box)
{
    representative_ = true;

    const scalar longest =
        frequency() > 0 ? longestStep*gas().c/frequency() : GREAT;

    for (int k = 0; k < 3; ++k)
    {
        centre_(k) = box.centre()[k];
        step_(k) = std::min(0.5*box.span()[k], longest);
    }
}


void Foam::acoustics::localSound::move
(
    const Eigen::Vector3d& velocity,
    const Eigen::Vector3d& frame,
    const scalar start
)
{
    velocity_ = velocity;
    frame_ = frame;
    start_ = start;
}


void Foam::acoustics::localSound::follow(const scalar t, const scalar h)
{
    // The sound of a time may have changed since
    for (moment& m : moments_)
    {
        m.t = VGREAT;
    }

    if (!representative_ || frequency() <= 0)
    {
        return;
    }

    if (const auto known = sound_.harmonics(region_, centre(t)))
    {
        // A replay may be solved again
        solved_ = *known;
        times_.clear();
        velocities_.clear();
        return;
    }

    if (times_.empty())
    {
        keep(t);
    }

    keep(t + h);
    analyse();
}


std::vector<Foam::scalar> Foam::acoustics::localSound::lastPeriod() const
{
    if (times_.empty())
    {
        return {};
    }

    std::vector<scalar> numbers{scalar(solved_.cols())};

    for (Eigen::Index k = 0; k < solved_.size(); ++k)
    {
        numbers.push_back(solved_(k).real());
        numbers.push_back(solved_(k).imag());
    }

    for (std::size_t i = 0; i < times_.size(); ++i)
    {
        numbers.push_back(times_[i]);
        for (int k = 0; k < 3; ++k)
        {
            numbers.push_back(velocities_[i](k));
        }
    }

    return numbers;
}


void Foam::acoustics::localSound::setLastPeriod
(
    const std::vector<scalar>& numbers
)
{
    times_.clear();
    velocities_.clear();

    std::size_t next = 0;
    solved_.setZero(3, label(numbers.at(next++)));

    for (Eigen::Index k = 0; k < solved_.size(); ++k, next += 2)
    {
        solved_(k) = {numbers.at(next), numbers.at(next + 1)};
    }

    for (std::size_t i = next; i + 3 < numbers.size(); i += 4)
    {
        times_.push_back(numbers[i]);
        velocities_.push_back
        ({
            numbers[i + 1], numbers[i + 2], numbers[i + 3]
        });
    }
}


void Foam::acoustics::localSound::save(dictionary& state) const
{
    const std::vector<scalar> numbers = lastPeriod();

    if (numbers.size())
    {
        // As text, but with all digits
        const unsigned int precision = IOstream::defaultPrecision(17);

        List<scalar> list(numbers.size());
        std::copy(numbers.cbegin(), numbers.cend(), list.begin());
        state.add("lastPeriod", list);

        IOstream::defaultPrecision(precision);
    }
}


void Foam::acoustics::localSound::load(const dictionary& state)
{
    if (state.found("lastPeriod"))
    {
        const List<scalar> numbers(state.get<List<scalar>>("lastPeriod"));

        setLastPeriod({numbers.cbegin(), numbers.cend()});
    }
}


Foam::scalar Foam::acoustics::localSound::amplitude(const scalar t) const
{
    const auto known =
        representative_ && frequency() > 0
      ? sound_.harmonics(region_, centre(t))
      : std::nullopt;

    return known ? known->col(0).norm() : sound_.expectedAmplitude();
}


Eigen::Matrix3d Foam::acoustics::localSound::gradient(const scalar t) const
{
    Eigen::Matrix3d result = Eigen::Matrix3d::Zero();

    if (!representative_)
    {
        return result;
    }

    for (int k = 0; k < 3; ++k)
    {
        vectors points = centre(t).replicate(1, 2);
        points(k, 0) -= step_(k);
        points(k, 1) += step_(k);

        vectors u;
        sound_.velocityIn(region_, t, points, u);

        result.col(k) = (u.col(1) - u.col(0))/(2*step_(k));
    }

    return result;
}


void Foam::acoustics::localSound::velocity
(
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    if (representative_)
    {
        u = at(t).u.replicate(1, x.cols());
        return;
    }

    sound_.velocityIn(region_, t, x, u);
}


void Foam::acoustics::localSound::velocityAt
(
    const scalar t,
    const vectors& x,
    const phasors& response,
    vectors& u
) const
{
    localSound::velocity(t, x, u);

    if (!representative_)
    {
        return;
    }

    const moment& now = at(t);

    if (!now.nHarmonics())
    {
        return;
    }

    constexpr int blockSize = commonVelocity::blockSize;
    commonVelocity::phasorBlock fundamental;
    commonVelocity::blocks apart;
    double* const to = u.data();

    for (Eigen::Index from = 0; from < x.cols(); from += blockSize)
    {
        const int size = std::min<Eigen::Index>(blockSize, x.cols() - from);

        fundamental.first.setZero();
        fundamental.second.setZero();
        fundamental.first.head(size) = response.segment(from, size).real();
        fundamental.second.head(size) = response.segment(from, size).imag();

        now.at
        (
            commonVelocity::responses(fundamental, now.nHarmonics()), apart
        );

        for (int l = 0; l < size; ++l)
        {
            for (int c = 0; c < 3; ++c)
            {
                to[3*(from + l) + c] = apart[c](l);
            }
        }
    }
}


std::optional<Foam::acoustics::commonVelocity>
Foam::acoustics::localSound::commonAt(const scalar t) const
{
    if
    (
        !representative_
     || frequency() <= 0
     || !sound_.harmonics(region_, centre(t))
    )
    {
        return std::nullopt;
    }

    return at(t);
}


// ************************************************************************* //
