/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gasComposition.H"

#include "checkedDictionary.H"
#include "thermodynamicConstants.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;
using species = Foam::acoustics::gasComposition::species;

//- Limits of the polynomials [K]
constexpr scalar coldest = 200;
constexpr scalar hottest = 6000;

//- By how much the sum of the mole fractions may differ from 1
constexpr scalar tolerance = 0.002;

const species known[] =
{
    {
        "Ar", 39.948,
        {2.5, 0, 0, 0, 0},
        {2.5, 0, 0, 0, 0},
        {2.125e-5, 273, 144},
        {0.0163, 273, 170}
    },
    {
        "CO", 28.0106,
        {3.57953, -6.10354e-4, 1.01681e-6, 9.07006e-10, -9.04424e-13},
        {3.04849, 1.35173e-3, -4.85794e-7, 7.88536e-11, -4.69807e-15},
        {1.657e-5, 273, 136},
        {0.0232, 273, 180}
    },
    {
        "CO2", 44.01,
        {2.35681, 8.98413e-3, -7.12206e-6, 2.4573e-9, -1.42885e-13},
        {4.63651, 2.74146e-3, -9.95898e-7, 1.60387e-10, -9.16199e-15},
        {1.370e-5, 273, 222},
        {0.0146, 273, 1800}
    },
    {
        "H2O", 18.0153,
        {4.19864, -2.0364e-3, 6.52034e-6, -5.48793e-9, 1.77197e-12},
        {2.67704, 2.97318e-3, -7.73769e-7, 9.44335e-11, -4.269e-15},
        {1.12e-5, 350, 1064},
        {0.0181, 300, 2200}
    },
    {
        "N2", 28.0134,
        {3.53101, -1.23661e-4, -5.02999e-7, 2.43531e-9, -1.40881e-12},
        {2.95258, 1.3969e-3, -4.92632e-7, 7.8601e-11, -4.60755e-15},
        {1.663e-5, 273, 107},
        {0.0242, 273, 150}
    },
    {
        "O2", 31.9988,
        {3.78246, -2.99673e-3, 9.8473e-6, -9.6813e-9, 3.24373e-12},
        {3.66096, 6.56366e-4, -1.4115e-7, 2.05798e-11, -1.29913e-15},
        {1.919e-5, 273, 139},
        {0.0244, 273, 240}
    }
};


const species& speciesOf(const Foam::word& name)
{
    return *std::find_if
    (
        std::begin(known),
        std::end(known),
        [&](const species& s) { return name == s.name; }
    );
}


Foam::wordList speciesNames()
{
    Foam::wordList names;

    for (const species& s : known)
    {
        names.append(s.name);
    }

    return names;
}


//- Gas constant [J/kmol/K]
scalar R()
{
    return Foam::constant::thermodynamic::RR;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::gasComposition::species::Cp(const scalar T) const
{
    const scalar t = std::clamp(T, coldest, hottest);
    const scalar (&a)[5] = t < 1000 ? low : high;

    return R()*(a[0] + t*(a[1] + t*(a[2] + t*(a[3] + t*a[4]))));
}


Foam::scalar Foam::acoustics::gasComposition::SutherlandLaw::at
(
    const scalar T
) const
{
    return value*std::pow(T/T0, 1.5)*(T0 + S)/(T + S);
}


Foam::scalar Foam::acoustics::gasComposition::W() const
{
    scalar sum = 0;

    for (const part& one : parts_)
    {
        sum += one.x*one.of->W;
    }

    return sum;
}


Foam::scalar Foam::acoustics::gasComposition::Cp(const scalar T) const
{
    scalar sum = 0;

    for (const part& one : parts_)
    {
        sum += one.x*one.of->Cp(T);
    }

    return sum/W();
}


Foam::scalar Foam::acoustics::gasComposition::gamma(const scalar T) const
{
    return Cp(T)/(Cp(T) - R()/W());
}


Foam::acoustics::gasProperties Foam::acoustics::gasComposition::at
(
    const scalar T,
    const scalar p
) const
{
    gasProperties gas;

    gas.T = T;
    gas.rho = p*W()/(R()*T);
    gas.c = std::sqrt(gamma(T)*R()*T/W());
    gas.Cp = Cp(T);
    gas.mu = 0;
    gas.kappa = 0;

    for (const part& i : parts_)
    {
        const scalar mui = i.of->mu.at(T);
        scalar sum = 0;

        for (const part& j : parts_)
        {
            const scalar ratio = i.of->W/j.of->W;

            sum +=
                j.x
               *std::pow
                (
                    1
                  + std::sqrt(mui/j.of->mu.at(T))*std::pow(ratio, -0.25),
                    2
                )
               /std::sqrt(8*(1 + ratio));
        }

        gas.mu += i.x*mui/sum;
        gas.kappa += i.x*i.of->kappa.at(T)/sum;
    }

    gas.meanFreePath =
        gasProperties::kineticMeanFreePath(gas.mu, gas.rho, T, W());

    return gas;
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::acoustics::gasComposition Foam::acoustics::gasComposition::air()
{
    gasComposition air;

    air.parts_ =
    {
        {&speciesOf("N2"), 0.7808},
        {&speciesOf("O2"), 0.2095},
        {&speciesOf("Ar"), 0.0093},
        {&speciesOf("CO2"), 0.0004}
    };

    return air;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::gasComposition::gasComposition(const dictionary& dict)
{
    const wordList names(speciesNames());

    requireOnly(dict, names);

    scalar sum = 0;

    for (const word& name : names)
    {
        const scalar x = readNonNegative(dict, name, dimless, 0);

        if (x > 0)
        {
            parts_.push_back({&speciesOf(name), x});
            sum += x;
        }
    }

    if (!(std::abs(sum - 1) < tolerance))
    {
        FatalIOErrorInFunction(dict)
            << "The mole fractions in " << dict.name() << " add up to " << sum
            << ", but the sum must be 1, within " << tolerance
            << "; the species are " << names
            << exit(FatalIOError);
    }

    for (part& one : parts_)
    {
        one.x /= sum;
    }
}


// ************************************************************************* //
