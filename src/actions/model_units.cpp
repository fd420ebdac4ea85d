// SPDX-License-Identifier: BSD-3-Clause
#include "actions/model_units.hpp"

#include "document/file.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/io/units.hpp>

#include <cmath>

namespace fstiff::actions {

ModelUnits model_units(const std::string& list, const std::string& name) {
    const std::size_t first = list.find(','), second = list.find(',', first + 1);
    if (first == std::string::npos || second == std::string::npos)
        throw domain_error(name + " = \"" + list +
                           "\": must be length, force and pressure, such as mm,N,MPa or m,N,Pa");
    ModelUnits units{.length = list.substr(0, first),
                     .force = list.substr(first + 1, second - first - 1),
                     .pressure = list.substr(second + 1)};
    const double length = io::parse_quantity("1 " + units.length, io::Dimension::length, name);
    const double pressure = io::parse_quantity("1 " + units.pressure, io::Dimension::pressure, name);
    if (!io::is_unit(units.force, io::Dimension::force))
        throw domain_error(name + " = \"" + list + "\": " + units.force + " is not a unit of force; must be one of " +
                           io::accepted_units(io::Dimension::force));
    const double force = io::unit_factor(units.force, io::Dimension::force);
    if (std::abs(force / (length * length) / pressure - 1) > 1e-9)
        throw domain_error(name + " = \"" + list + "\": must be consistent: 1 " + units.force + "/" + units.length +
                           "^2 is " + document::shortest(force / (length * length) / pressure) + " " + units.pressure);
    units.metre = 1 / length;
    units.newton = 1 / force;
    units.pascal = 1 / pressure;
    return units;
}

}  // namespace fstiff::actions
