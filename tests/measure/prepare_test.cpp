// SPDX-License-Identifier: BSD-3-Clause
// prepare() and clean() against their steps taken one after the other by hand, and against other orders of them.
#include <fstiff/measure/prepare.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/profile/profile_repair.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/topography/map_repair.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <numbers>

namespace prepare_test {

using namespace fstiff;

namespace {

/// A trace of 4 mm with a tilt and a bow.
Profile<double> trace() {
    auto profile = self_affine_profile<double>({.hurst = 0.6, .rms = 0.3e-6, .longest_wavelength = 300e-6, .seed = 5},
                                               8192, 0.5e-6);
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const double x = static_cast<double>(i) / 8192;
        profile.heights[i] += 5e-6 * x + 3e-6 * x * x;
    }
    return profile;
}

HeightMap<double> tilted_map() {
    auto map = self_affine_map<double>({.hurst = 0.7, .rms = 0.2e-6, .longest_wavelength = 20e-6, .seed = 3}, 80, 64,
                                       0.5e-6, 0.5e-6);
    for (Eigen::Index j = 0; j < map.rows(); ++j) map.heights.row(j) += 0.05e-6 * static_cast<double>(j);
    return map;
}

bool same(const Profile<double>& a, const Profile<double>& b) { return a.heights == b.heights; }
bool same(const HeightMap<double>& a, const HeightMap<double>& b) { return (a.heights == b.heights).all(); }

std::size_t missing(const Profile<double>& profile) { return profile.size() - profile.present(); }

}  // namespace

TEST_CASE("A profile loses its form, then lambda_s, and for Ra the lambda_c of what is left") {
    const auto profile = trace();
    const auto of_contact = prepare(profile);
    const auto prepared = with_drawing_cut_off(of_contact);
    const auto flat = detail::detrend(profile, Form::line);
    const auto smooth = detail::gaussian_low_pass(flat, 2.5e-6);  // five steps of 0.5 um
    const auto ra = [](const Profile<double>& of, double cut_off) {
        const auto rough = detail::gaussian_roughness(of, cut_off);
        double sum = 0;
        for (const double z : rough.heights) sum += std::abs(z);
        return sum / static_cast<double>(rough.size());
    };
    // the table by hand: Ra to 0.02 um with 0.08 mm, to 0.1 um with 0.25 mm, to 2 um with 0.8 mm
    CHECK(ra(smooth, 0.08e-3) > 0.02e-6);
    CHECK(ra(smooth, 0.25e-3) > 0.1e-6);
    CHECK(ra(smooth, 0.8e-3) < 2e-6);
    CHECK_FALSE(of_contact.cut_offs.lambda_c);
    CHECK(of_contact.cut_offs.why_c == CutOffReason::form_alone);
    CHECK(same(of_contact.profile, smooth));
    CHECK(of_contact.rms == rms_height(smooth));
    CHECK(prepared.cut_offs.lambda_s == 2.5e-6);
    CHECK(prepared.cut_offs.lambda_c == 0.8e-3);
    CHECK(prepared.cut_offs.why_c == CutOffReason::roughness);
    CHECK(std::abs(prepared.cut_offs.mean_deviation / ra(smooth, 0.8e-3) - 1) < 1e-12);
    CHECK(same(prepared.profile, detail::gaussian_roughness(smooth, 0.8e-3)));
    CHECK(same(prepared.of_structure(), flat));
    CHECK(prepared.rms_as_read == rms_height(profile));
    CHECK(prepared.rms_levelled == rms_height(smooth));
    CHECK(prepared.rms == rms_height(prepared.profile));
    double squares = 0;
    for (std::size_t i = 1; i < profile.size(); ++i)
        squares += std::pow((prepared.profile.heights[i] - prepared.profile.heights[i - 1]) / 0.5e-6, 2);
    CHECK(std::abs(prepared.rms_gradient / std::sqrt(2 * squares / 8191) - 1) < 1e-12);
    // the test depends on the order: filters before the form leave other heights
    CHECK_FALSE(same(
        prepared.profile,
        detail::detrend(detail::gaussian_roughness(detail::gaussian_low_pass(profile, 2.5e-6), 0.8e-3), Form::line)));
    CHECK_FALSE(same(prepared.profile, detail::gaussian_low_pass(detail::gaussian_roughness(flat, 0.8e-3), 2.5e-6)));
}

