/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "versionLine.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const char* Foam::versionLine()
{
    return "acousticDEM " ACOUSTICDEM_VERSION;
}


// ************************************************************************* //
