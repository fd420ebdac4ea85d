// SPDX-License-Identifier: BSD-3-Clause
// Truth: the transform of one line by itself.
#include <fstiff/topography/line_transform.hpp>

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace line_transform_test {

using namespace fstiff;

TEMPLATE_TEST_CASE("Lines transformed at once are each that line transformed", "", FSTIFF_SCALARS) {
    using T = TestType;
    using Lines = detail::LinesTransform<T>;
    const auto edges = GENERATE(Edges::periodic, Edges::mirrored);
    const std::size_t points = GENERATE(2u, 3u, 4u, 7u, 15u, 16u, 53u, 60u, 106u, 128u);
    const std::size_t count = GENERATE(std::size_t(Lines::lines), Lines::lines - 3);
    std::mt19937 random(3);
    std::vector<T> rows(points * count);  // a line a row
    for (T& z : rows) z = static_cast<T>(random()) / static_cast<T>(4294967296.0) - T(0.3);
    Lines lines(points, edges);
    lines.load(rows.data(), 1, points, count);
    lines.forward();
    std::vector<T> waves(points * count);  // turned: a line a column
    lines.store(waves.data(), count, 1, count);
    detail::LineTransform<T> one(points, edges);
    CAPTURE(points, count);
    T off = 0;
    for (std::size_t l = 0; l < count; ++l) {
        std::vector<T> line(rows.begin() + static_cast<std::ptrdiff_t>(l * points),
                            rows.begin() + static_cast<std::ptrdiff_t>((l + 1) * points));
        one.forward(line.data());
        for (std::size_t k = 0; k < points; ++k) off = std::max(off, std::abs(waves[k * count + l] - line[k]));
    }
    CHECK(off < 20 * std::numeric_limits<T>::epsilon() * std::sqrt(static_cast<T>(points)));
    lines.multiply(std::vector<T>(points * count, T(2)).data(), count, 1, count);
    lines.inverse();
    std::vector<T> back(rows.size());
    lines.store(back.data(), 1, points, count);
    off = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) off = std::max(off, std::abs(back[i] - 2 * rows[i]));
    CHECK(off < 20 * std::numeric_limits<T>::epsilon());
}

}  // namespace line_transform_test
