// SPDX-License-Identifier: BSD-3-Clause
// Numbers of fstiff_joint by their names: every field of the library, and the numbers of C++ to the last digit.
#include <fstiff.h>

#include "support/catch.hpp"

#include <fstiff/answer.hpp>
#include <fstiff/answer/joint_fields.hpp>
#include <fstiff/asperity/named_materials.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace joint_names_test {

using namespace fstiff;

namespace {

/// A joint of C with numbers by their names alone.
struct Named {
    std::vector<std::string> names{"upper.youngs_modulus", "lower.youngs_modulus", "upper.poisson_ratio",
                                   "lower.poisson_ratio"};
    std::vector<double> numbers{210e9, 100e9, 0.3, 0.3};

    void add(std::string name, double number) { names.push_back(std::move(name)), numbers.push_back(number); }
    /// The numbers of \p keys at 10 MPa. \return the status.
    int answer(const std::vector<const char*>& keys, std::vector<double>& found) const {
        fstiff_face face{};
        face.size = sizeof face;
        std::vector<const char*> pointers;
        for (const std::string& name : names) pointers.push_back(name.c_str());
        fstiff_joint joint{};
        joint.size = sizeof joint, joint.face = &face, joint.samples = -1;
        joint.number_count = pointers.size(), joint.names = pointers.data(), joint.numbers = numbers.data();
        found.assign(keys.size(), 0);
        std::vector<double*> to;
        for (double& number : found) to.push_back(&number);
        fstiff_answer_points points{};
        points.size = sizeof points;
        points.key_count = keys.size(), points.keys = keys.data(), points.numbers = to.data();
        const double pressure = 10e6;
        return fstiff_answer(&joint, &pressure, 1, &points, nullptr);
    }
};

/// A number that is allowed.
double allowed_number(const NumberFacts& facts) {
    if (facts.row && facts.row->high.value > 0)
        return static_cast<double>((facts.row->low.value + facts.row->high.value) / 2);
    if (facts.high < 1e300) return (facts.low + 3 * facts.high) / 4;
    return facts.low > 0 ? 2 * facts.low : facts.unit == "1/m^2" ? 1e9 : facts.unit == "m" ? 1e-6 : 0.1;
}

}  // namespace

TEST_CASE("every number of a face, and every word for it, is a name in C", "[c]") {
    const JointFace none;
    each_field(none, [&](std::string_view name, const auto&, const NumberFacts& facts) {
        std::vector<std::string_view> words{name};
        words.insert(words.end(), facts.words.begin(), facts.words.end());
        for (const std::string_view word : words) {
            Named joint;
            joint.add("face." + std::string(word), allowed_number(facts));
            if (name == "skewness") joint.add("face.kurtosis", 90);
            if (name == "kurtosis") joint.add("face.skewness", 0);
            if (name == "r") joint.add("face.theta", 0.7);
            if (name == "theta") joint.add("face.r", 0.5);
            if (facts.error != &JointFace::Errors::height) joint.add("face.rms_height", 1e-6);
            std::vector<double> found;
            INFO(word << ": " << fstiff_last_message());
            CHECK(joint.answer({"stiffness_Pa_per_m"}, found) == FSTIFF_OK);
            CHECK(found[0] > 0);
        }
    });
}

TEST_CASE("waves, conduction, the gap and friction by names give the numbers of C++", "[c]") {
    Named joint;
    for (const auto& [name, number] : {std::pair("face.Ra", 0.8e-6),
                                       {"face.rms_gradient", 0.1},
                                       {"other.rms_height", 0.3e-6},
                                       {"nominal_area", 1e-4},
                                       {"upper.density", 7850.0},
                                       {"lower.density", 7000.0},
                                       {"upper.velocity", 5900.0},
                                       {"lower.velocity", 4600.0},
                                       {"upper.thermal_conductivity", 50.0},
                                       {"lower.thermal_conductivity", 20.0},
                                       {"waves.frequency", 5e6},
                                       {"friction.coefficient", 0.2},
                                       {"friction.amplitude", 1e-8},
                                       {"conduction.thermal_film", 1e-9},
                                       {"conduction.gap.conductivity", 0.03},
                                       {"conduction.gap.temperature_jump", 1e-7},
                                       {"waves.shear.incident", 25e6},
                                       {"waves.shear.beyond", 20e6},
                                       {"upper.hardness", 2e9}})
        joint.add(name, number);
    const std::vector<const char*> keys{"stiffness_Pa_per_m", "reflection", "thermal_conductance_W_per_m2K",
                                        "loss_factor",        "force_N",    "thermal_conductance_gap_W_per_m2K",
                                        "shear_reflection"};
    std::vector<double> found;
    REQUIRE(joint.answer(keys, found) == FSTIFF_OK);

    Joint same{.face = {.mean_height = 0.8e-6, .rms_gradient = 0.1},
               .other = JointFace{.rms_height = 0.3e-6},
               .upper = {.elastic = {210e9, 0.3},
                         .hardness = 2e9,
                         .density = 7850,
                         .velocity = 5900,
                         .thermal_conductivity = 50},
               .lower = {.elastic = {100e9, 0.3}, .density = 7000, .velocity = 4600, .thermal_conductivity = 20},
               .nominal_area = 1e-4,
               .waves = UltrasonicWaves{.frequency = 5e6},
               .friction = Friction{0.2, 1e-8}};
    same.conduction.thermal_film = 1e-9;
    same.conduction.gap = {0.03, 1e-7};
    same.waves->shear = {25e6, 20e6};
    const AnswerPoint point = answer(same, 10e6, {.samples = 0});
    CHECK(found[0] == point.stiffness.value);
    CHECK(found[1] == point["reflection"]);
    CHECK(found[2] == point["thermal_conductance"]);
    CHECK(found[3] == point["loss_factor"]);
    CHECK(found[4] == point["force"]);
    CHECK(found[5] == point["thermal_conductance_gap"]);
    CHECK(found[6] == point["shear_reflection"]);
}

TEST_CASE("a name that no number has is refused, and NaN is not given", "[c]") {
    std::vector<double> found;
    for (const char* wrong : {"face.rms", "alpha", "face", "gap.conductivity", "face.errors.height", ""}) {
        Named joint;
        joint.add("face.rms_height", 1e-6), joint.add(wrong, 1);
        CHECK(joint.answer({"stiffness_Pa_per_m"}, found) == FSTIFF_REFUSED);
        CHECK(std::string(fstiff_last_message()).starts_with("names: \"" + std::string(wrong) + "\" must be the name"));
    }
    Named joint;
    joint.add("face.rms_height", 1e-6), joint.add("face.alpha", std::numeric_limits<double>::quiet_NaN());
    CHECK(joint.answer({"stiffness_Pa_per_m"}, found) == FSTIFF_OK);
    joint.add("face.hurst", 7);
    CHECK(joint.answer({"stiffness_Pa_per_m"}, found) == FSTIFF_REFUSED);
    CHECK(std::string(fstiff_last_message()) == "hurst = 7: must be greater than 0 and at most 1");
}

}  // namespace joint_names_test
