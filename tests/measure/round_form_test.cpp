// SPDX-License-Identifier: BSD-3-Clause
// Balls, rods and rings: the roughness that was put on them comes back.
#include <fstiff/measure/prepare.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace round_form_test {

using namespace fstiff;

namespace {

const SelfAffineOptions<double> roughness{
    .hurst = 0.8, .rms = 0.1e-6, .longest_wavelength = 100e-6, .shortest_wavelength = 16e-6, .seed = 3};

/// 1 mm of a surface of \p radius [m], below 0 where it is hollow, curved along x and \p along_y.
HeightMap<double> round_map(double radius, bool along_y) {
    HeightMap<double> map = self_affine_map(roughness, 256, 256, 4e-6, 4e-6);
    for (Eigen::Index j = 0; j < 256; ++j)
        for (Eigen::Index i = 0; i < 256; ++i) {
            const double x = 4e-6 * (double(i) - 100), y = along_y ? 4e-6 * (double(j) - 140) : 0;
            const double r = radius + map.heights(j, i);
            map.heights(j, i) = std::copysign(std::sqrt(r * r - x * x - y * y), radius) - radius;
        }
    return map;
}

Profile<double> ring(double radius) {
    Profile<double> profile = self_affine_profile(roughness, 1000, 1e-6);
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const double x = 1e-6 * (double(i) - 400), r = radius + profile.heights[i];
        profile.heights[i] = std::copysign(std::sqrt(r * r - x * x), radius) - radius;
    }
    return profile;
}

}  // namespace

TEST_CASE("Balls and rods of 2 and 5 mm have the sigma of their roughness to 1 %, and their radius") {
    const double sigma = rms_height(self_affine_map(roughness, 256, 256, 4e-6, 4e-6));
    for (const double radius : {5e-3, 2e-3, -2e-3})
        for (const MapForm form : {MapForm::sphere, MapForm::cylinder}) {
            CAPTURE(radius, name_of(form));
            const HeightMap<double> map = round_map(radius, form == MapForm::sphere);
            for (const double given : {0.0, std::abs(radius)}) {
                const PreparedMap<double> flat =
                    prepare(map, {.lambda_s = no_cut_off, .map_form = form, .form_radius = given});
                CHECK(test::relative_error(flat.rms, sigma) < 0.01);
                CHECK(test::relative_error(flat.radius, radius) < 1e-3);
            }
            const MapForm best = MapForm::quadratic;  // what there was before: 0.5 to 90 % above
            if (std::abs(radius) < 3e-3)
                CHECK(prepare(map, {.lambda_s = no_cut_off, .map_form = best}).rms > 1.3 * sigma);
        }
}

TEST_CASE("A trace of a ring has the sigma of its roughness to 1 %, and its radius") {
    for (const double radius : {4e-3, -4e-3, 1.3e-3}) {
        const Profile<double> rough = self_affine_profile(roughness, 1000, 1e-6);
        const PreparedProfile<double> flat = prepare(ring(radius), {.lambda_s = no_cut_off, .form = Form::circle});
        // the waves that the circle takes with it are those that a parabola takes from the flat trace
        CHECK(test::relative_error(flat.rms, prepare(rough, {.lambda_s = no_cut_off, .form = Form::parabola}).rms) <
              0.01);
        CHECK(test::relative_error(flat.radius, radius) < 3e-3);
        CHECK(flat.removed == Form::circle);
    }
}

TEST_CASE("Missing points stay missing, and a form that does not suit is refused") {
    Profile<double> trace = ring(4e-3);
    trace.heights[10] = std::numeric_limits<double>::quiet_NaN();
    CHECK(std::isnan(prepare(trace, {.lambda_s = no_cut_off, .form = Form::circle}).profile.heights[10]));
    CHECK(test::refused_for("degrees from the height: must be at most 30",
                            [] { return prepare(ring(0.62e-3), {.form = Form::circle}); }));
    CHECK(test::refused_for("align = median: must be none for a profile", [&] {
        Profile<double> copy = trace;
        return detail::clean(copy, {.align = LineAlignment::median});
    }));
}

}  // namespace round_form_test
