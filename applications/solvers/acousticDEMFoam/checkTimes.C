/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "checkTimes.H"

#include "Time.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::checkTimes(const Time& time)
{
    const dictionary& dict = time.controlDict();
    const scalar h = time.deltaTValue();
    const scalar now = time.value();
    const scalar end = time.endTime().value();

    // Not true for numbers that are none
    if (!(h > 0 && h < VGREAT))
    {
        FatalIOErrorInFunction(dict)
            << "'deltaT' is " << h << " s, but it must be positive: a fiftieth"
            << " of the period of the sound, say" << exit(FatalIOError);
    }

    if (!(mag(now) < VGREAT && mag(end) < VGREAT))
    {
        FatalIOErrorInFunction(dict)
            << "The run is from " << now << " s to 'endTime' " << end
            << " s, but both must be finite numbers" << exit(FatalIOError);
    }

    if (now + h == now)
    {
        FatalIOErrorInFunction(dict)
            << "'deltaT' " << h << " s is too short for a time of " << now
            << " s: their sum is not a later time" << exit(FatalIOError);
    }

    if (end < now - 0.5*h)
    {
        WarningInFunction
            << "'endTime' " << end << " s in " << dict.name().c_str()
            << " is before the time at which the run starts, " << now
            << " s: there is nothing to do" << endl;
    }
    else if (end < now + 0.5*h)
    {
        Info<< "The case has been run up to 'endTime' " << end << " s: there is"
            << " nothing to do. To go on, make 'endTime' larger" << nl << endl;
    }
}


// ************************************************************************* //
