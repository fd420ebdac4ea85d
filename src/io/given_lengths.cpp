// SPDX-License-Identifier: BSD-3-Clause
#include "io/given_lengths.hpp"

#include "io/column_titles.hpp"
#include "io/missing_values.hpp"
#include "io/option_names.hpp"

namespace fstiff::inline v0_1::io::detail {

std::string GivenUnits::note() const { return "x and y in " + lengths + ", heights in " + heights + ", from options"; }

GivenUnits given_lengths(const SurfaceOptions& options, const std::string& name, bool of_positions) {
    const auto given = given_units(options.units, 3, name, "one unit, or \"um,nm\" (x and y, heights)");
    if (given.empty())
        refuse_file(name, {of_positions ? "states no units and none are given; must be "
                                        : "states no unit of the heights and none is given; must be ",
                           given_as(options.names, "units", of_positions ? "\"um,nm\"" : "\"um\""),
                           of_positions ? " (x and y, heights), of " : ", one of ", accepted_units(Dimension::length)});
    return {std::string(given.front()), std::string(given.back()), unit_factor(given.front(), Dimension::length),
            unit_factor(given.back(), Dimension::length)};
}

std::string take_heights(std::vector<double>& heights, const GivenUnits& units, const SurfaceOptions& options,
                         const std::string& name) {
    const MissingValues missing = given_missing(options.missing, name);
    mark_missing(heights.data(), heights.size(), missing, {}, name, options.names, units.heights,
                 [](std::size_t) { return std::size_t(0); });
    for (double& z : heights) z *= units.vertical;
    return missing.note();
}

std::optional<GivenStep> step_of_options(const LengthOption& each, const LengthOption& whole, std::size_t points,
                                         const std::string& name, std::string& from) {
    if (each.value && whole.value)
        refuse_file(name, {each.name, " and ", whole.name, " are both given; must be one of them"});
    if (!each.value && !whole.value) return std::nullopt;
    const LengthOption& given = each.value ? each : whole;
    const double value = *given.value;
    fstiff::detail::located({.file = name}, [&] { fstiff::detail::require_positive(given.name, value); });
    from += (from.empty() ? "" : ", ") + given.name + " of the options";
    return GivenStep{given.name, value, each.value ? value : value / static_cast<double>(points)};
}

GivenSteps given_steps_of(std::size_t rows, std::size_t columns, const SurfaceOptions& options,
                          const std::string& name) {
    GivenSteps steps;
    const auto step = [&](const LengthOption& each, const LengthOption& whole, std::size_t points) {
        if (const auto given = step_of_options(each, whole, points, name, steps.from)) return given->step;
        refuse_file(name, {"states no steps; must be ", given_steps(options.names),
                           " (between points), or width and height (of the map)"});
    };
    if (gives_size(options) && (options.spacing || rows == 1))
        refuse_file(name, {rows == 1 ? "holds a profile; must be given spacing, and not"
                                     : "is given spacing; must not be given with",
                           " dx, dy, width or height"});
    if (options.spacing || rows == 1) {
        if (!options.spacing)
            refuse_file(name, {"states no steps and none are given; must be ",
                               given_as(options.names, "spacing", "\"0.5 um\"")});
        steps.dx = steps.dy = step({"spacing", options.spacing}, {}, 1);
    } else {
        steps.dx = step({"dx", options.dx}, {"width", options.width}, columns);
        steps.dy = step({"dy", options.dy}, {"height", options.height}, rows);
    }
    return steps;
}

}  // namespace fstiff::inline v0_1::io::detail
