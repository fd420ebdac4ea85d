// SPDX-License-Identifier: BSD-3-Clause
// Truth: closed forms.
#include <fstiff/measured/pooled_surface.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace pooled_surface_test {

using namespace fstiff;

namespace {

MeasuredFace<double> one_of(double rms, double radius, double density, double relative, double size) {
    MeasuredFace<double> one;
    one.face = {{rms, radius, density, 3 * rms}, moments_of_peaks(rms, radius, density), 1.4, 1e-12, 0.3, 0.6};
    one.uncertain.set(Parameter::rms_height, {rms, relative * rms});
    one.uncertain.set(Parameter::peak_radius, {radius, relative * radius});
    one.uncertain.set(Parameter::peak_density, {density, relative * density});
    one.uncertain.set(Parameter::fractal_dimension, {1.4, relative});
    one.uncertain.set(Parameter::r, {0.3, relative});
    one.uncertain.set(Parameter::theta, {0.6, relative});
    one.size = size;
    return one;
}

}  // namespace

TEST_CASE("like measurements leave the values, and have smaller errors") {
    const auto one = one_of(1e-6, 2e-5, 1e9, 0.1, 1e-3);
    const auto four = pooled<double>({one, one, one, one});
    for (std::size_t i = 0; i < surface_parameter_count; ++i)
        CHECK(test::relative_error(four.uncertain.value[i], one.uncertain.value[i]) < 1e-13);
    CHECK(test::relative_error(*four.face.fractal_roughness, 1e-12) < 1e-11);
    CHECK(test::relative_error(four.uncertain.error[3], 0.05) < 1e-12);  // no scatter: 0.1/sqrt(4)
    const double s = std::sqrt(std::log1p(0.01)) / 2;
    CHECK(test::relative_error(four.uncertain.error[0], 1e-6 * std::sqrt(std::expm1(s * s))) < 1e-12);
    CHECK(test::relative_error(pooled<double>({one}).uncertain.error[1], one.uncertain.error[1]) < 1e-15);
}

TEST_CASE("unlike measurements: means of the spectra, and the scatter is the error") {
    const auto a = one_of(1e-6, 2e-5, 1e9, 1e-6, 3e-3), b = one_of(2e-6, 4e-5, 2e9, 1e-6, 1e-3);
    const auto both = pooled<double>({a, b});
    CHECK(test::relative_error(both.uncertain.value[0], std::sqrt(0.75e-12 + 0.25 * 4e-12)) < 1e-14);
    CHECK(test::relative_error(both.uncertain.value[1], 1 / std::sqrt(0.75 / 4e-10 + 0.25 / 16e-10)) < 1e-13);
    CHECK(test::relative_error(both.face.roughness.max_peak_height, 6e-6) < 1e-15);
    // ln 2 apart, weights 3/4 and 1/4: variance 3/16 ln^2 2, times (10/16)/(6/16), times t^2
    const double k = student_quantile(normal_95<double>, 1) / normal_95<double>.value,
                 error = k * std::log(2.0) * std::sqrt(3.0 / 16 * 10 / 6);
    CHECK(test::relative_error(both.uncertain.error[0] / both.uncertain.value[0],
                               std::sqrt(std::expm1(error * error))) < 1e-10);
    auto without = b;
    without.face.fractal_dimension.reset(), without.face.fractal_roughness.reset();
    without.uncertain.known[3] = false;
    CHECK(test::relative_error(*pooled<double>({a, without}).face.fractal_dimension, 1.4) < 1e-14);
    CHECK_THROWS_AS(pooled<double>(std::vector<MeasuredFace<double>>{}), domain_error);
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
