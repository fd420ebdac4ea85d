// SPDX-License-Identifier: BSD-3-Clause
#include "io/zygo_xyz.hpp"

#include "io/number_table.hpp"

namespace fstiff::inline v0_1::io::detail {

std::size_t zygo_header(const std::vector<Line>& lines) {
    if (!lines.front().text.starts_with(zygo_xyz_begin)) return 0;
    const auto end = std::find_if(lines.begin(), lines.end(), [](const Line& line) { return line.text == "#"; });
    return static_cast<std::size_t>(end - lines.begin());
}

double zygo_pixel(const std::vector<Line>& lines, const std::string& name) {
    double pixel = 0;
    for (const Line& line : lines)
        if (std::vector<std::string_view> cells; line.number == 8) {
            split_line(line.text, ' ', cells);
            if (cells.size() > 6) pixel = number_in(cells[6], false).value_or(0);
        }
    if (!(pixel > 0) || !std::isfinite(pixel))
        refuse_line(name, 8, {"states no size of a pixel; must hold it as its seventh number [m], greater than 0"});
    return pixel;
}

}  // namespace fstiff::inline v0_1::io::detail
