// SPDX-License-Identifier: BSD-3-Clause
// The cut-offs against the surfaces that the generators make with them.
#include <fstiff/surface/fractal.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/synthetic/weierstrass_mandelbrot.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"

#include <array>
#include <numbers>

namespace cut_offs_test {

using namespace fstiff;

namespace {
/// Tables 1 and 2: sigma, D, G.
struct Row {
    double rms;
    Fractal<double> fractal;
};
Row row_of(const test::PaperSurface& surface) {
    return {surface.rms_height, {surface.fractal_dimension, surface.fractal_roughness}};
}
const std::array<Row, 3> rows{row_of(test::paper_surfaces[0]), row_of(test::paper_surfaces[1]),
                              row_of(test::paper_surfaces[2])};
}  // namespace

TEST_CASE("a sum of cosines from the longest cosine down has the rms height that was asked for") {
    for (const Row& row : rows) {
        const double longest = detail::longest_cosine(row.fractal, row.rms);
        CHECK(longest > 1e-4);  // a fraction of a millimetre, as the traces of such surfaces need
        CHECK(longest < 1e-3);
        // terms down to 1e-12 of the longest leave out 1e-12^(4-2D), at most 6.3e-8 at D = 1.7
        const WeierstrassMandelbrot<double> wm(row.fractal,
                                               {.longest_wavelength = longest, .shortest_wavelength = 1e-12 * longest});
        CHECK(test::relative_error(wm.variance(), row.rms * row.rms) < 1e-7);
    }
}

TEST_CASE("sections of a Gaussian map from the longest wave down have the D and G that were asked for") {
    const Row& row = rows[0];
    const double longest = detail::longest_wave(row.fractal, row.rms), hurst = 2 - row.fractal.dimension;
    const std::size_t points = 1024;
    const double spacing = 4 * longest / static_cast<double>(points);  // 4 long waves a side, 256 points a wave
    double worst = 0;
    for (const std::size_t lag : {16u, 32u}) {  // 8 and 16 shortest waves, 1/16 and 1/8 of the longest
        double mean = 0;
        const int seeds = 4;
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const auto map = self_affine_map<double>({.hurst = hurst,
                                                      .rms = row.rms,
                                                      .longest_wavelength = longest,
                                                      .long_waves = LongWaves::none,
                                                      .exact_rms = false,
                                                      .seed = seed},
                                                     points, points, spacing, spacing);
            const auto n = static_cast<Eigen::Index>(lag);
            const auto size = static_cast<Eigen::Index>(points);
            mean += (map.heights.rightCols(size - n) - map.heights.leftCols(size - n)).square().mean() / seeds;
        }
        const double tau = static_cast<double>(lag) * spacing;
        worst = std::max(worst, test::relative_error(mean, detail::structure_function_at(tau, row.fractal)));
    }
    // the waves left out at both ends: of order (shortest/lag)^(2H) and (lag/longest)^2; and the scatter of 4 maps
    CAPTURE(worst);
    CHECK(worst < 0.3);
}

TEST_CASE("the ratio of slope to height of a generated map, and its inverse") {
    const double hurst = 0.38, longest = 1e-3, shortest = 5e-5;
    const double ratio = detail::slope_ratio(hurst, longest, shortest);
    CHECK(test::relative_error(detail::shortest_wave(hurst, longest, ratio), shortest) < 1e-12);
    // by the midpoint rule over the spectrum q^(-2H-1) of a ring; a section has half of the squared slope
    double slopes = 0, heights = 0;
    const int n = 20000;
    const double step = std::log(longest / shortest) / n, pi = std::numbers::pi;
    for (int k = 0; k < n; ++k) {
        const double q = std::exp((k + 0.5) * step) / longest, weight = std::pow(q, -2 * hurst);
        heights += weight;
        slopes += weight * 2 * pi * pi * q * q;
    }
    CHECK(test::relative_error(ratio, slopes / heights) < 1e-7);  // the rule's error, step^2/24 times the curvature
}

TEST_CASE("cut-offs do not depend on the unit of length and refuse impossible arguments") {
    const Row& row = rows[2];
    const double scale = 1e6;
    const Fractal<double> scaled{row.fractal.dimension, row.fractal.roughness * scale};
    CHECK(test::relative_error(detail::longest_wave(scaled, row.rms * scale),
                               scale * detail::longest_wave(row.fractal, row.rms)) < 1e-13);
    CHECK(test::relative_error(detail::longest_cosine(scaled, row.rms * scale),
                               scale * detail::longest_cosine(row.fractal, row.rms)) < 1e-13);
    CHECK_THROWS_AS(detail::longest_cosine<double>({2.0, 1e-8}, 1e-6), domain_error);
    CHECK_THROWS_AS(detail::longest_wave<double>({1.5, 1e-8}, -1e-6), domain_error);
    CHECK_THROWS_AS(detail::slope_ratio(0.5, 1e-3, 2e-3), domain_error);
    CHECK_THROWS_AS(detail::shortest_wave(0.5, 1e-3, 1.0), domain_error);
}

}  // namespace cut_offs_test
