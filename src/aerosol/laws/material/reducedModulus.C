/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "reducedModulus.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::reducedModulus(const dictionary& dict)
{
    const scalar E = readPositive(dict, "YoungsModulus", dimPressure);
    const scalar nu =
        readNonNegative(dict, "PoissonRatio", dimless, 0.3);

    if (nu > 0.5)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'PoissonRatio' of " << dict.name() << " is " << nu
            << ", but it must not be above 0.5" << exit(FatalIOError);
    }

    return 0.5*E/(1 - nu*nu);
}


// ************************************************************************* //
