/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoWayCoupling.H"

#include "checkedDictionary.H"
#include "domain.H"
#include "fvMesh.H"
#include "meanDecay.H"

#include <unordered_map>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Eigen::Array<bool, 3, 1> readWhole(const Foam::dictionary& dict)
{
    using namespace Foam;

    requireOnly(dict, {"type", "represents"});

    const vector given = getVector(dict, "represents", dimless);
    Eigen::Array<bool, 3, 1> whole;

    for (direction k = 0; k < vector::nComponents; ++k)
    {
        if (given[k] != 0 && given[k] != 1)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'represents' of " << dict.name() << " is " << given
                << ", but of each direction it must say 1, the box stands for"
                << " the whole mesh, or 0, for its own extent"
                << exit(FatalIOError);
        }

        whole(k) = given[k] == 1;
    }

    return whole;
}


Foam::aerosol::vectors drift(const Foam::aerosol::particleArrays& p)
{
    return p.v - p.thermal;
}


Foam::aerosol::vectors times
(
    const Foam::aerosol::scalars& m,
    const Foam::aerosol::vectors& v
)
{
    return v.array().rowwise()*m.transpose();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Eigen::MatrixXd Foam::aerosol::twoWayCoupling::inCells
(
    const vectors& x,
    const Eigen::MatrixXd& amounts
) const
{
    Eigen::MatrixXd densities =
        Eigen::MatrixXd::Zero(amounts.rows(), nCells_);

    cells_.add(x, amounts, densities);

    return densities;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::twoWayCoupling::twoWayCoupling
(
    const dictionary& dict,
    const fvMesh& mesh,
    const domain& region,
    gasReaction& reaction
)
:
    nCells_(mesh.nCells()),
    cells_(mesh, region.bounds(), readWhole(dict)),
    reaction_(reaction)
{}


bool Foam::aerosol::twoWayCoupling::wanted(const dictionary& dict)
{
    if (dict.empty())
    {
        return false;
    }

    requireValue(dict, "type");
    const word type = dict.get<word>("type");

    if (type != "none" && type != "twoWay")
    {
        FatalIOErrorInFunction(dict)
            << "Unknown coupling type " << type << "; valid ones are none and"
            << " twoWay"
            << exit(FatalIOError);
    }

    if (type == "none")
    {
        // To switch it off for a comparison, the type is enough
        requireOnly(dict, {"type", "represents"});
    }

    return type == "twoWay";
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::twoWayCoupling::before
(
    const particleArrays& p,
    const scalar h
)
{
    id_ = p.id;
    x_ = p.x;
    momentum_ = times(p.m, drift(p) + h*p.acceleration);
}


void Foam::aerosol::twoWayCoupling::after(const particleArrays& p)
{
    // On the gas: what they had and do not have any more
    const vectors now = times(p.m, drift(p));

    vectors x = x_;
    vectors impulse = momentum_;

    std::unordered_map<std::int64_t, int> places;
    for (int k = 0; k < p.size(); ++k)
    {
        places[p.id(k)] = k;
    }

    for (int i = 0; i < int(id_.size()); ++i)
    {
        const auto found = places.find(id_(i));

        if (found != places.end())
        {
            x.col(i) = p.x.col(found->second);
            impulse.col(i) -= now.col(found->second);
        }
    }

    reaction_.migrate(inCells(x, impulse));
}


void Foam::aerosol::twoWayCoupling::announce
(
    const particleArrays& p,
    const equationOfMotion& motion,
    const vectors& u,
    const scalar h
)
{
    // The drift is what counts
    if (motion.noise().active() && !p.thermal.isZero(0))
    {
        particleArrays smooth(p);
        smooth.v = drift(p);
        smooth.thermal.setZero();

        announce(smooth, motion, u, h);
        return;
    }

    stepValues gas;
    gas.u0 = u;
    gas.u1 = u;

    stepEnd end;
    motion.exact().move(h, p, gas, {}, false, end);

    Eigen::MatrixXd amounts(4, p.size());

    amounts.topRows(3) = times(p.m, p.v + h*p.acceleration - end.v);

    for (int i = 0; i < p.size(); ++i)
    {
        const double z = std::max(p.rate(i)*h, 1e-9);

        amounts(3, i) = p.m(i)*(1 - meanDecay(z));
    }

    reaction_.announce(inCells(p.x, amounts));
}


// ************************************************************************* //
