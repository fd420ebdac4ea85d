// SPDX-License-Identifier: BSD-3-Clause
#include "io/given_lengths.hpp"

#include "io/column_titles.hpp"
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

namespace {

/// The distance between points, \p each, or the length of all \p points, \p whole.
double step(const std::string& name, const SurfaceOptions& options, const char* each,
            const std::optional<double>& given, const char* whole, const std::optional<double>& given_whole,
            std::size_t points, std::string& from) {
    if (given && given_whole) refuse_file(name, {each, " and ", whole, " are both given; must be one of them"});
    if (!given && !given_whole)
        refuse_file(name, {"states no steps; must be ", given_steps(options.names),
                           " (between points), or width and height (of the map)"});
    const char* const what = given ? each : whole;
    fstiff::detail::located({.file = name},
                            [&] { fstiff::detail::require_positive(what, given ? *given : *given_whole); });
    from += std::string(from.empty() ? "" : ", ") + what + " of the options";
    return given ? *given : *given_whole / static_cast<double>(points);
}

}  // namespace

GivenSteps given_steps_of(std::size_t rows, std::size_t columns, const SurfaceOptions& options,
                          const std::string& name) {
    GivenSteps steps;
    const bool of_sides = options.dx || options.dy || options.width || options.height;
    if (of_sides && (options.spacing || rows == 1))
        refuse_file(name, {rows == 1 ? "holds a profile; must be given spacing, and not"
                                     : "is given spacing; must not be given with",
                           " dx, dy, width or height"});
    if (options.spacing || rows == 1) {
        if (!options.spacing)
            refuse_file(name, {"states no steps and none are given; must be ",
                               given_as(options.names, "spacing", "\"0.5 um\"")});
        steps.dx = steps.dy = step(name, options, "spacing", options.spacing, "", std::nullopt, 1, steps.from);
    } else {
        steps.dx = step(name, options, "dx", options.dx, "width", options.width, columns, steps.from);
        steps.dy = step(name, options, "dy", options.dy, "height", options.height, rows, steps.from);
    }
    return steps;
}

}  // namespace fstiff::inline v0_1::io::detail
