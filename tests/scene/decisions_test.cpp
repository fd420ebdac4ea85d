// SPDX-License-Identifier: BSD-3-Clause
// What is decided between a scene and its numbers, each against the closed form of its decision: a wrong share, default
// or threshold shows here.
#include "support/half_space_maps.hpp"
#include "support/library.hpp"

#include <cmath>
#include <numbers>

namespace decisions_test {

using namespace fstiff;
using test::contains;

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0\n[contact]\n"
    "pressures = [\"2 MPa\", \"50 MPa\"]\npeaks = [{ theta = 1.0, r = 0.5 }]\n";
const std::string islands = "rms_height = \"1 um\"\npeak_radius = \"40 um\"\npeak_density = \"2000 /mm^2\"\n";
const std::string modulus_and_law = "laws = [\"hybrid\"]\n";

std::string surface(const std::string& keys) { return "[surface]\n" + keys + rest; }
double stiffness(const actions::Answered& results, std::size_t point = 0) {
    return results.curves().front().points.at(point).state.stiffness.value;
}

/// A map of \p points a side of a half space, 1e-4 of its heights and lengths, in a file of its own.
std::string map_file(const test::Folder& folder, const std::string& name, Eigen::Index points, double taller = 1) {
    return folder.write(name, test::file_text(test::corner_of_map(points, taller)));
}

}  // namespace

TEST_CASE("alpha and R give the mean square slope, and so the rms gradient and p*, of numbers without a gradient") {
    // m4 = (3 sqrt(pi)/(8 R))^2 by (4.10), m2 = sqrt(m0 m4/alpha), g = sqrt(2 m2)
    const double sigma = 1e-6, curvature = 3 * std::sqrt(std::numbers::pi) / (8 * 40e-6), alpha = 8;
    const double gradient = std::sqrt(2 * sigma * curvature / std::sqrt(alpha));
    const auto results = test::results_of(surface(islands + "alpha = 8\n") + modulus_and_law);
    const AnswerPoint& first = results.curves().front().points.front();
    REQUIRE(first.p_star);
    CHECK(test::relative_error(first.pressure / (results.answer.effective_modulus * *first.p_star), gradient) < 1e-13);
    // and K is that of the moments that these are
    const auto written = test::results_of(
        surface("rms_height = \"1 um\"\nalpha = 8\nrms_gradient = " + document::exact(gradient) + "\n") +
        modulus_and_law);
    CHECK(test::relative_error(stiffness(results), stiffness(written)) < 1e-12);
}

TEST_CASE("H of a band is 2 - D, or 0.8 where D is not known, and the scene records it") {
    const std::string moments = "rms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 20\n";
    const auto k = [&](const std::string& more) {
        return stiffness(test::results_of(surface(moments + more) + modulus_and_law));
    };
    CHECK(k("") == k("hurst = 0.8\n"));
    CHECK(k("") != k("hurst = 0.75\n"));
    CHECK(test::relative_error(k("fractal_dimension = 1.4\n"), k("fractal_dimension = 1.4\nhurst = 0.6\n")) < 1e-13);
    const auto assumed = test::scene_of(surface(moments) + modulus_and_law).assumed();
    REQUIRE(assumed.size() == 1);
    CHECK(assumed[0].key == "hurst");
    CHECK(assumed[0].value == 0.8);
    CHECK(test::scene_of(surface(moments + "hurst = 0.8\n") + modulus_and_law).assumed().empty());
}

TEST_CASE("Two maps of one face share its spectrum by their areas, two faces add theirs") {
    const test::Folder folder;
    const std::string large = map_file(folder, "large.csv", 192), small = map_file(folder, "small.csv", 96, 1.5);
    const auto of = [&](const std::string& text) { return test::scene_of(text + rest + modulus_and_law); };
    const std::string rule = "\nlambda_s = \"none\"\n";
    const scene::Scene one = of("[surface]\nfrom = \"" + large + "\"" + rule),
                       other = of("[surface]\nfrom = \"" + small + "\"" + rule),
                       both = of("[surface]\nfrom = [\"" + large + "\", \"" + small + "\"]" + rule),
                       sum = of("[surface.upper]\nfrom = \"" + large + "\"" + rule + "[surface.lower]\nfrom = \"" +
                                large + "\"" + rule);
    const auto square = [](const scene::Scene& of_map) {
        const double rms = test::face(of_map).map->spectrum().rms_height;
        return rms * rms;
    };
    const double share = 192.0 * 192 / (192 * 192 + 96 * 96);
    CHECK(test::relative_error(square(both), share * square(one) + (1 - share) * square(other)) < 1e-12);
    CHECK(test::relative_error(test::face(both).map->mean_square_height,
                               share * test::face(one).map->mean_square_height +
                                   (1 - share) * test::face(other).map->mean_square_height) < 1e-12);
    CHECK(test::relative_error(square(sum), 2 * square(one)) < 1e-12);
    CHECK(test::relative_error(test::face(sum).map->mean_square_height, 2 * test::face(one).map->mean_square_height) <
          1e-12);
}

TEST_CASE("H of two faces is the mean by their mean square slopes, the error of the gradient that of its square") {
    const auto face = [](const char* gradient, const char* hurst) {
        return std::string("rms_height = \"1 um\"\nalpha = 20\nrms_gradient = ") + gradient + "\nhurst = " + hurst +
               "\nerrors = { rms_gradient = 0.01 }\n";
    };
    const scene::Scene sum = test::scene_of("[surface.upper]\n" + face("0.2", "0.9") + "[surface.lower]\n" +
                                            face("0.1", "0.4") + rest + modulus_and_law);
    CHECK(test::relative_error(test::face(sum).rms_gradient.value(), std::sqrt(0.05)) < 1e-14);
    CHECK(test::relative_error(test::face(sum).hurst.value(), 0.8 * 0.9 + 0.2 * 0.4) < 1e-14);
    CHECK(test::relative_error(test::face(sum).gradient_error, std::hypot(0.2 * 0.01, 0.1 * 0.01) / std::sqrt(0.05)) <
          1e-14);
}

