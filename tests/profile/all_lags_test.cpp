// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/profile/all_lags.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/synthetic/weierstrass_mandelbrot.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/fractional_brownian.hpp"

#include <functional>
#include <numbers>

namespace all_lags_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// (2.8) in long double over the pairs that exist: 64 bits of mantissa against 1e-10.
long double slow(const std::vector<double>& z, std::size_t n) {
    long double sum = 0;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i + n < z.size(); ++i) {
        const long double d = static_cast<long double>(z[i + n]) - z[i];
        if (std::isnan(d)) continue;
        sum += d * d;
        ++pairs;
    }
    return pairs > 0 ? sum / static_cast<long double>(pairs) : -1;
}

struct Shape {
    const char* name;
    std::function<std::vector<double>(std::size_t)> heights;
};

std::vector<double> waves(std::size_t points, double length) {
    std::vector<double> z(points);
    for (std::size_t i = 0; i < points; ++i)
        z[i] = std::sin(2 * std::numbers::pi * static_cast<double>(i) / length + 0.3);
    return z;
}

std::vector<double> weierstrass(std::size_t points, double dimension) {
    const double h = 1e-7;
    const WeierstrassMandelbrot<double> wm(
        {dimension, 1.2e-10},
        {.longest_wavelength = static_cast<double>(points) * h, .shortest_wavelength = 2 * h, .seed = 3});
    return wm.sample(points, h).heights;
}

const Shape shapes[]{
    {"random walk", [](std::size_t n) { return test::fractional_brownian(n, 0.5, 1); }},
    {"fractional H = 0.9", [](std::size_t n) { return test::fractional_brownian(n, 0.9, 2); }},
    {"Weierstrass 1.1", [](std::size_t n) { return weierstrass(n, 1.1); }},
    {"Weierstrass 1.8", [](std::size_t n) { return weierstrass(n, 1.8); }},
    {"one sine", [](std::size_t n) { return waves(n, static_cast<double>(n)); }},
    {"short sine", [](std::size_t n) { return waves(n, 37.7); }},
    {"exact period",
     [](std::size_t n) {
         std::vector<double> z(n);
         for (std::size_t i = 0; i < n; ++i) z[i] = static_cast<double>(i * i % 50);
         return z;
     }},
    {"a parabola",
     [](std::size_t n) {
         std::vector<double> z(n);
         for (std::size_t i = 0; i < n; ++i) z[i] = static_cast<double>(i) * static_cast<double>(i) * 1e-9;
         return z;
     }},
    {"a step in a flat",
     [](std::size_t n) {
         std::vector<double> z(n, 0.0);
         for (std::size_t i = n / 2; i < n; ++i) z[i] = 1;
         return z;
     }},
    {"quantised walk",
     [](std::size_t n) {
         auto z = test::fractional_brownian(n, 0.5, 4);
         for (double& v : z) v = std::round(v / 3);
         return z;
     }},
};

double rms(const std::vector<double>& z) { return rms_height(Profile<double>{z, 1.0}); }

}  // namespace

TEST_CASE("S is the mean over the pairs within 1e-10 at every lag, whatever the offset, the tilt and the gaps") {
    const double offset = GENERATE(0.0, 1e6), tilt = GENERATE(0.0, 1e6);  // times the roughness
    const bool gaps = GENERATE(false, true);
    const std::size_t points = 2048;
    double worst = 0;
    for (const Shape& shape : shapes) {
        auto z = shape.heights(points);
        const double sigma = rms(z);
        for (std::size_t i = 0; i < points; ++i) {
            z[i] += offset * sigma + tilt * sigma * static_cast<double>(i) / static_cast<double>(points);
            if (gaps && (i % 13 == 5 || (i > 700 && i < 800))) z[i] = missing;
        }
        const auto s = detail::structure_function_at_all_lags(Profile<double>{z, 1e-6});
        std::size_t k = 0;
        for (std::size_t n = 1; n < points; ++n) {
            const long double truth = slow(z, n);
            if (truth < 0) continue;  // no pair
            REQUIRE(k < s.size());
            REQUIRE(s.step[k] == n);
            CAPTURE(shape.name, offset, tilt, gaps, n, s.value[k], truth);
            const double error = test::relative_error(s.value[k], static_cast<double>(truth));
            REQUIRE(error < 1e-10);
            worst = std::max(worst, error);
            ++k;
        }
        REQUIRE(k == s.size());
    }
    WARN("worst relative error " << worst << " with offset " << offset << ", tilt " << tilt << (gaps ? ", gaps" : ""));
}

