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
/// Derivation  docs/theory-surface.md
/// Reference   Bartlett, J. R. Stat. Soc. Suppl. 8 (1946) 27 (n); share: this project (docs/validation.md)
/// Units       heights [m]; all else dimensionless
/// Valid       form removed before, at least 16 points; missing points are left out
/// Accuracy    1e-12 of the formulae (tests/measure/height_shape_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/math/normal_distribution.hpp>
#include <fstiff/math/statistics.hpp>
#include <fstiff/measure/parameters.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/roughness_parameters.hpp>
#include <fstiff/surface/bearing_of_core.hpp>
#include <fstiff/surface/material_ratio.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/topography/height_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

// Distribution and gradient of the heights of a measured surface, which decide which contact law is valid.
//
//     skewness = <(z - <z>)^3>/sigma^3       kurtosis = <(z - <z>)^4>/sigma^4      0 and 3 for Gaussian heights
//     m0 = sigma^2,  m2 = <slope^2>,  m4 = <curvature^2>                            along a line, by neighbours
//     alpha = m0 m4/m2^2                     rms gradient g = sqrt(2 m2)           for an isotropic surface
//
// For a map the moments are means of those along x and y, and g^2 is the sum of both mean square slopes. The errors
// are those of a jackknife that leaves out one of 16 blocks of a profile, or tiles of a map, at a time.
//
// Reference   ISO 25178-2 (Ssk, Sku, Sdq), ISO 21920-2 (Rsk, Rku); Nayak, J. Lubr. Technol. 93 (1971) 398; Efron, The
//             Jackknife (SIAM, 1982).
// Units       heights [m], m2, g, skewness and kurtosis dimensionless, m4 [1/m^2]
// Valid       form removed before; at least 64 points with triples of neighbours
// Accuracy    1e-12 of plain sums (tests/measure/height_statistics_test.cpp)

namespace fstiff { inline namespace v0_1 {

/// Skewness, kurtosis, gradient and moments of a surface; the first three have standard errors.
template <Real T = double>
struct HeightStatistics {
    Measurement<T> skewness, kurtosis, rms_gradient;
    SpectralMoments<T> moments{};
};

namespace detail {

/// Sums over heights in units of their rms, and over differences of neighbours.
template <Real T>
struct HeightPowers {
    T points{}, first{}, second{}, third{}, fourth{};
    T pairs{}, slopes{}, triples{}, bends{};  // along x and y, squares

