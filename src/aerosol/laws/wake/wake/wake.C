/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wake.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(wake, 0);
    defineRunTimeSelectionTable(wake, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::wake> Foam::aerosol::wake::New
(
    const dictionary& dict
)
{
    return selectModel<wake>
    (
        dict,
        "wake model",
        dictionaryConstructorTablePtr_,
        dict
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::wake::save(dictionary& state) const
{
    if (needsTolerance())
    {
        state.add("wakeTolerance", tolerance());
    }
}


bool Foam::aerosol::wake::load(const dictionary& state)
{
    if (needsTolerance() && state.found("wakeTolerance"))
    {
        setTolerance(state.get<scalar>("wakeTolerance"));

        return true;
    }

    return !needsTolerance();
}


// ************************************************************************* //
