/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "faceStencils.H"

#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "fvMesh.H"
#include "globalIndex.H"
#include "IPstream.H"
#include "OPstream.H"
#include "processorPolyPatch.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Largest ratio of the volumes of neighbours on a line: grading is less,
//  refinement in two or three directions is more
constexpr double maxGrowth = 2.5;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::acoustics::faceStencils::beyond
(
    const label celli,
    const label facei
) const
{
    const cell& c = mesh_.cells()[celli];

    // Six faces of four points are a hexahedron
    bool hex = c.size() == 6;
    for (const label f : c)
    {
        hex = hex && mesh_.faces()[f].size() == 4;
    }
    if (!hex)
    {
        return -1;
    }

    const label opposite = c.opposingFaceLabel(facei, mesh_.faces());

    if (opposite < 0)
    {
        return -1;
    }
    if (!mesh_.isInternalFace(opposite))
    {
        return ghost(opposite);
    }
    return
        mesh_.faceOwner()[opposite] == celli
      ? mesh_.faceNeighbour()[opposite]
      : mesh_.faceOwner()[opposite];
}


Foam::boolList Foam::acoustics::faceStencils::connect()
{
    const globalIndex cells(nCells_);
    const label start = mesh_.nInternalFaces();

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled())
        {
            const auto* coupledPatch = isA<coupledPolyPatch>(patch);

            if
            (
                !(isA<cyclicPolyPatch>(patch) || isA<processorPolyPatch>(patch))
             || !coupledPatch->parallel()
            )
            {
                FatalErrorInFunction
                    << "Patch " << patch.name() << " is of type "
                    << patch.type() << " or is rotated against its other side."
                    << nl << "The sound explicitCompressible knows cyclic"
                    << " patches that are moved, face by face"
                    << exit(FatalError);
            }

            forAll(patch, i)
            {
                coupled_[patch.start() + i - start] = true;
            }
        }
    }

    // The cell of each face, and the one behind it, by global number
    labelList near(nBoundary_, -1);
    forAll(near, b)
    {
        near[b] = cells.toGlobal(mesh_.faceOwner()[start + b]);
    }
    syncTools::swapBoundaryFaceList(mesh_, near);

    labelList far(nBoundary_, -1);
    forAll(far, b)
    {
        const label place = inner_[b];

        if (place >= 0 && place < nCells_)
        {
            far[b] = cells.toGlobal(place);
        }
        else if (isCell(place))
        {
            far[b] = near[place - nCells_];
        }
    }
    const labelList mine(far);
    syncTools::swapBoundaryFaceList(mesh_, far);

    // The ranks that want each cell
    labelListList wanted(Pstream::nProcs());
    receive_.setSize(Pstream::nProcs());
    List<DynamicList<label>> from(Pstream::nProcs());
    List<DynamicList<label>> to(Pstream::nProcs());

    boolList goesOn(nBoundary_, false);

    forAll(coupled_, b)
    {
        if (!coupled_[b])
        {
            continue;
        }

        // The same on both sides
        goesOn[b] = far[b] >= 0 && mine[b] >= 0;

        const label last = goesOn[b] ? far[b] : near[b];
        const label place[2] = {nCells_ + b, nCells_ + nBoundary_ + b};
        const label global[2] = {near[b], last};

        for (int i = 0; i < 2; ++i)
        {
            const label rank = cells.whichProcID(global[i]);
            from[rank].append(cells.toLocal(rank, global[i]));
            to[rank].append(place[i]);
        }
    }

    forAll(from, rank)
    {
        wanted[rank] = from[rank];
        receive_[rank] = to[rank];
    }

    Pstream::exchange<labelList, label>(wanted, send_);
    send_[Pstream::myProcNo()] = wanted[Pstream::myProcNo()];

    sendBuffer_.setSize(Pstream::nProcs());
    receiveBuffer_.setSize(Pstream::nProcs());

    return goesOn;
}


void Foam::acoustics::faceStencils::exchange
(
    const std::vector<centralFluxes::array*>& arrays
) const
{
    const label me = Pstream::myProcNo();
    const label n = arrays.size();

    // Cyclic patches of this rank
    forAll(receive_[me], i)
    {
        for (centralFluxes::array* values : arrays)
        {
            (*values)[receive_[me][i]] = (*values)[send_[me][i]];
        }
    }

    if (!Pstream::parRun())
    {
        return;
    }

    const label firstRequest = Pstream::nRequests();

    forAll(receive_, rank)
    {
        if (rank != me && receive_[rank].size())
        {
            List<scalar>& buffer = receiveBuffer_[rank];
            buffer.setSize(n*receive_[rank].size());

            UIPstream::read
            (
                Pstream::commsTypes::nonBlocking,
                rank,
                reinterpret_cast<char*>(buffer.data()),
                buffer.byteSize()
            );
        }
    }

    forAll(send_, rank)
    {
        if (rank != me && send_[rank].size())
        {
            List<scalar>& buffer = sendBuffer_[rank];
            buffer.setSize(n*send_[rank].size());

            scalar* to = buffer.data();
            for (const centralFluxes::array* values : arrays)
            {
                for (const label celli : send_[rank])
                {
                    *to++ = (*values)[celli];
                }
            }

            UOPstream::write
            (
                Pstream::commsTypes::nonBlocking,
                rank,
                reinterpret_cast<const char*>(buffer.cdata()),
                buffer.byteSize()
            );
        }
    }

    Pstream::waitRequests(firstRequest);

    forAll(receive_, rank)
    {
        if (rank != me)
        {
            const scalar* from = receiveBuffer_[rank].cdata();
            for (centralFluxes::array* values : arrays)
            {
                for (const label place : receive_[rank])
                {
                    (*values)[place] = *from++;
                }
            }
        }
    }
}


