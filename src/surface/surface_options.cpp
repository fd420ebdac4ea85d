// SPDX-License-Identifier: BSD-3-Clause
#include "surface/surface_options.hpp"

#include "document/file.hpp"

#include <fstiff/io/quantity.hpp>

#include <algorithm>
#include <cmath>

namespace fstiff::scene {
namespace {

/// A length greater than 0 that came as a number.
double positive_metres(double metres, std::string_view name) {
    if (!(metres > 0 && std::isfinite(metres)))
        throw domain_error(
            {.parameter = name, .value = "\"" + parts::shortest_text(metres) + " m\"", .allowed = "greater than 0"});
    return metres;
}

/// The parts of \p text between its commas.
std::vector<std::string> split_at_commas(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

/// Whether \p text is 0 without a unit.
bool is_bare_zero(const std::string& text) {
    const auto first = text.find_first_not_of(' ');
    return first != std::string::npos && text.find_first_not_of("0. ", first) == std::string::npos &&
           text.find('0') != std::string::npos;
}

}  // namespace

std::string Lengths::text() const {
    if (metres_.empty()) return text_;
    std::string all;
    for (const double one : metres_) all += (all.empty() ? "" : ",") + parts::shortest_text(one) + " m";
    return all;
}

double parse_length(const Lengths& given, std::string_view name) {
    if (given.metres().empty()) return parse_positive(given.text(), io::Dimension::length, name);
    if (given.metres().size() != 1)
        throw domain_error({.parameter = name, .value = "\"" + given.text() + "\"", .allowed = "one length"});
    return positive_metres(given.metres().front(), name);
}

LagWindow<double> parse_window(const Lengths& given, std::string_view name) {
    std::vector<Lengths> ends(given.metres().begin(), given.metres().end());
    if (ends.empty())
        for (std::string& part : split_at_commas(given.text())) ends.emplace_back(std::move(part));
    const std::string quoted = std::string(name) + " = \"" + given.text() + "\": ";
    if (ends.size() < 2) throw option_error(quoted + "must be two lengths, such as \"1 um,100 um\"");
    if (ends.size() > 2)
        throw option_error(quoted + "must be two lengths with one comma between them; the decimal mark is the point");
    const LagWindow<double> window{parse_length(ends[0], name), parse_length(ends[1], name)};
    if (!(window.from < window.to)) throw option_error(quoted + "the first length must be less than the second");
    return window;
}

std::vector<double> parse_lengths(const Lengths& given, std::string_view name) {
    if (!given.metres().empty()) return given.metres();
    std::vector<double> values;
    for (const std::string& part : split_at_commas(given.text()))
        values.push_back(is_bare_zero(part) ? 0 : io::parse_quantity(part, io::Dimension::length, name));
    return values;
}

CutOff<double> parse_cut_off(const Lengths& given, std::string_view name) {
    if (given.empty() || given == Lengths("auto")) return {};
    if (given == Lengths("none")) return no_cut_off;
    return parse_length(given, name);
}

}  // namespace fstiff::scene
