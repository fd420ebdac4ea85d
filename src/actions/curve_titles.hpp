// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Titles of the columns of a measured curve, in the usual words of several languages: what a column holds, its unit,
// and the frequency or the pressure at which all of it was measured.
//
//     curve_title("Contact pressure (MPa)")      pressure, factor 1e6
//     curve_title("|R| at 5 MHz [%]")            reflection, factor 0.01, frequency 5e6
//     curve_title("Reflexionsfaktor / dB")       reflection, 10^(dB/20)

#include <optional>
#include <string>
#include <string_view>

namespace fstiff::actions {

enum class CurveColumn { pressure, frequency, stiffness, reflection, phase, error };

/// What the number in a cell is.
enum class CellScale {
    factor,   ///< the value in a unit
    decibel,  ///< 20 log10 of it, negative
    loss,     ///< the same with the other sign
    energy    ///< its square
};

struct CurveTitle {
    CurveColumn column{};
    std::string name{}, unit{};                     ///< as messages call them
    double factor = 1;                              ///< from the cell to SI
    CellScale scale = CellScale::factor;            ///< of a reflection, and of its error
    bool is_share = false;                          ///< an error without a dimension
    std::optional<double> frequency{}, pressure{};  ///< at which all of the column was measured [Hz], [Pa]

    /// The value of a cell that holds \p number.
    [[nodiscard]] double value(double number) const;
};

/// Whether \p title names a column of a curve, whatever its unit.
[[nodiscard]] bool names_curve_column(std::string_view title);
/// Whether \p unit is one of a column of a curve, or a sign that it has none.
[[nodiscard]] bool is_curve_unit(std::string_view unit);
/// None: a title of something else. \throws domain_error, a sentence without a place, for a unit that the column cannot
/// have, none where it needs one, and a word that some use for amplitudes and others for energies.
[[nodiscard]] std::optional<CurveTitle> curve_title(std::string_view title);

}  // namespace fstiff::actions
