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
    IOdictionary
    (
        IOobject
        (
            name_,
            mesh.time().timeName(),
            "uniform",
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    patches_(patches),
    from_(getOrDefault<scalar>("from", 1)),
    to_(getOrDefault<scalar>("to", 1)),
    begin_(getOrDefault<scalar>("begin", -GREAT)),
    end_(getOrDefault<scalar>("end", -GREAT))
{}


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

    set("from", from_);
    set("to", to_);
    set("begin", begin_);
    set("end", end_);
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
