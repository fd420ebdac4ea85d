// SPDX-License-Identifier: BSD-3-Clause
// Measured surfaces: structure functions of long profiles, generated profiles, islands of a map.
#include "row.hpp"

#include <fstiff/math/fft.hpp>
#include <fstiff/profile/structure_function.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/synthetic/weierstrass_mandelbrot.hpp>
#include <fstiff/topography/islands.hpp>

#include <numbers>

namespace {

using namespace bench;

constexpr fstiff::Fractal<double> fractal{1.5, 1e-9};
constexpr double longest = 1e-3, shortest = 1e-7, ratio = 1.5;

fstiff::WeierstrassMandelbrot<double> waves(bool random_phases) {
    return {fractal,
            {.longest_wavelength = longest,
             .shortest_wavelength = shortest,
             .gamma = ratio,
             .random_phases = random_phases}};
}

/// z(x) by (2.1) with zero phases, in long double, over the root of the variance.
Accuracy generation_accuracy(std::size_t points, double spacing) {
    const auto profile = waves(false);
    const std::vector<double> heights = profile.sample(points, spacing).heights;
    const double rms = std::sqrt(profile.variance());
    AccuracyCollector collector;
    for (std::size_t i = 0; i < points; i += 37) {
        const long double x = static_cast<long double>(i) * spacing;
        long double truth = 0;
        for (std::size_t j = 0; j < profile.terms(); ++j) {
            const long double wavelength =
                longest * std::pow(static_cast<long double>(ratio), -static_cast<long double>(j));
            const long double amplitude =
                std::pow(static_cast<long double>(fractal.roughness), fractal.dimension - 1.0L) *
                std::pow(wavelength, 2.0L - fractal.dimension);
            truth += amplitude * std::cos(2 * std::numbers::pi_v<long double> * std::fmod(x / wavelength, 1.0L));
        }
        collector.add(1 + static_cast<double>((heights[i] - truth) / rms), 1);
    }
    collector.add_cost(static_cast<double>(points * profile.terms()));
    return collector.accuracy();
}

const fstiff::Profile<double>& long_profile() {
    static const fstiff::Profile<double> profile = waves(true).sample(100000, shortest / 2);
    return profile;
}

Accuracy structure_accuracy() {
    const auto& z = long_profile().heights;
    const auto found = fstiff::structure_function(long_profile());
    AccuracyCollector collector;
    double pairs = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
        const std::size_t n = found.step[k];
        long double sum = 0;
        for (std::size_t i = 0; i + n < z.size(); ++i) {
            const long double difference = static_cast<long double>(z[i + n]) - z[i];
            sum += difference * difference;
        }
        collector.add(found.value[k], static_cast<double>(sum / static_cast<long double>(z.size() - n)));
        pairs += static_cast<double>(found.pairs[k]);
    }
    collector.add_cost(pairs);
    return collector.accuracy();
}

const fstiff::Profile<double>& million() {
    static const fstiff::Profile<double> profile = waves(true).sample(1000000, shortest / 2);
    return profile;
}

void transform_and_back(std::vector<double>& back) {
    fstiff::math::RealFft<double> fft(million().heights.size());
    std::vector<std::complex<double>> spectrum;
    fft.forward(million().heights, spectrum);
    fft.inverse(spectrum, back);
}

Accuracy transform_accuracy() {
    std::vector<double> back;
    transform_and_back(back);
    const auto& z = million().heights;
    const double rms = fstiff::rms_height(million());
    AccuracyCollector collector;
    for (std::size_t i = 0; i < z.size(); i += 97) collector.add(1 + (back[i] - z[i]) / rms, 1);
    collector.add_cost(static_cast<double>(z.size()));
    return collector.accuracy();
}

const fstiff::HeightMap<double>& map() {
    static const fstiff::HeightMap<double> made = fstiff::self_affine_map<double>(
        {.hurst = 0.8, .rms = 1e-6, .longest_wavelength = 64e-6, .shortest_wavelength = 8e-6}, 2048, 2048, 1e-6, 1e-6);
    return made;
}

const Rows rows_of_profile([] {
    constexpr std::size_t points = 65536;
    constexpr double spacing = shortest / 2;
    verified_row(
        "profile/weierstrass_mandelbrot/65536", 1e-12, [=] { return generation_accuracy(points, spacing); },
        [=](benchmark::State& state) {
            const auto profile = waves(true);
            for (auto _ : state) {
                const auto heights = profile.sample(points, spacing);
                benchmark::DoNotOptimize(heights.heights.data());
            }
        });
    verified_row("profile/structure_function/100000", 1e-12, structure_accuracy, [](benchmark::State& state) {
        for (auto _ : state) {
            const auto found = fstiff::structure_function(long_profile());
            benchmark::DoNotOptimize(found.value.data());
        }
    });
    verified_row("profile/transform_and_back/1000000", 1e-12, transform_accuracy, [](benchmark::State& state) {
        std::vector<double> back;
        for (auto _ : state) {
            transform_and_back(back);
            benchmark::DoNotOptimize(back.data());
        }
    });
    verified_row(
        "topography/islands/2048x2048", 1e-12,
        [] {  // what the curve counts at its own levels, counted again from the heights: the bearing area
            const auto curve = fstiff::island_curve(map());
            AccuracyCollector collector;
            for (std::size_t i = 0; i < curve.size(); i += 10)
                collector.add(curve.bearing_area[i], static_cast<double>((map().heights > curve.level[i]).count()) /
                                                         static_cast<double>(map().heights.size()));
            collector.add_cost(static_cast<double>(map().heights.size()));
            return collector.accuracy();
        },
        [](benchmark::State& state) {
            for (auto _ : state) {
                const auto curve = fstiff::island_curve(map());
                benchmark::DoNotOptimize(curve.level.data());
            }
        });
});

}  // namespace
