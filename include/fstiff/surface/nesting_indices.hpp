// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The cut-offs that the standards offer, and the shortest waves that a measurement of a given step can hold.
///
///     lambda_c [mm]   lambda_s [um]   greatest step [um]   tip radius [um]   Ra of the roughness [um]
///       0.08            2.5             0.5                  2                 to 0.02
///       0.25            2.5             0.5                  2                 to 0.1
///       0.8             2.5             0.5                  2 (5 above 0.5)   to 2
///       2.5             8               1.5                  5                 to 10
///       8               25              5                    10                to 80
///     series of nesting indices: 1, 2, 2.5, 5, 8 times powers of ten
///
/// Every step of the table is a fifth of its lambda_s, or a little less. So lambda_s is the least index of the series
/// that is five steps: the table's own for the table's steps, and for any other step, of an atomic force microscope as
/// well.
///
/// Reference   ISO 3274:1996, Table 1 (cut-offs, steps, tips), taken over by ISO 21920-3:2021; ISO 4288:1996, Table 1
///             (Ra); ISO 25178-3:2012, Tables 1 to 3 (series, step at most a fifth of the index). Smaller and greater
///             lengths than theirs continue the series; smaller tips than 2 um the ratio 1.25 of its lambda_s, greater
///             than 10 um 2.5.
/// Units       lengths [m]
/// Valid       lengths greater than 0
/// Accuracy    indices are the nearest numbers to the decimal ones; a length that exceeds an index by less than 1e-6 of
///             it counts as equal, as steps have rounding (tests/surface/nesting_indices_test.cpp)

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

/// How many steps of a measurement lambda_s holds at least.
inline constexpr int steps_of_lambda_s = 5;
/// How many lambda_c a profile holds at least: the sampling lengths of an evaluation length.
inline constexpr int lambda_c_of_length = 5;
/// lambda_c over lambda_s at least: rounded down from the table's smallest, 0.08 mm over 2.5 um.
inline constexpr double min_ratio_of_cut_offs = 30;

/// The least index of the series that is at least \p length. \throws domain_error unless 1e-15 <= length <= 1e6.
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

/// lambda_s of a stylus of \p tip_radius. \throws domain_error unless the radius is greater than 0.
template <Real T>
[[nodiscard]] T lambda_s_of_tip(T tip_radius) {
    require_positive("tip radius", tip_radius);
    for (std::size_t row = 2; row < cut_off_table.size(); ++row)
        if (tip_radius <= static_cast<T>(cut_off_table[row].tip_radius) * (1 + T(1e-6)))
            return row > 2 ? static_cast<T>(cut_off_table[row].lambda_s) : nesting_index(T(1.25) * tip_radius);
    return nesting_index(T(2.5) * tip_radius);
}

/// The shortest waves that a measurement of \p step shows: the least index of five steps and of the \p resolution, and
/// that of the tip; 0 for what is not known. \throws domain_error for lengths out of range.
template <Real T>
[[nodiscard]] T shortest_lambda_s(T step, T resolution = 0, T tip_radius = 0) {
    require_positive("step", step);
    const T index = nesting_index((std::max)(static_cast<T>(steps_of_lambda_s) * step, resolution));
    return tip_radius > T(0) ? (std::max)(index, lambda_s_of_tip(tip_radius)) : index;
}

}  // namespace fstiff::inline v0_1::parts
