// SPDX-License-Identifier: BSD-3-Clause
// Truth: the structure function of second differences of an exact power law, and differences of it.
#include <fstiff/profile/fractal_result.hpp>
#include <fstiff/profile/window_sensitivity.hpp>
#include <fstiff/surface/structure_coefficient.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace window_spread_test {

using namespace fstiff;

namespace {

/// The line through ln S2 = ln(4 S(n) - S(2n)) of \p fractal, at the reference lag of 20 samples.
detail::LogFit<double> line_of(const Fractal<double>& fractal) {
    detail::LogFit<double> line;
    line.reference = std::log(20.0);
    line.slope = 4 - 2 * fractal.dimension;
    line.level =
        std::log(4 * detail::structure_function_at(20.0, fractal) - detail::structure_function_at(40.0, fractal));
    line.slope_row = Eigen::Vector2d(0, 1);  // values: level and slope themselves
    line.level_row = Eigen::Vector2d(1, 0);
    return line;
}

}  // namespace

TEST_CASE("D and G of an exact power law come back, with their derivatives") {
    for (const double D : {1.1, 1.4, 1.85}) {
        const Fractal<double> truth{D, 1e-3};
        const auto found = detail::fractal_line(line_of(truth), StructureConvention::exact, 1.5);
        CHECK(test::relative_error(found.dimension, D) < 1e-15);
        CHECK(std::abs(found.log_g - std::log(1e-3)) < 1e-11);  // 1/(2 (D - 1)) magnifies the rounding of ln S2
        const auto log_g = [&](double level, double slope) {
            auto moved = line_of(truth);
            moved.level += level, moved.slope += slope;
            return detail::fractal_line(moved, StructureConvention::exact, 1.5).log_g;
        };
        const double step = 1e-5;
        CHECK(test::relative_error(found.log_g_row[0], (log_g(step, 0) - log_g(-step, 0)) / (2 * step)) < 1e-7);
        CHECK(test::relative_error(found.log_g_row[1], (log_g(0, step) - log_g(0, -step)) / (2 * step)) < 1e-5);
        CHECK(found.dimension_row[1] == -0.5);
    }
    auto flat = line_of({1.5, 1e-3});
    flat.slope = -0.1;
    const auto none = detail::fractal_line(flat, StructureConvention::exact, 1.5);
    CHECK(none.dimension > 2);
    CHECK(none.log_g_row.isZero());
}

}  // namespace window_spread_test
