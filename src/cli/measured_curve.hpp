// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A measured curve from delimited text: pressure with stiffness or reflection, and its standard error where there is one.

#include "output.hpp"
#include "sha256.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/io/quantity.hpp>
#include <fstiff/io/number_table.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::cli {

struct MeasuredPoint {
    double pressure, value;  ///< [Pa]; [Pa/m] or dimensionless
    double error = 0;        ///< of value; 0 without a column of errors
    std::size_t line;        ///< of the file
};

struct MeasuredCurve {
    std::string name, sha256;
    bool is_reflection = false;  ///< else stiffness
    bool has_errors = false;
    std::vector<std::string> decisions;  ///< which column was read as what
    std::vector<MeasuredPoint> points;
};

namespace detail {

/// "pressure" and "MPa" of "pressure [MPa]", "pressure (MPa)", "pressure/MPa", "pressure_MPa", "stiffness_Pa_per_m".
struct Title {
    std::string name, unit;
};

inline Title title_of(std::string_view cell) {
    namespace io_detail = io::detail;
    for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
        const std::size_t begin = cell.find(open), end = cell.rfind(close);
        if (begin != std::string_view::npos && end != std::string_view::npos && begin < end)
            return {io_detail::lower_case(io_detail::trimmed(cell.substr(0, begin))),
                    std::string(io_detail::trimmed(cell.substr(begin + 1, end - begin - 1)))};
    }
    const auto is_any = [](std::string_view unit) {
        return io::is_unit(unit, io::Dimension::pressure) || io::is_unit(unit, io::Dimension::stiffness_per_area);
    };
    for (std::size_t i = 0; i < cell.size(); ++i) {
        if (cell[i] != '_' && cell[i] != '/' && cell[i] != ' ') continue;
        std::string unit(cell.substr(i + 1));
        if (const std::size_t per = unit.find("_per_"); per != std::string::npos) unit.erase(per, 4), unit[per] = '/';
        if (is_any(unit)) return {io_detail::lower_case(io_detail::trimmed(cell.substr(0, i))), unit};
    }
    return {io_detail::lower_case(io_detail::trimmed(cell)), ""};
}

}  // namespace detail

