// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The numbers of a compiled law, and what they say within its range: all that is written to text.
///
///     p(gap), -dp/dgap, K(gap)    one table, uniform in the gap         gap(p), K(p), dK/dp    two, in the binary exponent of p
///
/// Units       SI: Pa, m, Pa/m
/// Valid       float and double; arguments within the tables
/// Accuracy    relative_error, as contact/law_compiler measures it

#include <fstiff/core/text.hpp>
#include <fstiff/math/piecewise.hpp>

namespace fstiff {

enum class OutsideRange {
    refuse,      ///< throw domain_error
    clamp,       ///< the values at the nearer end of the range; with derivatives 0
    exact,       ///< evaluate the model itself: microseconds; not for a law that goes to text
    extrapolate  ///< continue the law smoothly: an opening contact ends with p = K = 0
};

template <ReadableReal T>
struct LawRange {
    T pressure_min{};  ///< [Pa]
    T pressure_max{};  ///< [Pa]
    OutsideRange outside = OutsideRange::refuse;
};

namespace detail {

template <ReadableReal T>
struct LawTables {
    struct Whole {
        T pressure, stiffness, slope;
    };

    T pressure_min{}, pressure_max{};    ///< 0 of an empty law
    T slope_scale{}, stiffness_scale{};  ///< from dp/ds to -dp/dgap and to K
    T stiffness_over_slope = T(1);
    T relative_error{};
    OutsideRange outside = OutsideRange::refuse;
    int evaluations = 0;
    UniformPieces<T> by_gap;         ///< p
    BinaryPieces<T> stiffness, gap;  ///< by pressure

    [[nodiscard]] bool empty() const { return by_gap.rows.cols() == 0; }

    [[nodiscard]] Whole at_gap(T g) const {
        const auto [pressure, derivative] = by_gap(g);
        return {pressure, derivative * stiffness_scale, derivative * slope_scale};
    }
    /// Of two tables, so that at the ends of the range the last digits may differ: never beyond those of by_gap.
    [[nodiscard]] T gap_at(T pressure) const { return within(gap.value(pressure), by_gap.begin, by_gap.end); }

    /// The one place where -dp/dgap follows from K.
    [[nodiscard]] T slope_of(T k) const noexcept { return k / stiffness_over_slope; }

    /// To be called once by_gap and stiffness_over_slope are set.
    void set_scales() {
        slope_scale = -2 * by_gap.pieces_per_length;
        stiffness_scale = slope_scale * stiffness_over_slope;
    }

    /// Never a NaN: that becomes \p low.
    [[nodiscard]] static T within(T x, T low, T high) noexcept { return x > low ? (x < high ? x : high) : low; }

    [[nodiscard]] bool operator==(const LawTables& other) const {
        if (empty() || other.empty()) return empty() && other.empty();
        const auto same = [](const auto& a, const auto& b) { return a.cols() == b.cols() && (a == b).all(); };
        return pressure_min == other.pressure_min && pressure_max == other.pressure_max &&
               by_gap.begin == other.by_gap.begin && by_gap.end == other.by_gap.end &&
               stiffness_over_slope == other.stiffness_over_slope && relative_error == other.relative_error &&
               outside == other.outside && evaluations == other.evaluations && same(by_gap.rows, other.by_gap.rows) &&
               same(stiffness.rows, other.stiffness.rows) && same(gap.rows, other.gap.rows);
    }
};

}  // namespace detail
}  // namespace fstiff
