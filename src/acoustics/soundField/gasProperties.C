/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gasProperties.H"

#include "airProperties.H"
#include "checkedEntry.H"
#include "dictionary.H"
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

    return gas;
}


Foam::acoustics::gasProperties Foam::acoustics::gasProperties::read
(
    const dictionary& dict
)
{
    requireOnly(dict, {"T", "p", "rho", "mu", "c", "meanFreePath"});

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

    gasProperties gas = airAt(T, p);

    gas.rho = readPositive(dict, "rho", dimDensity, gas.rho);
    gas.mu = readPositive(dict, "mu", dimDynamicViscosity, gas.mu);
    gas.c = readPositive(dict, "c", dimVelocity, gas.c);
    gas.meanFreePath = readPositive
    (
        dict, "meanFreePath", dimLength, airMeanFreePath(gas)
    );

    return gas;
}


// ************************************************************************* //
