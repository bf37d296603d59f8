/*---------------------------------------------------------------------------*\
    acousticDEM: acoustic agglomeration of aerosols
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "particleArrays.H"

#include <algorithm>
#include <numeric>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using changes = std::vector<std::pair<int, int>>;

template<class Array>
void apply(Array& values, const changes& all, const int nRemoved)
{
    for (const auto& one : all)
    {
        values.col(one.second) = values.col(one.first);
    }

    values.conservativeResize(Eigen::NoChange, values.cols() - nRemoved);
}

template<class Scalar>
void apply
(
    Eigen::Array<Scalar, Eigen::Dynamic, 1>& values,
    const changes& all,
    const int nRemoved
)
{
    for (const auto& one : all)
    {
        values(one.second) = values(one.first);
    }

    values.conservativeResize(values.size() - nRemoved);
}

int count(const std::vector<char>& marked)
{
    return static_cast<int>
    (
        std::count_if
        (
            marked.begin(), marked.end(), [](const char m) { return m; }
        )
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::aerosol::particleArrays::resize(const int n)
{
    id.resize(n);
    x.resize(3, n);
    v.resize(3, n);
    thermal.setZero(3, n);
    d.resize(n);
    m.resize(n);
    primaries.resize(n);

    rate.resize(0);
    response.resize(0);
    acceleration.resize(3, 0);
    range.resize(0);
    mobilityDiameter.resize(0);
    collisionDiameter.resize(0);

    resizeHistory(history.rows());
}


void Foam::aerosol::particleArrays::resizeHistory(const int rows)
{
    history.setZero(rows, size());
    unsteady.setZero(3, rows ? size() : 0);
}


void Foam::aerosol::particleArrays::mergeHistory(const int i, const int j)
{
    if (history.rows())
    {
        const double share = m(j)/(m(i) + m(j));

        history.col(i) += share*(history.col(j) - history.col(i));
        unsteady.col(i) += share*(unsteady.col(j) - unsteady.col(i));
    }
}


void Foam::aerosol::particleArrays::resizeLaws()
{
    rate.resize(size());
    response.resize(size());
    acceleration.resize(3, size());
    range.resize(size());
    mobilityDiameter.resize(size());
    collisionDiameter.resize(size());
}


void Foam::aerosol::particleArrays::reorder(const std::vector<int>& indices)
{
    const bool withLaws = refreshed();

    // Not all of them twice at the same time
    const auto one = [&](auto& values)
    {
        values = values(indices).eval();
    };
    const auto three = [&](auto& values)
    {
        values = values(Eigen::all, indices).eval();
    };

    one(id);
    three(x);
    three(v);
    three(thermal);
    one(d);
    one(m);
    one(primaries);

    if (withLaws)
    {
        one(rate);
        one(response);
        three(acceleration);
        one(range);
        one(mobilityDiameter);
        one(collisionDiameter);
    }

    if (history.rows())
    {
        three(unsteady);
        three(history);
    }
}


double Foam::aerosol::particleArrays::volume(const int i) const
{
    return EIGEN_PI/6*d(i)*d(i)*d(i);
}


void Foam::aerosol::particleArrays::pack(const int i, double* numbers) const
{
    // Whole numbers are exact up to 2^53
    numbers[0] = static_cast<double>(id(i));
    numbers[1] = static_cast<double>(primaries(i));
    numbers[2] = d(i);
    numbers[3] = m(i);
    Eigen::Map<Eigen::Vector3d>(numbers + 4) = x.col(i);
    Eigen::Map<Eigen::Vector3d>(numbers + 7) = v.col(i);
    numbers[10] = rate(i);
    numbers[11] = range(i);
    Eigen::Map<Eigen::Vector3d>(numbers + 12) = acceleration.col(i);
    Eigen::Map<Eigen::Vector3d>(numbers + 15) = thermal.col(i);
    numbers[18] = mobilityDiameter(i);
    numbers[19] = collisionDiameter(i);
    numbers[20] = response(i).real();
    numbers[21] = response(i).imag();

    if (history.rows())
    {
        double* const more = numbers + nNumbers;

        Eigen::Map<Eigen::Vector3d>(more + 0) = unsteady.col(i);
        Eigen::Map<Eigen::VectorXd>(more + 3, history.rows()) = history.col(i);
    }
}


void Foam::aerosol::particleArrays::unpack(const int i, const double* numbers)
{
    id(i) = static_cast<std::int64_t>(numbers[0]);
    primaries(i) = static_cast<std::int64_t>(numbers[1]);
    d(i) = numbers[2];
    m(i) = numbers[3];
    x.col(i) = Eigen::Map<const Eigen::Vector3d>(numbers + 4);
    v.col(i) = Eigen::Map<const Eigen::Vector3d>(numbers + 7);
    rate(i) = numbers[10];
    range(i) = numbers[11];
    acceleration.col(i) = Eigen::Map<const Eigen::Vector3d>(numbers + 12);
    thermal.col(i) = Eigen::Map<const Eigen::Vector3d>(numbers + 15);
    mobilityDiameter(i) = numbers[18];
    collisionDiameter(i) = numbers[19];
    response(i) = {numbers[20], numbers[21]};

    if (history.rows())
    {
        const double* const more = numbers + nNumbers;

        unsteady.col(i) = Eigen::Map<const Eigen::Vector3d>(more);
        history.col(i) =
            Eigen::Map<const Eigen::VectorXd>(more + 3, history.rows());
    }
}


Foam::aerosol::particleArrays Foam::aerosol::particleArrays::select
(
    const std::vector<int>& indices
) const
{
    particleArrays chosen;

    chosen.id = id(indices);
    chosen.x = x(Eigen::all, indices);
    chosen.v = v(Eigen::all, indices);
    chosen.thermal = thermal(Eigen::all, indices);
    chosen.d = d(indices);
    chosen.m = m(indices);
    chosen.primaries = primaries(indices);

    if (refreshed())
    {
        chosen.rate = rate(indices);
        chosen.response = response(indices);
        chosen.acceleration = acceleration(Eigen::all, indices);
        chosen.range = range(indices);
        chosen.mobilityDiameter = mobilityDiameter(indices);
        chosen.collisionDiameter = collisionDiameter(indices);
    }

    if (history.rows())
    {
        chosen.unsteady = unsteady(Eigen::all, indices);
        chosen.history = history(Eigen::all, indices);
    }

    return chosen;
}


void Foam::aerosol::particleArrays::append(const particleArrays& by)
{
    const int before = size();
    const int n = before + by.size();

    for (integers* values : {&id, &primaries})
    {
        values->conservativeResize(n);
    }
    for (vectors* values : {&x, &v, &thermal, &acceleration})
    {
        values->conservativeResize(3, n);
    }
    for
    (
        scalars* values :
        {&d, &m, &rate, &range, &mobilityDiameter, &collisionDiameter}
    )
    {
        values->conservativeResize(n);
    }
    response.conservativeResize(n);
    if (history.rows())
    {
        unsteady.conservativeResize(3, n);
        history.conservativeResize(Eigen::NoChange, n);
    }

    std::vector<double> numbers(packedNumbers());

    for (int k = 0; k < by.size(); ++k)
    {
        by.pack(k, numbers.data());
        unpack(before + k, numbers.data());
    }
}


void Foam::aerosol::particleArrays::replace
(
    const int i,
    const particleArrays& by
)
{
    std::vector<double> numbers(packedNumbers());
    std::vector<int> others(by.size() - 1);

    std::iota(others.begin(), others.end(), 1);
    append(by.select(others));

    by.pack(0, numbers.data());
    unpack(i, numbers.data());
}


void Foam::aerosol::particleArrays::remove(const std::vector<char>& marked)
{
    const changes all = moves(marked);
    const int n = count(marked);
    const bool withLaws = refreshed();

    apply(id, all, n);
    apply(x, all, n);
    apply(v, all, n);
    apply(thermal, all, n);
    apply(d, all, n);
    apply(m, all, n);
    apply(primaries, all, n);

    if (withLaws)
    {
        apply(rate, all, n);
        apply(response, all, n);
        apply(acceleration, all, n);
        apply(range, all, n);
        apply(mobilityDiameter, all, n);
        apply(collisionDiameter, all, n);
    }

    if (history.rows())
    {
        apply(unsteady, all, n);
        apply(history, all, n);
    }
}


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

std::vector<std::pair<int, int>> Foam::aerosol::moves
(
    const std::vector<char>& marked
)
{
    changes all;

    int last = static_cast<int>(marked.size()) - 1;

    for (int to = 0; to <= last; ++to)
    {
        if (!marked[to])
        {
            continue;
        }

        while (last > to && marked[last])
        {
            --last;
        }

        if (last > to)
        {
            all.push_back({last, to});
        }

        --last;
    }

    return all;
}


void Foam::aerosol::remove(vectors& values, const std::vector<char>& marked)
{
    apply(values, moves(marked), count(marked));
}


void Foam::aerosol::remove(scalars& values, const std::vector<char>& marked)
{
    apply(values, moves(marked), count(marked));
}


// ************************************************************************* //
