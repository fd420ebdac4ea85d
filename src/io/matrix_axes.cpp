// SPDX-License-Identifier: BSD-3-Clause
#include "io/matrix_axes.hpp"

namespace fstiff::inline v0_1::io::detail {

double equal_step(const std::vector<double>& positions, double printed) {
    for (const double x : positions)
        if (!std::isfinite(x)) return 0;
    const bool rises = std::is_sorted(positions.begin(), positions.end());
    if (!rises && !std::is_sorted(positions.rbegin(), positions.rend())) return 0;
    const auto axis = axis_of(positions, printed);
    return axis && axis->count == positions.size() ? axis->step : 0;
}

namespace {

/// The units of length in brackets in \p corner, each once, or the one it ends with.
std::vector<std::string> corner_units(std::string_view corner) {
    std::vector<std::string> units;
    for (const Bracket& bracket : brackets_in(corner))
        if (is_unit(bracket.inside, Dimension::length) &&
            std::find(units.begin(), units.end(), bracket.inside) == units.end())
            units.emplace_back(bracket.inside);
    if (const auto unit = title_unit(corner); units.empty() && !unit.empty()) units.emplace_back(unit);
    return units;
}

/// The positions along x in a line, and what is before them.
struct AxisLine {
    std::string_view corner;
    std::vector<double> positions;
    PrintedDigits printed;
};
std::optional<AxisLine> axis_in(std::string_view line, const NumberTable& table) {
    const char separator = table.dialect.separator;
    std::vector<std::string_view> cells;
    split_line(line, separator, cells);
    if (cells.size() < table.columns || (separator != ' ' && cells.size() > table.columns)) return std::nullopt;
    AxisLine axis;
    const std::size_t before = cells.size() - (table.columns - 1);  // blanks may separate the words of the corner
    axis.corner = line.substr(0, static_cast<std::size_t>(cells[before].data() - line.data()));
    if (!axis.corner.empty() && separator != ' ') axis.corner = cells[0];
    for (std::size_t c = before; c < cells.size(); ++c) {
        const auto number = number_in(cells[c], table.dialect.decimal_comma);
        if (!number) return std::nullopt;
        axis.positions.push_back(*number);
        axis.printed.add(cells[c], *number);
    }
    return axis;
}

/// Whether \p positions begin with 0 and 1, or with 1 and 2.
bool counts(const std::vector<double>& positions) {
    return (positions[0] == 0 || positions[0] == 1) && positions[1] == positions[0] + 1;
}

}  // namespace

std::optional<MatrixAxes> axes_of(const NumberTable& table) {
    if (table.columns < 3 || table.rows() < 2) return std::nullopt;
    std::optional<AxisLine> head;
    if (table.first > 0)
        head = axis_in(without_comment_sign(table.lines[table.first - 1].text, table.dialect.separator), table);
    const bool in_table = !head;
    const std::size_t min_size = head ? 2 : std::isnan(table.at(0, 0)) ? 4 : 5;
    if (table.columns < min_size || table.rows() < min_size) return std::nullopt;
    const auto x = head ? head : axis_in(without_comment(table.lines[table.first].text), table);
    if (!x) return std::nullopt;
    std::vector<double> y = column_of(table, 0);
    if (in_table) y.erase(y.begin());
    MatrixAxes axes{.dx = equal_step(x->positions, x->printed.resolution()),
                    .dy = equal_step(y, table.printed[0].resolution()),
                    .in_table = in_table,
                    .line = head ? table.lines[table.first - 1].number : table.row_lines.front()};
    if (!(axes.dx > 0) || !(axes.dy > 0)) return std::nullopt;
    axes.counted = counts(x->positions) && counts(y);
    if (in_table) return axes;
    axes.stated = corner_units(head->corner);
    const bool names_both = head->corner.find_first_of("\\/|") != std::string_view::npos;
    if (counts(x->positions) && !counts(y) && !names_both) return std::nullopt;
    return axes;
}

void drop_first_row(NumberTable& table) {
    table.values.erase(table.values.begin(), table.values.begin() + static_cast<std::ptrdiff_t>(table.columns));
    table.row_lines.erase(table.row_lines.begin());
    table.printed.assign(table.printed.size(), PrintedDigits());
    table.signs.assign(table.signs.size(), ColumnSigns());
    const std::string_view sign = table.dialect.decimal_comma ? "," : ".";
    std::vector<std::string_view> cells;
    std::size_t r = 0;
    for (std::size_t i = table.first; i < table.lines.size() && r < table.rows(); ++i) {
        if (table.lines[i].number != table.row_lines[r]) continue;
        split_row(without_comment(table.lines[i].text), table.dialect.separator, cells);
        for (std::size_t c = 0; c < table.columns; ++c)
            if (const double value = table.at(r, c); std::isfinite(value) && !table.missing.has(value)) {
                if (c < table.printed.size()) table.printed[c].add(cells[c], value);
                table.signs[c].add(cells[c], value, table.row_lines[r], sign);
            }
        ++r;
    }
}

}  // namespace fstiff::inline v0_1::io::detail
