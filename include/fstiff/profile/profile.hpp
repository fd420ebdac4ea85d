// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// A measured profile: heights at equal spacing, some of which may be missing.
///
/// Units       heights and spacing [m]
/// Valid       spacing > 0; every height finite, or NaN where the point is missing

#include <fstiff/core/error.hpp>
#include <fstiff/core/names.hpp>
#include <fstiff/math/round_fit.hpp>
#include <fstiff/math/rounding.hpp>
#include <fstiff/math/tukey.hpp>

#include <algorithm>
#include <vector>

namespace fstiff { inline namespace v0_1 {

/// A profile in SI units. Its mean and rms are over the points that exist.
template <Real T = double>
struct Profile {
    std::vector<T> heights;  ///< z(i spacing) [m]; NaN marks a missing point
    T spacing{};             ///< between neighbours [m]

    /// Number of points, including missing ones.
    [[nodiscard]] std::size_t size() const { return heights.size(); }

    /// Number of points that are not missing.
    [[nodiscard]] std::size_t present() const {
        return static_cast<std::size_t>(
            std::count_if(heights.begin(), heights.end(), [](T z) { return !std::isnan(z); }));
    }

    /// Length from the first point to the last [m]; 0 for an empty profile.
    [[nodiscard]] T length() const { return heights.empty() ? T(0) : static_cast<T>(heights.size() - 1) * spacing; }

    /// \throws domain_error unless the spacing is positive, no height infinite, at least \p least points exist and they
    /// are not all of one height.
    void validate(std::size_t least = 16) const {
        detail::require_positive("spacing", spacing);
        bool varies = false;
        std::size_t count = 0;
        T first{};
        for (const T z : heights) {
            if (std::isnan(z)) continue;
            detail::require(std::abs(z) <= (std::numeric_limits<T>::max)(), "height", z,
                            "finite, or NaN for a missing point");
            if (count++ == 0) first = z;
            varies = varies || z != first;
        }
        if (count < least)
            throw domain_error("profile has " + std::to_string(count) + " points: must be at least " +
                               std::to_string(least));
        detail::require(varies, "profile of constant height", first, "of varying height");
    }
};

namespace detail {

/// Mean of the heights that exist [m]. \throws domain_error when there is none.
template <Real T>
[[nodiscard]] T mean_height(const Profile<T>& profile) {
    math::CompensatedSum<double> sum;
    std::size_t count = 0;
    for (const T z : profile.heights)
        if (!std::isnan(z)) {
            sum.add(z);
            ++count;
        }
    if (count == 0) throw domain_error("profile has 0 points: must be at least 1");
    return static_cast<T>(sum.value() / static_cast<double>(count));
}

}  // namespace detail

/// Rq: root of the mean square of the heights about their mean [m]. \throws domain_error when no point exists.
template <Real T>
[[nodiscard]] T rms_height(const Profile<T>& profile) {
    const T mean = detail::mean_height(profile);
    T largest = 0;  // scaled by, so that no square leaves the range of numbers
    for (const T z : profile.heights)
        if (!std::isnan(z)) largest = (std::max)(largest, std::abs(z - mean));
    if (largest == T(0)) return T(0);
    math::CompensatedSum<double> squares, firsts;
    std::size_t count = 0;
    for (const T z : profile.heights)
        if (!std::isnan(z)) {
            const double scaled = (z - mean) / largest;
            squares.add(scaled * scaled);
            firsts.add(scaled);
            ++count;
        }
    const auto n = static_cast<double>(count);
    const auto offset = firsts.value() / n;  // residual of the rounding of the mean
    return largest * static_cast<T>(std::sqrt(squares.value() / n - offset * offset));
}

}}  // namespace fstiff
