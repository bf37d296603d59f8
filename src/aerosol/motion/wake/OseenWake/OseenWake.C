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

Foam::aerosol::OseenWake::OseenWake(const dictionary& dict)
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

    requireOnly(dict, {"type", "range", "tolerance"});
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
    const blockVectors& s = pairs.r;
    const blockVectors& U = pairs.slip;

    const blockScalars distance =
        (s[0].square() + s[1].square() + s[2].square()).sqrt();

    // Not quite zero: Eigen's AVX-512 root of zero raises an exception
    const blockScalars speed =
        (U[0].square() + U[1].square() + U[2].square() + 1e-60).sqrt();

    // Unit vector e to the target, and U cos(theta)
    const blockScalars e0 = s[0]/distance;
    const blockScalars e1 = s[1]/distance;
    const blockScalars e2 = s[2]/distance;
    const blockScalars along = U[0]*e0 + U[1]*e1 + U[2]*e2;

    const blockScalars r = distance.max(pairs.radius);
    const blockScalars inverseR = pairs.radius/r;
    const blockScalars dipole = 0.25*inverseR.cube();

    // Rounding may make cos(theta) exceed one
    const blockScalars upstream = (speed - along).max(0.0);
    const blockScalars chi = (0.5/gas.nu())*r*upstream;
    const blockScalars E = (-chi).exp();

    // (1 - E)/chi, by its series where the difference would cancel
    const blockScalars large = chi.max(1e-3);
    const blockScalars sink =
        (chi < 1e-3).select
        (
            1 - chi*(0.5 - chi*(1.0/6 - chi/24)),
            (1 - E)/large
        );

    const blockScalars radial =
        2*dipole*along
      + 0.75*inverseR*(upstream*sink - (speed + along)*E);

    const blockScalars transverse = dipole + 0.75*inverseR*E;

    // The unit vector of theta is (cos(theta) e - U/|U|)/sin(theta)
    const blockScalars outward = radial + transverse*along;

    pairs.velocity[0] = outward*e0 - transverse*U[0];
    pairs.velocity[1] = outward*e1 - transverse*U[1];
    pairs.velocity[2] = outward*e2 - transverse*U[2];
}


// ************************************************************************* //
