/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "neighbourList.H"
#include "communicator.H"

#include <algorithm>
#include <map>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::neighbourList::neighbourList
(
    const domain& region,
    const bool shared
)
:
    ghosts_(region, shared)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::neighbourList::findTouching
(
    cellGrid& grid,
    const scalars& id,
    const vectors& x,
    const scalars& reach
)
{
    ghosts_.build(x, reach, true);

    vectors places = x;
    scalars reaches = reach;
    scalars ids = id;

    ghosts_.fill
    ({
        {places, ghosts_, true},
        {reaches, ghosts_},
        {ids, ghosts_}
    });

    ghostId_ = ids.tail(ghosts_.nGhosts());

    grid.build(places, reaches);
    grid.touching(ghosts_.n(), ids, pairs_);
}


void Foam::aerosol::neighbourList::findActing
(
    cellGrid& grid,
    const scalars& id,
    vectors x,
    const scalars& reach,
    const scalars& skin
)
{
    // Also on ranks without particles: all ranks exchange the same quantities
    const bool mutual = communicator::max(skin.size()) > 0;

    scalars reaches = mutual ? scalars(reach.max(skin)) : reach;
    scalars skins = skin;
    scalars ids = id;

    ghosts_.build(x, reaches, mutual);

    std::vector<ghosts::quantity> quantities
    {
        {x, ghosts_, true}, {reaches, ghosts_}, {ids, ghosts_}
    };
    if (mutual)
    {
        quantities.push_back({skins, ghosts_});
    }
    ghosts_.fill(quantities);

    grid.build(x, reaches);

    if (mutual)
    {
        grid.acting(ghosts_.n(), ids, skins, pairs_);
    }
    else
    {
        grid.acting(ghosts_.n(), ids, pairs_);
    }
}


void Foam::aerosol::neighbourList::set
(
    const int n,
    std::vector<particlePair> pairs
)
{
    std::map<std::pair<int, periods>, int> ghostOf;
    std::vector<std::pair<int, periods>> images;

    for (particlePair& pair : pairs)
    {
        if (pair.image != periods{0, 0, 0})
        {
            const auto added = ghostOf.insert
            ({
                {pair.j, pair.image}, static_cast<int>(images.size())
            });

            if (added.second)
            {
                images.push_back(added.first->first);
            }
            pair.j = n + added.first->second;
            pair.image = {};    // the ghost is there already
        }
    }

    pairs_ = std::move(pairs);
    ghosts_.set(n, std::move(images));
}


void Foam::aerosol::neighbourList::fillIds(const scalars& id)
{
    ghosts_.fill({{id, ghostId_, ghosts_}});
}


void Foam::aerosol::neighbourList::findActing
(
    cellGrid& grid,
    const scalars& id,
    const verletSkin& skin,
    const scalars& range,
    neighbourList& touching
)
{
    vectors x = skin.centres();
    vectors extent = skin.extents();
    scalars size = skin.sizes();
    scalars ranges = range;
    scalars ids = id;

    ghosts_.build
    (
        x, extent.colwise().norm().transpose().array() + size + range, true
    );
    ghosts_.fill
    ({
        {x, ghosts_, true}, {extent, ghosts_, false}, {size, ghosts_},
        {ranges, ghosts_}, {ids, ghosts_}
    });

    // Where boxes are long, space is squeezed, so that spheres fit them better.
    // Rounded means are those of micrometres.
    const double meanSize =
        communicator::mean
        (
            vectors::NullaryExpr
            (
                3,
                range.size(),
                [&](const Eigen::Index, const Eigen::Index i)
                {
                    return 1e6*(skin.sizes()(i) + range(i));
                }
            )
        )(0)
      + 1e-6;
    const Eigen::Array3d squeeze =
        meanSize/(meanSize + communicator::mean(1e6*skin.extents()).array());

    // About all places of a box, the sphere is the furthest from its centre
    scalars reaches =
        (extent.array().colwise()*squeeze).matrix().colwise().norm()
       .transpose().array()
      + squeeze.maxCoeff()*(size + ranges);

    vectors squeezed = (x.array().colwise()*squeeze).matrix();

    grid.build(squeezed, reaches);

    const int n = ghosts_.n();

    pairs_.clear();
    touching.pairs_.clear();

    // Of each pair, one or both may act on the other. Most do not: only those
    // that do are kept.
    const auto add = [&](const int i, const int j)
    {
        const double gap =
            verletSkin::beyond
            (
                x.col(j) - x.col(i), extent.col(i) + extent.col(j)
            )
          - size(i) - size(j);

        if (i < n && ranges(j) > 0 && gap <= ranges(j))
        {
            pairs_.push_back({i, j, {}});
        }
        if (j < n && ranges(i) > 0 && gap <= ranges(i))
        {
            pairs_.push_back({j, i, {}});
        }
        if (i < n && gap <= 0)
        {
            touching.pairs_.push_back({i, j, {}});
        }
    };

    grid.touching(n, ids, true, add);

    touching.ghosts_ = ghosts_;
}


void Foam::aerosol::neighbourList::keepNeededGhosts()
{
    const int n = ghosts_.n();
    std::vector<char> needed(ghosts_.nGhosts(), 0);

    for (const particlePair& pair : pairs_)
    {
        if (pair.j >= n)
        {
            needed[pair.j - n] = 1;
        }
    }

    const std::vector<int> places = ghosts_.keep(needed);

    for (particlePair& pair : pairs_)
    {
        if (pair.j >= n)
        {
            pair.j = n + places[pair.j - n];
        }
    }
}


void Foam::aerosol::neighbourList::keep
(
    std::vector<particlePair> pairs,
    const std::vector<int>& places,
    const int left
)
{
    const int n = ghosts_.n();

    pairs_ = std::move(pairs);
    keepNeededGhosts();
    ghosts_.renumber(places, left);

    for (particlePair& pair : pairs_)
    {
        pair.i = places[pair.i];
        pair.j = pair.j < n ? places[pair.j] : left + pair.j - n;
    }
}


void Foam::aerosol::neighbourList::remove
(
    const std::vector<char>& marked,
    const std::vector<int>& places,
    const int left
)
{
    const int n = ghosts_.n();

    const scalars gone =
        Eigen::Map<const Eigen::Array<char, Eigen::Dynamic, 1>>
        (
            marked.data(), n
        ).cast<double>();

    scalars ghostsGone;
    ghosts_.fill({{gone, ghostsGone, ghosts_}});

    const auto lost = [&](const particlePair& pair)
    {
        return
            marked[pair.i]
         || (pair.j < n ? marked[pair.j] : ghostsGone(pair.j - n));
    };

    pairs_.erase
    (
        std::remove_if(pairs_.begin(), pairs_.end(), lost), pairs_.end()
    );

    keep(std::move(pairs_), places, left);
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

std::vector<Foam::aerosol::particlePair>
Foam::aerosol::neighbourList::touching
(
    const domain& region,
    const vectors& x,
    const scalars& reach
)
{
    const int n = static_cast<int>(reach.size());

    neighbourList list(region, true);
    cellGrid grid;

    list.findTouching(grid, scalars::LinSpaced(n, 0, n - 1), x, reach);

    for (particlePair& pair : list.pairs_)
    {
        pair.image = list.ghosts_.image(pair.j);

        if (pair.j >= n)
        {
            pair.j = static_cast<int>(list.ghostId_(pair.j - n));
        }
    }

    return list.pairs_;
}


// ************************************************************************* //
