/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gasProperties.H"

#include "airProperties.H"
#include "checkedDictionary.H"
#include "gasComposition.H"
#include "mathematicalConstants.H"
#include "thermodynamicConstants.H"

#include <cmath>

// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::gasProperties::kineticMeanFreePath
(
    const scalar mu,
    const scalar rho,
    const scalar T,
    const scalar M
)
{
    using constant::mathematical::pi;

    // J/kmol/K, as M is in kg/kmol
    const scalar R = constant::thermodynamic::RR;

    return mu/rho*std::sqrt(pi*M/(2*R*T));
}


Foam::acoustics::gasProperties Foam::acoustics::gasProperties::air()
{
    gasProperties gas;

    gas.rho = 1.204;
    gas.mu = 1.81e-5;
    gas.T = 293.15;
    gas.c = 343.2;
    gas.meanFreePath = 66e-9;
    gas.Cp = 1005;
    gas.kappa = 0.0257;

    return gas;
}


Foam::acoustics::gasProperties Foam::acoustics::gasProperties::read
(
    const dictionary& dict
)
{
    requireOnly
    (
        dict,
        {"type", "composition", "T", "p", "rho", "mu", "c", "meanFreePath",
         "Cp", "kappa"}
    );

    const word type(valueOr<word>(dict, "type", "air"));
    const bool isMixture = type == "mixture";

    if (type != "air" && !isMixture)
    {
        FatalIOErrorInFunction(dict)
            << "Unknown gas '" << visible(type).c_str() << "' in "
            << dict.name() << "; valid types are air and mixture"
            << exit(FatalIOError);
    }

    const dictionary fractions(optionalDict(dict, "composition"));

    if (isMixture != dict.found("composition"))
    {
        FatalIOErrorInFunction(dict)
            << "A gas of type mixture, and no other, needs a dictionary"
            << " 'composition' of mole fractions; " << dict.name() << " has "
            << (isMixture ? "none" : "one, but is of type air")
            << exit(FatalIOError);
    }

    const scalar T = readPositive(dict, "T", dimTemperature, air().T);
    const scalar p = readPositive(dict, "p", dimPressure, atmosphere);

    requirePlausible(p, T, dict.name(), dict.startLineNumber());

    if (dict.found("p") && dict.found("rho"))
    {
        FatalIOErrorInFunction(dict)
            << "The density of a perfect gas follows from 'p' and 'T': give"
            << " either 'p' or 'rho' in " << dict.name()
            << exit(FatalIOError);
    }

    gasProperties gas =
        isMixture ? gasComposition(fractions).at(T, p) : airAt(T, p);

    const scalar nuBefore = gas.nu();

    gas.rho = readPositive(dict, "rho", dimDensity, gas.rho);
    gas.mu = readPositive(dict, "mu", dimDynamicViscosity, gas.mu);
    gas.c = readPositive(dict, "c", dimVelocity, gas.c);
    gas.Cp = readPositive(dict, "Cp", dimSpecificHeatCapacity, gas.Cp);
    gas.kappa =
        readPositive
        (
            dict, "kappa", dimPower/dimLength/dimTemperature, gas.kappa
        );

    // At that temperature it goes with the kinematic viscosity
    gas.meanFreePath = readPositive
    (
        dict,
        "meanFreePath",
        dimLength,
        gas.meanFreePath*(gas.nu()/nuBefore)
    );

    return gas;
}


// ************************************************************************* //
