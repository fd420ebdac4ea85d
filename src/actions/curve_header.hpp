// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The titles of a measured curve: their line, and which column holds what.

#include "actions/curve_titles.hpp"
#include "actions/measured_curve.hpp"
#include "io/lines.hpp"

#include <array>
#include <string>
#include <vector>

namespace fstiff::actions {

struct ReadColumn {
    std::size_t index;
    CurveTitle title;
};

/// The titles of a file, and where its rows begin.
struct CurveHeader {
    std::vector<std::string> titles{};
    char separator = ' ';
    std::size_t line = 0, rows = 0;                    ///< places in the lines of the file
    std::array<std::optional<ReadColumn>, 6> columns;  ///< by CurveColumn, but the values
    std::vector<ReadColumn> values;                    ///< stiffnesses or reflections
    std::optional<std::size_t> law, theta, r, answer;  ///< of fstiff run
    [[nodiscard]] bool computed() const { return law.has_value(); }
    [[nodiscard]] const std::optional<ReadColumn>& of(CurveColumn column) const {
        return columns[static_cast<std::size_t>(column)];
    }
    [[nodiscard]] bool is_reflection() const { return values.front().title.column == CurveColumn::reflection; }
};

/// What a first line that names no columns must do instead.
inline constexpr std::string_view must_name_columns =
    "the first line must name the columns, such as \"pressure [MPa], stiffness [GPa/um], stiffness_error [GPa/um]\" or "
    "\"pressure [MPa], frequency [MHz], reflection, reflection_error\"";

/// The titles in \p lines of the file that \p curve names, which gets its decisions and warnings.
/// \throws domain_error naming file, line and what must be there.
[[nodiscard]] CurveHeader read_header(const std::vector<io::detail::Line>& lines, MeasuredCurve& curve);

}  // namespace fstiff::actions
