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

/// The units of length in brackets in \p corner, or the one it ends with.
std::vector<std::string> corner_units(std::string_view corner) {
    std::vector<std::string> found;
    for (std::string_view rest = corner; !rest.empty();) {
        const std::size_t begin = rest.find_first_of("[("), end = rest.find_first_of("])", begin);
        if (begin == std::string_view::npos || end == std::string_view::npos) break;
        const std::string inside(trimmed(rest.substr(begin + 1, end - begin - 1)));
        if (is_unit(inside, Dimension::length) && std::find(found.begin(), found.end(), inside) == found.end())
            found.push_back(inside);
        rest.remove_prefix(end + 1);
    }
    if (const auto unit = title_unit(corner); found.empty() && !unit.empty()) found.emplace_back(unit);
    return found;
}

/// The positions along x in the line above the first row, after a word, and that word; none where there are none.
struct HeadOfAxis {
    std::string_view corner;
    std::vector<double> positions;
    PrintedDigits printed;
};
std::optional<HeadOfAxis> axis_above(const NumberTable& table) {
    if (table.first == 0) return std::nullopt;
    const char separator = table.dialect.separator;
    const std::string_view line = without_comment_sign(table.lines[table.first - 1].text, separator);
    std::vector<std::string_view> cells;
    split_line(line, separator, cells);
    if (cells.size() < table.columns || (separator != ' ' && cells.size() > table.columns)) return std::nullopt;
    HeadOfAxis head;
    const std::size_t before = cells.size() - (table.columns - 1);  // blanks may separate the words of the corner
    head.corner = line.substr(0, static_cast<std::size_t>(cells[before].data() - line.data()));
    if (!head.corner.empty() && separator != ' ') head.corner = cells[0];
    for (std::size_t c = before; c < cells.size(); ++c) {
        const auto number = number_in(cells[c], table.dialect.decimal_comma);
        if (!number) return std::nullopt;
        head.positions.push_back(*number);
        head.printed.add(cells[c], *number);
    }
    return head;
}

}  // namespace

std::optional<MatrixAxes> axes_of(const NumberTable& table) {
    if (table.columns < 3 || table.rows() < 2) return std::nullopt;
    MatrixAxes axes;
    std::vector<double> x, y;
    double printed_x = 0;
    const auto head = axis_above(table);
    if (head) {
        x = head->positions, printed_x = head->printed.resolution();
        axes.stated = corner_units(head->corner);
        axes.line = table.lines[table.first - 1].number;
    } else {
        const std::size_t least = std::isnan(table.at(0, 0)) ? 4 : 5;
        if (table.columns < least || table.rows() < least) return std::nullopt;
        PrintedDigits printed;
        std::vector<std::string_view> cells;
        split_row(without_comment(table.lines[table.first].text), table.dialect.separator, cells);
        for (std::size_t c = 1; c < table.columns; ++c) {
            x.push_back(table.at(0, c));
            if (std::isfinite(x.back())) printed.add(cells[c], x.back());
        }
        printed_x = printed.resolution();
        axes.in_table = true;
        axes.line = table.row_lines.front();
    }
    for (std::size_t r = axes.in_table ? 1 : 0; r < table.rows(); ++r) y.push_back(table.at(r, 0));
    axes.dx = equal_step(x, printed_x);
    if (!(axes.dx > 0)) return std::nullopt;
    axes.dy = equal_step(y, table.printed[0].resolution());
    if (!(axes.dy > 0)) return std::nullopt;
    const auto counts = [](const std::vector<double>& one) {
        return (one[0] == 0 || one[0] == 1) && one[1] == one[0] + 1;
    };
    axes.counted = counts(x) && counts(y);
    const bool names_both = head && head->corner.find_first_of("\\/|") != std::string_view::npos;
    if (head && counts(x) && !counts(y) && !names_both) return std::nullopt;
    return axes;
}

void drop_axes(NumberTable& table, const MatrixAxes& axes) {
    const std::size_t columns = table.columns--, first = axes.in_table ? 1 : 0, rows = table.rows() - first;
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t c = 0; c < table.columns; ++c)
            table.values[r * table.columns + c] = table.values[(r + first) * columns + c + 1];
    table.values.resize(rows * table.columns);
    if (axes.in_table) table.row_lines.erase(table.row_lines.begin());
    // the digits and signs of the heights alone
    table.printed.assign(std::min<std::size_t>(table.columns, 4), PrintedDigits());
    table.signs.assign(columns, ColumnSigns());
    const std::string_view sign = table.dialect.decimal_comma ? "," : ".";
    std::vector<std::string_view> cells;
    std::size_t r = 0;
    for (std::size_t i = table.first; i < table.lines.size() && r < rows; ++i) {
        if (table.lines[i].number != table.row_lines[r]) continue;
        split_row(without_comment(table.lines[i].text), table.dialect.separator, cells);
        for (std::size_t c = 0; c < table.columns; ++c)
            if (const double value = table.at(r, c); std::isfinite(value) && !table.missing.has(value)) {
                if (c < table.printed.size()) table.printed[c].add(cells[c + 1], value);
                table.signs[c + 1].add(cells[c + 1], value, table.row_lines[r], sign);
            }
        ++r;
    }
}

}  // namespace fstiff::inline v0_1::io::detail
