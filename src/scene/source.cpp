// SPDX-License-Identifier: BSD-3-Clause
#define TOML_IMPLEMENTATION
#include "scene/source.hpp"

#include "document/file.hpp"

namespace fstiff::scene {
namespace {

/// TOML allows characters beyond ASCII in quotation marks and comments only; elsewhere toml++ 3.3 runs into undefined
/// behaviour on some of them, so that a forgotten quotation mark before a µ is reported here.
void refuse_bare_unicode(std::string_view text, const std::string& file) {
    std::size_t line = 1;
    std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    const auto step = [&] { line += text[i++] == '\n' ? 1 : 0; };
    while (i < text.size()) {
        const char c = text[i];
        if (c == '#') {
            while (i < text.size() && text[i] != '\n') ++i;
        } else if (c == '"' || c == '\'') {
            const std::string_view mark =
                text.substr(i, 3) == std::string(3, c) ? text.substr(i, 3) : text.substr(i, 1);
            i += mark.size();
            while (i < text.size() && text.substr(i, mark.size()) != mark && (mark.size() == 3 || text[i] != '\n')) {
                if (c == '"' && text[i] == '\\' && i + 1 < text.size()) step();
                step();
            }
            if (i < text.size() && text[i] == c) i += mark.size();
        } else if (static_cast<unsigned char>(c) >= 0x80) {
            throw domain_error(
                file + ":" + std::to_string(line) +
                ": is not valid TOML: a character beyond ASCII is outside quotation marks; it must be inside");
        } else {
            step();
        }
    }
}

/// The line at which toml++ trips over \p text: that of the shortest beginning of the text that breaks it too.
std::size_t breaking_line(std::string_view text) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') ends.push_back(i + 1);
    const auto broken = std::partition_point(ends.begin(), ends.end(), [text](std::size_t end) {
        try {
            static_cast<void>(toml::parse(text.substr(0, end)));
        } catch (const BrokenToml&) {
            return false;
        } catch (const toml::parse_error&) {  // a table or a text cut short
        }
        return true;
    });
    return static_cast<std::size_t>(broken - ends.begin()) + 1;
}

/// Whether three lines of \p text hold numbers alone, as those of a trace or a map do.
bool holds_numbers(std::string_view text) {
    std::size_t found = 0;
    for (std::size_t begin = 0; begin < text.size() && found < 3;) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = text.substr(begin, end - begin);
        if (line.find_first_of("0123456789") != std::string_view::npos &&
            line.find_first_not_of("0123456789+-.eE,; \t\r") == std::string_view::npos)
            ++found;
        begin = end + 1;
    }
    return found == 3;
}

/// Whether \p text, which is not valid TOML, may be a measured surface: numbers, the JSON of fstiff measure, or binary.
bool is_surface(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r\n");
    return (first != std::string_view::npos && text[first] == '{') || text.find('\0') != std::string_view::npos ||
           holds_numbers(text);
}

}  // namespace

std::string_view si_unit(Dimension dimension) {
    switch (dimension) {
        case Dimension::length: return "m";
        case Dimension::area: return "m^2";
        case Dimension::inverse_area: return "1/m^2";
        case Dimension::pressure: return "Pa";
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

std::string_view example(Dimension dimension) {
    switch (dimension) {
        case Dimension::area: return "195 mm^2";
        case Dimension::inverse_area: return "500 /mm^2";
        case Dimension::pressure: return "10 MPa";
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

std::string written(const toml::node& node) {
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* number = node.as_floating_point())
        return std::isfinite(number->get()) ? shortest(number->get()) : std::isnan(number->get()) ? "nan" : "inf";
    if (const auto* number = node.as_integer()) return std::to_string(number->get());
    if (const auto* truth = node.as_boolean()) return truth->get() ? "true" : "false";
    if (node.is_array()) return node.as_array()->empty() ? "[]" : "[...]";
    if (node.is_table()) return "{...}";
    return "a date or a time";
}

toml::table parse_toml(const std::string& text, const std::string& file) {
    constexpr std::size_t most = std::size_t(1) << 20;
    if (text.size() > most)
        throw domain_error(file + ": has " + std::to_string(text.size()) + " bytes; must be at most 1 MiB");
    const auto refuse = [&](std::size_t line, const std::string& reason) {
        return domain_error(file + ":" + std::to_string(line) + ": is not valid TOML: " + reason);
    };
    if (text.find('\0') != std::string::npos)
        throw domain_error(file + ": is binary, or UTF-16 (it holds NUL bytes); must be TOML, a text in UTF-8");
    refuse_bare_unicode(text, file);
    try {
        return toml::parse(text);
    } catch (const toml::parse_error& error) {
        throw refuse(error.source().begin.line, std::string(error.description()));
    } catch (const BrokenToml&) {
        throw refuse(breaking_line(text), "a character that cannot begin a key or value");
    }
}

toml::table parse_scene(const std::string& text, const std::string& file) {
    toml::table table;
    try {
        table = parse_toml(text, file);
    } catch (const domain_error& error) {
        if (is_surface(text))
            throw domain_error(std::string(error.what()) +
                               "; a measured surface is given by --surface, or by surface.from in a scene");
        throw;
    }
    if (const toml::node* sweep = table.get("sweep"))
        throw domain_error(file + ":" + std::to_string(sweep->source().begin.line) +
                           ": sweep: is a section of a grid, which fstiff sweep reads; remove it from a scene");
    return table;
}

}  // namespace fstiff::scene
