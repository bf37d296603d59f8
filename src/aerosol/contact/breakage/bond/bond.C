/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bond.H"
#include "checkedEntry.H"
#include "dimensionSets.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::bond::bond(const dictionary& dict)
:
    force_(0),
    perRadius_(0)
{
    const word type(dict.get<word>("type"));

    if (type == "JKR")
    {
        requireOnly(dict, {"type", "workOfAdhesion"});

        perRadius_ =
            1.5*EIGEN_PI
           *readPositive(dict, "workOfAdhesion", dimEnergy/dimArea);
    }
    else if (type == "Rumpf")
    {
        requireOnly
        (
            dict, {"type", "HamakerConstant", "asperity", "separation"}
        );

        const scalar A = readPositive(dict, "HamakerConstant", dimEnergy);
        const scalar z0 = readPositive(dict, "separation", dimLength, 0.4e-9);
        const scalar b = readNonNegative(dict, "asperity", dimLength, 0);

        force_ = A/6*b/(z0*z0);
        perRadius_ = A/6/((b + z0)*(b + z0));
    }
    else
    {
        FatalIOErrorInFunction(dict)
            << "Unknown bond '" << type << "'; valid types are JKR and Rumpf"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::bond::strength
(
    const particleArrays& p,
    const int i
) const
{
    const scalar primary = p.d(i)/std::cbrt(scalar(p.primaries(i)));

    return force_ + perRadius_*0.25*primary;
}


// ************************************************************************* //
