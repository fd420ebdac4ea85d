// SPDX-License-Identifier: BSD-3-Clause
// A hardness that is not given is a number that is not known; K of a map is that of all its waves. Truth: the answers
// for hardnesses that are given; boundary elements of the map itself.
#include "actions/answered.hpp"
#include "actions/explanation.hpp"

#include "support/library.hpp"

#include <fstiff/answer.hpp>
#include <fstiff/halfspace/solve_half_space.hpp>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace hardness_test {

using namespace fstiff;
using test::contains;

namespace {

const std::string ground =
    "[surface]\nrms_height = \"1 um\"\nrms_gradient = 0.15\nalpha = 8\nhurst = 0.8\nskewness = 0\nkurtosis = 3\n";
const std::string loads = "[contact]\npressures = [\"5 MPa\", \"50 MPa\", \"300 MPa\"]\n";

std::string on(const std::string& upper, const std::string& lower = "") {
    return ground + "[material]\nupper = " + upper + "\n" + (lower.empty() ? "" : "lower = " + lower + "\n") + loads;
}
std::string with(const std::string& name, const std::string& hardness) {
    return "{ name = \"" + name + "\", hardness = \"" + hardness + "\" }";
}

struct Point {
    double low, value, high;
};
std::vector<Point> points_of(const actions::Answered& results) {
    std::vector<Point> all;
    for (std::size_t i = 0; i < results.answer.points.size(); ++i) {
        const auto& band = results.answer.points[i].stiffness;
        all.push_back({band.low, results.answer.points[i].state.stiffness.value, band.high});
    }
    return all;
}
std::vector<Point> points_of(const std::string& text) { return points_of(test::results_of(text)); }

}  // namespace

TEST_CASE("K of a steel whose hardness is not given has a band that holds K of every steel") {
    const auto open = points_of(on("\"steel\""));
    for (const char* hardness : {"1.3 GPa", "2 GPa", "3 GPa", "5 GPa", "7 GPa"}) {
        const auto named = points_of(on(with("steel", hardness)));
        for (std::size_t i = 0; i < open.size(); ++i) {
            INFO(hardness << " " << i);
            CHECK(open[i].low < named[i].value);
            CHECK(named[i].value < open[i].high);
            CHECK(named[i].high / named[i].low < open[i].high / open[i].low);
        }
    }
    const auto alloy = points_of(on("\"42CrMo4\""));
    CHECK(alloy[1].high / alloy[1].low < open[1].high / open[1].low);
}

TEST_CASE("A hardness that is not given is a cause of the band, an assumption, and what to measure next") {
    const scene::Scene of = test::scene_of(on("\"steel\""));
    const actions::Answered results = actions::compute(of);
    const auto& causes = results.answer.points[1].causes[static_cast<std::size_t>(fstiff::Cause::hardness)];
    CHECK(causes.low < -0.3);
    CHECK(causes.high > 0.3);
    CHECK(contains(test::joined(of.assumptions), "hardness 2.6 GPa (1.2 GPa to 9.5 GPa), of steel"));
    CHECK(contains(actions::measure_next(results), "measure the hardness of the softer body"));
    const actions::Answered named = test::results_of(on(with("steel", "2 GPa")));
    CHECK(named.answer.points[1].causes[static_cast<std::size_t>(fstiff::Cause::hardness)].high == 0);
}

TEST_CASE("The softer body flows, whichever of them has a hardness") {
    const auto same = [](const std::string& a, const std::string& b) {
        const auto one = points_of(a), other = points_of(b);
        for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i].value == other[i].value);
    };
    same(on("\"copper\"", "\"steel\""), on("\"steel\"", "\"copper\""));
    // 8 GPa of the steel leave that of the copper as it is, 0.2 GPa are below all that copper has
    const auto hard = test::scene_of(on(with("steel", "8 GPa"), "\"copper\"")),
               soft = test::scene_of(on(with("steel", "0.2 GPa"), "\"copper\""));
    const auto copper = fstiff::find_material("copper")->hardness();
    CHECK(hard.joint.hardness_range->middle == copper.middle);
    CHECK(hard.joint.hardness_range->high == copper.high);
    CHECK_FALSE(soft.joint.hardness_range.has_value());
    CHECK(*soft.joint.hardness == 0.2e9);
}

TEST_CASE("Hardness is read in the units of hardness") {
    const double vickers = 9.80665e6 / std::sin(68 * std::acos(-1.0) / 180);
    const auto hardness = [](const std::string& text, const char* name = "steel") {
        return *test::scene_of(on(with(name, text))).joint.hardness;
    };
    for (const char* text : {"240 HV", "240HV10", "HV 240", "240 HV 0.3", " 240  HV1 "}) {
        INFO(text);
        CHECK(test::relative_error(hardness(text), 240 * vickers) < 1e-12);
    }
    CHECK(test::relative_error(hardness("200 HBW 2.5/187.5"), 210 * vickers) < 1e-12);
    CHECK(test::relative_error(hardness("100 HB", "aluminium"), 114 * vickers) < 1e-12);
    CHECK(test::relative_error(hardness("60 HRC"), 697 * vickers) < 1e-12);
    CHECK(test::relative_error(hardness("200 kgf/mm^2"), 200 * 9.80665e6) < 1e-12);
    CHECK(std::isinf(hardness("infinite")));
    for (const char* wrong : {"12 HRC", "-3 HV", "0 HV", "HV", "240", "soft", "240 HX", "HRC", "2 GPa HV", ""}) {
        const std::string said = test::refused_scene(on(with("steel", wrong)));
        INFO(wrong << ": " << said);
        CHECK(contains(said, "material.upper.hardness"));
        CHECK(contains(said, "scene.toml"));
    }
}