TEST_CASE("The Ra that chooses lambda_c is that without the waves below lambda_s") {
    auto profile = trace();  // with waves of 1 to 2.5 um, which the filter of lambda_s removes for the most part
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const double n = static_cast<double>(i), share = n / static_cast<double>(2 * profile.size());
        const auto wave = [](double turns) { return std::sin(2 * std::numbers::pi_v<double> * turns); };
        profile.heights[i] = 60e-9 * wave(n * (0.2 + 0.3 * share)) + 20e-9 * wave(n / 60 * (1 + 2 * share)) + 1e-9 * n;
    }
    const auto chosen = [&](const MeasureOptions<double>& how) {
        return with_drawing_cut_off(prepare(profile, how)).cut_offs.lambda_c;
    };
    CHECK(chosen({}) == 0.08e-3);
    CHECK(chosen({.lambda_s = no_cut_off}) == 0.25e-3);
    CHECK(chosen({.lambda_c = 0.4e-3}) == 0.4e-3);
    CHECK_FALSE(chosen({.lambda_c = no_cut_off}));
    const auto shared = with_drawing_cut_off(prepare(profile), CutOff<double>(0.25e-3));
    CHECK(same(shared.profile, prepare(profile, {.lambda_c = 0.25e-3}).profile));
}

TEST_CASE("The form with its own cut-off, the robust filter, and none") {
    const auto profile = trace();
    const auto form = prepare(profile, {.lambda_s = 2.5e-6, .form_cut_off = 0.4e-3});
    const auto flat = detail::detrend(profile, Form::line);
    CHECK(same(form.profile, detail::gaussian_roughness(detail::gaussian_low_pass(flat, 2.5e-6), 0.4e-3)));
    CHECK(form.cut_offs.lambda_c == 0.4e-3);
    CHECK(form.cutoff == 0.4e-3);
    CHECK_FALSE(form.lambda_c);
    CHECK_THROWS_AS(prepare(profile, {.lambda_c = 0.8e-3, .form_cut_off = 0.4e-3}), domain_error);
    const auto robust = prepare(profile, {.lambda_s = no_cut_off, .lambda_c = 0.4e-3, .filter = CutOffFilter::robust});
    const auto wave = detail::robust_waviness(flat, 0.4e-3);
    REQUIRE(robust.cut_offs.robust);
    CHECK(robust.cut_offs.robust->left_out == wave.left_out);
    CHECK(robust.cut_offs.robust->points == 8192);
    CHECK(robust.cut_offs.robust->iterations == wave.iterations);
    CHECK(robust.profile.heights[100] == flat.heights[100] - wave.waviness.heights[100]);
    CHECK(same(robust.of_structure(), flat));
    const auto bow = prepare(profile, {.lambda_s = no_cut_off, .lambda_c = no_cut_off, .form = Form::parabola});
    CHECK(same(bow.profile, detail::detrend(profile, Form::parabola)));
}

TEST_CASE("A map loses its form, then lambda_s, then a given lambda_c, and every way to it gives the same map") {
    const auto map = tilted_map();
    const MeasureOptions<double> options{.lambda_c = 15e-6};
    const auto prepared = prepare(map, options);
    const auto flat = detail::remove_form(map, MapForm::plane);
    const auto smooth = detail::gaussian_low_pass(flat, 2.5e-6);
    CHECK(prepared.cut_offs.lambda_s == 2.5e-6);
    CHECK(same(prepared.map, detail::gaussian_high_pass(smooth, 15e-6)));
    CHECK(same(prepared.of_structure(), flat));
    CHECK(prepared.lambda_c == 15e-6);
    CHECK(prepared.rms_as_read == rms_height(map));
    CHECK(prepared.rms_levelled == rms_height(flat));
    CHECK(prepared.rms == prepared.areal.rms_height);
    CHECK(same(prepare(map).map, smooth));
    auto given = map;
    CHECK(same(prepare(std::move(given), options).map, prepared.map));
    CHECK(given.size() == 0);
    const auto shared = detail::without_form(map, options);
    CHECK(same(detail::with_cut_offs(shared, options).map, prepared.map));
    const auto none = detail::with_cut_offs(shared, {.lambda_s = no_cut_off});
    CHECK(same(none.map, flat));
    CHECK_FALSE(none.unfiltered);
    const auto robust = prepare(map, {.lambda_s = no_cut_off, .lambda_c = 15e-6, .filter = CutOffFilter::robust});
    const auto wave = detail::robust_waviness(flat, 15e-6);
    CHECK((robust.map.heights == flat.heights - wave.waviness.heights).all());
    REQUIRE(robust.cut_offs.robust);
    CHECK(robust.cut_offs.robust->points == 64 * 80);
    // the test sees the order
    CHECK_FALSE(same(prepared.map,
                     detail::remove_form(detail::gaussian_high_pass(detail::gaussian_low_pass(map, 2.5e-6), 15e-6),
                                         MapForm::plane)));
}

