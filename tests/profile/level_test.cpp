// SPDX-License-Identifier: BSD-3-Clause
// Levelled profiles against the single steps; a fit compensates the removed line.
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/fractional_brownian.hpp"

namespace level_test {

using namespace fstiff;

namespace {

Profile<double> rough() {
    Profile<double> profile{test::fractional_brownian(2048, 0.8, 3), 1e-6};
    for (double& z : profile.heights) z *= 1e-8;
    return profile;
}

}  // namespace

TEST_CASE("A levelled profile is the detrended one and contains the form") {
    const auto profile = rough();
    for (const Form form : {Form::none, Form::mean, Form::line, Form::parabola}) {
        const auto flat = detail::level(profile, form);
        CHECK(flat.profile.heights == detail::detrend(profile, form).heights);
        CHECK(flat.profile.spacing == profile.spacing);
        CHECK(flat.removed == form);
    }
}

TEST_CASE("The short waves go after the form, the long ones after them") {
    const auto profile = rough();
    const auto line = detail::detrend(profile, Form::line);
    const auto low = detail::level(profile, Form::line, {}, 0, 20e-6);
    CHECK(low.profile.heights == detail::gaussian_low_pass(line, 20e-6).heights);
    CHECK(low.lambda_s == 20e-6);
    CHECK_FALSE(low.cutoff);
    const auto band = detail::level(profile, Form::line, 200e-6, 0, 20e-6);
    CHECK(band.profile.heights == detail::gaussian_roughness(detail::gaussian_low_pass(line, 20e-6), 200e-6).heights);
}

TEST_CASE("The long waves go after the form") {
    const auto profile = rough();
    const auto flat = detail::level(profile, Form::line, 200e-6);
    CHECK(flat.profile.heights == detail::gaussian_roughness(detail::detrend(profile, Form::line), 200e-6).heights);
    CHECK(flat.cutoff == 200e-6);
}

TEST_CASE("D of a filtered profile is that of the profile before the filters, from lags that lambda_c holds") {
    const auto low = detail::level(rough(), Form::line, {}, 0, 5e-6);
    const auto flat = detail::without_waviness(low, 100e-6);
    CHECK(flat.profile.heights == detail::gaussian_roughness(low.profile, 100e-6).heights);
    CHECK(flat.lambda_c == 100e-6);
    CHECK(flat.of_structure().heights == detail::detrend(rough(), Form::line).heights);
    FractalFitOptions<double> options;
    options.longest = 100e-6;
    const auto fit = fit_fractal(flat), same = fit_fractal(low, options);
    CHECK(fit.fractal.dimension == same.fractal.dimension);
    CHECK(fit.begins == WindowEnd::lambda_s);
    CHECK(fit.window.to <= 100e-6);
    CHECK(fit_fractal(low).window.to > 100e-6);
    CHECK(fit.structure_function.value == fit_fractal(low).structure_function.value);
}

TEST_CASE("A fit does not see whether a line was removed") {
    const auto profile = rough();
    const auto as_it_is = fit_fractal(profile), flat = fit_fractal(detail::level(profile, Form::line));
    CHECK(std::abs(flat.fractal.dimension - as_it_is.fractal.dimension) < 1e-9);
}

TEST_CASE("A profile that is its own form is refused as a constant one is, whatever the unit") {
    for (const double unit : {1.0, 1e-6, 1e9})
        for (const Form form : {Form::line, Form::parabola}) {
            Profile<double> profile{std::vector<double>(500), unit};
            for (std::size_t i = 0; i < 500; ++i) {
                const double x = static_cast<double>(i) / 7;
                profile.heights[i] = unit * (3 + (form == Form::line ? x : x * (x - 50)));
            }
            CHECK(test::refusal([&] {
                      (void)detail::level(profile, form);
                  }).find("profile of constant height once its form") == 0);
            profile.heights[250] += 1e-9 * unit;
            CHECK_NOTHROW(detail::level(profile, form));
        }
}

}  // namespace level_test
