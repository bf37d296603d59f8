/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "replayQuality.H"

#include "checkedEntry.H"
#include "dictionary.H"

// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::acoustics::replayQuality Foam::acoustics::replayQuality::read
(
    const dictionary& dict
)
{
    replayQuality quality;

    quality.difference = readNonNegative(dict, "difference", dimless, -1);
    quality.change = readNonNegative(dict, "change", dimless, -1);

    return quality;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::replayQuality::write(dictionary& dict) const
{
    dict.add("difference", difference, true);
    dict.add("change", change, true);
}


void Foam::acoustics::replayQuality::report() const
{
    if (difference < 0 || change < 0)
    {
        WarningInFunction
            << "It is not known how well the fields that are replayed stand for"
            << " the sound of which they were made" << endl;

        return;
    }

    Info<< "    the sound that was solved differs from its mean and harmonics"
        << " by " << 100*difference << " % rms of the velocity amplitude, and"
        << " changed by " << 100*change << " % in its last period" << endl;

    warn();
}


void Foam::acoustics::replayQuality::warn() const
{
    if (difference > limit)
    {
        WarningInFunction
            << "The mean and the harmonics miss " << 100*difference
            << " % of the sound, more than " << 100*limit << " %: it is not"
            << " periodic, or has more harmonics. Solve it for longer, or raise"
            << " 'harmonics'" << endl;
    }

    if (change > limit)
    {
        WarningInFunction
            << "The sound is not periodic: it changed by " << 100*change
            << " % in the last period that was solved, more than "
            << 100*limit << " %. What is replayed is one period of it. Solve it"
            << " for longer" << endl;
    }
}


// ************************************************************************* //
