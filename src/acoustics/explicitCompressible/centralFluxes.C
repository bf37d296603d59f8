/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "centralFluxes.H"

#include <algorithm>
#include <cmath>
#include <tuple>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Cells of a block: what the faces of a block touch stays in the cache
constexpr int blockSize = 4096;


//- The values of a run in one array at one of the four places: where they are,
//  or gathered in a buffer
template<bool consecutive>
const double* pick
(
    const std::vector<double>& values,
    const int* place,
    const int n,
    double* buffer
)
{
    if (consecutive)
    {
        return values.data() + place[0];
    }

    for (int i = 0; i < n; ++i)
    {
        buffer[i] = values[place[i]];
    }
    return buffer;
}


//- Take the fluxes of a run from the left and give them to the right
template<bool consecutive>
void distribute
(
    const double* flux,
    const int* left,
    const int* right,
    const int n,
    std::vector<double>& sum
)
{
    double* const values = sum.data();

    if (consecutive)
    {
        double* const from = values + left[0];
        double* const to = values + right[0];

        #pragma GCC ivdep
        for (int i = 0; i < n; ++i)
        {
            from[i] += flux[i];
        }
        #pragma GCC ivdep
        for (int i = 0; i < n; ++i)
        {
            to[i] -= flux[i];
        }
    }
    else
    {
        for (int i = 0; i < n; ++i)
        {
            values[left[i]] += flux[i];
            values[right[i]] -= flux[i];
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<bool consecutive>
void Foam::acoustics::centralFluxes::inviscid
(
    const run& r,
    const state& q,
    state& sum
) const
{
    const int n = r.size;
    const int* const place[4] =
    {
        &cells_[0][r.first], &cells_[1][r.first],
        &cells_[2][r.first], &cells_[3][r.first]
    };

    alignas(64) double buffer[5][4][most];
    const double* v[5][4];
    for (int k = 0; k < 5; ++k)
    {
        for (int j = 0; j < 4; ++j)
        {
            v[k][j] = pick<consecutive>(q[k], place[j], n, buffer[k][j]);
        }
    }

    const double* const Sx = &area_[0][r.first];
    const double* const Sy = &area_[1][r.first];
    const double* const Sz = &area_[2][r.first];
    const double* const S = &magnitude_[r.first];
    const double* const filter = &filter_[r.first];

    const double impedance = gas_.rho*gas_.c;
    const double enthalpyFactor = gas_.gamma/(gas_.gamma - 1);
    const double enthalpy = gas_.c*gas_.c/(gas_.gamma - 1);
    const double perC = 1/gas_.c;

    // A ratio of rounding errors is no reason to filter
    const double silence = (1e-9*gas_.p)*(1e-9*gas_.p);

    alignas(64) double flux[5][most];

    #pragma GCC ivdep
    for (int i = 0; i < n; ++i)
    {
        const auto mean = [&](const int k)
        {
            return
                (7.0/12)*(v[k][1][i] + v[k][2][i])
              - (1.0/12)*(v[k][0][i] + v[k][3][i]);
        };

        const double rho = mean(0);
        const double ux = mean(1);
        const double uy = mean(2);
        const double uz = mean(3);
        const double p = mean(4);

        const double phi = ux*Sx[i] + uy*Sy[i] + uz*Sz[i];

        // The filter
        const double x1 = v[1][2][i] - v[1][1][i];
        const double y1 = v[2][2][i] - v[2][1][i];
        const double z1 = v[3][2][i] - v[3][1][i];
        const double p1 = v[4][2][i] - v[4][1][i];
        const double x3 = v[1][3][i] - v[1][0][i] - 3*x1;
        const double y3 = v[2][3][i] - v[2][0][i] - 3*y1;
        const double z3 = v[3][3][i] - v[3][0][i] - 3*z1;
        const double p3 = v[4][3][i] - v[4][0][i] - 3*p1;

        // Times rho c, and times S as the pressures below
        const double w1 = impedance*(x1*Sx[i] + y1*Sy[i] + z1*Sz[i]);
        const double w3 = impedance*(x3*Sx[i] + y3*Sy[i] + z3*Sz[i]);
        const double SS = S[i]*S[i];

        const double third = p3*p3*SS + w3*w3;
        const double first = p1*p1*SS + w1*w1;
        const double third2 = third*third;
        const double quiet = silence*SS;
        const double epsilon =
            filter[i]*third2
           /(third2 + filterOnset*first*first + quiet*quiet);

        const double a = epsilon*S[i]*p3*perC;
        const double bS = epsilon*w3;
        const double b = bS/S[i];

        const double mass = rho*phi + a;
        const double K = 0.5*(ux*ux + uy*uy + uz*uz);

        flux[0][i] = mass;
        flux[1][i] = mass*ux + (p + b)*Sx[i];
        flux[2][i] = mass*uy + (p + b)*Sy[i];
        flux[3][i] = mass*uz + (p + b)*Sz[i];
        flux[4][i] = (enthalpyFactor*p + b)*phi + mass*K + a*enthalpy;
    }

    for (int k = 0; k < 5; ++k)
    {
        distribute<consecutive>(flux[k], place[1], place[2], n, sum[k]);
    }
}


template<bool consecutive>
void Foam::acoustics::centralFluxes::dilatation(const run& r, const state& q)
{
    const int n = r.size;
    const int* const left = &cells_[1][r.first];
    const int* const right = &cells_[2][r.first];

    alignas(64) double buffer[2][most];
    alignas(64) double flux[most] = {};

    for (int d = 0; d < 3; ++d)
    {
        const double* const L = pick<consecutive>(q[1 + d], left, n, buffer[0]);
        const double* const R =
            pick<consecutive>(q[1 + d], right, n, buffer[1]);
        const double* const S = &area_[d][r.first];

        #pragma GCC ivdep
        for (int i = 0; i < n; ++i)
        {
            flux[i] += 0.5*(L[i] + R[i])*S[i];
        }
    }

    distribute<consecutive>(flux, left, right, n, divergence_);
}


template<bool consecutive>
void Foam::acoustics::centralFluxes::viscous
(
    const run& r,
    const state& q,
    state& sum
) const
{
    const int n = r.size;
    const int* const left = &cells_[1][r.first];
    const int* const right = &cells_[2][r.first];
    const double* const D = &conductance_[r.first];

    alignas(64) double buffer[2][most];
    alignas(64) double bulk[most];
    alignas(64) double heat[most];
    alignas(64) double flux[most];

    const double* L = pick<consecutive>(divergence_, left, n, buffer[0]);
    const double* R = pick<consecutive>(divergence_, right, n, buffer[1]);

    #pragma GCC ivdep
    for (int i = 0; i < n; ++i)
    {
        bulk[i] = gas_.mu/6*(L[i] + R[i]);
    }

    L = pick<consecutive>(T_, left, n, buffer[0]);
    R = pick<consecutive>(T_, right, n, buffer[1]);

    #pragma GCC ivdep
    for (int i = 0; i < n; ++i)
    {
        heat[i] = -gas_.kappa*D[i]*(R[i] - L[i]);
    }

    for (int d = 0; d < 3; ++d)
    {
        const double* const S = &area_[d][r.first];
        L = pick<consecutive>(q[1 + d], left, n, buffer[0]);
        R = pick<consecutive>(q[1 + d], right, n, buffer[1]);

        #pragma GCC ivdep
        for (int i = 0; i < n; ++i)
        {
            flux[i] = -gas_.mu*D[i]*(R[i] - L[i]) - bulk[i]*S[i];
            heat[i] += 0.5*(L[i] + R[i])*flux[i];
        }

        distribute<consecutive>(flux, left, right, n, sum[1 + d]);
    }

    distribute<consecutive>(heat, left, right, n, sum[4]);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::centralFluxes::centralFluxes
(
    const gas& g,
    std::vector<face> faces
)
:
    gas_(g)
{
    // Block by block, in each block direction by direction, where the four
    // places are apart by the same
    const auto key = [](const face& f)
    {
        const auto& c = f.cells;
        return std::make_tuple
        (
            c[1]/blockSize, c[2] - c[1], c[1] - c[0], c[3] - c[2], c[1]
        );
    };

    std::stable_sort
    (
        faces.begin(),
        faces.end(),
        [&](const face& a, const face& b) { return key(a) < key(b); }
    );

    const int n = int(faces.size());

    for (const face& f : faces)
    {
        for (int j = 0; j < 4; ++j)
        {
            cells_[j].push_back(f.cells[j]);
        }
        for (int d = 0; d < 3; ++d)
        {
            area_[d].push_back(f.area[d]);
        }
        magnitude_.push_back
        (
            std::sqrt
            (
                f.area[0]*f.area[0] + f.area[1]*f.area[1] + f.area[2]*f.area[2]
            )
        );
        conductance_.push_back(f.conductance);

        // Without a line the differences say nothing of how smooth it is
        const bool line =
            f.cells[0] != f.cells[1] && f.cells[3] != f.cells[2];
        filter_.push_back(line ? filterStrength : 0);
    }

    // Fewer than that are gathered
    constexpr int fewest = 4;

    for (int first = 0; first < n; )
    {
        int size = 1;

        const auto follows = [&](const int i)
        {
            bool yes = true;
            for (int j = 0; j < 4; ++j)
            {
                yes = yes && cells_[j][i] == cells_[j][i - 1] + 1;
            }
            return yes;
        };

        while (first + size < n && size < most && follows(first + size))
        {
            ++size;
        }

        const bool consecutive = size >= fewest;

        if
        (
            !consecutive
         && !runs_.empty()
         && !runs_.back().consecutive
         && runs_.back().size + size <= most
        )
        {
            runs_.back().size += size;
        }
        else
        {
            runs_.push_back({first, size, consecutive});
        }

        first += size;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::acoustics::centralFluxes::addInviscid
(
    const state& q,
    state& sum
) const
{
    for (const run& r : runs_)
    {
        if (r.consecutive)
        {
            inviscid<true>(r, q, sum);
        }
        else
        {
            inviscid<false>(r, q, sum);
        }
    }
}


Foam::acoustics::centralFluxes::array&
Foam::acoustics::centralFluxes::divergence(const state& q)
{
    divergence_.assign(q[0].size(), 0);

    for (const run& r : runs_)
    {
        if (r.consecutive)
        {
            dilatation<true>(r, q);
        }
        else
        {
            dilatation<false>(r, q);
        }
    }

    return divergence_;
}


void Foam::acoustics::centralFluxes::addViscous(const state& q, state& sum)
{
    const size_t n = q[0].size();
    T_.resize(n);

    for (size_t i = 0; i < n; ++i)
    {
        T_[i] = q[4][i]/(gas_.R*q[0][i]);
    }

    for (const run& r : runs_)
    {
        if (r.consecutive)
        {
            viscous<true>(r, q, sum);
        }
        else
        {
            viscous<false>(r, q, sum);
        }
    }
}


// ************************************************************************* //
