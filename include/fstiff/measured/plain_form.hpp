// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Shares of one parabola and of one step in the mean square of heights whose mean plane was removed.
///
///     z = sum c_kl u^k v^l + h [u cos a + v sin a > s]     u, v in [-1, 1] over the surface; a profile has no v
///     parabola    decrease of the mean square by the terms k + l = 2, over it
///     step        same by h at the best s, of a map also at the best of 36 a, where it is more than that of all
///                 terms up to the degree 5 (profile: 6): smooth waves follow these terms better than any step
///
/// Fitted to the means of at most 64 x 64 parts (profile: 256) of equal size, weighted by their points.
/// Units       heights [m], places [m] from the first point
/// Valid       surfaces without their mean plane (line) or a form of higher degree, missing points allowed
/// Accuracy    shares 0.02, place of a step along x or y one part (tests/measured/plain_form_test.cpp)

#include <fstiff/profile/structure_function.hpp>
#include <fstiff/topography/height_map.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace fstiff::inline v0_1::detail {

/// A parabola and a step in the heights.
template <Real T = double>
struct PlainForm {
    T parabola{}, step{};       ///< shares of the mean square height
    T place{};                  ///< of a step along x or y [m]
    bool along_x{}, along_y{};  ///< the step is passed along x, along y; neither: at an angle

    [[nodiscard]] bool is_parabola() const { return parabola > T(0.5) && parabola >= step; }
    [[nodiscard]] bool is_step() const { return step > T(0.5) && step > parabola; }
};

/// Parts of a surface: their terms, orthonormal with the root of their points as weight, and weighted heights.
template <Real T>
struct FormParts {
    Eigen::Array<T, Eigen::Dynamic, 1> u, v, weight, height;
    Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic> terms;
    std::vector<int> degree;  ///< of each term

    /// Orthonormal terms up to \p most; those that the points do not determine are left out.
    void add_terms(int most, bool map) {
        terms.resize(u.size(), 0);
        for (int total = 0; total <= most; ++total)
            for (int l = 0; l <= (map ? total : 0); ++l) {
                Eigen::Matrix<T, Eigen::Dynamic, 1> f = (weight * u.pow(total - l) * v.pow(l)).matrix();
                const T before = f.norm();
                for (int pass = 0; pass < 2; ++pass) f -= terms * (terms.transpose() * f);
                if (!(f.norm() > T(1e-4) * before)) continue;
                terms.conservativeResize(Eigen::NoChange, terms.cols() + 1);
                terms.col(terms.cols() - 1) = f.normalized();
                degree.push_back(total);
            }
    }
    /// Square sum of the heights that the terms of degree \p from to \p to explain.
    [[nodiscard]] T explained(int from, int to) const {
        T sum = 0;
        for (std::size_t k = 0; k < degree.size(); ++k)
            if (degree[k] >= from && degree[k] <= to)
                sum += std::pow(terms.col(static_cast<Eigen::Index>(k)).dot(height.matrix()), T(2));
        return sum;
    }
    /// Square sum that a step at the angle \p angle explains beyond the terms up to \p removed, and the part before it.
    [[nodiscard]] std::pair<T, Eigen::Index> step(T angle, int removed) const {
        const auto base = std::count_if(degree.begin(), degree.end(), [&](int one) { return one <= removed; });
        const auto low = terms.leftCols(base);
        const Eigen::Array<T, Eigen::Dynamic, 1> along = u * std::cos(angle) + v * std::sin(angle),
                                                 rest = (height.matrix() - low * (low.transpose() * height.matrix()));
        std::vector<Eigen::Index> order(static_cast<std::size_t>(u.size()));
        std::iota(order.begin(), order.end(), Eigen::Index(0));
        std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return along[a] < along[b]; });
        Eigen::Matrix<T, Eigen::Dynamic, 1> shared = Eigen::Matrix<T, Eigen::Dynamic, 1>::Zero(base);
        T heights = 0, points = 0;
        const T all = weight.square().sum();
        std::pair<T, Eigen::Index> best{T(0), 0};
        for (const Eigen::Index at : order) {
            shared += weight[at] * low.row(at).transpose();
            heights += weight[at] * rest[at], points += weight[at] * weight[at];
            if (points < all / 20 || points > all - all / 20) continue;
            if (const T gain = heights * heights / (points - shared.squaredNorm()); gain > best.first)
                best = {gain, at};
        }
        return best;
    }
};

