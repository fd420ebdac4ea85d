// SPDX-License-Identifier: BSD-3-Clause
// What is decided between a scene and its numbers, each against the closed form of its decision: a wrong share, default
// or threshold shows here.
#include "support/half_space_maps.hpp"
#include "support/library.hpp"

#include "scene/overclosure.hpp"

#include <cmath>
#include <numbers>

namespace decisions_test {

namespace scene = fstiff::scene;
using test::contains;

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0\n[contact]\n"
    "pressures = [\"2 MPa\", \"50 MPa\"]\npeaks = [{ theta = 1.0, r = 0.5 }]\n";
const std::string islands = "rms_height = \"1 um\"\npeak_radius = \"40 um\"\npeak_density = \"2000 /mm^2\"\n";
const std::string modulus_and_law = "laws = [\"hybrid\"]\n";

std::string surface(const std::string& keys) { return "[surface]\n" + keys + rest; }
double stiffness(const scene::Results& results, std::size_t point = 0) {
    return results.curves.front().states.at(point).stiffness.value;
}

/// A map of \p points a side of a half space, 1e-4 of its heights and lengths, in a file of its own.
std::string map_file(const test::Folder& folder, const std::string& name, Eigen::Index points, double taller = 1) {
    fstiff::HeightMap<double> map = test::half_space_map("gaussian");
    map.heights = (taller * 1e-4 * map.heights.topLeftCorner(points, points)).eval();
    map.dx = map.dy = 1e-4 / 256;
    std::ofstream file(folder / name);
    fstiff::io::write_csv(file, map);
    return folder / name;
}

}  // namespace

TEST_CASE("alpha and R give the mean square slope, and so the rms gradient and p*, of numbers without a gradient") {
    // m4 = (3 sqrt(pi)/(8 R))^2 by (4.10), m2 = sqrt(m0 m4/alpha), g = sqrt(2 m2)
    const double sigma = 1e-6, curvature = 3 * std::sqrt(std::numbers::pi) / (8 * 40e-6), alpha = 8;
    const double gradient = std::sqrt(2 * sigma * curvature / std::sqrt(alpha));
    const auto results = test::results_of(surface(islands + "alpha = 8\n") + modulus_and_law);
    REQUIRE(results.curves.front().rms_gradient);
    CHECK(test::relative_error(*results.curves.front().rms_gradient, gradient) < 1e-13);
    // and K is that of the moments that these are
    const auto written = test::results_of(
        surface("rms_height = \"1 um\"\nalpha = 8\nrms_gradient = " + scene::exact(gradient) + "\n") + modulus_and_law);
    CHECK(test::relative_error(stiffness(results), stiffness(written)) < 1e-12);
}

TEST_CASE("H of a band is 2 - D, or 0.8 where D is not known, and the scene says so") {
    const std::string moments = "rms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 20\n";
    const auto k = [&](const std::string& more) {
        return stiffness(test::results_of(surface(moments + more) + modulus_and_law));
    };
    CHECK(k("") == k("hurst = 0.8\n"));
    CHECK(k("") != k("hurst = 0.75\n"));
    CHECK(test::relative_error(k("fractal_dimension = 1.4\n"), k("fractal_dimension = 1.4\nhurst = 0.6\n")) < 1e-13);
    const auto assumed = scene::assumed(test::scene_of(surface(moments) + modulus_and_law));
    REQUIRE(assumed.size() == 1);
    CHECK(assumed[0].key == "hurst");
    CHECK(assumed[0].value == 0.8);
    CHECK(scene::assumed(test::scene_of(surface(moments + "hurst = 0.8\n") + modulus_and_law)).empty());
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
        CHECK(test::relative_error(mean.curves[0].states[i].stiffness.error,
                                   std::abs(first - second) / std::sqrt(2.0)) < 1e-6);
    }
}

TEST_CASE("A highest point above 1.6 times that of as many Gaussian summits makes heights far from Gaussian") {
    const test::Folder folder;
    const scene::Scene read =
        test::scene_of("[surface]\nfrom = \"" + map_file(folder, "map.csv", 128) + "\"\nlambda_s = \"none\"\n" + rest +
                       "laws = [\"hertz\"]\n[uncertainty]\nsamples = 0\n");
    const double summits = static_cast<double>(test::face(read).map->summits.front().summits.size());
    const double gaussian = std::sqrt(2 * std::log(summits));
    const auto verdict = [&](double highest) {
        scene::Scene higher = read;
        test::face(higher).heights = fstiff::HeightStatistics<double>{{0, 0.1}, {3, 0.1}, {0.1, 0.01}, {}};
        auto& parameters = test::face(higher).parameters;
        parameters.max_peak_height.value = highest * gaussian * parameters.rms_height.value;
        return test::joined(compute(higher).verdict);
    };
    CHECK_FALSE(contains(verdict(1.59), "far from Gaussian"));
    CHECK(contains(verdict(1.61), "the heights are far from Gaussian"));
    CHECK(contains(verdict(1.61), "Gaussian summits reach " + scene::rounded(gaussian, 2)));
    CHECK_FALSE(contains(verdict(1.61), "of elastic contacts"));
}

