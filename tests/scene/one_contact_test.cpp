// SPDX-License-Identifier: BSD-3-Clause
#include "actions/one_contact.hpp"

#include "actions/answered.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include <limits>
#include <string>
#include <vector>

namespace one_contact_test {

namespace {

using namespace fstiff;
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

surface::SurfaceOptions named_heights() {
    surface::SurfaceOptions options;
    options.file = "heights", options.lambda_s = "none";
    return options;
}

Joint joint_of(const Roughness<double>& surface, std::optional<double> r, std::optional<double> theta) {
    Joint joint{.face = {.rms_height = surface.rms_height,
                         .peak_radius = surface.peak_radius,
                         .peak_density = surface.peak_density,
                         .r = r,
                         .theta = theta},
                .effective_modulus = 112.6e9};
    joint.upper.elastic.poisson_ratio = std::numeric_limits<double>::quiet_NaN();
    return joint;
}

}  // namespace

TEST_CASE("every contact of a scene gives the curve of the scene") {
    const scene::Scene scene = scene::read_scene(with_surface, {.name = "scene"});
    const actions::Answered results = actions::compute(scene);
    std::size_t curve = 0;
    for (std::size_t law = 0; law < scene.laws.size(); ++law) {
        std::size_t peaks = 0;
        for (; curve < results.curves().size() && results.curves()[curve].law == scene.laws[law]->which; ++curve) {
            const actions::OneContact one = actions::make_contact(scene, law, peaks++);
            CHECK(one.law->which == results.curves()[curve].law);
            const auto points = one.contact->at_pressures(scene.points, Quantity::all);
            for (std::size_t i = 0; i < points.size(); ++i)
                CHECK(points[i].state.stiffness.value == results.curves()[curve].points[i].state.stiffness.value);
        }
        CHECK_THROWS_AS(actions::make_contact(scene, law, peaks), actions::no_such_entry);
    }
    CHECK(curve == results.curves().size());
    CHECK(test::refusal([&] { return actions::make_contact(scene, 3, 0); }) ==
          "law = 3: must be an entry of contact.laws");
}

TEST_CASE("what was measured of heights replaces the surface of a scene and of numbers") {
    const surface::SurfaceOptions options = named_heights();
    const surface::SurfaceInput input = surface::surface_of_heights(options, some_map(), "a test");
    CHECK(input.sha256.size() == 64);
    CHECK(input.surface.record.sentences().front() == "format: npy, from a test");
    surface::MeasureOptions how;
    how.input = options;
    const surface::MeasuredSurface measured = surface::measure_surface(how, input);
    const scene::Scene scene = scene::read_scene(bodies, {.name = "scene", .measured = &measured});
    CHECK(scene.joint.face.parameters.rms_height.value == measured.found.rms_height.value);
    const actions::Answered results = actions::compute(scene);
    for (std::size_t law = 0; law < scene.laws.size(); ++law) {
        const Joint joint{.face = {.measured = measured_face(measured.found)},
                          .effective_modulus = results.answer.effective_modulus};
        const actions::OneContact one = actions::make_contact(std::string(scene.laws[law]->name), joint);
        const auto points = one.contact->at_pressures(scene.points, Quantity::stiffness);
        for (std::size_t i = 0; i < points.size(); ++i)
            CHECK(points[i].state.stiffness.value == results.curves()[law].points[i].state.stiffness.value);
    }
}

TEST_CASE("heights and numbers that are not valid are refused in one sentence") {
    HeightMap<double> map = some_map();
    map.heights(3, 4) = std::numeric_limits<double>::infinity();
    CHECK(test::refusal([&] { (void)surface::surface_of_heights(named_heights(), map, "a test"); }) ==
          "heights: map with an infinite height: must be finite, or NaN where missing");
    CHECK(test::refusal([&] {
              (void)surface::surface_of_heights(named_heights(), Profile<double>{{1, 2}, 1}, "");
          }) == "heights: profile has 2 points: must be at least 16");
    const auto joint = [](double modulus, std::optional<double> r, std::optional<double> theta, double poisson) {
        Joint of = joint_of({0.832e-6, 40e-6, 500e6}, r, theta);
        of.effective_modulus = modulus, of.upper.yield_strength = 1e9, of.upper.elastic.poisson_ratio = poisson;
        return of;
    };
    // a missing number that may be 0 is not taken for 0
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const struct {
        const char* law;
        Joint of;
        std::string sentence;
    } rows[] = {{"hertz", joint(0, 0.5, 1, none), "effective_modulus = 0: must be finite and greater than 0"},
                {"herz", Joint(), "law = \"herz\": must be one of \"fractal\""},
                {"hertz", joint(112.6e9, {}, 1, none), "r: is missing; r and theta belong together"},
                {"hertz", joint(112.6e9, {}, {}, none), "law hertz: needs r and theta"},
                {"jackson_green", joint(112.6e9, 0, 1, none), "law jackson_green: needs poisson_ratio"},
                {"kogut_etsion", joint(112.6e9, 0, 1, none), "law kogut_etsion: needs poisson_ratio"},
                {"hertz", joint(112.6e9, 0, 1, none), ""},
                {"jackson_green", joint(112.6e9, 0, 1, 0), ""}};
    for (const auto& [law, of, sentence] : rows) {
        const std::string refusal = test::refusal([&] { (void)actions::make_contact(law, of); });
        INFO(law << ": " << refusal);
        CHECK((sentence.empty() ? refusal.empty() : refusal.starts_with(sentence)));
    }
    CHECK_THROWS_AS(actions::sensitivity_of("hertz", joint(112.6e9, 0, 1, none), -1), domain_error);
    CHECK_THROWS_AS(actions::sensitivity_of("none", joint(112.6e9, 0, 1, none), 1e7), domain_error);
}

TEST_CASE("the sensitivities of plain numbers are differences of the contact of the headers") {
    struct Numbers {
        double pressure = 1e7, rms_height = 0.832e-6, peak_radius = 40e-6, peak_density = 500e6,
               effective_modulus = 112.6e9, r = 0.5, theta = 1, fractal_dimension = 1.4;
    };
    const auto check = [](const std::string& name, double r, const auto& law) {
        const auto K = [&](const Numbers& x) {
            const RoughContact contact(Roughness<double>{x.rms_height, x.peak_radius, x.peak_density},
                                       PeakDistribution<double>(x.r, x.theta), law(x.fractal_dimension),
                                       x.effective_modulus);
            return contact.at_pressure(x.pressure, Quantity::stiffness).stiffness.value;
        };
        const Numbers numbers{.r = r};
        Joint joint = joint_of({numbers.rms_height, numbers.peak_radius, numbers.peak_density}, r, numbers.theta);
        joint.face.fractal_dimension = numbers.fractal_dimension;
        const auto by = actions::sensitivity_of(name, joint, numbers.pressure);
        const std::pair<const char*, double Numbers::*> members[] = {
            {"pressure", &Numbers::pressure},
            {"rms_height", &Numbers::rms_height},
            {"peak_radius", &Numbers::peak_radius},
            {"peak_density", &Numbers::peak_density},
            {"effective_modulus", &Numbers::effective_modulus},
            {"r", &Numbers::r},
            {"theta", &Numbers::theta},
            {"fractal_dimension", &Numbers::fractal_dimension}};
        for (const auto& [key, member] : members) {
            const double x = numbers.*member, scale = x > 0 ? x : 1;
            // Richardson's of central differences of steps of 4, 2 and 1 %; from r = 0 on of those of 8 orders
            const auto moved = [&](double change) {
                Numbers other = numbers;
                other.*member += change * scale;
                return K(other);
            };
            const auto central = [&](double step) { return (moved(step) - moved(-step)) / (2 * step); };
            double wanted = 0;
            if (x > 0) {
                wanted = (64 * central(0.01) - 20 * central(0.02) + central(0.04)) / 45;
            } else {
                constexpr double weights[] = {-761.0 / 280, 8,         -14,     56.0 / 3, -35.0 / 2,
                                              56.0 / 5,     -14.0 / 3, 8.0 / 7, -1.0 / 8};
                for (int i = 0; i < 9; ++i) wanted += weights[i] * moved(0.004 * i) / 0.004;
            }
            INFO(name << ", " << key);
            CHECK(std::abs(by.at(key) * scale - wanted) < 1e-7 * K(numbers));
        }
    };
    check("hertz", 0.5, [](double) { return HertzLaw<double>{}; });
    check("hertz", 0, [](double) { return HertzLaw<double>{}; });
    check("fractal_consistent", 0.5, [](double dimension) { return FractalConsistentLaw<double>(dimension); });
}

}  // namespace one_contact_test
