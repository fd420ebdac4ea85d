// SPDX-License-Identifier: BSD-3-Clause
// Numbers in another unit, points without a stiffness, refusals of a body, and what an answer assumes next to named
// laws. Truth: the sentences written out, and the scene without the names.
#include <fstiff/answer.hpp>

#include "support/library.hpp"

#include <fstiff/asperity/named_materials.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace likely_units_test {

using namespace fstiff;
using test::contains;

namespace {

Joint steel_joint() {
    const Body steel = body_of(*find_material("steel"));
    return {.face = {.rms_height = 0.8e-6, .rms_gradient = 0.1}, .upper = steel, .lower = steel};
}

std::set<Concern> kinds(const Answer& found) {
    std::set<Concern> all;
    for (const auto& check : found.concerns) all.insert(check.concern);
    return all;
}

std::string scene_of(const std::string& height, const std::string& material, const std::string& contact) {
    return "[surface]\nrms_height = \"" + height + "\"\nrms_gradient = 0.1\n[material]\nupper = " + material +
           "\n[contact]\n" + contact;
}

}  // namespace

TEST_CASE("A height above 1 mm, a modulus below 1 kPa and a pressure below 1e-9 of it are likely in another unit") {
    Joint joint = steel_joint();
    const std::vector<double> pressures{1e6, 1e7};
    CHECK(kinds(answer(joint, pressures)).empty());
    joint.face.rms_height = 0.8;
    const Answer tall = answer(joint, pressures);
    CHECK(kinds(tall) == std::set{Concern::height_unit});
    CHECK(tall.concerns.front().greatest == 0.8);
    CHECK(tall.doubtful);
    joint.face.rms_height = 0.999e-3;
    CHECK(kinds(answer(joint, pressures)).empty());

    joint = steel_joint();
    const Answer light = answer(joint, std::vector{1.0, 10.0});  // MPa
    CHECK(kinds(light) == std::set{Concern::pressure_unit});
    CHECK(light.doubtful);
    CHECK(light.concerns.front().violations == 2);
    const Answer from_light = answer(joint, std::vector{10.0, 1e7});
    CHECK(kinds(from_light) == std::set{Concern::pressure_unit});
    CHECK(from_light.concerns.front().first == 0);
    CHECK_FALSE(from_light.doubtful);  // a curve that begins at a light load

    joint.upper.elastic.youngs_modulus = 205;  // GPa
    const Answer soft = answer(joint, pressures);
    CHECK(kinds(soft).count(Concern::modulus_unit) == 1);
    CHECK(soft.doubtful);
    CHECK(contains(soft.points.front().reason, "modulus 205 Pa is below 1 kPa: a unit is likely wrong"));
    joint = steel_joint();
    joint.effective_modulus = 999;
    CHECK(kinds(answer(joint, std::vector{1.0})).count(Concern::modulus_unit) == 1);
    CHECK(name_of(Concern::height_unit) == "height_unit");
    CHECK(name_of(Concern::modulus_unit) == "modulus_unit");
    CHECK(name_of(Concern::pressure_unit) == "pressure_unit");
}

TEST_CASE("A scene warns of the same numbers, and is doubtful") {
    const std::string steel = "\"steel\"", load = "pressures = [\"10 MPa\"]\n";
    const auto results = [](const std::string& text) { return test::results_of(text); };
    const auto fine = results(scene_of("0.8 um", steel, load));
    CHECK_FALSE(contains(test::joined(fine.warnings), "unit"));
    for (const std::string laws : {"", "laws = [\"hybrid\"]\n"}) {
        const auto tall = results(scene_of("0.8 m", steel, load + laws));
        CHECK(contains(test::joined(tall.warnings), "rms height 0.8 m is above 1 mm: a unit is likely wrong"));
        CHECK(tall.doubtful);
        const auto light = results(scene_of("0.8 um", steel, "pressures = [\"10 Pa\", \"20 Pa\"]\n" + laws));
        CHECK(contains(test::joined(light.warnings),
                       "pressure 10 Pa is below 1e-9 of the effective modulus, 115 Pa: a unit is likely wrong"));
        CHECK(light.doubtful);
    }
    const std::string soft = scene_of("0.8 um", "{ youngs_modulus = \"205 Pa\", poisson_ratio = 0.3 }", load);
    CHECK(
        contains(test::refusal([&] { (void)results(soft); }), "modulus 205 Pa is below 1 kPa: a unit is likely wrong"));
}

TEST_CASE("A point without a stiffness has no number and no law") {
    Joint joint = steel_joint();
    joint.upper.hardness = joint.lower.hardness = 2e7;
    const Answer found = answer(joint, std::vector{1e6, 3e7}, {.laws = {laws::plastic}});
    REQUIRE(found.points.size() == 2);
    CHECK(found.points[0].law == LawKind::plastic);
    for (const AnswerPoint& lost : {found.points[1], found.laws.front().points[1], AnswerPoint()}) {
        CHECK(std::isnan(lost.stiffness.low));
        CHECK(std::isnan(lost.stiffness.value));
        CHECK(std::isnan(lost.stiffness.high));
        CHECK(lost.law == LawKind::none);
        CHECK(name_of(lost.law).empty());
    }
    CHECK(found.points[1].reason == "3e+07 Pa is above the hardness (2e+07 Pa): the contact is closed");
    CHECK(answer(joint, std::vector{1e6, 2e7}).points[1].reason ==
          "2e+07 Pa reaches the hardness (2e+07 Pa): the contact is closed");
    CHECK(test::refusal([&] {
              (void)answer(joint, std::vector{1e6}, {.laws = {ChosenLaw()}});
          }).starts_with("law: must be one of fractal"));
}

