// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The columns of a curve, each by what it holds: names, units and headings follow from one table.

#include "scene/curve_quantity.hpp"
#include "scene/scene.hpp"

#include <fstiff/answer/curves.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/peaks/quantity.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::scene {

/// The number of the quantity: its value, its numerical error, or an end of its band.
enum class Statistic { value, error, p05, p95 };

/// Whether a quantity follows from K, so that it has an error and a band, and how.
enum class OfStiffness { none, rises, falls };

/// A row of the table of quantities.
struct CurveQuantityRow {
    CurveQuantity quantity;
    std::string_view name, suffix;  ///< of the key, which has a statistic between them
    std::string_view unit;          ///< SI, such as "Pa/m"; empty: a plain number
    std::string_view symbol;        ///< in headings
    Quantity of_law;                ///< that the law must give; none: every law has it
    OfStiffness of_stiffness = OfStiffness::none;
    /// Its word in output.quantities, with its place among these words; where it is a default, and what it needs of a
    /// scene that lacks it.
    struct Choice {
        int place = 0;  ///< 0: none
        std::string_view word{};
        bool (*is_usual)(const Scene&) = nullptr;
        std::string_view (*lack)(const Scene&) = nullptr;
    } choice{};
};
/// In the order of CurveQuantity.
[[nodiscard]] std::span<const CurveQuantityRow> curve_quantities();
/// Those of output.quantities, in the order of their words.
[[nodiscard]] std::vector<const CurveQuantityRow*> chosen_quantities();

/// One quantity of a curve at every state.
struct Column {
    CurveQuantity quantity;
    Statistic statistic = Statistic::value;
    std::vector<double> values{};  ///< [SI] one a state, NaN where the law lacks it; empty: it gives none

    [[nodiscard]] const CurveQuantityRow& row() const { return curve_quantities()[static_cast<std::size_t>(quantity)]; }
    /// Name in CSV and JSON, with the unit at its end, such as "stiffness_p05_Pa_per_m".
    [[nodiscard]] const std::string& key() const;
};

/// The columns that \p scene asks for, of the states and the band of \p curve; with \p bands some curve has a band.
[[nodiscard]] std::vector<Column> columns_of(const Scene& scene, const detail::LawCurve& curve, bool bands);

}  // namespace fstiff::scene
