/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "syntheticTurbulence.H"

#include "addToRunTimeSelectionTable.H"
#include "checkedDictionary.H"
#include "checkedEntry.H"
#include "dimensionSets.H"
#include "mathematicalConstants.H"
#include "nearestMultiple.H"
#include "sineSeries.H"
#include "Switch.H"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(syntheticTurbulence, 0);
    addToRunTimeSelectionTable(turbulence, syntheticTurbulence, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::aerosol::syntheticTurbulence;

//- Faces, edges and corners of a cube, one of each opposite two
constexpr int directions[syntheticTurbulence::nWaves][3] =
{
    {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
    {1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1},
    {1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}
};

//- Of Lebedev's quadrature of the sphere with 26 points, both of each two
constexpr double weightsOfCube[4] = {0, 2.0/21, 8.0/105, 9.0/140};

using weights = Eigen::Matrix<double, syntheticTurbulence::nWaves, 1>;

//- Shares of the waves k in the square of the gradient for which its covariance
//  is isotropic, the closest ones to those of a cube: with the unit vectors h,
//  sum w h_i^2 h_j^2 is 3/15 for i = j and 1/15 otherwise
weights isotropic(const std::vector<Eigen::Vector3d>& k)
{
    constexpr int pairs[6][2] =
        {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

    Eigen::Matrix<double, 6, syntheticTurbulence::nWaves> A;
    Eigen::Matrix<double, 6, 1> b;
    weights w;

    for (int i = 0; i < w.size(); ++i)
    {
        const Eigen::Vector3d h = k[i].normalized();
        const int* const n = directions[i];

        w(i) = weightsOfCube[n[0]*n[0] + n[1]*n[1] + n[2]*n[2]];

        for (int row = 0; row < 6; ++row)
        {
            const double product = h(pairs[row][0])*h(pairs[row][1]);

            A(row, i) = product*product;
            b(row) = pairs[row][0] == pairs[row][1] ? 0.2 : 1.0/15;
        }
    }

    const Eigen::Matrix<double, 6, 6> AA = A*A.transpose();
    const Eigen::Matrix<double, 6, 1> missing = b - A*w;

    return w + A.transpose()*AA.ldlt().solve(missing);
}


//- Points that are worked out at once
constexpr int blockSize = 16;

using blockScalars = Eigen::Array<double, blockSize, 1>;

//- Sine and cosine of 2 pi r, to 1e-15, by the series for half the angle
void sineCosine
(
    const blockScalars& r,
    blockScalars& sine,
    blockScalars& cosine
)
{
    const blockScalars y = EIGEN_PI*(r - Foam::nearestMultiple<0>(r));
    const blockScalars z = y*y;

    const blockScalars s = y*Foam::sineSeries(z);

    blockScalars c = 1 - z*(1.0/(21*22));
    c = 1 - z*(1.0/(19*20))*c;
    c = 1 - z*(1.0/(17*18))*c;
    c = 1 - z*(1.0/(15*16))*c;
    c = 1 - z*(1.0/(13*14))*c;
    c = 1 - z*(1.0/(11*12))*c;
    c = 1 - z*(1.0/(9*10))*c;
    c = 1 - z*(1.0/(7*8))*c;
    c = 1 - z*(1.0/(5*6))*c;
    c = 1 - z*(1.0/(3*4))*c;
    c = 1 - z*(1.0/2)*c;

    sine = 2*s*c;
    cosine = 1 - 2*s*s;
}


//- Of the gas as a whole, over G: the acceleration has lost its correlation
//  after a quarter of a period, 2.2/G
constexpr double meanFrequency = 5.0/7;

//- Also far out of what makes sense, no number overflows
Foam::scalar within
(
    const Foam::dictionary& dict,
    const Foam::word& key,
    const Foam::dimensionSet& dimensions,
    const Foam::scalar defaultValue,
    const Foam::scalar least,
    const Foam::scalar most
)
{
    using namespace Foam;

    const scalar value = readPositive(dict, key, dimensions, defaultValue);

    if (value < least || value > most)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' of " << dict.name() << " is " << value
            << ", but must be from " << least << " to " << most
            << exit(FatalIOError);
    }

    return value;
}


//- Of the turbulence, or taken from the mean flow
Foam::scalar readShearRate
(
    const Foam::dictionary& dict,
    Foam::acoustics::soundField& sound
)
{
    using namespace Foam;

    const bool ofMeanFlow = valueOr<Switch>(dict, "meanFlow", false);

    if (dict.found("dissipation") + dict.found("shearRate") + ofMeanFlow != 1)
    {
        FatalIOErrorInFunction(dict)
            << "Give exactly one of 'dissipation' [m2/s3], 'shearRate' [1/s]"
            << " and 'meanFlow yes' in " << dict.name() << exit(FatalIOError);
    }

    // Of Kolmogorov's eddies: one turn in an age, and the speed of sound
    const scalar nu = sound.gas().nu();
    const scalar least = 1e-12;
    const scalar most = sqr(sound.gas().c)/nu;

    if (dict.found("dissipation"))
    {
        const dimensionSet dimensions(sqr(dimVelocity)/dimTime);

        return std::sqrt
        (
            within
            (
                dict, "dissipation", dimensions,
                readPositive(dict, "dissipation", dimensions),
                nu*sqr(least), nu*sqr(most)
            )
           /nu
        );
    }

    if (dict.found("shearRate"))
    {
        return within
        (
            dict, "shearRate", dimless/dimTime,
            readPositive(dict, "shearRate", dimless/dimTime), least, most
        );
    }

    const scalar gradient = sound.flattenMeanFlow();

    if (gradient <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'meanFlow' of " << dict.name() << " is yes, but the mean"
            << " flow of the sound "
            << (gradient < 0 ? "is not known" : "has no gradient") << " in the"
            << " domain. It is the field UMean of the sound 'replay' in"
            << " constant/acousticProperties: let it replay a chamber with"
            << " streaming there, or give 'shearRate'"
            << exit(FatalIOError);
    }

    return gradient;
}


//- a_0, which must be more than what the waves have, or zero
Foam::scalar readAccelerationFactor
(
    const Foam::dictionary& dict,
    const Foam::scalar ofWaves
)
{
    using namespace Foam;

    const bool ofMeanFlow = valueOr<Switch>(dict, "meanFlow", false);

    const scalar factor =
        readNonNegative
        (
            dict, "accelerationFactor", dimless, ofMeanFlow ? 0 : 1.3
        );

    if (factor > 100 || (factor > 0 && factor < ofWaves))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'accelerationFactor' of " << dict.name() << " is "
            << factor << ", but the waves have " << ofWaves << " by themselves,"
            << " and turbulence 1 to 6: give a shorter 'wavelength', a longer"
            << " 'timeScale', a factor of " << ofWaves << " to 100, or 0 for"
            << " waves alone" << exit(FatalIOError);
    }

    return factor;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::syntheticTurbulence::syntheticTurbulence
(
    const dictionary& dict,
    const domain& region,
    acoustics::soundField& sound
)
:
    random_(readSeed(dict)),
    speed_(0),
    acceleration_(0),
    number_(0),
    known_(false),
    time_(0)
{
    requireOnly
    (
        dict,
        {"type", "dissipation", "shearRate", "meanFlow", "accelerationFactor",
         "wavelength", "timeScale", "seed"}
    );

    const scalar nu = sound.gas().nu();

    shearRate_ = readShearRate(dict, sound);

    const scalar KolmogorovLength = std::sqrt(nu/shearRate_);

    interval_ =
        within
        (
            dict, "timeScale", dimTime, 2.3/shearRate_,
            1e-3/shearRate_, 1e9/shearRate_
        )
       /timeScaleOfInterval;

    const Eigen::Array3d edges = region.period();
    const scalar shortest = edges.minCoeff();

    // No more of the acceleration than a part: it is not normally distributed
    const scalar wavelength =
        within
        (
            dict, "wavelength", dimLength,
            shortest/min(std::ceil(shortest/(10*KolmogorovLength)), 1e3),
            1e-4*shortest, 1e3
        );

    perLength_ = (edges/wavelength).round().max(1)/edges;

    std::vector<Eigen::Vector3d> k;
    for (const auto& n : directions)
    {
        k.push_back
        (
            2*EIGEN_PI
           *(perLength_*Eigen::Array3d(n[0], n[1], n[2])).matrix()
        );
    }

    const weights share = isotropic(k);

    if (share.minCoeff() <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "No isotropic turbulence of waves of " << wavelength
            << " m fits a domain of " << edges(0) << " x " << edges(1) << " x "
            << edges(2) << " m: give a 'wavelength' of which each edge is a"
            << " multiple, or nearly so"
            << exit(FatalIOError);
    }

    scalar square = 0;

    for (int i = 0; i < nWaves; ++i)
    {
        // Both amplitudes have two components
        const scalar variance =
            share(i)*shearRate_*shearRate_/(2*k[i].squaredNorm());

        square += 2*variance;

        const Eigen::Vector3d first = k[i].unitOrthogonal();

        normal_[i].col(0) = std::sqrt(variance)*first;
        normal_[i].col(1) =
            std::sqrt(variance)*k[i].normalized().cross(first);
    }

    speed_ = std::sqrt(square/3);

    // In units of turbulence, with G for epsilon: no power of it overflows
    const scalar unit = nu*shearRate_*sqr(shearRate_);
    const scalar ofWaves =
        sqr(speed_)/(nu*shearRate_)
       *(5*sqr(constant::mathematical::pi/(interval_*shearRate_))/14 + 1.0/3);
    const scalar factor = readAccelerationFactor(dict, ofWaves);

    setOscillations(max(factor - ofWaves, scalar(0))*unit);

    std::ostringstream os;
    os  << "Turbulence: dissipation " << nu*sqr(shearRate_)
        << " m2/s3, Kolmogorov length " << KolmogorovLength
        << " m, rms gradient " << shearRate_ << " 1/s\n    as waves of "
        << 1/perLength_(0) << ", " << 1/perLength_(1) << ", "
        << 1/perLength_(2) << " m along the axes, time scale " << timeScale()
        << " s, " << speed_ << " m/s rms\n    acceleration "
        << std::sqrt(max(factor, ofWaves)*unit) << " m/s2 rms, with the factor "
        << max(factor, ofWaves) << ", of which waves have " << ofWaves
        << ", the gas as a whole " << max(factor - ofWaves, scalar(0));

    Info<< os.str().c_str() << endl;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::aerosol::syntheticTurbulence::amplitudes
Foam::aerosol::syntheticTurbulence::drawn(const std::int64_t number) const
{
    amplitudes result;

    for (int i = 0; i < nWaves; ++i)
    {
        const auto z =
            random_.normals(i, number, counterRandom::stream::turbulence);

        result.cosine[i] = normal_[i]*Eigen::Vector2d(z[0], z[1]);
        result.sine[i] = normal_[i]*Eigen::Vector2d(z[2], z[3]);
    }

    return result;
}


void Foam::aerosol::syntheticTurbulence::setOscillations
(
    const scalar variance
)
{
    acceleration_ = std::sqrt(2*variance/nOscillations);

    for (int m = 0; m < nOscillations; ++m)
    {
        // Block 0 has the numbers of the waves
        const auto r =
            random_.uniforms(m, 0, counterRandom::stream::turbulence, 1);

        omega_[m] =
            shearRate_*meanFrequency*(0.5 + (m + r[0])/nOscillations);

        phase_[m] = 2*EIGEN_PI*Eigen::Vector3d(r[1], r[2], r[3]);
    }
}


void Foam::aerosol::syntheticTurbulence::setTime(const scalar t) const
{
    if (known_ && t == time_)
    {
        return;
    }

    const scalar whole = std::floor(t/interval_);
    const std::int64_t number = static_cast<std::int64_t>(whole);

    if (!known_ || number != number_)
    {
        ends_ = {drawn(number), drawn(number + 1)};
        number_ = number;
    }

    const scalar s = t/interval_ - whole;
    const scalar theta = 0.5*EIGEN_PI*s*s*s*(10 - s*(15 - 6*s));
    const scalar c = std::cos(theta);
    const scalar e = std::sin(theta);

    for (int i = 0; i < nWaves; ++i)
    {
        now_.cosine[i] = c*ends_[0].cosine[i] + e*ends_[1].cosine[i];
        now_.sine[i] = c*ends_[0].sine[i] + e*ends_[1].sine[i];
    }

    velocity_.setZero();
    displacement_.setZero();

    for (int m = 0; m < nOscillations; ++m)
    {
        const scalar speed = acceleration_/omega_[m];

        for (int axis = 0; axis < 3; ++axis)
        {
            const scalar angle = omega_[m]*t + phase_[m](axis);

            velocity_(axis) += speed*std::sin(angle);
            displacement_(axis) -= speed/omega_[m]*std::cos(angle);
        }
    }

    time_ = t;
    known_ = true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::syntheticTurbulence::add
(
    const scalar t,
    const vectors& x,
    vectors& u
) const
{
    setTime(t);

    // Whole blocks, the last one filled up: the same instructions for any point
    for (Eigen::Index first = 0; first < x.cols(); first += blockSize)
    {
        const Eigen::Index end =
            std::min<Eigen::Index>(blockSize, x.cols() - first);

        // Of the axes
        blockScalars s[3];
        blockScalars c[3];

        blockScalars sum[3];

        for (int axis = 0; axis < 3; ++axis)
        {
            blockScalars cycles = blockScalars::Zero();

            for (Eigen::Index k = 0; k < end; ++k)
            {
                cycles(k) =
                    perLength_(axis)
                   *(x(axis, first + k) - displacement_(axis));
            }

            sineCosine(cycles, s[axis], c[axis]);
            sum[axis].setZero();
        }

        for (int i = 0; i < nWaves; ++i)
        {
            // The waves as products of complex numbers
            blockScalars re = blockScalars::Ones();
            blockScalars im = blockScalars::Zero();

            for (int axis = 0; axis < 3; ++axis)
            {
                const int n = directions[i][axis];

                if (n)
                {
                    const blockScalars before = re;
                    const blockScalars sine = double(n)*s[axis];

                    re = before*c[axis] - im*sine;
                    im = before*sine + im*c[axis];
                }
            }

            for (int axis = 0; axis < 3; ++axis)
            {
                sum[axis] +=
                    re*now_.cosine[i](axis) + im*now_.sine[i](axis);
            }
        }

        for (Eigen::Index k = 0; k < end; ++k)
        {
            for (int axis = 0; axis < 3; ++axis)
            {
                u(axis, first + k) += sum[axis](k) + velocity_(axis);
            }
        }
    }
}

// ************************************************************************* //
