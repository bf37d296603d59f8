/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particlePath.H"
#include "scalar.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::particlePath::particlePath
(
    const Eigen::Vector3d& x0,
    const Eigen::Vector3d& v0,
    const Eigen::Vector3d& x1,
    const Eigen::Vector3d& v1,
    const double length
)
:
    x0_(x0),
    v0_(v0),
    x1_(x1),
    v1_(v1),
    length_(length)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Eigen::Vector3d
Foam::aerosol::particlePath::position(const double t) const
{
    if (length_ <= 0)
    {
        return x1_;
    }

    const double s = t/length_;
    const double q = 1 - s;

    return
        (1 + 2*s)*q*q*x0_ + s*q*q*length_*v0_
      + (3 - 2*s)*s*s*x1_ - s*s*q*length_*v1_;
}


Eigen::Vector3d
Foam::aerosol::particlePath::velocity(const double t) const
{
    if (length_ <= 0)
    {
        return v1_;
    }

    const double s = t/length_;
    const double q = 1 - s;

    return
        6*s*q/length_*(x1_ - x0_)
      + q*(1 - 3*s)*v0_ + s*(3*s - 2)*v1_;
}


bool Foam::aerosol::particlePath::staysAwayFrom
(
    const particlePath& b,
    const double distance
) const
{
    const Eigen::Vector3d r0 = b.x0_ - x0_;
    const Eigen::Vector3d r1 = b.x1_ - x1_;
    const Eigen::Vector3d v0 = b.v0_ - v0_;
    const Eigen::Vector3d v1 = b.v1_ - v1_;

    // Hermite's cubic is no further from an end than this
    const double displacement =
        (r1 - r0).norm() + 4.0/27.0*length_*(v0.norm() + v1.norm());

    return std::max(r0.norm(), r1.norm()) > distance + displacement;
}


double
Foam::aerosol::particlePath::relativeSpeed(const particlePath& b) const
{
    const Eigen::Vector3d v0 = v0_ - b.v0_;
    const Eigen::Vector3d v1 = v1_ - b.v1_;

    if (length_ <= 0)
    {
        return std::max(v0.norm(), v1.norm());
    }

    const Eigen::Vector3d chord = (x1_ - x0_ - b.x1_ + b.x0_)/length_;

    return std::sqrt
    (
        std::max
        ({
            v0.squaredNorm(),
            (3*chord - v0 - v1).squaredNorm(),
            v1.squaredNorm()
        })
    );
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

double Foam::aerosol::particlePath::firstOverlap
(
    const particlePath& a,
    const particlePath& b,
    const double touch,
    const double interval,
    const bool onlyNew
)
{
    const auto overlaps = [&](const double t)
    {
        return
            (b.position(t) - a.position(t)).squaredNorm() <= touch*touch;
    };

    const int nSteps =
        std::max(1, static_cast<int>(std::lround(a.length_/interval)));

    bool before = overlaps(0);

    if (before && !onlyNew)
    {
        return 0;
    }

    for (int s = 1; s <= nSteps; ++s)
    {
        double late = s*a.length_/nSteps;
        const bool now = overlaps(late);

        if (now && !before)
        {
            // Bisection, down to rounding
            double early = (s - 1)*a.length_/nSteps;

            for (int n = 0; n < 50; ++n)
            {
                const double half = 0.5*(early + late);

                (overlaps(half) ? late : early) = half;
            }

            return late;
        }

        before = now;
    }

    return GREAT;
}


double Foam::aerosol::particlePath::firstTouch
(
    const particlePath& a,
    const particlePath& b,
    const double touch,
    const bool onlyNew
)
{
    const double last = a.length_;

    // No gap can close faster than this
    const double speed = std::max(a.relativeSpeed(b), VSMALL);

    const auto gap = [&](const double t)
    {
        return (b.position(t) - a.position(t)).norm() - touch;
    };

    double t = 0;
    double distance = gap(t);

    // Out of an overlap that does not count. Its end is none of the contacts
    // below, which are within rounding of touching.
    while (onlyNew && distance <= 1e-12*touch && t <= last)
    {
        t += std::max(-distance, 1e-3*touch)/speed;

        // Paths end here; far beyond, their polynomials overflow
        if (t > last)
        {
            return GREAT;
        }
        distance = gap(t);
    }

    while (t <= last)
    {
        if (distance <= 0)
        {
            return t;
        }

        // Very close, the steps become too short: contact is where the gap
        // closes at its present rate, unless they only graze
        if (distance < 1e-6*touch)
        {
            double contact = t;

            for (int n = 0; n < 3; ++n)
            {
                const Eigen::Vector3d r =
                    b.position(contact) - a.position(contact);
                const double rate =
                    (b.velocity(contact) - a.velocity(contact)).dot(r)/r.norm();

                if (rate >= 0)
                {
                    break;
                }
                contact += (touch - r.norm())/rate;
            }

            if (contact <= last && gap(contact) <= 1e-12*touch)
            {
                return std::max(contact, 0.0);
            }
        }

        t += std::max(distance, 1e-6*touch)/speed;

        if (t > last)
        {
            break;
        }
        distance = gap(t);
    }

    return GREAT;
}


double Foam::aerosol::particlePath::firstApproach
(
    const particlePath& a,
    const particlePath& b,
    const double touch
)
{
    // Gap up to which two are in touch, relative to the distance of contact: a
    // bounce leaves as much
    constexpr double closed = 1e-9;

    // Steps of those in touch that separate
    constexpr double stride = 1e-4;

    const double last = a.length_;
    const double speed = std::max(a.relativeSpeed(b), VSMALL);

    for (double t = 0; ; t = std::min(t + stride*touch/speed, last))
    {
        const Eigen::Vector3d r = b.position(t) - a.position(t);
        const double gap = r.norm() - touch;

        if (gap > closed*touch)
        {
            // No sooner than this; and not in touch before
            const double when =
                firstTouch(a.rest(t), b.rest(t), touch, false);

            if (when > last - t)
            {
                return GREAT;
            }
            t += when;
        }

        const Eigen::Vector3d there = b.position(t) - a.position(t);

        if ((b.velocity(t) - a.velocity(t)).dot(there) < 0)
        {
            return t;
        }

        // Also at the end: two that close there would begin the next step with
        // an overlap
        if (t >= last)
        {
            return GREAT;
        }
    }
}


// ************************************************************************* //
