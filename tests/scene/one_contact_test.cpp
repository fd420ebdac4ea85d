// SPDX-License-Identifier: BSD-3-Clause
#include "scene/one_contact.hpp"

#include "scene/results.hpp"

#include "support/catch.hpp"

#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/sensitivity.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include <limits>
#include <string>
#include <vector>

namespace one_contact_test {

namespace {

using namespace fstiff;
using namespace fstiff::scene;

const std::string bodies = R"(
[material.upper]
youngs_modulus = "205 GPa"
poisson_ratio = 0.3
[contact]
pressures = ["1 MPa", "10 MPa"]
laws = ["hertz", "hybrid", "greenwood_williamson"]
[uncertainty]
samples = 0
)";
const std::string with_surface = R"(
[surface]
rms_height = "1 um"
peak_radius = "20 um"
peak_density = "2000 /mm^2"
)" + bodies;

HeightMap<double> some_map() {
    SelfAffineOptions<double> options;
    options.hurst = 0.7, options.rms = 1e-6;
    return self_affine_map(options, 64, 48, 1e-6, 1.5e-6);
}

SurfaceOptions named_heights() {
    SurfaceOptions options;
    options.file = "heights", options.lambda_s = "none";
    return options;
}

std::string sentence_of(const auto& call) {
    try {
        (void)call();
    } catch (const domain_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("one contact of numbers is that of the library, bit for bit") {
    const Roughness<double> surface{0.832e-6, 40e-6, 500e6, 5.3e-6};
    const RoughContact expected(surface, PeakDistribution<double>(0.5, 1.0), HertzLaw<double>{}, 112.6e9);
    const OneContact one =
        contact_of("hertz", {.surface = surface, .r = 0.5, .theta = 1.0, .effective_modulus = 112.6e9});
    const std::vector<double> pressures{1e5, 1e7};
    const auto points = one.contact->at_pressures(pressures, Quantity::all);
    for (std::size_t i = 0; i < pressures.size(); ++i)
        CHECK(points[i].state.stiffness.value == expected.at_pressure(pressures[i]).stiffness.value);
    CHECK(one.law->name == "hertz");
}

TEST_CASE("every contact of a scene gives the curve of the scene") {
    const Scene scene = read_scene(with_surface, {.name = "scene"});
    const Results results = compute(scene);
    std::size_t curve = 0;
    for (std::size_t law = 0; law < scene.laws.size(); ++law) {
        std::size_t peaks = 0;
        for (; curve < results.curves.size() && results.curves[curve].law == scene.laws[law]; ++curve) {
            const OneContact one = contact_of(scene, law, peaks++);
            CHECK(one.law == results.curves[curve].law);
            const auto points = one.contact->at_pressures(scene.points, Quantity::all);
            for (std::size_t i = 0; i < points.size(); ++i)
                CHECK(points[i].state.stiffness.value == results.curves[curve].states[i].stiffness.value);
        }
        CHECK_THROWS_AS(contact_of(scene, law, peaks), no_such_entry);
    }
    CHECK(curve == results.curves.size());
    CHECK(sentence_of([&] { return contact_of(scene, 3, 0); }) == "law = 3: must be an entry of contact.laws");
}

TEST_CASE("what was measured of heights replaces the surface of a scene and of numbers") {
    const SurfaceOptions options = named_heights();
    const SurfaceInput input = surface_of_heights(options, some_map(), "a test");
    CHECK(input.sha256.size() == 64);
    CHECK(input.surface.record.sentences().front() == "format: npy, from a test");
    scene::MeasureOptions how;
    how.input = options;
    const MeasuredSurface measured = measure_surface(how, input);
    const Scene scene = read_scene(bodies, {.name = "scene", .measured = &measured});
    CHECK(scene.face.parameters.rms_height.value == measured.found.rms_height.value);
    const Results results = compute(scene);
    for (std::size_t law = 0; law < scene.laws.size(); ++law) {
        const OneContact one =
            contact_of(std::string(scene.laws[law]->name), {.effective_modulus = results.modulus}, &measured);
        const auto points = one.contact->at_pressures(scene.points, Quantity::stiffness);
        for (std::size_t i = 0; i < points.size(); ++i)
            CHECK(points[i].state.stiffness.value == results.curves[law].states[i].stiffness.value);
    }
}

TEST_CASE("heights and numbers that are not valid are refused in one sentence") {
    HeightMap<double> map = some_map();
    map.heights(3, 4) = std::numeric_limits<double>::infinity();
    CHECK(sentence_of([&] { return surface_of_heights(named_heights(), map, "a test"); }) ==
          "heights: map with an infinite height: must be finite, or NaN where missing");
    CHECK(sentence_of([&] {
              return surface_of_heights(named_heights(), Profile<double>{{1, 2}, 1}, "");
          }) == "heights: profile has 2 points: must be at least 16");
    CHECK(sentence_of([] { return contact_of("hertz", {}); }) ==
          "effective_modulus = 0: must be finite and greater than 0");
    CHECK(sentence_of([] {
              return contact_of("herz", {.effective_modulus = 1e11});
          }).starts_with("law = \"herz\": must be one of \"fractal\""));
}

TEST_CASE("a missing number that may be 0 is not taken for 0") {
    const Roughness<double> surface{.rms_height = 0.832e-6, .peak_radius = 40e-6, .peak_density = 500e6};
    ContactNumbers numbers{.surface = surface, .theta = 1.0, .effective_modulus = 112.6e9, .yield_strength = 1e9};
    CHECK(sentence_of([&] { return contact_of("hertz", numbers); }) == "law hertz: needs r");
    numbers.r = 0;
    CHECK(contact_of("hertz", numbers).contact);
    CHECK(sentence_of([&] { return contact_of("jackson_green", numbers); }) ==
          "law jackson_green: needs poisson_ratio");
    CHECK(sentence_of([&] { return contact_of("kogut_etsion", numbers); }) == "law kogut_etsion: needs poisson_ratio");
    numbers.poisson_ratio = 0;
    CHECK(contact_of("jackson_green", numbers).contact);
    numbers.theta.reset();
    CHECK(sentence_of([&] { return contact_of("hertz", numbers); }) == "law hertz: needs theta");
}

TEST_CASE("the sensitivities of plain numbers are the exact derivatives of the headers") {
    ContactNumbers numbers{.surface = {0.832e-6, 40e-6, 500e6}, .r = 0.5, .theta = 1.0, .fractal_dimension = 1.4};
    numbers.effective_modulus = 112.6e9;
    const PeakDistribution<double> peaks(0.5, 1.0);
    const double p = 1e7;
    const auto check = [&](const std::string& law, const Sensitivity<double>& exact) {
        const auto by = sensitivity_of(law, numbers, p);
        const auto agrees = [&](const char* name, double x, double wanted) {
            INFO(law << ", " << name);
            CHECK(std::abs(by.at(name) - wanted) * x < 1e-7 * exact.stiffness);
        };
        agrees("pressure", p, exact.pressure);
        agrees("rms_height", 0.832e-6, exact.rms_height);
        agrees("peak_radius", 40e-6, exact.peak_radius);
        agrees("peak_density", 500e6, exact.peak_density);
        agrees("effective_modulus", 112.6e9, exact.effective_modulus);
        agrees("r", 1, exact.r);
        agrees("theta", 1, exact.theta);
        agrees("fractal_dimension", 1.4, exact.fractal_dimension);
    };
    check("hertz", sensitivity(RoughContact(numbers.surface, peaks, HertzLaw<double>{}, 112.6e9), p));
    check("fractal_consistent",
          sensitivity(RoughContact(numbers.surface, peaks, FractalConsistentLaw<double>(1.4), 112.6e9), p));
}

TEST_CASE("a sensitivity by r at r = 0 is taken from above, and bad numbers are refused") {
    ContactNumbers numbers{.surface = {0.832e-6, 40e-6, 500e6}, .r = 0.0, .theta = 1.0};
    numbers.effective_modulus = 112.6e9;
    const RoughContact contact(numbers.surface, PeakDistribution<double>(0.0, 1.0), HertzLaw<double>{}, 112.6e9);
    const auto exact = sensitivity(contact, 1e7);
    CHECK(std::abs(sensitivity_of("hertz", numbers, 1e7).at("r") - exact.r) < 1e-7 * exact.stiffness);
    CHECK_THROWS_AS(sensitivity_of("hertz", numbers, -1), domain_error);
    CHECK_THROWS_AS(sensitivity_of("none", numbers, 1e7), domain_error);
}

}  // namespace one_contact_test
