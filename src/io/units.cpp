// SPDX-License-Identifier: BSD-3-Clause
#include "io/unit_table.hpp"

#include <fstiff/core/error.hpp>

#include <vector>

namespace fstiff::inline v0_1::io {

namespace detail {

namespace {

/// One spelling for all: micro signs to "u", superscripts to digits, products to ".", no "^", no brackets, no "1/".
std::string canonical_unit(std::string_view unit) {
    struct Spelling {
        std::string_view from, to;
    };
    static constexpr std::array spellings{Spelling{"\xC2\xB5", "u"},
                                          Spelling{"\xCE\xBC", "u"},
                                          Spelling{"\xB5", "u"},
                                          Spelling{"\xE6", "u"},      // the micro sign of MS-DOS (CP437, CP850)
                                          Spelling{"\xA6\xCC", "u"},  // of GBK and EUC-JP
                                          Spelling{"\x83\xCA", "u"},  // of Shift-JIS
                                          Spelling{"\xA5\xEC", "u"},  // of EUC-KR
                                          Spelling{"\xC2\xB2", "2"},
                                          Spelling{"\xB2", "2"},
                                          Spelling{"\xC2\xB3", "3"},
                                          Spelling{"\xB3", "3"},
                                          Spelling{"\xE2\x81\xBB", "-"},
                                          Spelling{"\xC2\xB9", "1"},
                                          Spelling{"\xC2\xB7", "."},
                                          Spelling{"\xE2\x8B\x85", "."},
                                          Spelling{"*", "."},
                                          Spelling{" ", "."},
                                          Spelling{"\t", "."},
                                          Spelling{"^", ""},
                                          Spelling{"(", ""},
                                          Spelling{")", ""}};
    unit = without_blanks(unit);
    std::string spelt;
    while (!unit.empty()) {
        if ((unit[0] >= 'a' && unit[0] <= 'z') || (unit[0] >= 'A' && unit[0] <= 'Z')) {  // no spelling begins so
            spelt += unit[0];
            unit.remove_prefix(1);
            continue;
        }
        std::string_view next = unit.substr(0, 1);
        std::size_t taken = 1;
        for (const Spelling& s : spellings)
            if (unit.starts_with(s.from)) {
                next = s.to;
                taken = s.from.size();
                break;
            }
        const bool product = next == ".";
        if (product && (spelt.empty() || spelt.back() == '.' || spelt.back() == '/')) next = "";
        if (next == "/" && !spelt.empty() && spelt.back() == '.') spelt.pop_back();
        spelt += next;
        unit.remove_prefix(taken);
    }
    if (spelt.starts_with("1/")) spelt.erase(0, 1);
    return spelt;
}

}  // namespace

const Unit* find_unit(std::string_view text, Dimension dimension) {
    static const std::vector<std::string> names = [] {  // of `units`; text may be searched for units at every word
        std::vector<std::string> all;
        for (const Unit& unit : units) all.push_back(canonical_unit(unit.name));
        return all;
    }();
    constexpr std::size_t longest = 40;  // with blanks, superscripts and brackets
    text = without_blanks(text);
    if (text.size() > longest) return nullptr;
    const std::string wanted = canonical_unit(text);
    if (wanted.empty()) return nullptr;
    const std::string lower = wanted.size() > 3 ? lower_case(wanted) : std::string();
    std::string word = lower;
    if (word.size() > 4 && word.back() == 's') word.pop_back();  // plural
    for (std::size_t i = 0; i < units.size(); ++i) {
        const std::string& name = names[i];
        if (units[i].dimension != dimension) continue;
        if (name == wanted || ((name == word || name == lower) && name.size() > 3 && name == lower_case(name)))
            return &units[i];
    }
    return nullptr;
}

bool measures_no_length(std::string_view text) {
    // those that the table of units lacks; the symbols after a prefix too
    static constexpr std::array<std::string_view, 16> symbols{"V", "A", "C",  "F",  "W",  "J",   "T",   "S",
                                                              "s", "N", "Hz", "Pa", "eV", "rad", "deg", "Ohm"};
    static constexpr std::array<std::string_view, 18> names{
        "%",       "dB",     "degc",    "\xC2\xB0\x43", "degrees", "radians", "volt",   "volts",  "ampere",
        "amperes", "newton", "newtons", "hertz",        "percent", "seconds", "arcsec", "arcmin", "kelvin"};
    const std::string unit = canonical_unit(text);
    if (unit.empty() || is_unit(text, Dimension::length)) return false;
    for (const Unit& one : units)
        if (one.dimension != Dimension::length && find_unit(text, one.dimension)) return true;
    const auto has = [](const auto& list, std::string_view word) {
        return std::find(list.begin(), list.end(), word) != list.end();
    };
    if (has(names, unit) || has(names, lower_case(unit)) || has(symbols, unit)) return true;
    if (std::string_view("pnumk").find(unit[0]) != std::string_view::npos && has(symbols, unit.substr(1))) return true;
    for (const std::string_view prefix : {"micro", "milli", "nano", "kilo"})
        if (unit.starts_with(prefix) && measures_no_length(unit.substr(prefix.size()))) return true;
    const auto measures = [](std::string_view part) {
        return part == "1" || is_unit(part, Dimension::length) || measures_no_length(part);
    };
    if (const std::size_t over = unit.find('/'); over != std::string::npos)
        return (over == 0 || measures(std::string_view(unit).substr(0, over))) &&
               measures(std::string_view(unit).substr(over + 1));
    const std::string_view base = std::string_view(unit).substr(0, unit.size() - 1);
    return (unit.back() == '2' || unit.back() == '3') &&
           measures(base.ends_with('-') ? base.substr(0, base.size() - 1) : base);
}

Multiple multiple_of_length(std::string_view text) {
    const auto skip = [&](std::initializer_list<std::string_view> signs) {
        text = without_blanks(text);
        for (const std::string_view sign : signs)
            if (text.starts_with(sign)) return text.remove_prefix(sign.size());
    };
    const auto skip_times = [&] { skip({"x", "X", "*", "\xC3\x97", "\xD7", "\xC2\xB7"}); };
    skip_times();
    text = without_blanks(text);
    const LeadingNumber number = leading_number(text);
    if (number.status != NumberStatus::ok) return {};
    text.remove_prefix(number.length);
    double factor = number.value;
    if (factor == 10 && (text.starts_with('^') || text.starts_with("**") || utf8_length(text) > 1)) {
        std::string exponent;  // superscripts too
        skip({"^", "**"});
        static constexpr std::array<std::string_view, 11> raised{
            "\xE2\x81\xB0", "\xC2\xB9",     "\xC2\xB2",     "\xC2\xB3",     "\xE2\x81\xB4", "\xE2\x81\xB5",
            "\xE2\x81\xB6", "\xE2\x81\xB7", "\xE2\x81\xB8", "\xE2\x81\xB9", "\xE2\x81\xBB"};
        for (std::size_t length = 1; length > 0 && !text.empty(); text.remove_prefix(length)) {
            length = is_digit(text[0]) || text[0] == '-' ? 1 : 0;
            if (length == 1) exponent += text[0];
            for (std::size_t i = 0; i < raised.size() && length == 0; ++i)
                if (text.starts_with(raised[i])) length = raised[i].size(), exponent += "0123456789-"[i];
        }
        factor = leading_number("1e" + exponent).value;
    }
    skip_times();
    const double power = std::log10(factor);
    if (!(std::abs(power) >= 1 && std::abs(power) <= 15 && std::abs(power - std::round(power)) < 1e-9)) return {};
    const Unit* const unit = find_unit(text, Dimension::length);
    return unit ? Multiple{factor, unit} : Multiple{};
}

const Unit& require_unit(std::string_view text, Dimension dimension) {
    if (const Unit* unit = find_unit(text, dimension)) return *unit;
    throw domain_error("unit \"" + std::string(text) + "\": is not a unit of " + std::string(name_of(dimension)) +
                       "; allowed are " + accepted_units(dimension));
}

}  // namespace detail

double unit_factor(std::string_view unit, Dimension dimension) {
    const auto value = [](const detail::Unit& one) {
        return detail::leading_number("1", one.exponent).value * one.factor;
    };
    if (dimension == Dimension::length && !detail::find_unit(unit, dimension))
        if (const auto [factor, one] = detail::multiple_of_length(unit); one) return factor * value(*one);
    return value(detail::require_unit(unit, dimension));
}

bool is_unit(std::string_view unit, Dimension dimension) {
    return detail::find_unit(unit, dimension) ||
           (dimension == Dimension::length && detail::multiple_of_length(unit).unit);
}

std::string accepted_units(Dimension dimension) {
    std::string list;
    for (const detail::Unit& unit : detail::units)
        if (unit.dimension == dimension && unit.listed) {
            if (!list.empty()) list += ", ";
            list += unit.name;
        }
    return list;
}

}  // namespace fstiff::inline v0_1::io
