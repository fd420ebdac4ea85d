// SPDX-License-Identifier: BSD-3-Clause
// What the contact sees of one face, of several maps of one face and of two faces. Truth: the definitions, written out;
// sums over the maps themselves.

#include <fstiff/answer/face.hpp>
#include <fstiff/answer/measured_map.hpp>
#include <fstiff/contact/contact_curve.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/surface/sum_of_faces.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace face_test {

using namespace fstiff;
using detail::Face;

namespace {

Face of_numbers() {
    Face face;
    face.parameters.rms_height.value = 0.8e-6;
    face.parameters.peak_radius.value = 40e-6;
    face.parameters.peak_density.value = 500e6;
    return face;
}

/// White noise of rms height \p sigma: every mode has a part.
HeightMap<double> noise(Eigen::Index rows, Eigen::Index columns, double sigma, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal(0, sigma);
    HeightMap<double>::Array heights(rows, columns);
    for (Eigen::Index i = 0; i < heights.size(); ++i) heights.data()[i] = normal(random);
    heights -= heights.mean();
    return {std::move(heights), 1e-6, 1e-6};
}
double mean_square(const HeightMap<double>& map) { return map.heights.square().mean(); }

Face of_maps(std::vector<HeightMap<double>> maps) {
    std::vector<std::shared_ptr<const HeightMap<double>>> shared;
    for (HeightMap<double>& map : maps) shared.push_back(std::make_shared<const HeightMap<double>>(std::move(map)));
    Face face = of_numbers();
    face.map = detail::map_of_surface(std::move(shared));
    return face;
}

/// Statistics of the states of every shift: mean of K, and of their scatter with n - 1 in addition to their own errors.
Estimate<double> mean_over(const std::vector<Estimate<double>>& of_shifts) {
    double mean = 0, error = 0, squares = 0;
    for (const auto& one : of_shifts) mean += one.value, error += one.error;
    mean /= static_cast<double>(of_shifts.size());
    error /= static_cast<double>(of_shifts.size());
    for (const auto& one : of_shifts) squares += std::pow(one.value - mean, 2);
    return {mean, std::sqrt(error * error + squares / static_cast<double>(of_shifts.size() - 1)), 0};
}

}  // namespace

TEST_CASE("Moments of a face are those of its gradient and alpha where they are written") {
    const double ulps = 8 * std::numeric_limits<double>::epsilon();
    Face face = of_numbers();
    const SpectralMoments<double> of_peaks = spectral_moments(face);
    face.alpha = 12.5;  // m2 follows
    CHECK(test::relative_error(spectral_moments(face).bandwidth(), 12.5) < ulps);
    CHECK(spectral_moments(face).m0 == of_peaks.m0);
    CHECK(spectral_moments(face).m4 == of_peaks.m4);
    face.rms_gradient = 0.125;  // m4 follows
    CHECK(test::relative_error(2 * spectral_moments(face).m2, 0.125 * 0.125) < ulps);
    CHECK(test::relative_error(spectral_moments(face).bandwidth(), 12.5) < ulps);
    CHECK(test::relative_error(spectral_moments(face).m0, 0.64e-12) < ulps);
    face.alpha.reset();  // m4 is that of R again
    CHECK(test::relative_error(2 * spectral_moments(face).m2, 0.125 * 0.125) < ulps);
    CHECK(spectral_moments(face).m4 == of_peaks.m4);
}

TEST_CASE("The Hurst exponent is the written one, 2 - D, or 0.8, and wide enough for what was measured") {
    Face face = of_numbers();
    CHECK(hurst_exponent(face) == 0.8);
    face.write(Parameter::fractal_dimension, 1.375);
    CHECK(hurst_exponent(face) == 0.625);
    face.hurst = 0.3;
    CHECK(hurst_exponent(face) == 0.3);
    face.hurst.reset();
    face.rms_gradient = 0.1;
    face.alpha = 60;
    face.widest_band = 20;  // alpha = 60 within a band of 20 takes a greater H
    const double least = detail::least_hurst(spectral_moments(face), 20.0);
    REQUIRE(least > 0.63);
    CHECK(hurst_exponent(face) == least);
}

TEST_CASE("Peaks of a face are isotropic where its gradient or alpha is known and alpha above 1.5") {
    Face face = of_numbers();
    CHECK_FALSE(has_isotropic_peaks(face));
    face.alpha = 1.51;
    CHECK(has_isotropic_peaks(face));
    face.alpha = 1.49;
    CHECK_FALSE(has_isotropic_peaks(face));
}

