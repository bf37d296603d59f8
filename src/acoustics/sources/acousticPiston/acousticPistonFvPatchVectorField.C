/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "acousticPistonFvPatchVectorField.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "driveFactor.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    makePatchTypeField(fvPatchVectorField, acousticPistonFvPatchVectorField);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::acoustics::oscillation readSpeed
(
    const Foam::dictionary& dict,
    const Foam::scalar now
)
{
    const bool displacement = dict.found("displacementAmplitude");

    if (displacement == dict.found("velocityAmplitude"))
    {
        FatalIOErrorInFunction(dict)
            << "Give exactly one of the entries velocityAmplitude (m/s, peak)"
            << " and displacementAmplitude (m, peak)"
            << exit(Foam::FatalIOError);
    }

    const Foam::word amplitude
    (
        displacement ? "displacementAmplitude" : "velocityAmplitude"
    );

    Foam::wordList valid
    ({
        "type", "patchType", "value", "libs", "useImplicit", "direction"
    });
    valid.append(Foam::acoustics::oscillation::entries(amplitude));
    Foam::requireOnly(dict, valid);

    return Foam::acoustics::oscillation(dict, amplitude, now, displacement);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::acousticPistonFvPatchVectorField::
acousticPistonFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(p, iF),
    direction_(Zero)
{}


Foam::acoustics::acousticPistonFvPatchVectorField::
acousticPistonFvPatchVectorField
(
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchVectorField(p, iF, dict, false),
    speed_(readSpeed(dict, db().time().timeOutputValue())),
    direction_(Zero)
{
    if (dict.found("direction"))
    {
        direction_ = readDirection(dict, "direction", Zero);
    }

    fvPatchVectorField::operator=
    (
        dict.found("value")
      ? vectorField("value", dict, p.size())
      : vectorField(p.size(), Zero)
    );

    if (p.size() && dict.found("value"))
    {
        requireAllRead(dict, "value");
    }
}


Foam::acoustics::acousticPistonFvPatchVectorField::
acousticPistonFvPatchVectorField
(
    const acousticPistonFvPatchVectorField& ptf,
    const fvPatch& p,
    const DimensionedField<vector, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchVectorField(ptf, p, iF, mapper),
    speed_(ptf.speed_),
    direction_(ptf.direction_)
{}


Foam::acoustics::acousticPistonFvPatchVectorField::
acousticPistonFvPatchVectorField
(
    const acousticPistonFvPatchVectorField& ptf
)
:
    acousticPistonFvPatchVectorField(ptf, ptf.internalField())
{}


Foam::acoustics::acousticPistonFvPatchVectorField::
acousticPistonFvPatchVectorField
(
    const acousticPistonFvPatchVectorField& ptf,
    const DimensionedField<vector, volMesh>& iF
)
:
    fixedValueFvPatchVectorField(ptf, iF),
    speed_(ptf.speed_),
    direction_(ptf.direction_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::acousticPistonFvPatchVectorField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    const scalar speed =
        driveFactor::of(patch())*speed_.value(db().time().timeOutputValue());

    if (magSqr(direction_) > 0)
    {
        operator==(vectorField(size(), speed*direction_));
    }
    else
    {
        operator==(-speed*patch().nf());
    }

    fixedValueFvPatchVectorField::updateCoeffs();
}


void Foam::acoustics::acousticPistonFvPatchVectorField::write
(
    Ostream& os
) const
{
    fvPatchVectorField::write(os);

    speed_.write(os);
    if (magSqr(direction_) > 0)
    {
        os.writeEntry("direction", direction_);
    }
    writeEntry("value", os);
}


// ************************************************************************* //
