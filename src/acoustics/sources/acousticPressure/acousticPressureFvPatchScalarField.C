/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "acousticPressureFvPatchScalarField.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "driveFactor.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace acoustics
{
    makePatchTypeField(fvPatchScalarField, acousticPressureFvPatchScalarField);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::acousticPressureFvPatchScalarField::
acousticPressureFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedValueFvPatchScalarField(p, iF),
    ambient_(0)
{}


Foam::acoustics::acousticPressureFvPatchScalarField::
acousticPressureFvPatchScalarField
(
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const dictionary& dict
)
:
    fixedValueFvPatchScalarField(p, iF, dict, false),
    pressure_
    (
        dict,
        "pressureAmplitude",
        db().time().timeOutputValue()
    ),
    ambient_(readPositive(dict, "ambient", dimPressure))
{
    wordList valid
    ({
        "type", "patchType", "value", "libs", "useImplicit", "ambient"
    });
    valid.append(oscillation::entries("pressureAmplitude"));
    requireOnly(dict, valid);

    fvPatchScalarField::operator=
    (
        dict.found("value")
      ? scalarField("value", dict, p.size())
      : scalarField(p.size(), ambient_)
    );

    if (p.size() && dict.found("value"))
    {
        requireAllRead(dict, "value");
    }
}


Foam::acoustics::acousticPressureFvPatchScalarField::
acousticPressureFvPatchScalarField
(
    const acousticPressureFvPatchScalarField& ptf,
    const fvPatch& p,
    const DimensionedField<scalar, volMesh>& iF,
    const fvPatchFieldMapper& mapper
)
:
    fixedValueFvPatchScalarField(ptf, p, iF, mapper),
    pressure_(ptf.pressure_),
    ambient_(ptf.ambient_)
{}


Foam::acoustics::acousticPressureFvPatchScalarField::
acousticPressureFvPatchScalarField
(
    const acousticPressureFvPatchScalarField& ptf
)
:
    acousticPressureFvPatchScalarField(ptf, ptf.internalField())
{}


Foam::acoustics::acousticPressureFvPatchScalarField::
acousticPressureFvPatchScalarField
(
    const acousticPressureFvPatchScalarField& ptf,
    const DimensionedField<scalar, volMesh>& iF
)
:
    fixedValueFvPatchScalarField(ptf, iF),
    pressure_(ptf.pressure_),
    ambient_(ptf.ambient_)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::acousticPressureFvPatchScalarField::updateCoeffs()
{
    if (updated())
    {
        return;
    }

    operator==
    (
        ambient_
      + driveFactor::of(patch())
       *pressure_.value(db().time().timeOutputValue())
    );

    fixedValueFvPatchScalarField::updateCoeffs();
}


void Foam::acoustics::acousticPressureFvPatchScalarField::write
(
    Ostream& os
) const
{
    fvPatchScalarField::write(os);

    pressure_.write(os);
    os.writeEntry("ambient", ambient_);
    writeEntry("value", os);
}


// ************************************************************************* //
