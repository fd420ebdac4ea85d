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
/// Accuracy    shares 0.02, place of a step along x or y one part (tests/measure/plain_form_test.cpp)

#include <fstiff/math/decompositions.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/topography/height_map.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// A parabola and a step in the heights.
template <Real T = double>
struct PlainForm {
    T parabola{}, step{};       ///< shares of the mean square height
    T place{};                  ///< of a step along x or y [m]
    bool along_x{}, along_y{};  ///< the step is passed along x, along y; neither: at an angle
    bool plateau{};             ///< the heights are a plateau with valleys (math/upper_half.hpp)

    [[nodiscard]] bool is_parabola() const { return parabola > T(0.5) && parabola >= step; }
    /// A parabola bends a plateau, whose roughness is small: its middle or its edges carry first.
    [[nodiscard]] bool is_bow() const { return plateau && parabola > T(0.05) && !is_parabola() && !is_step(); }
    [[nodiscard]] bool is_step() const { return step > T(0.5) && step > parabola; }
};

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Parts of a surface: their terms, orthonormal with the root of their points as weight, and weighted heights.
template <Real T>
struct FormParts {
    using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
    using Columns = Eigen::Map<const Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>>;

    Vector u, v, weight, height;
    std::vector<T> terms;     ///< one after the other
    std::vector<int> degree;  ///< of each term, rising

    /// What the first \p count terms leave of \p f.
    [[nodiscard]] Vector without(const Vector& f, Eigen::Index count) const {
        const Columns columns(terms.data(), f.size(), count);
        const Vector shares = columns.transpose() * f, sum = columns * shares;
        return math::vector_of<T>(f.size(), [&](Eigen::Index i) { return f[i] - sum[i]; });
    }

    /// Orthonormal terms up to \p most; those that the points do not determine are left out.
    void add_terms(int most, bool map) {
        for (int total = 0; total <= most; ++total)
            for (int l = 0; l <= (map ? total : 0); ++l) {
                Vector f(u.size()), of_v(u.size());
                math::raise(u.data(), static_cast<T>(total - l), f.data(), f.size());
                math::raise(v.data(), static_cast<T>(l), of_v.data(), f.size());
                for (Eigen::Index i = 0; i < f.size(); ++i) f[i] = weight[i] * f[i] * of_v[i];
                const T before = std::sqrt(math::dot_in_lanes(f.data(), f.data(), f.size()));
                for (int pass = 0; pass < 2; ++pass) f = without(f, static_cast<Eigen::Index>(degree.size()));
                const T norm = std::sqrt(math::dot_in_lanes(f.data(), f.data(), f.size()));
                if (!(norm > T(1e-4) * before)) continue;
                for (Eigen::Index i = 0; i < f.size(); ++i) terms.push_back(f[i] / norm);
                degree.push_back(total);
            }
    }
    /// Square sum of the heights that the terms of degree \p from to \p to explain.
    [[nodiscard]] T explained(int from, int to) const {
        T sum = 0;
        for (std::size_t k = 0; k < degree.size(); ++k)
            if (degree[k] >= from && degree[k] <= to)
                sum += std::pow(math::dot_in_lanes(&terms[k * static_cast<std::size_t>(height.size())], height.data(),
                                                   height.size()),
                                T(2));
        return sum;
    }
    /// Square sum that a step at the angle \p angle explains beyond the terms up to \p removed, and the part before it.
    [[nodiscard]] std::pair<T, Eigen::Index> step(T angle, int removed) const {
        const auto base = std::count_if(degree.begin(), degree.end(), [&](int term) { return term <= removed; });
        const T across = std::cos(angle), down = std::sin(angle);
        const Vector along = math::vector_of<T>(u.size(), [&](Eigen::Index i) { return u[i] * across + v[i] * down; }),
                     rest = without(height, base);
        std::vector<Eigen::Index> order(static_cast<std::size_t>(u.size()));
        std::iota(order.begin(), order.end(), Eigen::Index(0));
        std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return along[a] < along[b]; });
        Vector shared = Vector::Zero(base);
        T heights = 0, points = 0;
        const T total = math::dot_in_lanes(weight.data(), weight.data(), weight.size());
        std::pair<T, Eigen::Index> best{T(0), 0};
        for (const Eigen::Index index : order) {
            for (Eigen::Index k = 0; k < base; ++k)
                shared[k] += weight[index] * terms[static_cast<std::size_t>(k * u.size() + index)];
            heights += weight[index] * rest[index], points += weight[index] * weight[index];
            if (points < total / 20 || points > total - total / 20) continue;
            const T of_terms = math::dot_in_lanes(shared.data(), shared.data(), base);
            if (const T gain = heights * heights / (points - of_terms); gain > best.first) best = {gain, index};
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
    const T heights = math::sum_in_lanes(sum.data(), sum.size());
    squares -= heights * (heights / math::sum_in_lanes(count.data(), count.size()));
    const auto parts = std::count_if(count.data(), count.data() + count.size(), [](T points) { return points > T(0); });
    FormParts<T> form;
    for (auto* column : {&form.u, &form.v, &form.weight, &form.height}) column->resize(parts);
    Eigen::Index n = 0;
    for (Eigen::Index j = 0; j < down; ++j)
        for (Eigen::Index i = 0; i < across; ++i) {
            if (!(count(j, i) > T(0))) continue;
            form.u[n] = static_cast<T>(2 * i + 1) / static_cast<T>(across) - 1;
            form.v[n] = static_cast<T>(2 * j + 1) / static_cast<T>(down) - 1;
            form.weight[n] = std::sqrt(count(j, i));
            form.height[n] = sum(j, i) / form.weight[n];
            ++n;
        }
    const int smooth = map ? 5 : 6;
    form.add_terms(smooth, map);
    PlainForm<T> result;
    if (!(squares > T(0))) return result;
    result.parabola = removed < 2 ? form.explained(2, 2) / squares : T(0);
    constexpr int angles = 36;
    for (int k = 0; k < (map ? angles : 1); ++k) {
        const auto [gain, index] = form.step(static_cast<T>(k) * std::numbers::pi_v<T> / angles, removed);
        if (!(gain / squares > result.step) || !(gain > form.explained(removed + 1, smooth))) continue;
        result.step = gain / squares, result.along_x = k == 0, result.along_y = 2 * k == angles;
        result.place = result.along_y ? (form.v[index] + 1) / 2 * static_cast<T>(rows) * dy
                                      : (form.u[index] + 1) / 2 * static_cast<T>(columns) * dx;
    }
    return result;
}

/// Form of \p profile, without one of the degree \p removed.
template <Real T>
[[nodiscard]] PlainForm<T> plain_form(const Profile<T>& profile, int removed) {
    const T unit = static_cast<T>(detail::height_scale(profile));
    return plain_form<T>(
        1, static_cast<Eigen::Index>(profile.size()), profile.spacing, T(0), removed,
        [&](Eigen::Index, Eigen::Index i) { return profile.heights[static_cast<std::size_t>(i)] / unit; });
}
/// Same as above for \p map.
template <Real T>
[[nodiscard]] PlainForm<T> plain_form(const HeightMap<T>& map, int removed) {
    const T unit = static_cast<T>(detail::height_scale(map));
    return plain_form<T>(map.rows(), map.columns(), map.dx, map.dy, removed,
                         [&](Eigen::Index j, Eigen::Index i) { return map.heights(j, i) / unit; });
}

}}}  // namespace fstiff::detail
