// SPDX-License-Identifier: BSD-3-Clause
#include "actions/measured_curve.hpp"

#include "document/file.hpp"
#include "io/number_table.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/io/units.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <tuple>

namespace fstiff::actions {
namespace {

namespace text = io::detail;

constexpr std::string_view must_name_columns =
    "the first line must name the columns, such as \"pressure [MPa], stiffness [GPa/um], stiffness_error [GPa/um]\" or "
    "\"pressure [MPa], reflection, reflection_error\"";

/// "pressure" and "MPa" of "pressure [MPa]", "pressure (MPa)", "pressure/MPa", "pressure_MPa", "stiffness_Pa_per_m".
struct Title {
    std::string name, unit;
};

Title title_of(std::string_view cell) {
    for (const auto& [open, close] : {std::pair{'[', ']'}, {'(', ')'}}) {
        const std::size_t begin = cell.find(open), end = cell.rfind(close);
        if (begin != std::string_view::npos && end != std::string_view::npos && begin < end)
            return {text::lower_case(text::trimmed(cell.substr(0, begin))),
                    std::string(text::trimmed(cell.substr(begin + 1, end - begin - 1)))};
    }
    const auto is_any = [](std::string_view unit) {
        return io::is_unit(unit, io::Dimension::pressure) || io::is_unit(unit, io::Dimension::stiffness_per_area);
    };
    for (std::size_t i = 0; i < cell.size(); ++i) {
        if (cell[i] != '_' && cell[i] != '/' && cell[i] != ' ') continue;
        std::string unit(cell.substr(i + 1));
        if (const std::size_t per = unit.find("_per_"); per != std::string::npos) unit.erase(per, 4), unit[per] = '/';
        if (is_any(unit)) return {text::lower_case(text::trimmed(cell.substr(0, i))), unit};
    }
    return {text::lower_case(text::trimmed(cell)), ""};
}

/// Kinds of a column, the names of each, and its dimension; none: a plain number.
namespace column {
enum Kind : std::size_t { pressure, stiffness, reflection, error };
}
struct Meaning {
    column::Kind kind;
    std::optional<io::Dimension> dimension;
    std::vector<std::string_view> names;
};
const std::vector<Meaning>& meanings() {
    static const std::vector<Meaning> meanings{
        {column::pressure, io::Dimension::pressure, {"pressure", "p"}},
        {column::stiffness, io::Dimension::stiffness_per_area, {"stiffness", "k", "k/a0"}},
        {column::reflection, {}, {"reflection", "r", "|r|", "r12", "|r12|"}},
        {column::error, io::Dimension::stiffness_per_area, {"stiffness_error", "stiffness error", "k_error"}},
        {column::error, {}, {"reflection_error", "reflection error", "r_error"}},
        // takes its unit from its title, or none
        {column::error,
         io::Dimension::stiffness_per_area,
         {"error", "standard error", "standard_error", "uncertainty", "std", "stdev", "standard deviation"}}};
    return meanings;
}

struct ReadColumn {
    std::size_t index;
    double factor;
};

struct Header {
    std::array<std::optional<ReadColumn>, 4> columns;  ///< by column::Kind
    bool error_is_share = false;                       ///< a plain "error" column without a unit
    std::optional<std::size_t> law, theta, r, answer;  ///< of fstiff run
    [[nodiscard]] bool computed() const { return law.has_value(); }
};

using Cells = std::vector<std::string_view>;

/// The place of the column called \p name.
std::optional<std::size_t> column_called(const Cells& cells, std::string_view name) {
    const auto place = std::find_if(cells.begin(), cells.end(), [&](auto cell) { return text::trimmed(cell) == name; });
    return place == cells.end() ? std::nullopt : std::optional(static_cast<std::size_t>(place - cells.begin()));
}

Header read_header(const Cells& cells, const std::string& where, MeasuredCurve& curve) {
    Header header;
    if (column_called(cells, "eta") && column_called(cells, "law")) {
        header.law = column_called(cells, "law");
        header.theta = column_called(cells, "theta");
        header.r = column_called(cells, "r");
        header.answer = column_called(cells, "answer");
    }
    const bool has_stiffness =
        std::any_of(cells.begin(), cells.end(), [](auto cell) { return title_of(cell).name == "stiffness"; });
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Title title = title_of(cells[i]);
        const auto meaning = std::find_if(meanings().begin(), meanings().end(), [&](const Meaning& known) {
            return std::find(known.names.begin(), known.names.end(), title.name) != known.names.end();
        });
        if (meaning == meanings().end() && !header.computed())
            curve.warnings.push_back(where + "column \"" + std::string(cells[i]) + "\" is not read");
        if (meaning == meanings().end() || i == header.r) continue;
        if (header.computed() && meaning->kind == column::error) {
            curve.decisions.push_back("column " + std::to_string(i + 1) + " \"" + std::string(cells[i]) +
                                      "\" left out: the bound of a computation is not a standard error");
            continue;
        }
        if (header.computed() && meaning->kind == column::reflection && has_stiffness) continue;
        const std::string column = where + "column \"" + std::string(cells[i]) + "\": ";
        double factor = 1;
        const bool is_plain_error = meaning == meanings().end() - 1;
        const bool is_share = !meaning->dimension || (is_plain_error && (title.unit.empty() || title.unit == "%"));
        if (is_plain_error) header.error_is_share = is_share;
        if (is_share) {
            if (!title.unit.empty() && title.unit != "%")
                throw domain_error(column + "has the unit \"" + title.unit + "\"; must be a plain number, or in %");
            factor = title.unit.empty() ? 1 : 0.01;
        } else {
            try {
                if (title.unit.empty())
                    throw domain_error("has no unit; must be one of " + io::accepted_units(*meaning->dimension));
                factor = io::unit_factor(title.unit, *meaning->dimension);
            } catch (const domain_error& refusal) {
                throw domain_error(column + refusal.what());
            }
        }
        if (header.columns[meaning->kind]) throw domain_error(column + "is listed twice");
        header.columns[meaning->kind] = ReadColumn{i, factor};
        curve.decisions.push_back("column " + std::to_string(i + 1) + " \"" + std::string(cells[i]) + "\" read as " +
                                  title.name + (title.unit.empty() ? "" : " in " + title.unit));
    }
    return header;
}

void check_header(const Header& header, const std::string& where) {
    const auto& columns = header.columns;
    if (!columns[column::pressure])
        throw domain_error(where + "there is no column pressure; " + std::string(must_name_columns));
    if (columns[column::stiffness] && columns[column::reflection])
        throw domain_error(where + "there are both a stiffness and a reflection column; must be one of the two");
    if (!columns[column::stiffness] && !columns[column::reflection])
        throw domain_error(where + "there is no column stiffness or reflection; " + std::string(must_name_columns));
    if (columns[column::stiffness] && columns[column::error] && header.error_is_share)
        throw domain_error(where + "the error column has no unit; must be one of " +
                           io::accepted_units(io::Dimension::stiffness_per_area));
}

MeasuredPoint read_row(const Cells& cells, const Header& header, bool decimal_comma, const std::string& where) {
    const auto number = [&](const ReadColumn& column, std::string_view name, bool zero_allowed) {
        const std::string key = where + std::string(name);
        if (column.index >= cells.size()) throw domain_error(key + ": is missing; must be a number");
        const auto parsed = text::number_in(cells[column.index], decimal_comma);
        if (!parsed && decimal_comma && text::number_in(cells[column.index], false))
            throw domain_error(
                key + " = " + text::shown_cell(cells[column.index]) +
                ": must be a number with a decimal comma, as others of the file have, without separators "
                "of thousands");
        const double x = parsed ? *parsed * column.factor : -1;
        if (!parsed || !(x > 0 || (zero_allowed && x == 0)) || !(x <= std::numeric_limits<double>::max()))
            throw domain_error(key + " = " + text::shown_cell(cells[column.index]) +
                               (x > 1 ? ": is beyond the range of double precision in SI; must be a finite number "
                                      : ": must be a finite number ") +
                               (zero_allowed ? "that is not negative" : "greater than 0"));
        return x;
    };
    const auto& columns = header.columns;
    MeasuredPoint point{number(*columns[column::pressure], "pressure", false),
                        columns[column::reflection] ? number(*columns[column::reflection], "reflection", false)
                                                    : number(*columns[column::stiffness], "stiffness", false),
                        0, 0, 0};
    if (columns[column::error]) point.error = number(*columns[column::error], "error", true);
    return point;
}

/// Whether some cell of \p lines is a number with a decimal comma.
bool has_decimal_comma(const std::vector<text::Line>& lines, char separator) {
    Cells cells;
    return std::any_of(lines.begin(), lines.end(), [&](const text::Line& line) {
        text::split_line(line.text, separator, cells);
        return std::any_of(cells.begin(), cells.end(), [](auto cell) {
            return cell.find(',') != std::string_view::npos && text::number_in(cell, true);
        });
    });
}

/// How the one curve of several laws is called that the rows of an answer are.
constexpr std::string_view answer_curve = "answer";

ComputedCurve computed_curve(const Cells& cells, const Header& header) {
    ComputedCurve curve;
    if (header.answer && *header.answer < cells.size() && text::trimmed(cells[*header.answer]) == "1") {
        curve.law = answer_curve;
        return curve;
    }
    if (*header.law < cells.size()) curve.law = text::trimmed(cells[*header.law]);
    const auto number = [&](std::optional<std::size_t> index) -> std::optional<double> {
        if (!index || *index >= cells.size()) return std::nullopt;
        return text::number_in(cells[*index], false);
    };
    curve.theta = number(header.theta);
    curve.r = number(header.r);
    return curve;
}

}  // namespace

