// SPDX-License-Identifier: BSD-3-Clause
#include "request/field.hpp"

#include "document/file.hpp"
#include "io/number.hpp"

#include <fstiff/io/quantities.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace fstiff::request {
namespace {

using Kind = Value::Kind;
using Giver = Value::Giver;

bool is_number(const Value& value) { return value.kind == Kind::integer || value.kind == Kind::real; }

/// \p reason is the end of the sentence.
[[noreturn]] void refuse(const Value& value, std::string_view key, const std::string& reason) {
    const std::string shown = value.kind == Kind::text ? "\"" + value.written + "\"" : value.written;
    throw domain_error({.parameter = key, .value = shown, .reason = reason});
}

/// The end of a refusal of several values where there must be one.
std::string of_a_grid(const Value& value) {
    const bool several = value.kind == Kind::list || value.kind == Kind::other;
    return value.giver == Giver::scene && several ? "; several values are for a grid, which fstiff sweep reads" : "";
}

double plain(const Value& value, std::string_view key) {
    if (!is_number(value)) refuse(value, key, "must be a plain number" + of_a_grid(value));
    if (value.kind == Kind::integer && !(std::abs(value.number) <= 0x1p53))
        refuse(value, key, "must be at most 2^53 as a whole number; write a greater one with an exponent");
    if (!std::isfinite(value.number)) refuse(value, key, "must be a finite number");
    return value.number;
}

/// The number of a text with its unit.
double quantity(const Value& value, std::string_view key, io::Dimension dimension) {
    const std::string such = "a text such as \"" + std::string(example(dimension)) + "\"";
    const bool is_angle = dimension == io::Dimension::angle;
    if (is_number(value) && (is_angle || !value.is_of_person())) return plain(value, key);
    if (is_angle && value.kind != Kind::text)
        refuse(value, key, "must be a number of radians or a text such as \"pi/4\" or \"45 deg\"");
    if (is_number(value)) refuse(value, key, "a number without a unit; write it as " + such);
    if (value.kind != Kind::text) refuse(value, key, "must be " + such + of_a_grid(value));
    const double si = io::parse_quantity(value.written, dimension, key);
    constexpr double most = 1e100;
    if (si != 0 && !(std::abs(si) <= most && std::abs(si) >= 1 / most))
        refuse(value, key,
               "must be 0, or from 1e-100 to 1e100 " + std::string(si_unit(dimension)) +
                   " in size, so that results are in the range of double precision");
    return si;
}

}  // namespace

std::string Amount::text(std::string_view unit) const {
    if (si_.empty()) return text_;
    std::string joined;
    for (const double number : si_)
        joined +=
            (joined.empty() ? "" : ",") + detail::shortest_text(number) + (unit.empty() ? "" : " ") + std::string(unit);
    return joined;
}

double Amount::value(io::Dimension dimension, std::string_view name) const {
    if (si_.empty()) return io::parse_quantity(text_, dimension, name);
    const std::string shown = text();
    if (si_.size() > 1) throw domain_error({.parameter = name, .value = shown, .allowed = "one quantity"});
    if (!std::isfinite(si_.front())) throw domain_error({.parameter = name, .value = shown, .allowed = "finite"});
    return si_.front();
}

double Amount::positive(io::Dimension dimension, std::string_view name) const {
    const double si = si_.empty() ? document::parse_positive(text_, dimension, name) : value(dimension, name);
    detail::require_positive(name, si);
    return si;
}

std::string Field::text_of(double bound) {
    const bool is_whole = bound == std::floor(bound) && std::abs(bound) <= 0x1p53;
    return is_whole ? std::to_string(static_cast<std::int64_t>(bound)) : detail::shortest_text(bound);
}

std::string Field::allowed(bool integer) const {
    const std::string kind = integer ? "a whole number" : "a number";
    if (!has_range()) return integer ? kind : "a finite number";
    const std::string from = text_of(low), to = text_of(high);
    if (!above_low) return kind + " from " + from + " to " + to;
    const bool is_open = high == std::numeric_limits<double>::max();
    return (is_open && low == 0 ? "finite and " : "") + ("greater than " + from) +
           (is_open ? "" : " and at most " + to);
}

