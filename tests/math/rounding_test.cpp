// SPDX-License-Identifier: BSD-3-Clause
// Residuals of known forms: rounding of the scalar, of steps, and more than either.
#include <fstiff/math/rounding.hpp>

#include "support/catch.hpp"

#include <vector>

namespace rounding_test {

using fstiff::math::is_rounding;

namespace {

/// Residual of a line of \p slope with \p wave on it, rounded to steps of \p step, from the line itself.
bool rounding(double slope, double step, double wave, double resolution, double unit) {
    std::vector<double> z(400), rest(400);
    for (std::size_t i = 0; i < z.size(); ++i) {
        const double line = slope * static_cast<double>(i);
        const double there = line + wave * std::sin(0.3 * static_cast<double>(i));
        z[i] = step > 0 ? step * std::round(there / step) : there;
        rest[i] = (z[i] - line) * unit;
        z[i] *= unit;
    }
    return is_rounding(z.data(), rest.data(), z.size(), resolution * unit);
}

}  // namespace

TEST_CASE("Rounding is distinguished from roughness in every unit of length") {
    for (const double unit : {1.0, 1e-9, 1e12}) {
        INFO(unit);
        CHECK(rounding(1. / 3, 0, 0, 0, unit));           // of the scalar
        CHECK_FALSE(rounding(1. / 3, 0, 1e-9, 0, unit));  // small, and there
        CHECK(rounding(0.3, 1, 0, 0, unit));              // of steps, seen in the heights
        CHECK(rounding(2.3, 1, 0, 0, unit));
        CHECK(rounding(0.3, 0.05, 0, 0, unit));
        CHECK_FALSE(rounding(0.3, 1, 2, 0, unit));      // steps of something rough
        CHECK_FALSE(rounding(7, 0.001, 0.1, 0, unit));  // steep and smooth to many digits
        CHECK_FALSE(rounding(7, 0, 0.1, 0, unit));
        CHECK(rounding(1. / 3, 1e-6, 0, 1e-6, unit));  // of steps that the digits show
        CHECK_FALSE(rounding(1. / 3, 1e-6, 1e-5, 1e-6, unit));
    }
    const std::vector<double> two{0, 1, 1, 0, 0, 1, 0, 1}, rest{-.5, .5, .5, -.5, -.5, .5, -.5, .5};
    CHECK_FALSE(is_rounding(two.data(), rest.data(), two.size(), 1.0));  // two heights, not one that is rounded
}

}  // namespace rounding_test
