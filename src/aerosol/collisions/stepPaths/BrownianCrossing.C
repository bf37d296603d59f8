/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "BrownianCrossing.H"

#include <cmath>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

bool Foam::aerosol::BrownianCrossing
(
    const Brownian& noise,
    const std::int64_t idI,
    const std::int64_t idJ,
    const scalar gap0,
    const scalar gap1,
    const scalar variance,
    const std::int64_t step,
    const std::uint64_t block
)
{
    const double exponent = 2*gap0*gap1/(variance + VSMALL);

    // Of the probability no random number is as small as this one
    if (gap0 <= 0 || gap1 <= 0 || exponent > 40)
    {
        return false;
    }

    return
        noise.uniform(idI, idJ, step, block)
      < std::exp(-exponent);
}


// ************************************************************************* //
