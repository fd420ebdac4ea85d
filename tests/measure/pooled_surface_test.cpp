// SPDX-License-Identifier: BSD-3-Clause
// Truth: closed forms.
#include <fstiff/math/random.hpp>
#include <fstiff/measure/pooled_surface.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace pooled_surface_test {

using namespace fstiff;

namespace {

Surface<double> one_of(double rms, double radius, double density, double relative, double size) {
    Surface<double> one;
    one.rms_height = {rms, relative * rms};
    one.peak_radius = {radius, relative * radius};
    one.peak_density = {density, relative * density};
    one.max_peak_height = {3 * rms, 0};
    one.fractal_dimension = {1.4, relative};
    one.fractal_roughness = {1e-12, relative * 1e-12};
    one.r = {0.3, relative};
    one.theta = {0.6, relative};
    one.dimension_window_error = 0.02;
    one.peaks_counted = 100;
    one.size = size;
    return one;
}

}  // namespace

TEST_CASE("like measurements leave the values, and have smaller errors") {
    const auto one = one_of(1e-6, 2e-5, 1e9, 0.1, 1e-3);
    const auto four = pooled(std::vector{one, one, one, one});
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i)
        CHECK(test::relative_error(four.values()[i], one.values()[i]) < 1e-13);
    CHECK(test::relative_error(four.fractal_roughness->value, 1e-12) < 1e-11);
    CHECK(test::relative_error(four.fractal_roughness->error, 0.05e-12) < 1e-11);
    CHECK(test::relative_error(four.dimension_window_error, 0.01) < 1e-14);
    CHECK(test::relative_error(four.fractal_dimension->error, 0.05) < 1e-12);  // no scatter: 0.1/sqrt(4)
    CHECK(four.parts.size() == 4);
    CHECK(four.size == 4e-3);
    CHECK(four.peaks_counted == 400);
    CHECK(four.concerns.empty());
    const double s = std::sqrt(std::log1p(0.01)) / 2;
    CHECK(test::relative_error(four.rms_height.error, 1e-6 * std::sqrt(std::expm1(s * s))) < 1e-12);
    CHECK(test::relative_error(pooled(std::vector{one}).peak_radius.error, one.peak_radius.error) < 1e-15);
}

TEST_CASE("unlike measurements: means of the spectra, and the scatter is the error") {
    const auto a = one_of(1e-6, 2e-5, 1e9, 1e-6, 3e-3), b = one_of(2e-6, 4e-5, 2e9, 1e-6, 1e-3);
    const auto both = pooled(std::vector{a, b});
    CHECK(test::relative_error(both.rms_height.value, std::sqrt(0.75e-12 + 0.25 * 4e-12)) < 1e-14);
    CHECK(test::relative_error(both.peak_radius.value, 1 / std::sqrt(0.75 / 4e-10 + 0.25 / 16e-10)) < 1e-13);
    CHECK(test::relative_error(both.max_peak_height.value, 6e-6) < 1e-15);
    // ln 2 apart, weights 3/4 and 1/4: variance 3/16 ln^2 2, times (10/16)/(6/16), times t^2
    const double k = math::student_quantile(math::normal_95<double>, 1) / math::normal_95<double>.value,
                 error = k * std::log(2.0) * std::sqrt(3.0 / 16 * 10 / 6);
    CHECK(test::relative_error(both.rms_height.error / both.rms_height.value, std::sqrt(std::expm1(error * error))) <
          1e-10);
    auto without = b;
    without.fractal_dimension.reset(), without.fractal_roughness.reset();
    CHECK(test::relative_error(pooled(std::vector{a, without}).fractal_dimension->value, 1.4) < 1e-14);
    const HeightStatistics<double> heights{.rms_gradient = {0.1, 0.01}, .moments = {4e-12, 0.005, 1e8}};
    without.peak_radius = without.peak_density = {}, without.why_no_density = "one island", without.heights = heights;
    const auto known_of_one = pooled(std::vector{a, without});
    CHECK(test::relative_error(known_of_one.peak_radius.value, a.peak_radius.value) < 1e-13);
    CHECK(test::relative_error(known_of_one.peak_density.value, a.peak_density.value) < 1e-13);
    auto neither = a;
    neither.peak_radius = neither.peak_density = {}, neither.why_no_density = "one island", neither.heights = heights;
    CHECK(pooled(std::vector{neither, without}).why_no_density == "one island");
    CHECK(pooled(std::vector{neither, without}).find(Parameter::peak_radius) == nullptr);
    CHECK_THROWS_AS(pooled(std::vector<Surface<double>>{}), domain_error);
}

