// SPDX-License-Identifier: BSD-3-Clause
#include "io/regular_grid.hpp"

namespace fstiff::inline v0_1::io::detail {

std::optional<GridAxis> axis_of(std::vector<double> positions, double printed) {
    std::sort(positions.begin(), positions.end());
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

std::optional<Grid> grid_of(const NumberTable& table) {
    std::vector<double> positions[2];
    for (std::size_t c = 0; c < 2; ++c) {
        positions[c].resize(table.rows());
        for (std::size_t r = 0; r < table.rows(); ++r) {
            positions[c][r] = table.at(r, c);
            if (std::isnan(positions[c][r])) return std::nullopt;
        }
    }
    const auto x = axis_of(std::move(positions[0]), table.printed[0].resolution());
    if (!x) return std::nullopt;
    const auto y = axis_of(std::move(positions[1]), table.printed[1].resolution());
    if (!y) return std::nullopt;
    // scattered points lie on a very fine grid of which they fill next to nothing
    const double points = static_cast<double>(x->count) * static_cast<double>(y->count);
    if (points > 10 * static_cast<double>(table.rows())) return std::nullopt;
    return Grid{*x, *y};
}

std::size_t points_on(const Grid& grid, const NumberTable& table) {
    std::vector<bool> taken(grid.x.count * grid.y.count);
    for (std::size_t r = 0; r < table.rows(); ++r) {
        const std::size_t at = (std::min)(grid.y.index(table.at(r, 1)), grid.y.count - 1) * grid.x.count +
                               (std::min)(grid.x.index(table.at(r, 0)), grid.x.count - 1);
        if (taken[at]) return 0;
        taken[at] = true;
    }
    return table.rows();
}

std::vector<double> heights_on(const Grid& grid, const NumberTable& table, const std::string& name) {
    std::vector<double> heights(grid.x.count * grid.y.count, std::numeric_limits<double>::quiet_NaN());
    std::vector<std::size_t> line_at(grid.x.count * grid.y.count);
    for (std::size_t r = 0; r < table.rows(); ++r) {
        const double x = table.at(r, 0), y = table.at(r, 1);
        const std::size_t row = (std::min)(grid.y.index(y), grid.y.count - 1);
        const std::size_t at = row * grid.x.count + (std::min)(grid.x.index(x), grid.x.count - 1);
        if (line_at[at] != 0)
            refuse_line(
                name, table.row_lines[r],
                {"repeats the point of line ", line_at[at], ", x = ", x, ", y = ", y, "; every point must come once"});
        line_at[at] = table.row_lines[r];
        heights[at] = table.at(r, 2);  // by row
    }
    return heights;
}

}  // namespace fstiff::inline v0_1::io::detail
