/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ghosts.H"
#include "domain.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::ghosts::ghosts(const domain& region, const bool shared)
:
    decomposition_(region, shared ? 1 : communicator::nRanks()),
    period_(region.period()),
    n_(0),
    sent_(decomposition_.n()),
    received_(decomposition_.n(), 0)
{}


Foam::aerosol::ghosts::quantity::quantity
(
    vectors& values,
    const ghosts& where,
    const bool isPosition
)
:
    rows_(3),
    isPosition_(isPosition)
{
    values.conservativeResize(3, where.size());
    own_ = values.data();
    ghosts_ = values.data() + 3*where.n();
}


Foam::aerosol::ghosts::quantity::quantity(scalars& values, const ghosts& where)
:
    rows_(1),
    isPosition_(false)
{
    values.conservativeResize(where.size());
    own_ = values.data();
    ghosts_ = values.data() + where.n();
}


Foam::aerosol::ghosts::quantity::quantity
(
    const vectors& own,
    vectors& inGhosts,
    const ghosts& where,
    const bool isPosition
)
:
    rows_(3),
    isPosition_(isPosition)
{
    inGhosts.resize(3, where.nGhosts());
    own_ = own.data();
    ghosts_ = inGhosts.data();
}


Foam::aerosol::ghosts::quantity::quantity
(
    const scalars& own,
    scalars& inGhosts,
    const ghosts& where
)
:
    rows_(1),
    isPosition_(false)
{
    inGhosts.resize(where.nGhosts());
    own_ = own.data();
    ghosts_ = inGhosts.data();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::ghosts::build
(
    const vectors& x,
    const scalars& reach,
    const bool mutual
)
{
    const int here = decomposition_.own();

    n_ = static_cast<int>(reach.size());

    const Eigen::Array3d ownLower = decomposition_.lower(here);
    const Eigen::Array3d ownUpper = decomposition_.upper(here);

    // How far any particle reaches out of its subdomain: so far others must be
    // copied to it
    double furthest = 0;

    for (int i = 0; i < n_; ++i)
    {
        double out = mutual ? reach(i) : 0;

        for (int k = 0; k < 3; ++k)
        {
            const double below = ownLower(k) - x(k, i);
            const double above = x(k, i) - ownUpper(k);
            out += std::max(0.0, std::max(below, above));
        }

        furthest = std::max(furthest, out);
    }

    const double common = communicator::max(furthest);

    for (auto& list : sent_)
    {
        list.clear();
    }

    std::vector<Eigen::Array3d> lower;
    std::vector<Eigen::Array3d> upper;

    for (int rank = 0; rank < decomposition_.n(); ++rank)
    {
        // A little more, lest rounding leaves out a particle on a face
        const Eigen::Array3d extra = common + 1e-12*period_;

        lower.push_back(decomposition_.lower(rank) - extra);
        upper.push_back(decomposition_.upper(rank) + extra);
    }

    // Particles away from the faces of the subdomain have no ghosts
    const Eigen::Array3d innerLower = ownLower + common;
    const Eigen::Array3d innerUpper = ownUpper - common;

    for (int i = 0; i < n_; ++i)
    {
        const double r = reach(i);
        int inside = 1;

        for (int k = 0; k < 3; ++k)
        {
            inside &= x(k, i) - r > innerLower(k);
            inside &= x(k, i) + r < innerUpper(k);
        }

        if (inside)
        {
            continue;
        }

        const Eigen::Array3d xi = x.col(i).array();

        for (int rank = 0; rank < decomposition_.n(); ++rank)
        {
            std::array<int, 3> first;
            std::array<int, 3> last;

            for (int k = 0; k < 3; ++k)
            {
                if (period_(k) > 0)
                {
                    first[k] = static_cast<int>
                    (
                        std::ceil((lower[rank](k) - r - xi(k))/period_(k))
                    );
                    last[k] = static_cast<int>
                    (
                        std::floor((upper[rank](k) + r - xi(k))/period_(k))
                    );
                }
                else
                {
                    first[k] = 0;
                    last[k] =
                        xi(k) + r >= lower[rank](k)
                     && xi(k) - r <= upper[rank](k)
                      ? 0 : -1;
                }
            }

            for (int a = first[0]; a <= last[0]; ++a)
            {
                for (int b = first[1]; b <= last[1]; ++b)
                {
                    for (int c = first[2]; c <= last[2]; ++c)
                    {
                        if (rank != here || a || b || c)
                        {
                            sent_[rank].push_back
                            ({
                                i,
                                {
                                    static_cast<std::int8_t>(a),
                                    static_cast<std::int8_t>(b),
                                    static_cast<std::int8_t>(c)
                                }
                            });
                        }
                    }
                }
            }
        }
    }

    // The images tell each rank how many ghosts it gets
    messages send(decomposition_.n());

    for (int rank = 0; rank < decomposition_.n(); ++rank)
    {
        for (const auto& one : sent_[rank])
        {
            for (int k = 0; k < 3; ++k)
            {
                send[rank].push_back(one.second[k]);
            }
        }
    }

    const messages from = communicator::exchange(std::move(send));

    image_.clear();

    for (int rank = 0; rank < decomposition_.n(); ++rank)
    {
        received_[rank] = from[rank].size()/3;

        for (std::size_t m = 0; m < from[rank].size(); m += 3)
        {
            image_.push_back
            ({
                static_cast<std::int8_t>(from[rank][m]),
                static_cast<std::int8_t>(from[rank][m + 1]),
                static_cast<std::int8_t>(from[rank][m + 2])
            });
        }
    }
}


void Foam::aerosol::ghosts::set
(
    const int n,
    std::vector<std::pair<int, periods>> images
)
{
    n_ = n;
    image_.clear();

    for (const auto& one : images)
    {
        image_.push_back(one.second);
    }

    received_[0] = static_cast<int>(images.size());
    sent_[0] = std::move(images);
}


std::vector<int> Foam::aerosol::ghosts::originals() const
{
    std::vector<int> all;
    all.reserve(nGhosts());

    for (int rank = 0; rank < decomposition_.n(); ++rank)
    {
        if (rank != decomposition_.own())
        {
            all.insert(all.end(), received_[rank], -1);
            continue;
        }
        for (const auto& one : sent_[rank])
        {
            all.push_back(one.first);
        }
    }

    return all;
}


void Foam::aerosol::ghosts::renumber
(
    const std::vector<int>& places,
    const int n
)
{
    n_ = n;

    for (auto& list : sent_)
    {
        for (auto& one : list)
        {
            one.first = places[one.first];
        }
    }
}


std::vector<int> Foam::aerosol::ghosts::keep(const std::vector<char>& marks)
{
    std::vector<int> places(nGhosts(), -1);
    messages send(decomposition_.n());

    int ghost = 0;
    int n = 0;

    for (int rank = 0; rank < decomposition_.n(); ++rank)
    {
        const int end = ghost + received_[rank];
        received_[rank] = 0;

        for (; ghost < end; ++ghost)
        {
            send[rank].push_back(marks[ghost]);

            if (marks[ghost])
            {
                ++received_[rank];
                image_[n] = image_[ghost];
                places[ghost] = n++;
            }
        }
    }

    image_.resize(n);

    std::vector<std::size_t> lengths;
    for (const auto& list : sent_)
    {
        lengths.push_back(list.size());
    }

    const messages back = communicator::exchange(std::move(send), lengths);

    for (int rank = 0; rank < decomposition_.n(); ++rank)
    {
        auto& list = sent_[rank];
        std::size_t to = 0;

        for (std::size_t m = 0; m < list.size(); ++m)
        {
            if (back[rank][m] > 0)
            {
                list[to++] = list[m];
            }
        }

        list.resize(to);
    }

    return places;
}


std::vector<char> Foam::aerosol::ghosts::sent() const
{
    std::vector<char> marks(n_, 0);

    for (const auto& list : sent_)
    {
        for (const auto& one : list)
        {
            marks[one.first] = 1;
        }
    }

    return marks;
}


void Foam::aerosol::ghosts::fill(const std::vector<filling>& all)
{
    const int n = all[0].layer->decomposition_.n();

    messages send(n);
    std::vector<std::size_t> lengths(n, 0);

    for (const filling& one : all)
    {
        const ghosts& layer = *one.layer;
        const auto& quantities = one.quantities;

        int rows = 0;
        for (const quantity& q : quantities)
        {
            rows += q.rows_;
        }

        for (int rank = 0; rank < n; ++rank)
        {
            const std::size_t before = send[rank].size();
            const auto& sent = layer.sent_[rank];

            lengths[rank] += rows*layer.received_[rank];
            send[rank].resize(before + rows*sent.size());
            double* to = send[rank].data() + before;

            for (const auto& image : sent)
            {
                for (const quantity& q : quantities)
                {
                    for (int k = 0; k < q.rows_; ++k)
                    {
                        *to = q.own_[q.rows_*image.first + k];

                        if (q.isPosition_)
                        {
                            *to += image.second[k]*layer.period_(k);
                        }

                        ++to;
                    }
                }
            }
        }
    }

    const messages received = communicator::exchange(std::move(send), lengths);

    std::vector<const double*> from;
    for (const std::vector<double>& message : received)
    {
        from.push_back(message.data());
    }

    for (const filling& one : all)
    {
        int ghost = 0;

        for (int rank = 0; rank < n; ++rank)
        {
            const double*& next = from[rank];

            for (int m = 0; m < one.layer->received_[rank]; ++m, ++ghost)
            {
                for (const quantity& q : one.quantities)
                {
                    for (int k = 0; k < q.rows_; ++k)
                    {
                        q.ghosts_[q.rows_*ghost + k] = *next++;
                    }
                }
            }
        }
    }
}


void Foam::aerosol::ghosts::spreadMax
(
    const std::vector<std::pair<const ghosts*, scalars*>>& all
)
{
    const int n = all[0].first->decomposition_.n();

    messages send(n);
    std::vector<std::size_t> lengths(n, 0);

    for (const auto& one : all)
    {
        const ghosts& layer = *one.first;
        const double* next = one.second->data() + layer.n_;

        for (int rank = 0; rank < n; ++rank)
        {
            const double* const end = next + layer.received_[rank];

            lengths[rank] += layer.sent_[rank].size();
            send[rank].insert(send[rank].end(), next, end);
            next = end;
        }
    }

    const messages back = communicator::exchange(std::move(send), lengths);

    std::vector<const double*> from;
    for (const std::vector<double>& message : back)
    {
        from.push_back(message.data());
    }

    // The first one collects what the originals get
    const int own = all[0].first->n_;
    auto largest = all[0].second->head(own);

    for (const auto& one : all)
    {
        for (int rank = 0; rank < n; ++rank)
        {
            for (const auto& image : one.first->sent_[rank])
            {
                largest(image.first) =
                    std::max(largest(image.first), *from[rank]++);
            }
        }
        largest = largest.max(one.second->head(own));
    }

    std::vector<filling> fillings;

    for (const auto& one : all)
    {
        one.second->head(own) = largest;
        fillings.push_back({one.first, {quantity(*one.second, *one.first)}});
    }

    fill(fillings);
}


void Foam::aerosol::ghosts::fill(const std::vector<quantity>& quantities) const
{
    fill({filling{this, quantities}});
}


void Foam::aerosol::ghosts::spreadMax(scalars& values) const
{
    spreadMax({{this, &values}});
}


// ************************************************************************* //