    void add_height(T z) { points += 1, first += z, second += z * z, third += z * z * z, fourth += z * z * z * z; }
    /// Adds three consecutive heights \p a, \p b, \p c at the distance \p h; NaN where missing.
    void add_neighbours(T a, T b, T c, T h) {
        const T slope = (b - a) / h, next = (c - b) / h;
        if (std::isnan(slope)) return;
        pairs += 1, slopes += slope * slope;
        if (std::isnan(next)) return;
        const T bend = (next - slope) / h;
        triples += 1, bends += bend * bend;
    }
    HeightPowers& operator+=(const HeightPowers& o) {
        points += o.points, first += o.first, second += o.second, third += o.third, fourth += o.fourth;
        pairs += o.pairs, slopes += o.slopes, triples += o.triples, bends += o.bends;
        return *this;
    }
    HeightPowers operator-(const HeightPowers& o) const {
        return {points - o.points, first - o.first,   second - o.second,   third - o.third, fourth - o.fourth,
                pairs - o.pairs,   slopes - o.slopes, triples - o.triples, bends - o.bends};
    }
    [[nodiscard]] T mean() const { return first / points; }
    [[nodiscard]] T variance() const { return second / points - mean() * mean(); }
    [[nodiscard]] T skewness() const {
        const T m = mean(), v = variance();
        return (third / points - 3 * m * second / points + 2 * m * m * m) / (v * std::sqrt(v));
    }
    [[nodiscard]] T kurtosis() const {
        const T m = mean(), v = variance();
        return (fourth / points - 4 * m * third / points + 6 * m * m * second / points - 3 * m * m * m * m) / (v * v);
    }
    [[nodiscard]] T gradient() const { return std::sqrt(2 * slopes / pairs); }
};

/// Statistics from the sums of \p blocks of a surface whose heights were divided by \p rms.
template <Real T, std::size_t blocks>
[[nodiscard]] HeightStatistics<T> statistics_of(const std::array<HeightPowers<T>, blocks>& sums, T rms) {
    HeightPowers<T> total;
    for (const auto& block : sums) total += block;
    require(total.triples >= 16 && total.points >= 64, "points of a surface", static_cast<long long>(total.points),
            "at least 64, with 16 triples of neighbours");
    const auto measured = [&](T (HeightPowers<T>::*statistic)() const, T scale) {
        std::array<T, blocks> left_out{};
        T mean = 0, square = 0;
        std::size_t used = 0;
        for (const auto& block : sums) {
            if (!(block.pairs > 0)) continue;
            left_out[used] = ((total - block).*statistic)();
            mean += left_out[used++];
        }
        mean /= static_cast<T>(used);
        for (std::size_t i = 0; i < used; ++i) square += (left_out[i] - mean) * (left_out[i] - mean);
        const T n = static_cast<T>(used);
        return Measurement<T>{scale * (total.*statistic)(), scale * std::sqrt((n - 1) / n * square)};
    };
    HeightStatistics<T> out;
    out.skewness = measured(&HeightPowers<T>::skewness, T(1));
    out.kurtosis = measured(&HeightPowers<T>::kurtosis, T(1));
    out.rms_gradient = measured(&HeightPowers<T>::gradient, rms);
    out.moments = {total.variance() * rms * rms, total.slopes / total.pairs * rms * rms,
                   total.bends / total.triples * rms * rms};
    return out;
}

}  // namespace detail

/// Statistics of \p profile as a section of an isotropic surface. \throws domain_error for a profile out of range.
template <Real T>
[[nodiscard]] HeightStatistics<T> height_statistics(const Profile<T>& profile) {
    profile.validate(16);
    const T mean = detail::mean_height(profile), rms = rms_height(profile);
    const std::vector<T>& z = profile.heights;
    std::array<detail::HeightPowers<T>, 16> sums{};
    const auto height = [&](std::size_t i) {
        return i < z.size() ? (z[i] - mean) / rms : std::numeric_limits<T>::quiet_NaN();
    };
    for (std::size_t i = 0; i < z.size(); ++i) {
        auto& block = sums[i * 16 / z.size()];
        if (!std::isnan(z[i])) block.add_height(height(i));
        block.add_neighbours(height(i), height(i + 1), height(i + 2), profile.spacing);
    }
    return detail::statistics_of(sums, rms);
}

/// Statistics of \p map. \throws domain_error for a map out of range.
template <Real T>
[[nodiscard]] HeightStatistics<T> height_statistics(const HeightMap<T>& map) {
    map.validate();
    const T mean = detail::mean_height(map), rms = rms_height(map);
    const Eigen::Index rows = map.rows(), columns = map.columns();
    std::array<detail::HeightPowers<T>, 16> sums{};
    const auto height = [&](Eigen::Index j, Eigen::Index i) {
        return j < rows && i < columns ? (map.heights(j, i) - mean) / rms : std::numeric_limits<T>::quiet_NaN();
    };
    for (Eigen::Index j = 0; j < rows; ++j)
        for (Eigen::Index i = 0; i < columns; ++i) {
            auto& tile = sums[static_cast<std::size_t>(j * 4 / rows * 4 + i * 4 / columns)];
            const T z = height(j, i);
            if (!std::isnan(z)) tile.add_height(z);
            tile.add_neighbours(z, height(j, i + 1), height(j, i + 2), map.dx);
            tile.add_neighbours(z, height(j + 1, i), height(j + 2, i), map.dy);
        }
    return detail::statistics_of(sums, rms);
}

}}  // namespace fstiff

namespace fstiff { inline namespace v0_1 { namespace detail {

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
    const auto departs = [](const Measurement<T>& measurement, T gaussian) {
        return std::abs(measurement.value - gaussian) > 2 * measurement.error;
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

/// Number n of independent heights of a profile with the autocorrelation \p acf, at most its number of points.
template <Real T>
[[nodiscard]] T independent_points(const Autocorrelation<T>& acf) {
    const auto points = static_cast<T>(acf.pairs.front());
    T lags = 1;
    for (std::size_t k = 1; k < acf.size(); ++k) {
        if (std::isnan(acf.value[k])) continue;
        const T A = acf.value[k] * static_cast<T>(acf.pairs[k]) / points;  // few pairs at long lags scatter
        lags += 2 * A * A;
    }
    return points / lags;
}

/// Heights of one surface, from one or several traces or maps.
template <Real T = double>
class ShapeOfHeights {
public:
    /// Adds \p profile with the autocorrelation \p acf.
    void add(const Profile<T>& profile, const Autocorrelation<T>& acf) {
        points_ += detail::independent_points(acf);
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
    [[nodiscard]] T departure() {
        std::vector<T>& z = heights_;
        math::sort_falling<T>(z, [](T height) { return height; });
        std::reverse(z.begin(), z.end());
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
    [[nodiscard]] T share() {
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
            sum += detail::independent_points(autocorrelation(profile)), lines += 1;
        }
        return lines > 0 ? sum / lines : T(1);
    }
    /// Heights minus their own mean.
    void add_heights(std::span<const T> heights) {
        T mean = 0, present = 0;
        for (const T z : heights)
            if (!std::isnan(z)) mean += z, present += 1;
        heights_.reserve(heights_.size() + static_cast<std::size_t>(present));
        for (const T z : heights)
            if (!std::isnan(z)) heights_.push_back(z - mean / present);
    }

    T points_ = 0;
    std::vector<T> heights_;  // rising once departure() was asked for
};

}}}  // namespace fstiff::detail
