/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "harmonicFlow.H"

#include "phasor.H"
#include "checkedEntry.H"
#include "localIOdictionary.H"
#include "mathematicalConstants.H"
#include "polyMesh.H"
#include "Time.H"

#include <cmath>
#include <sstream>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<Foam::scalar> Foam::acoustics::harmonicFlow::factors
(
    const scalar t
) const
{
    const scalar periods = t*frequency_;
    const scalar angle =
        constant::mathematical::twoPi*(periods - std::floor(periods));

    std::vector<scalar> result({1});
    for (label k = 1; k <= nHarmonics(); ++k)
    {
        result.push_back(std::cos(k*angle));
        result.push_back(std::sin(k*angle));
    }
    return result;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::acoustics::harmonicFlow::harmonicFlow
(
    const polyMesh& mesh,
    const scalar frequency,
    const terms& t
)
:
    mesh_(mesh),
    frequency_(frequency),
    terms_(t)
{}


// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const char* const Foam::acoustics::harmonicFlow::origin =
    "Such fields are written by the sound untilPeriodic, and by the function"
    " object soundPressureLevel with coefficients yes";


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

Foam::word Foam::acoustics::harmonicFlow::name(const label term)
{
    if (term == 0)
    {
        return "UMean";
    }

    return (term % 2 ? "UCos" : "USin") + std::to_string((term + 1)/2);
}


Foam::acoustics::harmonicFlow::terms
Foam::acoustics::harmonicFlow::significant
(
    const harmonicSum<vector>& sum,
    const scalar tolerance
)
{
    label n = 1;
    scalar fundamental = 0;

    for (label k = 1; k <= sum.nHarmonics(); ++k)
    {
        scalar largest = 0;
        forAll(sum.cosine(k), celli)
        {
            largest =
                max(largest, peak(sum.cosine(k)[celli], sum.sine(k)[celli]));
        }
        reduce(largest, maxOp<scalar>());

        if (k == 1)
        {
            fundamental = largest;
        }
        if (largest > tolerance*fundamental)
        {
            n = k;
        }
    }

    return first(sum, n);
}


Foam::acoustics::harmonicFlow::terms
Foam::acoustics::harmonicFlow::first
(
    const harmonicSum<vector>& sum,
    const label n
)
{
    terms result(2*n + 1);
    result[0] = sum.mean();
    for (label k = 1; k <= n; ++k)
    {
        result[2*k - 1] = sum.cosine(k);
        result[2*k] = sum.sine(k);
    }
    return result;
}


Foam::acoustics::harmonicFlow::terms
Foam::acoustics::harmonicFlow::read
(
    const polyMesh& mesh,
    const word& time,
    const label nHarmonics
)
{
    DynamicList<vectorField> result;

    // The mean and at least one harmonic must be there
    const label least = max(2*nHarmonics + 1, 3);

    while (nHarmonics < 0 || result.size() < least)
    {
        IOobject io
        (
            name(result.size()),
            time,
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        );

        const label without = returnReduce
        (
            !io.typeHeaderOk<localIOdictionary>(false, true, false),
            sumOp<label>()
        );

        if (without)
        {
            if (result.size() < least)
            {
                FatalErrorInFunction
                    << "There is no field " << io.objectPath()
                    << ", or no whole one, to be replayed"
                    << (without < Pstream::nProcs() ? ", on some ranks" : "")
                    << nl << origin << exit(FatalError);
            }
            break;
        }

        // Of the file only the values in the cells: no boundary conditions
        const localIOdictionary dict(io, "volVectorField");
        const vectorField values("internalField", dict, mesh.nCells());

        forAll(values, celli)
        {
            if (!std::isfinite(magSqr(values[celli])))
            {
                FatalIOErrorInFunction(dict)
                    << "The field " << io.objectPath() << " that is to be"
                    << " replayed has the value " << values[celli]
                    << " in the cell " << celli << exit(FatalIOError);
            }
        }

        result.append(values);
    }

    // A sine without its cosine, or the other way round, is not read
    result.setSize(2*((result.size() - 1)/2) + 1);

    return terms(result);
}


Foam::dictionary Foam::acoustics::harmonicFlow::magnitudes
(
    const polyMesh& mesh,
    const terms& t
)
{
    const scalarField& V = mesh.cellVolumes();
    const scalar volume = gSum(V);

    dictionary result;

    forAll(t, i)
    {
        result.add(name(i), std::sqrt(gSum(V*magSqr(t[i]))/volume));
    }

    return result;
}


void Foam::acoustics::harmonicFlow::requireSame
(
    const polyMesh& mesh,
    const terms& t,
    const dictionary& magnitudes
)
{
    if (magnitudes.empty())
    {
        return;
    }

    const dictionary now = harmonicFlow::magnitudes(mesh, t);

    // What ascii files with six digits leave
    scalar rounding = 0;
    for (const entry& e : now)
    {
        rounding = max(rounding, 1e-5*now.get<scalar>(e.keyword()));
    }

    for (const entry& e : now)
    {
        const scalar is = now.get<scalar>(e.keyword());
        const scalar was = readFinite(magnitudes, e.keyword(), dimVelocity);

        if (mag(is - was) > 1e-4*was + rounding)
        {
            FatalIOErrorInFunction(magnitudes)
                << "The field " << e.keyword() << " that is to be replayed is"
                << " not the one that was written with it: its rms is " << is
                << " m/s, but by " << magnitudes.name() << " it was " << was
                << " m/s. Another program or function object has written it, or"
                << " the files are of different runs" << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::acoustics::harmonicFlow::largestAmplitude() const
{
    scalar largest = 0;

    forAll(terms_[0], celli)
    {
        scalar speed = 0;
        for (label k = 1; k <= nHarmonics(); ++k)
        {
            speed += peak(terms_[2*k - 1][celli], terms_[2*k][celli]);
        }
        largest = max(largest, speed);
    }
    reduce(largest, maxOp<scalar>());

    return largest;
}


Foam::scalar Foam::acoustics::harmonicFlow::largestMean() const
{
    return std::sqrt(gMax(magSqr(terms_[0])()));
}


Foam::vectorField Foam::acoustics::harmonicFlow::inCells(const scalar t) const
{
    const std::vector<scalar> factor = factors(t);

    vectorField result(terms_[0]);
    for (label i = 1; i < terms_.size(); ++i)
    {
        result += factor[i]*terms_[i];
    }
    return result;
}


Foam::label Foam::acoustics::harmonicFlow::prepare(const boundBox& box)
{
    regions_.emplace_back();
    region& r = regions_.back();

    r.sampler.reset(new regionSampler(mesh_, box));
    r.oldest = 0;

    r.terms.resize(terms_.size());
    forAll(terms_, i)
    {
        r.sampler->sample(terms_[i], r.terms[i]);
    }

    for (region::moment& m : r.moments)
    {
        m.t = VGREAT;
    }

    return regions_.size() - 1;
}


Eigen::Vector3d
Foam::acoustics::harmonicFlow::meanInMiddle(const label number) const
{
    const region& r = regions_[number];
    const velocityLattice& lattice = r.sampler->lattice();
    const Eigen::Matrix3Xd nodes = lattice.nodes();

    Eigen::Matrix3Xd middle;
    lattice.interpolate
    (
        r.terms[0],
        0.5*(nodes.leftCols<1>() + nodes.rightCols<1>()),
        middle
    );

    return middle.col(0);
}


Foam::scalar Foam::acoustics::harmonicFlow::flattenMean(const label number)
{
    region& r = regions_[number];
    velocityLattice::values& mean = r.terms[0];

    const velocityLattice& lattice = r.sampler->lattice();
    const Eigen::Matrix3Xd nodes = lattice.nodes();

    const Eigen::Vector3d low = nodes.col(0);
    const Eigen::Vector3d high = nodes.col(nodes.cols() - 1);
    const scalar gradient = r.sampler->rmsGradient(mean);
    const scalar largest = std::sqrt(mean.square().colwise().sum().maxCoeff());

    const Eigen::Vector3d middle = meanInMiddle(number);

    mean.topRows<3>().colwise() = middle.array();

    for (region::moment& m : r.moments)
    {
        m.t = VGREAT;
    }

    const Eigen::IOFormat components
    (
        Eigen::StreamPrecision, Eigen::DontAlignCols, " ", "", "", "", "(", ")"
    );

    std::ostringstream os;
    os  << "    mean flow from " << low.transpose().format(components)
        << " to " << high.transpose().format(components) << " m: up to "
        << largest << " m/s, rms gradient " << gradient
        << " 1/s;\n    there, from here on the same everywhere: "
        << middle.transpose().format(components) << " m/s";

    Info<< os.str().c_str() << endl;

    return
        gradient*lattice.spacing().minCoeff() > 1e-12*largest ? gradient : 0;
}


const Foam::acoustics::velocityLattice::values&
Foam::acoustics::harmonicFlow::atNodes
(
    const label number,
    const scalar t
) const
{
    const region& r = regions_[number];

    for (const region::moment& m : r.moments)
    {
        if (m.t == t)
        {
            return m.u;
        }
    }

    region::moment& m = r.moments[r.oldest];
    r.oldest = (r.oldest + 1) % r.moments.size();

    const std::vector<scalar> factor = factors(t);

    m.t = t;
    m.u = r.terms[0];
    for (size_t i = 1; i < r.terms.size(); ++i)
    {
        m.u += factor[i]*r.terms[i];
    }
    return m.u;
}


Eigen::Matrix3Xcd Foam::acoustics::harmonicFlow::harmonics
(
    const label number,
    const Eigen::Vector3d& x
) const
{
    const region& r = regions_[number];
    const Eigen::Matrix3Xd point(x);

    Eigen::Matrix3Xcd u(3, nHarmonics());
    Eigen::Matrix3Xd term;

    for (label k = 1; k <= nHarmonics(); ++k)
    {
        // a cos + b sin = Re((a - ib) exp)
        sampler(number).lattice().interpolate(r.terms[2*k - 1], point, term);
        u.col(k - 1).real() = term;
        sampler(number).lattice().interpolate(r.terms[2*k], point, term);
        u.col(k - 1).imag() = -term;
    }

    return u;
}


void Foam::acoustics::harmonicFlow::velocity
(
    const label region,
    const scalar t,
    const Eigen::Matrix3Xd& x,
    Eigen::Matrix3Xd& u
) const
{
    if (region >= label(regions_.size()))
    {
        FatalErrorInFunction
            << "The gas velocity is asked for before a region was announced"
            << exit(FatalError);
    }

    sampler(region).lattice().interpolate(atNodes(region, t), x, u);
}


// ************************************************************************* //
