// SPDX-License-Identifier: BSD-3-Clause
#include "actions/measured_curve.hpp"

#include "actions/curve_header.hpp"
#include "document/file.hpp"
#include "io/row_layout.hpp"

#include <fstiff/core/error.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <tuple>

namespace fstiff::actions {
namespace {

namespace text = io::detail;

using Cells = std::vector<std::string_view>;

/// One row of the file.
struct RowReader {
    const Cells& cells;
    bool decimal_comma;
    std::string where;  ///< "file.csv:3: "

    /// The number of \p column as it is written.
    [[nodiscard]] double number(const ReadColumn& column, std::string_view name, bool zero_allowed,
                                bool any_sign = false) const {
        const std::string key = where + std::string(name);
        if (column.index >= cells.size()) throw domain_error(key + ": is missing; must be a number");
        const std::string_view cell = cells[column.index];
        const auto parsed = text::number_in(cell, decimal_comma);
        if (!parsed && decimal_comma && text::number_in(cell, false))
            throw domain_error(
                key + " = " + text::shown_cell(cell) +
                ": must be a number with a decimal comma, as others of the file have, without separators "
                "of thousands");
        const double x = parsed.value_or(-1);
        const bool allowed = parsed && (any_sign || x > 0 || (zero_allowed && x == 0));
        if (!allowed || !(std::abs(x) * column.title.factor <= std::numeric_limits<double>::max()))
            throw domain_error(key + " = " + text::shown_cell(cell) +
                               (x > 1 ? ": is beyond the range of double precision in SI; must be a finite number"
                                      : ": must be a finite number") +
                               (any_sign       ? ""
                                : zero_allowed ? " that is not negative"
                                               : " greater than 0"));
        return x;
    }
    [[nodiscard]] double value(const ReadColumn& column, std::string_view name, bool zero_allowed = false) const {
        const bool logarithm = column.title.scale == CellScale::decibel || column.title.scale == CellScale::loss;
        const double x = number(column, name, zero_allowed, logarithm);
        if (column.title.column != CurveColumn::reflection) return x * column.title.factor;
        const double decibels = column.title.scale == CellScale::loss ? -x : x;
        if (logarithm && decibels > 1)
            throw domain_error(where + std::string(name) + " = " + document::shortest(x) +
                               " dB: would be above 1; |R| in dB is negative, and a positive loss is called "
                               "reflection loss [dB]");
        if (!logarithm && column.title.value(x) > 1.6)
            throw domain_error(where + std::string(name) + " = " + document::shortest(x) +
                               ": must be less than 1; of per cent the title is R [%], of decibels R [dB]");
        return column.title.value(x);
    }
    [[nodiscard]] bool is_missing(const ReadColumn& column) const {
        return column.index >= cells.size() || cells[column.index].empty() ||
               text::is_missing_word(cells[column.index]);
    }
};

/// The points of a row: one for each column of values.
void read_row(const RowReader& row, const CurveHeader& header, std::vector<MeasuredPoint>& points, std::size_t line) {
    MeasuredPoint point{.pressure = 0, .value = 0, .line = line};
    if (const auto& pressure = header.of(CurveColumn::pressure))
        point.pressure = row.value(*pressure, "pressure", true);
    if (const auto& frequency = header.of(CurveColumn::frequency)) point.frequency = row.value(*frequency, "frequency");
    if (const auto& phase = header.of(CurveColumn::phase); phase && !row.is_missing(*phase)) {
        point.phase = row.number(*phase, "phase", true, true) * phase->title.factor;
        if (std::abs(*point.phase) > 6.3)
            throw domain_error(row.where + "phase = " + document::shortest(*point.phase) +
                               ": is beyond a full turn; of degrees the title is phase [deg]");
    }
    const bool no_load = header.of(CurveColumn::pressure) && point.pressure == 0;
    for (const ReadColumn& column : header.values) {
        if (row.is_missing(column) && (header.values.size() > 1 || no_load)) continue;
        if (column.title.pressure) point.pressure = *column.title.pressure;
        if (column.title.frequency) point.frequency = *column.title.frequency;
        point.value =
            row.value(column, header.is_reflection() ? "reflection" : "stiffness", header.is_reflection() || no_load);
        if (const auto& error = header.of(CurveColumn::error)) {
            point.error = row.value(*error, "error", true);
            if (error->title.scale != CellScale::factor) point.error *= std::log(10) / 20 * point.value;
        }
        points.push_back(point);
    }
}

/// Refuses reflections whose unit cannot be what the title states.
void check_scale(const CurveHeader& header, const MeasuredCurve& curve) {
    if (!curve.is_reflection || curve.points.empty()) return;
    const CurveTitle& title = header.values.front().title;
    const auto all = [&](auto test) {
        return std::all_of(curve.points.begin(), curve.points.end(),
                           [&](const MeasuredPoint& point) { return test(point.value); });
    };
    if ((title.scale == CellScale::decibel || title.scale == CellScale::loss) && all([](double R) { return R >= 1; }) &&
        !all([](double R) { return R == 1; }))
        throw domain_error(curve.name +
                           ": all reflections would be above 1; |R| in dB is negative, and a positive loss "
                           "is called reflection loss [dB]");
    if (title.scale == CellScale::factor && title.factor == 0.01 && all([](double R) { return R <= 0.0101; }))
        throw domain_error(curve.name + ": no reflection is above 1 %; a plain number has the title R, without %");
}

/// Takes the rows without load out of \p curve.
void leave_out_unloaded(MeasuredCurve& curve) {
    if (!curve.has_pressures) return;
    const auto first = std::find_if(curve.points.begin(), curve.points.end(),
                                    [](const MeasuredPoint& point) { return point.pressure == 0; });
    if (first == curve.points.end()) return;
    const MeasuredPoint unloaded = *first;
    double furthest = 0;
    for (const MeasuredPoint& point : curve.points)
        if (point.pressure == 0) furthest = std::max(furthest, std::abs(point.value - 1) - 2 * point.error);
    const std::size_t count =
        std::erase_if(curve.points, [](const MeasuredPoint& point) { return point.pressure == 0; });
    curve.left_out =
        count == 1 ? "line " + std::to_string(unloaded.line) + ", without load"
                   : std::to_string(count) + " points without load, the first at line " + std::to_string(unloaded.line);
    if (curve.is_reflection) curve.left_out += ", |R| = " + document::rounded(unloaded.value);
    curve.doubtful = curve.is_reflection && furthest > 0.02;
    if (curve.doubtful)
        curve.warnings.push_back(curve.name + ":" + std::to_string(unloaded.line) +
                                 ": |R| without load is not 1: the reference is not that of a free face, and every |R| "
                                 "is wrong by as much");
    if (curve.points.empty())
        throw domain_error(curve.name + ": has no row with load; pressure must be greater than 0 in one at least");
}

/// How the one curve of several laws is called that the rows of an answer are.
constexpr std::string_view answer_curve = "answer";

ComputedCurve computed_curve(const Cells& cells, const CurveHeader& header) {
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
    if (lines.empty()) throw domain_error(curve.name + ": holds blank lines only; " + std::string(must_name_columns));
    const auto where = [&](const text::Line& line) { return curve.name + ":" + std::to_string(line.number) + ": "; };
    const CurveHeader header = read_header(lines, curve);
    const text::NumberTable table = text::titled_rows(std::move(lines), header.rows, header.separator);
    if (const std::size_t left = table.footer.size(); left > 0)
        curve.decisions.push_back(std::to_string(left) + (left == 1 ? " line" : " lines") + " after the rows not used");
    curve.is_reflection = header.is_reflection();
    curve.has_errors = header.of(CurveColumn::error).has_value();
    curve.has_pressures = header.of(CurveColumn::pressure) || header.values.front().title.pressure;
    curve.has_frequencies = header.of(CurveColumn::frequency) || header.values.front().title.frequency;
    Cells cells;
    for (std::size_t row = table.first; row < table.lines.size(); ++row) {
        const text::Line& line = table.lines[row];
        if (text::is_comment(line.text)) continue;
        text::split_line(line.text, header.separator, cells);
        const std::size_t before = curve.points.size();
        read_row({cells, table.dialect.decimal_comma, where(line)}, header, curve.points, line.number);
        if (!header.computed()) continue;
        const ComputedCurve law = computed_curve(cells, header);
        const auto known = std::find(curve.computed.begin(), curve.computed.end(), law);
        for (std::size_t i = before; i < curve.points.size(); ++i)
            curve.points[i].curve = static_cast<std::size_t>(known - curve.computed.begin());
        if (known == curve.computed.end()) curve.computed.push_back(law);
    }
    if (curve.points.empty()) throw domain_error(curve.name + ": has a header but no row; at least one row is needed");
    check_scale(header, curve);
    leave_out_unloaded(curve);
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
                               std::span<const double> errors, bool is_reflection, const std::string& name,
                               std::span<const double> frequencies) {
    MeasuredCurve curve;
    curve.name = name;
    curve.is_reflection = is_reflection;
    curve.has_errors = !errors.empty();
    curve.has_frequencies = !frequencies.empty();
    curve.has_pressures = !pressures.empty() || !curve.has_frequencies;
    if (values.empty()) throw domain_error(name + ": has no point; at least one is needed");
    const auto has_length = [&](std::span<const double> list, bool needed) {
        return needed ? list.size() == values.size() : list.empty();
    };
    if (!has_length(pressures, curve.has_pressures) || !has_length(errors, curve.has_errors) ||
        !has_length(frequencies, curve.has_frequencies))
        throw domain_error(name + ": pressures, values and errors must have the same length" +
                           (curve.has_frequencies ? ", and so must frequencies" : ""));
    std::string bytes;
    for (const auto& list : {pressures, values, errors, frequencies})
        bytes.append(reinterpret_cast<const char*>(list.data()), list.size_bytes());
    curve.sha256 = document::sha256(bytes);
    for (std::size_t i = 0; i < values.size(); ++i) {
        MeasuredPoint point{.pressure = 0, .value = values[i], .line = i + 1};
        if (curve.has_errors) point.error = errors[i];
        if (curve.has_pressures) point.pressure = pressures[i];
        if (curve.has_frequencies) point.frequency = frequencies[i];
        detail::located(Place{.file = name, .line = i + 1, .before_line = ":"}, [&] {
            if (curve.has_pressures) detail::require_positive("pressure", point.pressure);
            if (curve.has_frequencies) detail::require_positive("frequency", point.frequency);
            detail::require_positive(is_reflection ? "reflection" : "stiffness", point.value);
            detail::require(point.error >= 0 && point.error <= std::numeric_limits<double>::max(), "error", point.error,
                            "finite and not negative");
        });
        curve.points.push_back(point);
    }
    return curve;
}

}  // namespace fstiff::actions