TEST_CASE("The error of K of two maps holds the scatter of one shift, by n - 1") {
    const test::Folder folder;
    const std::string a = map_file(folder, "a.csv", 96), b = map_file(folder, "b.csv", 96, 1.2);
    const auto k_of = [&](const std::string& from) {
        return test::results_of("[surface]\nfrom = " + from + "\nlambda_s = \"none\"\n" + rest +
                                "laws = [\"summits\"]\n[uncertainty]\nsamples = 0\n");
    };
    const auto one = k_of("\"" + a + "\""), other = k_of("\"" + b + "\""),
               mean = k_of("[\"" + a + "\", \"" + b + "\"]");
    for (std::size_t i = 0; i < 2; ++i) {
        const double first = stiffness(one, i), second = stiffness(other, i);
        CHECK(test::relative_error(stiffness(mean, i), (first + second) / 2) < 1e-12);
        // of two numbers the standard deviation by n - 1 is their distance over sqrt(2)
        CHECK(test::relative_error(mean.curves()[0].points[i].state.stiffness.error,
                                   std::abs(first - second) / std::sqrt(2.0)) < 1e-6);
    }
}

TEST_CASE("The band of one error in a scene has the 5 % and the 95 % of K") {
    // K of hertz goes as a power of sigma over a small change: K(sigma exp(-+1.645 s))
    const std::string of_error = "errors = { rms_height = \"0.02 um\" }\n";
    const std::string laws = "laws = [\"hertz\"]\n[uncertainty]\nsamples = 2000\n";
    const auto banded = test::results_of(surface(islands + of_error) + laws);
    const auto at = [&](double factor) {
        return stiffness(test::results_of(surface(test::replaced(islands, "1 um", document::exact(factor) + " um")) +
                                          "laws = [\"hertz\"]\n"));
    };
    const double s = std::sqrt(std::log1p(0.02 * 0.02)), low = at(std::exp(1.6448536 * s)),
                 high = at(std::exp(-1.6448536 * s));
    const auto& band = banded.curves()[0].points.at(0).stiffness;
    // 2000 draws give a quantile to 0.047 standard deviations, 3 % of 1.645; three of those
    CHECK(std::abs(std::log(band.low / low)) < 0.1 * std::log(high / low) / 2);
    CHECK(std::abs(std::log(band.high / high)) < 0.1 * std::log(high / low) / 2);
}

TEST_CASE("The softer body alone decides whether the peaks yield, and how much") {
    const auto results = [](const std::string& yield, const std::string& lower) {
        return test::results_of(
            "[surface]\nrms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 8\n"
            "[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0\n" +
            yield + "[material.lower]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0\n" + lower +
            "[contact]\npressures = [\"2 MPa\"]\n");
    };
    const auto soft = results("yield_strength = \"300 MPa\"\n", "yield_strength = \"900 MPa\"\n"),
               turned = results("yield_strength = \"900 MPa\"\n", "yield_strength = \"300 MPa\"\n"),
               hard = results("yield_strength = \"900 GPa\"\n", "yield_strength = \"900 GPa\"\n");
    CHECK(soft.answer.yield_strength == 300e6);
    CHECK(turned.answer.yield_strength == 300e6);
    // 2.8 Y/(E g)
    CHECK(contains(test::joined(soft.explanation),
                   "The peaks yield at first loading (H/(E g) = 0.084): K is the unloading stiffness"));
    CHECK(soft.explanation == turned.explanation);
    CHECK(stiffness(soft) == stiffness(turned));
    CHECK(contains(test::joined(hard.explanation), "The contact is nearly elastic (H/(E g) = 250)"));
    CHECK(stiffness(soft) > stiffness(hard));
}

TEST_CASE("Boundary elements take a map of 16 points a side and none of 15") {
    const test::Folder folder;
    const auto refused = [&](Eigen::Index points) {
        return test::refused_scene(
            "[surface]\nfrom = \"" + map_file(folder, "m.csv", points) + "\"\nlambda_s = \"none\"\n" + rest +
            "laws = [\"boundary_elements\"]\n[boundary_elements]\npoints = 16\n[uncertainty]\nsamples = 0\n");
    };
    CHECK(contains(refused(15), "needs a map of at least 16 points a side"));
    CHECK_FALSE(contains(refused(16), "at least 16 points a side"));
}

TEST_CASE("Spikes are hinted at from 30 standard deviations on, and taken out from the limit on") {
    const auto text = [](double spike) {
        std::string rows;
        for (int i = 0; i < 400; ++i)
            rows += document::exact(i == 200 ? spike : std::sin(0.3 * i) + 0.2 * std::sin(i * i)) + "\n";
        return rows;
    };
    const std::string how = "--units um --spacing '1 um' --lambda-s none --lambda-c none";
    CHECK(contains(test::measured(how, text(90))["warnings"].dump(), "--spikes 20 removes "));
    CHECK(contains(test::measured(how, text(25))["warnings"].dump(), "--spikes 20 removes "));
    CHECK_FALSE(contains(test::measured(how, text(1))["warnings"].dump(), "--spikes"));
    CHECK(test::decided(test::measured(how + " --spikes 20", text(90)), "spikes: 1 of 400 points became missing"));
}

}  // namespace decisions_test
