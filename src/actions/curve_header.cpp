// SPDX-License-Identifier: BSD-3-Clause
#include "actions/curve_header.hpp"

#include "io/column_titles.hpp"

#include <fstiff/core/error.hpp>
#include <fstiff/io/units.hpp>

#include <algorithm>

namespace fstiff::actions {
namespace {

namespace text = io::detail;

using Cells = std::vector<std::string_view>;
using Titles = std::vector<std::string>;

/// The titles of \p line between \p separator.
Titles titles_in(std::string_view line, char separator) {
    Cells cells;
    text::split_titles(line, separator, cells);
    Titles titles(cells.begin(), cells.end());
    while (!titles.empty() && titles.back().empty()) titles.pop_back();
    return titles;
}

std::size_t named_in(const Titles& titles) {
    return static_cast<std::size_t>(std::count_if(titles.begin(), titles.end(), names_curve_column));
}

/// Appends the units of \p line, which holds nothing else, to the titles above it that state none.
bool take_units(Titles& titles, std::string_view line, char separator) {
    const Titles units = titles_in(line, separator);
    Titles joined = titles;
    std::size_t taken = 0;
    for (std::size_t i = 0; i < units.size(); ++i) {
        std::string unit = units[i];
        if (unit.size() > 2 && (unit.front() == '[' || unit.front() == '(')) unit = unit.substr(1, unit.size() - 2);
        if (i >= titles.size() || unit == "1") return false;
        if (!names_curve_column(titles[i]) || unit.empty()) continue;
        if (!is_curve_unit(unit)) return false;
        joined[i] += " [" + unit + "]", ++taken;
    }
    if (taken > 0) titles = joined;
    return taken > 0;
}

/// Whether the row at \p place of \p lines, if there is one, has numbers and \p count cells.
bool is_row(const std::vector<text::Line>& lines, std::size_t place, char separator, std::size_t count) {
    while (place < lines.size() && text::is_comment(lines[place].text)) ++place;
    if (place == lines.size()) return false;
    const Titles cells = titles_in(lines[place].text, separator);
    return cells.size() == count && std::any_of(cells.begin(), cells.end(), [](const std::string& cell) {
               return text::number_in(cell, false) || text::number_in(cell, true);
           });
}

/// The first line that names two columns of a curve or more, else the first line that is no comment.
CurveHeader find_titles(const std::vector<text::Line>& lines, const std::string& name) {
    constexpr std::string_view separators = ";\t, ";
    constexpr std::size_t longest = 200;  // lines above the titles
    for (std::size_t i = 0; i < std::min(lines.size(), longest); ++i)
        for (const char separator : separators) {
            CurveHeader header{.separator = separator, .line = i, .rows = i + 1};
            header.titles = titles_in(text::without_comment_sign(lines[i].text, separator), separator);
            if (named_in(header.titles) < 2) continue;
            if (i + 1 < lines.size() && take_units(header.titles, lines[i + 1].text, separator)) ++header.rows;
            const bool may_be_prose = separator == ' ' || text::is_comment(lines[i].text);
            if (may_be_prose && !is_row(lines, header.rows, separator, header.titles.size())) continue;
            return header;
        }
    CurveHeader header;
    while (header.line < lines.size() && text::is_comment(lines[header.line].text)) ++header.line;
    if (header.line == lines.size())
        throw domain_error(name + ": holds comments only; " + std::string(must_name_columns));
    const std::string_view first = lines[header.line].text;
    header.separator = separators[std::min(separators.find_first_of(first), separators.size() - 1)];
    for (const char separator : separators)
        if (first.find(separator) != first.npos) {
            header.separator = separator;
            break;
        }
    header.titles = titles_in(first, header.separator);
    header.rows = header.line + 1;
    return header;
}

/// The place of the column called \p name.
std::optional<std::size_t> column_called(const Titles& titles, std::string_view name) {
    const auto place = std::find(titles.begin(), titles.end(), name);
    return place == titles.end() ? std::nullopt : std::optional(static_cast<std::size_t>(place - titles.begin()));
}

/// Whether a computed curve leaves out \p title, with a decision where somebody may miss it.
bool is_left_by_computed(const CurveTitle& title, std::string_view cell, std::size_t place, bool has_stiffness,
                         MeasuredCurve& curve) {
    if (title.column == CurveColumn::error)
        curve.decisions.push_back("column " + std::to_string(place + 1) + " \"" + std::string(cell) +
                                  "\" left out: the bound of a computation is not a standard error");
    return title.column == CurveColumn::error || title.column == CurveColumn::phase ||
           title.column == CurveColumn::frequency || (title.column == CurveColumn::reflection && has_stiffness);
}

void read_titles(CurveHeader& header, const std::string& where, MeasuredCurve& curve) {
    const Titles& titles = header.titles;
    if (column_called(titles, "eta") && column_called(titles, "law")) {
        header.law = column_called(titles, "law");
        header.theta = column_called(titles, "theta");
        header.r = column_called(titles, "r");
        header.answer = column_called(titles, "answer");
    }
    const bool has_stiffness = std::any_of(titles.begin(), titles.end(),
                                           [](const std::string& title) { return title.starts_with("stiffness"); });
    for (std::size_t i = 0; i < titles.size(); ++i) {
        const std::string shown = "column " + text::shown_cell(titles[i]);
        if (header.computed() && i == header.r) continue;
        const auto title = detail::located(Place{.file = where + shown}, [&] { return curve_title(titles[i]); });
        if (!title && !header.computed() && !titles[i].empty())
            curve.warnings.push_back(where + shown + " is not read");
        if (!title) continue;
        if (header.computed() && is_left_by_computed(*title, titles[i], i, has_stiffness, curve)) continue;
        const bool is_value = title->column == CurveColumn::stiffness || title->column == CurveColumn::reflection;
        std::optional<ReadColumn>& column = header.columns[static_cast<std::size_t>(title->column)];
        const auto& values = header.values;
        const bool again = std::any_of(values.begin(), values.end(), [&](const ReadColumn& other) {
            return other.title.column == title->column && other.title.frequency == title->frequency &&
                   other.title.pressure == title->pressure;
        });
        if (is_value ? again : column.has_value()) throw domain_error(where + shown + ": is listed twice");
        if (is_value)
            header.values.push_back({i, *title});
        else
            column = ReadColumn{i, *title};
        curve.decisions.push_back("column " + std::to_string(i + 1) + " \"" + titles[i] + "\" read as " + title->name +
                                  (title->unit.empty() ? "" : " in " + title->unit));
    }
}

void check_errors(const CurveHeader& header, const std::string& where) {
    const auto& error = header.of(CurveColumn::error);
    if (!error) return;
    const CurveTitle &title = error->title, &value = header.values.front().title;
    const auto refuse = [&](const std::string& what) { throw domain_error(where + "the error column " + what); };
    if (!header.is_reflection() && title.is_share)
        refuse("has no unit; must be one of " + io::accepted_units(io::Dimension::stiffness_per_area));
    if (!header.is_reflection()) return;
    if (!title.is_share) refuse("is that of a stiffness; must be that of the reflection");
    const bool in_decibels = value.scale == CellScale::decibel || value.scale == CellScale::loss;
    if (value.scale == CellScale::energy || (title.scale != CellScale::factor) != in_decibels ||
        (value.factor != 1 && title.unit.empty()))
        refuse("must have the unit of the reflection, which is " + (value.scale == CellScale::energy
                                                                        ? "then of amplitudes"
                                                                    : value.unit.empty() ? "none"
                                                                                         : value.unit));
}

void check_titles(const CurveHeader& header, const std::string& where) {
    const auto has = [&](CurveColumn column) { return header.of(column).has_value(); };
    const auto all = [&](auto member) {
        return std::all_of(header.values.begin(), header.values.end(),
                           [&](const ReadColumn& value) { return (value.title.*member).has_value(); });
    };
    const bool pressures = has(CurveColumn::pressure) || (!header.values.empty() && all(&CurveTitle::pressure)),
               frequencies = has(CurveColumn::frequency) || (!header.values.empty() && all(&CurveTitle::frequency));
    if (!pressures && !frequencies)
        throw domain_error(where + "there is no column pressure; " + std::string(must_name_columns));
    if (header.values.empty())
        throw domain_error(where + "there is no column stiffness or reflection; " + std::string(must_name_columns));
    for (const ReadColumn& value : header.values)
        if (value.title.column != header.values.front().title.column)
            throw domain_error(where + "there are both a stiffness and a reflection column; must be one of the two");
    if (!header.is_reflection() && !pressures)
        throw domain_error(where + "there is no column pressure; stiffnesses need it");
    const auto two_places = [&](CurveColumn column, auto member) {
        return has(column) && std::any_of(header.values.begin(), header.values.end(),
                                          [&](const ReadColumn& value) { return (value.title.*member).has_value(); });
    };
    if (two_places(CurveColumn::pressure, &CurveTitle::pressure) ||
        two_places(CurveColumn::frequency, &CurveTitle::frequency))
        throw domain_error(where + "a column and a title state the same quantity; must be one of the two");
    if (header.values.size() > 1 && (has(CurveColumn::error) || has(CurveColumn::phase)))
        throw domain_error(where + "there are " + std::to_string(header.values.size()) +
                           " columns of values and one of errors or phases; must be a row for each value");
    check_errors(header, where);
}

}  // namespace

CurveHeader read_header(const std::vector<text::Line>& lines, MeasuredCurve& curve) {
    CurveHeader header = find_titles(lines, curve.name);
    const std::string where = curve.name + ":" + std::to_string(lines[header.line].number) + ": ";
    if (std::all_of(header.titles.begin(), header.titles.end(), [](const std::string& title) {
            return text::number_in(title, false) || text::number_in(title, true);
        }))
        throw domain_error(where + "is a row of numbers; " + std::string(must_name_columns));
    read_titles(header, where, curve);
    check_titles(header, where);
    return header;
}

}  // namespace fstiff::actions
