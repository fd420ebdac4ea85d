// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The plane on which a plateau with valleys rests: through the points above the median, in place of least squares over
/// all points, which follow the valleys and leave the plateau askew.
///
///     z -= form through { z > median z }, until the form no longer changes, where the skewness is below -0.5
///
/// Two faces settle where they touch. Of 20 maps with a skewness below -0.5 K of the plane of least squares is 0.25 to
/// 1.03 of the truth, that of this plane 0.95 to 1.10.
///
/// Reference   this project; docs/theory-surface.md
/// Units       heights of any unit
/// Valid       heights whose least-squares form of the same degree is gone; NaN: missing, stays missing
/// Accuracy    of a plateau with flat valleys the plane of the plateau to rounding (tests/math/upper_half_test.cpp)

#include <fstiff/core/numbers.hpp>
#include <fstiff/math/decompositions.hpp>
#include <fstiff/math/rounding.hpp>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace math {

/// Skewness below which heights are a plateau with valleys.
inline constexpr double plateau_skewness = -0.5;

/// Skewness of the \p heights that exist, about their mean; 0 where they are equal.
template <Real T>
[[nodiscard]] double skewness_of(const std::vector<T>& heights) {
    double mean = 0, square = 0, cube = 0;
    for (const T z : heights) mean += static_cast<double>(z);
    mean /= static_cast<double>(heights.size());
    for (const T height : heights) {
        const double z = static_cast<double>(height) - mean;
        square += z * z, cube += z * z * z;
    }
    return square > 0 ? cube * std::sqrt(static_cast<double>(heights.size()) / square) / square : 0;
}

/// The heights that exist on a grid of \p rows by \p columns points, and polynomials at their places.
class UpperHalf {
public:
    /// \p there: the heights of \p z that exist, in their order. \p degree is 1 or 2; of one row along it alone.
    template <Real T>
    UpperHalf(const T* z, Eigen::Index rows, Eigen::Index columns, int degree, std::vector<double> there)
        : terms_(rows > 1 ? (degree == 1 ? 3 : 6) : degree + 1), heights_(std::move(there)) {
        const auto place = [](Eigen::Index i, Eigen::Index count) {
            return count > 1 ? 2 * static_cast<double>(i) / static_cast<double>(count - 1) - 1 : 0.0;
        };
        places_.reserve(heights_.size());
        for (Eigen::Index j = 0; j < rows; ++j)
            for (Eigen::Index i = 0; i < columns; ++i)
                if (!std::isnan(z[j * columns + i])) places_.push_back({place(i, columns), place(j, rows)});
        is_line_ = rows == 1;
    }

    /// One step: the polynomial through the heights above the median is gone. \return its coefficients; none where the
    /// points do not determine it, as of a plateau of one height.
    std::optional<Eigen::VectorXd> settle() {
        std::vector<double> sorted = heights_;
        const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(terms_, terms_);
        Eigen::VectorXd moments = Eigen::VectorXd::Zero(terms_);
        double upper = 0;
        for (std::size_t k = 0; k < heights_.size(); ++k) {
            if (!(heights_[k] > *middle)) continue;
            const std::array<double, 6> f = at(k);
            upper += 1;
            for (Eigen::Index s = 0; s < terms_; ++s) {
                moments[s] += f[static_cast<std::size_t>(s)] * heights_[k];
                for (Eigen::Index t = 0; t <= s; ++t)
                    normal(s, t) += f[static_cast<std::size_t>(s)] * f[static_cast<std::size_t>(t)];
            }
        }
        for (Eigen::Index s = 0; s < terms_; ++s)
            for (Eigen::Index t = 0; t < s; ++t) normal(t, s) = normal(s, t);
        const PivotedQr<double> solver(normal / (std::max)(upper, 1.0), 1e-12);
        if (solver.rank() < terms_) return std::nullopt;
        const Eigen::VectorXd c = solver.solve(moments / upper);
        for (std::size_t k = 0; k < heights_.size(); ++k) {
            const std::array<double, 6> f = at(k);
            for (Eigen::Index s = 0; s < terms_; ++s) heights_[k] -= c[s] * f[static_cast<std::size_t>(s)];
        }
        return c;
    }

    [[nodiscard]] std::vector<double>& heights() { return heights_; }

private:
    [[nodiscard]] std::array<double, 6> at(std::size_t k) const {
        const auto [u, v] = places_[k];
        const double bend = 1.5 * u * u - 0.5;
        if (is_line_) return {1, u, bend};
        return {1, u, v, bend, u * v, 1.5 * v * v - 0.5};
    }

    Eigen::Index terms_;
    bool is_line_ = false;
    std::vector<double> heights_;
    std::vector<std::array<double, 2>> places_{};  ///< from -1 to 1
};

/// Removes from the \p rows times \p columns heights \p z the polynomial of \p degree 1 or 2 through the upper half, if
/// they are a plateau with valleys; their mean is 0 then. Heights of one row vary along it alone.
/// \return the tilt of what was removed along the rows and along the columns, last point less first; none: no plateau.
template <Real T>
std::optional<std::array<T, 2>> settle_on_upper_half(T* z, Eigen::Index rows, Eigen::Index columns, int degree) {
    constexpr int most_passes = 12;
    const Eigen::Index size = rows * columns;
    T largest = 0;
    for (Eigen::Index k = 0; k < size; ++k)
        if (!std::isnan(z[k])) largest = (std::max)(largest, std::abs(z[k]));
    const double unit = power_of_two_below(static_cast<double>(largest));  // so that no power leaves the range
    std::vector<double> there;
    for (Eigen::Index k = 0; k < size; ++k)
        if (!std::isnan(z[k])) there.push_back(static_cast<double>(z[k]) / unit);
    if (there.empty() || !(skewness_of(there) < plateau_skewness)) return std::nullopt;

    double square = 0;
    for (const double height : there) square += height * height;
    const double rms = std::sqrt(square / static_cast<double>(there.size()));
    UpperHalf half(z, rows, columns, degree, std::move(there));
    std::array<double, 2> tilt{};
    for (int pass = 0; pass < most_passes; ++pass) {
        const std::optional<Eigen::VectorXd> c = half.settle();
        if (!c) break;
        tilt[0] += 2 * (*c)[1], tilt[1] += rows > 1 ? 2 * (*c)[2] : 0;
        if (c->tail(c->size() - 1).cwiseAbs().maxCoeff() < 1e-9 * rms) break;
    }
    double mean = 0;
    for (const double height : half.heights()) mean += height;
    mean /= static_cast<double>(half.heights().size());
    auto next = half.heights().begin();
    for (Eigen::Index k = 0; k < size; ++k)
        if (!std::isnan(z[k])) z[k] = static_cast<T>((*next++ - mean) * unit);
    return std::array{static_cast<T>(tilt[0] * unit), static_cast<T>(tilt[1] * unit)};
}

}}}  // namespace fstiff::math
