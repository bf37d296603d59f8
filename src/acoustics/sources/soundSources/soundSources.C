/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soundSources.H"

#include "acousticPistonFvPatchVectorField.H"
#include "acousticPressureFvPatchScalarField.H"
#include "gasProperties.H"
#include "volFields.H"

#include <cmath>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::acoustics::soundSources::agrees
(
    const source& s,
    const scalar frequency
)
{
    const scalar n = std::max(std::round(s.frequency/frequency), 1.0);

    return mag(s.frequency - n*frequency) < 1e-4*s.frequency;
}


std::string Foam::acoustics::soundSources::said(const source& s)
{
    std::ostringstream os;
    os.precision(10);
    os  << "The source at the patch " << s.patch << " in "
        << s.file << " has a frequency of " << s.frequency << " Hz";

    return os.str();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::soundSources::soundSources
(
    const volScalarField& p,
    const volVectorField& U
)
{
    const scalar now = p.time().timeOutputValue();

    const auto add = [&]
    (
        const fvPatch& patch,
        const IOobject& field,
        const bool isVelocity,
        const oscillation& what,
        const scalar ambient
    )
    {
        all_.push_back
        ({
            patch.name(), field.objectPath(), isVelocity, what.amplitude(now),
            what.frequency(now), ambient
        });
    };

    for (const fvPatchVectorField& field : U.boundaryField())
    {
        if (const auto* s = isA<acousticPistonFvPatchVectorField>(field))
        {
            add(s->patch(), U, true, s->speed(), 0);
        }
    }

    for (const fvPatchScalarField& field : p.boundaryField())
    {
        if (const auto* s = isA<acousticPressureFvPatchScalarField>(field))
        {
            add(s->patch(), p, false, s->pressure(), s->ambient());
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::soundSources::warnOfFrequency
(
    const scalar frequency,
    const std::string& entry
) const
{
    bool found = all_.empty();

    for (const source& s : all_)
    {
        found = found || mag(s.frequency - frequency) < 1e-4*frequency;
    }

    for (const source& s : all_)
    {
        if (!found || !agrees(s, frequency))
        {
            WarningInFunction
                << said(s).c_str() << ", but " << entry.c_str() << " is "
                << frequency
                << " Hz: what is said, checked and averaged per period is for"
                << " the latter" << endl;
        }
    }
}


void Foam::acoustics::soundSources::requireFrequency
(
    const scalar frequency,
    const wordList& patches,
    const dictionary& dict
) const
{
    for (const source& s : all_)
    {
        if
        (
            patches.found(s.patch)
         && mag(s.frequency - frequency) > 1e-4*frequency
        )
        {
            FatalIOErrorInFunction(dict)
                << said(s).c_str() << ", but 'frequency' of the sound whose"
                << " level it is to control is " << frequency
                << " Hz: make them the same" << exit(FatalIOError);
        }
    }
}


void Foam::acoustics::soundSources::requirePeriod
(
    const scalar frequency,
    const dictionary& dict
) const
{
    for (const source& s : all_)
    {
        if (!agrees(s, frequency))
        {
            FatalIOErrorInFunction(dict)
                << said(s).c_str() << ", but 'frequency' of the sound that is"
                << " to become periodic is " << frequency
                << " Hz: make them the same, or give 'startTime', at which the"
                << " sound is taken for periodic" << exit(FatalIOError);
        }
    }
}


void Foam::acoustics::soundSources::checkAmplitudes
(
    const scalar p,
    const gasProperties& gas
) const
{
    for (const source& s : all_)
    {
        const scalar most = s.isVelocity ? gas.c : p;
        const char* unit = s.isVelocity ? " m/s" : " Pa";

        // Not true for a number that is none
        if (!(mag(s.amplitude) < most))
        {
            FatalIOError(FUNCTION_NAME, __FILE__, __LINE__, s.file)
                << "The amplitude of the source at the patch " << s.patch
                << " is " << s.amplitude << unit
                << ", but it must be below the "
                << (s.isVelocity ? "speed of sound" : "pressure of the gas")
                << ", " << most << unit << exit(FatalIOError);
        }

        if (s.ambient > 0 && mag(s.ambient - p) > 0.01*p)
        {
            WarningInFunction
                << "'ambient' of the source at the patch " << s.patch
                << " in " << s.file.c_str() << " is " << s.ambient
                << " Pa, but the mean pressure of the gas is " << p
                << " Pa: a flow sets in" << endl;
        }
    }
}


// ************************************************************************* //
