/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "planeWave.H"

#include "checkedEntry.H"
#include "eigenVector.H"
#include "mathematicalConstants.H"
#include "nearestMultiple.H"
#include "sineSeries.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::planeWave::planeWave(const dictionary& dict)
:
    analyticSound(readPositive(dict, "frequency", dimless/dimTime), dict),
    level_(soundLevel::read(dict, gas())),
    direction_(toEigen(readDirection(dict, "direction", vector(1, 0, 0)))),
    origin_(toEigen(readVector(dict, "origin", dimLength, Zero))),
    phase_(dict.found("phase") ? readFinite(dict, "phase", dimless) : 0),
    mean_(readFlow(dict)),
    omega_(constant::mathematical::twoPi*frequency()),
    k_(omega_/gas().c)
{
    requireOnly
    (
        dict,
        {"type", "frequency", "SPL", "velocityAmplitude", "direction", "origin",
         "phase", "velocity", "gas"}
    );

    Info<< "    " << level_ << nl
        << "    frequency " << frequency() << " Hz, wavelength "
        << gas().c/frequency() << " m" << endl;
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Eigen::ArrayXd Foam::acoustics::planeWave::kDistance(const vectors& x) const
{
    const Eigen::Vector3d k = k_*direction_;
    const double atOrigin = k.dot(origin_);
    const double k0 = k(0);
    const double k1 = k(1);
    const double k2 = k(2);

    Eigen::ArrayXd distance(x.cols());

    // Alike for every point, wherever it is in the array
    for (Eigen::Index i = 0; i < x.cols(); ++i)
    {
        distance(i) = k0*x(0, i) + (k1*x(1, i) + (k2*x(2, i) - atOrigin));
    }

    return distance;
}


void Foam::acoustics::planeWave::add(const Eigen::ArrayXd& wave, vectors& u)
const
{
    u = direction_*wave.matrix().transpose();

    if (mean_ != Eigen::Vector3d::Zero())
    {
        u.colwise() += mean_;
    }
}


Eigen::ArrayXd
Foam::acoustics::planeWave::sine(const Eigen::ArrayXd& angles)
{
    // Pi as the sum of two numbers
    constexpr double pi = 3.141592653589793116;
    constexpr double rest = 1.2246467991473532e-16;

    Eigen::ArrayXd result(angles.size());

    const double* const angle = angles.data();
    double* const sine = result.data();

    for (Eigen::Index i = 0; i < angles.size(); ++i)
    {
        const double n = nearestMultiple<0>(angle[i]*(1/pi));
        const double y = (angle[i] - n*pi) - n*rest;

        // Of an odd number of half periods: -1 or 1
        const double odd = n - 2*nearestMultiple<0>(0.5*n);
        const double sign = 1 - 2*odd*odd;

        sine[i] = sign*y*sineSeries(y*y);
    }

    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

std::optional<Foam::acoustics::soundField::vectorPhasors>
Foam::acoustics::planeWave::harmonics
(
    const label,
    const Eigen::Vector3d& x
) const
{
    // Re(u) and Re(i u) of the phasor u, without the mean flow
    vectors now, quarterLater;
    velocity(0, x, now);
    velocity(0.25/frequency(), x, quarterLater);

    vectorPhasors u(3, 1);
    u.real() = now - mean_;
    u.imag() = mean_ - quarterLater;

    return u;
}


// ************************************************************************* //
