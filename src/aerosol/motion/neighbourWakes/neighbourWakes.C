/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neighbourWakes.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::neighbourWakes::neighbourWakes
(
    const domain& region,
    const equationOfMotion& motion,
    stepCounters& counters
)
:
    domain_(region),
    motion_(motion),
    counters_(counters),
    list_(region),
    withMiddle_(false)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::neighbourWakes::at
(
    const vectors& x,
    const vectors& v,
    const vectors& u,
    const vectors& imaginary,
    vectors& keptX,
    vectors& keptSlip,
    vectors& w
)
{
    const ghosts& layer = list_.layer();

    keptX = x;
    keptSlip = u - v;
    sources_.x.leftCols(x.cols()) = keptX;
    sources_.slip.leftCols(x.cols()) = keptSlip;

    std::vector<ghosts::quantity> quantities
    {
        {sources_.x, layer, true},
        {sources_.slip, layer, false}
    };

    // Also on ranks without wakes: all ranks exchange the same quantities
    if (motion_.wakes().asksForPhase())
    {
        sources_.imaginary.resize(3, sources_.x.cols());
        sources_.imaginary.leftCols(x.cols()) = imaginary;
        quantities.push_back({sources_.imaginary, layer, false});
    }

    layer.fill(quantities);

    motion_.wakes().sum(sources_, list_.pairs(), x.cols(), w);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::neighbourWakes::search
(
    cellGrid& grid,
    const particleArrays& p,
    const vectors& x,
    const scalars& reach,
    const scalars& skin
)
{
    // The last list may have been one of particles that are not shared out
    list_ = neighbourList(domain_);

    if (motion_.wakes().active())
    {
        list_.findActing(grid, p.id.cast<double>(), x, reach, skin);
    }
}


void Foam::aerosol::neighbourWakes::involve(const particleArrays& p)
{
    involved_.clear();

    if (!motion_.wakes().active())
    {
        return;
    }

    ghosts& layer = list_.layer();
    std::vector<particlePair>& pairs = list_.pairs();

    counters_.wakePairs += pairs.size();

    const int n = p.size();

    // Only those ghosts that act on a particle
    std::vector<char> felt(layer.nGhosts(), 0);

    for (const particlePair& pair : pairs)
    {
        if (pair.j >= n)
        {
            felt[pair.j - n] = 1;
        }
    }

    const std::vector<int> kept = layer.keep(felt);

    std::vector<char> marks = layer.sent();

    for (const particlePair& pair : pairs)
    {
        marks[pair.i] = 1;

        if (pair.j < n)
        {
            marks[pair.j] = 1;
        }
    }

    place_.assign(n, -1);

    for (int i = 0; i < n; ++i)
    {
        if (marks[i])
        {
            place_[i] = static_cast<int>(involved_.size());
            involved_.push_back(i);
        }
    }

    // From now on by their places
    const int nInvolved = static_cast<int>(involved_.size());

    for (particlePair& pair : pairs)
    {
        pair.i = place_[pair.i];
        pair.j =
            pair.j < n ? place_[pair.j] : nInvolved + kept[pair.j - n];
    }

    layer.renumber(place_, nInvolved);

    sources_.x.resize(3, layer.size());
    sources_.slip.resize(3, layer.size());

    sources_.d = p.mobilityDiameter(involved_);
    sources_.range = p.range(involved_);

    std::vector<ghosts::quantity> quantities
    {
        {sources_.d, layer}, {sources_.range, layer}
    };

    if (motion_.wakes().asksForPhase())
    {
        const vectors all = motion_.wakes().settling(p);
        sources_.steady.resize(3, layer.size());
        sources_.steady.leftCols(nInvolved) = all(Eigen::all, involved_);
        quantities.push_back({sources_.steady, layer, false});
    }

    layer.fill(quantities);
}


Foam::aerosol::vectors Foam::aerosol::neighbourWakes::now
(
    const particleArrays& p,
    const stepGas& gas,
    const scalar h
)
{
    const stepValues air = gas.some(involved_);

    vectors kept, slip, found;
    at
    (
        p.x(Eigen::all, involved_),
        motion_.noise().drift
        (
            p.v(Eigen::all, involved_), p.thermal(Eigen::all, involved_)
        ),
        air.u0,
        motion_.wakes().imaginarySlip(p.rate(involved_), air, 0, h),
        kept, slip, found
    );

    vectors w = vectors::Zero(3, p.size());
    w(Eigen::all, involved_) = found;

    return w;
}


void Foam::aerosol::neighbourWakes::move
(
    const scalar h,
    const particleArrays& p,
    const stepGas& gas,
    const bool withMiddle,
    stepEnd& end
)
{
    if (!motion_.wakes().active())
    {
        motion_.noise().split(h, p, end);
        return;
    }

    withMiddle_ = withMiddle;

    // The involved particles, by themselves
    const auto select = [&](const vectors& all)
    {
        return
            all.cols() ? vectors(all(Eigen::all, involved_))
          : vectors(3, 0);
    };

    const particleArrays q = p.select(involved_);
    const stepValues air = gas.some(involved_);

    stepEnd there;
    there.increment = {select(end.increment.v), select(end.increment.x)};

    // The thermal velocity at the end is that of drag and noise alone
    motion_.noise().cool(h, q, there);

    const auto wakesOf =
    [&]
    (
        const scalar s,
        const vectors& x,
        const vectors& v,
        const vectors& u,
        vectors& result
    )
    {
        const auto part = [&](stepValues& all) -> vectors&
        {
            return s == 0 ? all.u0 : s == 1 ? all.u1 : all.um;
        };

        at
        (
            x, v, u, motion_.wakes().imaginarySlip(q.rate, air, s, h),
            part(x_), part(slip_), result
        );
    };

    x_.um.resize(3, 0);
    slip_.um.resize(3, 0);

    motion_.inWakes().move
    (
        h, q, air, wakesOf,
        withMiddle ? wakeStep::nIterations : wakeStep::linear,
        values_, there
    );

    for (std::size_t k = 0; k < involved_.size(); ++k)
    {
        end.x.col(involved_[k]) = there.x.col(k);
        end.v.col(involved_[k]) = there.v.col(k);
    }

    motion_.noise().split(h, p, end);
}


// ************************************************************************* //