std::string_view si_unit(io::Dimension dimension) {
    using io::Dimension;
    switch (dimension) {
        case Dimension::length: return "m";
        case Dimension::area: return "m^2";
        case Dimension::inverse_area: return "1/m^2";
        case Dimension::pressure: return "Pa";
        case Dimension::stiffness_per_area: return "Pa/m";
        case Dimension::angle: return "rad";
        case Dimension::frequency: return "Hz";
        case Dimension::velocity: return "m/s";
        case Dimension::density: return "kg/m^3";
        case Dimension::impedance: return "kg/(m^2 s)";
        case Dimension::force: return "N";
        case Dimension::thermal_conductivity: return "W/(m K)";
        case Dimension::electrical_conductivity: return "S/m";
        case Dimension::thermal_film: return "m^2 K/W";
        case Dimension::electrical_film: return "ohm m^2";
        case Dimension::temperature: return "K";
        default: return "";
    }
}

std::optional<io::Dimension> dimension_of(std::string_view unit) {
    if (unit.empty()) return std::nullopt;
    for (const auto& [dimension, name] : enum_names<io::Dimension>)
        if (si_unit(dimension) == unit) return dimension;
    return std::nullopt;
}

Field field_of(const NumberFacts& facts) {
    if (facts.unit.empty()) return {};
    Field field{.dimension = dimension_of(facts.unit)};
    if (facts.low == 0 && !facts.low_too) field.high = std::numeric_limits<double>::max(), field.above_low = true;
    return field;
}

std::string_view example(io::Dimension dimension) {
    using io::Dimension;
    switch (dimension) {
        case Dimension::area: return "195 mm^2";
        case Dimension::inverse_area: return "500 /mm^2";
        case Dimension::pressure: return "10 MPa";
        case Dimension::stiffness_per_area: return "0.1 GPa/um";
        case Dimension::frequency: return "7 MHz";
        case Dimension::velocity: return "5900 m/s";
        case Dimension::density: return "7850 kg/m^3";
        case Dimension::impedance: return "46 MRayl";
        case Dimension::force: return "20 kN";
        case Dimension::thermal_conductivity: return "40 W/(m K)";
        case Dimension::electrical_conductivity: return "7 MS/m";
        case Dimension::thermal_film: return "1 mm^2 K/W";
        case Dimension::electrical_film: return "1 ohm um^2";
        case Dimension::temperature: return "293 K";
        default: return "0.8 um";
    }
}

Value Value::of_text(std::string text, Giver giver) {
    Value value{.written = std::move(text), .giver = giver};
    if (value.written == "true" || value.written == "false") {
        value.kind = Kind::truth;
        value.number = value.written == "true";
        return value;
    }
    const auto number = io::detail::leading_number(value.written);
    if (value.written.empty() || number.length != value.written.size() || number.status != io::detail::NumberStatus::ok)
        return value;
    const bool is_digits = value.written.find_first_of(".eE") == std::string::npos;
    const bool is_whole = number.value == std::floor(number.value) && (is_digits || std::abs(number.value) <= 0x1p53);
    value.kind = is_whole ? Kind::integer : Kind::real;
    value.number = number.value;
    return value;
}

void put(const Value& value, bool& to, std::string_view key, const Field& field) {
    const bool by_number = field.form == Form::or_number;
    if (value.kind != Kind::truth && !(by_number && is_number(value) && (value.number == 0 || value.number == 1)))
        refuse(value, key, by_number ? "must be true or false, or 1 or 0" : "must be true or false");
    to = value.number == 1;
}

void put(const Value& value, double& to, std::string_view key, const Field& field) {
    to = field.dimension ? quantity(value, key, *field.dimension) : plain(value, key);
    if (!field.holds(to)) refuse(value, key, "must be " + field.allowed());
}

