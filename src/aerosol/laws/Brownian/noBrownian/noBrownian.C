/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "noBrownian.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(noBrownian, 0);
    addToRunTimeSelectionTable(Brownian, noBrownian, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::noBrownian::noBrownian(const dictionary&)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::noBrownian::increment
(
    const particleArrays&,
    const scalars&,
    const gasProperties&,
    const scalar,
    const std::int64_t,
    const std::uint64_t,
    increments& k
) const
{
    k.v.resize(3, 0);
    k.x.resize(3, 0);
}


void Foam::aerosol::noBrownian::bridge
(
    const particleArrays&,
    const scalars&,
    const gasProperties&,
    const scalar,
    const std::int64_t,
    const std::uint64_t,
    const int n,
    const increments&,
    std::vector<increments>& parts
) const
{
    parts.resize(n);

    for (increments& part : parts)
    {
        part.v.resize(3, 0);
        part.x.resize(3, 0);
    }
}


Foam::aerosol::Brownian::extent Foam::aerosol::noBrownian::reach
(
    const particleArrays&,
    const scalars&,
    const gasProperties&,
    const scalar
) const
{
    return {};
}


Foam::scalar Foam::aerosol::noBrownian::uniform
(
    const std::int64_t,
    const std::int64_t,
    const std::int64_t,
    const std::uint64_t
) const
{
    return 0.5;
}


// ************************************************************************* //