TEST_CASE("A profile is cropped, masked, freed of spikes and filled, in this order") {
    Profile<double> profile{std::vector<double>(100), 1e-6};
    for (std::size_t i = 0; i < 100; ++i) profile.heights[i] = 1e-9 * std::sin(static_cast<double>(i * i));
    profile.heights[15] = 1e-6;  // a spike that the mask takes
    profile.heights[40] = -1e-6;
    profile.heights[60] = std::nan("");
    profile.heights[95] = 1e-6;  // one that the crop takes
    Cleaning<double> how{
        .crop = Crop<double>{10e-6, 79.9999999e-6}, .mask = PointMask::Ones(1, 71), .spikes = 10, .fill = true};
    how.mask(0, 5) = how.mask(0, 50) = false;  // 50: missing before
    Profile<double> cleaned = profile;
    const CleaningReport report = detail::clean(cleaned, how);
    CHECK(report.columns_read == 100);
    CHECK(report.columns == 71);  // 10 to 80: a bound within rounding of a point includes it
    CHECK(report.rows == 1);
    CHECK(report.masked == 1);
    CHECK(report.spikes == 1);
    CHECK(report.filled == 3);
    CHECK(report.largest_hole == 1);
    CHECK(missing(cleaned) == 0);
    Profile<double> by_hand{{profile.heights.begin() + 10, profile.heights.begin() + 81}, 1e-6};
    by_hand.heights[5] = by_hand.heights[50] = std::nan("");
    CHECK(detail::find_spikes(by_hand, 10).removed == 1);
    CHECK(detail::fill_missing(by_hand).missing == 3);
    CHECK(same(cleaned, by_hand));
    CHECK(cleaned.heights[30] == (by_hand.heights[29] + by_hand.heights[31]) / 2);
    how.mask = PointMask::Ones(1, 100);  // of the whole, not of the crop
    CHECK_THROWS_AS(detail::clean(cleaned = profile, how), domain_error);
    how.mask = PointMask{};
    how.spikes = 2.9;
    CHECK_THROWS_AS(detail::clean(cleaned = profile, how), domain_error);
    how.spikes = 1001;
    CHECK_THROWS_AS(detail::clean(cleaned = profile, how), domain_error);
    how.spikes = 3;
    CHECK_NOTHROW(detail::clean(cleaned = profile, how));
    for (const auto& [from, to] : {std::pair{-1e-6, 5e-6}, {5e-6, 5e-6}, {5e-6, 101e-6}, {5.1e-6, 5.9e-6}}) {
        how.crop = Crop<double>{from, to};
        CHECK_THROWS_AS(detail::clean(cleaned = profile, how), domain_error);
    }
}

TEST_CASE("A map is cropped along x and y, masked, freed of spikes and filled, in this order") {
    HeightMap<double> map{HeightMap<double>::Array(30, 40), 1e-6, 2e-6};
    for (Eigen::Index k = 0; k < map.size(); ++k) map.heights.data()[k] = 1e-9 * std::sin(static_cast<double>(k * k));
    map.heights(10, 10) = 1e-6;  // masked
    map.heights(20, 20) = 1e-6;
    Cleaning<double> how{
        .crop = Crop<double>{5e-6, 34e-6, 8e-6, 52e-6}, .mask = PointMask::Ones(23, 30), .spikes = 20, .fill = true};
    how.mask(6, 5) = false;  // row 10 - 4, column 10 - 5
    HeightMap<double> cleaned = map;
    const CleaningReport report = detail::clean(cleaned, how);
    CHECK(report.columns_read == 40);
    CHECK(report.rows_read == 30);
    CHECK(report.columns == 30);
    CHECK(report.rows == 23);
    CHECK(report.masked == 1);
    CHECK(report.spikes == 1);
    CHECK(report.filled == 2);
    HeightMap<double> by_hand{map.heights.block(4, 5, 23, 30), 1e-6, 2e-6};
    by_hand.heights(6, 5) = std::nan("");
    CHECK(detail::find_spikes(by_hand, 20).removed == 1);
    CHECK(detail::fill_missing(by_hand).missing == 2);
    CHECK(same(cleaned, by_hand));
    CHECK(std::abs(cleaned.heights(16, 15)) < 2e-9);
    how.mask = PointMask::Ones(30, 23);
    CHECK_THROWS_AS(detail::clean(cleaned = map, how), domain_error);
}

TEST_CASE("The points between two lengths") {
    CHECK(detail::points_between(0.0, 9e-6, 10, 1e-6)->count == 10);
    CHECK(detail::points_between(0.0, 10e-6, 10, 1e-6)->count == 10);  // the last point has a step of its own
    CHECK_FALSE(detail::points_between(0.0, 10.1e-6, 10, 1e-6));
    CHECK_FALSE(detail::points_between(3e-6, 2e-6, 10, 1e-6));
    CHECK(detail::points_between(2.2e-6, 2.8e-6, 10, 1e-6)->count == 0);
    CHECK(detail::points_between(2.2e-6, 4.8e-6, 10, 1e-6)->from == 3);
    CHECK(detail::points_between(2.2e-6, 4.8e-6, 10, 1e-6)->count == 2);
}

}  // namespace prepare_test
