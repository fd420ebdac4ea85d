// SPDX-License-Identifier: BSD-3-Clause
// [surface.upper] and [surface.lower]: two rough faces as one.
#include "support/library.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/topography/height_map.hpp>
#include <fstiff/topography/sum_of_maps.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace two_faces_test {

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n"
    "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\n";

const std::string numbers =
    "rms_height = \"0.8 um\"\npeak_radius = \"40 um\"\npeak_density = \"900 /mm^2\"\nfractal_dimension = 1.3\nr = "
    "0.5\ntheta = 0.6\n";

std::string map_text(std::uint64_t seed, double rms) {
    return test::map_text(
        192, 1e-6, {.hurst = 0.8, .rms = rms, .longest_wavelength = 60e-6, .shortest_wavelength = 8e-6, .seed = seed});
}

}  // namespace

TEST_CASE("A face next to a smooth one is [surface], and the inputs record it") {
    const auto one = test::scene_of("[surface]\n" + numbers + rest),
               same = test::scene_of("[surface.upper]\n" + numbers + rest);
    CHECK(test::csv_of(fstiff::actions::compute(one)) == test::csv_of(fstiff::actions::compute(same)));
    const auto lower = std::find_if(one.inputs.begin(), one.inputs.end(),
                                    [](const auto& input) { return input.key == "surface.lower"; });
    REQUIRE(lower != one.inputs.end());
    CHECK(lower->written.starts_with("smooth"));
}

TEST_CASE("Two equal faces are one of sqrt(2) the heights, with the same peaks a unit of area") {
    const auto two = test::results_of("[surface.upper]\n" + numbers + "[surface.lower]\n" + numbers + rest),
               one = test::results_of(
                   "[surface]\nrms_height = \"1.1313708498984762 um\"\npeak_radius = \"28.284271247461902 um\"\n"
                   "peak_density = \"900 /mm^2\"\nfractal_dimension = 1.3\nr = 0.5\ntheta = 0.6\n" +
                   rest);
    REQUIRE(two.curves().size() == one.curves().size());
    for (std::size_t c = 0; c < two.curves().size(); ++c)
        for (std::size_t i = 0; i < 2; ++i) {
            const double truth = one.curves()[c].points[i].state.stiffness.value;
            CHECK(std::abs(two.curves()[c].points[i].state.stiffness.value - truth) < 1e-10 * truth);
        }
}

TEST_CASE("Two maps: what is measured of both adds up to what is measured of their sum, within the errors", "[more]") {
    const test::Folder folder;
    const auto upper = folder.write("upper.txt", map_text(3, 1e-6)),
               lower = folder.write("lower.txt", map_text(4, 0.6e-6));
    const auto a = fstiff::io::read_surface(std::filesystem::path(upper)).map(),
               b = fstiff::io::read_surface(std::filesystem::path(lower)).map();
    const auto sum = fstiff::detail::shifted_sum(a, b, 0, 0);
    std::ostringstream text;
    text.precision(17);
    for (Eigen::Index j = 0; j < sum.rows(); ++j)
        for (Eigen::Index i = 0; i < sum.columns(); ++i)
            text << static_cast<double>(i) * sum.dx << ' ' << static_cast<double>(j) * sum.dy << ' '
                 << sum.heights(j, i) << '\n';
    folder.write("sum.txt", text.str());
    const auto measured = test::measured("--units m --peaks summits", text.str())["surface"];
    const std::string file = folder / "scene.toml";
    const auto added = test::scene_of(
        "[surface.upper]\nfrom = \"upper.txt\"\npeaks = \"summits\"\n"
        "[surface.lower]\nfrom = \"lower.txt\"\npeaks = \"summits\"\n" +
            rest + "laws = [\"hertz\", \"persson\", \"hybrid\", \"summits\", \"boundary_elements\"]\n",
        file);
    const auto check_added = [&](const char* key, double sum_of_both) {
        const double found = measured[key]["value"], error = measured[key]["error"];
        INFO(key << ": added " << sum_of_both << ", of the sum " << found << " +- " << error);
        CHECK(std::abs(sum_of_both - found) < 3 * error);
        CHECK(std::abs(sum_of_both - found) < 0.1 * found);
    };
    check_added("rms_height", test::face(added).parameters.rms_height.value);
    check_added("peak_radius", test::face(added).parameters.peak_radius.value);
    check_added("peak_density", test::face(added).parameters.peak_density.value);
    check_added("r", test::face(added).parameters.r.value().value);
    check_added("theta", test::face(added).parameters.theta.value().value);
    // K of the added heights at random shifts against K of the one shift of 0 that was measured
    const test::Csv of_sum = test::rows_of_scene("[surface]\nfrom = \"sum.txt\"\nunits = \"m\"\n" + rest +
                                                     "laws = [\"hybrid\", \"summits\", \"boundary_elements\"]\n",
                                                 file);
    const test::Csv rows(test::csv_of(fstiff::actions::compute(added)));
    int compared = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t j = 0; j < of_sum.size(); ++j)
            if (rows.text(i, "law") == of_sum.text(j, "law") && rows.number(i, "pressure_Pa") == 1e7 &&
                of_sum.number(j, "pressure_Pa") == 1e7) {
                const double k = rows.number(i, "stiffness_Pa_per_m"), one = of_sum.number(j, "stiffness_Pa_per_m");
                const double scatter = rows.number(i, "stiffness_error_Pa_per_m");  // of one shift about the mean
                INFO(rows.text(i, "law") << ": " << k << " +- " << scatter << " over shifts, " << one << " at one");
                CHECK(std::abs(k - one) < 3 * scatter);
                CHECK(scatter > 0.02 * k);
                CHECK(scatter < 0.5 * k);
                ++compared;
            }
    CHECK(compared == 3);
    CHECK(added.joint.faces.at(0).parameters.rms_height.value > 0.9e-6);
    CHECK(added.joint.faces.at(1).parameters.rms_height.value < 0.7e-6);
}

TEST_CASE("Wrong keys of two faces are reported in one sentence") {
    const auto refused = [&](const std::string& surface, const std::string& sentence, const std::string& more = "") {
        test::check_sentence(test::refused_scene(surface + rest + more), {sentence});
    };
    const std::string both = "[surface.upper]\n" + numbers + "[surface.lower]\n" + numbers;
    refused("[surface]\nrms_height = \"1 um\"\n" + both, "surface.rms_height: unknown key; valid keys of surface are");
    refused("[surface]\nshifts = 3\n" + both,
            "surface.shifts = 3: needs two maps of one grid: not both faces are maps");
    refused(both, "\"summits\" needs two maps of one grid, whose heights can be added: not both faces are maps",
            "laws = [\"summits\"]\n");
    refused("[surface.upper]\n" + numbers + "[surface.lower]\nrms_height = \"1\"\n", "surface.lower.rms_height");
    refused("surface.upper = 3\n" + both.substr(both.find("[surface.lower]")), "");
}

}  // namespace two_faces_test
