// SPDX-License-Identifier: BSD-3-Clause
// measure() against its steps taken by hand; tests/scene/one_measurement_test.cpp holds the command, C and Python to
// it.
#include <fstiff/fstiff.hpp>
#include <fstiff/measure/lay.hpp>
#include <fstiff/measure/roughness_cut_off.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <atomic>
#include <thread>

namespace measure_test {

using namespace fstiff;
using test::relative_error;

namespace {

Profile<double> trace(double rms = 0.3e-6, std::size_t points = 4096) {
    return self_affine_profile<double>({.hurst = 0.4, .rms = rms, .longest_wavelength = 200e-6, .seed = 3}, points,
                                       0.5e-6);
}

HeightMap<double> some_map() {
    return self_affine_map<double>({.hurst = 0.7, .rms = 0.2e-6, .longest_wavelength = 12e-6, .seed = 2}, 96, 96,
                                   0.5e-6, 0.5e-6);
}

bool has(const Surface<double>& surface, MeasuredConcern concern) {
    return std::count(surface.concerns.begin(), surface.concerns.end(), concern) > 0;
}

/// Every number of \p a is that of \p b; of the errors too where \p errors.
void require_equal(const SurfaceParameters<double>& a, const SurfaceParameters<double>& b, bool errors) {
    const auto equal = [&](const Measurement<double>& one, const Measurement<double>& other) {
        CHECK(one.value == other.value);
        if (errors) CHECK(one.error == other.error);
    };
    equal(a.rms_height, b.rms_height);
    equal(a.peak_radius, b.peak_radius);
    equal(a.peak_density, b.peak_density);
    equal(a.max_peak_height, b.max_peak_height);
    REQUIRE(a.fractal_dimension.has_value() == b.fractal_dimension.has_value());
    if (a.fractal_dimension && errors) equal(*a.fractal_dimension, *b.fractal_dimension);
    REQUIRE(a.r.has_value() == b.r.has_value());
    if (a.r) equal(*a.r, *b.r), equal(*a.theta, *b.theta);
}

}  // namespace

TEST_CASE("A measured profile has the parameters of its steps taken by hand") {
    const auto profile = trace();
    const Surface<double> surface = measure(profile);
    const LevelledProfile<double> flat = detail::level(profile, Form::line, {}, 0, 2.5e-6);
    CHECK(surface.cut_offs.lambda_s == 2.5e-6);
    CHECK_FALSE(surface.cut_offs.lambda_c);  // a contact depends on all waves except the form
    CHECK(surface.cut_offs.why_c == CutOffReason::form_alone);
    detail::SurfaceParameterOptions<double> how;
    how.fit.lambda_s = 2.5e-6;
    const auto by_hand = detail::surface_parameters(flat, how);
    require_equal(surface, by_hand, true);
    const auto heights = height_statistics(flat.profile);
    REQUIRE(surface.heights);
    CHECK(surface.rms_gradient.value == heights.rms_gradient.value);
    CHECK(surface.rms_gradient.error == heights.rms_gradient.error);
    CHECK(surface.heights->skewness.value == heights.skewness.value);
    CHECK(surface.concerns == detail::concerns_of(by_hand, surface.profile->rms_gradient));
    CHECK(relative_error(surface.size, 4096 * 0.5e-6) < 1e-14);
    CHECK(relative_error(surface.widest_band, 819.2) < 1e-14);  // 2.048 mm over 2.5 um
    CHECK(surface.profile->rms == rms_height(flat.profile));
    CHECK_FALSE(surface.map);
}

TEST_CASE("A measured map has the parameters of its steps taken by hand") {
    const auto map = some_map();
    for (const PeakSource peaks : {PeakSource::islands, PeakSource::summits}) {
        const Surface<double> surface = measure(map, {.peaks = peaks, .neighbours = false});
        LevelledMap<double> flat = detail::level(map, MapForm::plane);
        flat.unfiltered = std::make_shared<const HeightMap<double>>(flat.map);
        flat.map = detail::gaussian_low_pass(flat.map, 2.5e-6);
        detail::SurfaceParameterOptions<double> how;
        how.fit.lambda_s = 2.5e-6;
        how.peaks = peaks;
        require_equal(surface, detail::surface_parameters(flat, how), true);
        CHECK(surface.cut_offs.lambda_s == 2.5e-6);
        CHECK_FALSE(surface.cut_offs.lambda_c);
        CHECK(relative_error(surface.size, 48e-6 * 48e-6) < 1e-14);
        CHECK(relative_error(surface.widest_band, 48 / 1.0) < 1e-14);  // to two steps: K takes all waves of a map
        REQUIRE(surface.all_waves);
        CHECK(surface.all_waves->rms_gradient.value == height_statistics(*flat.unfiltered).rms_gradient.value);
        CHECK(surface.rms_gradient.value == height_statistics(flat.map).rms_gradient.value);
        CHECK((surface.map->unfiltered->heights == flat.unfiltered->heights).all());  // which K is of
        CHECK_FALSE(surface.profile);
    }
    auto given = map;
    require_equal(measure(std::move(given), {.neighbours = false}), measure(map, {.neighbours = false}), true);
}

TEST_CASE("The neighbours are the surface with a shorter and a longer lambda_s, and the lambda_c that was given") {
    const auto profile = trace();
    const Surface<double> surface = measure(profile, {.lambda_c = 0.25e-3});
    REQUIRE(surface.neighbours.size() == 2);
    const double root = std::sqrt(2.0);
    for (std::size_t k = 0; k < 2; ++k) {
        const double lambda_s = k == 0 ? 2.5e-6 / root : 2.5e-6 * root;
        const Surface<double>& neighbour = surface.neighbours[k];
        CHECK(relative_error(*neighbour.cut_offs.lambda_s, lambda_s) < 1e-14);
        CHECK(neighbour.cut_offs.lambda_c == surface.cut_offs.lambda_c);
        CHECK(neighbour.neighbours.empty());
        require_equal(neighbour, measure(profile, {.lambda_s = *neighbour.cut_offs.lambda_s, .lambda_c = 0.25e-3}),
                      false);
    }
    CHECK(surface.neighbours[0].peak_radius.value < surface.peak_radius.value);
    CHECK(surface.neighbours[1].peak_radius.value > surface.peak_radius.value);
    const auto none = measure(profile, {.lambda_s = no_cut_off});
    REQUIRE(none.neighbours.size() == 1);
    CHECK(none.neighbours[0].cut_offs.lambda_s == 2e-6);
    CHECK_FALSE(none.neighbours[0].cut_offs.lambda_c);
    const auto shortest = measure(profile, {.lambda_s = 1.2e-6});
    REQUIRE(shortest.neighbours.size() == 1);
    CHECK(shortest.neighbours[0].cut_offs.lambda_s == 2.4e-6);
    const auto form = measure(profile, {.form_cut_off = 0.2e-3});
    REQUIRE(form.neighbours.size() == 2);
    CHECK(form.neighbours[0].cut_offs.lambda_c == 0.2e-3);
    CHECK(form.neighbours[0].profile->cutoff == 0.2e-3);
    CHECK(measure(profile, {.lambda_s = 1.9e-3, .lambda_c = no_cut_off, .neighbours = false}).neighbours.empty());
    const auto map = measure(some_map(), {.keep_maps = false});
    REQUIRE(map.neighbours.size() == 2);
    CHECK(map.map);
    CHECK_FALSE(map.neighbours[0].map);
    CHECK(map.neighbours[0].size == map.size);
}

TEST_CASE("Omitted parts leave all others unchanged") {
    const HeightMap<double> map = some_map();
    const Surface<double> whole = measure(map, {.lambda_s = 2e-6});
    const Surface<double> lean = measure(map, {.lambda_s = 2e-6, .neighbour_dimensions = false});
    require_equal(lean, whole, true);
    CHECK(lean.texture_aspect_ratio == detail::texture_aspect_ratio(lean.map->map));
    REQUIRE(lean.neighbours.size() == whole.neighbours.size());
    for (std::size_t k = 0; k < whole.neighbours.size(); ++k) {
        SurfaceParameters<double> with_dimension = lean.neighbours[k];
        CHECK_FALSE(with_dimension.fractal_dimension);
        CHECK(with_dimension.why_no_dimension == "D was not asked for");
        with_dimension.fractal_dimension = whole.neighbours[k].fractal_dimension;
        require_equal(with_dimension, whole.neighbours[k], true);
    }
    const Surface<double> flat = measure(trace(), {.dimension = false, .neighbours = false});
    CHECK_FALSE(flat.fractal_dimension);
    CHECK(flat.peak_radius.value == measure(trace(), {.neighbours = false}).peak_radius.value);
    CHECK(measure(map, {.texture = false, .neighbours = false}).texture_aspect_ratio == 1);
}

TEST_CASE("A surface measured on two threads has the digits of one thread, and reports to none") {
    std::atomic<int> pieces = 0;
    const ParallelHook on_two_threads = [&](std::size_t count, const auto& run) {
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t i = next++; i < count; i = next++) ++pieces, run(i);
        };
        std::thread other(work);
        work();
        other.join();
    };
    const auto never = [](std::string_view, std::size_t, std::size_t) { throw domain_error("called"); };
    const auto check = [&](const auto& heights, int parts) {
        const Surface<double> one = measure(heights);
        pieces = 0;
        const Surface<double> two = measure(heights, {.progress = never, .parallel = on_two_threads});
        CHECK(pieces == parts);
        const auto same = [](const Surface<double>& a, const Surface<double>& b) {
            require_equal(a, b, true);
            CHECK(a.concerns == b.concerns);
            CHECK(a.shape_share == b.shape_share);
            CHECK(a.heights->kurtosis.value == b.heights->kurtosis.value);
            CHECK(a.repetition.correlation == b.repetition.correlation);
            CHECK(a.texture_aspect_ratio == b.texture_aspect_ratio);
            CHECK(a.long_end.hurst == b.long_end.hurst);
        };
        same(two, one);
        REQUIRE(two.neighbours.size() == 2);
        for (std::size_t k = 0; k < 2; ++k) same(two.neighbours[k], one.neighbours[k]);
    };
    check(trace(), 3 + 3 * 2);
    check(some_map(), 2 + 3 + 3 * 2 + 1 + 1 + 2);  // sections are measured once; scan lines of the map alone
    CHECK(test::refusal([&] {
              (void)measure(trace(), {.resamples = 1, .parallel = on_two_threads});
          }).find("resamples") == 0);
}

