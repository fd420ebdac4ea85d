// SPDX-License-Identifier: BSD-3-Clause
// A map next to which numbers are written: what K is computed from.
#include "support/library.hpp"

#include <fstiff/answer/answer.hpp>

#include <cmath>
#include <memory>
#include <string>

namespace map_with_keys_test {

namespace {

using fstiff::HeightMap;

const HeightMap<double>& map() {
    static const auto made = fstiff::self_affine_map<double>(
        {.hurst = 0.8, .rms = 0.3e-6, .longest_wavelength = 30e-6, .seed = 5}, 64, 64, 1e-6, 1e-6);
    return made;
}

std::string text_of(const HeightMap<double>& map) {
    std::ostringstream text;
    text.precision(17);
    for (Eigen::Index j = 0; j < map.rows(); ++j)
        for (Eigen::Index i = 0; i < map.columns(); ++i)
            text << map.heights(j, i) << (i + 1 < map.columns() ? '\t' : '\n');
    return text.str();
}

const std::string contact = "[material]\nupper = \"steel\"\n[contact]\npressures = [\"200 MPa\"]\n";

/// The folder of the map, and results of it with further keys of [surface].
struct Scenes {
    test::Folder folder;
    std::string file = folder.write("map.txt", text_of(map()));
    [[nodiscard]] fstiff::actions::Answered with(const std::string& keys) const {
        return test::results_of(
            "[surface]\nfrom = \"map.txt\"\nunits = \"m\"\ndx = \"1 um\"\ndy = \"1 um\"\nmeasured = \"whole\"\n" +
                keys + contact,
            folder / "scene.toml");
    }
};

std::string joined(const fstiff::actions::Answered& results) {
    std::string text;
    for (const std::string& sentence : results.explanation) text += sentence + "\n";
    return text;
}

}  // namespace

TEST_CASE("A number that only laws of numbers take leaves a map a map") {
    const Scenes scenes;
    const auto alone = scenes.with("");
    const auto& K = alone.answer;
    REQUIRE(K.points.front().law == fstiff::LawKind::boundary_elements);
    for (const std::string key :
         {"hurst = 0.8", "alpha = 12", "peak_radius = \"10 um\"", "peak_density = \"20000 /mm^2\"",
          "fractal_dimension = 1.3", "r = 0.4\ntheta = \"40 deg\"", "errors = { peak_radius = \"1 um\" }"}) {
        const auto with = scenes.with(key + "\n");
        CAPTURE(key);
        CHECK(with.answer.points.front().law == fstiff::LawKind::boundary_elements);
        CHECK(with.answer.points.front().state.stiffness.value == K.points.front().state.stiffness.value);
        CHECK(with.answer.points.front().stiffness.low == K.points.front().stiffness.low);
        CHECK(with.answer.points.front().stiffness.high == K.points.front().stiffness.high);
        CHECK(joined(with).find("not from the heights") == std::string::npos);
    }
}

TEST_CASE("A number that a map has itself sets it aside, and the output names it") {
    const Scenes scenes;
    for (const auto& [key, name] : {std::pair("rms_height = \"0.3 um\"", "because rms_height is given"),
                                    {"rms_gradient = 0.1", "because rms_gradient is given"},
                                    {"skewness = 0\nkurtosis = 3", "because skewness is given"},
                                    {"Sk = \"0.7 um\"\nSpk = \"0.2 um\"\nSvk = \"0.3 um\"\nSmr1 = 0.1\nSmr2 = 0.9",
                                     "because a bearing curve is given"}}) {
        const auto with = scenes.with(std::string(key) + "\n");
        CAPTURE(key, joined(with));
        CHECK(with.answer.points.front().law == fstiff::LawKind::plastic);
        CHECK(joined(with).find(name) != std::string::npos);
    }
}

TEST_CASE("The numbers of a map have the gradient of all its waves, from its document too") {
    const Scenes scenes;
    const double gradient = fstiff::height_statistics(map()).rms_gradient.value;
    const auto alone = scenes.with("");
    const auto aside = scenes.with("skewness = 0\nkurtosis = 3\n");
    // lambda_s takes a part of the gradient of a map this coarse away
    const auto document = test::measured_files("--units m --dx 1um --dy 1um", {scenes.file});
    CHECK(document["surface"]["rms_gradient"]["value"].get<double>() < 0.9 * gradient);
    CHECK(std::abs(document["all_waves"]["rms_gradient"]["value"].get<double>() / gradient - 1) < 0.01);
    // the map in its contact has no plane, and its spectrum is that of the mirrored map
    CHECK(std::abs(*aside.answer.rms_gradient / gradient - 1) < 0.01);
    CHECK(std::abs(*alone.answer.rms_gradient / gradient - 1) < 0.1);
    scenes.folder.write("map.json", document.dump());
    const auto of_document = test::results_of("[surface]\nfrom = \"map.json\"\nskewness = 0\nkurtosis = 3\n" + contact,
                                              scenes.folder / "scene.toml");
    const auto &a = aside.answer, &b = of_document.answer;
    CHECK(std::abs(b.points.front().state.stiffness.value / a.points.front().state.stiffness.value - 1) < 1e-12);
    CHECK(joined(of_document).find("give the file of the map") != std::string::npos);
}

TEST_CASE("A measured map keeps its K in C++ next to numbers that it does not take") {
    using namespace fstiff;
    const auto measured = measured_face(measure(map()));
    const Body steel = body_of(*find_material("C45"));
    Joint joint{.face = {.measured = measured}, .upper = steel, .lower = steel};
    const double K = answer(joint, std::array{2e8}).points[0].stiffness.value;
    joint.face.hurst = 0.5, joint.face.alpha = 30;
    CHECK(answer(joint, std::array{2e8}).points[0].stiffness.value == K);
    joint.face.rms_height = 0.3e-6;
    CHECK(answer(joint, std::array{2e8}).points[0].stiffness.value != K);
}

}  // namespace map_with_keys_test
