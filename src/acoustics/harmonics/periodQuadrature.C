/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "periodQuadrature.H"

#include "error.H"
#include "mathematicalConstants.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

//- Rounding of times, in steps
constexpr scalar rounding = 1e-5;

//- Value (or slope) at a fraction of a step as a combination of value and slope
//  at its beginning and its end: Hermite's cubic
struct cubic
{
    scalar value[4];
    scalar slope[4];

    cubic(const scalar s, const scalar h)
    :
        value
        {
            (1 + 2*s)*(1 - s)*(1 - s),
            h*s*(1 - s)*(1 - s),
            s*s*(3 - 2*s),
            -h*s*s*(1 - s)
        },
        slope
        {
            -6*s*(1 - s)/h,
            (1 - s)*(1 - 3*s),
            6*s*(1 - s)/h,
            -s*(2 - 3*s)
        }
    {}
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::periodQuadrature::periodQuadrature
(
    const scalar frequency,
    const label nHarmonics
)
:
    period_(1/frequency),
    nHarmonics_(nHarmonics)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::acoustics::periodQuadrature::number
(
    const scalar t,
    const scalar step
) const
{
    return label(std::floor((t + rounding*step)/period_));
}


bool Foam::acoustics::periodQuadrature::isBoundary
(
    const scalar t,
    const scalar step
) const
{
    return
        std::abs(t - period_*std::round(t/period_)) < rounding*step;
}


std::vector<Foam::acoustics::periodQuadrature::part>
Foam::acoustics::periodQuadrature::parts
(
    const scalar t0,
    const scalar t1
) const
{
    const scalar step = t1 - t0;
    const scalar longest = period_/(2*max(nHarmonics_, label(1)) + 1);

    if (!(step > 0 && step < longest))
    {
        FatalErrorInFunction
            << "A time step of " << step << " s cannot tell " << nHarmonics_
            << " harmonics of a period of " << period_ << " s from one"
            << " another: it must be shorter than " << longest << " s"
            << exit(FatalError);
    }

    // Where the step begins, a period may end in it, and it ends
    std::vector<scalar> cuts({0});
    const scalar boundary = (number(t0, step) + 1)*period_;
    const bool ends = boundary < t1 + rounding*step;
    const bool cut = ends && boundary < t1 - rounding*step;
    if (cut)
    {
        cuts.push_back((boundary - t0)/step);
    }
    cuts.push_back(1);

    std::vector<part> result;

    for (size_t i = 0; i + 1 < cuts.size(); ++i)
    {
        part piece;
        piece.sums.assign(size(), weights({0, 0, 0, 0}));
        piece.endsPeriod = ends && i == 0;
        piece.end = boundary;

        const scalar h = (cuts[i + 1] - cuts[i])*step;

        for (const int side : {0, 1})
        {
            const cubic y(cuts[i + side], step);
            const scalar t = t0 + cuts[i + side]*step;

            // Of f and of its slope
            const scalar ofValue = 0.5*h;
            const scalar ofSlope = (side ? -1 : 1)*h*h/12;

            for (label sum = 0; sum < size(); ++sum)
            {
                const label k = (sum + 1)/2;
                const scalar omega = k*constant::mathematical::twoPi/period_;

                // Whole periods are taken off before they cost digits
                const scalar angle =
                    omega*(t - period_*std::floor(t/period_));

                scalar factor = 1;
                scalar itsSlope = 0;
                if (sum % 2)
                {
                    factor = std::cos(angle);
                    itsSlope = -omega*std::sin(angle);
                }
                else if (sum)
                {
                    factor = std::sin(angle);
                    itsSlope = omega*std::cos(angle);
                }

                const scalar norm = (sum ? 2 : 1)/period_;

                for (int c = 0; c < 4; ++c)
                {
                    piece.sums[sum][c] +=
                        norm
                       *(
                            (ofValue*factor + ofSlope*itsSlope)*y.value[c]
                          + ofSlope*factor*y.slope[c]
                        );
                }
            }
        }

        result.push_back(piece);
    }

    return result;
}


// ************************************************************************* //
