/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "setupCheck.H"
#include "collisions.H"
#include "domain.H"
#include "equationOfMotion.H"
#include "mathematicalConstants.H"
#include "Time.H"
#include "turbulentGas.H"
#include "eigenVector.H"

#include <algorithm>
#include <cmath>
#include <sstream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::setupCheck::setupCheck
(
    const dictionary& dict,
    const Time& time,
    const domain& box,
    const turbulentGas& sound,
    const equationOfMotion& motion,
    const collisions& meetings,
    const particleArrays& particles
)
:
    dict_(dict),
    time_(time),
    domain_(box),
    sound_(sound),
    motion_(motion),
    collisions_(meetings),
    particles_(particles)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::setupCheck::requireTolerance() const
{
    const wake& model = motion_.laws().wakeModel();
    const dictionary& dict = dict_.subDict("wake");

    const char* const remedy =
        "give 'range', a number of diameters of the source, in this dictionary";

    if
    (
        (model.needsTolerance() || model.tolerance() > 0)
     && sound_.frequency() > 0
     && sound_.expectedAmplitude() < 0
    )
    {
        FatalIOErrorInFunction(dict)
            << "The range of the wakes cannot be worked out from a tolerance:"
            << " the velocity amplitude of the sound is not known. Give its"
            << " expected level, 'SPL' or 'velocityAmplitude', in"
            << " constant/acousticProperties, or " << remedy
            << exit(FatalIOError);
    }

    if
    (
        model.needsTolerance()
     && (model.tolerance() <= 0 || model.tolerance() > 0.1*GREAT)
    )
    {
        FatalIOErrorInFunction(dict)
            << "The range of the wakes has no default: without sound it comes"
            << " from the settling speed of the particles, which is"
            << (model.tolerance() > 0 ? " unlimited without drag" : " zero")
            << ": " << remedy
            << exit(FatalIOError);
    }
}


void Foam::aerosol::setupCheck::requireNoBounces() const
{
    // Their noise of the step is known, and a bounce would have to reflect what
    // is left of it for both
    if (motion_.noise().active() && collisions_.bounces())
    {
        FatalIOErrorInFunction(dict_.subDict("contact"))
            << "Particles that bounce cannot have Brownian motion: set"
            << " 'Brownian' to none, or let them stick or pass"
            << exit(FatalIOError);
    }
}


void Foam::aerosol::setupCheck::checkSound() const
{
    if (sound_.frequency() <= 0)
    {
        return;
    }

    const scalar steps = 1/(sound_.frequency()*time_.deltaTValue());
    const scalar shortest = domain_.bounds().minDim();

    // Those that are carried along best and least move relative to each other
    const scalar omega = constant::mathematical::twoPi*sound_.frequency();
    const scalars tau = particleLaws::relaxationTime(particles_);
    const scalar s1 = min(omega*tau.minCoeff(), 1e8);
    const scalar s2 = min(omega*tau.maxCoeff(), 1e8);
    const scalar share = (s2 - s1)/sqrt((1 + s1*s1)*(1 + s2*s2));

    // That of a domain that moves is not the same all the way
    const scalar amplitude =
        dict_.found("frame")
      ? sound_.expectedAmplitude()
      : sound_.amplitude(time_.value());
    const scalar displacement = 2*max(amplitude, scalar(0))*share/omega;
    const scalar layer = sqrt(2*sound_.gas().nu()/omega);

    std::ostringstream os;
    os  << "Fluid steps per period " << steps << " (k_f = " << 1/steps
        << ")\nRelative displacement of the smallest and the largest particle ";

    if (amplitude >= 0)
    {
        os  << displacement << " m (peak to peak) where the gas oscillates"
            << " with " << amplitude << " m/s";
    }
    else
    {
        os  << "not known, since the level of the sound is not";
    }

    os  << ", Stokes layer " << layer << " m, shortest edge of the domain "
        << shortest << " m";

    Info<< os.str().c_str() << nl;

    if (steps < 20)
    {
        WarningInFunction
            << "With " << steps << " fluid steps per period the velocity of"
            << " the gas at the particles is not resolved in time: use at least"
            << " 20, and 50 for strategies other than eventDriven" << endl;
    }

    if
    (
        (collisions_.active() || motion_.wakes().active())
     && (shortest < displacement || shortest < 4*layer)
    )
    {
        WarningInFunction
            << "The domain is shorter than the relative displacement, "
            << displacement << " m, or than four Stokes layers, " << 4*layer
            << " m: particles meet periodic images that they would not meet"
            << " in the chamber, and agglomerate too fast" << endl;
    }
}