TEST_CASE("A refusal names the body or the face, and its member") {
    const auto refused = [](const auto& change) {
        Joint joint = steel_joint();
        joint.other = joint.face;
        change(joint);
        return test::refusal([&] { (void)answer(joint, std::vector{1e7}); });
    };
    CHECK(refused([](Joint& of) { of.lower = {}; }) == "lower.youngs_modulus = 0: must be finite and greater than 0");
    CHECK(refused([](Joint& of) { of.upper.elastic.youngs_modulus = -1; }).starts_with("upper.youngs_modulus = -1"));
    CHECK(refused([](Joint& of) { of.lower.elastic.poisson_ratio = 0.6; }).starts_with("lower.poisson_ratio = 0.6"));
    CHECK(refused([](Joint& of) { of.upper.yield_strength = 0; }).starts_with("upper.yield_strength = 0"));
    CHECK(refused([](Joint& of) { of.lower.hardness = -2; }).starts_with("lower.hardness = -2"));
    CHECK(refused([](Joint& of) {
              of.lower.hardness.reset(), of.lower.hardness_range = PriorRange{3, 2, 1};
          }).starts_with("lower.hardness_range = 2"));
    CHECK(refused([](Joint& of) {
              of.effective_modulus = 1e11, of.upper.elastic.poisson_ratio = 0.7;
          }).starts_with("upper.poisson_ratio = 0.7"));
    CHECK(refused([](Joint& of) { of.other->rms_height = -1; }).starts_with("other.rms_height = -1"));
    CHECK(refused([](Joint& of) { of.other->rms_height.reset(); }).starts_with("other.rms_height: is missing"));
    CHECK(refused([](Joint& of) {
              of.other->skewness = 0;
          }).starts_with("other.kurtosis: is missing; skewness and kurtosis belong together"));
    CHECK(refused([](Joint& of) { of.face.rms_gradient = 0; }).starts_with("rms_gradient = 0"));
}

TEST_CASE("What an answer assumes is listed where other laws are named") {
    const std::string text = scene_of("0.8 um", "\"steel\"", "pressures = [\"10 MPa\"]\n");
    const auto best = scene::read_scene(text, {.name = "x.toml"});
    const auto sorted = [](std::vector<std::string> all) {
        std::sort(all.begin(), all.end());
        return all;
    };
    const auto results_of_best = actions::compute(best);
    const auto wanted = sorted(actions::assumptions_of(results_of_best));
    REQUIRE(wanted.size() >= 5);
    for (const char* law : {"hertz", "hybrid", "proportional", "plastic"}) {
        const auto read = scene::read_scene(text + "laws = [\"" + std::string(law) + "\"]\n", {.name = "x.toml"});
        const auto results = actions::compute(read);
        INFO(law);
        CHECK(sorted(actions::assumptions_of(results)) == wanted);
        const auto json = test::parsed(actions::run_document(results));
        CHECK(sorted(json["assumptions"].get<std::vector<std::string>>()) == wanted);
        const std::string shown = actions::document_of(results).text();
        for (const char* part : {"hardness 2.6 GPa (1.2 GPa to 9.5 GPa)", "Hurst", "skewness", "kurtosis"})
            CHECK(contains(shown, part));
    }
}

TEST_CASE("What follows from K of the answer comes first, in tables and in the JSON, next to named laws") {
    const std::string text =
        scene_of("0.8 um", "{ name = \"steel\", hardness = \"2 GPa\", electrical_conductivity = \"5e6 S/m\" }",
                 "pressures = [\"10 MPa\", \"100 MPa\"]\n");
    const std::string more =
        "[ultrasound]\nfrequency = \"5 MHz\"\n[friction]\ncoefficient = 0.2\namplitude = \"10 nm\"\n[gap]\n"
        "conductivity = \"0.026 W/(m K)\"\n";
    const auto best = scene::read_scene(text + more, {.name = "x.toml"});
    const auto json_of = [](const scene::Scene& scene) {
        return test::parsed(actions::run_document(actions::compute(scene)));
    };
    const auto wanted = json_of(best)["answer"];
    const auto read = scene::read_scene(text + "laws = [\"hertz\", \"hybrid\"]\n" + more, {.name = "x.toml"});
    const auto found = json_of(read)["answer"];
    for (const char* key :
         {"reflection", "reflection_p05", "reflection_p95", "shear_reflection", "tangential_stiffness_Pa_per_m",
          "loss_factor", "thermal_conductance_W_per_m2K", "electrical_conductance_S_per_m2"})
        for (std::size_t i = 0; i < 2; ++i) {
            CAPTURE(key, i);
            REQUIRE(wanted[i].contains(key));
            CHECK(found[i][key] == wanted[i][key]);
        }
    const auto results = actions::compute(read);
    const std::string shown = actions::document_of(results).text(), full = actions::document_of(results, true).text();
    for (const char* table : {"\n  |R|, ", "\n  shear |R|", "\n  Kt/A0 [", "\n  loss factor", "\n  h ["}) {
        const std::size_t at = shown.find(table);
        INFO(table << shown);
        REQUIRE(at != std::string::npos);
        const std::size_t line = shown.find('\n', at + 1) + 1;
        CHECK(shown.substr(line).starts_with("  answer: plastic "));
        CHECK(contains(shown.substr(line, 700), "\n  hertz"));
    }
    CHECK(full.find("\nanswer: plastic\n") < full.find("\nhertz"));
}

}  // namespace likely_units_test
