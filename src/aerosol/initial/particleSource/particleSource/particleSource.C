/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleSource.H"
#include "checkedDictionary.H"
#include "checkedEntry.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(particleSource, 0);
    defineRunTimeSelectionTable(particleSource, dictionary);
}
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::aerosol::particleSource::start
(
    particleArrays& particles,
    const int n
)
{
    particles.resize(n);
    particles.id.setLinSpaced(n, 0, n - 1);
    particles.v.setZero();
    particles.primaries.setOnes();
}


void Foam::aerosol::particleSource::setMasses(particleArrays& particles) const
{
    for (int i = 0; i < particles.size(); ++i)
    {
        particles.m(i) = density_*particles.volume(i);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::particleSource::particleSource(const dictionary& dict)
:
    particleSource(dict, readPositive(dict, "density", dimDensity))
{}


Foam::aerosol::particleSource::particleSource
(
    const dictionary& dict,
    const scalar density
)
:
    dict_(dict),
    density_(density)
{
    const word velocity
    (
        valueOr<word>(dict, "initialVelocity", "gas")
    );

    if (velocity != "gas" && velocity != "rest")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'initialVelocity' of " << dict.name() << " is '"
            << velocity << "', but it must be gas or rest"
            << exit(FatalIOError);
    }

    followsGas_ = velocity == "gas";
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::particleSource>
Foam::aerosol::particleSource::New
(
    const dictionary& dict
)
{
    return selectModel<particleSource>
    (
        "source",
        dict,
        "particle source",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// ************************************************************************* //