void Foam::aerosol::setupCheck::reportSettling() const
{
    if (!particles_.size() || particles_.rate.minCoeff() <= 0)
    {
        return;
    }

    const vectors speed =
        particles_.acceleration.array().rowwise()
       /particles_.rate.transpose();

    Eigen::Index i;
    const scalar fastest = speed.colwise().norm().maxCoeff(&i);

    if (fastest <= 0)
    {
        return;
    }

    const Time& time = time_;
    const scalar rest = time.endTime().value() - time.value();
    const Eigen::Array3d edges = toEigen(domain_.bounds().span());

    std::ostringstream os;
    os  << "The fastest particle settles at " << fastest << " m/s: by "
        << rest*fastest << " m until the end, "
        << rest*(speed.col(i).array().abs()/edges).maxCoeff()
        << " times through the domain";

    Info<< os.str().c_str() << nl;
}


void Foam::aerosol::setupCheck::checkBrownian() const
{
    if (!motion_.noise().active() || !particles_.size())
    {
        return;
    }

    // Of two alike, relative to one another
    const scalars displacements =
        Foam::sqrt(2.0)
       *motion_.noise().reach(time_.deltaTValue(), particles_).x;

    Eigen::Index i;
    const scalar most =
        (displacements/particles_.collisionDiameter).maxCoeff(&i);

    Info<< "Brownian motion in a fluid step, of two alike relative to one"
        << " another: at most " << most << " diameters, at "
        << particles_.collisionDiameter(i) << " m" << nl;

    if (most > 4)
    {
        WarningInFunction
            << "In one fluid step, particles of "
            << particles_.collisionDiameter(i) << " m"
            << " stray by " << most << " of their diameters relative to one"
            << " another: eventDriven resolves up to four, and misses contacts"
            << " beyond. Reduce deltaT of system/controlDict" << endl;
    }
}


void Foam::aerosol::setupCheck::reportWakes() const
{
    if (!motion_.wakes().active() || !particles_.size())
    {
        return;
    }

    const wake& model = motion_.laws().wakeModel();
    const int n = particles_.size();

    scalars range = particles_.range;
    std::sort(range.data(), range.data() + n);

    std::ostringstream os;
    os  << "Wakes act up to " << 1e6*range(0) << " um (smallest), "
        << 1e6*range(n/2) << " um (median), " << 1e6*range(n - 1)
        << " um (largest range), ";

    if (model.tolerance() > 0)
    {
        os  << "where a wake falls below the "
            << (model.needsTolerance() ? "default " : "") << "tolerance, "
            << model.tolerance() << " m/s"
            << (model.needsTolerance() || model.ends()
             ? ", or has no time to arise" : "");
    }
    else
    {
        os  << "a fixed number of diameters";
    }

    os  << ";\n    "
        << 4.0/3*constant::mathematical::pi*range.cube().sum()/domain_.volume()
        << " wakes act on a particle, on average; a wake fades out from "
        << 0.01*std::round(100*wake::fadeBegin) << " of its range on";

    Eigen::Index largest;
    particles_.mobilityDiameter.maxCoeff(&largest);

    // Nothing is known of the slip without drag, or without the level
    if
    (
        particles_.rate(largest) > 0
     && (sound_.frequency() <= 0 || sound_.expectedAmplitude() >= 0)
    )
    {
        os  << ",\n    where the wake of the largest particle is still up to "
            << motion_.wakes().fadingSpeed
               (
                   particles_, static_cast<int>(largest)
               )
            << " m/s";
    }

    Info<< os.str().c_str() << nl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::setupCheck::refuse() const
{
    requireTolerance();
    requireNoBounces();
}


void Foam::aerosol::setupCheck::report() const
{
    checkSound();
    reportSettling();
    checkBrownian();
    reportWakes();
}


// ************************************************************************* //
