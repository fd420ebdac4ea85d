// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/surface/spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace spectrum_window_test {

using namespace fstiff;

TEST_CASE("Hann's window is half a cosine wave, symmetric, and of mean square 3/8") {
    const std::size_t points = GENERATE(4u, 9u, 100u);
    double square = 0;
    for (std::size_t i = 0; i < points; ++i) {
        const double weight = detail::window_weight<double>(SpectrumWindow::hann, i, points);
        const double turn =
            2 * std::numbers::pi_v<double> * (static_cast<double>(i) + 0.5) / static_cast<double>(points);
        CHECK(std::abs(weight - (1 - std::cos(turn)) / 2) < 1e-15);
        CHECK(std::abs(weight - detail::window_weight<double>(SpectrumWindow::hann, points - 1 - i, points)) < 1e-15);
        CHECK(detail::window_weight<double>(SpectrumWindow::none, i, points) == 1);
        square += weight * weight / static_cast<double>(points);
    }
    CHECK(test::relative_error(square, 3.0 / 8) < 1e-14);
}

}  // namespace spectrum_window_test
