/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundLevel.H"

#include "checkedEntry.H"
#include "dictionary.H"
#include "gasProperties.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::soundLevel::soundLevel
(
    const scalar pAmplitude,
    const scalar uAmplitude
)
:
    pAmplitude_(pAmplitude),
    uAmplitude_(uAmplitude)
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::acoustics::soundLevel Foam::acoustics::soundLevel::fromSPL
(
    const scalar SPL,
    const gasProperties& gas
)
{
    const scalar pAmplitude =
        std::sqrt(2.0)*pReference*std::pow(10.0, SPL/20);

    return soundLevel(pAmplitude, pAmplitude/(gas.rho*gas.c));
}


Foam::acoustics::soundLevel Foam::acoustics::soundLevel::fromVelocity
(
    const scalar uAmplitude,
    const gasProperties& gas
)
{
    return soundLevel(gas.rho*gas.c*uAmplitude, uAmplitude);
}


Foam::acoustics::soundLevel Foam::acoustics::soundLevel::read
(
    const dictionary& dict,
    const gasProperties& gas
)
{
    if (dict.found("SPL") == dict.found("velocityAmplitude"))
    {
        FatalIOErrorInFunction(dict)
            << "Give exactly one of the entries SPL (dB, rms, at the pressure"
            << " antinode) and velocityAmplitude (m/s, peak)"
            << exit(FatalIOError);
    }

    // The mean pressure of a gas of two atoms; nothing goes below vacuum, and
    // what sound is ends earlier
    const scalar most = 0.5*gas.rho*sqr(gas.c)/1.4;

    const auto refuse = [&]
    (
        const char* key,
        const scalar value,
        const scalar end
    )
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name() << " is " << value
            << ", but above " << end << " the amplitude would be more than half"
            << " the pressure of the gas: there is no such sound"
            << exit(FatalIOError);
    };

    if (dict.found("SPL"))
    {
        const scalar SPL = readFinite(dict, "SPL", dimless);
        const scalar loudest = soundLevel::SPL(most/std::sqrt(2.0));

        if (SPL > loudest)
        {
            refuse("SPL", SPL, loudest);
        }

        return fromSPL(SPL, gas);
    }

    const scalar u = readNonNegative(dict, "velocityAmplitude", dimVelocity, 0);
    const scalar fastest = most/(gas.rho*gas.c);

    if (u > fastest)
    {
        refuse("velocityAmplitude", u, fastest);
    }

    return fromVelocity(u, gas);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::soundLevel::pRms() const
{
    return pAmplitude_/std::sqrt(2.0);
}


Foam::scalar Foam::acoustics::soundLevel::SPL() const
{
    return SPL(pRms());
}


Foam::scalar Foam::acoustics::soundLevel::SPL(const scalar pRms)
{
    // Silence is a level of minus infinity, which cannot be printed
    constexpr scalar silence = 1e-10;

    return 20*std::log10(std::max(pRms, silence)/pReference);
}


// * * * * * * * * * * * * * * * Global Operators  * * * * * * * * * * * * * //

Foam::Ostream& Foam::acoustics::operator<<
(
    Ostream& os,
    const soundLevel& level
)
{
    os  << level.SPL() << " dB: p_rms " << level.pRms()
        << " Pa, p_amp " << level.pAmplitude()
        << " Pa at the pressure antinode, u0 " << level.uAmplitude()
        << " m/s at the velocity antinode";

    return os;
}


// ************************************************************************* //
