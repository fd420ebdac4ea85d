// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_steps.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Warns where the step \p value of the option is another than the \p stated length over \p points.
void MapSteps::warn_of_step(const std::string& option, double given, double value,
                            const std::optional<StatedGrid::Length>& length, double points) {
    if (!length || std::abs(length->value / points - value) <= 0.01 * value) return;
    const std::string shown = number_text(length->value) + " m";
    warnings.push_back(contradiction(options.names, option, number_text(given) + " m",
                                     length->from.empty()
                                         ? "line " + std::to_string(length->line) + ", which states " + shown
                                         : length->from + ", " + shown));
}

double MapSteps::step_of(const std::string& step, const std::string& whole, const std::optional<double>& given_step,
                         const std::optional<double>& given_whole, const std::optional<StatedGrid::Length>& stated_step,
                         const std::optional<StatedGrid::Length>& stated_whole, std::size_t count) {
    const auto points = static_cast<double>(count);
    const auto note = [&](const std::string& source) { from += (from.empty() ? "" : ", ") + source; };
    if (given_step && given_whole) refuse_file(name, {step, " and ", whole, " are both given; must be one of them"});
    if (given_step || given_whole) {
        fstiff::detail::located({.file = name}, [&] {
            fstiff::detail::require_positive(given_step ? step : whole, *(given_step ? given_step : given_whole));
        });
        note((given_step ? step : whole) + " of the options");
        const double value = given_step ? *given_step : *given_whole / points;
        warn_of_step(given_step ? step : whole, given_step ? value : *given_whole, value, stated_step, 1);
        if (!stated_step)
            warn_of_step(given_step ? step : whole, given_step ? value : *given_whole, value, stated_whole, points);
        return value;
    }
    if (stated_step) {
        // also with points - 1 steps, which some programs take for the width
        if (stated_whole && std::abs(stated_whole->value - stated_step->value * (points - 0.5)) >
                                0.51 * stated_step->value + 0.01 * stated_whole->value)
            refuse_line(name, stated_whole->line,
                        {"states a ", whole, " that disagrees with the spacing of line ", stated_step->line,
                         "; must agree, or ", step, " be given"});
        note(stated_step->from.empty() ? step + " of line " + std::to_string(stated_step->line) : stated_step->from);
        return stated_step->value;
    }
    if (stated_whole) {
        note(whole + " of line " + std::to_string(stated_whole->line) + stated_whole->unit_from);
        return stated_whole->value / points;
    }
    if (!stated.without_unit.empty())
        refuse_line(name, stated.without_unit_line,
                    {shown_cell(stated.without_unit), " has no unit; must be ", given_as(options.names, "units", units),
                     " (lengths, heights), or dx and dy be given"});
    refuse_file(name, {subject, " states no ", step, " and no ", whole, "; must be ", given_steps(options.names),
                       " (between points) or width and height (of the map)"});
}

double MapSteps::x(std::size_t columns) {
    return step_of("dx", "width", options.dx, options.width, stated.dx, stated.width, columns);
}
double MapSteps::y(std::size_t rows) {
    return step_of("dy", "height", options.dy, options.height, stated.dy, stated.height, rows);
}

}  // namespace fstiff::inline v0_1::io::detail
