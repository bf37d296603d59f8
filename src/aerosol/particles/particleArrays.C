/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleArrays.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::particleArrays::resize(const int n)
{
    id.resize(n);
    x.resize(3, n);
    v.resize(3, n);
    d.resize(n);
    m.resize(n);
    primaries.resize(n);
}


double Foam::aerosol::particleArrays::volume(const int i) const
{
    return EIGEN_PI/6*d(i)*d(i)*d(i);
}


void Foam::aerosol::particleArrays::remove(const std::vector<char>& marked)
{
    int n = 0;

    for (int i = 0; i < size(); ++i)
    {
        if (marked[i])
        {
            continue;
        }

        if (n != i)
        {
            id(n) = id(i);
            x.col(n) = x.col(i);
            v.col(n) = v.col(i);
            d(n) = d(i);
            m(n) = m(i);
            primaries(n) = primaries(i);
        }

        ++n;
    }

    id.conservativeResize(n);
    x.conservativeResize(3, n);
    v.conservativeResize(3, n);
    d.conservativeResize(n);
    m.conservativeResize(n);
    primaries.conservativeResize(n);
}


// ************************************************************************* //
