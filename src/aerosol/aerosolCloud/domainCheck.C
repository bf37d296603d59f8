/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "domainCheck.H"

#include "chamber.H"
#include "communicator.H"
#include "domain.H"
#include "eigenVector.H"
#include "equationOfMotion.H"
#include "fvMesh.H"
#include "movingFrame.H"
#include "StringStream.H"
#include "Time.H"
#include "turbulentGas.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::domainCheck::domainCheck
(
    const dictionary& dict,
    const Time& time,
    const domain& region,
    const turbulentGas& sound,
    const equationOfMotion& motion,
    const particleArrays& particles
)
:
    dict_(dict),
    time_(time),
    domain_(region),
    sound_(sound),
    motion_(motion),
    particles_(particles),
    largestAmplitude_(0),
    outgrown_(false)
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::domain>
Foam::aerosol::domainCheck::domainInMesh
(
    const dictionary& dict,
    const fvMesh& mesh
)
{
    autoPtr<domain> made(domain::New(dict));

    const boundBox& box = made->bounds();
    const chamber room(mesh);

    if (!room.contains(box))
    {
        OStringStream where;

        if (room.bounds().contains(box))
        {
            const chamber::encounter wall = room.first(box, Zero);

            where << ". That is not of the shape of a box";
            if (wall.time == 0)
            {
                where << ": a part of its boundary, at " << wall.place
                    << ", lies in the domain";
            }
        }

        FatalIOErrorInFunction(dict)
            << "The domain of the particles, " << box.min() << " to "
            << box.max() << " m, leaves the mesh, which extends from "
            << room.bounds().min() << " to " << room.bounds().max() << " m"
            << where.str().c_str()
            << ". Change 'centre' or 'length', or make the mesh larger"
            << exit(FatalIOError);
    }

    return made;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::domainCheck::requireAtRest(const movingFrame& frame) const
{
    if (!domain_.representative() && frame.domainMoves())
    {
        FatalIOErrorInFunction(dict_.subDict("domain"))
            << "A domain that moves cannot have a resolved sound: leave out"
            << " 'frame', or set 'sound' to representative"
            << exit(FatalIOError);
    }
}


void Foam::aerosol::domainCheck::requireNoShear() const
{
    if (!domain_.representative() || sound_.frequency() > 0)
    {
        return;
    }

    const Eigen::Matrix3d gradient = sound_.gradient(time_.value());

    if (!gradient.isZero(0))
    {
        FatalIOErrorInFunction(dict_.subDict("domain"))
            << "The gas has a steady velocity gradient of " << gradient.norm()
            << " 1/s, and a periodic domain has not: the images of a particle"
            << " would have the velocity of the particle itself, not that of"
            << " the gas where they are. For rates of collision in a shear,"
            << " use 'turbulence' with its 'shearRate' in a gas that is"
            << " quiescent"
            << exit(FatalIOError);
    }
}


void Foam::aerosol::domainCheck::requireCoupling
(
    const movingFrame& frame
) const
{
    if (frame.domainMoves())
    {
        FatalIOErrorInFunction(dict_.subDict("coupling"))
            << "A domain that moves stands for no part of the chamber:"
            << " coupling must be of type none"
            << exit(FatalIOError);
    }

    // Particles act where they are, and feel the gas at the centre
    const scalar longest = 0.05*sound_.gas().c/max(sound_.frequency(), SMALL);

    const scalar edge = cmptMax(domain_.bounds().span());

    if (domain_.representative() && edge > longest)
    {
        FatalIOErrorInFunction(dict_.subDict("domain"))
            << "A domain that acts on the gas, and is longer than "
            << longest << " m, a twentieth of the wavelength, must have a"
            << " resolved sound: its particles act on the gas where they"
            << " are, and must feel it there. Set 'sound' to resolved"
            << exit(FatalIOError);
    }
}


void Foam::aerosol::domainCheck::refuse() const
{
    const dictionary& dict = dict_.subDict("domain");
    const scalar shortest = domain_.bounds().minDim();

    // A particle must not feel a neighbour and its image at once
    const auto requireRange = [&]
    (
        const char* what,
        const scalar range,
        const char* remedy
    )
    {
        if (2*range > shortest)
        {
            FatalIOErrorInFunction(dict)
                << "The shortest edge of the domain, " << shortest
                << " m, is less than twice the largest " << what << ", "
                << range << " m: particles would meet a neighbour and its"
                << " periodic image at once. Make the domain larger or the "
                << what << " smaller" << remedy
                << exit(FatalIOError);
        }
    };

    requireRange
    (
        "range of contact",
        particles_.collisionDiameter.maxCoeff(),
        ""
    );
    requireRange
    (
        "range of the wakes",
        particles_.range.maxCoeff(),
        motion_.laws().wakeModel().tolerance() > 0
      ? ", by a larger 'tolerance' or by a fixed 'range' in the dictionary"
        " 'wake'"
      : ", by 'range' in the dictionary 'wake'"
    );
}


void Foam::aerosol::domainCheck::requirePeriodicSound(const scalar t)
{
    if (domain_.representative())
    {
        return;
    }

    // Nine points of each face
    const boundBox& box = domain_.bounds();

    // Not that of the moment, if no level is expected
    largestAmplitude_ = std::max(largestAmplitude_, sound_.velocityAmplitude());
    const scalar amplitude =
        sound_.expectedAmplitude() >= 0 ? sound_.expectedAmplitude()
      : largestAmplitude_;

    for (direction k = 0; k < vector::nComponents; ++k)
    {
        vectors low(3, 9);
        vectors high(3, 9);

        for (int n = 0; n < 9; ++n)
        {
            vector place(0, 0, 0);
            place[(k + 1) % 3] = 0.1 + 0.4*(n % 3);
            place[(k + 2) % 3] = 0.1 + 0.4*(n/3);

            const point onLow = box.min() + cmptMultiply(place, box.span());

            low.col(n) = toEigen(onLow);
            high.col(n) = low.col(n);
            high(k, n) = box.max()[k];
        }

        vectors before, after;
        sound_.acoustics::localSound::velocity(t, low, before);
        sound_.acoustics::localSound::velocity(t, high, after);

        const scalar difference =
            (after - before).colwise().norm().maxCoeff();

        if (difference > 0.01*amplitude + 1e-9)
        {
            FatalIOErrorInFunction(dict_.subDict("domain"))
                << "At time " << time_.timeName() << " the gas at"
                << " opposite faces of the domain, normal to direction "
                << label(k) << ", differs by " << difference << " m/s, of a"
                << " velocity amplitude of " << amplitude << " m/s. With"
                << " 'sound resolved' it must be the same there, as in a box"
                << " from one wall at rest to another, or as long as whole"
                << " wavelengths: set 'sound' to representative"
                << exit(FatalIOError);
        }
    }
}


void Foam::aerosol::domainCheck::warnOfGrowth()
{
    const scalar range = communicator::max
    (
        particles_.size()
      ? std::max
        (
            particles_.range.maxCoeff(),
            particles_.collisionDiameter.maxCoeff()
        )
      : 0.0
    );

    if (!outgrown_ && 2*range > domain_.bounds().minDim())
    {
        WarningInFunction
            << "At time " << time_.timeName() << " twice the range of"
            << " the wake, or of contact, of the largest aggregate, "
            << 2*range << " m, exceeds the shortest edge of the domain, "
            << domain_.bounds().minDim() << " m (it has grown, or 'wake' has"
            << " changed): its neighbours feel it together with its periodic"
            << " images from now on" << endl;

        outgrown_ = true;
    }
}


// ************************************************************************* //
