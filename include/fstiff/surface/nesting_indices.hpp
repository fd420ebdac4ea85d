// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Cut-offs of the standards, and the shortest waves that a measurement of a given step can contain.
///
///     lambda_c [mm]   lambda_s [um]   greatest step [um]   tip radius [um]   Ra of the roughness [um]
///       0.08            2.5             0.5                  2                 to 0.02
///       0.25            2.5             0.5                  2                 to 0.1
///       0.8             2.5             0.5                  2 (5 above 0.5)   to 2
///       2.5             8               1.5                  5                 to 10
///       8               25              5                    10                to 80
///     series of nesting indices: 1, 2, 2.5, 5, 8 times powers of ten;   lambda_s >= 5 steps
///
/// Reference   ISO 3274:1996, ISO 4288:1996 and ISO 21920-3:2021 (table), ISO 25178-3:2012 (series, steps)
/// Units       lengths [m]
/// Valid       lengths greater than 0; smaller and greater ones continue the series
/// Accuracy    indices are the nearest numbers to the decimal ones (tests/surface/nesting_indices_test.cpp)

#include <fstiff/core/error.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace fstiff::inline v0_1::parts {

/// One row of the table above [m].
struct CutOffRow {
    double lambda_c, lambda_s, max_step, tip_radius, max_ra;
};
inline constexpr std::array<CutOffRow, 5> cut_off_table{{{0.08e-3, 2.5e-6, 0.5e-6, 2e-6, 0.02e-6},
                                                         {0.25e-3, 2.5e-6, 0.5e-6, 2e-6, 0.1e-6},
                                                         {0.8e-3, 2.5e-6, 0.5e-6, 2e-6, 2e-6},
                                                         {2.5e-3, 8e-6, 1.5e-6, 5e-6, 10e-6},
                                                         {8e-3, 25e-6, 5e-6, 10e-6, 80e-6}}};

/// Minimum number of steps in lambda_s.
inline constexpr int steps_of_lambda_s = 5;
/// Minimum number of lambda_c in a profile: the sampling lengths of an evaluation length.
inline constexpr int lambda_c_of_length = 5;
/// Minimum of lambda_c over lambda_s: rounded down from the smallest of the table, 0.08 mm over 2.5 um.
inline constexpr double min_ratio_of_cut_offs = 30;

/// Smallest index of the series that is at least \p length; a length above an index by less than 1e-6 of it counts as
/// equal, because steps have rounding errors. \throws domain_error unless 1e-15 <= length <= 1e6.
template <Real T>
[[nodiscard]] T nesting_index(T length) {
    require(length >= T(1e-15) && length <= T(1e6), "length", length, "between 1e-15 and 1e6");
    constexpr std::array<double, 6> series{1, 2, 2.5, 5, 8, 10};
    const int decade = static_cast<int>(std::floor(std::log10(length) + T(1e-9)));
    const T power = std::pow(T(10), static_cast<T>(std::abs(decade)));
    for (const double one : series) {
        const T index = decade < 0 ? static_cast<T>(one) / power : static_cast<T>(one) * power;
        if (length <= index * (1 + T(1e-6))) return index;
    }
    return decade < 0 ? T(10) / power : T(10) * power;
}

/// lambda_s of a stylus of \p tip_radius; below 2 um the ratio is 1.25, above 10 um 2.5, as in the table at these ends.
/// \throws domain_error unless the radius is greater than 0.
template <Real T>
[[nodiscard]] T lambda_s_of_tip(T tip_radius) {
    require_positive("tip radius", tip_radius);
    for (std::size_t row = 2; row < cut_off_table.size(); ++row)
        if (tip_radius <= static_cast<T>(cut_off_table[row].tip_radius) * (1 + T(1e-6)))
            return row > 2 ? static_cast<T>(cut_off_table[row].lambda_s) : nesting_index(T(1.25) * tip_radius);
    return nesting_index(T(2.5) * tip_radius);
}

/// Shortest waves that a measurement of \p step contains: the smallest index of five steps and of the \p resolution,
/// and that of the tip; 0 for unknown ones. \throws domain_error for lengths out of range.
template <Real T>
[[nodiscard]] T shortest_lambda_s(T step, T resolution = 0, T tip_radius = 0) {
    require_positive("step", step);
    const T index = nesting_index((std::max)(static_cast<T>(steps_of_lambda_s) * step, resolution));
    return tip_radius > T(0) ? (std::max)(index, lambda_s_of_tip(tip_radius)) : index;
}

}  // namespace fstiff::inline v0_1::parts