TEST_CASE("Long profiles keep 1e-10 at the shortest, the middle and the longest lags") {
    const std::size_t points = 1u << 17;
    for (const Shape& shape : shapes) {
        auto z = shape.heights(points);
        const auto s = detail::structure_function_at_all_lags(Profile<double>{z, 1e-6});
        REQUIRE(s.size() == points - 1);
        std::vector<std::size_t> lags = detail::logarithmic_lags(points - 1, 3);
        for (std::size_t k = 1; k < 4; ++k) lags.push_back(points - k * k);
        for (const std::size_t n : lags) {
            CAPTURE(shape.name, n);
            CHECK(test::relative_error(s.value[n - 1], static_cast<double>(slow(z, n))) < 1e-10);
            CHECK(s.pairs[n - 1] == points - n);
        }
    }
}

TEST_CASE("All lags are those of the direct sum, with the divisor asked for, in every scalar") {
    const auto z = test::fractional_brownian(512, 0.5, 7);
    const Profile<double> profile{z, 2e-6};
    std::vector<std::size_t> lags;
    for (std::size_t n = 1; n < 512; ++n) lags.push_back(n);
    for (const Divisor divisor : {Divisor::pairs, Divisor::paper}) {
        const auto all = detail::structure_function_at_all_lags(profile, 0, divisor);
        const auto direct = structure_function(profile, std::span<const std::size_t>(lags), divisor);
        REQUIRE(all.step == direct.step);
        CHECK(all.pairs == direct.pairs);
        CHECK(all.lag == direct.lag);
        for (std::size_t k = 0; k < all.size(); ++k)
            REQUIRE(test::relative_error(all.value[k], direct.value[k]) < 1e-10);
    }
    const auto few = detail::structure_function_at_all_lags(profile, 10);
    CHECK(few.step.back() == 10);
    const auto narrow =
        detail::structure_function_at_all_lags(Profile<float>{std::vector<float>(z.begin(), z.end()), 2e-6f});
    const auto direct = structure_function(profile, std::span<const std::size_t>(lags));
    for (std::size_t k = 0; k < 511; ++k) {
        // the heights were rounded to 6e-8 of at most 60, differences of order 1 and more
        REQUIRE(test::relative_error(static_cast<double>(narrow.value[k]), direct.value[k]) < 1e-4);
    }
}

TEST_CASE("All lags scale with the unit of length") {
    const auto z = test::fractional_brownian(1024, 0.7, 8);
    const auto s = detail::structure_function_at_all_lags(Profile<double>{z, 1e-6});
    for (const double unit : {1e-9, 1e9}) {
        auto scaled = z;
        for (double& v : scaled) v *= unit;
        const auto t = detail::structure_function_at_all_lags(Profile<double>{scaled, 1e-6 * unit});
        REQUIRE(t.step == s.step);
        for (std::size_t k = 0; k < s.size(); ++k)
            REQUIRE(test::relative_error(t.value[k], s.value[k] * unit * unit) < 2e-10);
    }
}

TEST_CASE("Profiles without pairs of few points or with an infinite height have separate messages") {
    CHECK(detail::structure_function_at_all_lags(Profile<double>{{missing, missing, 1.0}, 1.0}).size() == 0);
    CHECK(detail::structure_function_at_all_lags(Profile<double>{{missing, missing}, 1.0}).size() == 0);
    const auto two = detail::structure_function_at_all_lags(Profile<double>{{1.0, 4.0}, 1.0});
    REQUIRE(two.size() == 1);
    CHECK(two.value[0] == 9.0);
    const auto flat = detail::structure_function_at_all_lags(Profile<double>{std::vector<double>(100, 3.0), 1.0});
    REQUIRE(flat.size() == 99);
    for (const double s : flat.value) CHECK(s == 0.0);
    const auto refusal = [](std::vector<double> z, double spacing, std::size_t longest) {
        return test::refusal([&] {
            (void)detail::structure_function_at_all_lags(Profile<double>{z, spacing}, longest);
        });
    };
    CHECK(refusal({1.0}, 1.0, 0).find("between 2 and 2^29") != std::string::npos);
    CHECK(refusal({1.0, 2.0}, 1.0, 2).find("lag = 2 samples") != std::string::npos);
    CHECK(refusal({1.0, 2.0}, 0.0, 0).find("spacing") != std::string::npos);
    CHECK(refusal({1.0, std::numeric_limits<double>::infinity()}, 1.0, 0).find("height") != std::string::npos);
    CHECK(refusal({1e250, 0.0}, 1.0, 0).find("structure function = ") == 0);
}

}  // namespace all_lags_test
