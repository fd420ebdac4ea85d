// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A law as text of one program: cards of CalculiX and Abaqus, columns of MOOSE and COMSOL.

#include "actions/overclosure.hpp"

#include <optional>
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

/// A law, and in which units and how closely it is written.
struct LawInModel {
    const PressureTable& table;
    ModelUnits units{};
    ChordErrors tolerance{};
    std::optional<double> friction{};  ///< the coefficient
    double at = 0;                     ///< the pressure of the one stiffness that a card of friction holds [Pa]

    [[nodiscard]] std::string pressure(double pascals) const;
    [[nodiscard]] std::string length(double metres) const;
};

/// The comment on the rows of the pressure, for the cards below.
[[nodiscard]] std::string comment_of_pressure(const LawInModel& law);
/// The surface interaction FSTIFF: pressure, heat and friction.
[[nodiscard]] std::string calculix_cards(const LawInModel& law);
/// The surface interaction FSTIFF: pressure, heat, current and friction.
[[nodiscard]] std::string abaqus_cards(const LawInModel& law);
/// A line of names and rows of numbers with commas; the tolerance holds for all of them.
[[nodiscard]] std::string moose_columns(const LawInModel& law);
/// The same with spaces, and the names in a comment.
[[nodiscard]] std::string comsol_columns(const LawInModel& law);

}  // namespace fstiff::actions
