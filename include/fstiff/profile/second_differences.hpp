// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Structure function of second differences, blind to waves longer than some eight lags.
///
///     S2(n h) = 1/M sum (z_(i+n) - 2 z_i + z_(i-n))^2,  M triples
///             = 4 S(tau) - S(2 tau)  in the mean, (4 - 2^(4-2D)) C tau^(4-2D)  of a power law S = C tau^(4-2D)
///
/// A wave enters S as (1 - cos q tau) and S2 as its square; a tilt and an offset cost nothing.
///
/// Reference   Istas, Lang, Ann. Inst. H. Poincare (B) 33 (1997) 407; Kent, Wood, J. R. Stat. Soc. B 59 (1997) 679
/// Units       lag [m], S2 [m^2]
/// Valid       lags of 1 to (N-1)/2 samples of N points; heights finite or NaN (missing)
/// Accuracy    1e-14 of the sums (tests/profile/second_differences_test.cpp)

#include <fstiff/profile/structure_function.hpp>

namespace fstiff {

/// S2 of \p profile at \p lags (in samples, any order); a lag of which no triple exists is left out. `pairs` counts
/// triples. \throws domain_error as structure_function(), for a lag above (N-1)/2.
template <Real T>
[[nodiscard]] StructureFunction<T> second_differences(const Profile<T>& profile, std::span<const std::size_t> lags) {
    const T scale = 2 * detail::height_scale(profile);  // a second difference is at most four heights
    const T* const z = profile.heights.data();
    return detail::mean_squares(profile, lags, 2, scale, Divisor::pairs, [=](std::size_t i, std::size_t n) {
        return (z[i + 2 * n] - z[i + n]) / scale - (z[i + n] - z[i]) / scale;
    });
}

}  // namespace fstiff
