// SPDX-License-Identifier: BSD-3-Clause
// The band of a measured surface against its parts computed one by one; tests/scene/one_measurement_test.cpp holds the
// band of the command to it.
#include <fstiff/measured/widened_band.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <vector>

namespace widened_band_test {

using namespace fstiff;
using test::relative_error;

namespace {

Profile<double> trace() {
    return self_affine_profile<double>({.hurst = 0.4, .rms = 0.3e-6, .longest_wavelength = 90e-6, .seed = 3}, 4096,
                                       0.5e-6);
}

const auto hertz = [](double) { return HertzLaw<double>{}; };
const auto fractal = [](double dimension) { return FractalLaw<double>(dimension); };
const std::vector<double> pressures{1e6, 1e7};

/// K of \p surface by itself.
double stiffness_of(const parts::SurfaceParameters<double>& surface, double pressure) {
    const RoughContact contact(
        Roughness<double>{surface.rms_height.value, surface.peak_radius.value, surface.peak_density.value},
        PeakDistribution<double>(surface.r->value, surface.theta->value), HertzLaw<double>{}, 112.6e9);
    return contact.at_pressure(pressure, Quantity::stiffness).stiffness.value;
}

}  // namespace

TEST_CASE("Unknowns widen a band by squares as do those of one kind and the greatest is reported") {
    const double k = 2e14;
    const auto curves = [](parts::Unknown which, double low, double high) {
        return parts::UnknownCurves<double>{which, {std::exp(low)}, {std::exp(high)}};
    };
    const std::vector<parts::UnknownCurves<double>> unknowns{
        curves(parts::Unknown::gradient, -0.3, 0.4), curves(parts::Unknown::gradient, 0.3, -0.4),  // of the other face
        curves(parts::Unknown::alpha, 0.1, std::numeric_limits<double>::quiet_NaN()),
        curves(parts::Unknown::skewness, 0.05, -0.2), curves(parts::Unknown::kurtosis, -0.1, 0)};
    const auto wide =
        parts::widened<double>(k, {k * std::exp(-0.2), k, k * std::exp(0.1), 0}, {}, {}, 0, false, 1, unknowns);
    const auto& parts = wide.parts;
    CHECK(relative_error(-parts.prior_low, std::hypot(0.3, 0.4)) < 1e-14);
    CHECK(relative_error(parts.prior_high, std::hypot(0.4, 0.3, 0.1)) < 1e-14);
    CHECK(relative_error(-parts.shape_low, std::hypot(0.2, 0.1)) < 1e-14);
    CHECK(relative_error(parts.shape_high, 0.05) < 1e-14);
    CHECK(relative_error(std::log(wide.band.low / k), -std::hypot(0.2, 0.5, std::hypot(0.2, 0.1))) < 1e-13);
    CHECK(relative_error(std::log(wide.band.high / k), std::hypot(0.1, std::sqrt(0.26), 0.05)) < 1e-13);
    const auto greatest = parts::greatest_unknown(parts);
    REQUIRE(greatest);
    CHECK(greatest->which == parts::Unknown::gradient);
    const double without = std::hypot(0.2, std::hypot(0.2, 0.1)) + std::hypot(0.1, 0.1, 0.05),
                 with = std::log(wide.band.high / wide.band.low);
    CHECK(relative_error(greatest->narrower, without / with) < 1e-13);
    CHECK_FALSE(parts::greatest_unknown(parts::BandParts<double>{.errors_low = -1, .errors_high = 1}));
    // no unknown leaves the band as it is, to the last bit
    const auto same = parts::widened<double>(k, {k / 2, k, k * 2, 0}, {{k * 0.9}}, {}, 0, false, 1, {});
    parts::SampledBand<double> direct{k / 2, k, k * 2, 0};
    (void)parts::widen(direct, k, std::span<const double>(std::vector<double>{k * 0.9}));
    CHECK((same.band.low == direct.low && same.band.high == direct.high));
}

TEST_CASE("A band is widened by squares, and its parts are logarithms over K") {
    const double k = 2e14;
    const auto at = [&](double factor) { return k * factor; };
    parts::SampledBand<double> band{at(0.8), at(1.01), at(1.25), 0};
    const std::vector<double> others{at(0.7), at(1.1), -1, 0, std::nan(""), std::numeric_limits<double>::infinity()};
    const auto parts = parts::widen(band, k, std::span<const double>(others));
    CHECK(relative_error(parts.errors_low, std::log(0.8)) < 1e-13);
    CHECK(relative_error(parts.errors_high, std::log(1.25)) < 1e-13);
    CHECK(relative_error(parts.scale_low, std::log(0.7)) < 1e-13);
    CHECK(relative_error(parts.scale_high, std::log(1.1)) < 1e-13);
    CHECK(relative_error(band.low, k * std::exp(-std::sqrt(std::pow(std::log(0.8), 2) + std::pow(std::log(0.7), 2)))) <
          1e-13);
    CHECK(relative_error(band.high, k * std::exp(std::sqrt(std::pow(std::log(1.25), 2) + std::pow(std::log(1.1), 2)))) <
          1e-13);
    CHECK(band.median == at(1.01));
    CHECK(parts.window_low == 0);
}

TEST_CASE("Neighbours on one side widen that side and a band of 0 surfaces stays empty") {
    parts::SampledBand<double> band{0.9, 1, 1.1, 0};
    const std::vector<double> above{1.2, 1.3};
    const auto parts = parts::widen(band, 1.0, std::span<const double>(above));
    CHECK(relative_error(band.low, 0.9) < 1e-15);
    CHECK(parts.scale_low == 0);
    CHECK(relative_error(parts.scale_high, std::log(1.3)) < 1e-15);
    parts::SampledBand<double> none;
    CHECK(parts::widen(none, 1.0, std::span<const double>(above)).scale_high == 0);
    CHECK(none.high == 0);
    parts::SampledBand<double> higher{1.05, 1.1, 1.2, 0};  // K is below the band: its low end stays
    (void)parts::widen(higher, 1.0, std::span<const double>(above));
    CHECK(relative_error(higher.low, 1.05) < 1e-15);
    parts::SampledBand<double> huge{1, 1, 1e308, 0};
    const std::vector<double> far_above{1e300};
    (void)parts::widen(huge, 1.0, std::span<const double>(far_above));
    CHECK(huge.high == std::numeric_limits<double>::max() / 2);
}

TEST_CASE("The window of D moves it by 5 % and 95 % of its error, within its range") {
    const auto [low, high] = parts::dimensions_of_other_windows(1.5, 0.1);
    CHECK(relative_error(low, 1.5 - 0.16448536269514722) < 1e-14);
    CHECK(relative_error(high, 1.5 + 0.16448536269514722) < 1e-14);
    CHECK(parts::dimensions_of_other_windows(1.99, 0.1)[1] == 1.999);
    CHECK(parts::dimensions_of_other_windows(1.01, 0.1)[0] == 1.001);
}

TEST_CASE("The band of a measured surface is that of its errors, widened by K of its neighbours") {
    const Surface<double> surface = measure(trace());
    REQUIRE(surface.neighbours.size() == 2);
    const parts::BandOptions options{.samples = 60, .seed = 4};
    const auto found = stiffness_band(surface, pressures, hertz, 112.6e9, options);
    const parts::SurfaceParameters<double>& parameters = surface;  // without its neighbours
    const auto errors = stiffness_band(parameters, pressures, hertz, 112.6e9, options);
    REQUIRE(found.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const double k = stiffness_of(surface, pressures[i]);
        CHECK(found[i].stiffness == k);
        CHECK(found[i].band.median == errors[i].median);
        double low = 0, high = 0;
        for (const auto& neighbour : surface.neighbours) {
            const double change = std::log(stiffness_of(neighbour, pressures[i]) / k);
            low = std::min(low, change), high = std::max(high, change);
        }
        CHECK(high - low > 0.02);  // so that a band without it is another
        CHECK(relative_error(found[i].band.low, k * std::exp(-std::hypot(std::log(errors[i].low / k), low))) < 1e-12);
        CHECK(relative_error(found[i].band.high, k * std::exp(std::hypot(std::log(errors[i].high / k), high))) < 1e-12);
    }
    Surface<double> alone = surface;
    alone.neighbours.clear();
    const auto narrow = stiffness_band(alone, pressures, hertz, 112.6e9, options);
    CHECK(narrow[0].band.low == errors[0].low);
    CHECK(narrow[0].parts.scale_high == 0);
}

TEST_CASE("A law of D has the part of its window, a lay ends the band higher, and r and theta must be known") {
    Surface<double> surface = measure(trace());
    REQUIRE(surface.fractal_dimension);
    REQUIRE(surface.dimension_window_error > 0);
    const parts::BandOptions options{.samples = 20};
    const auto of_fractal = stiffness_band(surface, pressures, fractal, 112.6e9, options);
    CHECK(of_fractal[0].parts.window_high - of_fractal[0].parts.window_low > 0);
    const auto plain = stiffness_band(surface, pressures, hertz, 112.6e9, options);
    CHECK(plain[0].parts.window_high - plain[0].parts.window_low == 0);
    surface.concerns.push_back(MeasuredConcern::lay);
    const auto with_lay = stiffness_band(surface, pressures, hertz, 112.6e9, options);
    CHECK(relative_error(with_lay[1].band.high, 20 * plain[1].band.high) < 1e-14);
    CHECK(with_lay[1].band.low == plain[1].band.low);
    surface.neighbours[0].r.reset(), surface.neighbours[0].theta.reset();  // it takes those of the surface
    CHECK(std::isfinite(stiffness_band(surface, pressures, hertz, 112.6e9, options)[0].band.low));
    surface.r.reset();
    CHECK_THROWS_AS(stiffness_band(surface, pressures, hertz, 112.6e9, options), domain_error);
}

}  // namespace widened_band_test
