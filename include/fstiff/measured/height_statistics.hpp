// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Distribution and gradient of the heights of a measured surface, which decide which contact law is valid.
///
///     skewness = <(z - <z>)^3>/sigma^3       kurtosis = <(z - <z>)^4>/sigma^4      0 and 3 for Gaussian heights
///     m0 = sigma^2,  m2 = <slope^2>,  m4 = <curvature^2>                            along a line, by neighbours
///     alpha = m0 m4/m2^2                     rms gradient g = sqrt(2 m2)           for an isotropic surface
///
/// For a map the moments are means of those along x and y, and g^2 is the sum of both mean square slopes. The errors
/// are those of a jackknife that leaves out one of 16 blocks of a profile, or tiles of a map, at a time.
///
/// Reference   ISO 25178-2 (Ssk, Sku, Sdq), ISO 21920-2 (Rsk, Rku); Nayak, J. Lubr. Technol. 93 (1971) 398; Efron, The
///             Jackknife (SIAM, 1982).
/// Units       heights [m], m2, g, skewness and kurtosis dimensionless, m4 [1/m^2]
/// Valid       form removed before; at least 64 points with triples of neighbours
/// Accuracy    1e-12 of plain sums (tests/measured/height_statistics_test.cpp)

#include <fstiff/measured/surface_parameters.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/topography/height_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>

namespace fstiff::inline v0_1 {

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
    HeightPowers<T> whole;
    for (const auto& block : sums) whole += block;
    require(whole.triples >= 16 && whole.points >= 64, "points of a surface", static_cast<long long>(whole.points),
            "at least 64, with 16 triples of neighbours");
    const auto measured = [&](T (HeightPowers<T>::*of)() const, T scale) {
        std::array<T, blocks> without{};
        T mean = 0, square = 0;
        std::size_t used = 0;
        for (const auto& block : sums) {
            if (!(block.pairs > 0)) continue;
            without[used] = ((whole - block).*of)();
            mean += without[used++];
        }
        mean /= static_cast<T>(used);
        for (std::size_t i = 0; i < used; ++i) square += (without[i] - mean) * (without[i] - mean);
        const T n = static_cast<T>(used);
        return Measurement<T>{scale * (whole.*of)(), scale * std::sqrt((n - 1) / n * square)};
    };
    HeightStatistics<T> out;
    out.skewness = measured(&HeightPowers<T>::skewness, T(1));
    out.kurtosis = measured(&HeightPowers<T>::kurtosis, T(1));
    out.rms_gradient = measured(&HeightPowers<T>::gradient, rms);
    out.moments = {whole.variance() * rms * rms, whole.slopes / whole.pairs * rms * rms,
                   whole.bends / whole.triples * rms * rms};
    return out;
}

}  // namespace detail

/// Statistics of \p profile as a section of an isotropic surface. \throws domain_error for a profile out of range.
template <Real T>
[[nodiscard]] HeightStatistics<T> height_statistics(const Profile<T>& profile) {
    profile.validate(16);
    const T mean = parts::mean_height(profile), rms = rms_height(profile);
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
    const T mean = parts::mean_height(map), rms = rms_height(map);
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

}  // namespace fstiff::inline v0_1
