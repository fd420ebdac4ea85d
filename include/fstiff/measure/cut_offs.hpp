// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Cut-offs of a measurement: given, chosen from the tables of the standards, or none, each with its reason.
///
///     lambda_s    smallest nesting index >= 5 steps and >= resolution; that of the tip where it is longer;
///                 none where the surface is shorter than 10 of it, or where it is not below a given lambda_c
///     lambda_c    none unless given, because K depends on all waves up to the size of the contact; for Ra, Rq and the
///                 other parameters of ISO 21920 that of with_drawing_cut_off()
///     neighbours  lambda_s/sqrt(2) and sqrt(2) lambda_s; only 2 lambda_s where the first is below 2 steps;
///                 4 steps for a surface without lambda_s
/// Reference   ISO 21920-3:2021, ISO 25178-3:2012 (measure/cut_offs.hpp); a surface without lambda_c is the S-F
///             surface of ISO 25178-2:2012. The limits 10, 2, 5 and the neighbours are this project's.
/// Units       lengths [m]
/// Valid       a given lambda_s has at least 2 steps, a given lambda_c at least 5; neither exceeds the length of the
///             surface, and lambda_s is below lambda_c
/// Accuracy    that of nesting_index() and roughness_cut_off() (tests/measure/cut_offs_test.cpp)

#include <fstiff/core/error.hpp>
#include <fstiff/measure/options.hpp>
#include <fstiff/profile/gaussian_filter.hpp>

#include <algorithm>
#include <array>
#include <cmath>

// Cut-offs of the standards, and the shortest waves that a measurement of a given step can contain.
//
//     lambda_c [mm]   lambda_s [um]   greatest step [um]   tip radius [um]   Ra of the roughness [um]   RSm [mm]
//       0.08            2.5             0.5                  2                 to 0.02                    to 0.04
//       0.25            2.5             0.5                  2                 to 0.1                     to 0.13
//       0.8             2.5             0.5                  2 (5 above 0.5)   to 2                       to 0.4
//       2.5             8               1.5                  5                 to 10                      to 1.3
//       8               25              5                    10                to 80                      to 4
//     series of nesting indices: 1, 2, 2.5, 5, 8 times powers of ten;   lambda_s >= 5 steps
//     every limit of a class holds to 1 %, because printed positions leave a step open by some 0.1 %
//
// Reference   ISO 3274:1996, ISO 4288:1996 and ISO 21920-3:2021 (table), ISO 25178-3:2012 (series, steps)
// Units       lengths [m]
// Valid       lengths greater than 0; smaller and greater ones continue the series
// Accuracy    indices are the nearest numbers to the decimal ones (tests/measure/nesting_indices_test.cpp)

namespace fstiff { inline namespace v0_1 { namespace detail {

/// One row of the table above [m].
struct CutOffRow {
    double lambda_c, lambda_s, max_step, tip_radius, max_ra, max_spacing;
};
inline constexpr std::array<CutOffRow, 5> cut_off_table{{{0.08e-3, 2.5e-6, 0.5e-6, 2e-6, 0.02e-6, 0.04e-3},
                                                         {0.25e-3, 2.5e-6, 0.5e-6, 2e-6, 0.1e-6, 0.13e-3},
                                                         {0.8e-3, 2.5e-6, 0.5e-6, 2e-6, 2e-6, 0.4e-3},
                                                         {2.5e-3, 8e-6, 1.5e-6, 5e-6, 10e-6, 1.3e-3},
                                                         {8e-3, 25e-6, 5e-6, 10e-6, 80e-6, 4e-3}}};
/// Whether \p value is within the class that ends at \p limit; 1 % above it still is.
template <Real T>
[[nodiscard]] constexpr bool within_class(T value, std::type_identity_t<T> limit) {
    return value <= limit * T(1.01);
}

/// Minimum number of steps in lambda_s.
inline constexpr int steps_of_lambda_s = 5;
/// Minimum number of lambda_c in a profile: the sampling lengths of an evaluation length; of one that RSm determines.
inline constexpr int lambda_c_of_length = 5, lambda_c_of_periodic_length = 2;
/// Minimum of lambda_c over lambda_s: rounded down from the smallest of the table, 0.08 mm over 2.5 um.
inline constexpr double min_ratio_of_cut_offs = 30;

/// Smallest index of the series that is at least \p length, to within_class().
/// \throws domain_error unless 1e-15 <= length <= 1e6.
template <Real T>
[[nodiscard]] T nesting_index(T length) {
    require(length >= T(1e-15) && length <= T(1e6), "length", length, "between 1e-15 and 1e6");
    constexpr std::array<double, 6> series{1, 2, 2.5, 5, 8, 10};
    const int decade = static_cast<int>(std::floor(std::log10(length) + T(1e-9)));
    const T power = std::pow(T(10), static_cast<T>(std::abs(decade)));
    for (const double term : series) {
        const T index = decade < 0 ? static_cast<T>(term) / power : static_cast<T>(term) * power;
        if (within_class(length, index)) return index;
    }
    return decade < 0 ? T(10) / power : T(10) * power;
}

/// lambda_s of a stylus of \p tip_radius; below 2 um the ratio is 1.25, above 10 um 2.5, as in the table at these ends.
/// \throws domain_error unless the radius is greater than 0.
template <Real T>
[[nodiscard]] T lambda_s_of_tip(T tip_radius) {
    require_positive("tip radius", tip_radius);
    for (std::size_t row = 2; row < cut_off_table.size(); ++row)
        if (within_class(tip_radius, static_cast<T>(cut_off_table[row].tip_radius)))
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

}}}  // namespace fstiff::detail
