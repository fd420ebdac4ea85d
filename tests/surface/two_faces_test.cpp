// SPDX-License-Identifier: BSD-3-Clause
// Truth: sums of the spectra and autocorrelations of independent surfaces.
#include <fstiff/answer/face.hpp>
#include <fstiff/answer/resolve.hpp>
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/moments.hpp>
#include <fstiff/surface/spectrum.hpp>
#include <fstiff/surface/structure_coefficient.hpp>
#include <fstiff/surface/sum_of_faces.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace two_faces_test {

using namespace fstiff;

namespace {

/// The face of a band spectrum, whose triples are \p rho1 and \p rho2 at one step.
detail::RoughFace<double> face_of(const BandSpectrum<double>& band, double rho1, double rho2) {
    const SpectralMoments<double> moments{band.m0(), band.m2(), band.m4()};
    const auto peaks = PeakDistribution<double>::from_autocorrelation(rho1, rho2);
    detail::RoughFace<double> face{
        {band.rms_height(), detail::peak_radius_of(moments), detail::peak_density_of(moments), 1e-6}, moments};
    face.r = peaks.r();
    face.theta = peaks.theta();
    return face;
}

}  // namespace

TEST_CASE("the peaks of two faces are those of the added spectra") {
    const BandSpectrum<double> a{1e3, 0.8, 1e4, 2e4, 4e6}, b{2e1, 0.5, 3e4, 3e4, 9e6};
    const auto sum = detail::sum_of_faces(face_of(a, 0.9, 0.7), face_of(b, 0.8, 0.45));
    const double n1 = a.integral(1) + b.integral(1), n3 = a.integral(3) + b.integral(3),
                 n5 = a.integral(5) + b.integral(5), pi = std::numbers::pi_v<double>;
    CHECK(test::relative_error(sum.roughness.rms_height, std::sqrt(2 * pi * n1)) < 1e-14);
    CHECK(test::relative_error(sum.roughness.peak_radius, 3 * std::sqrt(pi) / 8 / std::sqrt(0.75 * pi * n5)) < 1e-13);
    CHECK(test::relative_error(sum.roughness.peak_density, 0.75 * n5 / n3 / (6 * pi * std::sqrt(3.0))) < 1e-13);
    CHECK(test::relative_error(sum.moments.m2, pi * n3) < 1e-14);
    CHECK(test::relative_error(sum.roughness.max_peak_height, 2e-6) < 1e-15);
}

TEST_CASE("r and theta of two faces sampled at one step are those of the added autocorrelations") {
    // sigma, sigma_m and sigma_kappa of either face at one step; m4 is the one of the triples
    const double step = 2e-7;
    const auto face = [&](double sigma, double rho1, double rho2) {
        const auto peaks = PeakDistribution<double>::from_autocorrelation(rho1, rho2);
        const double curvature = sigma * std::sqrt(6 - 8 * rho1 + 2 * rho2) / (step * step);
        const SpectralMoments<double> moments{sigma * sigma, sigma * sigma * 2 * (1 - rho1) / (step * step),
                                              curvature * curvature};
        detail::RoughFace<double> one{{sigma, detail::peak_radius_of(moments), detail::peak_density_of(moments)},
                                      moments};
        one.r = peaks.r(), one.theta = peaks.theta();
        return one;
    };
    const double s1 = 3e-7, s2 = 8e-7;
    const auto sum = detail::sum_of_faces(face(s1, 0.85, 0.6), face(s2, 0.97, 0.9));
    const auto mixed = [&](double one, double other) {
        return (s1 * s1 * one + s2 * s2 * other) / (s1 * s1 + s2 * s2);
    };
    const auto truth = PeakDistribution<double>::from_autocorrelation(mixed(0.85, 0.97), mixed(0.6, 0.9));
    CHECK(test::relative_error(*sum.r, truth.r()) < 1e-13);
    CHECK(test::relative_error(*sum.theta, truth.theta()) < 1e-13);
}

