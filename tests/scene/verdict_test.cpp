// SPDX-License-Identifier: BSD-3-Clause
// The sentences of the verdict: what they advise can be done, and no side is taken from a number that is zero.
#include "scene/verdict.hpp"

#include "cli/command.hpp"

#include <fstiff/core/text.hpp>
#include <fstiff/io/write.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/validity/law_findings.hpp>

#include "support/accuracy.hpp"
#include "support/half_space_maps.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <vector>

namespace verdict_test {

namespace scene = fstiff::scene;
using test::contains;

namespace {

scene::Scene read(const std::string& text) { return scene::read_scene(text, {.name = "s.toml"}); }

/// All sentences of the verdict.
std::string verdict_of(const scene::Scene& of) {
    std::string all;
    for (const std::string& sentence : scene::compute(of).verdict) all += sentence + "\n";
    return all;
}

/// A scene of numbers at \p pressures, whose yield strength is high.
std::string scene_of(const std::string& surface, const std::string& pressures) {
    return "[surface]\n" + surface +
           "\n[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0\n[contact]\npressures = [" + pressures +
           "]\nlaws = [\"hertz\"]\npeaks = [{ theta = 1.0, r = 0.5 }]\n";
}
const std::string moments = "rms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 8\nhurst = 0.7";

/// The verdict of heights of \p skewness and \p kurtosis with their standard errors.
std::string of_heights(fstiff::Measurement<double> skewness, fstiff::Measurement<double> kurtosis) {
    scene::Scene one = read(scene_of(moments, "\"10 MPa\""));
    one.face.heights = fstiff::HeightStatistics<double>{skewness, kurtosis, {0.1, 0.01}, {}};
    return verdict_of(one);
}

}  // namespace

TEST_CASE("The verdict advises no law that the scene cannot have") {
    scene::Scene builtin = scene::read_scene(scene::builtin_scene, {.name = "built-in scene"});
    const std::string sentences = verdict_of(builtin);
    CHECK_FALSE(contains(sentences, "add \"hybrid\""));
    CHECK(contains(sentences, "hybrid needs a spectrum"));
    CHECK(contains(sentences, "must be told surface.rms_gradient and surface.alpha"));
    // what it advises can be added
    for (std::size_t at = 0; (at = sentences.find("(add \"", at)) != std::string::npos; ++at) {
        const std::string name = sentences.substr(at + 6, sentences.find('"', at + 6) - at - 6);
        INFO(name);
        const scene::Law* law = scene::find_law(name);
        REQUIRE(law);
        CHECK(scene::refusal_of(*law, builtin).empty());
        scene::Scene added = builtin;
        added.laws = {law};
        CHECK_NOTHROW(scene::compute(added));
    }
    CHECK(contains(verdict_of(read(scene_of(moments, "\"10 MPa\""))), "believe hybrid (add \"hybrid\""));
}

TEST_CASE("The side of the error is not taken from a skewness that is zero within two standard errors") {
    const std::string large = "too large, 1.05 to 1.9 times", small = "too small, 0.3 to 0.9";
    CHECK(contains(of_heights({0.5, 0.1}, {3, 0.2}), large));
    CHECK(contains(of_heights({-0.5, 0.1}, {3, 0.2}), small));
    for (const double sign : {-1.0, 1.0}) {
        CHECK_FALSE(contains(of_heights({sign * 0.34, 0.17}, {3, 0.2}), "not Gaussian"));
        // a sawtooth: a kurtosis of 1.8, a skewness of rounding
        const std::string even = of_heights({sign * 8e-18, 0.01}, {1.8, 0.02});
        CHECK(contains(even, "the heights are not Gaussian"));
        CHECK(contains(even, "leaves open to which side"));
        CHECK_FALSE(contains(even, large));
        CHECK_FALSE(contains(even, small));
        CHECK_FALSE(contains(of_heights({sign * 1.4, 0.8}, {6, 2}), "far from Gaussian"));
        CHECK(contains(of_heights({sign * 1.4, 0.3}, {6, 2}), "far from Gaussian"));
    }
}

TEST_CASE("The accuracy of hybrid is one number, that of docs/validation.md") {
    const std::string percent = std::to_string(fstiff::parts::hybrid_accuracy_percent) + " %";
    std::ifstream table(FSTIFF_SCENES "/../bench/map_validation.csv");
    int points = 0, within = 0;
    for (std::string line; std::getline(table, line);) {
        if (!line.starts_with("hybrid,")) continue;
        ++points;
        within +=
            std::abs(std::stod(line.substr(line.rfind(',') + 1)) - 1) <= fstiff::parts::hybrid_accuracy_percent / 100.0;
    }
    CHECK(points == 750);
    CHECK(within >= 0.96 * points);
    // E = 100 GPa, g = 0.1: p* is p over 10 GPa
    CHECK(contains(verdict_of(read(scene_of(moments, "\"30 MPa\", \"1 GPa\""))), "to about " + percent));
    for (const char* document : {"README.md", "docs/validation.md"})
        CHECK(contains(test::read(FSTIFF_SCENES "/../" + std::string(document)), "within " + percent));
    CHECK(contains(verdict_of(read(scene_of(moments, "\"15 MPa\""))), "to about a quarter\n"));
    const std::string above = verdict_of(read(scene_of(moments, "\"3 GPa\"")));
    CHECK(contains(above, "above p* = 0.25 hybrid and persson alone were compared, within 15 % up to 0.75"));
    CHECK_FALSE(contains(above, "believe hybrid"));
}

TEST_CASE("Counts of contacts are whole numbers") {
    for (const auto& [area, words] :
         {std::pair{"1e-3 mm^2", "less than one contact is expected"}, std::pair{"5 mm^2", " contacts are expected"}}) {
        const std::string text = verdict_of(
            read(scene_of(moments, "\"1 MPa\"") + "nominal_area = \"" + std::string(area) + "\"\n"));
        INFO(text);
        CHECK((contains(text, words) || !contains(text, "as few as")));
        CHECK_FALSE(contains(text, "e+"));
    }
}

TEST_CASE("Where points are missing, the way to fill them is named, and hybrid is not advised") {
    fstiff::HeightMap<double> map = test::half_space_map("gaussian");
    map.heights = (1e-4 * map.heights.topLeftCorner(64, 64)).eval();
    map.dx = map.dy = 1e-4 / 256;
    map.heights(20, 30) = std::numeric_limits<double>::quiet_NaN();
    const test::Folder folder;
    std::ofstream file(folder / "map.csv");
    fstiff::io::write_csv(file, map);
    file.close();
    const std::string from = "from = \"" + folder / "map.csv" + "\"\nlambda_s = \"none\"\n";
    const auto with = [&](const std::string& keys, const std::string& laws) {
        return test::replaced(scene_of(from + keys, "\"10 MPa\""), "laws = [\"hertz\"]", laws);
    };
    const scene::Scene holes = read(with("", ""));
    std::string warnings;
    for (const std::string& line : holes.warnings) warnings += line + "\n";
    CHECK(contains(warnings, "law hybrid is not computed: 1 point of the map is missing; fill = true"));
    const std::string sentences = verdict_of(holes);
    CHECK_FALSE(contains(sentences, "add \"hybrid\""));
    CHECK_FALSE(contains(sentences, "add \"boundary_elements\""));
    CHECK(contains(test::refusal([&] { (void)read(with("", "laws = [\"boundary_elements\"]")); }), "fill = true"));
    CHECK(read(with("fill = true\n", "")).laws.front()->name == "hybrid");
}

TEST_CASE("A profile across grooves is told to be no measure of K, and its band reaches 20 times as high") {
    const test::Folder folder;
    fstiff::SelfAffineOptions<double> rough;
    rough.hurst = 0.7, rough.rms = 0.12e-6, rough.longest_wavelength = 60e-6, rough.shortest_wavelength = 16e-6;
    fstiff::Profile<double> profile = fstiff::self_affine_profile(rough, 1024, 4e-6);
    const auto scene_of_profile = [&](const char* name) {
        std::string rows;
        for (std::size_t i = 0; i < profile.size(); ++i)
            rows += fstiff::parts::shortest_text(double(i) * 4) + "," +
                    fstiff::parts::shortest_text(profile.heights[i] * 1e6) + "\n";
        folder.write(std::string(name) + ".csv", rows);
        return read("[surface]\nfrom = \"" + folder / name + ".csv\"\nunits = \"um\"\n[material.upper]\n"
                    "youngs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n[contact]\npressures = [\"10 MPa\"]\n"
                    "laws = [\"hertz\"]\n[uncertainty]\nsamples = 40\n");
    };
    const std::string isotropic = verdict_of(scene_of_profile("isotropic"));
    CHECK_FALSE(contains(isotropic, "lay"));
    const auto advice_of = [](const fstiff::Profile<double>& of) {  // that of a C++ program
        return fstiff::recommended_law(fstiff::measure(of), 205e9 / 0.91 / 2, std::vector{10e6});
    };
    REQUIRE(advice_of(profile).law);
    CHECK(contains(isotropic, "believe " + std::string(name_of(*advice_of(profile).law))));
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const double x = std::remainder(double(i) * 4, 256);
        profile.heights[i] += x * x / 1600 * 1e-6;
    }
    CHECK_FALSE(advice_of(profile).law);
    CHECK(advice_of(profile).findings.front().finding == fstiff::Finding::profile_with_lay);
    scene::Scene turned = scene_of_profile("turned");
    CHECK(turned.has_lay);
    const scene::Results with = scene::compute(turned);
    CHECK(with.doubtful);
    REQUIRE_FALSE(with.verdict.empty());
    CHECK(contains(with.verdict.front(), "its face has a lay: it cannot tell K"));
    for (const std::string& sentence : with.verdict) CHECK_FALSE(contains(sentence, "too large"));
    CHECK(with.short_verdict == std::vector<std::string>{"A profile of a face with a lay cannot tell K: measure a map."});
    turned.has_lay = false;
    const scene::Results without = scene::compute(turned);
    CHECK(test::relative_error(with.curves[0].band[0].high, 20 * without.curves[0].band[0].high) < 1e-14);
    CHECK(with.curves[0].band[0].low == without.curves[0].band[0].low);
}

}  // namespace verdict_test
