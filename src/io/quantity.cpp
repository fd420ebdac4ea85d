// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/quantities.hpp>
#include <fstiff/io/units.hpp>

#include "io/unit_table.hpp"

#include <fstiff/core/error.hpp>

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

/// Whether \p text has a comma between two digits, as "0,8 um".
bool has_decimal_comma(std::string_view text) {
    for (std::size_t i = 1; i + 1 < text.size(); ++i)
        if (text[i] == ',' && is_digit(text[i - 1]) && is_digit(text[i + 1])) return true;
    return false;
}

/// \throws domain_error for \p reason, or for the comma where the number has one.
[[noreturn]] void refuse_text(std::string_view name, std::string_view text, const std::string& reason) {
    throw domain_error(
        {.parameter = name,
         .value = "\"" + std::string(text) + "\"",
         .reason = has_decimal_comma(text) ? "has a comma; the decimal mark is the point, as in 0.8" : reason});
}

/// \p value, unless the factor of the unit made it infinite.
double finite(double value, std::string_view name, std::string_view text) {
    if (std::abs(value) <= (std::numeric_limits<double>::max)()) return value;
    refuse_text(name, text, "is beyond the range of double precision; allowed is a finite number");
}

}  // namespace

}  // namespace detail

double parse_number(std::string_view text, std::string_view name) {
    const std::string_view inner = detail::trimmed(text);
    const auto number = detail::leading_number(inner);
    if (number.status == detail::NumberStatus::out_of_range)
        detail::refuse_text(name, text, "is beyond the range of double precision; allowed is a finite number");
    if (number.status == detail::NumberStatus::no_number || number.length != inner.size())
        detail::refuse_text(name, text, "is not a number; allowed is a finite decimal number such as 0.25 or 1e-6");
    return number.value;
}

double parse_quantity(std::string_view text, Dimension dimension, std::string_view name) {
    if (dimension == Dimension::angle) return parse_angle(text, name);
    const std::string_view inner = detail::trimmed(text);
    const std::string kind(name_of(dimension));
    const auto bare = detail::leading_number(inner);
    if (bare.status == detail::NumberStatus::no_number)
        detail::refuse_text(name, text,
                            "does not begin with a finite number; allowed is a number and a unit of " + kind +
                                ", one of " + accepted_units(dimension));
    const std::string_view unit_text = detail::without_blanks(inner.substr(bare.length));
    if (unit_text.empty())
        detail::refuse_text(
            name, text,
            "a number without a unit; must have a unit of " + kind + ", one of " + accepted_units(dimension));
    const detail::Unit* const unit = detail::find_unit(unit_text, dimension);
    if (!unit)
        detail::refuse_text(name, text,
                            "\"" + std::string(unit_text) + "\" is not a unit of " + kind + "; allowed are " +
                                accepted_units(dimension));
    const auto number = detail::leading_number(inner, unit->exponent);
    if (bare.status != detail::NumberStatus::ok || number.status != detail::NumberStatus::ok)
        detail::refuse_text(name, text, "is beyond the range of double precision; allowed is a finite number");
    return detail::finite(number.value * unit->factor, name, text);
}

double parse_angle(std::string_view text, std::string_view name) {
    const auto refuse = [&]() -> double {
        detail::refuse_text(name, text,
                            "is not an angle; allowed are a number of radians, \"45 deg\", \"0.7 rad\" or \"pi/4\"");
    };
    std::string_view rest = detail::trimmed(text);
    const auto skip_blanks = [&] { rest = detail::trimmed(rest); };
    double value = 1;
    bool has_number = false;
    if (const auto number = detail::leading_number(rest); number.status == detail::NumberStatus::ok) {
        value = number.value;
        has_number = true;
        rest.remove_prefix(number.length);
        skip_blanks();
        if (rest.empty()) return value;
        if (const detail::Unit* unit = detail::find_unit(rest, Dimension::angle))
            return detail::finite(value * unit->factor, name, text);
    } else if (number.status == detail::NumberStatus::out_of_range) {
        return refuse();
    } else if (rest.starts_with('-')) {
        value = -1;
        rest.remove_prefix(1);
    }
    // [number [*]] pi [/ number]
    if (has_number && rest.starts_with('*')) {
        rest.remove_prefix(1);
        skip_blanks();
    }
    if (!rest.starts_with("pi") && !rest.starts_with("\xCF\x80")) return refuse();
    rest.remove_prefix(2);
    value *= std::numbers::pi;
    skip_blanks();
    if (rest.empty()) return detail::finite(value, name, text);
    if (!rest.starts_with('/')) return refuse();
    rest.remove_prefix(1);
    skip_blanks();
    const auto divisor = detail::leading_number(rest);
    if (divisor.status != detail::NumberStatus::ok || divisor.length != rest.size() || divisor.value == 0)
        return refuse();
    return detail::finite(value / divisor.value, name, text);
}

}  // namespace fstiff::inline v0_1::io