TEST_CASE("D and G of two faces touch the added structure functions at the distance of the peaks") {
    detail::RoughFace<double> a{{1e-6, 2e-5, 1e9}, detail::moments_of_peaks(1e-6, 2e-5, 1e9), 1.3, 1e-13},
        b{{5e-7, 6e-5, 4e8}, detail::moments_of_peaks(5e-7, 6e-5, 4e8), 1.6, 3e-10};
    const auto sum = detail::sum_of_faces(a, b);
    const double lag = 1 / std::sqrt(sum.roughness.peak_density), step = 1e-4;
    const auto log_s = [&](double at) {
        return std::log(detail::structure_function_at(at, Fractal<double>{1.3, 1e-13}) +
                        detail::structure_function_at(at, Fractal<double>{1.6, 3e-10}));
    };
    const double slope = (log_s(lag * std::exp(step)) - log_s(lag * std::exp(-step))) / (2 * step);
    CHECK(test::relative_error(4 - 2 * *sum.fractal_dimension, slope) < 1e-8);  // of differences over 2e-4
    const Fractal<double> of_sum{*sum.fractal_dimension, *sum.fractal_roughness};
    CHECK(std::abs(std::log(detail::structure_function_at(lag, of_sum)) - log_s(lag)) < 1e-12);
    b.fractal_roughness.reset();
    const auto without = detail::sum_of_faces(a, b);
    CHECK(!without.fractal_roughness);
    const double share = a.moments.m2 / (a.moments.m2 + b.moments.m2);
    CHECK(test::relative_error(*without.fractal_dimension, share * 1.3 + (1 - share) * 1.6) < 1e-14);
    b.fractal_dimension.reset();
    CHECK(!detail::sum_of_faces(a, b).fractal_dimension);
}

TEST_CASE("two equal faces and one with a face that is nearly smooth") {
    detail::RoughFace<double> a{
        {1e-6, 2e-5, 1e9, 3e-6}, detail::moments_of_peaks(1e-6, 2e-5, 1e9), 1.3, 1e-13, 0.4, 0.7};
    const auto twice = detail::sum_of_faces(a, a);
    CHECK(test::relative_error(twice.roughness.rms_height, std::sqrt(2.0) * 1e-6) < 1e-15);
    CHECK(test::relative_error(twice.roughness.peak_radius, 2e-5 / std::sqrt(2.0)) < 1e-14);
    CHECK(test::relative_error(twice.roughness.peak_density, 1e9) < 1e-14);
    CHECK(test::relative_error(*twice.r, 0.4) < 1e-14);
    CHECK(test::relative_error(*twice.theta, 0.7) < 1e-14);
    CHECK(test::relative_error(*twice.fractal_dimension, 1.3) < 1e-14);
    CHECK(test::relative_error(*twice.fractal_roughness, 1e-13 * std::pow(2.0, 1 / 0.6)) < 1e-11);  // (2.4), G^(2D-2)
    detail::RoughFace<double> smooth = a;
    smooth.roughness = {1e-15, 2e4, 1e9, 3e-15};
    smooth.moments = detail::moments_of_peaks(1e-15, 2e4, 1e9);
    smooth.fractal_dimension = 1.9, smooth.fractal_roughness = 1e-24;
    const auto one = detail::sum_of_faces(a, smooth);
    CHECK(test::relative_error(one.roughness.rms_height, 1e-6) < 1e-15);
    CHECK(test::relative_error(one.roughness.peak_radius, 2e-5) < 1e-14);
    CHECK(test::relative_error(*one.r, 0.4) < 1e-8);
    CHECK(test::relative_error(*one.theta, 0.7) < 1e-8);
    CHECK(test::relative_error(*one.fractal_dimension, 1.3) < 1e-8);
    detail::RoughFace<double> near_one = a;
    near_one.fractal_dimension = 1.002, near_one.fractal_roughness = 1e-300;  // G of half the heights is 1e-450
    CHECK(!detail::scaled(near_one, 0.5).fractal_roughness);
    CHECK(detail::sum_of_faces(detail::scaled(near_one, 0.5), a).fractal_dimension);
    CHECK_THROWS_AS(detail::sum_of_faces(a.roughness, Roughness<double>{1e-6, -1, 1e9}), domain_error);
}

}  // namespace two_faces_test
