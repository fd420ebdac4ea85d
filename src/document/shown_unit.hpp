// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The unit in which people read a value: by its size, the same in every table.

#include <string>
#include <string_view>

namespace fstiff::scene {

struct ShownUnit {
    std::string_view name;
    double factor = 1;  ///< from SI to this unit

    /// \p value [SI] with its unit.
    [[nodiscard]] std::string operator()(double value, int digits = 5) const;
};

/// nm from 0.01 nm, µm from 0.1 µm, mm from 1 mm; m for what is smaller or above 1 m.
[[nodiscard]] ShownUnit unit_of_length(double metres);
/// \p metres in that unit.
[[nodiscard]] std::string shown_length(double metres, int digits = 5);
/// Of a number per area [1/m^2]: /mm², and /µm² from 0.1 /µm².
[[nodiscard]] ShownUnit unit_of_density(double per_area);
/// Pa, kPa from 100 Pa, MPa from 0.1 MPa, GPa from 1 GPa.
[[nodiscard]] ShownUnit unit_of_pressure(double pressure);
/// Of K per area: GPa/µm, which is 1e15 Pa/m.
inline constexpr ShownUnit unit_of_stiffness{"GPa/µm", 1e-15};

/// \p value in the unit that its SI unit \p si ("m", "/m^2") has for people; a plain number or any other unit stays.
[[nodiscard]] ShownUnit shown_unit(double value, std::string_view si);

/// A factor as a change: "-3 %", "+41 %", or "2.8 times" where that is clearer.
[[nodiscard]] std::string shown_change(double factor);

/// A share in percent, without an exponent: "0.12 %", "8.5 %", "85 %", "181 %".
[[nodiscard]] std::string shown_percent(double share);
/// A count as a whole number of \p digits digits and zeros: "3", "110", "1670" of 1672 with three.
[[nodiscard]] std::string shown_count(double count, int digits = 2);

}  // namespace fstiff::scene
