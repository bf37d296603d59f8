/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "airProperties.H"

#include "error.H"
#include "gasComposition.H"

#include <cmath>
#include <sstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Sutherland's temperature of air [K]
constexpr double Sutherland = 110.4;

//- Conductivity of air [W/m/K]
constexpr Foam::acoustics::gasComposition::SutherlandLaw conductivity
{
    0.0241, 273, 194
};

//- What a gas can have, and the largest temperature and pressure [K], [Pa]
constexpr double coldest = 100;
constexpr double cold = 200;
constexpr double hottest = 5000;
constexpr double thinnest = 500;
constexpr double densest = 1e8;

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::acoustics::gasProperties Foam::acoustics::airAt
(
    const scalar T,
    const scalar p
)
{
    const gasProperties reference = gasProperties::air();
    const gasComposition composition = gasComposition::air();
    const scalar ratio = T/reference.T;

    gasProperties gas;

    gas.T = T;
    gas.rho = reference.rho*(p/atmosphere)/ratio;
    gas.mu =
        reference.mu*ratio*std::sqrt(ratio)
       *(reference.T + Sutherland)/(T + Sutherland);
    gas.Cp = composition.Cp(T);
    gas.c =
        reference.c
       *std::sqrt(ratio*composition.gamma(T)/composition.gamma(reference.T));
    gas.kappa = conductivity.at(T);
    gas.meanFreePath =
        reference.meanFreePath*(gas.mu/reference.mu)*(reference.rho/gas.rho)
       /std::sqrt(ratio);

    return gas;
}


void Foam::acoustics::requirePlausible
(
    const scalar p,
    const scalar T,
    const string& file,
    const label line
)
{
    std::ostringstream why;

    // Not true for numbers that are none
    if (!(T >= coldest && T <= hottest))
    {
        why << "The temperature of the gas is " << T << " K, but it must be"
            << " absolute, from " << coldest << " to " << hottest
            << " K: is it in degrees Celsius? Add 273.15";
    }
    else if (!(p >= thinnest && p <= densest))
    {
        why << "The pressure of the gas is " << p << " Pa, but it must be"
            << " absolute, from " << thinnest << " to " << densest
            << " Pa: is it a gauge pressure (add 101325), or in bar?";
    }

    if (!why.str().empty())
    {
        FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, file, line)
            << why.str().c_str() << exit(FatalIOError);
    }

    if (T < cold)
    {
        WarningInFunction
            << "The temperature of the gas is " << T << " K in " << file.c_str()
            << ": is it in degrees Celsius? Add 273.15 then" << endl;
    }
}


Foam::Ostream& Foam::acoustics::operator<<
(
    Ostream& os,
    const gasProperties& gas
)
{
    os  << "density " << gas.rho << " kg/m3, viscosity " << gas.mu
        << " Pa s, temperature " << gas.T << " K, sound speed " << gas.c
        << " m/s, mean free path " << gas.meanFreePath
        << " m, heat capacity " << gas.Cp << " J/kg/K, conductivity "
        << gas.kappa << " W/m/K";

    return os;
}


// ************************************************************************* //
