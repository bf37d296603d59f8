/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeStepping.H"
#include "selectModel.H"

#include <algorithm>
#include <queue>
#include <tuple>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace aerosol
{
    defineTypeNameAndDebug(timeStepping, 0);
    defineRunTimeSelectionTable(timeStepping, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * * //

class Foam::aerosol::timeStepping::path
{
        Eigen::Vector3d x0_;
        Eigen::Vector3d v0_;
        Eigen::Vector3d x1_;
        Eigen::Vector3d v1_;
        double begin_;
        double length_;

public:

    path
    (
        const Eigen::Vector3d& x0,
        const Eigen::Vector3d& v0,
        const Eigen::Vector3d& x1,
        const Eigen::Vector3d& v1,
        const double begin,
        const double end
    )
    :
        x0_(x0),
        v0_(v0),
        x1_(x1),
        v1_(v1),
        begin_(begin),
        length_(end - begin)
    {}

    //- Hermite's cubic through the ends
    Eigen::Vector3d position(const double t) const
    {
        if (length_ <= 0)
        {
            return x1_;
        }

        const double s = (t - begin_)/length_;
        const double q = 1 - s;

        return
            (1 + 2*s)*q*q*x0_ + s*q*q*length_*v0_
          + (3 - 2*s)*s*s*x1_ - s*s*q*length_*v1_;
    }

    //- No less than the speed relative to the other path, at any time: the
    //  largest of the control points of the derivative, a Bezier curve, where
    //  both are cubics over the same time, else the sum for both
    double relativeSpeed(const path& b) const
    {
        const auto largest =
        [](
            const Eigen::Vector3d& v0,
            const Eigen::Vector3d& chord,
            const Eigen::Vector3d& v1
        )
        {
            return
                std::sqrt
                (
                    std::max
                    ({
                        v0.squaredNorm(),
                        (3*chord - v0 - v1).squaredNorm(),
                        v1.squaredNorm()
                    })
                );
        };

        if (begin_ == b.begin_ && length_ > 0)
        {
            return largest
            (
                v0_ - b.v0_,
                (x1_ - x0_ - b.x1_ + b.x0_)/length_,
                v1_ - b.v1_
            );
        }

        const auto own = [&](const path& a)
        {
            return
                a.length_ > 0
              ? largest(a.v0_, (a.x1_ - a.x0_)/a.length_, a.v1_)
              : 0.0;
        };

        return own(*this) + own(b);
    }

    //- Its derivative
    Eigen::Vector3d velocity(const double t) const
    {
        if (length_ <= 0)
        {
            return v1_;
        }

        const double s = (t - begin_)/length_;
        const double q = 1 - s;

        return
            6*s*q/length_*(x1_ - x0_)
          + q*(1 - 3*s)*v0_ + s*(3*s - 2)*v1_;
    }
};


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- An overlap found on the paths of a pair
struct overlap
{
    double time;
    std::int64_t idI;
    std::int64_t idJ;
    int i;
    int j;
    std::array<std::int8_t, 3> image;

    //- How often the paths of both had changed when it was found
    int age;

    //- Earliest first; at the same time in the order of the ids
    bool operator<(const overlap& b) const
    {
        return
            std::tie(time, idI, idJ) > std::tie(b.time, b.idI, b.idJ);
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::timeStepping::timeStepping(const tools& with)
:
    with_(with),
    grid_(with.region)
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::aerosol::timeStepping>
Foam::aerosol::timeStepping::New
(
    const dictionary& dict,
    const tools& with
)
{
    return selectModel<timeStepping>
    (
        dict,
        "time stepping",
        dictionaryConstructorTablePtr_,
        dict,
        with
    );
}


// * * * * * * * * * * * * * Static Member Functions * * * * * * * * * * * * //

double Foam::aerosol::timeStepping::firstOverlap
(
    const path& a,
    const path& b,
    const Eigen::Vector3d& shift,
    const double touch,
    const double first,
    const double last,
    const double interval,
    const bool onlyNew
)
{
    const auto overlaps = [&](const double t)
    {
        return
            (b.position(t) + shift - a.position(t)).squaredNorm()
         <= touch*touch;
    };

    bool before = onlyNew && overlaps(first);

    const int nSteps =
        std::max(1, static_cast<int>(std::lround((last - first)/interval)));

    for (int s = 0; s <= nSteps; ++s)
    {
        const double t = first + s*(last - first)/nSteps;
        const bool now = overlaps(t);

        if (now && !before)
        {
            return t;
        }

        before = now;
    }

    return GREAT;
}


double Foam::aerosol::timeStepping::firstTouch
(
    const path& a,
    const path& b,
    const Eigen::Vector3d& shift,
    const double touch,
    const double first,
    const double last,
    const bool onlyNew
)
{
    // No gap can close faster than this
    const double speed = std::max(a.relativeSpeed(b), VSMALL);

    const auto gap = [&](const double t)
    {
        return (b.position(t) + shift - a.position(t)).norm() - touch;
    };

    double t = first;
    double distance = gap(t);

    // Out of an overlap that does not count
    while (onlyNew && distance <= 0 && t <= last)
    {
        t += std::max(-distance, 1e-3*touch)/speed;
        distance = gap(t);
    }

    while (t <= last)
    {
        if (distance <= 0)
        {
            return t;
        }

        // Very close, the steps become too short: contact is where the gap
        // closes at its present rate, unless they only graze
        if (distance < 1e-6*touch)
        {
            double contact = t;

            for (int n = 0; n < 3; ++n)
            {
                const Eigen::Vector3d r =
                    b.position(contact) + shift - a.position(contact);
                const double rate =
                    (b.velocity(contact) - a.velocity(contact)).dot(r)/r.norm();

                if (rate >= 0)
                {
                    break;
                }
                contact += (touch - r.norm())/rate;
            }

            if (contact <= last && gap(contact) <= 1e-12*touch)
            {
                return std::max(contact, first);
            }
        }

        t += std::max(distance, 1e-6*touch)/speed;
        distance = gap(t);
    }

    return GREAT;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::aerosol::timeStepping::gasStep
Foam::aerosol::timeStepping::sampleGas
(
    const particleArrays& p,
    const scalar t,
    const scalar h,
    const bool parabola
) const
{
    gasStep gas;

    with_.sound.velocity(t, p.x, gas.u0);

    // Where a particle will be at the end matters to second order; just across
    // the border of the domain the gas is that at the border
    vectors x1 = p.x + h*p.v;

    const vector lower = with_.region.bounds().min();
    const vector upper = with_.region.bounds().max();

    for (int k = 0; k < 3; ++k)
    {
        x1.row(k) = x1.row(k).cwiseMax(lower[k]).cwiseMin(upper[k]);
    }

    with_.sound.velocity(t + h, x1, gas.u1);

    if (parabola)
    {
        with_.sound.velocity(t + 0.5*h, 0.5*(p.x + x1), gas.um);
    }

    return gas;
}


Foam::aerosol::scalars Foam::aerosol::timeStepping::relativeSpeed
(
    const particleArrays& p,
    const gasStep& gas
) const
{
    const Eigen::Vector3d mean = p.v.rowwise().mean();

    const auto speed = [&](const vectors& v)
    {
        return (v.colwise() - mean).colwise().norm().array().transpose();
    };

    return speed(p.v).max(speed(gas.u0)).max(speed(gas.u1));
}


Foam::aerosol::scalars Foam::aerosol::timeStepping::relativeWay
(
    const particleArrays& p,
    const gasStep& gas,
    const scalar h
) const
{
    const scalars way = h*(relativeSpeed(p, gas) + with_.motion.gain(h));

    const scalar furthest = way.maxCoeff();
    const scalar shortest = with_.region.bounds().minDim();

    if (p.size() > 1 && furthest > shortest)
    {
        FatalErrorInFunction
            << "In one fluid step of " << h << " s a particle can move by "
            << furthest << " m relative to the others, which is more than the "
            << "shortest edge of the domain, " << shortest
            << " m. Reduce deltaT"
            << exit(FatalError);
    }

    return way;
}


void Foam::aerosol::timeStepping::nestedSteps
(
    particleArrays& p,
    const gasStep& gas,
    const scalar t,
    const scalar h,
    const int nParticle,
    const int nCollision
)
{
    search(p, gas, h);

    march(p, gas, {}, {}, t, h, nParticle, nCollision);

    with_.contacts.sweep(p);
    with_.region.confine(p);

    effort_.collisionSteps += std::int64_t(nParticle)*nCollision;
    effort_.particleSteps += nParticle;
    effort_.wakePairs += wakePairs_.size();
    effort_.contactPairs += contactPairs_.size();
}


void Foam::aerosol::timeStepping::march
(
    particleArrays& p,
    const gasStep& gas,
    const vectors& outside0,
    const vectors& outside1,
    const scalar t,
    const scalar h,
    const int nParticle,
    const int nCollision
)
{
    const scalar hp = h/nParticle;

    gasStep now;
    now.u0 = gas.u0;

    vectors w0;
    vectors outside;
    equationOfMotion::state end;

    with_.motion.wakes(p, wakePairs_, p.x, p.v, now.u0, w0);
    if (outside0.cols())
    {
        w0 += outside0;
    }

    for (int s = 0; s < nParticle; ++s)
    {
        const scalar done = scalar(s + 1)/nParticle;

        now.u1 = gas.at(done);
        if (outside0.cols())
        {
            outside = outside0 + done*(outside1 - outside0);
        }

        with_.motion.step(hp, p, wakePairs_, now, w0, outside, end);

        collide(p, end, now, outside, t + s*hp, hp, nCollision);

        p.x.swap(end.x);
        p.v.swap(end.v);
        w0.swap(end.w);
        now.u0.swap(now.u1);
    }
}


void Foam::aerosol::timeStepping::searchWakes
(
    const particleArrays& p,
    const scalars& way
)
{
    wakePairs_.clear();

    if (with_.motion.hasWakes())
    {
        const scalars& range = with_.motion.wakeRange();

        grid_.build
        (
            p.x,
            (range > 0).select(range + way + way.maxCoeff(), range)
        );
        grid_.acting(wakePairs_);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::timeStepping::search
(
    const particleArrays& p,
    const gasStep& gas,
    const scalar h
)
{
    with_.motion.refresh(p);

    const scalars way = relativeWay(p, gas, h);

    searchWakes(p, way);

    if (with_.contacts.active())
    {
        // More for the wake of a neighbour, which is no faster than its slip,
        // and that no faster than twice the relative speed. A sphere that has
        // just grown by a merger may touch one that is not listed: it is found
        // in the next step.
        const scalar drawn = with_.motion.hasWakes() ? 2*way.maxCoeff() : 0;

        grid_.build(p.x, 0.5*p.d + way + drawn);
        grid_.touching(contactPairs_);
    }
}


void Foam::aerosol::timeStepping::collide
(
    particleArrays& p,
    equationOfMotion::state& end,
    const gasStep& gas,
    const vectors& outside,
    const scalar t,
    const scalar h,
    const int nCollision
)
{
    if (contactPairs_.empty())
    {
        return;
    }

    const Eigen::Array3d period = with_.region.period();

    // Particles that merged within this step began their path later
    std::vector<double> begin;
    std::vector<int> age;

    const auto pathOf = [&](const int i) -> path
    {
        return
        {
            p.x.col(i), p.v.col(i), end.x.col(i), end.v.col(i),
            begin.empty() ? 0 : begin[i], h
        };
    };

    const auto shiftOf = [&](const particlePair& pair) -> Eigen::Vector3d
    {
        return
        {
            pair.image[0]*period(0),
            pair.image[1]*period(1),
            pair.image[2]*period(2)
        };
    };

    std::priority_queue<overlap> queue;

    // The first time, from the given one on, at which a pair overlaps
    const auto look = [&](const particlePair& pair, const double first)
    {
        const int i = pair.i;
        const int j = pair.j;

        if
        (
            i == j
         || with_.contacts.absorbed(i)
         || with_.contacts.absorbed(j)
        )
        {
            return;
        }

        const double touch = 0.5*(p.d(i) + p.d(j));
        const Eigen::Vector3d shift = shiftOf(pair);

        // Most pairs stay apart: the distance is no less than that at either
        // end less the way between them
        if (begin.empty())
        {
            const Eigen::Vector3d r0 = p.x.col(j) + shift - p.x.col(i);
            const Eigen::Vector3d r1 = end.x.col(j) + shift - end.x.col(i);
            const Eigen::Vector3d v0 = p.v.col(j) - p.v.col(i);
            const Eigen::Vector3d v1 = end.v.col(j) - end.v.col(i);

            // Hermite's cubic is no further from an end than this
            const double way =
                (r1 - r0).norm() + 4.0/27.0*h*(v0.norm() + v1.norm());

            if (std::max(r0.norm(), r1.norm()) > touch + way)
            {
                return;
            }
        }

        const path pathI = pathOf(i);
        const path pathJ = pathOf(j);

        // Who touched without sticking does so again only after a separation
        const bool onlyNew = with_.contacts.refused(p.id(i), p.id(j));

        const double when =
            nCollision > 0
          ? firstOverlap
            (
                pathI, pathJ, shift, touch, first, h, h/nCollision,
                onlyNew
            )
          : firstTouch
            (
                pathI, pathJ, shift, touch, first, h,
                onlyNew
            );

        if (when <= h)
        {
            queue.push
            ({
                when, p.id(i), p.id(j), i, j, pair.image,
                age.empty() ? 0 : age[i] + age[j]
            });
        }
    };

    for (const particlePair& pair : contactPairs_)
    {
        look(pair, 0);
    }

    while (!queue.empty())
    {
        const overlap found = queue.top();
        queue.pop();

        const int i = found.i;
        const int j = found.j;

        if
        (
            with_.contacts.absorbed(i)
         || with_.contacts.absorbed(j)
         || found.age != (age.empty() ? 0 : age[i] + age[j])
        )
        {
            continue;
        }

        const scalar when = found.time;
        const path pathI = pathOf(i);
        const path pathJ = pathOf(j);
        const Eigen::Vector3d shift = shiftOf({i, j, found.image});

        contactOutcome::encounter encounter;
        encounter.i = i;
        encounter.j = j;
        encounter.xi = pathI.position(when);
        encounter.xj = pathJ.position(when) + shift;
        encounter.shift = shift;
        encounter.vi = pathI.velocity(when);
        encounter.vj = pathJ.velocity(when);
        encounter.time = t + when;

        const int survivor = with_.contacts.meet(p, encounter);

        if (survivor < 0)
        {
            continue;
        }

        if (begin.empty())
        {
            begin.assign(p.size(), 0);
            age.assign(p.size(), 0);
        }

        begin[survivor] = when;
        ++age[survivor];

        std::array<std::int8_t, 3> image = found.image;

        if (survivor == j)
        {
            for (std::int8_t& n : image)
            {
                n = -n;
            }
        }

        redirect(survivor, survivor == i ? j : i, image);

        with_.motion.moveOn
        (
            survivor, when/h, h, p, wakePairs_, gas, outside, end
        );

        for (const particlePair& pair : contactPairs_)
        {
            if (pair.i == survivor || pair.j == survivor)
            {
                look(pair, when);
            }
        }
    }
}


void Foam::aerosol::timeStepping::redirect
(
    const int survivor,
    const int absorbed,
    const std::array<std::int8_t, 3>& image
)
{
    // Contacts of the absorbed one become contacts of the survivor, which is
    // where the absorbed one's copy at `image` was
    for (particlePair& pair : contactPairs_)
    {
        for (int k = 0; k < 3; ++k)
        {
            if (pair.i == absorbed)
            {
                pair.image[k] += image[k];
            }
            if (pair.j == absorbed)
            {
                pair.image[k] -= image[k];
            }
        }

        if (pair.i == absorbed)
        {
            pair.i = survivor;
        }
        if (pair.j == absorbed)
        {
            pair.j = survivor;
        }
    }

    // Its wake is gone
    wakePairs_.erase
    (
        std::remove_if
        (
            wakePairs_.begin(),
            wakePairs_.end(),
            [&](const particlePair& pair)
            {
                return pair.i == absorbed || pair.j == absorbed;
            }
        ),
        wakePairs_.end()
    );
}


// ************************************************************************* //
