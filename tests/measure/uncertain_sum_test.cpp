// SPDX-License-Identifier: BSD-3-Clause
// Truth: derivatives of sum_of_faces by differences; sums over all pairs of heights.
#include <fstiff/answer/face.hpp>
#include <fstiff/measure/uncertain_sum.hpp>
#include <fstiff/surface/sum_of_faces.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace uncertain_sum_test {

using namespace fstiff;

namespace {

SurfaceParameters<double> face(double rms, double radius, double density, double dimension, double relative) {
    SurfaceParameters<double> of;
    of.rms_height = {rms, relative * rms};
    of.peak_radius = {radius, 2 * relative * radius};
    of.peak_density = {density, relative * density};
    of.fractal_dimension = {dimension, relative / 5};
    of.r = {0.3, relative / 4};
    of.theta = {0.6, relative / 4};
    of.correlation[0][1] = of.correlation[1][0] = -0.6;
    return of;
}

SpectralMoments<double> moments_of(const SurfaceParameters<double>& face) {
    return detail::moments_of_peaks(face.rms_height.value, face.peak_radius.value, face.peak_density.value);
}

SurfaceParameters<double> sum_of(const SurfaceParameters<double>& a, const SurfaceParameters<double>& b) {
    return detail::uncertain_sum(a, moments_of(a), b, moments_of(b));
}

}  // namespace

TEST_CASE("errors of a sum of two faces are those of its derivatives") {
    const auto a = face(1e-6, 2e-5, 1e9, 1.3, 0.02), b = face(6e-7, 5e-5, 3e9, 1.5, 0.03);
    const auto sum = sum_of(a, b);
    // sigma: d sigma = (sigma_a d sigma_a + sigma_b d sigma_b)/sigma
    const double sigma = std::hypot(1e-6, 6e-7);
    CHECK(test::relative_error(sum.rms_height.value, sigma) < 1e-15);
    CHECK(test::relative_error(sum.rms_height.error, std::hypot(1e-6 * 2e-8, 6e-7 * 1.8e-8) / sigma) < 0.03);
    // R^-2 adds: dR/R = R^2 (dR_a/R_a^3 + dR_b/R_b^3)
    const double R = 1 / std::sqrt(1 / 4e-10 + 1 / 25e-10);
    CHECK(test::relative_error(sum.peak_radius.value, R) < 1e-14);
    CHECK(test::relative_error(sum.peak_radius.error / R, R * R * std::hypot(0.04 / 4e-10, 0.06 / 25e-10)) < 0.03);
    // correlation of sigma and R: both by the same face
    const double shared =
        -0.6 * (1e-6 * 2e-8 / sigma * R * R * R * 0.04 / 4e-10 + 6e-7 * 1.8e-8 / sigma * R * R * R * 0.06 / 25e-10);
    CHECK(std::abs(sum.correlation[0][1] - shared / (sum.rms_height.error * sum.peak_radius.error)) < 0.04);
    const double share =
        detail::share_of_face(detail::rough_face(a, moments_of(a)), detail::rough_face(b, moments_of(b)));
    CHECK(test::relative_error(sum.fractal_dimension->error, std::hypot(share * 0.004, (1 - share) * 0.006)) < 0.03);
    CHECK(sum.r);
    CHECK(sum.theta);
}

TEST_CASE("with a face that is nearly smooth the errors stay") {
    const auto a = face(1e-6, 2e-5, 1e9, 1.3, 0.05);
    auto b = face(1e-15, 2e4, 1e9, 1.3, 0.05);
    const auto sum = sum_of(a, b);
    for (std::size_t i = 0; i < detail::surface_parameter_count; ++i) {
        const auto which = static_cast<Parameter>(i);
        CHECK(test::relative_error(sum.find(which)->value, a.find(which)->value) < 1e-7);
        CHECK(test::relative_error(sum.find(which)->error, a.find(which)->error) < 0.05);
    }
    b.r.reset(), b.theta.reset();
    CHECK(!sum_of(a, b).r);
}

TEST_CASE("skewness and kurtosis of a sum are those of all pairs of heights") {
    const std::vector<double> one{-1, -0.5, 0.2, 3, 0.1, -2.2}, other{0.4, -0.3, -0.9, 0.8, 1.3};
    const auto statistics = [](const std::vector<double>& z) {
        double mean = 0, m2 = 0, m3 = 0, m4 = 0;
        const auto n = static_cast<double>(z.size());
        for (const double x : z) mean += x / n;
        for (const double x : z)
            m2 += std::pow(x - mean, 2) / n, m3 += std::pow(x - mean, 3) / n, m4 += std::pow(x - mean, 4) / n;
        HeightStatistics<double> of;
        of.skewness.value = m3 / std::pow(m2, 1.5);
        of.kurtosis.value = m4 / (m2 * m2);
        of.rms_gradient.value = 0.1;
        of.moments = {m2, 0.005, 1e9};
        return of;
    };
    std::vector<double> pairs;
    for (const double x : one)
        for (const double y : other) pairs.push_back(x + y);
    const auto sum = detail::sum_of_faces(statistics(one), statistics(other)), truth = statistics(pairs);
    CHECK(test::relative_error(sum.skewness.value, truth.skewness.value) < 1e-13);
    CHECK(test::relative_error(sum.kurtosis.value, truth.kurtosis.value) < 1e-13);
    CHECK(test::relative_error(sum.moments.m0, truth.moments.m0) < 1e-14);
    CHECK(test::relative_error(sum.rms_gradient.value, 0.1 * std::sqrt(2.0)) < 1e-14);
}

}  // namespace uncertain_sum_test
