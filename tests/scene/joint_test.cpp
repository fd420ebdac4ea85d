// SPDX-License-Identifier: BSD-3-Clause
// The answer of a joint in the library. Truth: the answer of the scene of the same joint, which reads its own text.
#include <fstiff/answer.hpp>

#include "support/library.hpp"

#include <fstiff/asperity/named_materials.hpp>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace joint_test {

using namespace fstiff;

namespace {

const std::vector<double> pressures{1e5, 1e7, 3e8};
const std::string contact_of_text =
    "[contact]\npressures = [\"0.1 MPa\", \"10 MPa\", \"300 MPa\"]\nseating = \"1 kPa\"\n";
const std::string steel_on_iron = "[material]\nupper = \"steel\"\nlower = \"cast_iron\"\n";

Body body(const char* name) { return {.elastic = parts::find_material(name)->elastic}; }

/// \p found has every number of the answer of \p scene, to the last digit.
void require_same(const Answer& found, const scene::Scene& scene) {
    const scene::Results results = compute(scene);
    REQUIRE(results.answer);
    const scene::StiffnessAnswer& answer = *results.answer;
    REQUIRE(found.points.size() == scene.points.size());
    for (std::size_t place = 0; place < found.points.size(); ++place) {
        const AnswerPoint& point = found.points[place];
        const auto at = answer.curve.state_at(place);
        REQUIRE(point.ok() == at.has_value());
        if (!at) continue;
        CAPTURE(place);
        CHECK(point.stiffness.value == answer.curve.states[*at].stiffness.value);
        CHECK(point.stiffness.low == answer.curve.band[*at].low);
        CHECK(point.stiffness.high == answer.curve.band[*at].high);
        CHECK(point.law == answer.curve.law_at(*at).which);
        CHECK(point.p_star == answer.reasons[*at].p_star);
        CHECK(point.contacts == answer.reasons[*at].contacts);
        CHECK(point.loading_stiffness == answer.reasons[*at].loading_stiffness);
        CHECK(parts::shares_of(point.causes) == parts::shares_of(answer.reasons[*at].causes));
    }
    CHECK(found.flows == answer.flows);
    CHECK(found.of_map_itself == answer.of_map_itself);
    CHECK(found.relative_hardness == answer.relative_hardness);
}

scene::Scene read(const std::string& text, const std::string& name = "s.toml") {
    return scene::read_scene(text, {.name = name});
}

}  // namespace

TEST_CASE("The answer of a joint of numbers is that of its scene") {
    struct Case {
        std::string surface;
        JointFace face;
    };
    const std::vector<Case> cases{
        {"rms_height = \"0.8 um\"\nrms_gradient = 0.1\nalpha = 10\n",
         {.rms_height = 0.8e-6, .rms_gradient = 0.1, .alpha = 10}},
        {"rms_height = \"0.8 um\"\n", {.rms_height = 0.8e-6}},
        {"Ra = \"1.6 um\"\nprocess = \"turned\"\n", {.mean_height = 1.6e-6, .process = parts::Process::turned}},
        {"rms_height = \"0.8 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n",
         {.rms_height = 0.8e-6, .peak_radius = 40e-6, .peak_density = 500e6}},
        {"rms_height = \"0.8 um\"\nrms_gradient = 0.2\nhurst = 0.6\nskewness = -1\nkurtosis = 4.5\n",
         {.rms_height = 0.8e-6, .rms_gradient = 0.2, .hurst = 0.6, .skewness = -1, .kurtosis = 4.5}},
        {"rms_height = \"0.8 um\"\nrms_gradient = 0.2\nfractal_dimension = 1.3\nerrors = { rms_height = \"0.1 um\", "
         "rms_gradient = 0.02 }\n",
         {.rms_height = 0.8e-6,
          .rms_gradient = 0.2,
          .fractal_dimension = 1.3,
          .rms_height_error = 0.1e-6,
          .rms_gradient_error = 0.02}}};
    for (const Case& one : cases) {
        CAPTURE(one.surface);
        const Joint elastic{.face = one.face, .upper = body("steel"), .lower = body("cast_iron")};
        require_same(answer(elastic, pressures), read("[surface]\n" + one.surface + steel_on_iron + contact_of_text));
        Joint soft = elastic;
        soft.upper.hardness = 2e9, soft.lower.yield_strength = 0.3e9, soft.nominal_area = 1e-4;
        require_same(answer(soft, pressures),
                     read("[surface]\n" + one.surface + "[material.upper]\nname = \"steel\"\nhardness = \"2 GPa\"\n" +
                          "[material.lower]\nname = \"cast_iron\"\nyield_strength = \"300 MPa\"\n" + contact_of_text +
                          "nominal_area = \"1 cm^2\"\n"));
    }
}

