/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellPlaces.H"

#include "foamVersion.H"
#include "indexedOctree.H"
#include "ListOps.H"
#include "Pstream.H"
#include "particleArrays.H"
#include "polyMesh.H"
#include "polyMeshTetDecomposition.H"
#include "treeDataCell.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::List<Foam::tetIndices> Foam::aerosol::cellPlaces::locate
(
    const polyMesh& mesh,
    const particleArrays& particles
)
{
    List<tetIndices> places(particles.size());

    if (!mesh.nCells())
    {
        return places;
    }

    // Neighbours in the arrays are often neighbours in space
    label hint = -1;

    forAll(places, i)
    {
        if (!particles.x.col(i).allFinite())
        {
            continue;
        }

        const point p(position(particles, i));

        if (hint >= 0)
        {
            places[i] = polyMeshTetDecomposition::findTet(mesh, hint, p);
        }

        if (places[i].cell() < 0)
        {
            const label celli = mesh.cellTree().findInside(p);

            if (celli >= 0)
            {
                places[i] = polyMeshTetDecomposition::findTet(mesh, celli, p);
                hint = celli;
            }
        }
    }

    return places;
}


Foam::labelList Foam::aerosol::cellPlaces::ofThisRank
(
    const polyMesh& mesh,
    const particleArrays& particles,
    const UList<tetIndices>& places
)
{
    const label nobody = Pstream::nProcs();

    labelList writer(places.size(), nobody);

    forAll(places, i)
    {
        if (places[i].cell() >= 0)
        {
            writer[i] = Pstream::myProcNo();
        }
    }

    combineToAll(writer, minEqOp<label>());

    const label lost = writer.find(nobody);

    if (lost >= 0)
    {
        FatalErrorInFunction
            << std::count(writer.cbegin(), writer.cend(), nobody) << " of the "
            << particles.size() << " particles are outside the mesh, which"
            << " lies within " << mesh.bounds() << nl
            << "The first of them, of id " << particles.id(lost) << ", is at "
            << position(particles, lost)
            << exit(FatalError);
    }

    return findIndices(writer, Pstream::myProcNo());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::cellPlaces::cellPlaces
(
    const polyMesh& mesh,
    const particleArrays& particles
)
:
    places_(locate(mesh, particles)),
    mine_(ofThisRank(mesh, particles, places_))
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::point Foam::aerosol::cellPlaces::position
(
    const particleArrays& particles,
    const int i
)
{
    return point(particles.x(0, i), particles.x(1, i), particles.x(2, i));
}


// ************************************************************************* //
