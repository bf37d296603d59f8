/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bruteForce.H"

#include <algorithm>
#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const double pi = EIGEN_PI;

//- Fractions of the step, and weights of the rates before, of each stage; the
//  last stage is the end of the step
const double fraction[7] = {0, 1.0/5, 3.0/10, 4.0/5, 8.0/9, 1, 1};

const double weight[7][6] =
{
    {},
    {1.0/5},
    {3.0/40, 9.0/40},
    {44.0/45, -56.0/15, 32.0/9},
    {19372.0/6561, -25360.0/2187, 64448.0/6561, -212.0/729},
    {9017.0/3168, -355.0/33, 46732.0/5247, 49.0/176, -5103.0/18656},
    {35.0/384, 0, 500.0/1113, 125.0/192, -2187.0/6784, 11.0/84}
};

//- Of the 5th less the 4th order
const double difference[7] =
{
    71.0/57600, 0, -71.0/16695, 71.0/1920, -17253.0/339200, 22.0/525, -1.0/40
};

//- Of the term of 4th order of the dense output (Hairer, Norsett and Wanner)
const double bulge[7] =
{
    -12715105075.0/11282082432,
    0,
    87487479700.0/32700410799,
    -10690763975.0/1880347072,
    701980252875.0/199316789632,
    -1453857185.0/822651844,
    69997945.0/29380423
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::aerosol::testTools::bruteForce::resize()
{
    const array Kn = 2*gas_.meanFreePath/d_;
    const array Cc = 1 + Kn*(1.257 + 0.4*(-1.1/Kn).exp());

    rate_ = 3*pi*gas_.mu*d_/m_;
    if (law_.slipCorrection)
    {
        rate_ /= Cc;
    }

    weight_ = law_.gravity*(1 - gas_.rho*pi/6*d_.cube()/m_);

    range_ = law_.range*d_;
    if (law_.bound > 0)
    {
        const double omega = 2*pi*law_.frequency;
        const array s = omega/rate_;
        const array U = law_.u*s/(1 + s.square()).sqrt() + weight_/rate_;
        const array half = 0.5*U/omega;

        range_ =
            (0.75*d_*U/law_.bound)
           .min(half + (half.square() + 3*gas_.nu()/omega).sqrt());
    }

    end_.resizeLike(y_);
    stage_.resizeLike(y_);
    for (state& k : k_)
    {
        k.resizeLike(y_);
    }
}


void Foam::aerosol::testTools::bruteForce::rates
(
    const double t,
    const state& y,
    state& dy
)
{
    const vec u(law_.u*std::sin(2*pi*law_.frequency*t), 0, 0);

    dy.leftCols<3>() = y.rightCols<3>();
    dy.rightCols<3>().setZero();

    for (int j = 0; range_(0) > 0 && j < size(); ++j)
    {
        const vec U = u - y.row(j).tail<3>().matrix().transpose();
        const double speed = U.norm();

        if (speed < 1e-14)
        {
            continue;
        }

        const double radius = 0.5*d_(j);
        const double Re = 2*radius*speed/gas_.nu();

        for (int k = 0; k < 3; ++k)
        {
            r_[k] = y.col(k) - y(j, k);

            if (law_.length > 0)
            {
                r_[k] -= law_.length*(r_[k]/law_.length).round();
            }
        }

        distance_ = r_[0].square() + r_[1].square() + r_[2].square();
        distance_(j) = 1;
        distance_ = distance_.sqrt();

        cosine_ =
            ((U(0)*r_[0] + U(1)*r_[1] + U(2)*r_[2])/(speed*distance_))
           .max(-1.0).min(1.0);

        // Radii per distance from the centre, and no more than at the surface
        q_ = (radius/distance_).min(1.0);
        E_ = (-0.25*Re*(1 - cosine_)/q_).exp();

        // Components along r and theta, this one per sine
        along_ =
            0.5*cosine_*q_.cube() - 0.75*(1 + cosine_)*E_*q_
          + 3/Re*(1 - E_)*q_.square();
        across_ = 0.25*q_.cube() + 0.75*E_*q_;

        // Theta points along (cosine e - U/speed)/sine
        along_ = speed*(along_ + cosine_*across_)/distance_;

        // In full up to the range over the root of two; the distance of j
        // itself is one
        fade_ =
            (2*(distance_/range_(j)).square() - 1).max(0.0).min(1.0);
        fade_ = 1 - fade_.cube()*(10 - 15*fade_ + 6*fade_.square());
        fade_(j) = 0;

        along_ *= fade_;
        across_ *= fade_;

        for (int k = 0; k < 3; ++k)
        {
            dy.col(3 + k) += along_*r_[k] - U(k)*across_;
        }
    }

    for (int k = 0; k < 3; ++k)
    {
        dy.col(3 + k) = rate_*(u(k) + dy.col(3 + k) - y.col(3 + k));
    }

    dy.col(4) -= weight_;
}


double Foam::aerosol::testTools::bruteForce::step(const double h)
{
    for (int s = 1; s < 7; ++s)
    {
        stage_ = y_;
        for (int n = 0; n < s; ++n)
        {
            if (weight[s][n] != 0)
            {
                stage_ += h*weight[s][n]*k_[n];
            }
        }
        rates(t_ + fraction[s]*h, stage_, k_[s]);
    }
    end_ = stage_;

    stage_.setZero();
    for (int n = 0; n < 7; ++n)
    {
        stage_ += h*difference[n]*k_[n];
    }

    return
        std::max
        (
            stage_.leftCols<3>().abs().maxCoeff()/errorX_,
            stage_.rightCols<3>().abs().maxCoeff()/errorV_
        );
}


void Foam::aerosol::testTools::bruteForce::makeDense(const double h)
{
    dense_[0] = y_;
    dense_[1] = end_ - y_;
    dense_[2] = h*k_[0] - dense_[1];
    dense_[3] = dense_[1] - h*k_[6] - dense_[2];
    dense_[4] = h*bulge[0]*k_[0];
    for (int n = 2; n < 7; ++n)
    {
        dense_[4] += h*bulge[n]*k_[n];
    }
}


Eigen::Vector3d Foam::aerosol::testTools::bruteForce::nearest(vec r) const
{
    for (int k = 0; law_.length > 0 && k < 3; ++k)
    {
        r(k) -= law_.length*std::round(r(k)/law_.length);
    }
    return r;
}


std::pair<Eigen::Vector3d, Eigen::Vector3d>
Foam::aerosol::testTools::bruteForce::relative
(
    const state& y,
    const int i,
    const int j
) const
{
    vec r, v;

    for (int k = 0; k < 3; ++k)
    {
        r(k) = y(j, k) - y(i, k);
        v(k) = y(j, 3 + k) - y(i, 3 + k);
    }

    return {nearest(r), v};
}


std::pair<Eigen::Vector3d, Eigen::Vector3d>
Foam::aerosol::testTools::bruteForce::relative
(
    const double s,
    const int i,
    const int j
) const
{
    const auto at = [&](const int p, const int c)
    {
        return
            dense_[0](p, c)
          + s
           *(
                dense_[1](p, c)
              + (1 - s)
               *(
                    dense_[2](p, c)
                  + s*(dense_[3](p, c) + (1 - s)*dense_[4](p, c))
                )
            );
    };

    vec r, v;

    for (int k = 0; k < 3; ++k)
    {
        r(k) = at(j, k) - at(i, k);
        v(k) = at(j, 3 + k) - at(i, 3 + k);
    }

    return {nearest(r), v};
}


void Foam::aerosol::testTools::bruteForce::look
(
    const double h,
    const int i,
    const int j,
    event& first
) const
{
    const auto [r0, v0] = relative(y_, i, j);
    const auto [r1, v1] = relative(end_, i, j);

    // Most are far from any event
    const double way = 2*h*std::max(v0.norm(), v1.norm());
    const double nearest = std::min(r0.norm(), r1.norm()) - way;

    // Where a function that is positive at a, but not at b, changes its sign
    const auto root = [](const auto& function, double a, double b)
    {
        for (int n = 0; n < 50; ++n)
        {
            const double middle = 0.5*(a + b);
            (function(middle) > 0 ? a : b) = middle;
        }
        return b;
    };

    const int parts = 4;
    const double touch = 0.5*(d_(i) + d_(j));

    const auto gap = [&](const double s)
    {
        return relative(s, i, j).first.norm() - touch;
    };

    const auto closing = [&](const double s)
    {
        const auto [r, v] = relative(s, i, j);
        return -r.dot(v);
    };

    for (int n = 0; nearest <= touch && n < parts; ++n)
    {
        const double a = double(n)/parts;
        const double b = double(n + 1)/parts;
        double s = 2;

        if (gap(b) <= 0)
        {
            s = root(gap, a, b);
        }
        else if (closing(a) > 0 && closing(b) < 0)
        {
            const double closest = root(closing, a, b);

            if (gap(closest) <= 0)
            {
                s = root(gap, a, closest);
            }
        }

        if (s < first.s)
        {
            first = {s, i, j};
        }
        if (s <= 1)
        {
            break;
        }
    }
}


double Foam::aerosol::testTools::bruteForce::endAt
(
    double h,
    const int i,
    const int j
)
{
    step(h);

    for (int n = 0; n < 4; ++n)
    {
        const auto [r, v] = relative(end_, i, j);
        const double rate = v.dot(r)/r.norm();
        const double late = (r.norm() - 0.5*(d_(i) + d_(j)))/rate;

        // Not where they graze
        if (rate >= 0 || std::abs(late) > 0.01*h)
        {
            break;
        }

        h -= late;
        step(h);
    }

    return h;
}


void Foam::aerosol::testTools::bruteForce::merge(int i, int j)
{
    const Eigen::Array3d half = 0.5*relative(y_, i, j).first;

    collisions_.push_back
    ({
        std::minmax(id_[i], id_[j]),
        t_,
        Eigen::Vector3d(y_(i, 0), y_(i, 1), y_(i, 2)) + half.matrix()
    });

    if (m_(j) > m_(i) || (m_(j) == m_(i) && id_[j] < id_[i]))
    {
        std::swap(i, j);
    }

    const double m = m_(i) + m_(j);
    const auto [r, v] = relative(y_, i, j);

    for (int k = 0; k < 3; ++k)
    {
        y_(i, k) += m_(j)/m*r(k);
        y_(i, 3 + k) += m_(j)/m*v(k);
    }

    d_(i) = std::cbrt(std::pow(d_(i), 3) + std::pow(d_(j), 3));
    m_(i) = m;

    // The last one takes the place
    const int last = size() - 1;
    id_[j] = id_[last];
    d_(j) = d_(last);
    m_(j) = m_(last);
    y_.row(j) = y_.row(last).eval();

    id_.resize(last);
    d_.conservativeResize(last);
    m_.conservativeResize(last);
    y_.conservativeResize(last, 6);
}


void Foam::aerosol::testTools::bruteForce::mergeOverlaps()
{
    while (true)
    {
        int bi = -1, bj = -1;

        for (int i = 0; i < size(); ++i)
        {
            for (int j = i + 1; j < size(); ++j)
            {
                if
                (
                    relative(y_, i, j).first.norm() <= 0.5*(d_(i) + d_(j))
                 && (
                        bi < 0
                     || std::minmax(id_[i], id_[j])
                      < std::minmax(id_[bi], id_[bj])
                    )
                )
                {
                    bi = i;
                    bj = j;
                }
            }
        }

        if (bi < 0)
        {
            break;
        }
        merge(bi, bj);
    }

    resize();
    rates(t_, y_, k_[0]);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::aerosol::testTools::bruteForce::bruteForce
(
    const particleArrays& p,
    const conditions& law
)
:
    law_(law),
    gas_(acoustics::gasProperties::air()),
    d_(p.d),
    m_(p.m),
    y_(p.size(), 6)
{
    for (int i = 0; i < p.size(); ++i)
    {
        id_.push_back(p.id(i));

        for (int k = 0; k < 3; ++k)
        {
            y_(i, k) = p.x(k, i);
            y_(i, 3 + k) = p.v(k, i);
        }
    }

    resize();

    errorX_ = law.tolerance*d_.minCoeff();
    errorV_ = errorX_*rate_.maxCoeff();
    h_ = 0.01/rate_.maxCoeff();

    mergeOverlaps();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::testTools::bruteForce::run(const double end)
{
    while (t_ < end)
    {
        double h = std::min(h_, end - t_);
        const double error = step(h);

        // Cautiously, as it costs more to try in vain
        const double next =
            h*std::min(4.0, std::max(0.2, 0.9*std::pow(error + 1e-10, -0.2)));

        if (error > 1)
        {
            h_ = next;
            continue;
        }

        makeDense(h);

        event first{2, -1, -1};

        for (int i = 0; i < size(); ++i)
        {
            for (int j = i + 1; j < size(); ++j)
            {
                look(h, i, j, first);
            }
        }

        if (first.i < 0)
        {
            // The last step is no measure for the next
            h_ = h < h_ ? std::max(h_, next) : next;
            t_ = end - t_ > h ? t_ + h : end;
            y_.swap(end_);
            k_[0].swap(k_[6]);
        }
        else
        {
            t_ += endAt(first.s*h, first.i, first.j);
            y_.swap(end_);
            merge(first.i, first.j);
            mergeOverlaps();
        }
    }
}


Foam::aerosol::particleArrays
Foam::aerosol::testTools::bruteForce::particles() const
{
    particleArrays p;
    p.resize(size());

    for (int i = 0; i < size(); ++i)
    {
        p.id(i) = id_[i];
        p.d(i) = d_(i);
        p.m(i) = m_(i);
        p.primaries(i) = 1;

        for (int k = 0; k < 3; ++k)
        {
            p.x(k, i) = y_(i, k);
            p.v(k, i) = y_(i, 3 + k);
        }
    }

    return p;
}


// ************************************************************************* //
