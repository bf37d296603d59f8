/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "contacts.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::contacts::contacts(const dictionary& dict)
:
    outcome_(contactOutcome::New(dict.subDict("contact"))),
    aggregate_(aggregate::New(dict.subDict("aggregate"))),
    count_(0),
    nAbsorbed_(0)
{}


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

    aggregate_->merge(p, pair);

    absorbed_.resize(p.size(), 0);
    absorbed_[pair.j] = 1;
    ++nAbsorbed_;

    return pair.i;
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
