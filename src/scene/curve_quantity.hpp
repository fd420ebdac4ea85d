// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// What a scene may ask for at a point.

#include <cstddef>

namespace fstiff::scene {

/// Quantities of columns, in the order of the columns.
enum class CurveQuantity {
    force,
    pressure,
    eta,
    separation,
    approach,
    stiffness,
    joint_stiffness,
    loading_stiffness,
    tangential_stiffness,
    loss_factor,
    reflection,
    shear_reflection,
    thermal_conductance,
    thermal_conductance_gap,
    electrical_conductance,
    thermal_resistance,
    electrical_resistance,
    real_area,
    contacts
};
inline constexpr std::size_t curve_quantity_count = static_cast<std::size_t>(CurveQuantity::contacts) + 1;

}  // namespace fstiff::scene
