// SPDX-License-Identifier: BSD-3-Clause
// Every concern just within its limit and just beyond it; and of surfaces that are made to have it.
#include <fstiff/measure/concerns.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/catch.hpp"

#include <algorithm>

namespace measured_concerns_test {

using namespace fstiff;
using enum MeasuredConcern;

namespace {

using Concerns = std::vector<MeasuredConcern>;

FractalFit<double> sound_fit() {
    FractalFit<double> fit;
    fit.fractal = {1.5, 1e-9};
    fit.dimension_error = 0.02;
    fit.log_roughness_error = 2.3;
    fit.automatic_window = true;
    fit.window = {1e-6, 20e-6};
    fit.min_slope = 0.69;
    fit.flattest_lag = 0.5e-6;
    fit.flattest_slope = 0.19;
    return fit;
}

}  // namespace

TEST_CASE("A sound fit has no concerns") {
    CHECK(detail::concerns_of(sound_fit()).empty());
    LevelledProfile<double> levelled;
    CHECK(detail::concerns_of(sound_fit(), levelled, {}).empty());
    levelled.cutoff = 200e-6;
    detail::SpectralFit<double> spectrum;
    spectrum.dimension = 1.61;
    spectrum.dimension_error = 0.031;  // three times hypot(0.031, 0.02) is 0.1107
    CHECK(detail::concerns_of(sound_fit(), levelled, std::optional(spectrum)).empty());
}

TEST_CASE("A fit reports each concern beyond its limit") {
    auto fit = sound_fit();
    fit.curved = true;
    CHECK(detail::concerns_of(fit) == Concerns{curved});
    fit = sound_fit();
    fit.min_slope = 0.7;
    CHECK(detail::concerns_of(fit) == Concerns{saturated});
    fit.automatic_window = false;
    CHECK(detail::concerns_of(fit).empty());
    fit = sound_fit();
    fit.after_plateau = true;
    CHECK(detail::concerns_of(fit) == Concerns{saturated});
    fit.flattest_slope = 0.21;
    CHECK(detail::concerns_of(fit).empty());
    fit = sound_fit();
    fit.log_roughness_error = 2.31;
    CHECK(detail::concerns_of(fit) == Concerns{roughness_uncertain});
    LevelledProfile<double> levelled;
    levelled.cutoff = 199e-6;
    detail::SpectralFit<double> spectrum;
    spectrum.dimension = 1.61;
    spectrum.dimension_error = 0.0299;  // three times hypot(0.0299, 0.02) is 0.108
    CHECK(detail::concerns_of(sound_fit(), levelled, std::optional(spectrum)) == Concerns{filtered, spectrum_differs});
    spectrum.dimension = 1.59;  // less than 0.1 away
    spectrum.dimension_error = 0;
    CHECK(detail::concerns_of(sound_fit(), {}, std::optional(spectrum)).empty());
}

TEST_CASE("A surface reports each concern beyond its limit") {
    SurfaceParameters<double> surface;
    surface.peak_radius = {1e-6, 0.299e-6};
    surface.peak_density = {1e9, 0.299e9};
    surface.peaks_counted = 30;
    CHECK(detail::concerns_of(surface).empty());
    surface.peak_radius.error = 0.301e-6;
    CHECK(detail::concerns_of(surface) == Concerns{radius_uncertain});
    surface.peak_density.error = 0.301e9;
    surface.peaks_counted = 29;
    surface.anisotropic = surface.curved = true;
    CHECK(detail::concerns_of(surface) ==
          Concerns{curved, anisotropic, few_peaks, radius_uncertain, density_uncertain});
    surface = {};
    surface.peaks_counted = 30;
    for (const double gradient : {1e-6, 0.1, 1.0}) CHECK(detail::concerns_of(surface, gradient).empty());
    for (const double gradient : {9.9e-7, 1.01, std::numeric_limits<double>::infinity()})
        CHECK(detail::concerns_of(surface, gradient) == Concerns{implausible_gradient});
    CHECK(detail::is_fatal(implausible_gradient));
}

TEST_CASE(
    "A parameter with an error above half its value is not known and islands with maximum density at an end give no R "
    "and D_p") {
    SurfaceParameters<double> surface;
    surface.peaks_counted = 30;
    surface.rms_height = {1e-6, 0.5e-6};
    surface.r = {0.4, 0.2};
    CHECK(detail::concerns_of(surface).empty());
    surface.r->error = 0.2001;
    CHECK(detail::concerns_of(surface) == Concerns{parameter_unknown});
    surface.long_wave_share = 0.751;  // which gives the reason for r, and hides no sigma
    CHECK(detail::concerns_of(surface) == Concerns{long_waves});
    surface.rms_height.error = 0.501e-6;
    CHECK(detail::concerns_of(surface) == Concerns{long_waves, parameter_unknown});
    surface.rms_height.error = 0.5e-6;
    surface.long_wave_share = 0.75;
    surface.r.reset();
    surface.peak_radius = {1e-6, 0.501e-6};
    CHECK(detail::concerns_of(surface) == Concerns{radius_uncertain, parameter_unknown});

    RepresentativeIslands<double> islands;
    islands.islands = 30;
    islands.radius = islands.density = 1;
    islands.curve.level = {3, 2, 1};
    islands.index = 1;
    CHECK(detail::concerns_of(islands).empty());
    for (const std::size_t end : {0u, 2u}) {
        islands.index = end;
        CHECK(detail::concerns_of(islands) == Concerns{no_densest_level});
    }
    surface.peak_radius = {};
    surface.islands = islands;
    CHECK(detail::concerns_of(surface) == Concerns{no_densest_level});
    islands.index = 1;
    islands.density_error = 0.51;
    CHECK(detail::concerns_of(islands) == Concerns{density_uncertain, parameter_unknown});
    CHECK((detail::is_fatal(no_densest_level) && detail::is_fatal(parameter_unknown) &&
           !detail::is_fatal(radius_uncertain)));
}

TEST_CASE("A parabola or a step of more than half of the mean square height is a concern, and the greater one counts") {
    SurfaceParameters<double> surface;
    surface.peaks_counted = 30;
    surface.plain_form = {.parabola = 0.5, .step = 0.5};
    CHECK(detail::concerns_of(surface).empty());
    surface.plain_form.parabola = 0.51;
    CHECK(detail::concerns_of(surface) == Concerns{form});
    surface.plain_form.step = 0.52;
    CHECK(detail::concerns_of(surface) == Concerns{step});
    CHECK((detail::is_fatal(form) && detail::is_fatal(step)));
}

TEST_CASE("R and D_p that are not known are no parameters of few peaks") {
    SurfaceParameters<double> surface;
    surface.rms_height = {1e-6, 1e-8};
    surface.peaks_counted = 1;
    CHECK(detail::concerns_of(surface).empty());
    CHECK(surface.find(Parameter::peak_radius) == nullptr);
    surface.set(Parameter::peak_density, {1e9, 1e8});
    REQUIRE(surface.find(Parameter::peak_density));
    CHECK(detail::concerns_of(surface) == Concerns{few_peaks});
}

TEST_CASE("A map that is stretched is reported as anisotropic") {
    auto map = self_affine_map<double>({.hurst = 0.6, .rms = 1e-6, .seed = 3}, 256, 256, 1e-6, 1e-6);
    map.dx *= 4;
    const Concerns found = detail::concerns_of(detail::surface_parameters(detail::level(map, MapForm::plane)));
    CHECK(std::find(found.begin(), found.end(), anisotropic) != found.end());
}

}  // namespace measured_concerns_test
