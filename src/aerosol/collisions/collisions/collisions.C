/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "collisions.H"
#include "communicator.H"
#include "DynamicList.H"
#include "packedRecord.H"

#include <Eigen/Geometry>

#include <cmath>
#include <tuple>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::collisions::collisions
(
    const dictionary& dict,
    const aggregate& merging
)
:
    outcome_(contactOutcome::New(dict.subDict("contact"))),
    aggregate_(merging),
    breakage_(nullptr),
    before_(0),
    count_(0),
    nAbsorbed_(0),
    keepsRecords_(false)
{
    // A pair that should stick, but does not merge, would stay in contact
    if (outcome_->bounces() && !aggregate_.merges())
    {
        FatalIOErrorInFunction(dict.subDict("contact"))
            << "The contact outcome '" << outcome_->type()
            << "' lets particles bounce or stick, but the 'aggregate' is none."
            << " Choose an aggregate for those that stick"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::collisions::setImpact
(
    const std::int64_t id,
    const breakage::impact& hit
)
{
    if (hit.energy > 0)
    {
        impacts_[id] = hit;
    }
    else
    {
        impacts_.erase(id);
    }
}


void Foam::aerosol::collisions::remember
(
    const std::int64_t survivor,
    const std::int64_t absorbed,
    const breakage::impact& hit
)
{
    breakage::impact hardest = hit;

    for (const std::int64_t id : {survivor, absorbed})
    {
        const auto before = impacts_.find(id);

        if
        (
            before != impacts_.end()
         && before->second.energy > hardest.energy
        )
        {
            hardest = before->second;
        }
    }

    if (hardest.energy <= 0)
    {
        return;
    }

    setImpact(survivor, hardest);
    setImpact(absorbed, breakage::impact());

    recordWriter(newImpacts_)
        << double(survivor) << hardest.energy << hardest.mass
        << hardest.direction;
    recordWriter(newImpacts_)
        << double(absorbed) << 0.0 << 0.0 << Eigen::Vector3d(0, 0, 0);
}


void Foam::aerosol::collisions::keep
(
    const particleArrays& p,
    const contactOutcome::encounter& pair,
    const bool merged,
    const bool bounced
)
{
    if (!keepsRecords_)
    {
        return;
    }

    const Eigen::Vector3d r = pair.xj - pair.xi;
    const Eigen::Vector3d v = pair.vi - pair.vj;

    // By atan2, which is exact where contacts are head-on, and 0 at rest
    records_.push_back
    ({
        pair.time,
        p.id(pair.i),
        p.id(pair.j),
        p.d(pair.i),
        p.d(pair.j),
        v.norm(),
        std::atan2(r.cross(v).norm(), r.dot(v)),
        merged,
        bounced,
        pair.number
    });
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::aerosol::collisions::meet
(
    particleArrays& p,
    contactOutcome::encounter pair
)
{
    ++count_;

    const bool merges = aggregate_.merges() && outcome_->sticks(p, pair);

    if (!merges && outcome_->bounces())
    {
        const Eigen::Vector3d n = (pair.xj - pair.xi).normalized();
        const double mi = p.m(pair.i);
        const double mj = p.m(pair.j);
        const Eigen::Vector3d impulse =
            (1 + outcome_->restitution(p, pair))
           *mi*mj/(mi + mj)*pair.approach()*n;

        p.v.col(pair.i) = pair.vi - impulse/mi;
        p.v.col(pair.j) = pair.vj + impulse/mj;
        keep(p, pair, false, true);

        return bounced;
    }

    if (!merges)
    {
        refused_.insert(std::minmax(p.id(pair.i), p.id(pair.j)));
        newlyRefused_.push_back(p.id(pair.i));
        newlyRefused_.push_back(p.id(pair.j));
        keep(p, pair, false);
        return passed;
    }

    // The heavier one lives on, at its own place rather than its image's
    const bool jIsHeavier =
        p.m(pair.j) > p.m(pair.i)
     || (p.m(pair.j) == p.m(pair.i) && p.id(pair.j) < p.id(pair.i));

    if (jIsHeavier)
    {
        std::swap(pair.i, pair.j);
        std::swap(pair.xi, pair.xj);
        std::swap(pair.vi, pair.vj);

        pair.xi -= pair.shift;
        pair.xj -= pair.shift;
        pair.shift = -pair.shift;
    }

    if (breakage_)
    {
        remember(p.id(pair.i), p.id(pair.j), breakage_->hit(p, pair));
    }

    keep(p, pair, true);
    p.mergeHistory(pair.i, pair.j);
    aggregate_.merge(p, pair);

    absorbed_.resize(p.size(), 0);
    absorbed_[pair.j] = 1;
    ++nAbsorbed_;

    return pair.i;
}


std::int64_t Foam::aerosol::collisions::count() const
{
    return before_ + static_cast<std::int64_t>(communicator::sum(count_));
}


void Foam::aerosol::collisions::save(dictionary& state) const
{
    DynamicList<label> refused;

    for (const auto& pair : refused_)
    {
        refused.append(pair.first);
        refused.append(pair.second);
    }

    state.add("contacts", label(count()));
    state.add("refusedPairs", labelList(refused));
}


void Foam::aerosol::collisions::load(const dictionary& state)
{
    const labelList refused
    (
        state.getOrDefault<labelList>("refusedPairs", labelList())
    );

    setCount(state.get<label>("contacts"));

    for (label k = 0; k + 1 < refused.size(); k += 2)
    {
        refused_.insert
        (
            std::minmax<std::int64_t>(refused[k], refused[k + 1])
        );
    }
}


std::vector<Foam::aerosol::collisions::record>
Foam::aerosol::collisions::takeRecords()
{
    if (!keepsRecords_)
    {
        return {};
    }

    constexpr int length = 10;

    std::vector<double> mine;

    for (const record& r : records_)
    {
        recordWriter(mine)
            << r.time << double(r.id1) << double(r.id2) << r.d1 << r.d2
            << r.speed << r.angle << double(r.merged) << double(r.bounced)
            << double(r.number);
    }
    records_.clear();

    std::vector<record> taken;
    const messages all = exchangeWithAll(mine);

    for (const auto& one : records(all, length))
    {
        const double* const part = one.first;

        taken.push_back
        ({
            part[0], std::int64_t(part[1]), std::int64_t(part[2]), part[3],
            part[4], part[5], part[6], part[7] > 0, part[8] > 0,
            std::uint64_t(part[9])
        });
    }

    std::sort
    (
        taken.begin(),
        taken.end(),
        [](const record& a, const record& b)
        {
            return
                std::tie(a.time, a.number, a.id1, a.id2)
              < std::tie(b.time, b.number, b.id1, b.id2);
        }
    );

    return taken;
}


std::map<std::int64_t, Foam::aerosol::breakage::impact>
Foam::aerosol::collisions::takeImpacts()
{
    std::map<std::int64_t, breakage::impact> taken;
    taken.swap(impacts_);

    return taken;
}


void Foam::aerosol::collisions::share()
{
    if
    (
        communicator::worksAlone()
     || communicator::max(newlyRefused_.size() + newImpacts_.size()) == 0
    )
    {
        return;
    }

    const messages refused = exchangeWithAll(newlyRefused_);
    const messages impacts = exchangeWithAll(newImpacts_);
    newlyRefused_.clear();
    newImpacts_.clear();

    for (const auto& one : records(refused, 2))
    {
        refused_.insert
        (
            std::minmax(std::int64_t(one.first[0]), std::int64_t(one.first[1]))
        );
    }

    // No particle was in more than one cluster since the last time
    for (const auto& one : records(impacts, 6))
    {
        recordReader record(one.first);
        const std::int64_t id = std::int64_t(record.number());

        breakage::impact hit;
        hit.energy = record.number();
        hit.mass = record.number();
        hit.direction = record.vector();

        setImpact(id, hit);
    }
}


std::vector<char> Foam::aerosol::collisions::takeAbsorbed(const int n)
{
    std::vector<char> marks;
    marks.swap(absorbed_);
    marks.resize(n, 0);
    nAbsorbed_ = 0;

    return marks;
}


// ************************************************************************* //
