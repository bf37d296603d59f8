/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "memoryWake.H"
#include "addToRunTimeSelectionTable.H"
#include "checkedEntry.H"
#include "mathematicalConstants.H"

#include <algorithm>
#include <array>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(memoryWake, 0);
    addToRunTimeSelectionTable(wake, memoryWake, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Powers of lambda in the series of A, B, D, which are used up to |lambda| =
//  0.42: what is missing is below the precision
constexpr int nPowers = 12;

//- Single precision is more exact than the expansion, and Eigen has sine and
//  cosine in vectors of it
using floats = Eigen::Array<float, Foam::aerosol::wake::blockSize, 1>;

//- Coefficients of the powers of x = r/delta
struct coefficients
{
    float reA[nPowers] = {};
    float imA[nPowers] = {};
    float reB[nPowers] = {};

    // Over x^2
    float imB[nPowers] = {};
    float imD[nPowers] = {};
    float reD[nPowers] = {};
};


constexpr coefficients series()
{
    coefficients c;

    // (-1)^n/n! and the powers of 1 + i
    double f = 1;
    double re = 1;
    double im = 0;

    for (int n = 0; n < nPowers; ++n)
    {
        const double f1 = f/(n + 1);
        const double f2 = f1/(n + 2);
        const double a = 2*(f - f1 + f2);
        const double b = -2*(f - 3*f1 + 3*f2);
        const double d = 2*f*(1 - n);

        c.reA[n] = a*re;
        c.imA[n] = a*im;
        c.reB[n] = b*re;

        if (n >= 2)
        {
            c.imB[n - 2] = b*im;
            c.imD[n - 2] = d*im;
            c.reD[n - 2] = d*re;
        }

        f = -f1;
        const double next = re - im;
        im = re + im;
        re = next;
    }

    return c;
}


floats polynomial(const float (&c)[nPowers], const floats& x)
{
    floats sum = x*c[nPowers - 1];

    for (int n = nPowers - 2; n > 0; --n)
    {
        sum = (sum + c[n])*x;
    }

    return sum + c[0];
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::aerosol::memoryWake::layer() const
{
    return std::sqrt(2*nu_/omega_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::memoryWake::memoryWake(const dictionary& dict)
:
    OseenWake(dict, {"frequency"}),
    omega_
    (
        constant::mathematical::twoPi
       *readPositive(dict, "frequency", dimless/dimTime, 0)
    ),
    nu_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::memoryWake::setSound
(
    const dictionary& dict,
    const scalar omega,
    const acoustics::gasProperties& gas
)
{
    nu_ = gas.nu();

    if (omega_ > 0 && omega > 0 && mag(omega_ - omega) > 1e-6*omega)
    {
        IOWarningInFunction(dict)
            << "Entry 'frequency' of " << dict.name() << " is "
            << omega_/constant::mathematical::twoPi << " Hz, but the sound has "
            << omega/constant::mathematical::twoPi << " Hz" << endl;
    }

    if (omega_ <= 0)
    {
        omega_ = omega;
    }

    if (omega_ <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Wakes with memory need to know the frequency of the sound,"
            << " which has none: give 'frequency' [Hz], or take another 'type'"
            << exit(FatalIOError);
    }
}


Foam::scalar Foam::aerosol::memoryWake::bound
(
    const scalar a,
    const scalar U,
    const double amplitudes
) const
{
    const double delta = layer();
    const double driftTolerance =
        tolerance()/(10*constant::mathematical::pi);

    const double Stokes = 1.5*a*U/tolerance();
    const double dipole = std::cbrt(1.2*Stokes*delta*delta);
    const double drift = 3.0/16*a*U*U/nu_/driftTolerance;

    return std::max
    (
        std::min(Stokes, dipole),
        drift > 1
      ? amplitudes*U/omega_ + delta*std::sqrt(std::sqrt(7.7*drift))
      : 0.0
    );
}


Foam::scalar Foam::aerosol::memoryWake::end(const scalar U) const
{
    return 4*layer() + 2*U/omega_;
}


Foam::scalar Foam::aerosol::memoryWake::reach
(
    const scalar a,
    const scalar U
) const
{
    const double all = bound(a, U, 0);

    return needsTolerance() ? std::min(all, end(U)) : all;
}


Foam::aerosol::scalars Foam::aerosol::memoryWake::range
(
    const scalars& d,
    const scalars& slip
) const
{
    if (!(tolerance() > 0))
    {
        return OseenWake::range(d, slip);
    }

    scalars result(d.size());

    for (int i = 0; i < result.size(); ++i)
    {
        // GREAT without drag
        result(i) = reach(0.5*d(i), std::min(slip(i), 1e6));
    }

    return result;
}


void Foam::aerosol::memoryWake::evaluate
(
    block& pairs,
    const acoustics::gasProperties& gas
) const
{
    const blockVectors slip = pairs.slip;

    // A steady part has always been there
    pairs.slip = pairs.steady;
    OseenWake::evaluate(pairs, gas);
    const blockVectors ofSettling = pairs.velocity;

    for (int k = 0; k < 3; ++k)
    {
        pairs.slip[k] = slip[k] - pairs.steady[k];
    }
    oscillating(pairs, gas);

    for (int k = 0; k < 3; ++k)
    {
        pairs.velocity[k] += ofSettling[k];
    }
    pairs.slip = slip;
}


void Foam::aerosol::memoryWake::oscillating
(
    block& pairs,
    const acoustics::gasProperties& gas
) const
{
    // Where the series are better than the differences
    constexpr float small = 0.3f;

    std::array<floats, 3> n, P, Q;

    const blockScalars perDistance =
        (
            pairs.r[0].square() + pairs.r[1].square() + pairs.r[2].square()
        ).rsqrt();

    for (int k = 0; k < 3; ++k)
    {
        n[k] = (pairs.r[k]*perDistance).cast<float>();
        P[k] = pairs.slip[k].cast<float>();
        Q[k] = pairs.imaginary[k].cast<float>();
    }

    // a/r, one within the sphere
    const blockScalars ratio = (pairs.radius*perDistance).min(1.0);
    const floats q = ratio.cast<float>();
    const floats x =
        (std::sqrt(0.5*omega_/gas.nu())*(pairs.radius/ratio)).cast<float>();

    // E = exp(-lambda); none is left at 40
    const floats large = x.max(small);
    const floats phase = large.min(40.0f);
    const floats decay = (-phase).exp();
    const floats reE = decay*phase.cos();
    const floats imE = -decay*phase.sin();

    // 1/lambda = h (1 - i)
    const floats h = 0.5f/large;
    const floats hh = 2*h.square();
    const floats perSquare = 2*hh;

    static constexpr coefficients c = series();
    const floats little = x.min(small);
    const auto near = x < small;

    const floats reA = near.select
    (
        polynomial(c.reA, little),
        2*(reE*(1 + h) + imE*(h + hh))
    );
    const floats imA = near.select
    (
        polynomial(c.imA, little),
        2*(imE*(1 + h) - reE*(h + hh) + hh)
    );
    const floats reB = near.select
    (
        polynomial(c.reB, little),
        -2*(reE*(1 + 3*h) + 3*imE*(h + hh))
    );

    // Over x^2
    const floats imB = near.select
    (
        polynomial(c.imB, little),
        -2*perSquare*(imE*(1 + 3*h) - 3*reE*(h + hh) + 3*hh)
    );
    const floats imD = near.select
    (
        polynomial(c.imD, little),
        2*perSquare*(reE*large + imE*(1 + large))
    );
    const floats reD = near.select
    (
        polynomial(c.reD, little),
        2*perSquare*(reE*(1 + large) - imE*large - 1)
    );

    const floats Pn = P[0]*n[0] + P[1]*n[1] + P[2]*n[2];
    const floats Qn = Q[0]*n[0] + Q[1]*n[1] + Q[2]*n[2];
    const floats square =
        P[0].square() + P[1].square() + P[2].square();

    const floats Stokeslet = -0.75f*q;
    const floats dipole = -0.25f*q.cube();
    const floats drift =
        ((-3.0/16/gas.nu())*pairs.radius).cast<float>();
    const floats across = 2*drift*(2*imB - imD);
    const floats turn = drift*reD;

    const floats alongP =
        Stokeslet*reA + dipole + across*Pn + turn*Qn;
    const floats alongQ = -Stokeslet*imA - turn*Pn;
    const floats outward =
        Stokeslet*(reB*Pn - x.square()*imB*Qn)
      - 3*dipole*Pn
      + 2*drift*((imD - 5*imB)*Pn.square() + imB*square);

    for (int k = 0; k < 3; ++k)
    {
        pairs.velocity[k] =
            (alongP*P[k] + alongQ*Q[k] + outward*n[k]).cast<double>();
    }
}


// ************************************************************************* //
