/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "verletSkin.H"
#include "communicator.H"
#include "StokesResponse.H"

#include <array>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Cost of a search per particle, in looks at a pair of 4 ns each (measured:
//  some 0.15 us per particle, for wakes 1.2 us)
constexpr double searchCost = 40;
constexpr double wakeSearchCost = 300;

constexpr int mostSteps = 32;

//- A skin for the whole oscillation: its size, in amplitudes, and the number of
//  steps that it is estimated to last
constexpr double amplitudeFactor = 1.1;
constexpr int amplitudeSteps = 100;

//- Allowance for drift before a new search, in mean distances
constexpr double drift = 0.02;

//- The displacement of the next step, in those of this one
constexpr double growth = 1.1;

constexpr int blockSize = 64;
using block = Eigen::Array<double, blockSize, 1>;

block norm(const std::array<block, 3>& v)
{
    return
        (v[0].square() + v[1].square() + v[2].square() + 1e-60).sqrt();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::aerosol::verletSkin::make
(
    const particleArrays& p,
    const vectors& x1,
    const vectors& v1,
    const scalars& wakeSpeed,
    const scalars& least,
    const double h,
    const double frequency,
    const double velocityAmplitude,
    const double concentration
)
{
    const int n = p.size();

    // Also on ranks without particles
    const bool withWakes = communicator::max(wakeSpeed.size()) > 0;
    const bool crowded =
        communicator::max(withWakes && n ? -wakeSpeed.minCoeff() : -1.0) > 0;
    const double omega = 2*EIGEN_PI*frequency;

    const Eigen::Vector3d mean = communicator::mean(p.v - p.thermal);

    // Real and imaginary part of the response
    vectors response = vectors::Zero(3, n);
    if (frequency > 0)
    {
        for (int i = 0; i < n; ++i)
        {
            const StokesResponse H(p.rate(i), omega);
            response(0, i) = H.real();
            response(1, i) = H.imaginary();
        }
    }

    const Eigen::Vector3d meanResponse = communicator::mean(response);

    scalars displacement(n);
    double longest = 0;
    for (int i = 0; i < n; ++i)
    {
        const double speed = (p.v.col(i) - p.thermal.col(i) - mean).norm();

        longest = std::max(longest, h*speed);
        displacement(i) =
            h
           *std::max
            (
                speed,
                velocityAmplitude*(response.col(i) - meanResponse).norm()
              + (withWakes ? response.col(i).norm()*wakeSpeed(i) : 0.0)
            );
    }

    // In mean distances, lest the rounding of the mean loses digits
    const double inverse = std::cbrt(concentration);
    const double sphere = 4*EIGEN_PI/3;

    // Looks at pairs per particle and step, if skins of K displacements last
    // some steps
    const auto cost = [&](const double K, const double steps)
    {
        // First, second and third powers, worked out one by one
        const auto power = [](const double x, const Eigen::Index k)
        {
            return k == 0 ? x : k == 1 ? x*x : x*x*x;
        };
        const auto skin = [&](const Eigen::Index i)
        {
            return inverse*(least(i) + K*displacement(i)) + drift;
        };
        const auto acts = [&](const Eigen::Index i)
        {
            return withWakes && p.range(i) > 0;
        };
        const auto mean = [&](const auto& numbers)
        {
            return communicator::mean(vectors::NullaryExpr(3, n, numbers));
        };
        using index = Eigen::Index;

        const Eigen::Vector3d s = mean
        (
            [&](const index k, const index i) { return power(skin(i), k); }
        );
        const Eigen::Vector3d r = mean
        (
            [&](const index k, const index i)
            {
                return acts(i) ? power(inverse*p.range(i) + skin(i), k) : 0;
            }
        );
        const double part = mean
        (
            [&](const index, const index i) { return acts(i) ? 1.0 : 0.0; }
        )(0);

        return
            (withWakes ? wakeSearchCost : searchCost)/steps
          + sphere
           *(
                0.5*(2*s(2) + 6*s(1)*s(0))
              + r(2) + 3*r(1)*s(0) + 3*r(0)*s(1) + part*s(2)
            );
    };

    // No skin at all: searched in each step, for contacts twice
    double K = 0;
    double cheapest = crowded ? 0 : cost(0, 1) + searchCost;

    for (double next = 1; !crowded && next <= mostSteps; next *= 2)
    {
        const double price = cost(next, next);

        if (price < cheapest)
        {
            K = next;
            cheapest = price;
        }
    }

    centre_ = p.x;
    extent_.resize(3, 0);
    moved_.setZero();

    const double amplitude = frequency > 0 ? 1/(omega*h) : 0;

    if
    (
        frequency > 0
     && !crowded
     && cost(amplitudeFactor*amplitude, amplitudeSteps) < cheapest
    )
    {
        K = amplitudeFactor*amplitude;

        // From the middle of the next step, less the mean
        const auto offsets =
            0.5*(x1 - p.x) + (v1 - p.v + p.thermal)/(h*omega*omega);

        // Of particles in no strong wakes: wakes oscillate with the gas, too
        vectors quiet = vectors::Zero(3, n);
        vectors parts = vectors::Zero(3, n);
        for (int i = 0; i < n; ++i)
        {
            if (!withWakes || wakeSpeed(i) < 0.003*velocityAmplitude)
            {
                quiet.col(i).setOnes();
                parts.col(i) = offsets.col(i)/h;
            }
        }

        const double share = communicator::mean(quiet)(0);
        const Eigen::Vector3d common =
            share > 0 ? Eigen::Vector3d(communicator::mean(parts)*(h/share))
          : Eigen::Vector3d(communicator::mean(offsets/h)*h);

        for (int i = 0; i < n; ++i)
        {
            const Eigen::Vector3d off = offsets.col(i) - common;

            // Limit the offset to the amplitude: a larger one is no oscillation
            centre_.col(i) +=
                off
               *std::min
                (
                    1.0,
                    amplitude*displacement(i)/(off.norm() + 1e-30)
                );
        }
    }

    size_ = least + K*displacement + drift/inverse;
    lasting_ = K > 0;
    expired_ = !lasting_;

    return longest;
}


bool Foam::aerosol::verletSkin::hold
(
    const particleArrays& p,
    const vectors& v0,
    const vectors& x1,
    const vectors& v1,
    const double h,
    const Eigen::Vector3d& displacement,
    const double radii,
    const scalars& extra
)
{
    const int n = p.size();
    const Eigen::Vector3d mean = displacement/h;
    const Eigen::Vector3d after = moved_ + displacement;

    const bool boxes = extent_.cols();
    bool inside = true;

    block skin = block::Ones();
    block own = block::Zero();
    std::array<block, 3> chord, off, begin, end;

    for (std::array<block, 3>* values : {&chord, &off, &begin, &end})
    {
        values->fill(block::Zero());
    }

    for (int from = 0; from < n; from += blockSize)
    {
        const int size = std::min(blockSize, n - from);

        for (int l = 0; l < size; ++l)
        {
            const int i = from + l;

            for (int c = 0; c < 3; ++c)
            {
                chord[c](l) = x1(c, i) - p.x(c, i) - displacement(c);
                off[c](l) = x1(c, i) - centre_(c, i) - after(c);
                if (boxes)
                {
                    off[c](l) =
                        std::max(0.0, std::abs(off[c](l)) - extent_(c, i));
                }
                begin[c](l) = h*(v0(c, i) - mean(c)) - chord[c](l);
                end[c](l) = h*(v1(c, i) - mean(c)) - chord[c](l);
            }

            skin(l) = size_(i);
            own(l) = 0.5*radii*p.collisionDiameter(i);
        }

        if (extra.size())
        {
            for (int l = 0; l < size; ++l)
            {
                own(l) = std::max(own(l), extra(from + l));
            }
        }

        for (int l = size; l < blockSize; ++l)
        {
            skin(l) = 1e100;
        }

        const block length = norm(chord);
        const block bulge = 4.0/27*(norm(begin) + norm(end));
        const block need = norm(off) + length + bulge + own;

        inside = inside && (need <= skin).all();
        expired_ = expired_ || (need + (growth - 1)*length > skin).any();
    }

    return inside;
}


void Foam::aerosol::verletSkin::make
(
    vectors centres,
    vectors extents,
    scalars sizes
)
{
    centre_.swap(centres);
    extent_.swap(extents);
    size_.swap(sizes);
    moved_.setZero();
    lasting_ = true;
    expired_ = false;
}


bool Foam::aerosol::verletSkin::contain
(
    const particleArrays& p,
    const scalars& displacement
) const
{
    for (int i = 0; i < p.size(); ++i)
    {
        if (!(beyond(i, p.x.col(i)) + displacement(i) <= size_(i)))
        {
            return false;
        }
    }

    return true;
}


void Foam::aerosol::verletSkin::remove(const std::vector<char>& marked)
{
    aerosol::remove(centre_, marked);
    aerosol::remove(size_, marked);
    if (extent_.cols())
    {
        aerosol::remove(extent_, marked);
    }
}


// ************************************************************************* //