void put(const Value& value, std::string& to, std::string_view key, const Field& field) {
    const bool by_number = field.form == Form::or_number;
    const bool has_kinds = value.giver == Giver::scene || value.giver == Giver::program;
    if (value.kind != Kind::text && has_kinds && !(by_number && is_number(value)))
        refuse(value, key,
               by_number                     ? "must be a number or a text"
               : value.giver == Giver::scene ? "must be a text in quotation marks"
                                             : "must be a text");
    if (!field.words.empty()) (void)word(value, key, field.words);
    to = value.written;
}

void put(const Value& value, std::vector<std::string>& to, std::string_view key, const Field&) {
    to.clear();
    if (value.kind == Kind::list) {
        for (const Value& item : value.items) put(item, to.emplace_back(), key, {});
        return;
    }
    std::string joined;
    put(value, joined, key, {});
    for (std::size_t begin = 0; !joined.empty() && begin <= joined.size();) {
        const std::size_t end = std::min(joined.find(',', begin), joined.size());
        to.push_back(joined.substr(begin, end - begin));
        if (to.back().empty()) refuse(value, key, "has an empty part; must have a word on each side of a comma");
        begin = end + 1;
    }
}

void put(const Value& value, Amount& to, std::string_view key, const Field& field) {
    const io::Dimension dimension = field.dimension.value_or(io::Dimension::length);
    if (value.kind == Kind::text || value.giver == Giver::command) {
        to = value.written;
        return;
    }
    if (value.giver == Giver::scene) refuse(value, key, "must be a text in quotation marks");
    std::vector<double> numbers;
    std::string texts;
    bool is_text = false;
    for (const Value& item : value.kind == Kind::list ? value.items : std::vector{value}) {
        is_text = is_text || item.kind == Kind::text;
        if (item.kind != Kind::text && !is_number(item))
            refuse(value, key, "must be numbers in SI, or texts such as \"" + std::string(example(dimension)) + "\"");
        numbers.push_back(item.number);
        texts += (texts.empty() ? "" : ",") +
                 (item.kind == Kind::text ? item.written : Amount(item.number).text(si_unit(dimension)));
    }
    if (numbers.empty()) refuse(value, key, "is an empty list; at least one value is needed");
    to = is_text ? Amount(texts) : Amount(numbers);
}

std::int64_t integer(const Value& value, std::string_view key, const Field& field, std::int64_t least,
                     std::int64_t most) {
    Field range = field;
    if (!range.has_range()) range.low = static_cast<double>(least), range.high = static_cast<double>(most);
    if (value.kind != Kind::integer || !range.holds(value.number)) {
        const bool is_written_so = value.kind == Kind::real && value.number == std::floor(value.number);
        refuse(value, key,
               "must be " + range.allowed(true) +
                   (is_written_so ? ", written without a point and an exponent" : of_a_grid(value)));
    }
    const auto& words = field.words;
    if (!words.empty() && std::find(words.begin(), words.end(), value.written) == words.end())
        refuse(value, key, "must be " + std::string(words.front()) + " or " + std::string(words.back()));
    return static_cast<std::int64_t>(value.number);
}

std::uint64_t count(const Value& value, std::string_view key, const Field& field) {
    const bool is_text = value.giver == Giver::command || value.giver == Giver::line;
    if (!is_text || field.has_range())
        return static_cast<std::uint64_t>(integer(value, key, field, 0, (std::int64_t(1) << 53) - 1));
    std::uint64_t number = 0;
    const char* const last = value.written.data() + value.written.size();
    const auto [end, error] = std::from_chars(value.written.data(), last, number);
    if (error != std::errc() || end != last)
        refuse(value, key, "must be a whole number from 0 to " + std::to_string(std::uint64_t(-1)));
    return number;
}

std::size_t word(const Value& value, std::string_view key, const std::vector<std::string_view>& words) {
    const auto place = std::find(words.begin(), words.end(), value.kind == Kind::text ? value.written : "");
    if (place == words.end())
        refuse(value, key, "must be one of " + document::list_and_suggestion(value.written, words));
    return static_cast<std::size_t>(place - words.begin());
}

}  // namespace fstiff::request
