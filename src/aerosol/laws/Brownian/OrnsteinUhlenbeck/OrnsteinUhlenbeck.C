/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "OrnsteinUhlenbeck.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(OrnsteinUhlenbeck, 0);
    addToRunTimeSelectionTable(Brownian, OrnsteinUhlenbeck, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::aerosol;

constexpr int nLanes = OrnsteinUhlenbeck::nLanes;
using lanes = OrnsteinUhlenbeck::lanes;

//- Boltzmann's constant [J/K], exact since 2019
constexpr double kB = 1.380649e-23;


//- Those of particle i, i + 1, ..., and sound ones for unused lanes
lanes fill(const scalars& values, const int i, const int n)
{
    lanes result = lanes::Ones();
    result.head(n) = values.segment(i, n);

    return result;
}


//- Standard deviation sqrt(kB T/m) of a component of the velocity
lanes thermalSpeed
(
    const particleArrays& particles,
    const gasProperties& gas,
    const int i,
    const int n
)
{
    const lanes m = fill(particles.m, i, n);
    lanes speed;

    for (int b = 0; b < nLanes; ++b)
    {
        speed(b) = std::sqrt(kB*gas.T/m(b));
    }

    return speed;
}


//- Pairs of independent normal numbers, from the upper 52 bits for the radius
//  and 33 bits for the angle
void BoxMuller
(
    const std::uint64_t* radiusBits,
    const std::uint64_t* angleBits,
    lanes& first,
    lanes& second
)
{
    // Thirty bits of the angle are within the octant from zero to pi/4, where
    // Taylor's series are exact to rounding, and three tell the octant
    lanes u, t, steep, signA, signB;

    for (int b = 0; b < nLanes; ++b)
    {
        const std::uint64_t angle = angleBits[b];

        u(b) = counterRandom::openUniform(radiusBits[b]);
        t(b) = (static_cast<double>(angle >> 3) + 0.5)
           *(0.25*EIGEN_PI*0x1p-30);
        signA(b) = 1 - static_cast<double>(angle & 2);
        signB(b) = 1 - 0.5*static_cast<double>(angle & 4);
        steep(b) = static_cast<double>(angle & 1);
    }

    const lanes logU = u.log();
    const lanes s = t.square();

    const lanes sine =
        t*(1 - s*(1.0/6)*(1 - s*(1.0/20)*(1 - s*(1.0/42)*(1 - s*(1.0/72)
       *(1 - s*(1.0/110)*(1 - s*(1.0/156)*(1 - s*(1.0/210))))))));
    const lanes cosine =
        1 - s*(1.0/2)*(1 - s*(1.0/12)*(1 - s*(1.0/30)*(1 - s*(1.0/56)
       *(1 - s*(1.0/90)*(1 - s*(1.0/132)*(1 - s*(1.0/182)
       *(1 - s*(1.0/240))))))));

    lanes radius;
    for (int b = 0; b < nLanes; ++b)
    {
        radius(b) = std::sqrt(-2*std::min(logU(b), 0.0));
    }

    first = radius*signA*(steep*sine + (1 - steep)*cosine);
    second = radius*signB*(steep*cosine + (1 - steep)*sine);
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::aerosol::OrnsteinUhlenbeck::law::law(const lanes& z)
{
    // Not Eigen's sqrt, for which zero is an error in AVX-512, nor its
    // select(), which is not vectorised
    constexpr double small = 0.5;

    decay = (-z).exp();

    for (int b = 0; b < nLanes; ++b)
    {
        const double y = 0.5*z(b);

        // Below the limit z - 2g cancels. Lambert's continued fraction of
        // tanh, its first seven terms: right to 3e-15 of z - 2g at the limit.
        const double w = std::min(y, small)*std::min(y, small);
        const double series =
            (45045 + w*(2772 + w*27))
           /(135135 + w*(62370 + w*(3150 + w*28)));

        const double ys = std::max(y, small);
        const double ratio = (1 - decay(b))/((1 + decay(b))*ys);

        // tanh(y)/y, and (y - tanh(y))/y^2
        const double G = y < small ? 1 - w*series : ratio;
        const double R = y < small ? y*series : (1 - ratio)/ys;

        gain(b) = G/(1 + y*G);
        slope(b) = 0.5*G;
        v(b) = 2*std::sqrt(y*G)/(1 + y*G);
        x(b) = std::sqrt(R);
    }
}


void Foam::aerosol::OrnsteinUhlenbeck::normals
(
    const particleArrays& particles,
    const int i,
    const std::int64_t step,
    const std::uint64_t block,
    std::array<lanes, 6>& numbers
) const
{
    // One counter gives 4 x 64 bits. Three pairs by Box and Muller take 3 x 52
    // for their radii and 3 x 33, the 12 left of each word and 21 of the
    // fourth, for their angles.
    std::uint64_t words[4][nLanes] = {};

    for (int b = 0; b < nLanes && i + b < particles.size(); ++b)
    {
        const auto bits = random_.bits
        (
            particles.id(i + b),
            step,
            counterRandom::stream::Brownian,
            block
        );

        for (int k = 0; k < 4; ++k)
        {
            words[k][b] = bits[k];
        }
    }

    for (int k = 0; k < 3; ++k)
    {
        std::uint64_t angles[nLanes];
        for (int b = 0; b < nLanes; ++b)
        {
            angles[b] =
                (words[k][b] & 0xfff) << 21
              | ((words[3][b] >> 21*k) & 0x1fffff);
        }

        BoxMuller(words[k], angles, numbers[k], numbers[3 + k]);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::OrnsteinUhlenbeck::OrnsteinUhlenbeck(const dictionary& dict)
:
    random_(readSeed(dict))
{
    requireOnly(dict, {"type", "seed"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::OrnsteinUhlenbeck::increment
(
    const particleArrays& particles,
    const scalars& rate,
    const gasProperties& gas,
    const scalar h,
    const std::int64_t step,
    const std::uint64_t block,
    increments& k
) const
{
    const int size = particles.size();

    k.v.resize(3, size);
    k.x.resize(3, size);

    std::array<lanes, 6> numbers;

    for (int i = 0; i < size; i += nLanes)
    {
        const int n = std::min(nLanes, size - i);

        const law whole(h*fill(rate, i, n));
        const lanes speed = thermalSpeed(particles, gas, i, n);

        normals(particles, i, step, block, numbers);

        for (int c = 0; c < 3; ++c)
        {
            const lanes v = speed*whole.v*numbers[c];
            const lanes x =
                h*(whole.slope*v + speed*whole.x*numbers[3 + c]);

            k.v.row(c).segment(i, n) = v.head(n).matrix().transpose();
            k.x.row(c).segment(i, n) = x.head(n).matrix().transpose();
        }
    }
}


void Foam::aerosol::OrnsteinUhlenbeck::bridge
(
    const particleArrays& particles,
    const scalars& rate,
    const gasProperties& gas,
    const scalar h,
    const std::int64_t step,
    const std::uint64_t block,
    const int n,
    const increments& whole,
    std::vector<increments>& parts
) const
{
    const int size = particles.size();
    const double share = 1.0/n;
    const double hPart = share*h;

    parts.resize(n);

    for (int j = 0; j < n; ++j)
    {
        increment(particles, rate, gas, hPart, step, block + j, parts[j]);
    }

    // For what is divided by a variance: zero where there is no drag
    constexpr double tiny = 1e-60;

    for (int i = 0; i < size; i += nLanes)
    {
        const int used = std::min(nLanes, size - i);

        const lanes z = h*fill(rate, i, used);
        const law all(z);
        const law part(share*z);

        const lanes gain = share*part.gain;
        const lanes slope = share*part.slope;
        const lanes varianceV = part.v.square();
        const lanes varianceX = (share*part.x).square();

        for (int c = 0; c < 3; ++c)
        {
            const auto read = [&](const vectors& from)
            {
                lanes values = lanes::Zero();
                values.head(used) =
                    from.row(c).segment(i, used).transpose().array();

                return values;
            };

            const auto add = [&](const lanes& values, vectors& to)
            {
                to.row(c).segment(i, used) +=
                    values.head(used).matrix().transpose();
            };

            // Where the free parts lead, with lengths in h
            lanes v = lanes::Zero();
            lanes x = lanes::Zero();

            for (const increments& free : parts)
            {
                x += gain*v + read(free.x)/h;
                v = part.decay*v + read(free.v);
            }

            // What is missing, multiplied by the inverse of the covariance
            v = read(whole.v) - v;
            x = read(whole.x)/h - x;

            x = (x - all.slope*v)/(all.x.square() + tiny);
            v = v/(all.v.square() + tiny) - all.slope*x;

            // And shared out, from the last part to the first
            for (int j = n - 1; j >= 0; --j)
            {
                const lanes dv = varianceV*(v + slope*x);

                add(dv, parts[j].v);
                add(h*(slope*dv + varianceX*x), parts[j].x);

                v = part.decay*v + gain*x;
            }
        }
    }
}


Foam::aerosol::Brownian::extent Foam::aerosol::OrnsteinUhlenbeck::reach
(
    const particleArrays& particles,
    const scalars& rate,
    const gasProperties& gas,
    const scalar h
) const
{
    const int size = particles.size();

    extent all{scalars(size), scalars(size), scalars(size)};

    for (int i = 0; i < size; i += nLanes)
    {
        const int n = std::min(nLanes, size - i);

        const lanes z = h*fill(rate, i, n);
        const law whole(z);
        const law half(0.5*z);
        const lanes speed = thermalSpeed(particles, gas, i, n);

        const lanes x =
            (whole.slope*whole.v).square() + whole.x.square();

        // Covariance of one half, and of both together, with lengths in h/2
        const lanes vv = half.v.square();
        const lanes vx = half.slope*vv;
        const lanes xx = half.slope*vx + half.x.square();

        const lanes VV = vv*(1 + half.decay.square());
        const lanes VX = vx*(1 + half.decay) + half.decay*half.gain*vv;
        const lanes XX = 2*xx + 2*half.gain*vx + half.gain.square()*vv;

        // What is left of that of the middle if the end is known
        constexpr double tiny = 1e-60;
        const lanes withV = half.decay*vx;
        const lanes withX = xx + half.gain*vx;
        const lanes slope = VX/(VV + tiny);
        const lanes rest = withX - slope*withV;
        const lanes middle =
            xx - withV.square()/(VV + tiny)
          - rest.square()/(XX - slope*VX + tiny);

        for (int b = 0; b < n; ++b)
        {
            all.v(i + b) = speed(b)*whole.v(b);
            all.x(i + b) = h*speed(b)*std::sqrt(x(b));

            const double way = h*speed(b);
            all.stray(i + b) = way*way*std::max(middle(b), 0.0);
        }
    }

    return all;
}


Foam::scalar Foam::aerosol::OrnsteinUhlenbeck::uniform
(
    const std::int64_t idI,
    const std::int64_t idJ,
    const std::int64_t step,
    const std::uint64_t block
) const
{
    const auto ids = std::minmax(idI, idJ);

    return counterRandom::openUniform
    (
        random_.bits
        (
            ids.first,
            step,
            counterRandom::stream::crossing,
            block,
            ids.second
        )[0]
    );
}


// ************************************************************************* //
