// SPDX-License-Identifier: BSD-3-Clause
#include "io/regular_grid.hpp"

namespace fstiff::inline v0_1::io::detail {

std::vector<double> column_of(const NumberTable& table, std::size_t c) {
    std::vector<double> numbers(table.rows());
    for (std::size_t r = 0; r < numbers.size(); ++r) numbers[r] = table.at(r, c);
    return numbers;
}

double printed_step(const NumberTable& table, std::size_t c) {
    return c < table.printed.size() ? table.printed[c].resolution() : 0;
}

namespace {

/// The values of \p positions in their order. The rows of a raster repeat one another: what is as a row before is left
/// out.
std::vector<double> sorted_positions(const std::vector<double>& positions) {
    std::vector<double> sorted;
    std::size_t period = 1;
    while (period < positions.size() && positions[period] != positions.front()) ++period;
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (i < period || positions[i] != positions[i - period]) sorted.push_back(positions[i]);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

}  // namespace

std::optional<GridAxis> axis_of(const std::vector<double>& all_positions, double printed) {
    const std::vector<double> positions = sorted_positions(all_positions);
    for (const double merged : {0.0, 1.01 * printed}) {
        std::vector<double> lines;
        double begin = 0;
        for (const double x : positions) {
            if (lines.empty() || x - lines.back() > merged) {
                lines.push_back(x);
                begin = x;
            } else {
                lines.back() = begin + (x - begin) / 2;
            }
        }
        if (lines.size() < 2 || !std::isfinite(lines.back() - lines.front())) continue;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; i < lines.size(); ++i) least = (std::min)(least, lines[i] - lines[i - 1]);
        // in steps: how far each line is from the first
        std::vector<double> at(lines.size());
        bool fits = true;
        for (std::size_t i = 1; i < lines.size() && fits; ++i) {
            at[i] = at[i - 1] + std::round((lines[i] - lines[i - 1]) / least);
            fits = at[i] < 1e9;
        }
        if (!fits) continue;
        const double step = (lines.back() - lines.front()) / at.back();
        // printed to less than a quarter of the step, a missing line cannot be distinguished from rounding
        if (printed > 0.25 * step && at.back() >= static_cast<double>(lines.size())) continue;
        const double allowed = 0.01 * step + (std::min)(1.01 * printed, 0.3 * step);
        for (std::size_t i = 1; i < lines.size() && fits; ++i)
            fits = std::abs(lines[i] - (lines.front() + at[i] * step)) <= allowed;
        if (fits) return GridAxis{lines.front(), step, static_cast<std::size_t>(at.back()) + 1};
    }
    return std::nullopt;
}

std::optional<Grid> grid_of(const NumberTable& table, std::size_t x_column, std::size_t y_column) {
    const auto axis = [&](std::size_t c) -> std::optional<GridAxis> {
        const std::vector<double> positions = column_of(table, c);
        if (std::any_of(positions.begin(), positions.end(), [](double x) { return std::isnan(x); })) return {};
        return axis_of(positions, printed_step(table, c));
    };
    const auto x = axis(x_column), y = x ? axis(y_column) : std::nullopt;
    if (!y) return std::nullopt;
    // scattered points lie on a very fine grid of which they fill next to nothing
    const double points = static_cast<double>(x->count) * static_cast<double>(y->count);
    if (points > 10 * static_cast<double>(table.rows())) return std::nullopt;
    return Grid{*x, *y, x_column, y_column};
}

std::size_t points_on(const Grid& grid, const NumberTable& table) {
    std::vector<bool> taken(grid.size());
    for (std::size_t r = 0; r < table.rows(); ++r) {
        const std::size_t point = grid.point(table, r);
        if (taken[point]) return 0;
        taken[point] = true;
    }
    return table.rows();
}

std::vector<double> heights_on(const Grid& grid, const NumberTable& table, const std::vector<double>& heights,
                               const std::string& name) {
    std::vector<double> map(grid.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<std::size_t> line_at(grid.size());
    for (std::size_t r = 0; r < table.rows(); ++r) {
        const std::size_t point = grid.point(table, r);
        if (line_at[point] != 0)
            refuse_line(name, table.row_lines[r],
                        {"repeats the point of line ", line_at[point], ", x = ", table.at(r, grid.x_column),
                         ", y = ", table.at(r, grid.y_column), "; every point must come once"});
        line_at[point] = table.row_lines[r];
        map[point] = heights[r];
    }
    return map;
}

}  // namespace fstiff::inline v0_1::io::detail
