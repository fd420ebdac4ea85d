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
/// The largest |ratio - 1| in the table: how far K of \p law may be off there. \throws std::logic_error for a law that it lacks.
[[nodiscard]] double largest_departure(std::string_view law);

/// The range of p* in the table.
inline constexpr double min_validated_pressure = 0.002, max_validated_pressure = 0.25;
/// p* to which hybrid and persson were compared (tests/contact/hybrid_of_band_test.cpp), and beyond which they refuse.
inline constexpr double max_compared_pressure = 0.75;

}  // namespace fstiff::scene