TEST_CASE("A table of pressures keeps its tolerance and has no row that it could do without") {
    const scene::Scene read = test::scene_of(scene::builtin_scene);
    for (const double tolerance : {1e-3, 1e-2, 0.1}) {
        const scene::PressureTable table = pressure_table(read, {.law = "hertz", .tolerance = tolerance});
        CHECK(table.error <= tolerance);
        CHECK(table.error > 0.85 * tolerance);
        // the chord of an exponential over a factor q is off by (ln q)^2/8, so that as many rows are needed
        const double rows = std::log(table.to / table.from) / std::sqrt(8 * tolerance);
        CHECK(static_cast<double>(table.rows.size()) < 1.15 * rows + 3);
        CHECK(static_cast<double>(table.rows.size()) > 0.6 * rows);
    }
    CHECK_FALSE(test::refusal([&] { (void)pressure_table(read, {.law = "hertz", .tolerance = 0.21}); }).empty());
    CHECK_FALSE(test::refusal([&] { (void)pressure_table(read, {.law = "hertz", .tolerance = 0.9e-5}); }).empty());
}

TEST_CASE("The band of one error in a scene has the 5 % and the 95 % of K") {
    // K of hertz goes as a power of sigma over a small change: K(sigma exp(-+1.645 s))
    const std::string of_error = "errors = { rms_height = \"0.02 um\" }\n";
    const std::string laws = "laws = [\"hertz\"]\n[uncertainty]\nsamples = 2000\n";
    const auto banded = test::results_of(surface(islands + of_error) + laws);
    const auto at = [&](double factor) {
        return stiffness(test::results_of(surface(test::replaced(islands, "1 um", scene::exact(factor) + " um")) +
                                          "laws = [\"hertz\"]\n"));
    };
    const double s = std::sqrt(std::log1p(0.02 * 0.02)), low = at(std::exp(1.6448536 * s)),
                 high = at(std::exp(-1.6448536 * s));
    const auto& band = banded.curves[0].band.at(0);
    // 2000 draws tell a quantile to 0.047 standard deviations, 3 % of 1.645; three of those
    CHECK(std::abs(std::log(band.low / low)) < 0.1 * std::log(high / low) / 2);
    CHECK(std::abs(std::log(band.high / high)) < 0.1 * std::log(high / low) / 2);
}

TEST_CASE("The recommended law changes where its accuracy changes: p* of 0.001, 0.002, 0.01 and 0.25, either side") {
    // E = 100 GPa and g = 0.1: p* is p over 10 GPa
    const auto verdict = [](double p) {
        std::string text =
            surface("rms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 8\nhurst = 0.7\n") + modulus_and_law;
        text = test::replaced(text, "\"2 MPa\", \"50 MPa\"", "\"" + scene::exact(p * 1e10) + " Pa\"");
        return test::joined(test::results_of(text).verdict);
    };
    CHECK(contains(verdict(0.00099), "to about a quarter above p* = 0.001 and a factor of two below"));
    CHECK(contains(verdict(0.00101), "to about a quarter\n"));
    CHECK(contains(verdict(0.00199), "to about a quarter\n"));
    CHECK(contains(verdict(0.00201), "to about 15 %"));
    CHECK_FALSE(contains(verdict(0.0099), "too little K above p* = 0.01"));
    CHECK(contains(verdict(0.0101), "too little K above p* = 0.01, half at 0.1"));
    CHECK_FALSE(contains(verdict(0.249), "alone were compared"));
    CHECK(contains(verdict(0.251), "above p* = 0.25 hybrid and persson alone were compared, within 15 % up to 0.75"));
}

