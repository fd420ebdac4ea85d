// SPDX-License-Identifier: BSD-3-Clause
// Truth: a loop over the sampler; with an error of D_p alone K grows with it, so that the quantiles of K are K at those
// of D_p, which are closed.
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/measured/stiffness_band.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace stiffness_band_test {

using namespace fstiff;
using test::relative_error;

namespace {

parts::SurfaceParameters<double> surface() {
    parts::SurfaceParameters<double> s;
    s.set(Parameter::rms_height, {0.832e-6, 0});
    s.set(Parameter::peak_radius, {40e-6, 0});
    s.set(Parameter::peak_density, {500e6, 0});
    s.set(Parameter::fractal_dimension, {1.62, 0});
    s.set(Parameter::r, {0.6, 0});
    s.set(Parameter::theta, {1.1, 0});
    return s;
}

const auto fractal = [](double dimension) { return FractalLaw<double>(dimension); };
const std::vector<double> pressures{1e5, 1e7};

}  // namespace

TEST_CASE("Without errors the band is K itself") {
    const auto band = stiffness_band(surface(), pressures, fractal, 112.6e9, {.samples = 20});
    const RoughContact contact(Roughness<double>{0.832e-6, 40e-6, 500e6}, PeakDistribution<double>(0.6, 1.1),
                               FractalLaw<double>(1.62), 112.6e9);
    REQUIRE(band.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const double k = contact.at_pressure(pressures[i]).stiffness.value;
        CHECK((band[i].low == k && band[i].median == k && band[i].high == k && band[i].failed == 0));
    }
}

TEST_CASE("The band is that of a loop over the surfaces, and of its seed") {
    parts::SurfaceParameters<double> s = surface();
    for (const auto& [which, error] : {std::pair{Parameter::rms_height, 0.1e-6},
                                       {Parameter::peak_radius, 4e-6},
                                       {Parameter::peak_density, 100e6},
                                       {Parameter::fractal_dimension, 0.05},
                                       {Parameter::r, 0.1},
                                       {Parameter::theta, 0.1}})
        s.find(which)->error = error;
    const auto band = stiffness_band(s, pressures, fractal, 112.6e9, {.samples = 101, .seed = 3});
    parts::SurfaceSampler<double> draw(s, 3);
    std::vector<std::vector<double>> k(2);
    for (int n = 0; n < 101; ++n) {
        const auto x = draw();
        const RoughContact contact(Roughness<double>{x[0], x[1], x[2]}, PeakDistribution<double>(x[4], x[5]),
                                   FractalLaw<double>(x[3]), 112.6e9);
        for (std::size_t i = 0; i < 2; ++i)
            k[i].push_back(contact.at_pressure(pressures[i], Quantity::stiffness).stiffness.value);
    }
    for (std::size_t i = 0; i < 2; ++i) {
        std::sort(k[i].begin(), k[i].end());
        CHECK((band[i].low == k[i][5] && band[i].median == k[i][50] &&
               band[i].high == k[i][95]));  // of 101: exact places
    }
    const auto other = stiffness_band(s, pressures, fractal, 112.6e9, {.samples = 101, .seed = 4});
    CHECK(other[0].low != band[0].low);
}

TEST_CASE("The band over the error of the density of peaks is that of its quantiles") {
    parts::SurfaceParameters<double> s = surface();
    s.peak_density.error = 100e6;
    // p and K are both proportional to D_p: at a pressure p of the surface with c D_p, K = c K_1(p/c) of the surface
    // itself
    const auto contact_of = [](const auto& drawn) {
        return GreenwoodWilliamson<double>(detail::roughness_of(drawn), 112.6e9);
    };
    const auto band = stiffness_band(s, pressures, contact_of, {.samples = 4001, .seed = 1});
    const GreenwoodWilliamson<double> one(Roughness<double>{0.832e-6, 40e-6, 500e6}, 112.6e9);
    const double s_log = std::sqrt(std::log1p(0.2 * 0.2));
    for (std::size_t i = 0; i < 2; ++i)
        for (const auto& [z, found] :
             {std::pair(-1.6448536, band[i].low), std::pair(0.0, band[i].median), std::pair(1.6448536, band[i].high)}) {
            const double c = std::exp(z * s_log);
            const double expected = c * one.at_pressure(pressures[i] / c, Quantity::stiffness).stiffness.value;
            // ln K varies less than ln D_p, whose quantile of 4001 draws has a standard error of 0.033 s_log
            CHECK(relative_error(found, expected) < 4 * 0.033 * s_log);
            CHECK(relative_error(found, expected) < 0.01);
        }
}

TEST_CASE("Surfaces that do not reach a pressure are left out there and impossible ones are refused") {
    parts::SurfaceParameters<double> s = surface();
    s.rms_height.error = 0.2e-6;
    const auto at =
        stiffness_band(s, std::vector{1e-287, 1e6},
                       [](const auto& drawn) {
                           return RoughContact(detail::roughness_of(drawn), PeakDistribution<double>(0.6, 1.1),
                                               HertzLaw<double>{}, 112.6e9);
                       },
                       {.samples = 50});
    CHECK((at[0].failed > 0 && at[1].failed == 0));

    s.r.reset();
    CHECK(test::refusal([&] { (void)stiffness_band(s, pressures, fractal, 112.6e9); }) ==
          "r and theta of the surface are not known: must be known for the density of its peaks");
    CHECK(test::refusal([&] { (void)stiffness_band(surface(), std::vector{-1.0}, fractal, 112.6e9); }) ==
          "pressure = -1: must be finite and greater than 0");
}

}  // namespace stiffness_band_test
