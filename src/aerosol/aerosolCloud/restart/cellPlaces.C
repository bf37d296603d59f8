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
#include <utility>
#include <vector>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using aerosol::vectors;

//- The tetrahedra of a cell: a million particles are often in the same one
class tetsOfCell
{
    struct tet
    {
        tetIndices indices;
        point origin;

        //- From a distance to the origin to three of the coordinates
        tensor toCoordinates;
    };

    label celli_ = -1;
    DynamicList<tet> tets_;

public:

    label cell() const
    {
        return celli_;
    }

    void set(const polyMesh& mesh, const label celli)
    {
        celli_ = celli;
        tets_.clear();

        for (const label facei : mesh.cells()[celli])
        {
            const face& f = mesh.faces()[facei];

            for (label tetPti = 1; tetPti < f.size() - 1; ++tetPti)
            {
                const tetIndices indices(celli, facei, tetPti);
                const tetPointRef t = indices.tet(mesh);

                // Its columns are the edges from a
                const tensor edges =
                    tensor(t.b() - t.a(), t.c() - t.a(), t.d() - t.a()).T();

                if (mag(det(edges)) > VSMALL)
                {
                    tets_.append({indices, t.a(), inv(edges)});
                }
            }
        }
    }

    //- The one that contains a point, if there is one
    tetIndices find(const point& p) const
    {
        for (const tet& t : tets_)
        {
            const vector s = t.toCoordinates & (p - t.origin);

            if (cmptMin(s) >= 0 && cmptSum(s) <= 1)
            {
                return t.indices;
            }
        }

        return tetIndices();
    }
};


//- The particles whose positions are finite, in such an order that neighbours
//  in space follow one another
std::vector<int> inOrderOfSpace(const vectors& x)
{
    constexpr double cells = 64;

    Eigen::Array3d low = Eigen::Array3d::Constant(GREAT);
    Eigen::Array3d high = -low;
    std::vector<int> indices;

    for (int i = 0; i < x.cols(); ++i)
    {
        if (x.col(i).allFinite())
        {
            indices.push_back(i);
            low = low.min(x.col(i).array());
            high = high.max(x.col(i).array());
        }
    }

    const Eigen::Array3d scale = cells/(high - low + VSMALL);
    std::vector<std::pair<int, int>> order;

    for (const int i : indices)
    {
        const Eigen::Array3d place = ((x.col(i).array() - low)*scale).floor();

        order.push_back
        ({
            static_cast<int>((place(0)*cells + place(1))*cells + place(2)), i
        });
    }

    std::sort(order.begin(), order.end());

    for (std::size_t k = 0; k < order.size(); ++k)
    {
        indices[k] = order[k].second;
    }

    return indices;
}

} // End anonymous namespace


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

    tetsOfCell last;

    for (const int i : inOrderOfSpace(particles.x))
    {
        const point p(position(particles, i));

        places[i] = last.find(p);

        if (places[i].cell() < 0)
        {
            const label celli = mesh.cellTree().findInside(p);

            if (celli >= 0)
            {
                if (celli != last.cell())
                {
                    last.set(mesh, celli);
                }
                places[i] = last.find(p);

                // On a face between two of them, after rounding
                if (places[i].cell() < 0)
                {
                    places[i] =
                        polyMeshTetDecomposition::findTet(mesh, celli, p);
                }
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
