// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What docs/validation.md found of a law: K of the law over K of boundary elements, by p*.

#include <optional>
#include <string_view>

namespace fstiff::scene {

/// Least and largest over the families of surfaces of docs/validation.md.
struct ValidatedRatio {
    double low, high;
};
/// At \p dimensionless_pressure, of the two nearest rows of the table there; none for a law or a p* (with a tolerance of
/// one percent) that is not in it.
[[nodiscard]] std::optional<ValidatedRatio> validated_ratio(std::string_view law, double dimensionless_pressure);
/// Within how much of boundary elements K of hybrid is at 96 of 100 points of single surfaces, by their map or, where they are
/// Gaussian, by their numbers. The means of families are nearer.
inline constexpr int hybrid_accuracy_percent = 15;

/// The range of p* in the table.
inline constexpr double min_validated_pressure = 0.002, max_validated_pressure = 0.25;
/// p* to which hybrid and persson were compared (tests/contact/hybrid_of_band_test.cpp), and beyond which they refuse.
inline constexpr double max_compared_pressure = 0.75;

}  // namespace fstiff::scene