std::vector<MeasuredPoint> MeasuredCurve::points_of(const ComputedCurve& wanted) const {
    if (computed.size() < 2) return points;
    std::vector<MeasuredPoint> own;
    for (const MeasuredPoint& point : points)
        if (computed[point.curve] == wanted) own.push_back(point);
    return own;
}

MeasuredCurve read_measured_curve(const std::string& file) {
    MeasuredCurve curve;
    curve.name = document::display_name(file);
    const std::string bytes = document::read_all(file);
    curve.sha256 = document::sha256(bytes);
    const std::string content = text::text_of(bytes, curve.name, "the columns pressure and stiffness or reflection");
    std::size_t count = 0;
    auto lines = text::lines_of(content, curve.name, count);
    std::erase_if(lines, [](const text::Line& line) { return text::is_comment(line.text); });
    if (lines.empty()) throw domain_error(curve.name + ": holds comments only; " + std::string(must_name_columns));
    const auto where = [&](const text::Line& line) { return curve.name + ":" + std::to_string(line.number) + ": "; };
    const char separator = lines.front().text.find(';') != std::string_view::npos    ? ';'
                           : lines.front().text.find('\t') != std::string_view::npos ? '\t'
                           : lines.front().text.find(',') != std::string_view::npos  ? ','
                                                                                     : ' ';
    // of all rows: a point in one of them is then refused, for it may separate thousands
    const bool decimal_comma = separator != ',' && has_decimal_comma(lines, separator);
    Cells cells;
    text::split_line(lines.front().text, separator, cells);
    if (std::all_of(cells.begin(), cells.end(),
                    [&](auto cell) { return text::number_in(cell, decimal_comma).has_value(); }))
        throw domain_error(where(lines.front()) + "is a row of numbers; " + std::string(must_name_columns));
    const Header header = read_header(cells, where(lines.front()), curve);
    check_header(header, where(lines.front()));
    curve.is_reflection = header.columns[column::reflection].has_value();
    curve.has_errors = header.columns[column::error].has_value();
    for (std::size_t row = 1; row < lines.size(); ++row) {
        text::split_line(lines[row].text, separator, cells);
        MeasuredPoint& point = curve.points.emplace_back(read_row(cells, header, decimal_comma, where(lines[row])));
        point.line = lines[row].number;
        if (!header.computed()) continue;
        const ComputedCurve law = computed_curve(cells, header);
        const auto known = std::find(curve.computed.begin(), curve.computed.end(), law);
        point.curve = static_cast<std::size_t>(known - curve.computed.begin());
        if (known == curve.computed.end()) curve.computed.push_back(law);
    }
    if (curve.points.empty()) throw domain_error(curve.name + ": has a header but no row; at least one row is needed");
    if (curve.computed.size() > 1 && curve.computed.front().law == answer_curve) {  // the laws that are named count
        std::erase_if(curve.points, [](const MeasuredPoint& point) { return point.curve == 0; });
        for (MeasuredPoint& point : curve.points) --point.curve;
        curve.computed.erase(curve.computed.begin());
    }
    return curve;
}