TEST_CASE("Concerns are reported each with its cause") {
    CHECK_FALSE(has(measure(trace(), {.neighbours = false}), MeasuredConcern::implausible_gradient));
    CHECK(has(measure(trace(30e-6), {.neighbours = false}), MeasuredConcern::implausible_gradient));
    auto ridges = trace();
    for (std::size_t i = 0; i < ridges.size(); ++i)
        ridges.heights[i] += 2e-6 * std::sin(2 * std::numbers::pi_v<double> * static_cast<double>(i) / 100);
    CHECK(has(measure(ridges, {.neighbours = false}), MeasuredConcern::lay));
    auto waves = trace();
    for (std::size_t i = 0; i < waves.size(); ++i)
        waves.heights[i] += 5e-6 * std::sin(2 * std::numbers::pi_v<double> * static_cast<double>(i) / 4096);
    CHECK(has(measure(waves, {.neighbours = false}), MeasuredConcern::long_waves));
    CHECK_FALSE(has(measure(waves, {.lambda_c = 0.25e-3, .neighbours = false}), MeasuredConcern::long_waves));
}

TEST_CASE("A surface is cleaned before it is measured, and options reach their step") {
    auto profile = trace();
    profile.heights[1000] += 20e-6;
    const Cleaning<double> cleaning{.crop = Crop<double>{100e-6, 1.8e-3}, .spikes = 10, .fill = true};
    const auto surface = measure(profile, {.cleaning = cleaning, .neighbours = false});
    auto by_hand = profile;
    CHECK(detail::clean(by_hand, cleaning).spikes == surface.cleaning.spikes);
    CHECK(surface.cleaning.spikes >= 1);
    CHECK(surface.cleaning.columns == 3401);
    require_equal(surface, measure(by_hand, {.neighbours = false}), true);
    CHECK(profile.size() == 4096);
    const auto few = measure(profile, {.resamples = 20, .seed = 7, .neighbours = false});
    const auto many = measure(profile, {.neighbours = false});
    CHECK(few.rms_height.value == many.rms_height.value);
    CHECK(few.rms_height.error != many.rms_height.error);
    CHECK(few.seed == 7);
    const auto windowed = measure(trace(), {.window = LengthRange<double>{3e-6, 30e-6}, .neighbours = false});
    CHECK(windowed.window.to <= 30e-6);
    CHECK(measure(trace(), {.tip_radius = 5e-6, .neighbours = false}).cut_offs.lambda_s == 8e-6);
    auto map = some_map();
    map.heights(5, 5) = 1;
    const Cleaning<double> spikes{.spikes = 50, .fill = true};
    const auto of_map = measure(map, {.cleaning = spikes, .neighbours = false});
    CHECK(of_map.cleaning.spikes == 1);
    CHECK(map.heights(5, 5) == 1);
    CHECK(of_map.rms_height.value < 1e-6);
}

