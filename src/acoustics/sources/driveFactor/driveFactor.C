/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "driveFactor.H"

#include "fvMesh.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::word Foam::acoustics::driveFactor::name_("driveFactor");


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::driveFactor::driveFactor
(
    const fvMesh& mesh,
    const wordList& patches
)
:
    stateDictionary(name_, mesh, {"from", "to", "begin", "end"}),
    patches_(patches),
    from_(getOrDefault<scalar>("from", 1)),
    to_(getOrDefault<scalar>("to", 1)),
    begin_(getOrDefault<scalar>("begin", -GREAT)),
    end_(getOrDefault<scalar>("end", -GREAT))
{
    // A restart before the first change finds all of it, too
    add("from", from_, true);
    add("to", to_, true);
    add("begin", begin_, true);
    add("end", end_, true);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::driveFactor::value(const scalar t) const
{
    if (t >= end_)
    {
        return to_;
    }

    const scalar fraction = max((t - begin_)/(end_ - begin_), scalar(0));

    return
        from_
      + (to_ - from_)*0.5*(1 - std::cos(constant::mathematical::pi*fraction));
}


void Foam::acoustics::driveFactor::change
(
    const scalar factor,
    const scalar t,
    const scalar duration
)
{
    from_ = value(t);
    to_ = factor;
    begin_ = t;
    end_ = t + duration;

    add("from", from_, true);
    add("to", to_, true);
    add("begin", begin_, true);
    add("end", end_, true);
}


Foam::scalar Foam::acoustics::driveFactor::of(const fvPatch& patch)
{
    const fvMesh& mesh = patch.boundaryMesh().mesh();
    const auto* factor = mesh.cfindObject<driveFactor>(name_);

    return
        factor && factor->patches_.found(patch.name())
      ? factor->value(mesh.time().value())
      : 1;
}


// ************************************************************************* //
