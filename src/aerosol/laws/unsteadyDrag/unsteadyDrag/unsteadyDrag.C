/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unsteadyDrag.H"
#include "noUnsteadyDrag.H"
#include "selectModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(unsteadyDrag, 0);
    defineRunTimeSelectionTable(unsteadyDrag, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::unsteadyDrag> Foam::aerosol::unsteadyDrag::New
(
    const dictionary& laws,
    const scalar frequency
)
{
    if (!laws.found("unsteadyDrag"))
    {
        return autoPtr<unsteadyDrag>(new noUnsteadyDrag());
    }

    const dictionary& dict = laws.subDict("unsteadyDrag");

    return selectModel<unsteadyDrag>
    (
        dict,
        "unsteady drag",
        dictionaryConstructorTablePtr_,
        dict,
        frequency
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::unsteadyDrag::save(dictionary& state) const
{
    if (times().size())
    {
        List<scalar> list(times().size());
        std::copy(times().data(), times().data() + list.size(), list.begin());

        state.add("historyTimes", list);
    }
}


bool Foam::aerosol::unsteadyDrag::continues(const dictionary& state) const
{
    const List<scalar> before
    (
        state.getOrDefault<List<scalar>>("historyTimes", List<scalar>())
    );

    bool same = before.size() == times().size() && !state.empty();

    for (int j = 0; same && j < times().size(); ++j)
    {
        same = mag(before[j] - times()(j)) < 1e-4*times()(j);
    }

    return same;
}


// ************************************************************************* //
