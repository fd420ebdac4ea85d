// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Sums over triples of neighbouring points: mean square slope and curvature, and peaks.
///
/// Each triple gives both of its differences to the slope, so that the curvature is at most twice the slope whatever
/// the heights. Units of the heights and of the step are the caller's.
///
/// Reference   Greenwood, Proc. R. Soc. Lond. A 393 (1984) 133-157
/// Accuracy    that of the sums: those of compensated ones 1e-14 (tests/profile/triples_test.cpp)

#include <fstiff/math/accumulate.hpp>

#include <cstddef>
#include <type_traits>

namespace fstiff::detail {

/// \p Sum: S, or CompensatedSum<S>.
template <Real S, class Sum = S>
struct TripleSums {
    Sum slope{}, curvature{};  // of squared differences, and of squared second differences
    std::size_t triples{}, peaks{};

    /// A triple with its two differences; one with a missing point is left out.
    void add(S rise, S fall) {
        if (std::isnan(rise) || std::isnan(fall)) return;
        put(slope, (rise * rise + fall * fall) / 2);
        put(curvature, (fall - rise) * (fall - rise));
        peaks += rise > S(0) && fall < S(0) ? 1 : 0;
        ++triples;
    }
    void add(const TripleSums& other) requires std::is_same_v<Sum, S> {
        slope += other.slope, curvature += other.curvature;
        triples += other.triples, peaks += other.peaks;
    }
    S mean_square_slope() const { return total(slope) / static_cast<S>(triples); }
    S mean_square_curvature() const { return total(curvature) / static_cast<S>(triples); }

private:
    static void put(S& sum, S term) { sum += term; }
    static void put(CompensatedSum<S>& sum, S term) { sum.add(term); }
    static S total(S sum) { return sum; }
    static S total(const CompensatedSum<S>& sum) { return sum.value(); }
};

}  // namespace fstiff::detail