TEST_CASE("a concern of every measurement is one of the whole and values missing in one may be known for all") {
    using enum MeasuredConcern;
    auto a = one_of(1e-6, 2e-5, 1e9, 0.4, 1e-3);
    a.r->error = a.theta->error = 0.01;
    a.peaks_counted = 20;
    auto b = a;
    a.concerns = {anisotropic, curved, few_peaks, radius_uncertain, density_uncertain, parameter_unknown};
    b.concerns = {curved, few_peaks, radius_uncertain, density_uncertain, implausible_gradient};
    CHECK(pooled(std::vector{a, b}).concerns == std::vector{curved, implausible_gradient});  // errors of 28 %, 40 peaks
    a.peak_radius.error = b.peak_radius.error = 2.5e-5;
    CHECK(pooled(std::vector{a, b}).concerns ==
          std::vector{curved, implausible_gradient, radius_uncertain, parameter_unknown});
}

TEST_CASE("several profiles are measured with the longest cut-offs that the tables choose for them") {
    const auto trace = [](std::uint64_t seed, std::size_t points, double spacing) {
        return self_affine_profile<double>({.hurst = 0.4, .rms = 0.3e-6, .longest_wavelength = 200e-6, .seed = seed},
                                           points, spacing);
    };
    const MeasureOptions<double> how{.resamples = 20, .neighbours = false};
    const std::vector<Profile<double>> both{trace(1, 4096, 0.5e-6), trace(2, 2048, 1.2e-6)};
    CHECK(measure(both[0], how).cut_offs.lambda_s == 2.5e-6);
    const Surface<double> whole = measure(both, how);
    CHECK(whole.cut_offs.lambda_s == 8e-6);
    CHECK(whole.parts[0].cut_offs.lambda_s == 8e-6);
    CHECK(whole.parts[0].rms_height.value == measure(both[0], {.lambda_s = 8e-6, .resamples = 20}).rms_height.value);
    const double w = 2048e-6 / (2048e-6 + 2457.6e-6), a = whole.parts[0].rms_height.value,
                 b = whole.parts[1].rms_height.value;
    CHECK(test::relative_error(whole.rms_height.value, std::sqrt(w * a * a + (1 - w) * b * b)) < 1e-13);
    MeasureOptions<double> other = how;
    other.lambda_s = no_cut_off;
    CHECK(test::refusal([&] { (void)measure(both, other); }) ==
          "measurements of unlike step: must be alike to be pooled");
}

TEST_CASE("skewness, kurtosis and gradient of the parts are those of the whole") {
    const std::vector<double> one{-1, -0.5, 0.2, 3, 0.1, -1.8}, other{0.4, -0.3, -0.9, 0.8};
    const auto statistics = [](const std::vector<double>& z) {
        double m2 = 0, m3 = 0, m4 = 0;
        const auto n = static_cast<double>(z.size());
        for (const double x : z) m2 += x * x / n, m3 += x * x * x / n, m4 += x * x * x * x / n;
        HeightStatistics<double> of;
        of.skewness.value = m3 / std::pow(m2, 1.5);
        of.kurtosis.value = m4 / (m2 * m2);
        of.rms_gradient.value = std::sqrt(m2);
        of.moments = {m2, m2 / 2, 1};
        return of;
    };
    std::vector<double> all = one;
    all.insert(all.end(), other.begin(), other.end());
    const auto mean = pooled<double>({statistics(one), statistics(other)}, {6, 4}), truth = statistics(all);
    CHECK(test::relative_error(mean.skewness.value, truth.skewness.value) < 1e-13);
    CHECK(test::relative_error(mean.kurtosis.value, truth.kurtosis.value) < 1e-13);
    CHECK(test::relative_error(mean.rms_gradient.value, truth.rms_gradient.value) < 1e-13);
    CHECK(mean.skewness.error > 0);
}

}  // namespace pooled_surface_test
