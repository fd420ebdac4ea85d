// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Skewness and kurtosis of a surface, reduced by their uncertainty, for the bearing curve of the hybrid contact law.
///
///     D^2   = <(z/sigma - zeta)^2>,  zeta = Phi^-1((rank + 1/2)/N)           departure from Gaussian heights
///     n     = N/(1 + 2 sum_k (A(k) pairs_k/N)^2)    independent heights; for a map the product of the means along x, y
///     share = max(0, 1 - 0.8/(n D^2))               factor of skewness and of kurtosis - 3
///
/// Skewness 0 and kurtosis 3 where neither differs from these values by more than two standard errors.
/// Derivation  docs/theory.md, section 2
/// Reference   Bartlett, J. R. Stat. Soc. Suppl. 8 (1946) 27 (n); share: this project (docs/validation.md)
/// Units       heights [m]; all else dimensionless
/// Valid       form removed before, at least 16 points; missing points are left out
/// Accuracy    1e-12 of the formulae (tests/measured/height_shape_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/measured/height_statistics.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/surface/bearing_family.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace fstiff::inline v0_1::parts {

/// Skewness and kurtosis of heights; the default is a Gaussian surface.
template <Real T = double>
struct HeightShape {
    T skewness = 0, kurtosis = 3;

    [[nodiscard]] bool is_gaussian() const { return skewness == 0 && kurtosis == 3; }
};

/// Shape with \p share of \p skewness and of \p kurtosis - 3. The skewness is limited to 2 and the kurtosis to 10, the
/// range of the maps that were compared, because spikes cause larger values; both are valid for bearing_of_moments.
template <Real T>
[[nodiscard]] HeightShape<T> counted_shape(T skewness, T kurtosis, T share) {
    const T s = std::clamp(share * skewness, T(-2), T(2));
    return {s, std::clamp(3 + share * (kurtosis - 3), least_kurtosis(s), T(10))};
}

/// Shape of \p measured heights: Gaussian unless skewness or kurtosis departs by two standard errors.
template <Real T>
[[nodiscard]] HeightShape<T> counted_shape(const HeightStatistics<T>& measured, T share) {
    const auto departs = [](const Measurement<T>& one, T gaussian) {
        return std::abs(one.value - gaussian) > 2 * one.error;
    };
    if (!departs(measured.skewness, T(0)) && !departs(measured.kurtosis, T(3))) return {};
    return counted_shape(measured.skewness.value, measured.kurtosis.value, share);
}

/// Shape of the sum of two faces with the mean square heights \p m0_a and \p m0_b and independent heights: cumulants
/// add.
template <Real T>
[[nodiscard]] HeightShape<T> sum_of_shapes(const HeightShape<T>& a, T m0_a, const HeightShape<T>& b, T m0_b) {
    const T of_a = m0_a / (m0_a + m0_b), of_b = m0_b / (m0_a + m0_b);
    return {of_a * std::sqrt(of_a) * a.skewness + of_b * std::sqrt(of_b) * b.skewness,
            3 + of_a * of_a * (a.kurtosis - 3) + of_b * of_b * (b.kurtosis - 3)};
}

/// Number n of independent heights of \p profile, at most its number of points.
/// \throws domain_error as autocorrelation.
template <Real T>
[[nodiscard]] T independent_points(const Profile<T>& profile) {
    const Autocorrelation<T> of = autocorrelation(profile);
    const auto points = static_cast<T>(profile.present());
    T lags = 1;
    for (std::size_t k = 1; k < of.size(); ++k) {
        if (std::isnan(of.value[k])) continue;
        const T A = of.value[k] * static_cast<T>(of.pairs[k]) / points;  // few pairs at long lags scatter
        lags += 2 * A * A;
    }
    return points / lags;
}

/// Heights of one surface, from one or several traces or maps.
template <Real T = double>
class ShapeOfHeights {
public:
    /// \throws domain_error as independent_points.
    void add(const Profile<T>& profile) {
        points_ += parts::independent_points(profile);
        add_heights(profile.heights);
    }
    /// \throws domain_error as HeightMap::validate.
    void add(const HeightMap<T>& map) {
        map.validate();
        points_ += along(map.rows(), [&](Eigen::Index j) { return Heights(map.heights.row(j)); }) *
                   along(map.columns(), [&](Eigen::Index i) { return Heights(map.heights.col(i)); });
        add_heights({map.heights.data(), static_cast<std::size_t>(map.size())});
    }
    /// n of all heights added.
    [[nodiscard]] T independent_points() const { return points_; }
    /// D^2; 0 for fewer than 16 heights, or for equal heights.
    [[nodiscard]] T departure() const {
        std::vector<T> z = heights_;
        std::sort(z.begin(), z.end());
        const auto count = static_cast<T>(z.size());
        T square = 0, product = 0, scores = 0;
        for (std::size_t from = 0, to = 0; from < z.size(); from = to) {
            while (to < z.size() && z[to] == z[from]) ++to;
            const auto equal = static_cast<T>(to - from);
            const T score = math::normal_quantile((static_cast<T>(from) + static_cast<T>(to)) / (2 * count));
            square += equal * z[from] * z[from], product += equal * z[from] * score, scores += equal * score * score;
        }
        if (z.size() < 16 || !(square > 0)) return 0;
        const T sigma = std::sqrt(square / count);
        return (std::max)(T(0), 1 - 2 * product / (sigma * count) + scores / count);
    }
    /// Factor of skewness and of kurtosis - 3, from 0 to 1.
    [[nodiscard]] T share() const {
        const T known = points_ * departure();
        return known > by_chance ? 1 - by_chance / known : T(0);
    }

private:
    using Heights = Eigen::Array<T, Eigen::Dynamic, 1>;
    static constexpr T by_chance = T(0.8);  ///< of n D^2

    /// Mean n of 16 of \p count lines, without lines that are too short or flat.
    template <class Line>
    [[nodiscard]] static T along(Eigen::Index count, const Line& line) {
        T sum = 0, lines = 0;
        const Eigen::Index every = (std::max)(count / 16, Eigen::Index(1));
        for (Eigen::Index k = 0; k < count; k += every) {
            const Heights z = line(k);
            Profile<T> profile{std::vector<T>(z.data(), z.data() + z.size()), T(1)};
            if (profile.present() < 16 || !(rms_height(profile) > 0)) continue;
            sum += parts::independent_points(profile), lines += 1;
        }
        return lines > 0 ? sum / lines : T(1);
    }
    /// Heights minus their own mean.
    void add_heights(std::span<const T> heights) {
        T mean = 0, present = 0;
        for (const T z : heights)
            if (!std::isnan(z)) mean += z, present += 1;
        for (const T z : heights)
            if (!std::isnan(z)) heights_.push_back(z - mean / present);
    }

    T points_ = 0;
    std::vector<T> heights_;
};

}  // namespace fstiff::inline v0_1::parts
