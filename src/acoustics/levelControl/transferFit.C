/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "transferFit.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::transferFit::transferFit
(
    const std::vector<complex>& response,
    const std::vector<complex>& drive
)
{
    // Normal equations of A_j = r A_(j-1) + b D_j
    double AA = 0;
    double DD = 0;
    complex AD = 0;
    complex AY = 0;
    complex DY = 0;

    for (size_t j = 1; j < response.size(); ++j)
    {
        AA += std::norm(response[j - 1]);
        DD += std::norm(drive[j]);
        AD += std::conj(response[j - 1])*drive[j];
        AY += std::conj(response[j - 1])*response[j];
        DY += std::conj(drive[j])*response[j];
    }

    // Prefers a small pole where the data allow many
    AA *= 1 + 1e-6;

    constexpr double small = 1e-300;
    const double determinant = AA*DD - std::norm(AD);

    pole_ = (AY*DD - AD*DY)/std::max(determinant, small);

    // Passive chambers do not amplify
    constexpr double most = 0.9999;
    if (std::abs(pole_) > most)
    {
        pole_ *= most/std::abs(pole_);
    }

    gain_ = (DY - std::conj(AD)*pole_)/std::max(DD, small);
}


// ************************************************************************* //
