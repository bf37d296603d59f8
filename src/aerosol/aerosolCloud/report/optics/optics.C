/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "optics.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <limits>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::optics::optics(const dictionary& dict)
:
    wavelength_(readPositive(dict, "wavelength", dimLength)),
    refractiveIndex_(readPositive(dict, "refractiveIndex", dimless)),
    path_(readPositive(dict, "path", dimLength))
{
    requireOnly(dict, {"wavelength", "refractiveIndex", "path"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::aerosol::optics::efficiency(const double d) const
{
    using constant::mathematical::pi;

    const double rho = 2*pi*d/wavelength_*(refractiveIndex_ - 1);
    const double square = rho*rho;

    // What is left of the difference has no digits otherwise
    if (square < 0.01)
    {
        return square/2*(1 - square/18*(1 - square/40));
    }

    return 2 - 4/rho*std::sin(rho) + 4/square*(1 - std::cos(rho));
}


double Foam::aerosol::optics::crossSection(const double d) const
{
    return efficiency(d)*constant::mathematical::pi/4*d*d;
}


double Foam::aerosol::optics::transmittance(const double extinction) const
{
    return std::exp(-extinction*path_);
}


double Foam::aerosol::optics::visibility(const double extinction)
{
    return
        extinction > 0
      ? -std::log(0.02)/extinction
      : std::numeric_limits<double>::infinity();
}


// ************************************************************************* //
