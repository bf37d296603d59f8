/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "historyWake.H"
#include "addToRunTimeSelectionTable.H"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(historyWake, 0);
    addToRunTimeSelectionTable(wake, historyWake, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Boys' function F_n(z) = int_0^1 t^2n exp(-z t^2) dt for n of 1 and 2
double Boys(const int n, const double z)
{
    if (z < 1)
    {
        double sum = 0;
        double term = 1;

        for (int k = 0; k < 20; ++k)
        {
            sum += term/(2*(n + k) + 1);
            term *= -z/(k + 1);
        }

        return sum;
    }

    const double E = std::exp(-z);
    const double F0 = 0.5*std::sqrt(EIGEN_PI/z)*std::erf(std::sqrt(z));
    const double F1 = (F0 - E)/(2*z);

    return n == 1 ? F1 : (3*F1 - E)/(2*z);
}


//- F_1 and F_2 as polynomials in y^2, times y^3 and y^5, of y = (1 + z/c)^-1/2,
//  through Chebyshev's points: off by 4e-4 of them at most
struct BoysFunctions
{
    static constexpr int nPowers = 11;
    static constexpr float c = 3.5;

    using powers = std::array<float, nPowers>;

    powers first = fitted(1);
    powers second = fitted(2);

    static powers fitted(const int n)
    {
        Eigen::Matrix<double, nPowers, nPowers> power;
        Eigen::Matrix<double, nPowers, 1> value;

        for (int i = 0; i < nPowers; ++i)
        {
            const double t = 0.5 - 0.5*std::cos(EIGEN_PI*(i + 0.5)/nPowers);

            for (int k = 0; k < nPowers; ++k)
            {
                power(i, k) = std::pow(t, k);
            }

            value(i) = Boys(n, c*(1/t - 1))/std::pow(t, n + 0.5);
        }

        const Eigen::Matrix<double, nPowers, 1> solution =
            power.fullPivLu().solve(value);

        powers result;

        for (int k = 0; k < nPowers; ++k)
        {
            result[k] = solution(k);
        }

        return result;
    }
};


inline float polynomial(const BoysFunctions::powers& c, const float t)
{
    float sum = c[BoysFunctions::nPowers - 1];

    for (int k = BoysFunctions::nPowers - 2; k >= 0; --k)
    {
        sum = sum*t + c[k];
    }

    return sum;
}


//- A point of the past, in units of 1/omega
struct instant
{
    double time;
    double weight;

    //- Share of the oscillation
    double window;

    double cosine = std::cos(time);
    double sine = std::sin(time);
};

constexpr int nInstants = 20;

std::array<instant, nInstants> past()
{
    constexpr double scale = 6;
    constexpr double begin = 2;
    constexpr double end = 11;

    std::array<instant, nInstants> result;

    for (int k = 0; k < nInstants; ++k)
    {
        const double xi = (k + 0.5)/nInstants;
        const double root = xi/(1 - xi);
        const double time = scale*root*root;
        const double t =
            std::clamp((time - begin)/(end - begin), 0.0, 1.0);

        result[k] = instant
        {
            time,
            2*scale*root/(1 - xi)/(1 - xi)/nInstants,
            1 - t*t*t*(10 - t*(15 - 6*t))
        };
    }

    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::historyWake::historyWake(const dictionary& dict)
:
    memoryWake(dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::aerosol::historyWake::reach
(
    const scalar a,
    const scalar U
) const
{
    return std::min(bound(a, U, 1), end(U));
}


std::vector<Foam::aerosol::wake::path> Foam::aerosol::historyWake::paths
(
    const vectors& slip,
    const vectors& imaginary
) const
{
    std::vector<path> result(slip.cols());

    for (std::size_t j = 0; j < result.size(); ++j)
    {
        // An ellipse about Q/omega, in a strip along the longer of both
        const Eigen::Vector3d P = slip.col(j)/omega();
        const Eigen::Vector3d Q = imaginary.col(j)/omega();
        const bool ofP = P.squaredNorm() > Q.squaredNorm();
        const Eigen::Vector3d direction = (ofP ? P : Q).normalized();
        const Eigen::Vector3d& other = ofP ? Q : P;

        result[j] = path
        {
            {Q(0), Q(1), Q(2)},
            {direction(0), direction(1), direction(2)},
            std::sqrt(P.squaredNorm() + Q.squaredNorm()),
            (other - direction.dot(other)*direction).norm(),
            4*layer()
        };
    }

    return result;
}


void Foam::aerosol::historyWake::oscillating
(
    block& pairs,
    const acoustics::gasProperties& gas
) const
{
    static const BoysFunctions boys;
    static const std::array<instant, nInstants> instants = past();

    OseenWake::evaluate(pairs, gas);

    // In units of the Stokes layer and 1/omega, so that 4 nu s is twice the
    // time. Single precision is more exact than the sum, and twice as fast.
    using floats = Eigen::Array<float, blockSize, 1>;

    const double perLayer = std::sqrt(0.5*omega()/gas.nu());
    const double perSpeed = perLayer/omega();

    // Within the sphere the value at its surface is used
    const blockScalars a = perLayer*pairs.radius;
    const blockScalars out =
        perLayer
       *(
            pairs.radius
           *(
                pairs.r[0].square()
              + pairs.r[1].square()
              + pairs.r[2].square()
            ).rsqrt()
        ).max(1.0);

    std::array<floats, 3> r, P, Q;

    for (int k = 0; k < 3; ++k)
    {
        r[k] = (out*pairs.r[k]).cast<float>();
        P[k] = (perSpeed*pairs.slip[k]).cast<float>();
        Q[k] = (perSpeed*pairs.imaginary[k]).cast<float>();
    }

    const auto dot = [](const auto& x, const auto& y)
    {
        return floats(x[0]*y[0] + x[1]*y[1] + x[2]*y[2]);
    };

    const floats rr = dot(r, r);
    const floats rP = dot(r, P);
    const floats rQ = dot(r, Q);
    const floats PP = dot(P, P);
    const floats PQ = dot(P, Q);
    const floats QQ = dot(Q, Q);

    floats ofR = floats::Zero();
    floats ofP = floats::Zero();
    floats ofQ = floats::Zero();

    // Add the response of the gas to the slip U = u P + v Q after the
    // displacement d = p P + q Q, a time ago, by the coefficients of r, P and
    // Q. The compiler turns this loop into vector instructions: check that it
    // does (-fopt-info-vec) after a change.
    const auto add = [&]
    (
        const float time,
        const float weight,
        const float u,
        const float v,
        const float p,
        const float q
    )
    {
        const float perSpread = 0.5f/time;
        const float scale =
            2*weight*std::pow(perSpread/static_cast<float>(EIGEN_PI), 1.5f);

        for (int b = 0; b < blockSize; ++b)
        {
            const float distanceSqr =
                rr(b) - 2*(p*rP(b) + q*rQ(b))
              + p*p*PP(b) + 2*p*q*PQ(b) + q*q*QQ(b);
            const float z = perSpread*(distanceSqr > 0 ? distanceSqr : 0);
            const float along =
                u*rP(b) + v*rQ(b)
              - p*u*PP(b) - (p*v + q*u)*PQ(b) - q*v*QQ(b);

            const float t = 1/(1 + z/BoysFunctions::c);
            const float y = std::sqrt(t);
            const float F1 = t*y*polynomial(boys.first, t);
            const float F2 = t*t*y*polynomial(boys.second, t);

            const float ofU = scale*(F1 - z*F2);
            const float ofWay = scale*perSpread*F2*along;

            ofR(b) += ofWay;
            ofP(b) += u*ofU - p*ofWay;
            ofQ(b) += v*ofU - q*ofWay;
        }
    };

    for (const instant& i : instants)
    {
        add(i.time, i.weight, 1, 0, i.time, 0);

        if (i.window > 0)
        {
            add
            (
                i.time, -i.window*i.weight,
                i.cosine, i.sine, i.sine, 1 - i.cosine
            );
        }
    }

    // 6 pi nu a in these units, and back to m/s
    const blockScalars strength = (3*EIGEN_PI/perSpeed)*a;

    for (int k = 0; k < 3; ++k)
    {
        pairs.velocity[k] +=
            strength*(ofR*r[k] + ofP*P[k] + ofQ*Q[k]).cast<double>();
    }
}


// ************************************************************************* //
