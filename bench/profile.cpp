// SPDX-License-Identifier: BSD-3-Clause
// Profiles: the structure function of 100,000 points, and 65,536 points of a Weierstrass-Mandelbrot profile.
#include "row.hpp"

#include <fstiff/profile/structure_function.hpp>
#include <fstiff/surface/weierstrass_mandelbrot.hpp>

namespace {

using namespace bench;

constexpr fstiff::Fractal<double> fractal{1.5, 1e-9};
constexpr double longest = 1e-3, shortest = 1e-7, ratio = 1.5;

fstiff::WeierstrassMandelbrot<double> waves(fstiff::Phases phases) {
    return {fractal,
            {.longest_wavelength = longest, .shortest_wavelength = shortest, .gamma = ratio, .phases = phases}};
}

/// z(x) by (2.1) with zero phases, in long double, over the root of the variance.
Accuracy generation_accuracy(std::size_t points, double spacing) {
    const auto profile = waves(fstiff::Phases::zero);
    const std::vector<double> heights = profile.sample(points, spacing);
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
    static const fstiff::Profile<double> profile{waves(fstiff::Phases::random).sample(100000, shortest / 2),
                                                 shortest / 2};
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

const Rows rows([] {
    constexpr std::size_t points = 65536;
    constexpr double spacing = shortest / 2;
    verified_row(
        "profile/weierstrass_mandelbrot/65536", 1e-12, [=] { return generation_accuracy(points, spacing); },
        [=](benchmark::State& state) {
            const auto profile = waves(fstiff::Phases::random);
            for (auto _ : state) {
                const auto heights = profile.sample(points, spacing);
                benchmark::DoNotOptimize(heights.data());
            }
        });
    verified_row("profile/structure_function/100000", 1e-12, structure_accuracy, [](benchmark::State& state) {
        for (auto _ : state) {
            const auto found = fstiff::structure_function(long_profile());
            benchmark::DoNotOptimize(found.value.data());
        }
    });
});

}  // namespace
