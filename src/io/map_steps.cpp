// SPDX-License-Identifier: BSD-3-Clause
#include "io/map_steps.hpp"

namespace fstiff::inline v0_1::io::detail {

/// Warns where the step of the option is another than the stated \p length over \p points.
void MapSteps::warn_of_step(const GivenStep& given, const std::optional<StatedGrid::Length>& length, double points) {
    if (!length || std::abs(length->value / points - given.step) <= 0.01 * given.step) return;
    const std::string shown = number_text(length->value) + " m";
    warnings.push_back(contradiction(options.names, given.option, number_text(given.value) + " m",
                                     length->from.empty()
                                         ? "line " + std::to_string(length->line) + ", which states " + shown
                                         : length->from + ", " + shown));
}

double MapSteps::step_of(const LengthOption& step, const LengthOption& whole,
                         const std::optional<StatedGrid::Length>& stated_step,
                         const std::optional<StatedGrid::Length>& stated_whole, std::size_t count) {
    const auto points = static_cast<double>(count);
    const auto note = [&](const std::string& source) { from += (from.empty() ? "" : ", ") + source; };
    if (const auto given = step_of_options(step, whole, count, name, from)) {
        warn_of_step(*given, stated_step, 1);
        if (!stated_step) warn_of_step(*given, stated_whole, points);
        return given->step;
    }
    if (stated_step) {
        // also with points - 1 steps, which some programs take for the width
        if (stated_whole && std::abs(stated_whole->value - stated_step->value * (points - 0.5)) >
                                0.51 * stated_step->value + 0.01 * stated_whole->value)
            refuse_line(name, stated_whole->line,
                        {"states a ", whole.name, " that disagrees with the spacing of line ", stated_step->line,
                         "; must agree, or ", step.name, " be given"});
        note(stated_step->from.empty() ? step.name + " of line " + std::to_string(stated_step->line)
                                       : stated_step->from);
        return stated_step->value;
    }
    if (stated_whole) {
        note(whole.name + " of line " + std::to_string(stated_whole->line) + stated_whole->unit_from);
        return stated_whole->value / points;
    }
    if (!stated.without_unit.empty())
        refuse_line(name, stated.without_unit_line,
                    {shown_cell(stated.without_unit), " has no unit; must be ", given_as(options.names, "units", units),
                     " (lengths, heights), or dx and dy be given"});
    refuse_file(name, {subject, " states no ", step.name, " and no ", whole.name, "; must be ",
                       given_steps(options.names), " (between points) or width and height (of the map)"});
}

double MapSteps::x(std::size_t columns) {
    return step_of({"dx", options.dx}, {"width", options.width}, stated.dx, stated.width, columns);
}
double MapSteps::y(std::size_t rows) {
    return step_of({"dy", options.dy}, {"height", options.height}, stated.dy, stated.height, rows);
}

}  // namespace fstiff::inline v0_1::io::detail
