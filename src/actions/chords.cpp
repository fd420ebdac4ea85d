// SPDX-License-Identifier: BSD-3-Clause
#include "actions/chords.hpp"

#include <algorithm>
#include <cmath>

namespace fstiff::actions {
namespace {

/// Raises \p worst to the errors of the chords from the points \p begin to the points \p end of \p lines.
void add_chords(const std::vector<Line>& lines, std::size_t begin, std::size_t end, ChordErrors& worst) {
    for (const Line& line : lines) {
        const LinePoint a = line[begin], b = line[end];
        const double slope = (b.y - a.y) / (b.x - a.x);
        for (std::size_t i = begin; i <= end; ++i) {
            const double on_chord = i == end ? b.y : a.y + slope * (line[i].x - a.x);
            worst.value = std::max(worst.value, std::abs(on_chord / line[i].y - 1));
            if (line[i].slope > 0) worst.slope = std::max(worst.slope, std::abs(slope / line[i].slope - 1));
        }
    }
}

bool are_chords_within(const std::vector<Line>& lines, std::size_t begin, std::size_t end, ChordErrors within) {
    ChordErrors worst;
    add_chords(lines, begin, end, worst);
    return worst.value <= within.value && worst.slope <= within.slope;
}

}  // namespace

std::vector<std::size_t> rows_within(const std::vector<Line>& lines, ChordErrors within) {
    const std::size_t size = lines.front().size();
    std::vector<std::size_t> rows{0};
    while (rows.back() + 1 < size) {
        std::size_t end = rows.back() + 1;
        while (end + 1 < size && are_chords_within(lines, rows.back(), end + 1, within)) ++end;
        rows.push_back(end);
    }
    return rows;
}

ChordErrors error_of_rows(const std::vector<Line>& lines, const std::vector<std::size_t>& rows) {
    ChordErrors worst;
    for (std::size_t i = 1; i < rows.size(); ++i) add_chords(lines, rows[i - 1], rows[i], worst);
    return worst;
}

}  // namespace fstiff::actions
