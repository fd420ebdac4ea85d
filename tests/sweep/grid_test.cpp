// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/grid.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <fstiff/core/error.hpp>

#include <cmath>
#include <set>

namespace grid_test {

using namespace fstiff::sweep;

namespace {

/// A grid with these lines in [surface], [contact] and [sweep].
std::string grid_text(const std::string& surface, const std::string& contact = "pressures = [\"1 MPa\"]",
                      const std::string& sweep = "") {
    return "[surface]\n" + surface +
           "\n[material.upper]\nyoungs_modulus = \"200 GPa\"\npoisson_ratio = 0.3\n[contact]\n" + contact + "\n" +
           (sweep.empty() ? "" : "[sweep]\n" + sweep + "\n");
}

std::vector<double> numbers(const Grid& grid, std::uint64_t index) {
    std::vector<Value> values;
    grid.values(index, values);
    std::vector<double> all;
    for (const Value& value : values) all.push_back(value.number);
    return all;
}

void check_refused(const std::string& text, const std::string& sentence) {
    try {
        static_cast<void>(read_grid(text, "grid.toml"));
        FAIL("is read: " << text);
    } catch (const fstiff::domain_error& error) {
        INFO(error.what());
        CHECK(std::string(error.what()).find(sentence) != std::string::npos);
    }
}

}  // namespace

TEST_CASE("The quantity written last varies fastest, whatever its name") {
    const Grid grid =
        read_grid(grid_text("rms_height = [\"1 um\", \"2 um\"]\npeak_radius = { from = \"10 um\", to = \"30 "
                            "um\", count = 3 }\npeak_density = [\"100 /mm^2\", \"0.0002 /um^2\"]"),
                  "grid.toml");
    REQUIRE(grid.axes.size() == 3);
    CHECK(grid.axes[0].key == "surface.rms_height");
    CHECK(grid.axes[1].key == "surface.peak_radius");
    CHECK(grid.axes[2].key == "surface.peak_density");
    CHECK(grid.axes[2].unit == "1/m^2");
    REQUIRE(grid.size == 12);
    CHECK(numbers(grid, 0) == std::vector<double>{1e-6, 1e-5, 1e8});
    CHECK(numbers(grid, 1) == std::vector<double>{1e-6, 1e-5, 2e8});
    CHECK(numbers(grid, 2) == std::vector<double>{1e-6, 2e-5, 1e8});
    CHECK(numbers(grid, 11) == std::vector<double>{2e-6, 3e-5, 2e8});
    std::set<std::vector<double>> all;
    for (std::uint64_t i = 0; i < grid.size; ++i) all.insert(numbers(grid, i));
    CHECK(all.size() == 12);
}

TEST_CASE("In zip mode the first values are combined, then the second ones") {
    const Grid grid = read_grid(grid_text("rms_height = [\"1 um\", \"2 um\"]",
                                          "pressures = [ { values = [\"1 MPa\", \"3 MPa\"] } ]", "mode = \"zip\""),
                                "grid.toml");
    REQUIRE(grid.size == 2);
    CHECK(grid.axes[1].key == "contact.pressures[0]");
    CHECK(numbers(grid, 1) == std::vector<double>{2e-6, 3e6});
    check_refused(
        grid_text("rms_height = [\"1 um\", \"2 um\"]", "pressures = [ { values = [\"1 MPa\"] } ]", "mode = \"zip\""),
        "has 1 values; mode = \"zip\" must have as many as of surface.rms_height, 2");
}

TEST_CASE("A list of pressures, or a range of them, is many points of one scene and is not swept") {
    for (const char* points : {"pressures = [\"1 MPa\", \"2 MPa\"]", "laws = [\"hertz\"]\npeaks = [\"surface\"]",
                               "pressures = { from = \"1 MPa\", to = \"2 MPa\", count = 3 }"})
        CHECK(read_grid(grid_text("rms_height = \"1 um\"", points), "grid.toml").axes.empty());
}

TEST_CASE("Draws at one point of the grid are adjacent and depend on the index alone") {
    const std::string surface = "rms_height = [\"1 um\", \"2 um\"]\npeak_radius = { normal = [\"40 um\", \"2 um\"] }";
    const std::string contact = "pressures = [ { lognormal = [\"10 MPa\", 0.1] } ]";
    const Grid grid = read_grid(grid_text(surface, contact, "samples = 5\nseed = 3"), "grid.toml");
    REQUIRE(grid.size == 10);
    CHECK(numbers(grid, 4)[0] == 1e-6);
    CHECK(numbers(grid, 5)[0] == 2e-6);
    const Distribution normal{Distribution::Kind::normal, 4e-5, 2e-6}, log{Distribution::Kind::lognormal, 1e7, 0.1};
    CHECK(numbers(grid, 7)[1] == normal.quantile(uniform_draw(3, 7, 0)));
    CHECK(numbers(grid, 7)[2] == log.quantile(uniform_draw(3, 7, 1)));
    const Grid other = read_grid(grid_text(surface, contact, "samples = 5\nseed = 4"), "grid.toml");
    CHECK(numbers(other, 7)[1] != numbers(grid, 7)[1]);
}

TEST_CASE("A lognormal of two quantities has this mean and this standard deviation") {
    const Grid grid = read_grid(
        grid_text("rms_height = { lognormal = [\"2 um\", \"1 um\"] }", "pressures = [\"1 MPa\"]", "samples = 20000"),
        "grid.toml");
    double sum = 0, squares = 0;
    for (std::uint64_t i = 0; i < grid.size; ++i) {
        const double x = numbers(grid, i)[0] * 1e6;
        sum += x, squares += x * x;
    }
    const double n = static_cast<double>(grid.size), mean = sum / n;
    CHECK(std::abs(mean - 2) <
          4 / std::sqrt(n));  // four standard errors; of the deviation more, by the kurtosis of 8.0
    CHECK(std::abs(std::sqrt(squares / n - mean * mean) - 1) < 6 / std::sqrt(n));
}

TEST_CASE("What a program sweeps comes after what the scene sweeps, with numbers in SI") {
    const std::string scene = grid_text("rms_height = \"1 um\"\npeak_density = [\"1 /mm^2\", \"2 /mm^2\"]");
    const Given given{.text =
                          "\"surface.rms_height\" = { values = [1e-6] }\n"
                          "\"contact.pressures[0]\" = { normal = [1e6, 1e4] }\n"
                          "\"material.lower.youngs_modulus\" = [\"70 GPa\"]\n\"sweep.samples\" = 2\n",
                      .numbers = {{"surface.rms_height", {2e-6, 3e-6}}}};
    const Grid grid = read_grid(scene, "scene", given);
    std::vector<std::string> keys;
    for (const Axis& axis : grid.axes) keys.push_back(axis.key);
    CHECK(keys == std::vector<std::string>{"surface.peak_density", "surface.rms_height", "contact.pressures[0]",
                                           "material.lower.youngs_modulus"});
    CHECK(grid.in_si ==
          std::set<std::string>{"surface.rms_height", "contact.pressures[0]", "material.lower.youngs_modulus"});
    REQUIRE(grid.size == 2 * 3 * 2);
    CHECK(numbers(grid, 11)[1] == 3e-6);
    CHECK(numbers(grid, 11)[3] == 7e10);
    for (const char* key : {"contact.pressures[1]", "contact.laws[0]", "surface.rms_height.x", "name[0]"}) {
        INFO(key);
        CHECK(test::refusal([&] {
                  (void)read_grid(scene, "scene", {.text = "\"" + std::string(key) + "\" = [1.5]\n"});
              }) == "scene: " + std::string(key) + ": is no place of the scene");
    }
}

TEST_CASE("Errors of a grid are reported with line, key and value") {
    const auto surface = [](const std::string& rms) { return grid_text("rms_height = " + rms); };
    check_refused(surface("{ from = \"2 um\", to = \"1 um\", count = 3 }"),
                  "grid.toml:2: surface.rms_height.to = \"1 um\": must be greater than surface.rms_height.from");
    check_refused(surface("{ from = \"2 um\", to = \"3 um\" }"), "surface.rms_height.count: is missing");
    check_refused(surface("{ from = \"2 um\", to = \"3 MPa\", count = 3 }"), "\"MPa\" is not a unit of length");
    check_refused(surface("{ from = \"2 um\", to = \"3 um\", count = 1 }"),
                  "must be a whole number from 2 to 9007199254740992");
    check_refused(surface("{ from = \"-2 um\", to = \"3 um\", count = 3, spacing = \"log\" }"),
                  "must be greater than 0");
    check_refused(surface("[\"2 um\", 3]"), "surface.rms_height[1] = 3: must be of the same kind as the first");
    check_refused(surface("[]"), "must be a list of at least one value");
    check_refused(surface("{ values = [] }"), "must be a list of at least one value");
    check_refused(surface("{ normal = [\"2 um\"] }"), "must be a list of the mean and the standard deviation");
    check_refused(surface("{ lognormal = [\"2 um\", \"1 GPa\"] }"), "the standard deviation of the logarithm");
    check_refused(surface("{ lognormal = [\"2 um\", -1] }"), "the standard deviation of the logarithm");
    check_refused(surface("{ uniform = [\"2 um\", \"1 um\"] }"), "must be greater than");
    check_refused(grid_text("rms_height = \"1 um\"", "pressures = [\"1 MPa\"]", "samples = 3"),
                  "sweep.samples = 3: needs a distribution");
    check_refused(grid_text("rms_height = \"1 um\"", "pressures = [\"1 MPa\"]", "mode = \"all\""),
                  "must be one of \"product\", \"zip\"");
    check_refused("name = [\"a\", \"b\"]\n", "cannot be swept");
    check_refused(grid_text("rms_height = { from = 1, to = 2, count = 9000000000000000 }\nalpha = [2, 3]"),
                  "has more than 2^53 scenes");
}

}  // namespace grid_test
