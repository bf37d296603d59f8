/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gasEntries.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::wordList Foam::acoustics::gasNames()
{
    return wordList({"rho", "mu", "T", "c", "meanFreePath"});
}


Foam::dictionary Foam::acoustics::gasEntries(const gasProperties& gas)
{
    dictionary dict;

    dict.add("rho", gas.rho);
    dict.add("mu", gas.mu);
    dict.add("T", gas.T);
    dict.add("c", gas.c);
    dict.add("meanFreePath", gas.meanFreePath);
    dict.add("Cp", gas.Cp);
    dict.add("kappa", gas.kappa);

    return dict;
}


// ************************************************************************* //
