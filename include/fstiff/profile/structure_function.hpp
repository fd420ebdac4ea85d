// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Structure function of a profile at chosen lags, of its heights and of their second differences.
///
///     S(n h)  = mean of (z_(i+n) - z_i)^2 over the pairs that exist                 eq. (2.8)
///     S2(n h) = mean of (z_(i+n) - 2 z_i + z_(i-n))^2 over the triples that exist
///             = 4 S(tau) - S(2 tau)  in the mean, (4 - 2^(4-2D)) C tau^(4-2D)  for a power law S = C tau^(4-2D)
///
/// Divisor::paper divides by pairs - 1, as (2.8) does. S2 does not depend on a tilt: docs/theory-surface.md.
/// Reference   Buczkowski et al., Arch. Mech. 66 (2014), eq. (2.8), docs/errata.md; Istas, Lang, Ann. Inst. H.
///             Poincare (B) 33 (1997) 407; Kent, Wood, J. R. Stat. Soc. B 59 (1997) 679
/// Units       lag [m], S, S2 [m^2]
/// Valid       lags of 1 to N-1 samples (S2: (N-1)/2), enough pairs for the divisor; heights finite or NaN (missing)
/// Accuracy    1e-13 in double for 2^16 points, offset up to 1e6 times the roughness
///             (tests/profile/structure_function_test.cpp, tests/profile/second_differences_test.cpp)

#include <fstiff/math/statistics.hpp>
#include <fstiff/profile/profile.hpp>

#include <span>

namespace fstiff { inline namespace v0_1 {

/// A range of lags or wavelengths [m], both ends included.
template <Real T = double>
struct LengthRange {
    T from{}, to{};
};

/// S at some lags; all vectors have one length. A lag without a pair is left out.
template <Real T = double>
struct StructureFunction {
    std::vector<std::size_t> step;   ///< lag in samples
    std::vector<T> lag;              ///< [m]
    std::vector<T> value;            ///< S [m^2]
    std::vector<std::size_t> pairs;  ///< that were averaged

    [[nodiscard]] std::size_t size() const { return lag.size(); }
};

/// Divisor of the sum of (2.8).
enum class Divisor { pairs, paper };

namespace detail {

/// Lags 1, 2, 3, ... \p longest, thinned to \p per_octave steps an octave where they are denser.
[[nodiscard]] inline std::vector<std::size_t> logarithmic_lags(std::size_t longest, std::size_t per_octave = 12) {
    std::vector<std::size_t> lags;
    const double octave = static_cast<double>(std::max<std::size_t>(per_octave, 1));
    for (std::size_t k = 0;; ++k) {
        const double exact = std::exp2(static_cast<double>(k) / octave);
        if (!(exact < static_cast<double>(longest) + 0.5)) break;
        const auto lag = static_cast<std::size_t>(std::lround(exact));
        if (lag <= longest && (lags.empty() || lag > lags.back())) lags.push_back(lag);
    }
    return lags;
}

}  // namespace detail

/// S of \p profile at logarithmic_lags up to a quarter of its points. \throws domain_error as above.
template <Real T>
[[nodiscard]] StructureFunction<T> structure_function(const Profile<T>& profile, Divisor divisor = Divisor::pairs) {
    return structure_function(profile, std::span<const std::size_t>(detail::logarithmic_lags(profile.size() / 4)),
                              divisor);
}

namespace detail {

/// Power of two near the largest height: squares of scaled heights stay in range, and scaling is exact.
template <Real T>
T height_scale(const Profile<T>& profile) {
    T low = (std::numeric_limits<T>::max)(), high = std::numeric_limits<T>::lowest();
    for (const T z : profile.heights) {
        if (std::isnan(z)) continue;
        require(std::abs(z) <= (std::numeric_limits<T>::max)(), "height", z, "finite, or NaN for a missing point");
        low = (std::min)(low, z);
        high = (std::max)(high, z);
    }
    return low < high ? math::power_of_two_below(high / 2 - low / 2) : T(1);  // a range that cannot overflow
}

/// Divisor of the sum over \p pairs.
constexpr std::size_t divided_by(std::size_t pairs, Divisor divisor) {
    return divisor == Divisor::paper && pairs > 0 ? pairs - 1 : pairs;
}

/// Mean of the squares of differences from their \p sum, with heights in units of \p scale.
template <Real T>
T mean_square(double sum, double count, double scale) {
    const T value = static_cast<T>(sum / count * scale * scale);
    require(sum == 0 || (value >= (std::numeric_limits<T>::min)() && value <= (std::numeric_limits<T>::max)()),
            "structure function", value, "a number of normal size: these heights are too large or too small");
    return value;
}

/// Mean squares of \p difference(i, n), of heights in units of \p scale, at the lags n, i from 0 to N - \p reach n.
template <Real T, class Difference>
StructureFunction<T> mean_squares(const Profile<T>& profile, std::span<const std::size_t> lags, std::size_t reach,
                                  T scale, Divisor divisor, const Difference& difference) {
    require_positive("spacing", profile.spacing);
    const std::size_t points = profile.size();
    const bool complete = profile.present() == points;
    StructureFunction<T> result;
    for (const std::size_t n : lags) {
        if (n < 1 || reach * n >= points)
            refuse("lag", std::to_string(n) + " samples",
                   "between 1 and " + std::to_string(points > 0 ? (points - 1) / reach : 0));
        // sums of short runs are added up, so that rounding does not grow with the number of points
        double sum = 0;
        std::size_t pairs = points - reach * n;
        const auto square = [&](std::size_t i) {
            const T rise = difference(i, n);
            if (complete || !std::isnan(rise)) return static_cast<double>(rise) * rise;
            --pairs;
            return 0.0;
        };
        math::sum_runs<double>(0, points - reach * n, 512, square, [&](double part) { sum += part; });
        const std::size_t count = divided_by(pairs, divisor);
        if (count == 0) continue;
        result.step.push_back(n);
        result.lag.push_back(static_cast<T>(n) * profile.spacing);
        result.value.push_back(mean_square<T>(sum, static_cast<double>(count), scale));
        result.pairs.push_back(pairs);
    }
    return result;
}

}  // namespace detail

/// S of \p profile at \p lags (in samples, any order). \throws domain_error for a lag outside 1 ... N-1, a spacing that
/// is not positive, an infinite height, or heights whose squares leave the range of numbers.
template <Real T>
[[nodiscard]] StructureFunction<T> structure_function(const Profile<T>& profile, std::span<const std::size_t> lags,
                                                      Divisor divisor = Divisor::pairs) {
    const T scale = detail::height_scale(profile), inverse = 1 / scale;  // a power of two: the product is exact
    const T* const z = profile.heights.data();
    return detail::mean_squares(profile, lags, 1, scale, divisor,
                                [=](std::size_t i, std::size_t n) { return (z[i + n] - z[i]) * inverse; });
}

namespace detail {

/// S2 of \p profile at \p lags (in samples, any order); a lag without a triple is left out. `pairs` counts triples.
/// \throws domain_error as structure_function(), for a lag above (N-1)/2.
template <Real T>
[[nodiscard]] StructureFunction<T> second_differences(const Profile<T>& profile, std::span<const std::size_t> lags) {
    const T scale = 2 * height_scale(profile), inverse = 1 / scale;  // a second difference is at most four heights
    const T* const z = profile.heights.data();
    return mean_squares(profile, lags, 2, scale, Divisor::pairs, [=](std::size_t i, std::size_t n) {
        return (z[i + 2 * n] - z[i + n]) * inverse - (z[i + n] - z[i]) * inverse;
    });
}

}  // namespace detail

}}  // namespace fstiff
