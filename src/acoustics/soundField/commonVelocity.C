/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "commonVelocity.H"

// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

std::vector<Foam::acoustics::commonVelocity::phasorBlock>
Foam::acoustics::commonVelocity::responses
(
    const phasorBlock& fundamental,
    const int n
)
{
    std::vector<phasorBlock> all(n);

    const block& re = fundamental.first;
    const block& im = fundamental.second;

    for (int k = 1; k <= n; ++k)
    {
        const block den = re + k*(1 - re);
        const block more = im*(1 - k);
        const block share = 1/(den*den + more*more);

        all[k - 1].first = share*(re*den + im*more);
        all[k - 1].second = share*(im*den - re*more);
    }

    return all;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::commonVelocity::at
(
    const std::vector<phasorBlock>& responses,
    blocks& velocity
) const
{
    for (int c = 0; c < 3; ++c)
    {
        velocity[c].setConstant(u(c));

        for (int k = 0; k < nHarmonics(); ++k)
        {
            velocity[c] +=
                responses[k].first*oscillation(c, 2*k)
              + responses[k].second*oscillation(c, 2*k + 1);
        }
    }
}


// ************************************************************************* //
