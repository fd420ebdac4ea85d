// SPDX-License-Identifier: BSD-3-Clause
#include "io/matrix_unit.hpp"

namespace fstiff::inline v0_1::io::detail {

namespace {

/// "Bit2nm = 0.5" of SPIP: nanometres of a count, where no unit is stated.
MatrixUnit nanometres_of_count(const HeaderEntry& entry, const HeaderEntry* unit, const std::string& name,
                               const OptionNames& names) {
    const auto number = number_in(entry.value, false);
    if (!number || !(*number > 0) || !std::isfinite(*number))
        refuse_line(name, entry.line, {"Bit2nm ", shown_cell(entry.value), "; must be a number greater than 0"});
    const bool stated = unit && is_unit(unit->value, Dimension::length);
    if (stated && *number != 1)
        refuse_line(name, entry.line,
                    {"states Bit2nm ", *number, ", line ", unit->line, " the unit ", shown_cell(unit->value),
                     ": heights may be in either; must be ", given_as(names, "units", "\"nm\"")});
    const std::string shown = stated ? printable(unit->value, 16) : "counts";
    return {.factor = stated ? unit_factor(unit->value, Dimension::length) : *number * 1e-9,
            .shown = shown,
            .text = stated ? shown : "counts of " + number_text(*number) + " nm",
            .from = "line " + std::to_string(stated ? unit->line : entry.line)};
}

/// "height conversion factor (-> m)=2.9e-8", or "... = 29 nm".
MatrixUnit conversion_factor(const HeaderEntry& entry, const HeaderEntry* unit, const std::string& name) {
    const LeadingNumber number = leading_number(entry.value);
    std::string_view to = trimmed(std::string_view(entry.value).substr(number.length));
    const std::size_t arrow = entry.key.find("->");
    if (to.empty() && arrow != std::string::npos) {
        to = std::string_view(entry.key).substr(arrow + 2);
        to = trimmed(to.substr(0, to.find(')')));
    }
    if (number.status != NumberStatus::ok || !(number.value > 0) || !is_unit(to, Dimension::length))
        refuse_line(name, entry.line,
                    {shown_cell(entry.value),
                     " is not a height conversion factor; must be a positive number with a "
                     "unit of length, such as \"(-> m)=2.9e-8\""});
    const double factor = number.value * unit_factor(to, Dimension::length);
    if (unit && is_unit(unit->value, Dimension::length) &&
        !(std::abs(factor - unit_factor(unit->value, Dimension::length)) <= 1e-6 * factor))
        refuse_line(name, entry.line,
                    {"states a height conversion factor, line ", unit->line,
                     " a unit of length that disagrees; must agree, or units be given"});
    const std::string shown = unit ? printable(unit->value, 16) : "units";
    return {.factor = factor,
            .shown = shown,
            .text = shown + " of " + number_text(factor) + " m",
            .from = "line " + std::to_string(entry.line)};
}

}  // namespace

MatrixUnit matrix_unit(const std::vector<HeaderEntry>& entries, std::string_view given, const std::string& name,
                       const OptionNames& names) {
    const bool factor_stated = std::any_of(entries.begin(), entries.end(), [](const HeaderEntry& entry) {
        return entry.key.starts_with("height conversion factor");
    });
    if (!factor_stated && !given.empty()) refuse_no_length(entries, name);
    if (!given.empty()) {
        MatrixUnit unit{.factor = unit_factor(given, Dimension::length),
                        .shown = std::string(given),
                        .text = std::string(given),
                        .from = "options"};
        const HeaderEntry* const scale = stated_scale(entries).entry;
        for (const HeaderEntry& entry : entries)
            if (unit.contradicted.empty() && entry.key.starts_with("height conversion factor"))
                unit.contradicted = "line " + std::to_string(entry.line) +
                                    ", which states a height conversion factor of " + printable(entry.value, 24);
            else if (unit.contradicted.empty() && &entry == scale)
                unit.contradicted = shown_line(entry);
            else if (unit.contradicted.empty() && is_height_unit_key(entry.key) &&
                     is_unit(entry.value, Dimension::length) &&
                     unit_factor(entry.value, Dimension::length) != unit.factor)
                unit.contradicted = "line " + std::to_string(entry.line) + ", which states " +
                                    printable(entry.value, 16) + " for the heights";
        return unit;
    }
    const auto [unit, factor] = stated_height_unit(entries, name);
    if (factor) return conversion_factor(*factor, unit, name);
    if (const HeaderEntry* const count = find_entry(entries, "bit2nm"))
        return nanometres_of_count(*count, unit, name, names);
    if (!unit)
        refuse_file(name, {"states no unit of the heights and none is given; must be ",
                           given_as(names, "units", "\"UNIT\""), ", one of ", accepted_units(Dimension::length)});
    const double scale = require_scale(entries, name, names);
    if (!is_unit(unit->value, Dimension::length))
        refuse_line(name, unit->line,
                    {shown_cell(unit->value),
                     " is not a unit of length, and no height conversion factor is stated; must be one of ",
                     accepted_units(Dimension::length)});
    const std::string shown = printable(unit->value, 16);
    return {.factor = unit_factor(unit->value, Dimension::length) * scale,
            .shown = shown,
            .text = scale == 1 ? shown : number_text(scale) + " " + shown,
            .from = "line " + std::to_string(unit->line)};
}

}  // namespace fstiff::inline v0_1::io::detail
