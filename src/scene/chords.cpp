// SPDX-License-Identifier: BSD-3-Clause
#include "scene/chords.hpp"

#include <algorithm>
#include <cmath>

namespace fstiff::scene {
namespace {

/// The largest relative error of y on the chord from the point \p begin to the point \p end of \p line.
double error_of_chord(const Line& line, std::size_t begin, std::size_t end) {
    const LinePoint a = line[begin], b = line[end];
    double worst = 0;
    for (std::size_t i = begin + 1; i < end; ++i) {
        const double on_chord = a.y + (b.y - a.y) * (line[i].x - a.x) / (b.x - a.x);
        worst = std::max(worst, std::abs(on_chord / line[i].y - 1));
    }
    return worst;
}

double error_of_chords(const std::vector<Line>& lines, std::size_t begin, std::size_t end) {
    double worst = 0;
    for (const Line& line : lines) worst = std::max(worst, error_of_chord(line, begin, end));
    return worst;
}

}  // namespace

std::vector<std::size_t> rows_within(const std::vector<Line>& lines, double tolerance) {
    const std::size_t size = lines.front().size();
    std::vector<std::size_t> rows{0};
    while (rows.back() + 1 < size) {
        std::size_t end = rows.back() + 1;
        while (end + 1 < size && error_of_chords(lines, rows.back(), end + 1) <= tolerance) ++end;
        rows.push_back(end);
    }
    return rows;
}

double error_of_rows(const std::vector<Line>& lines, const std::vector<std::size_t>& rows) {
    double worst = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) worst = std::max(worst, error_of_chords(lines, rows[i - 1], rows[i]));
    return worst;
}

}  // namespace fstiff::scene
