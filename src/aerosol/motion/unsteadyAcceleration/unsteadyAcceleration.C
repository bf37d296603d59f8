/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "unsteadyAcceleration.H"
#include "meanDecay.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::unsteadyAcceleration::unsteadyAcceleration
(
    const unsteadyDrag& law,
    const gasProperties& gas,
    const exponentialStep& exact,
    const BrownianPath& noise
)
:
    law_(law),
    gas_(gas),
    exact_(exact),
    noise_(noise)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::unsteadyAcceleration::find
(
    const scalar h,
    const stepValues& gas,
    const int first,
    particleArrays& p,
    stepEnd& end
) const
{
    const int n = static_cast<int>(gas.u0.cols());

    const vectors U0 =
        gas.u0
      - noise_.drift(p.v.middleCols(first, n), p.thermal.middleCols(first, n));

    vectors a0;
    scalars q;
    law_.begin(h, U0, gas.u1 - gas.u0, gas_, first, p, a0, q);

    p.unsteady.middleCols(first, n).setZero();

    // With finite drag, which depends on the end, once more
    const int nPasses = exact_.linear() ? 1 : 2;

    for (int pass = 0; pass < nPasses; ++pass)
    {
        exact_.move(h, p, gas, {}, pass > 0, end, first);

        for (int l = 0; l < n; ++l)
        {
            const int i = first + l;
            const double z = h*p.rate(i);
            const double A = meanDecay(z);

            Eigen::Vector3d U1 = gas.u1.col(l) - end.v.col(i);
            if (noise_.active())
            {
                U1 += (1 - z*A)*p.thermal.col(i);
            }

            p.unsteady.col(i) +=
            (
                a0.col(l) + q(l)*(U1 - U0.col(l)) - p.unsteady.col(i)
            )/(1 + q(l)*h*A);
        }
    }
}


// ************************************************************************* //
