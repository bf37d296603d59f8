/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "chamber.H"

#include "emptyPolyPatch.H"
#include "polyMesh.H"
#include "processorCyclicPolyPatch.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::chamber::chamber(const polyMesh& mesh)
:
    mesh_(mesh)
{}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

std::pair<Foam::scalar, Foam::scalar> Foam::aerosol::chamber::overlap
(
    const boundBox& box,
    const vector& velocity,
    const FixedList<point, 3>& triangle
)
{
    const point centre(box.midpoint());

    // A little smaller, or rounding would make a box meet the wall it touches
    const vector half
    (
        (0.5 - 1e-9)*box.span()
      - 1e-12*max(mag(box.min()), mag(box.max()))*vector::one
    );

    const vector edges[3] =
    {
        triangle[1] - triangle[0],
        triangle[2] - triangle[1],
        triangle[0] - triangle[2]
    };

    scalar from = -GREAT;
    scalar to = GREAT;

    const auto compare = [&](vector axis)
    {
        const scalar length = mag(axis);

        if (length < VSMALL)
        {
            // Of parallel edges
            return;
        }
        axis /= length;

        const scalar a = axis & (triangle[0] - centre);
        const scalar b = axis & (triangle[1] - centre);
        const scalar c = axis & (triangle[2] - centre);
        const scalar reach = half & cmptMag(axis);

        const scalar low = min(a, min(b, c)) - reach;
        const scalar high = max(a, max(b, c)) + reach;
        const scalar speed = axis & velocity;

        if (mag(speed)*GREAT <= max(mag(low), mag(high)))
        {
            // At rest: always, or never
            if (low >= 0 || high <= 0)
            {
                from = GREAT;
                to = -GREAT;
            }
            return;
        }

        const scalar enters = (speed > 0 ? low : high)/speed;
        const scalar leaves = (speed > 0 ? high : low)/speed;

        from = max(from, enters);
        to = min(to, leaves);
    };

    compare(edges[0] ^ edges[1]);

    for (direction d = 0; d < vector::nComponents; ++d)
    {
        vector normal(Zero);
        normal[d] = 1;

        compare(normal);

        for (const vector& edge : edges)
        {
            const vector axis = normal ^ edge;

            if (magSqr(axis) > 1e-16*magSqr(edge))
            {
                compare(axis);
            }
        }
    }

    return {from, to};
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::boundBox& Foam::aerosol::chamber::bounds() const
{
    return mesh_.bounds();
}


Foam::aerosol::chamber::encounter Foam::aerosol::chamber::first
(
    const boundBox& box,
    const vector& velocity
) const
{
    encounter earliest{GREAT, Zero};

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const bool between =
            isA<processorPolyPatch>(patch)
         && !isA<processorCyclicPolyPatch>(patch);

        if (between || isA<emptyPolyPatch>(patch) || isA<wedgePolyPatch>(patch))
        {
            continue;
        }

        forAll(patch, i)
        {
            const face& f = patch[i];
            const point& middle = mesh_.faceCentres()[patch.start() + i];

            forAll(f, k)
            {
                const point& here = mesh_.points()[f[k]];
                const point& next = mesh_.points()[f.nextLabel(k)];

                const auto [from, to] =
                    overlap(box, velocity, {here, next, middle});

                if (from < to && to > 0 && max(from, scalar(0)) < earliest.time)
                {
                    earliest = {max(from, scalar(0)), middle};
                }
            }
        }
    }

    // The earliest of all ranks
    scalar time = earliest.time;
    reduce(time, minOp<scalar>());

    point place = earliest.time == time ? earliest.place : vector::min;
    reduce(place, maxOp<vector>());

    return {time, place};
}


bool Foam::aerosol::chamber::contains(const boundBox& box) const
{
    // Not for directions in which there is but one layer of cells
    if (!bounds().contains(box) || first(box, Zero).time == 0)
    {
        return false;
    }

    // Where no wall is in the box, all of it is in the cells or none
    bool inside = mesh_.primitiveMesh::findCell(box.midpoint()) >= 0;
    reduce(inside, orOp<bool>());

    return inside;
}


// ************************************************************************* //
