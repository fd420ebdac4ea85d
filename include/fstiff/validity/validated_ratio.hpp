// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// How far each law was off boundary elements: K of the law over K of the half space solved on the same surfaces, by
/// p*.
///
///     const auto ratio = fstiff::parts::validated_ratio(fstiff::LawName::hertz, 0.02);
///     if (ratio) use(ratio->low, ratio->high);          0.63 to 0.97
///
/// Reference   docs/validation.md, its first table: families of periodic self-affine Gaussian surfaces, without plastic
///             flow
/// Units       p* = p/(E g_rms) and ratios, dimensionless
/// Valid       p* from 0.002 to 0.25
/// Accuracy    two decimals; tests/validity/validated_ratio_test.cpp compares every number with the document

#include <fstiff/core/names.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace fstiff {

/// The laws of contact.
enum class LawName {
    fractal,
    fractal_consistent,
    hertz,
    greenwood_williamson,
    hybrid,
    persson,
    summits,
    plastic,
    plastic_peaks,
    jackson_green,
    kogut_etsion,
    boundary_elements
};

template <>
inline constexpr auto names<LawName> =
    name_list<LawName>({{LawName::fractal, "fractal"},
                        {LawName::fractal_consistent, "fractal_consistent"},
                        {LawName::hertz, "hertz"},
                        {LawName::greenwood_williamson, "greenwood_williamson"},
                        {LawName::hybrid, "hybrid"},
                        {LawName::persson, "persson"},
                        {LawName::summits, "summits"},
                        {LawName::plastic, "plastic"},
                        {LawName::plastic_peaks, "plastic_peaks"},
                        {LawName::jackson_green, "jackson_green"},
                        {LawName::kogut_etsion, "kogut_etsion"},
                        {LawName::boundary_elements, "boundary_elements"}});

namespace parts {

/// Least and greatest K of a law over that of the contact.
struct StiffnessRatio {
    double low = 0, high = 0;
};

/// The range of p* in the table.
inline constexpr double min_validated_pressure = 0.002, max_validated_pressure = 0.25;

inline constexpr std::array<double, 8> validated_pressures{
    min_validated_pressure, 0.004, 0.008, 0.015, 0.03, 0.06, 0.12, max_validated_pressure};

struct ValidatedLaw {
    LawName law;
    std::array<StiffnessRatio, validated_pressures.size()> ratios;
};

// clang-format off
inline constexpr std::array<ValidatedLaw, 6> validated_laws{{
    {LawName::hertz, {{{0.87, 0.97}, {0.89, 1.01}, {0.82, 1.04}, {0.74, 0.97},
                       {0.63, 0.89}, {0.49, 0.76}, {0.34, 0.58}, {0.18, 0.31}}}},
    {LawName::greenwood_williamson, {{{0.82, 0.93}, {0.77, 0.96}, {0.70, 0.99}, {0.63, 0.91},
                                      {0.53, 0.83}, {0.42, 0.71}, {0.29, 0.53}, {0.16, 0.27}}}},
    {LawName::fractal, {{{1.30, 2.59}, {1.33, 2.70}, {1.22, 2.68}, {1.11, 2.55},
                         {0.94, 2.30}, {0.74, 1.85}, {0.51, 1.29}, {0.27, 0.67}}}},
    {LawName::fractal_consistent, {{{0.91, 1.01}, {0.94, 1.07}, {0.88, 1.10}, {0.81, 1.06},
                                    {0.71, 0.99}, {0.58, 0.84}, {0.42, 0.65}, {0.24, 0.37}}}},
    {LawName::hybrid, {{{0.91, 1.08}, {0.96, 1.09}, {1.02, 1.11}, {1.02, 1.10},
                        {1.01, 1.11}, {0.97, 1.11}, {0.96, 1.09}, {0.95, 1.03}}}},
    {LawName::persson, {{{0.69, 0.95}, {0.78, 1.00}, {0.85, 1.04}, {0.90, 1.07},
                         {0.94, 1.10}, {0.95, 1.10}, {0.96, 1.09}, {0.95, 1.03}}}},
}};
// clang-format on

/// The ratio of \p law at \p dimensionless_pressure (p*): of the row that p* is at, within one percent, else of the two
/// rows on either side. None for a law or a p* that is not in the table.
[[nodiscard]] inline std::optional<StiffnessRatio> validated_ratio(LawName law, double dimensionless_pressure) {
    constexpr double tolerance = 1.01;
    const auto& rows = validated_pressures;
    const auto of = std::find_if(validated_laws.begin(), validated_laws.end(),
                                 [&](const ValidatedLaw& one) { return one.law == law; });
    const double p = dimensionless_pressure;
    if (of == validated_laws.end() || !(p > 0.99 * rows.front() && p < tolerance * rows.back()))
        return std::nullopt;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if ((std::max)(rows[i], p) < tolerance * (std::min)(rows[i], p)) return of->ratios[i];
    const auto above = static_cast<std::size_t>(std::upper_bound(rows.begin(), rows.end(), p) - rows.begin());
    if (above == 0) return of->ratios.front();
    if (above == rows.size()) return of->ratios.back();
    const StiffnessRatio &a = of->ratios[above - 1], &b = of->ratios[above];
    return StiffnessRatio{(std::min)(a.low, b.low), (std::max)(a.high, b.high)};
}

}  // namespace parts

}  // namespace fstiff
