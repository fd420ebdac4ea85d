// SPDX-License-Identifier: BSD-3-Clause
#include "scene/validated_ratio.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace fstiff::scene {
namespace {

constexpr std::array<double, 8> pressures{min_validated_pressure, 0.004, 0.008, 0.015, 0.03, 0.06, 0.12,
                                          max_validated_pressure};

struct Validated {
    std::string_view law;
    std::array<ValidatedRatio, pressures.size()> ratios{};
};

/// The table of docs/validation.md (tests/scene/validated_ratio_test.cpp compares them).
constexpr std::array<Validated, 6> table{{
    {"hertz",
     {{{0.87, 0.97},
       {0.89, 1.01},
       {0.82, 1.04},
       {0.74, 0.97},
       {0.63, 0.89},
       {0.49, 0.76},
       {0.34, 0.58},
       {0.18, 0.31}}}},
    {"greenwood_williamson",
     {{{0.82, 0.93},
       {0.77, 0.96},
       {0.70, 0.99},
       {0.63, 0.91},
       {0.53, 0.83},
       {0.42, 0.71},
       {0.29, 0.53},
       {0.16, 0.27}}}},
    {"fractal",
     {{{1.30, 2.59},
       {1.33, 2.70},
       {1.22, 2.68},
       {1.11, 2.55},
       {0.94, 2.30},
       {0.74, 1.85},
       {0.51, 1.29},
       {0.27, 0.67}}}},
    {"fractal_consistent",
     {{{0.91, 1.01},
       {0.94, 1.07},
       {0.88, 1.10},
       {0.81, 1.06},
       {0.71, 0.99},
       {0.58, 0.84},
       {0.42, 0.65},
       {0.24, 0.37}}}},
    {"hybrid",
     {{{0.91, 1.08},
       {0.96, 1.09},
       {1.02, 1.11},
       {1.02, 1.10},
       {1.01, 1.11},
       {0.97, 1.11},
       {0.96, 1.09},
       {0.95, 1.03}}}},
    {"persson",
     {{{0.69, 0.95},
       {0.78, 1.00},
       {0.85, 1.04},
       {0.90, 1.07},
       {0.94, 1.10},
       {0.95, 1.10},
       {0.96, 1.09},
       {0.95, 1.03}}}},
}};

const Validated* find(std::string_view law) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const Validated& row) { return row.law == law; });
    return found == table.end() ? nullptr : &*found;
}

}  // namespace

std::optional<ValidatedRatio> validated_ratio(std::string_view law, double dimensionless_pressure) {
    const Validated* row = find(law);
    if (!row ||
        !(dimensionless_pressure > 0.99 * pressures.front() && dimensionless_pressure < 1.01 * pressures.back()))
        return std::nullopt;
    std::optional<ValidatedRatio> both;
    for (std::size_t i = 0; i < pressures.size(); ++i) {
        // a row counts where no other stands between it and p*; one that p* is at stands alone
        const bool here =
            std::max(pressures[i], dimensionless_pressure) < 1.01 * std::min(pressures[i], dimensionless_pressure);
        if (here) return row->ratios[i];
        const bool below = pressures[i] < dimensionless_pressure &&
                           (i + 1 == pressures.size() || pressures[i + 1] > dimensionless_pressure);
        const bool above =
            pressures[i] > dimensionless_pressure && (i == 0 || pressures[i - 1] < dimensionless_pressure);
        if (!below && !above) continue;
        const ValidatedRatio& one = row->ratios[i];
        both = both ? ValidatedRatio{std::min(both->low, one.low), std::max(both->high, one.high)} : one;
    }
    return both;
}

}  // namespace fstiff::scene
