/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contacts.H"

#include <Eigen/Geometry>

#include <cmath>
#include <tuple>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::contacts::contacts(const dictionary& dict)
:
    outcome_(contactOutcome::New(dict.subDict("contact"))),
    aggregate_(aggregate::New(dict.subDict("aggregate"))),
    count_(0),
    nAbsorbed_(0),
    keepsRecords_(false)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::contacts::keep
(
    const particleArrays& p,
    const contactOutcome::encounter& pair,
    const bool merged
)
{
    if (!keepsRecords_)
    {
        return;
    }

    const Eigen::Vector3d r = pair.xj - pair.xi;
    const Eigen::Vector3d v = pair.vi - pair.vj;

    // By atan2, which is exact where contacts are head-on, and 0 at rest
    records_.push_back
    ({
        pair.time,
        p.id(pair.i),
        p.id(pair.j),
        p.d(pair.i),
        p.d(pair.j),
        v.norm(),
        std::atan2(r.cross(v).norm(), r.dot(v)),
        merged
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::aerosol::contacts::meet
(
    particleArrays& p,
    contactOutcome::encounter pair
)
{
    ++count_;

    if (!aggregate_->merges() || !outcome_->sticks(p, pair))
    {
        refused_.insert(std::minmax(p.id(pair.i), p.id(pair.j)));
        keep(p, pair, false);
        return -1;
    }

    // The heavier one lives on, at its own place rather than its image's
    const bool jIsHeavier =
        p.m(pair.j) > p.m(pair.i)
     || (p.m(pair.j) == p.m(pair.i) && p.id(pair.j) < p.id(pair.i));

    if (jIsHeavier)
    {
        std::swap(pair.i, pair.j);
        std::swap(pair.xi, pair.xj);
        std::swap(pair.vi, pair.vj);

        pair.xi -= pair.shift;
        pair.xj -= pair.shift;
        pair.shift = -pair.shift;
    }

    keep(p, pair, true);
    aggregate_->merge(p, pair);

    absorbed_.resize(p.size(), 0);
    absorbed_[pair.j] = 1;
    ++nAbsorbed_;

    return pair.i;
}


std::vector<Foam::aerosol::contacts::record>
Foam::aerosol::contacts::takeRecords()
{
    std::vector<record> taken;
    taken.swap(records_);

    std::sort
    (
        taken.begin(),
        taken.end(),
        [](const record& a, const record& b)
        {
            return
                std::tie(a.time, a.id1, a.id2) < std::tie(b.time, b.id1, b.id2);
        }
    );

    return taken;
}


std::vector<char> Foam::aerosol::contacts::takeAbsorbed(const int n)
{
    std::vector<char> marks;
    marks.swap(absorbed_);
    marks.resize(n, 0);
    nAbsorbed_ = 0;

    return marks;
}


void Foam::aerosol::contacts::sweep(particleArrays& p)
{
    if (nAbsorbed_)
    {
        p.remove(takeAbsorbed(p.size()));
    }
}


// ************************************************************************* //