void Foam::acoustics::faceStencils::addFace
(
    const label facei,
    const label left2,
    const label left,
    const label right,
    const label right2
)
{
    const bool line = left2 >= 0 && right2 >= 0;

    const vector& S = mesh_.faceAreas()[facei];
    const vector n = S/mag(S);

    // Along the normal; a ghost is as far away as the cell, if it is no cell
    const vector& C = mesh_.cellCentres()[left];
    scalar distance;
    if (right < nCells_)
    {
        distance = (mesh_.cellCentres()[right] - C) & n;
    }
    else
    {
        const label patchi = mesh_.boundaryMesh().whichPatch(facei);
        const label i = facei - mesh_.boundaryMesh()[patchi].start();

        distance =
            mesh_.boundary()[patchi].coupled()
          ? 1/mesh_.boundary()[patchi].deltaCoeffs()[i]
          : 2*((mesh_.faceCentres()[facei] - C) & n);
    }

    faces_.push_back
    ({
        {
            int(line ? left2 : left), int(left), int(right),
            int(line ? right2 : right)
        },
        {S.x(), S.y(), S.z()},
        mag(S)/distance
    });
}


void Foam::acoustics::faceStencils::cutIrregularLines()
{
    centralFluxes::array V(size(), 0);

    forAll(mesh_.cellVolumes(), i)
    {
        V[i] = mesh_.cellVolumes()[i];
    }
    exchange(std::vector<centralFluxes::array*>{&V});

    for (label b = 0; b < nBoundary_; ++b)
    {
        if (!coupled_[b])
        {
            const label facei = mesh_.nInternalFaces() + b;

            V[nCells_ + b] = V[mesh_.faceOwner()[facei]];
            V[nCells_ + nBoundary_ + b] = V[inner(facei)];
        }
    }

    for (centralFluxes::face& f : faces_)
    {
        auto& c = f.cells;

        for (int i = 0; i < 3; ++i)
        {
            const scalar ratio = V[c[i]]/V[c[i + 1]];

            if (ratio > maxGrowth || ratio < 1/maxGrowth)
            {
                c[0] = c[1];
                c[3] = c[2];
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::faceStencils::faceStencils(const fvMesh& mesh)
:
    mesh_(mesh),
    nCells_(mesh.nCells()),
    nBoundary_(mesh.nFaces() - mesh.nInternalFaces()),
    inner_(nBoundary_, -1),
    coupled_(nBoundary_, false)
{
    // Made on demand, by all ranks together: some may have no use for it
    mesh.deltaCoeffs();

    const label start = mesh.nInternalFaces();

    // Ghosts of empty patches are none
    std::vector<bool> none(nBoundary_, false);
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch))
        {
            forAll(patch, i)
            {
                none[patch.start() + i - start] = true;
            }
        }
    }

    const auto behind = [&](const label celli, const label facei)
    {
        const label place = beyond(celli, facei);

        return place >= nCells_ && none[place - nCells_] ? -1 : place;
    };

    forAll(inner_, b)
    {
        inner_[b] = behind(mesh.faceOwner()[start + b], start + b);
    }

    const boolList goesOn = connect();

    for (label facei = 0; facei < start; ++facei)
    {
        const label left = mesh.faceOwner()[facei];
        const label right = mesh.faceNeighbour()[facei];

        addFace
        (
            facei, behind(left, facei), left, right, behind(right, facei)
        );
    }

    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<emptyPolyPatch>(patch))
        {
            continue;
        }

        forAll(patch, i)
        {
            const label b = patch.start() + i - start;
            const bool line =
                patch.coupled()
              ? goesOn[b]
              : isCell(inner_[b]);

            addFace
            (
                start + b,
                line ? inner_[b] : -1,
                mesh.faceOwner()[start + b],
                nCells_ + b,
                nCells_ + nBoundary_ + b
            );
        }
    }

    cutIrregularLines();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::acoustics::faceStencils::ghost(const label facei) const
{
    return nCells_ + facei - mesh_.nInternalFaces();
}


Foam::label Foam::acoustics::faceStencils::inner(const label facei) const
{
    const label place = inner_[facei - mesh_.nInternalFaces()];

    return isCell(place) ? place : mesh_.faceOwner()[facei];
}


bool Foam::acoustics::faceStencils::isCoupled(const label facei) const
{
    return coupled_[facei - mesh_.nInternalFaces()];
}


void Foam::acoustics::faceStencils::exchange(centralFluxes::state& q) const
{
    exchange({&q[0], &q[1], &q[2], &q[3], &q[4]});
}


void Foam::acoustics::faceStencils::complete
(
    centralFluxes::array& values
) const
{
    for (label b = 0; b < nBoundary_; ++b)
    {
        values[nCells_ + b] =
            values[mesh_.faceOwner()[mesh_.nInternalFaces() + b]];
    }

    exchange(std::vector<centralFluxes::array*>{&values});
}


// ************************************************************************* //