TEST_CASE("Several maps of one face share its spectrum by their areas") {
    const HeightMap<double> wide = noise(32, 64, 1e-8, 1), tall = noise(16, 16, 3e-8, 2);
    const Face face = of_maps({wide, tall});
    const double area = wide.area() + tall.area();
    for (const Edges edges : {Edges::mirrored, Edges::periodic}) {
        const auto& spectrum = face.map->spectrum(edges);
        const double wanted = (wide.area() * mean_square(wide) + tall.area() * mean_square(tall)) / area;
        CHECK(test::relative_error(spectrum.rms_height * spectrum.rms_height, wanted) < 1e-12);
        const double of_wide = map_spectrum(wide, edges).rms_gradient();
        const double of_tall = map_spectrum(tall, edges).rms_gradient();
        CHECK(test::relative_error(std::pow(spectrum.rms_gradient(), 2),
                                   (wide.area() * of_wide * of_wide + tall.area() * of_tall * of_tall) / area) < 1e-12);
        for (std::size_t i = 1; i < spectrum.shells.size(); ++i) {
            const auto &last = spectrum.shells[i - 1], &shell = spectrum.shells[i];
            CHECK(last.q2_h2 / last.q_h2 <= shell.q2_h2 / shell.q_h2 * (1 + 1e-12));
        }
    }
}

TEST_CASE("The spectrum of two faces is the sum of theirs, and their heights are added at every shift") {
    const Face upper = of_maps({noise(16, 16, 1e-8, 3)}), lower = of_maps({noise(16, 16, 2e-8, 4)});
    const Face sum = detail::sum_of_faces(upper, lower, 3, 7);
    REQUIRE(sum.map);
    for (const Edges edges : {Edges::mirrored, Edges::periodic}) {
        const auto &a = upper.map->spectrum(edges), &b = lower.map->spectrum(edges), &both = sum.map->spectrum(edges);
        CHECK(test::relative_error(both.rms_height, std::hypot(a.rms_height, b.rms_height)) < 1e-14);
        CHECK(test::relative_error(both.rms_gradient(), std::hypot(a.rms_gradient(), b.rms_gradient())) < 1e-14);
        CHECK(both.shells.size() == a.shells.size() + b.shells.size());
    }
    REQUIRE(sum.map->maps.size() == 3);
    REQUIRE(sum.map->summits.size() == 3);
    for (const auto& map : sum.map->maps) {
        CHECK(map->size() == 256);
        CHECK(mean_square(*map) > 0.5 * (1e-16 + 4e-16));
    }
    CHECK(((sum.map->maps[0]->heights - sum.map->maps[1]->heights).abs() > 0).any());
}

TEST_CASE("H of two faces is the mean over their slopes") {
    Face upper = of_numbers(), lower = of_numbers();
    upper.rms_gradient = 0.1, upper.alpha = 5, upper.hurst = 0.5;
    lower.rms_gradient = 0.2, lower.alpha = 5, lower.hurst = 0.9;
    const Face sum = detail::sum_of_faces(upper, lower, 1, 1);
    CHECK(test::relative_error(*sum.hurst, (0.01 * 0.5 + 0.04 * 0.9) / 0.05) < 1e-14);
    CHECK(test::relative_error(*sum.rms_gradient, std::sqrt(0.05)) < 1e-14);
    lower.hurst.reset();  // 0.8, as that face alone
    CHECK(test::relative_error(*detail::sum_of_faces(upper, lower, 1, 1).hurst, (0.01 * 0.5 + 0.04 * 0.8) / 0.05) <
          1e-14);
}

TEST_CASE("K over the shifts of two maps is their mean, with the scatter of one shift as its error") {
    const Face sum = detail::sum_of_faces(of_maps({noise(24, 24, 1e-8, 5)}), of_maps({noise(24, 24, 1e-8, 6)}), 4, 11);
    const detail::Law& law = *detail::find_law("summits");
    detail::ContactInputs inputs{.surface = sum.roughness(), .effective_modulus = 1e11};
    inputs.options.mutual = false;
    inputs.map = sum.map.get();
    const std::vector<double> pressures{2e6, 2e7};
    const auto all = law.contact(inputs)->at_pressures(pressures, Quantity::stiffness | Quantity::separation);
    std::vector<std::vector<ContactPoint<double>>> single;
    for (std::size_t k = 0; k < 4; ++k) {
        single.push_back(curve_at_pressures(SummitContact<double>(sum.map->summits[k], 1e11), std::span(pressures),
                                            Quantity::stiffness | Quantity::separation));
    }
    for (std::size_t i = 0; i < pressures.size(); ++i) {
        REQUIRE(all[i].ok());
        for (const auto member : {&ContactState<double>::stiffness, &ContactState<double>::separation}) {
            std::vector<Estimate<double>> of_shifts;
            for (const auto& states : single) of_shifts.push_back(states[i].state.*member);
            const Estimate<double> wanted = mean_over(of_shifts);
            CHECK(test::relative_error((all[i].state.*member).value, wanted.value) < 1e-13);
            CHECK(test::relative_error((all[i].state.*member).error, wanted.error) < 1e-10);
            CHECK(wanted.error > 1e-3 * std::abs(wanted.value));  // the shifts do differ
        }
    }
}

}  // namespace face_test