TEST_CASE("A hardness below the yield strength, or above a tenth of the modulus of a metal, is a warning") {
    const auto warned = [](const std::string& keys) {
        return test::joined(test::scene_of(on("{ name = \"steel\", " + keys + " }")).warnings);
    };
    CHECK(contains(warned("hardness = \"30 GPa\""), "is above a tenth of the modulus"));
    CHECK(contains(warned("hardness = \"200 MPa\", yield_strength = \"400 MPa\""), "is below the yield strength"));
    CHECK_FALSE(contains(warned("hardness = \"7 GPa\""), "hardness"));
}

TEST_CASE("An unknown material is refused with the names next to it") {
    const std::string said = test::refused_scene(on("\"aluminium 6061 T651\""));
    CHECK(contains(said, "\"6061\""));
    CHECK(contains(said, "youngs_modulus"));
    CHECK(contains(test::refused_scene(on("\"wood\"")), "is not a known material; fstiff help materials"));
}

TEST_CASE("A body that never yields is elastic, and so is rubber") {
    CHECK(test::results_of(on(with("steel", "infinite"))).answer.points[1].law == fstiff::LawKind::hybrid);
    const auto rubber = test::scene_of(on("{ youngs_modulus = \"2 MPa\", poisson_ratio = 0.49 }", "\"steel\""));
    CHECK(rubber.joint.hardness_range.has_value());  // of the steel
    CHECK(test::scene_of(ground + "[material.upper]\nyoungs_modulus = \"2 MPa\"\npoisson_ratio = 0.49\n" + loads)
              .joint.hardness_range.has_value() == false);
}

TEST_CASE("K of a map is that of all its waves, unless a lambda_s is given") {
    const test::Folder folder;
    const auto map = fstiff::self_affine_map<double>({.hurst = 0.6, .rms = 0.5e-6, .longest_wavelength = 64e-6}, 128,
                                                     128, 1e-6, 1e-6);
    {
        std::ofstream file(folder / "map.csv");
        fstiff::io::write_csv(file, map);
    }
    const auto text = [&](const std::string& keys) {
        return "[surface]\nfrom = '" + folder / "map.csv" + "'\ndetrend = \"mean\"\n" + keys +
               "[material]\nupper = " + with("steel", "infinite") + "\n" + loads +
               "[boundary_elements]\nedges = \"periodic\"\n";
    };
    const double modulus = 210e9 / (2 * (1 - 0.09));
    const auto all = test::results_of(text("")), none = test::results_of(text("lambda_s = \"none\"\n")),
               given = test::results_of(text("lambda_s = \"8 um\"\n"));
    const std::vector<double> pressures{5e6, 50e6, 300e6};
    const auto truth = fstiff::solve_half_space(map, modulus, pressures, {.edges = fstiff::Edges::periodic});
    for (std::size_t i = 1; i < 3; ++i) {  // at the first one fewer than 20 points touch
        CHECK(test::relative_error(points_of(all)[i].value, truth[i].state.stiffness) < 1e-9);
        CHECK(points_of(all)[i].value == points_of(none)[i].value);
    }
    CHECK(points_of(given)[1].value > 1.1 * points_of(all)[1].value);  // the more the fewer points touch
    CHECK(test::scene_of(text("")).joint.face.parameters.peak_radius.value >
          1.2 * test::scene_of(text("lambda_s = \"none\"\n")).joint.face.parameters.peak_radius.value);
}

TEST_CASE("Noise of an instrument is a cause of the band of a map, and above 5 % of sigma a warning") {
    const test::Folder folder;
    const auto write = [&](double noise) {
        auto map = fstiff::self_affine_map<double>({.hurst = 0.8, .rms = 1e-6, .longest_wavelength = 64e-6}, 128, 128,
                                                   1e-6, 1e-6);
        std::mt19937_64 random(2);
        std::normal_distribution<double> normal(0, 1);
        for (double& z : map.heights.reshaped()) z += noise * normal(random);
        std::ofstream file(folder / "map.csv");
        fstiff::io::write_csv(file, map);
    };
    const std::string text = "[surface]\nfrom = '" + folder / "map.csv" +
                             "'\n[material]\nupper = " + with("steel", "infinite") + "\n" + loads +
                             "[boundary_elements]\nedges = \"periodic\"\n";
    const auto part = [](const actions::Answered& results) {
        return results.answer.points[2].causes[static_cast<std::size_t>(fstiff::Cause::noise)].high;
    };
    write(0);
    const actions::Answered quiet = test::results_of(text);
    CHECK(part(quiet) < 0.01);
    CHECK_FALSE(contains(test::joined(quiet.warnings), "noise"));
    write(0.1e-6);
    const actions::Answered noisy = test::results_of(text);
    CHECK(part(noisy) > part(quiet));
    CHECK(contains(test::joined(noisy.warnings), "the shortest waves of the map are noise, some 10 % of sigma"));
    CHECK(points_of(noisy)[2].high > points_of(quiet)[2].value);  // the band holds K without the noise
}

}  // namespace hardness_test