/// Form of \p rows by \p columns points at the steps \p dx, \p dy, whose \p height(j, i) is in any unit, NaN where
/// missing, and without a form of the degree \p removed; one row for a profile.
template <Real T, class Height>
[[nodiscard]] PlainForm<T> plain_form(Eigen::Index rows, Eigen::Index columns, T dx, T dy, int removed,
                                      const Height& height) {
    const bool map = rows > 1;
    const Eigen::Index most = map ? 64 : 256, down = (std::min)(rows, most), across = (std::min)(columns, most);
    Eigen::Array<T, Eigen::Dynamic, Eigen::Dynamic> sum = decltype(sum)::Zero(down, across), count = sum;
    T squares = 0;
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i)
            if (const T z = height(j, i); !std::isnan(z)) {
                sum(j * down / rows, i * across / columns) += z, squares += z * z;
                count(j * down / rows, i * across / columns) += T(1);
            }
    squares -= sum.sum() * (sum.sum() / count.sum());
    const Eigen::Index parts = (count > T(0)).count();
    FormParts<T> of;
    for (auto* one : {&of.u, &of.v, &of.weight, &of.height}) one->resize(parts);
    Eigen::Index n = 0;
    for (Eigen::Index j = 0; j < down; ++j)
        for (Eigen::Index i = 0; i < across; ++i) {
            if (!(count(j, i) > T(0))) continue;
            of.u[n] = static_cast<T>(2 * i + 1) / static_cast<T>(across) - 1;
            of.v[n] = static_cast<T>(2 * j + 1) / static_cast<T>(down) - 1;
            of.weight[n] = std::sqrt(count(j, i));
            of.height[n] = sum(j, i) / of.weight[n];
            ++n;
        }
    const int smooth = map ? 5 : 6;
    of.add_terms(smooth, map);
    PlainForm<T> found;
    if (!(squares > T(0))) return found;
    found.parabola = removed < 2 ? of.explained(2, 2) / squares : T(0);
    constexpr int angles = 36;
    for (int k = 0; k < (map ? angles : 1); ++k) {
        const auto [gain, at] = of.step(static_cast<T>(k) * std::numbers::pi_v<T> / angles, removed);
        if (!(gain / squares > found.step) || !(gain > of.explained(removed + 1, smooth))) continue;
        found.step = gain / squares, found.along_x = k == 0, found.along_y = 2 * k == angles;
        found.place = found.along_y ? (of.v[at] + 1) / 2 * static_cast<T>(rows) * dy
                                    : (of.u[at] + 1) / 2 * static_cast<T>(columns) * dx;
    }
    return found;
}

/// Form of \p profile, without one of the degree \p removed.
template <Real T>
[[nodiscard]] PlainForm<T> plain_form(const Profile<T>& profile, int removed) {
    const T unit = static_cast<T>(parts::height_scale(profile));
    return plain_form<T>(
        1, static_cast<Eigen::Index>(profile.size()), profile.spacing, T(0), removed,
        [&](Eigen::Index, Eigen::Index i) { return profile.heights[static_cast<std::size_t>(i)] / unit; });
}
/// Same as above for \p map.
template <Real T>
[[nodiscard]] PlainForm<T> plain_form(const HeightMap<T>& map, int removed) {
    const T unit = static_cast<T>(parts::height_scale(map));
    return plain_form<T>(map.rows(), map.columns(), map.dx, map.dy, removed,
                         [&](Eigen::Index j, Eigen::Index i) { return map.heights(j, i) / unit; });
}

}  // namespace fstiff::inline v0_1::detail
