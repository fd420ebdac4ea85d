// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Repair of a profile: spikes become missing points, and missing points are filled.
///
///     d_i = z_i - median(z_i-2, z_i-1, z_i+1, z_i+2);  q_n: z_i beyond both of z_i-n and z_i+n
///     spike: |d_i - median d| > k 1.4826 MAD(d); q_2 or q_3, and q = median(q_4 to q_6), > |d|/2; q_2 > k/6 (q - q_2)
///     fill: the straight line between the nearest points that exist; at the ends the nearest height
///
/// d has the scale of the roughness and not of the form. A wall goes on at one side, a bump or a cusp falls farther.
///
/// Reference   Hampel, J. Am. Stat. Assoc. 69 (1974) 383 (median and MAD)
/// Units       heights [m]; k in standard deviations
/// Valid       k > 0; at least 5 points for spikes, one existing point for filling
/// Accuracy    rounding. k = 5 removes less than 1e-4 of Gaussian and of self-affine roughness
///             (tests/profile/repair_test.cpp)

#include <fstiff/profile/profile.hpp>

#include <algorithm>
#include <vector>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Number of spikes of \p profile beyond \p limit; with \p remove they become missing. \throws domain_error as above.
template <Real T>
math::Repair find_spikes(Profile<T>& profile, std::type_identity_t<T> limit, bool remove = true) {
    require_positive("spikes", limit);
    const std::size_t size = profile.size();
    require(size >= 5, "points of a profile with spikes", size, "at least 5");
    std::vector<T> differences(size, std::numeric_limits<T>::quiet_NaN()), neighbours;
    for (std::size_t i = 0; i < size; ++i) {
        if (std::isnan(profile.heights[i])) continue;
        neighbours.clear();
        for (std::size_t k = i < 2 ? 0 : i - 2; k < (std::min)(size, i + 3); ++k)
            if (k != i && !std::isnan(profile.heights[k])) neighbours.push_back(profile.heights[k]);
        if (neighbours.size() >= 2) differences[i] = profile.heights[i] - math::median(neighbours);
    }
    return math::spikes_among(profile.heights.data(), differences, limit, remove, [&](std::size_t i, T difference) {
        const auto height = [&](std::size_t k) {
            return k < size ? profile.heights[k] : std::numeric_limits<T>::quiet_NaN();
        };
        const auto beyond = [&](std::size_t n) {  // i - n of the first points is beyond the last
            return math::beyond_both(profile.heights[i], height(i - n), height(i + n), std::copysign(T(1), difference));
        };
        const auto exist = [](std::vector<T> heights) {
            std::erase_if(heights, [](T q) { return std::isnan(q); });
            return heights;
        };
        std::vector<T> inner = exist({beyond(2), beyond(3)}), outer = exist({beyond(4), beyond(5), beyond(6)});
        if (inner.empty() || outer.empty()) return true;
        const T most = *std::max_element(inner.begin(), inner.end());
        return most > std::abs(difference) / 2 &&
               math::has_no_foot(inner.front(), math::median(outer), difference, limit);
    });
}

/// Fills the missing points of \p profile. \throws domain_error where every point is missing.
template <Real T>
math::Repair fill_missing(Profile<T>& profile) {
    math::Repair repair;
    const std::size_t size = profile.size();
    std::size_t from = 0;  // of the run of missing points
    for (std::size_t i = 0; i <= size; ++i) {
        if (i < size && std::isnan(profile.heights[i])) continue;
        const std::size_t count = i - from;
        if (count > 0) {
            require(from > 0 || i < size, "points that exist", 0, "at least 1 to fill the others");
            const T before = profile.heights[from > 0 ? from - 1 : i], after = profile.heights[i < size ? i : from - 1];
            for (std::size_t k = from; k < i; ++k) {
                const T share = static_cast<T>(k - from + 1) / static_cast<T>(count + 1);
                profile.heights[k] = (1 - share) * before + share * after;
            }
            repair.missing += count;
            repair.longest = (std::max)(repair.longest, count);
        }
        from = i + 1;
    }
    return repair;
}

}}}  // namespace fstiff::detail
