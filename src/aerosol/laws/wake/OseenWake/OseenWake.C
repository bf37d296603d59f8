/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "OseenWake.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(OseenWake, 0);
    addToRunTimeSelectionTable(wake, OseenWake, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::OseenWake::OseenWake
(
    const dictionary& dict,
    const wordList& others
)
:
    range_(readPositive(dict, "range", dimless, 0)),
    needsTolerance_(!dict.found("range") && !dict.found("tolerance")),
    tolerance_(readPositive(dict, "tolerance", dimVelocity, 0))
{
    if (dict.found("range") && dict.found("tolerance"))
    {
        FatalIOErrorInFunction(dict)
            << "The wake can have either 'range' (in diameters of the source)"
            << " or 'tolerance' (the disturbance in m/s that may be left out),"
            << " or neither for the default tolerance; " << dict.name()
            << " has both"
            << exit(FatalIOError);
    }

    wordList valid{"type", "range", "tolerance"};
    valid.append(others);
    requireOnly(dict, valid);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::aerosol::scalars Foam::aerosol::OseenWake::range
(
    const scalars& d,
    const scalars& slip
) const
{
    if (range_ > 0)
    {
        return range_*d;
    }

    if (tolerance_ <= 0)
    {
        FatalErrorInFunction
            << "No tolerance has been set"
            << exit(FatalError);
    }

    return 0.75*d*slip/tolerance_;
}


void Foam::aerosol::OseenWake::evaluate
(
    block& pairs,
    const acoustics::gasProperties& gas
) const
{
    // Loops that the compiler turns into vector instructions; see that it does
    // (-fopt-info-vec) when they change. Choices in longer ones would make it
    // branch. The roots and the exponential are Eigen's, in vectors already.

    const blockVectors& s = pairs.r;
    const blockVectors& U = pairs.slip;

    blockScalars distanceSqr, speedSqr, along, upstream, chi;

    for (int b = 0; b < blockSize; ++b)
    {
        distanceSqr(b) =
            s[0](b)*s[0](b) + s[1](b)*s[1](b) + s[2](b)*s[2](b);

        // Not quite zero: Eigen's AVX-512 root of zero raises an exception
        speedSqr(b) =
            U[0](b)*U[0](b) + U[1](b)*U[1](b) + U[2](b)*U[2](b) + 1e-60;
    }

    const blockScalars perDistance = distanceSqr.rsqrt();
    const blockScalars speed = speedSqr.sqrt();
    const double factor = 0.5/gas.nu();

    for (int b = 0; b < blockSize; ++b)
    {
        // U cos(theta), U (1 - cos(theta)), which rounding may make negative
        along(b) =
            (U[0](b)*s[0](b) + U[1](b)*s[1](b) + U[2](b)*s[2](b))
           *perDistance(b);
        const double difference = speed(b) - along(b);
        upstream(b) = difference > 0 ? difference : 0;

        const double distance = distanceSqr(b)*perDistance(b);
        const double a = pairs.radius(b);
        chi(b) = factor*(distance > a ? distance : a)*upstream(b);
    }

    const blockScalars E = (-chi).exp();

    // (1 - E)/chi, by its series where the difference would cancel. Both are
    // worked out everywhere before the choice, which then needs no branch.
    blockScalars quotient, series, sink, inverseR;

    for (int b = 0; b < blockSize; ++b)
    {
        const double x = chi(b);
        quotient(b) = (1 - E(b))/(x > 1e-3 ? x : 1e-3);
        series(b) = 1 - x*(0.5 - x*(1.0/6 - x*(1.0/24)));

        const double ratio = pairs.radius(b)*perDistance(b);
        inverseR(b) = ratio < 1 ? ratio : 1;
    }

    for (int b = 0; b < blockSize; ++b)
    {
        const double small = series(b);
        const double large = quotient(b);
        sink(b) = chi(b) < 1e-3 ? small : large;
    }

    blockScalars outward, transverse;

    for (int b = 0; b < blockSize; ++b)
    {
        const double q = inverseR(b);
        const double dipole = 0.25*q*q*q;

        const double radial =
            2*dipole*along(b)
          + 0.75*q*(upstream(b)*sink(b) - (speed(b) + along(b))*E(b));

        transverse(b) = dipole + 0.75*q*E(b);

        // The unit vector of theta is (cos(theta) e - U/|U|)/sin(theta), with
        // e that to the target
        outward(b) =
            (radial + transverse(b)*along(b))*perDistance(b);
    }

    for (int k = 0; k < 3; ++k)
    {
        pairs.velocity[k] = outward*s[k] - transverse*U[k];
    }
}


// ************************************************************************* //
