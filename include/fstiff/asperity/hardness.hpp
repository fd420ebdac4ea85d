// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Indentation hardness: the mean pressure of a contact that has yielded fully, and its range where it was not
/// measured.
///
///     vickers_pressure * 200                     2.12e9, of 200 HV
///     hardness_of_elastic({210e9, 0.3})          {0.95e9, 2.7e9, 11.6e9}, of any metal with these constants
///     softer(of_steel, of_copper)                the hardness of the body that yields
///
///     HV is force over the faces of the pyramid; the pressure under it is 1/sin 68 degrees = 1.079 times that
///
/// Reference   ISO 6507-1:2018 (HV); ASTM A370-03a as quoted by two suppliers (HRC); HB to HV of pairs in data sheets.
///             Shares of the modulus: smallest and greatest of the materials of asperity/named_materials.hpp
/// Units       [Pa]
/// Valid       HRC 20 to 68
/// Accuracy    HRC 3 % (tests/asperity/hardness_test.cpp); HB to HV 1.00 to 1.06 was read of steel

#include <fstiff/asperity/material.hpp>
#include <fstiff/math/random.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fstiff { inline namespace v0_1 { namespace detail {

/// Mean pressure [Pa] of a contact with the hardness 1 HV.
inline constexpr double vickers_pressure = 9.80665e6 / 0.9271838545667874;

/// HV over HB of a body with the modulus \p youngs_modulus [Pa]: that of aluminium and magnesium differs.
[[nodiscard]] constexpr double vickers_over_brinell(double youngs_modulus) {
    return youngs_modulus > 40e9 && youngs_modulus < 80e9 ? 1.14 : 1.05;
}

/// HV of the Rockwell hardness \p rockwell. \throws domain_error unless it is from 20 to 68.
[[nodiscard]] inline double vickers_of_rockwell(double rockwell) {
    constexpr std::array<std::array<double, 2>, 16> table{{{20, 238},
                                                           {25, 266},
                                                           {30, 302},
                                                           {35, 345},
                                                           {40, 392},
                                                           {45, 446},
                                                           {50, 513},
                                                           {52, 544},
                                                           {55, 595},
                                                           {58, 653},
                                                           {60, 697},
                                                           {62, 746},
                                                           {64, 800},
                                                           {65, 832},
                                                           {66, 865},
                                                           {68, 940}}};
    require(rockwell >= table.front()[0] && rockwell <= table.back()[0], "HRC", rockwell, "from 20 to 68");
    std::size_t i = 1;
    while (i + 1 < table.size() && rockwell > table[i][0]) ++i;
    const auto &a = table[i - 1], &b = table[i];
    return a[1] * std::pow(b[1] / a[1], (rockwell - a[0]) / (b[0] - a[0]));
}

/// Range of the hardness [Pa] of a body of which nothing but \p elastic is known: of metals, of glass and ceramics (nu
/// below 0.25), of polymers (E below 15 GPa). Rubber, E below 0.1 GPa, does not yield: infinite.
[[nodiscard]] inline PriorRange hardness_of_elastic(const Material<double>& elastic) {
    const double modulus = elastic.youngs_modulus;
    if (!(modulus >= 0.1e9)) {
        constexpr double none = std::numeric_limits<double>::infinity();
        return {none, none, none};
    }
    const PriorRange share = modulus < 15e9                 ? PriorRange{0.02, 0.05, 0.09}
                             : elastic.poisson_ratio < 0.25 ? PriorRange{0.02, 0.07, 0.14}
                                                            : PriorRange{0.0045, 0.013, 0.055};
    return {share.low * modulus, share.middle * modulus, share.high * modulus};
}

/// Range of the lesser of two independent numbers with the ranges \p a and \p b; the logarithm of each is normal below
/// and above its middle. A range whose three numbers are equal is a number.
[[nodiscard]] inline PriorRange softer(const PriorRange& a, const PriorRange& b) {
    const auto below = [](const PriorRange& range, double x) {  // share of the numbers below x
        const double end = x < range.middle ? range.low : range.high;
        return end == range.middle ? (x < range.middle ? 0.0 : 1.0)
                                   : math::normal_share(math::normal_95<double>.value * std::log(x / range.middle) /
                                                        std::abs(std::log(end / range.middle)));
    };
    const auto quantile = [&](double share) {
        double low = std::log((std::min)(a.low, b.low)) - 2, high = std::log((std::min)(a.high, b.high)) + 1e-9;
        while (high - low > 1e-12 * std::abs(high)) {
            const double middle = (low + high) / 2, x = std::exp(middle);
            (1 - (1 - below(a, x)) * (1 - below(b, x)) < share ? low : high) = middle;
        }
        return std::exp(high);
    };
    const auto is_number = [](const PriorRange& range) { return range.low == range.high; };
    const auto least = [](const PriorRange& range, double x) {
        return PriorRange{(std::min)(range.low, x), (std::min)(range.middle, x), (std::min)(range.high, x)};
    };
    if (is_number(a)) return least(b, a.low);
    if (is_number(b)) return least(a, b.low);
    return {quantile(0.05), quantile(0.5), quantile(0.95)};
}

}}}  // namespace fstiff::detail
