// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The unit in which people read a value: by its size, the same in every table, text and picture.

#include <span>
#include <string>
#include <string_view>

namespace fstiff::document {

struct ShownUnit {
    std::string_view name;
    double size = 1;           ///< in SI
    double factor = 1 / size;  ///< from SI to this unit

    /// \p value [SI] with its unit, and with \p error where that is not 0: "0.832 ± 0.08 µm".
    [[nodiscard]] std::string operator()(double value, int digits = 5, double error = 0) const;
    /// "separation [µm]", "contacts [1/mm²]", "eta": the heading of a column, or the label of an axis.
    [[nodiscard]] std::string heading(std::string_view quantity) const;
};

/// The unit for a value of about \p size in the SI unit \p si; of 0 the usual one. A plain number or any other unit
/// stays. "m": nm from 0.01 nm, µm from 0.1 µm, mm from 1 mm, m for what is smaller or from 1 m; "m along", of what is
/// as long as a profile, has mm from 0.1 mm. "/m^2" or "1/m^2": /mm² from 0.01 /mm², /µm² from 0.1 /µm². "m^2". "Pa":
/// kPa from 0.1 kPa, MPa from 0.1 MPa, GPa from 1 GPa. "Pa/m": MPa/µm from 1 MPa/µm, GPa/µm from 1 GPa/µm. "Hz". "N".
/// "N/m": N/µm from 0.1 N/µm, kN/µm from 1 kN/µm.
[[nodiscard]] ShownUnit shown_unit(double size, std::string_view si);
/// The unit of \p si in which most of \p values are between 1 and 1000, for a table that has one unit.
[[nodiscard]] ShownUnit shown_unit(std::span<const double> values, std::string_view si);
/// \p value [\p si] in the unit of its size, as ShownUnit writes it.
[[nodiscard]] std::string with_unit(double value, std::string_view si, int digits = 5, double error = 0);

[[nodiscard]] inline ShownUnit unit_of_length(double metres) { return shown_unit(metres, "m"); }
[[nodiscard]] inline ShownUnit unit_of_density(double per_area) { return shown_unit(per_area, "/m^2"); }
[[nodiscard]] inline ShownUnit unit_of_pressure(double pressure) { return shown_unit(pressure, "Pa"); }
[[nodiscard]] inline std::string shown_length(double metres, int digits = 5) { return with_unit(metres, "m", digits); }

/// A factor as a change: "-3 %", "+41 %", or "2.8 times" where that is clearer.
[[nodiscard]] std::string shown_change(double factor);

/// A share in percent, without an exponent: "0.12 %", "8.5 %", "85 %", "181 %".
[[nodiscard]] std::string shown_percent(double share);

}  // namespace fstiff::document
