// SPDX-License-Identifier: BSD-3-Clause
#include "surface/surface_options.hpp"

#include "document/file.hpp"

#include <fstiff/io/quantities.hpp>
#include <fstiff/io/units.hpp>

#include <algorithm>

namespace fstiff::surface {
namespace {

/// Whether \p text is 0 without a unit.
bool is_bare_zero(const std::string& text) {
    const auto first = text.find_first_not_of(' ');
    return first != std::string::npos && text.find_first_not_of("0. ", first) == std::string::npos &&
           text.find('0') != std::string::npos;
}

}  // namespace

std::vector<std::string> split_at_commas(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

double parse_length(const Amount& given, std::string_view name) {
    if (given.numbers().size() > 1)
        throw domain_error({.parameter = name, .value = "\"" + given.text("m") + "\"", .allowed = "one length"});
    return document::parse_positive(given.text("m"), io::Dimension::length, name);
}

LengthRange<double> parse_window(const Amount& given, std::string_view name) {
    const std::vector<std::string> ends = split_at_commas(given.text("m"));
    const std::string quoted = std::string(name) + " = \"" + given.text("m") + "\": ";
    if (ends.size() < 2) throw document::option_error(quoted + "must be two lengths, such as \"1 um,100 um\"");
    if (ends.size() > 2)
        throw document::option_error(quoted +
                                     "must be two lengths with one comma between them; the decimal mark is the point");
    const LengthRange<double> window{parse_length(ends[0], name), parse_length(ends[1], name)};
    if (!(window.from < window.to))
        throw document::option_error(quoted + "the first length must be less than the second");
    return window;
}

std::vector<double> parse_lengths(const Amount& given, std::string_view name) {
    if (!given.numbers().empty()) return given.numbers();
    std::vector<double> values;
    for (const std::string& part : split_at_commas(given.text()))
        values.push_back(is_bare_zero(part) ? 0 : io::parse_quantity(part, io::Dimension::length, name));
    return values;
}

CutOff<double> parse_cut_off(const Amount& given, std::string_view name) {
    if (given.empty() || given == Amount("auto")) return {};
    if (given == Amount("none")) return no_cut_off;
    return parse_length(given, name);
}

}  // namespace fstiff::surface