TEST_CASE("Options that do not fit a surface are refused") {
    CHECK_THROWS_AS(measure(trace(), {.peaks = PeakSource::summits}), domain_error);
    CHECK_THROWS_AS(measure(some_map(), {.tip_radius = 1e-6}), domain_error);
    CHECK_THROWS_AS(measure(trace(), {.lambda_s = 0.9e-6}), domain_error);
    CHECK_THROWS_AS(measure(some_map(), {.form_cut_off = 5e-6}), domain_error);
    CHECK_THROWS_AS(measure(trace(), {.resamples = 1}), domain_error);
}

TEST_CASE("Too few points for the statistics of heights leave the parameters", "[measure]") {
    const auto profile = trace(0.3e-6, 60);
    const auto surface = measure(profile, {.lambda_s = no_cut_off});
    CHECK_FALSE(surface.heights);
    CHECK(surface.rms_gradient.value == surface.profile->rms_gradient);
    CHECK(surface.rms_gradient.error == 0);
    CHECK(surface.rms_height.value > 0);
}

#ifdef FSTIFF_MORE_TESTS
TEST_CASE("Single precision measures what double does", "[measure]") {
    const auto profile = trace();
    Profile<float> single{{profile.heights.begin(), profile.heights.end()}, 0.5e-6F};
    const auto a = measure(single, {.neighbours = false});
    const auto b = measure(profile, {.neighbours = false});
    CHECK(a.cut_offs.lambda_s.value() == 2.5e-6F);
    CHECK(relative_error(static_cast<double>(a.rms_height.value), b.rms_height.value) < 1e-4);
    CHECK(relative_error(static_cast<double>(a.peak_radius.value), b.peak_radius.value) < 1e-3);
}
#endif

}  // namespace measure_test
