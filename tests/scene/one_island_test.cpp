// SPDX-License-Identifier: BSD-3-Clause
// A surface of which R and D_p cannot be had is measured and answered by everything that does not need them.
#include "support/library.hpp"

#include <fstiff/halfspace/solve_half_space.hpp>

#include <cmath>

namespace one_island_test {

using namespace fstiff;
using nlohmann::json;
using test::contains;

namespace {

constexpr double radius = 5e-3, side = 4e-6;

/// \p z(x, y) [m] on 128 points a side every 4 um, from the middle.
template <class Z>
HeightMap<double> map_of(const Z& z) {
    HeightMap<double> map{HeightMap<double>::Array(128, 128), side, side};
    for (Eigen::Index j = 0; j < 128; ++j)
        for (Eigen::Index i = 0; i < 128; ++i)
            map.heights(j, i) = z((static_cast<double>(i) - 63.5) * side, (static_cast<double>(j) - 63.5) * side);
    return map;
}
HeightMap<double> ball() {
    return map_of([](double x, double y) { return -(x * x + y * y) / (2 * radius); });
}
HeightMap<double> bump() {
    return map_of([](double x, double y) { return 20e-6 * std::exp(-(x * x + y * y) / (2 * 60e-6 * 60e-6)); });
}

std::string text_of(const HeightMap<double>& map) {
    std::ostringstream text;
    io::write_csv(text, map);
    return text.str();
}

std::string scene_of(const std::string& file, const std::string& surface, const std::string& contact) {
    return "material = { upper = \"steel\" }\n[surface]\nfrom = '" + file + "'\n" + surface + "[contact]\n" + contact +
           "[boundary_elements]\npoints = 128\n[uncertainty]\nsamples = 20\n";
}

}  // namespace

TEST_CASE("K of a smooth ball is that of Hertz, and R and D_p are not known: one island") {
    const test::Folder folder;
    const std::string file = folder.write("ball.csv", text_of(ball()));
    const std::string whole = "detrend = \"none\"\nlambda_s = \"none\"\n";
    const scene::Scene of = test::scene_of(scene_of(file, whole, "pressures = [\"1 MPa\"]\n"));
    const actions::Answered results = actions::compute(of);
    REQUIRE(results.has_answer());
    const double K = results.answer.points.front().state.stiffness.value;
    // one ball on A0 = (128 4 um)^2: K = 2 E a/A0, a^3 = 3 p A0 R/(4 E); its mirror images add 10 % at a = L/25
    const double area = std::pow(128 * side, 2), E = results.answer.effective_modulus,
                 a = std::cbrt(3 * 1e6 * area * radius / (4 * E)), hertz = 2 * E * a / area;
    CHECK(K > hertz);
    CHECK(K < 1.15 * hertz);
    HeightMap<double> centred = ball();
    const auto exact = solve_half_space(centred, E, std::vector{1e6}, {.points = 128});
    CHECK(test::relative_error(K, exact.front().state.stiffness) < 1e-6);
    CHECK_FALSE(of.joint.face.has_radius_and_density());
    CHECK(of.joint.face.parameters.why_no_density == "one island");

    const actions::Answered named =
        test::results_of(scene_of(file, whole, "pressures = [\"1 MPa\"]\nlaws = [\"boundary_elements\", \"hertz\"]\n"));
    CHECK(test::relative_error(named.curves().front().points.front().state.stiffness.value, K) < 1e-12);
    CHECK(contains(test::joined(named.warnings), "D_p is not known: one island"));
    test::check_sentence(
        test::refused_scene(scene_of(file, whole, "pressures = [\"1 MPa\"]\nlaws = [\"hertz\"]\n")),
        {"\"hertz\" needs surface.peak_radius and surface.peak_density, which are not known: one island"});
    const actions::Answered given =
        test::results_of(scene_of(file, whole + "peak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n",
                                  "pressures = [\"1 MPa\"]\nlaws = [\"hertz\"]\n"));
    CHECK(given.curves().front().points.size() == 1);
}

TEST_CASE("A map of one bump has all parameters but R and D_p") {
    const json found = test::measured("", text_of(bump()));
    // 20 um exp(-r^2/(2 s^2)), s = 60 um, on L = 512 um: mean square less the square mean, less no plane
    const double pi = std::numbers::pi_v<double>, L = 512e-6, s = 60e-6, mean = 2 * pi * s * s / L / L;
    const double sigma = 20e-6 * std::sqrt(pi * s * s / L / L - mean * mean);
    CHECK(std::abs(found["surface"]["rms_height"]["value"].get<double>() / sigma - 1) < 0.01);
    CHECK(found["no_peak_density"] == "one island");
    CHECK_FALSE(found["surface"].contains("peak_radius"));
    CHECK_FALSE(found["surface"].contains("peak_density"));
    CHECK(found["surface"].contains("rms_gradient"));
    CHECK(contains(found["warnings"].dump(), "no R and D_p"));
    CHECK_FALSE(contains(found["warnings"].dump(), "R and D_p come from"));

    const test::Folder folder;  // the JSON is a surface of a scene, as numbers
    const actions::Answered results =
        test::results_of(scene_of(folder.write("bump.json", found.dump()), "", "pressures = [\"10 MPa\"]\n"));
    REQUIRE(results.has_answer());
    CHECK(results.answer.points.front().state.stiffness.value > 0);
    json without = found;
    without.erase("no_peak_density");
    test::check_sentence(
        test::refused_scene(scene_of(folder.write("cut.json", without.dump()), "", "pressures = [\"10 MPa\"]\n")),
        {"surface.peak_radius: is missing"});
}

TEST_CASE("Bowls, half covered bumps and several files of a bump are measured") {
    HeightMap<double> half = bump();
    half.heights.leftCols(70) = std::nan("");
    HeightMap<double> bowl = ball();
    bowl.heights *= -1;
    const test::Folder folder;
    for (const HeightMap<double>& map : {half, bowl, HeightMap<double>{-bump().heights, side, side}}) {
        const std::string text = text_of(map);
        const json found = test::measured("--detrend mean", text);
        CHECK(found["surface"].contains("rms_height"));
        CHECK(found["surface"].contains("rms_gradient"));
        CHECK(found["surface"].contains("peak_radius") == !found.contains("no_peak_density"));
        const actions::Answered results = test::results_of(
            scene_of(folder.write("map.csv", text), "detrend = \"mean\"\n", "pressures = [\"10 MPa\"]\n"));
        CHECK(results.has_answer());
    }
    HeightMap<double> other = bump();
    other.heights *= 1.1;
    const json two =
        test::measured_files("", {folder.write("a.csv", text_of(bump())), folder.write("b.csv", text_of(other))});
    CHECK(two["no_peak_density"] == "one island");
    CHECK_FALSE(two["surface"].contains("peak_density"));
    // next to a rough face: the sum has neither
    const std::string rough =
        folder.write("rough.csv", test::map_text(128, side, {.hurst = 0.8, .rms = 1e-6, .longest_wavelength = 60e-6}));
    const actions::Answered sum =
        test::results_of("material = { upper = \"steel\" }\n[surface.upper]\nfrom = '" +
                         folder.write("c.csv", text_of(bump())) + "'\n[surface.lower]\nfrom = '" + rough +
                         "'\n[contact]\npressures = [\"10 MPa\"]\n[uncertainty]\nsamples = 20\n");
    REQUIRE(sum.has_answer());
    CHECK(sum.answer.points.front().state.stiffness.value > 0);
}

TEST_CASE("A profile without a peak is measured, and answered by the laws of its spectrum") {
    std::string text;
    for (int i = 0; i < 400; ++i) text += document::exact(1e-4 * (i - 150) * (i - 150)) + "\n";
    const std::string how = "--units um --spacing '1 um' --lambda-s none";
    const json found = test::measured(how, text);
    CHECK(found["no_peak_density"] == "no peak");
    CHECK(found["surface"].contains("rms_height"));
    CHECK(found["surface"].contains("peak_radius"));
    CHECK_FALSE(found["surface"].contains("peak_density"));
    CHECK(contains(found["warnings"].dump(), "no D_p"));
    const test::Folder folder;
    const actions::Answered results = test::results_of(
        scene_of(folder.write("bowl.txt", text), "units = \"um\"\nspacing = \"1 um\"\n", "pressures = [\"10 MPa\"]\n"));
    REQUIRE(results.has_answer());
    CHECK(results.answer.points.front().state.stiffness.value > 0);
    CHECK(results.doubtful);  // it is one parabola
}

}  // namespace one_island_test