/// Reads \p file ("-" is standard input). The first line that is no comment names the columns with their units:
/// pressure, then stiffness or reflection, and optionally stiffness_error or reflection_error (or error). Others are left.
/// \throws domain_error naming file, line and what must be there.
inline MeasuredCurve read_measured_curve(const std::string& file) {
    namespace text = io::detail;
    constexpr std::string_view columns =
        "the first line must name the columns, such as \"pressure [MPa], stiffness [GPa/um], stiffness_error "
        "[GPa/um]\" "
        "or \"pressure [MPa], reflection, reflection_error\"";
    MeasuredCurve curve;
    curve.name = display_name(file);
    const std::string bytes = read_all(file);
    curve.sha256 = sha256(bytes);
    const std::string content = text::text_of(bytes, curve.name, "the columns pressure and stiffness or reflection");
    std::size_t count = 0;
    auto lines = text::lines_of(content, curve.name, count);
    std::erase_if(lines, [](const text::Line& line) { return text::is_comment(line.text); });
    if (lines.empty()) throw domain_error(curve.name + ": holds comments only; " + std::string(columns));
    const char separator = lines.front().text.find(';') != std::string_view::npos    ? ';'
                           : lines.front().text.find('\t') != std::string_view::npos ? '\t'
                           : lines.front().text.find(',') != std::string_view::npos  ? ','
                                                                                     : ' ';
    const bool decimal_comma = separator != ',';

    struct Column {
        std::size_t index;
        double factor;
    };
    std::optional<Column> pressure, stiffness, reflection, error;
    bool error_is_share = false;  // a plain "error" column takes its unit from its title, or none
    std::vector<std::string_view> cells;
    text::split_line(lines.front().text, separator, cells);
    if (std::all_of(cells.begin(), cells.end(),
                    [&](auto cell) { return text::number_in(cell, decimal_comma).has_value(); }))
        throw domain_error(curve.name + ":" + std::to_string(lines.front().number) + ": is a row of numbers; " +
                           std::string(columns));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const detail::Title title = detail::title_of(cells[i]);
        const auto is = [&](std::initializer_list<std::string_view> names) {
            return std::find(names.begin(), names.end(), title.name) != names.end();
        };
        const auto factor = [&](io::Dimension dimension) {
            try {
                if (title.unit.empty())
                    throw domain_error("has no unit; must be one of " + text::accepted_units(dimension));
                return io::unit_factor(title.unit, dimension);
            } catch (const domain_error& refusal) {
                throw domain_error(curve.name + ":" + std::to_string(lines.front().number) + ": column \"" +
                                   std::string(cells[i]) + "\": " + refusal.what());
            }
        };
        const auto once = [&](std::optional<Column>& column, double scale) {
            if (column)
                throw domain_error(curve.name + ":" + std::to_string(lines.front().number) + ": column \"" +
                                   std::string(cells[i]) + "\": is there twice; must be once");
            column = Column{i, scale};
        };
        if (is({"pressure", "p"}))
            once(pressure, factor(io::Dimension::pressure));
        else if (is({"stiffness", "k", "k/a0"}))
            once(stiffness, factor(io::Dimension::stiffness_per_area));
        else if (is({"reflection", "r", "|r|", "r12", "|r12|"}))
            once(reflection, 1);
        else if (is({"stiffness_error", "stiffness error", "k_error"}))
            once(error, factor(io::Dimension::stiffness_per_area));
        else if (is({"reflection_error", "reflection error", "r_error"}))
            once(error, 1);
        else if (is({"error", "standard error", "standard_error", "uncertainty"})) {
            error_is_share = title.unit.empty();
            once(error, title.unit.empty() ? 1 : factor(io::Dimension::stiffness_per_area));
        } else
            continue;
        curve.decisions.push_back("column " + std::to_string(i + 1) + " \"" + std::string(cells[i]) + "\" read as " +
                                  title.name + (title.unit.empty() ? "" : " in " + title.unit));
    }
    const std::string where = curve.name + ":" + std::to_string(lines.front().number) + ": ";
    if (!pressure) throw domain_error(where + "there is no column pressure; " + std::string(columns));
    if (stiffness && reflection)
        throw domain_error(where + "there are both a stiffness and a reflection column; must be one of the two");
    if (!stiffness && !reflection)
        throw domain_error(where + "there is no column stiffness or reflection; " + std::string(columns));
    if (stiffness && error && error_is_share)
        throw domain_error(where + "the error column has no unit; must be one of " +
                           text::accepted_units(io::Dimension::stiffness_per_area));
    curve.is_reflection = reflection.has_value();
    curve.has_errors = error.has_value();
    const Column value = reflection ? *reflection : *stiffness;

    for (std::size_t row = 1; row < lines.size(); ++row) {
        text::split_line(lines[row].text, separator, cells);
        const auto number = [&](const Column& column, std::string_view name, bool zero_allowed) {
            const std::string at = curve.name + ":" + std::to_string(lines[row].number) + ": " + std::string(name);
            if (column.index >= cells.size()) throw domain_error(at + ": is missing; must be a number");
            const auto found = text::number_in(cells[column.index], decimal_comma);
            const double x = found ? *found * column.factor : -1;
            if (!found || !(x > 0 || (zero_allowed && x == 0)) || !(x <= std::numeric_limits<double>::max()))
                throw domain_error(at + " = " + text::shown_cell(cells[column.index]) + ": must be a finite number " +
                                   (zero_allowed ? "that is not negative" : "greater than 0"));
            return x;
        };
        MeasuredPoint point{number(*pressure, "pressure", false),
                            number(value, reflection ? "reflection" : "stiffness", false), 0, lines[row].number};
        if (error) point.error = number(*error, "error", true);
        curve.points.push_back(point);
    }
    if (curve.points.empty()) throw domain_error(curve.name + ": has a header but no row; at least one row is needed");
    return curve;
}

}  // namespace fstiff::cli
