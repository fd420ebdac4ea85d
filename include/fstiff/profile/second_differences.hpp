// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Structure function of second differences: what a structure function sees without the waves that are much longer than
/// its lag.
///
///     S2(n h) = 1/M sum (z_(i+n) - 2 z_i + z_(i-n))^2,  M triples
///             = 4 S(tau) - S(2 tau)  in the mean, (4 - 2^(4-2D)) C tau^(4-2D)  of a power law S = C tau^(4-2D)
///
/// A wave of the wavelength lambda enters S as (1 - cos q tau) and S2 as (1 - cos q tau)^2: waves longer than some eight
/// lags are not seen, where S bends already at a hundredth of the wavelength at which a spectrum ends or turns flat. A tilt
/// and an offset cost nothing. A smooth profile has S2 ~ tau^4, where S ~ tau^2 cannot be told from D = 1.
///
/// Reference   Istas, Lang, Ann. Inst. H. Poincare (B) 33 (1997) 407; Kent, Wood, J. R. Stat. Soc. B 59 (1997) 679
/// Units       lag [m], S2 [m^2]
/// Valid       lags of 1 to (N-1)/2 samples of N points; heights finite or NaN (missing)
/// Accuracy    the sums to 1e-14 of themselves (tests/profile/second_differences_test.cpp)

#include <fstiff/profile/structure_function.hpp>

namespace fstiff {

/// S2 of \p profile at \p lags (in samples, any order); a lag of which no triple exists is left out. `pairs` counts
/// triples.
/// \throws domain_error as structure_function(), for a lag above (N-1)/2.
template <Real T>
[[nodiscard]] StructureFunction<T> second_differences(const Profile<T>& profile, std::span<const std::size_t> lags) {
    require_positive("spacing", profile.spacing);
    const T scale = 2 * detail::height_scale(profile);  // a second difference is at most four heights
    const std::vector<T>& z = profile.heights;
    const std::size_t points = z.size();
    StructureFunction<T> result;
    for (const std::size_t n : lags) {
        if (n < 1 || 2 * n >= points)
            detail::refuse("lag", std::to_string(n) + " samples",
                           "between 1 and " + std::to_string(points > 0 ? (points - 1) / 2 : 0));
        // sums of short runs are added up, so that rounding does not grow with the number of points
        constexpr std::size_t run = 512;
        Accumulator<T> sum = 0;
        std::size_t triples = 0;
        for (std::size_t start = n; start < points - n; start += run) {
            const std::size_t end = (std::min)(start + run, points - n);
            Accumulator<T> part = 0;
            for (std::size_t i = start; i < end; ++i) {
                const T difference = (z[i + n] - z[i]) / scale - (z[i] - z[i - n]) / scale;
                if (std::isnan(difference)) continue;
                part += static_cast<Accumulator<T>>(difference) * difference;
                ++triples;
            }
            sum += part;
        }
        if (triples == 0) continue;
        result.step.push_back(n);
        result.lag.push_back(static_cast<T>(n) * profile.spacing);
        result.value.push_back(detail::mean_square<T>(sum, static_cast<Accumulator<T>>(triples), scale));
        result.pairs.push_back(triples);
    }
    return result;
}

}  // namespace fstiff