TEST_CASE("The answer of a joint of a trace, of a map and of two faces is that of its scene") {
    const test::Folder folder;
    const auto measured = [&](const std::string& name, const std::string& text) {
        const auto input = scene::read_surface_input(test::surface_options("", folder.write(name, text)));
        const auto find = [](const auto& heights) { return measure(heights); };
        return std::make_shared<const Surface<double>>(std::visit(find, input.surface.data));
    };
    const auto trace = measured(
        "trace.txt",
        test::profile_text(4096, 0.5e-6, {.hurst = 0.4, .rms = 0.3e-6, .longest_wavelength = 90e-6, .seed = 3}));
    const SelfAffineOptions<double> rough{.hurst = 0.8, .rms = 0.2e-6, .longest_wavelength = 20e-6, .seed = 3};
    const auto map = measured("map.txt", test::map_text(64, 0.5e-6, rough));
    const auto scene_of = [&](const std::string& surface, const std::string& more = "") {
        return read(surface + steel_on_iron + contact_of_text + more, folder / "s.toml");
    };
    Joint joint{.face = {.measured = trace}, .upper = body("steel"), .lower = body("cast_iron")};
    require_same(answer(joint, pressures), scene_of("[surface]\nfrom = \"trace.txt\"\n"));
    joint.nominal_area = 1e-4;
    joint.face.rms_gradient = 0.3;  // in place of what was measured
    require_same(answer(joint, pressures),
                 scene_of("[surface]\nfrom = \"trace.txt\"\nrms_gradient = 0.3\n", "nominal_area = \"1 cm^2\"\n"));
    joint.face = {.measured = map};
    require_same(answer(joint, pressures), scene_of("[surface]\nfrom = \"map.txt\"\n", "nominal_area = \"1 cm^2\"\n"));
    joint.other = JointFace{.rms_height = 0.1e-6, .rms_gradient = 0.05};
    require_same(
        answer(joint, pressures),
        scene_of("[surface.upper]\nfrom = \"map.txt\"\n[surface.lower]\nrms_height = \"0.1 um\"\nrms_gradient = "
                 "0.05\n",
                 "nominal_area = \"1 cm^2\"\n"));
}

TEST_CASE("A contact by the name of its law has K of the answer, and keeps what it is made of") {
    Joint joint{.face = {.rms_height = 0.8e-6, .rms_gradient = 0.1}, .upper = body("steel"), .lower = body("steel")};
    joint.upper.hardness = 1e9;
    const Answer found = answer(joint, pressures);
    const std::shared_ptr<const AnyContact> contact = contact_of(joint, LawName::plastic);
    joint = {};
    for (const AnswerPoint& point : found.points) {
        REQUIRE(point.law == LawName::plastic);
        const double p = point.pressure;
        CHECK(contact->at_pressures(std::span(&p, 1), Quantity::stiffness).front().state.stiffness.value ==
              point.stiffness.value);
    }
    CHECK(found.assumed.size() == 4);  // alpha, H, skewness, kurtosis
}

TEST_CASE("A joint out of range is refused by the name of its member") {
    const Joint joint{
        .face = {.rms_height = 0.8e-6, .rms_gradient = 0.1}, .upper = body("steel"), .lower = body("steel")};
    const auto refused = [&](const auto& change, std::vector<double> at = pressures) {
        Joint other = joint;
        change(other);
        return test::refusal([&] { (void)answer(other, at); });
    };
    CHECK(refused([](Joint& of) { of.face.rms_height.reset(); }).starts_with("rms_height: is missing"));
    CHECK(refused([](Joint& of) {
              of.face.rms_height = -1;
          }).starts_with("rms_height = -1: must be finite and greater than 0"));
    CHECK(refused([](Joint& of) { of.face.rms_gradient = std::nan(""); }).starts_with("rms_gradient = nan"));
    CHECK(refused([](Joint& of) {
              of.face.alpha = 1.5;
          }).starts_with("alpha = 1.5: must be finite and greater than 1.5"));
    CHECK(refused([](Joint& of) { of.face.skewness = 0; }).starts_with("skewness: must be given with kurtosis"));
    CHECK(refused([](Joint& of) { of.face.hurst = 1.5; }) == "hurst = 1.5: must be greater than 0 and at most 1");
    CHECK(refused([](Joint& of) { of.face.skewness = 0, of.face.kurtosis = 0.5; }).find("kurtosis") !=
          std::string::npos);
    CHECK(refused([](Joint& of) { of.nominal_area = 0; }).starts_with("nominal_area = 0"));
    CHECK(refused([](Joint& of) { of.lower.hardness = -2; }).starts_with("hardness = -2"));
    CHECK(refused([](Joint& of) { of.upper.elastic.poisson_ratio = 0.7; }).starts_with("poisson_ratio = 0.7"));
    CHECK(refused([](Joint&) {}, {1e6, 0.0}).starts_with("pressure = 0: must be finite and greater than 0"));
    CHECK(answer(joint, std::vector<double>{}).points.empty());
    CHECK(test::refusal([&] { (void)contact_of(joint, LawName::boundary_elements); }) ==
          "law boundary_elements: needs a measured map");
    CHECK(test::refusal([&] { (void)contact_of(joint, LawName::fractal); }) == "law fractal: needs fractal_dimension");
    Joint soft = joint;
    soft.upper.hardness = 20e6;
    const Answer closed = answer(soft, pressures);
    CHECK(closed.points[0].ok());
    CHECK_FALSE(closed.points[2].ok());
    CHECK(closed.points[2].reason.starts_with("at the hardness, 2e+07 Pa"));
}

}  // namespace joint_test
