/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicSum.H"

#include "error.H"
#include "scalarField.H"
#include "vectorField.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type>
void Foam::acoustics::harmonicSum<Type>::accumulate
(
    const periodQuadrature::part& part,
    const UList<Type>& y,
    const UList<Type>& slope
)
{
    forAll(sums_, sum)
    {
        const periodQuadrature::weights& w = part.sums[sum];
        Field<Type>& s = sums_[sum];

        forAll(s, i)
        {
            s[i] += w[0]*last_[i] + w[1]*slope_[i] + w[2]*y[i] + w[3]*slope[i];
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::acoustics::harmonicSum<Type>::harmonicSum
(
    const scalar frequency,
    const label nHarmonics
)
:
    quadrature_(frequency, nHarmonics),
    lastTime_(0),
    beforeTime_(0),
    nValues_(0),
    gap_(false),
    whole_(false),
    sums_(quadrature_.size()),
    result_(quadrature_.size()),
    end_(0),
    nPeriods_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
bool Foam::acoustics::harmonicSum<Type>::add
(
    const scalar t,
    const UList<Type>& y
)
{
    if (nValues_ == 0)
    {
        for (Field<Type>& s : sums_)
        {
            s.setSize(y.size(), Zero);
        }
        last_ = y;
        lastTime_ = t;
        nValues_ = 1;
        return false;
    }

    if (y.size() != last_.size())
    {
        FatalErrorInFunction
            << "The mesh has changed: there were " << last_.size()
            << " values, now there are " << y.size() << exit(FatalError);
    }

    const scalar h = t - lastTime_;

    // A second one in a row is no gap, but a step that is refused below
    const bool gapBefore = gap_;
    gap_ = h > 0.5*quadrature_.period();

    if (gap_ && !gapBefore)
    {
        for (Field<Type>& s : sums_)
        {
            s = Zero;
        }
        last_ = y;
        lastTime_ = t;
        nValues_ = 1;
        whole_ = false;
        return false;
    }

    Field<Type> slope((y - last_)/h);

    if (nValues_ == 1)
    {
        // A line through the first two values
        slope_ = slope;
        whole_ = quadrature_.isBoundary(lastTime_, h);
        nValues_ = 2;
    }
    else
    {
        // A parabola through three
        const scalar h0 = lastTime_ - beforeTime_;
        slope += h/(h + h0)*(slope - (last_ - before_)/h0);
    }

    bool ended = false;

    for (const periodQuadrature::part& part : quadrature_.parts(lastTime_, t))
    {
        if (whole_)
        {
            accumulate(part, y, slope);
        }

        if (part.endsPeriod)
        {
            if (whole_)
            {
                result_.swap(sums_);
                end_ = part.end;
                ++nPeriods_;
                ended = true;
            }

            for (Field<Type>& s : sums_)
            {
                s.setSize(y.size());
                s = Zero;
            }
            whole_ = true;
        }
    }

    before_.transfer(last_);
    last_ = y;
    slope_.transfer(slope);
    beforeTime_ = lastTime_;
    lastTime_ = t;

    return ended;
}


// * * * * * * * * * * * * * * Instantiations  * * * * * * * * * * * * * * * //

template class Foam::acoustics::harmonicSum<Foam::scalar>;
template class Foam::acoustics::harmonicSum<Foam::vector>;


// ************************************************************************* //
