/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "largestValue.H"

#include "foamVersion.H"
#include "fvMesh.H"
#include "Pstream.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::largestValue::largestValue
(
    const fvMesh& mesh,
    const scalarField& inCells
)
:
    value(-VGREAT),
    place(Zero),
    processor(-1),
    cell(-1)
{
    forAll(inCells, celli)
    {
        if (inCells[celli] > value)
        {
            value = inCells[celli];
            cell = celli;
        }
    }

    scalarField values(Pstream::nProcs(), -VGREAT);
    pointField places(Pstream::nProcs(), Zero);
    values[Pstream::myProcNo()] = value;
    if (cell >= 0)
    {
        places[Pstream::myProcNo()] = mesh.cellCentres()[cell];
    }
    gatherToAll(values);
    gatherToAll(places);

    processor = findMax(values);
    value = values[processor];
    place = places[processor];
    if (processor != Pstream::myProcNo())
    {
        cell = -1;
    }
}


// ************************************************************************* //
