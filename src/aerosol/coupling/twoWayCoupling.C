/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "twoWayCoupling.H"

#include "checkedDictionary.H"
#include "communicator.H"
#include "domain.H"
#include "fvMesh.H"
#include "meanDecay.H"

#include <unordered_map>
#include <unordered_set>
#include <vector>

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
    const vectors momentum = times(p.m, drift(p));

    std::unordered_map<std::int64_t, int> here;
    for (int k = 0; k < p.size(); ++k)
    {
        here[p.id(k)] = k;
    }

    // On the gas: what they had and do not have any more
    vectors x = x_;
    vectors impulse = momentum_;

    std::vector<int> left;

    for (int i = 0; i < int(id_.size()); ++i)
    {
        const auto found = here.find(id_(i));

        if (found == here.end())
        {
            left.push_back(i);
            continue;
        }

        x.col(i) = p.x.col(found->second);
        impulse.col(i) -= momentum.col(found->second);
        here.erase(found);
    }

    // The others have been absorbed, or have migrated: each rank says which
    // have come, and what those that have left it had
    constexpr int size = 7;
    std::vector<double> mine{double(here.size())};

    for (const auto& arrived : here)
    {
        mine.push_back(double(arrived.first));
    }
    for (const int i : left)
    {
        mine.push_back(double(id_(i)));
        mine.insert(mine.end(), x_.col(i).begin(), x_.col(i).end());
        mine.insert
        (
            mine.end(), momentum_.col(i).begin(), momentum_.col(i).end()
        );
    }

    const messages all =
        communicator::exchange(messages(communicator::nRanks(), mine));

    std::unordered_map<std::int64_t, const double*> departed;
    std::unordered_set<std::int64_t> arrived;

    for (const std::vector<double>& of : all)
    {
        const std::size_t n = 1 + std::size_t(of[0]);

        for (std::size_t k = 1; k < n; ++k)
        {
            arrived.insert(std::int64_t(of[k]));
        }
        for (std::size_t k = n; k < of.size(); k += size)
        {
            departed[std::int64_t(of[k])] = &of[k + 1];
        }
    }

    for (const int i : left)
    {
        if (arrived.count(id_(i)))
        {
            impulse.col(i).setZero();
        }
    }

    const Eigen::Index n = x.cols();
    x.conservativeResize(Eigen::NoChange, n + here.size());
    impulse.conservativeResize(Eigen::NoChange, n + here.size());

    Eigen::Index column = n;
    for (const auto& one : here)
    {
        const double* const before = departed.at(one.first);

        x.col(column) = p.x.col(one.second);
        impulse.col(column) =
            Eigen::Vector3d(before[3], before[4], before[5])
          - momentum.col(one.second);
        ++column;
    }

    reaction_.add(inCells(x, impulse));
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
