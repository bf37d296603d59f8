/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "analyticSound.H"

#include "checkedDictionary.H"
#include "eigenVector.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::analyticSound::analyticSound
(
    const scalar frequency,
    const dictionary& dict
)
:
    soundField(frequency),
    gas_(gasProperties::read(optionalDict(dict, "gas")))
{}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

Eigen::Vector3d Foam::acoustics::analyticSound::readFlow
(
    const dictionary& dict
) const
{
    const vector flow =
        Foam::readVector(dict, "velocity", dimVelocity, vector::zero);

    // Componentwise: the square of a huge number is none
    if (cmptMax(cmptMag(flow)) > gas_.c)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'velocity' of " << dict.name() << " is " << flow
            << " m/s, but the gas must not flow faster than sound, at "
            << gas_.c << " m/s" << exit(FatalIOError);
    }

    return toEigen(flow);
}


// ************************************************************************* //