TEST_CASE("The scatter of one surface about a law is told below 200 contacts, in four steps") {
    const std::string text =
        surface("rms_height = \"1 um\"\nrms_gradient = 0.1\nalpha = 8\nhurst = 0.7\n") + "laws = [\"hertz\"]\n";
    const auto density = test::results_of(text).curves.front().states.front().contact_density.value;
    const auto verdict = [&](double contacts) {
        return test::joined(test::results_of(test::replaced(text, "[contact]\n",
                                                            "[contact]\nnominal_area = \"" +
                                                                scene::exact(contacts / density) + " m^2\"\n"))
                                .verdict);
    };
    CHECK_FALSE(contains(verdict(201), "contacts are expected"));
    for (const auto& [contacts, words] : {std::pair{199.0, "7 %"},
                                          {101.0, "7 %"},
                                          {99.0, "11 %"},
                                          {41.0, "11 %"},
                                          {39.0, "16 %"},
                                          {16.0, "16 %"},
                                          {14.0, "34 % or more"},
                                          {2.0, "34 % or more"}}) {
        INFO(contacts);
        CHECK(contains(verdict(contacts),
                       "one surface departs from a law by about " + std::string(words) + " there (rms)"));
    }
    CHECK(contains(verdict(1.4), "as few as one contact is expected on the nominal area"));
    CHECK(contains(verdict(0.9), "fewer than one contact is expected on the nominal area (0.9)"));
}

TEST_CASE("The plastic law is advised above a plasticity index of 1, by the softer body alone") {
    const auto results = [](const std::string& yield, const std::string& lower) {
        return test::results_of("[surface]\n" + islands +
                                "[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0\n" + yield +
                                "[material.lower]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0\n" + lower +
                                "[contact]\npressures = [\"2 MPa\"]\nlaws = [\"hertz\"]\n");
    };
    const auto soft = results("yield_strength = \"300 MPa\"\n", "yield_strength = \"900 MPa\"\n"),
               turned = results("yield_strength = \"900 MPa\"\n", "yield_strength = \"300 MPa\"\n"),
               hard = results("yield_strength = \"900 GPa\"\n", "yield_strength = \"900 GPa\"\n");
    REQUIRE(soft.plasticity_index);
    CHECK(*soft.plasticity_index == *turned.plasticity_index);
    CHECK(*soft.plasticity_index > 1);
    CHECK(contains(test::joined(soft.verdict), "the peaks flow (plasticity index "));
    REQUIRE(hard.plasticity_index);
    CHECK(*hard.plasticity_index < 1);
    CHECK_FALSE(contains(test::joined(hard.verdict), "flow"));
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

TEST_CASE("The parameters of several files are pooled by their lengths") {
    const test::Folder folder;
    const fstiff::SelfAffineOptions<double> how{
        .hurst = 0.7, .rms = 1e-6, .longest_wavelength = 80e-6, .shortest_wavelength = 6e-6};
    const std::string line = "--lambda-s none --lambda-c none";
    const std::string long_one = test::profile_text(4096, 1e-6, how), short_one = test::profile_text(1024, 1e-6, how);
    const auto a = test::measured(line, long_one)["surface"], b = test::measured(line, short_one)["surface"];
    const auto both =
        test::measured_files(line, {folder.write("long", long_one), folder.write("short", short_one)})["surface"];
    const auto of = [](const nlohmann::json& one, const char* key) { return one[key]["value"].get<double>(); };
    const double share = 4096.0 / (4096 + 1024);
    const auto mean = [&](const char* key, double power) {
        return std::pow(share * std::pow(of(a, key), power) + (1 - share) * std::pow(of(b, key), power), 1 / power);
    };
    CHECK(test::relative_error(of(both, "rms_height"), mean("rms_height", 2)) < 1e-9);
    CHECK(test::relative_error(of(both, "rms_gradient"), mean("rms_gradient", 2)) < 1e-9);
    CHECK(test::relative_error(of(both, "peak_radius"), mean("peak_radius", -2)) < 1e-9);
    CHECK(of(both, "max_peak_height") == std::max(of(a, "max_peak_height"), of(b, "max_peak_height")));
}

TEST_CASE("Spikes are hinted at from 30 standard deviations on, and taken out from the limit on") {
    const auto text = [](double spike) {
        std::string rows;
        for (int i = 0; i < 400; ++i)
            rows += scene::exact(i == 200 ? spike : std::sin(0.3 * i) + 0.2 * std::sin(i * i)) + "\n";
        return rows;
    };
    const std::string how = "--units um --spacing '1 um' --lambda-s none --lambda-c none";
    CHECK(contains(test::measured(how, text(90))["warnings"].dump(), "--spikes 20 takes such points out"));
    CHECK(contains(test::measured(how, text(25))["warnings"].dump(), "--spikes 20 takes such points out"));
    CHECK_FALSE(contains(test::measured(how, text(1))["warnings"].dump(), "--spikes"));
    CHECK(test::decided(test::measured(how + " --spikes 20", text(90)), "spikes: 1 of 400 points became missing"));
}

}  // namespace decisions_test