void require_distinct_points(const MeasuredCurve& curve) {
    const auto numbers = [](const MeasuredPoint& point) {
        return std::tuple(point.curve, point.pressure, point.value, point.error);
    };
    std::vector<MeasuredPoint> points = curve.points;
    std::sort(points.begin(), points.end(), [&](const MeasuredPoint& a, const MeasuredPoint& b) {
        return std::tuple(numbers(a), a.line) < std::tuple(numbers(b), b.line);
    });
    const auto twice =
        std::adjacent_find(points.begin(), points.end(),
                           [&](const MeasuredPoint& a, const MeasuredPoint& b) { return numbers(a) == numbers(b); });
    if (twice != points.end())
        throw domain_error(curve.name + ":" + std::to_string((twice + 1)->line) + ": is the point of line " +
                           std::to_string(twice->line) + " again; every point must be given once");
}

MeasuredCurve curve_of_numbers(std::span<const double> pressures, std::span<const double> values,
                               std::span<const double> errors, bool is_reflection, const std::string& name) {
    MeasuredCurve curve;
    curve.name = name;
    curve.is_reflection = is_reflection;
    curve.has_errors = !errors.empty();
    if (pressures.empty()) throw domain_error(name + ": has no point; at least one is needed");
    if (values.size() != pressures.size() || (curve.has_errors && errors.size() != pressures.size()))
        throw domain_error(name + ": pressures, values and errors must have the same length");
    std::string bytes;
    for (const auto& list : {pressures, values, errors})
        bytes.append(reinterpret_cast<const char*>(list.data()), list.size_bytes());
    curve.sha256 = document::sha256(bytes);
    for (std::size_t i = 0; i < pressures.size(); ++i) {
        const double error = curve.has_errors ? errors[i] : 0;
        detail::located(Place{.file = name, .line = i + 1, .before_line = ":"}, [&] {
            detail::require_positive("pressure", pressures[i]);
            detail::require_positive(is_reflection ? "reflection" : "stiffness", values[i]);
            detail::require(error >= 0 && error <= std::numeric_limits<double>::max(), "error", error,
                            "finite and not negative");
        });
        curve.points.push_back({.pressure = pressures[i], .value = values[i], .error = error, .line = i + 1});
    }
    return curve;
}

}  // namespace fstiff::actions
