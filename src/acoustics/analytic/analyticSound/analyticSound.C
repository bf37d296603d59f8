/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "analyticSound.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::analyticSound::analyticSound
(
    const scalar frequency,
    const dictionary& dict
)
:
    soundField(frequency),
    gas_(gasProperties::read(dict.subOrEmptyDict("gas")))
{}


// ************************************************************************* //
