// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The numbers of a compiled law, and what they say within its range: all that is written to text.
///
///     p(gap), -dp/dgap       one table, uniform in the gap; K(gap) too where K is a constant times -dp/dgap
///     K(gap)                 else a table of its own, of the same pieces
///     gap(p), K(p), dK/dp    two, in the binary exponent of p
///
/// and how they go on beyond the range, as contact/contact_law says of OutsideRange::extrapolate.
///
/// Units       SI: Pa, m, Pa/m
/// Valid       float and double; arguments within the tables, but for the functions of the continuation
/// Accuracy    relative_error, as contact/law_compiler measures it

#include <fstiff/core/error.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/math/piecewise.hpp>

#include <cmath>
#include <limits>

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
    struct AtPressure {
        T gap, stiffness, stiffness_slope;
    };

    T pressure_min{}, pressure_max{};    ///< 0 of an empty law
    T slope_scale{}, stiffness_scale{};  ///< from dp/ds to -dp/dgap and to K
    T stiffness_over_slope = T(1);       ///< 0 where K has a table of its own
    T relative_error{};
    OutsideRange outside = OutsideRange::refuse;
    int evaluations = 0;
    UniformPieces<T> by_gap;         ///< p
    UniformPieces<T> own_stiffness;  ///< K by gap, of the same pieces; empty where it is a constant times -dp/dgap
    BinaryPieces<T> stiffness, gap;  ///< by pressure

    [[nodiscard]] bool empty() const { return by_gap.rows.cols() == 0; }
    [[nodiscard]] bool has_own_stiffness() const noexcept { return stiffness_over_slope == T(0); }

    [[nodiscard]] Whole at_gap(T g) const {
        const auto [pressure, derivative] = by_gap(g);
        T k = derivative * stiffness_scale;
        if (has_own_stiffness()) [[unlikely]]
            k = own_stiffness(g).value;
        return {pressure, k, derivative * slope_scale};
    }
    /// Of two tables, so that at the ends of the range the last digits may differ: never beyond those of by_gap.
    [[nodiscard]] T gap_at(T pressure) const { return within(gap.value(pressure), by_gap.begin, by_gap.end); }

    [[nodiscard]] AtPressure at_pressure(T pressure) const {
        return {gap_at(pressure), stiffness.value(pressure), stiffness.derivative(pressure)};
    }

    /// K over -dp/dgap where the gap is the end \p end_gap of the range: what the continuation keeps.
    [[nodiscard]] T ratio_at(T end_gap) const {
        if (!has_own_stiffness()) return stiffness_over_slope;
        const Whole end = at_gap(end_gap);
        return end.stiffness / end.slope;
    }

    /// The law beyond the range: K/p is constant below it, K dK/dp above it. Each continues its own table, from the value at
    /// the very end. \throws domain_error for a pressure that is negative or not finite.
    [[nodiscard]] AtPressure continued_pressure(T pressure) const;
    /// \throws domain_error for -infinity.
    [[nodiscard]] Whole continued_gap(T at) const;

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
               same(stiffness.rows, other.stiffness.rows) && same(gap.rows, other.gap.rows) &&
               same(own_stiffness.rows, other.own_stiffness.rows);
    }
};

template <ReadableReal T>
auto LawTables<T>::continued_pressure(T pressure) const -> AtPressure {
    require(pressure >= 0 && pressure <= std::numeric_limits<T>::max(), "pressure", pressure,
            "finite and at least 0 Pa: the contact does not pull");
    if (pressure < pressure_min) {
        const AtPressure end = at_pressure(pressure_min);
        const T rate = end.stiffness / pressure_min;
        return {end.gap + std::log(pressure_min / pressure) / (rate / ratio_at(by_gap.end)), rate * pressure, rate};
    }
    const AtPressure end = at_pressure(pressure_max);
    const T more = pressure - pressure_max;
    const T growth = std::sqrt(1 + 2 * (end.stiffness_slope / end.stiffness) * more);
    const T k = end.stiffness * growth;
    return {end.gap - 2 * more / ((end.stiffness + k) / ratio_at(by_gap.begin)), k, end.stiffness_slope / growth};
}

template <ReadableReal T>
auto LawTables<T>::continued_gap(T at) const -> Whole {
    if (at > by_gap.end) {
        const Whole end = at_gap(by_gap.end);
        const T share = std::exp(-(at - by_gap.end) * (end.slope / end.pressure));
        return {end.pressure * share, end.stiffness * share, end.slope * share};
    }
    require(at >= std::numeric_limits<T>::lowest(), "gap", at, "greater than -infinity (m)");
    const Whole end = at_gap(by_gap.begin);
    const T less = by_gap.begin - at;
    const T bend = stiffness.derivative(pressure_max) * end.slope;  // dK/d less
    const T more_slope = bend * less / ratio_at(by_gap.begin);
    return {end.pressure + less * (end.slope + more_slope / 2), end.stiffness + bend * less, end.slope + more_slope};
}

}  // namespace detail
}  // namespace fstiff
