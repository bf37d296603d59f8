/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "versionLine.H"

#if __has_include("acousticDEMVersion.H")
    #include "acousticDEMVersion.H"
#else
    #define ACOUSTICDEM_VERSION "of unknown version: run Allwmake"
#endif

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

const char* Foam::versionLine()
{
    return "acousticDEM " ACOUSTICDEM_VERSION;
}


// ************************************************************************* //
