// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/math/random.hpp>
#include <fstiff/surface/fractal.hpp>
#include <fstiff/surface/structure_coefficient.hpp>
#include <fstiff/synthetic/weierstrass_mandelbrot.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>

namespace weierstrass_mandelbrot_test {

using namespace fstiff;

namespace {

/// (2.1) term by term in long double: the slow twin. Zero phases.
long double slow(long double x, long double d, long double g, long double longest, int terms) {
    long double sum = 0;
    for (int j = 0; j < terms; ++j) {
        const long double wavelength = longest * std::pow(1.5L, -static_cast<long double>(j));
        const long double turns = x / wavelength;
        sum += std::pow(g, d - 1) * std::pow(wavelength, 2 - d) *
               std::cos(2 * std::acos(-1.0L) * (turns - std::floor(turns)));
    }
    return sum;
}

}  // namespace

TEMPLATE_TEST_CASE("A profile of zero phases is the sum (2.1)", "", float, double) {
    using T = TestType;
    const T longest = T(1e-3), shortest = longest * std::pow(T(1.5), T(-20));
    const WeierstrassMandelbrot<T> wm(
        {T(1.62), T(1.2e-8)}, {.longest_wavelength = longest, .shortest_wavelength = shortest, .random_phases = false});
    REQUIRE(wm.terms() == 21);
    const T spacing = T(1.7e-7);
    const auto heights = wm.sample(5000, spacing).heights;
    const T size = std::sqrt(wm.variance());
    T worst = 0, worst_call = 0;
    for (std::size_t i = 0; i < heights.size(); i += 7) {
        const long double truth = slow(static_cast<long double>(i) * spacing, T(1.62), T(1.2e-8), longest, 21);
        worst = std::max(worst, static_cast<T>(std::abs(heights[i] - truth)));
        const T x = static_cast<T>(i) * spacing;
        worst_call = std::max(worst_call, std::abs(wm(x) - static_cast<T>(slow(x, T(1.62), T(1.2e-8), longest, 21))));
    }
    // every amplitude and every cosine is rounded once, and 21 terms add up
    CHECK(worst <= 40 * std::numeric_limits<T>::epsilon() * size);
    CHECK(worst_call <= 40 * std::numeric_limits<T>::epsilon() * size);
}

TEST_CASE("Phases do not drift over 2^16 points") {
    const WeierstrassMandelbrot<double> wm(
        {1.5, 1e-9}, {.longest_wavelength = 1e-2, .shortest_wavelength = 2e-7, .random_phases = false});
    const auto heights = wm.sample(65536, 1e-7).heights;
    const int terms = static_cast<int>(wm.terms());
    double worst = 0;
    for (const std::size_t i : {65535u, 65534u, 65000u, 60001u})
        worst = std::max(worst, std::abs(heights[i] - static_cast<double>(slow(i * static_cast<long double>(1e-7), 1.5,
                                                                               1e-9, 1e-2, terms))));
    CHECK(worst <= 1e-12 * std::sqrt(wm.variance()));
}

TEST_CASE("A seed gives the same phases everywhere, and another seed others") {
    const auto heights = [](std::uint64_t seed) {
        return WeierstrassMandelbrot<double>({1.5, 1e-9},
                                             {.longest_wavelength = 1e-4, .shortest_wavelength = 1e-6, .seed = seed})
            .sample(100, 1e-7)
            .heights;
    };
    CHECK(heights(7) == heights(7));
    CHECK(heights(7) != heights(8));
    // from the integers to the height: one wave of known phase
    std::uint64_t one = 7;
    const double turns = std::ldexp(static_cast<double>(math::splitmix64(one)), -64);
    const WeierstrassMandelbrot<double> wave({1.5, 1e-4},
                                             {.longest_wavelength = 1e-4, .shortest_wavelength = 1e-4, .seed = 7});
    CHECK(std::abs(wave(0) - 1e-4 * std::cos(2 * std::numbers::pi * turns)) <= 1e-18);
}

TEST_CASE("The mean structure function follows the exact constant over a log-period, and wiggles about it") {
    for (const double d : {1.3, 1.5, 1.7}) {
        CAPTURE(d);
        // 200 periods of waves: the band reaches far beyond the lags, so that its ends do not count
        const Fractal<double> fractal{d, 1e-9};
        const WeierstrassMandelbrot<double> wm(fractal, {.longest_wavelength = 1e15, .shortest_wavelength = 1e-25});
        const int steps = 4096;
        double mean = 0, highest = 0, lowest = 10;
        for (int k = 0; k < steps; ++k) {
            const double lag = 1e-6 * std::pow(1.5, k / static_cast<double>(steps));
            const double ratio = wm.structure_function(lag) / detail::structure_function_at(lag, fractal);
            mean += ratio / steps;
            highest = std::max(highest, ratio);
            lowest = std::min(lowest, ratio);
        }
        // The constant is the mean of S / tau^(4-2D) over ln tau. S is a Weierstrass function itself, nowhere smooth:
        // the rule of equal steps converges as steps^-1.1 at D = 1.7 (6e-4 with 64 steps).
        CHECK(test::relative_error(mean, 1.0) < 2e-5);
        if (d == 1.3) CHECK(highest - lowest < 0.03);  // theory: +-1 %
        if (d == 1.7) {                                // theory: -8 to +11 %
            CHECK(std::abs(highest - 1.11) < 0.01);
            CHECK(std::abs(lowest - 0.92) < 0.01);
        }
    }
}

TEST_CASE("The profile does not depend on the unit of length") {
    const auto heights = [](double unit) {
        return WeierstrassMandelbrot<double>({1.62, 1.2e-8 * unit},
                                             {.longest_wavelength = 1e-3 * unit, .shortest_wavelength = 1e-6 * unit})
            .sample(1000, 5e-7 * unit)
            .heights;
    };
    const auto metres = heights(1);
    for (const double unit : {1e-9, 1e9}) {
        const auto scaled = heights(unit);
        double worst = 0;
        for (std::size_t i = 0; i < metres.size(); ++i) worst = std::max(worst, std::abs(scaled[i] / unit - metres[i]));
        // the ratio of spacing to wavelength moves by a rounding, times up to 500 turns
        CHECK(worst <= 1e-12 * 1e-5);
    }
}

TEST_CASE("A generator out of range is refused by name and value") {
    const auto refusal = [](Fractal<double> fractal, WeierstrassMandelbrotOptions<double> options) {
        return test::refusal([&] { WeierstrassMandelbrot<double> wm(fractal, options); });
    };
    CHECK(refusal({2.0, 1e-9}, {.longest_wavelength = 1, .shortest_wavelength = 1}).find("fractal_dimension = 2") !=
          std::string::npos);
    CHECK(refusal({1.5, 0.0}, {.longest_wavelength = 1, .shortest_wavelength = 1}).find("fractal_roughness = 0") !=
          std::string::npos);
    CHECK(refusal({1.5, 1e-9}, {.longest_wavelength = 0, .shortest_wavelength = 1}).find("longest_wavelength = 0") !=
          std::string::npos);
    CHECK(refusal({1.5, 1e-9}, {.longest_wavelength = 1, .shortest_wavelength = 2}).find("shortest_wavelength = 2") !=
          std::string::npos);
    CHECK(refusal({1.5, 1e-9}, {.longest_wavelength = 1, .shortest_wavelength = 0.5, .gamma = 1}).find("gamma = 1") !=
          std::string::npos);
    CHECK(refusal({1.5, 1e-9}, {.longest_wavelength = 1, .shortest_wavelength = 1e-9, .gamma = 1.0000001})
              .find("gamma") != std::string::npos);
    const WeierstrassMandelbrot<double> wm({1.5, 1e-9}, {.longest_wavelength = 1, .shortest_wavelength = 0.1});
    CHECK_FALSE(test::refusal([&] { (void)wm.sample(10, 0.0); }).empty());
    CHECK_FALSE(test::refusal([&] { (void)wm(std::numeric_limits<double>::infinity()); }).empty());
}

}  // namespace weierstrass_mandelbrot_test
