/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bond.H"
#include "checkedDictionary.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "reducedModulus.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::bond::bond(const dictionary& dict)
:
    force_(0),
    perRadius_(0),
    work_(0),
    workPerRadius_(0),
    workPerPower_(0)
{
    requireValue(dict, "type");
    const word type(dict.get<word>("type"));

    if (type == "JKR")
    {
        requireOnly
        (
            dict, {"type", "workOfAdhesion", "YoungsModulus", "PoissonRatio"}
        );

        const scalar W =
            readPositive(dict, "workOfAdhesion", dimEnergy/dimArea);

        perRadius_ = 1.5*EIGEN_PI*W;

        if (dict.found("YoungsModulus") || dict.found("PoissonRatio"))
        {
            // a_0^2 of R = 1 m
            const scalar areaOfOne =
                std::pow
                (
                    4.5*EIGEN_PI*W/aerosol::reducedModulus(dict), 2.0/3
                );

            workPerPower_ =
                1.2*(1 + 4*std::pow(6.0, -7.0/3))*perRadius_*areaOfOne/3;
        }
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
        work_ = A/6*b/z0;
        workPerRadius_ = A/6/(b + z0);
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
    return strength(p.d(i)/std::cbrt(scalar(p.primaries(i))));
}


Foam::scalar Foam::aerosol::bond::strength(const scalar primary) const
{
    return force_ + perRadius_*0.25*primary;
}


Foam::scalar Foam::aerosol::bond::work(const scalar primary) const
{
    const scalar R = 0.25*primary;

    return work_ + workPerRadius_*R + workPerPower_*R*std::cbrt(R);
}


// ************************************************************************* //
