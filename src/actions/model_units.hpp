// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The consistent units of a finite-element model.

#include <string>
#include <string_view>

namespace fstiff::actions {

/// Numbers of a law in the units of a model; power is force times length over second, temperature kelvin.
struct ModelUnits {
    std::string length, force, pressure;
    double metre = 1, newton = 1, pascal = 1;  ///< one of them in these units

    [[nodiscard]] std::string of_stiffness() const { return pressure + "/" + length; }
    [[nodiscard]] std::string of_heat() const { return force + "/(" + length + " s K)"; }
    [[nodiscard]] std::string of_current() const { return "S/" + length + "^2"; }
    [[nodiscard]] double stiffness(double K) const { return K * pascal / metre; }
    [[nodiscard]] double heat(double h) const { return h * newton / metre; }
    [[nodiscard]] double current(double h) const { return h / (metre * metre); }
};

/// Reads length, force and pressure, such as "mm,N,MPa". \throws domain_error, which names the option \p name, for what
/// is not a unit and for units that are not consistent.
[[nodiscard]] ModelUnits model_units(const std::string& list, const std::string& name);

}  // namespace fstiff::actions
