// SPDX-License-Identifier: BSD-3-Clause
// Every number of a joint through every door: a member that each_field() hands over is a key of a scene with a record,
// a refusal and a suggestion, an axis of a sweep with its unit, and a row of docs/scene.md. The keywords of Python are
// in tests/python/test_answer.py, the names of C in tests/c.
#include <fstiff/answer/joint_fields.hpp>

#include "support/accuracy.hpp"
#include "support/library.hpp"
#include "sweep/grid.hpp"
#include "sweep/lines.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace joint_fields_test {

using namespace fstiff;

namespace {

/// What docs/scene.md calls a quantity in \p unit.
std::string_view kind_of(std::string_view unit) {
    const std::map<std::string_view, std::string_view> kinds{{"1/m^2", "number per area"},
                                                             {"rad", "angle"},
                                                             {"Pa", "pressure"},
                                                             {"kg/m^3", "density"},
                                                             {"m/s", "velocity"},
                                                             {"W/(m K)", "W/(m K)"},
                                                             {"S/m", "S/m"},
                                                             {"Hz", "frequency"},
                                                             {"N", "force"},
                                                             {"Pa/m", "stiffness per area"},
                                                             {"m^2 K/W", "mm^2 K/W"},
                                                             {"ohm m^2", "ohm um^2"}};
    return kinds.at(unit);
}

/// A number that is allowed.
double allowed_number(const NumberFacts& facts) {
    if (facts.row && facts.row->high.value > 0)
        return static_cast<double>((facts.row->low.value + facts.row->high.value) / 2);
    if (facts.high < 1e300) return (facts.low + 3 * facts.high) / 4;
    return facts.low > 0 ? 2 * facts.low : facts.unit == "1/m^2" ? 1e9 : facts.unit == "m" ? 1e-6 : 0.1;
}

std::string written(double value, std::string_view unit) {
    const std::string number = fstiff::document::shortest(value);
    return unit.empty() ? number : "\"" + number + " " + std::string(unit) + "\"";
}

/// The section surface with \p keys, and what they need in addition.
std::string scene_with(std::map<std::string, std::string> keys) {
    const auto has = [&](const std::vector<const char*>& any) {
        return std::any_of(any.begin(), any.end(), [&](const char* key) { return keys.contains(key); });
    };
    const bool skewness = has({"skewness", "Ssk", "Rsk"}), kurtosis = has({"kurtosis", "Sku", "Rku"});
    if (skewness && !kurtosis) keys.emplace("kurtosis", "90");
    if (kurtosis && !skewness) keys.emplace("skewness", "0");
    if (has({"r"})) keys.emplace("theta", "0.7");
    if (has({"theta"})) keys.emplace("r", "0.5");
    if (!has({"rms_height", "Rq", "Sq", "mean_height", "Ra", "Sa"})) keys.emplace("rms_height", "\"0.8 um\"");
    std::string text = "[surface]\n";
    for (const auto& [key, value] : keys) text += key + " = " + value + "\n";
    return text + "[contact]\npressures = [\"10 MPa\"]\n";
}

/// \p page has a row of \p key, whose first cell names it, whose second has its kind, and whose third has its range.
void check_row(const std::string& page, const std::string& section, const std::string& key, const NumberFacts& facts) {
    std::string row;
    std::istringstream lines(page);
    for (std::string line; row.empty() && std::getline(lines, line);) {
        const std::string first = line.substr(0, line.find('|', 1));
        const auto names = [&](const char* before) { return first.find(before + key + "`") != first.npos; };
        if (line.starts_with("| `" + section) && (names(".") || names("`"))) row = line;
    }
    INFO(section << key << ": " << row);
    REQUIRE(!row.empty());
    const std::string kind = facts.unit.empty()  ? "number"
                             : facts.unit == "m" ? "length"
                                                 : std::string(kind_of(facts.unit));
    CHECK(row.find(kind) != row.npos);
    if (!facts.row && facts.high > 1e300 && facts.low > -1e300)
        CHECK(row.find((facts.low_too ? ">= " : "> ") + fstiff::document::shortest(facts.low)) != row.npos);
}

/// A scene that is resolved with the numbers of the next one has the lines of one that is read.
void check_lines(const sweep::Grid& grid) {
    sweep::SceneMaker maker(grid);
    sweep::SceneMaker::Work work;
    const std::string together = lines_of(grid, block_of(grid, maker, work, 0, grid.size));
    std::string alone;
    for (std::uint64_t i = 0; i < grid.size; ++i) {
        sweep::SceneMaker::Work own;
        alone += lines_of(grid, block_of(grid, maker, own, i, 1));
    }
    CHECK(together == alone);
    CHECK(together.find("stiffness_Pa_per_m") != std::string::npos);
}

std::string refusal_of(const std::string& text) {
    try {
        (void)scene::read_scene(text, {.name = "scene.toml"});
    } catch (const domain_error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("every number of a face is a key, a record, a refusal, a suggestion, an axis and a row of the page") {
    const std::string page = test::read(FSTIFF_SCENES "/../docs/scene.md");
    const JointFace face;
    std::size_t count = 0;
    each_field(face, [&](std::string_view name, const auto&, const NumberFacts& facts) {
        ++count;
        std::vector<std::string_view> keys{name};
        keys.insert(keys.end(), facts.words.begin(), facts.words.end());
        const double number = allowed_number(facts);
        for (const std::string_view each : keys) {
            const std::string key(each);
            INFO(key);
            const scene::Scene read =
                scene::read_scene(scene_with({{key, written(number, facts.unit)}}), {.name = "scene.toml"});
            bool recorded = false;
            for (const auto& input : read.inputs)
                recorded = recorded || (input.key == "surface." + key && input.value &&
                                        std::abs(*input.value / number - 1) < 1e-15 && input.unit == facts.unit);
            CHECK(recorded);
            check_row(page, "surface.", key, facts);

            // out of its range, in another unit, misspelt
            const double wrong = facts.low < 0 ? 10 * facts.high : -1;
            CHECK(refusal_of(scene_with({{key, written(wrong, facts.unit)}})).find("surface." + key) !=
                  std::string::npos);
            CHECK(refusal_of(scene_with({{key, "\"1 kg\""}})).find("surface." + key + " = \"1 kg\"") !=
                  std::string::npos);
            if (key.size() > 5)
                CHECK(refusal_of(scene_with({{key.substr(0, 3) + key.substr(4), written(number, facts.unit)}}))
                          .find("did you mean " + key) != std::string::npos);

            const sweep::Grid grid = sweep::read_grid(
                scene_with({{key, "[" + written(number, facts.unit) + ", " + written(0.9 * number, facts.unit) + "]"}}),
                "grid.toml");
            REQUIRE(grid.axes.size() == 1);
            CHECK(grid.axes[0].key == "surface." + key);
            CHECK(grid.axes[0].unit == facts.unit);
            CHECK(grid.axes[0].numbers == std::vector{number, 0.9 * number});
            check_lines(grid);
        }
    });
    CHECK(count == 16);
}

TEST_CASE("every number of bodies, waves, friction and the gap is a key, a refusal, an axis and a row of the page") {
    const std::string page = test::read(FSTIFF_SCENES "/../docs/scene.md");
    const auto check = [&](const std::string& section, const auto& owner, std::string_view ends_with = "") {
        each_field(owner, [&](std::string_view name, const auto&, const NumberFacts& facts) {
            if (!name.ends_with(ends_with)) return;
            const std::string path = section + "." + std::string(name);
            INFO(path);
            const auto text = [&](const std::string& value) {
                std::map<std::string, std::string> sections{{"material.upper", "name = \"steel\"\n"},
                                                            {"friction", "coefficient = 0.2\n"},
                                                            {"ultrasound", "frequency = \"5 MHz\"\n"},
                                                            {"gap", "conductivity = \"0.03 W/(m K)\"\n"}};
                std::string& own = sections.at(section);
                if (own.starts_with(name)) own.clear();
                own += std::string(name) + " = " + value + "\n";
                std::string all = "[surface]\nRa = \"0.8 um\"\n[contact]\npressures = [\"10 MPa\"]\n";
                for (const auto& [each, keys] : sections)
                    if (each == section || each == "material.upper") all += "[" + each + "]\n" + keys;
                return all;
            };
            const double number = name == "youngs_modulus"  ? 205e9
                                  : name == "poisson_ratio" ? 0.3
                                  : facts.unit == "Pa"      ? 2e9
                                                            : 5 * std::min(1.0, allowed_number(facts));
            const scene::Scene read = scene::read_scene(text(written(number, facts.unit)), {.name = "scene.toml"});
            CHECK(std::any_of(read.inputs.begin(), read.inputs.end(), [&](const auto& input) {
                return input.key == path && input.value && std::abs(*input.value / number - 1) < 1e-15;
            }));
            CHECK(refusal_of(text(written(-2, facts.unit))).find(path) != std::string::npos);
            CHECK(refusal_of(text("\"1 mol\"")).find(path + " = \"1 mol\"") != std::string::npos);
            const sweep::Grid grid = sweep::read_grid(
                text("[" + written(number, facts.unit) + ", " + written(0.9 * number, facts.unit) + "]"), "grid.toml");
            REQUIRE(grid.axes.size() == 1);
            CHECK(grid.axes[0].unit == facts.unit);
            check_lines(grid);
            check_row(page, section == "material.upper" ? "material." : section + ".", std::string(name), facts);
        });
    };
    check("material.upper", Body());
    check("friction", Friction());
    check("ultrasound", UltrasonicWaves());
    check("gap", GapFilling<double>());
    check("gap", Conduction(), "_film");
}

namespace {

/// Number of \p scene at \p key, with its unit.
std::optional<double> recorded_number(const scene::Scene& scene, const std::string& key, std::string_view unit) {
    for (const auto& input : scene.inputs)
        if (input.key == key && input.unit == unit) return input.value;
    return std::nullopt;
}

std::string scene_of_load(const std::string& keys) {
    return "[surface]\nRa = \"0.8 um\"\n[output]\nquantities = [\"stiffness\", \"approach\"]\n[contact]\n" + keys;
}

}  // namespace

TEST_CASE("every kind of points is a key, a record, a refusal, a suggestion, an axis and a row of the page") {
    const std::string page = test::read(FSTIFF_SCENES "/../docs/scene.md");
    std::vector<std::string> all;
    const detail::Load load;
    detail::each_points(load, [&](std::string_view name, const auto&, const NumberFacts& facts) {
        std::vector<std::string_view> keys{name};
        keys.insert(keys.end(), facts.words.begin(), facts.words.end());
        for (const std::string_view each : keys) {
            const std::string key(all.emplace_back(each)), path = "contact." + key;
            INFO(key);
            const double number = facts.unit == "Pa" ? 1e7 : facts.unit == "N" ? 1000 : 1.5e-6;
            const std::string one = written(number, facts.unit), two = written(0.9 * number, facts.unit);
            const auto text = [&](const std::string& value) {
                return scene_of_load("nominal_area = \"100 mm^2\"\n" + key + " = " + value + "\n");
            };
            const scene::Scene read = scene::read_scene(text("[" + two + ", " + one + "]"), {.name = "scene.toml"});
            CHECK(recorded_number(read, path + "[1]", facts.unit) == number);
            CHECK(read.points == (facts.unit == "N" ? std::vector{0.9 * number / 1e-4, number / 1e-4}
                                                    : std::vector{0.9 * number, number}));
            CHECK(read.at_separations == (facts.unit == "m"));
            check_row(page, "contact.", key, facts);

            CHECK(refusal_of(text(written(-1, facts.unit))).find(path) == (facts.low == 0 ? 14 : std::string::npos));
            CHECK(refusal_of(text("\"1 kg\"")).find(path + " = \"1 kg\"") != std::string::npos);
            if (key.size() > 5)
                CHECK(refusal_of(scene_of_load(key.substr(0, 3) + key.substr(4) + " = " + one))
                          .find("did you mean " + key) != std::string::npos);

            const std::string list = "[" + two + ", " + one + "]", range = "{ from = " + two + ", to = " + one;
            for (const auto& [axis, value] :
                 {std::pair(path + "[0]", "[" + list + "]"), std::pair(path, "{ values = " + list + " }")}) {
                const sweep::Grid grid = sweep::read_grid(text(value), "grid.toml");
                REQUIRE(grid.axes.size() == 1);
                CHECK(grid.axes[0].key == axis);
                CHECK(grid.axes[0].unit == facts.unit);
                CHECK(grid.axes[0].numbers == std::vector{0.9 * number, number});
                check_lines(grid);
            }
            const scene::Range spaced =
                *sweep::read_grid(text("[" + range + ", count = 3 }]"), "grid.toml").axes.at(0).range;
            CHECK(spaced.log == (facts.low == 0));
            const auto points = scene::read_scene(text(range + ", count = 3 }"), {.name = "scene.toml"}).points;
            CHECK(points[1] == (facts.unit == "N" ? spaced.at(1) / 1e-4 : spaced.at(1)));
        }
    });
    CHECK(all == std::vector<std::string>{"pressures", "pressure", "separations", "force"});
    for (const std::string& one : all)
        for (const std::string& other : all)
            if (one < other)
                CHECK(refusal_of(scene_of_load(one + " = \"1 MPa\"\n" + other + " = \"1 MPa\"\n"))
                          .find("must not be given with contact.") != std::string::npos);
}

TEST_CASE("every number of a load is a key, a record, a refusal, a suggestion, an axis and a row of the page") {
    const std::string page = test::read(FSTIFF_SCENES "/../docs/scene.md");
    std::vector<std::string> all;
    const detail::Load load;
    each_field(load, [&](std::string_view name, const auto&, const NumberFacts& facts) {
        const std::string key(all.emplace_back(name)), path = "contact." + key;
        INFO(key);
        const bool is_ball = key == "ball_radius";
        const auto text = [&](const std::string& value, const std::string& as) {
            return scene_of_load((is_ball ? "force = \"10 N\"\n" : "pressures = [\"10 MPa\"]\n") + as + " = " + value);
        };
        const double number = is_ball ? 0.01 : 2e3;
        const std::string one = written(number, facts.unit), two = written(0.9 * number, facts.unit);
        const scene::Scene read = scene::read_scene(text(one, key), {.name = "scene.toml"});
        CHECK(recorded_number(read, path, facts.unit) == number);
        CHECK((is_ball ? read.ball->radius : read.seating) == number);
        check_row(page, "contact.", key, facts);
        CHECK(refusal_of(text(written(-1, facts.unit), key)).find(path) != std::string::npos);
        CHECK(refusal_of(text("\"1 kg\"", key)).find(path + " = \"1 kg\"") != std::string::npos);
        CHECK(refusal_of(text(one, key.substr(0, 3) + key.substr(4))).find("did you mean " + key) != std::string::npos);

        const sweep::Grid grid = sweep::read_grid(text("[" + two + ", " + one + "]", key), "grid.toml");
        REQUIRE(grid.axes.size() == 1);
        CHECK(grid.axes[0].key == path);
        CHECK(grid.axes[0].unit == facts.unit);
        CHECK(grid.axes[0].numbers == std::vector{0.9 * number, number});
        if (is_ball)
            CHECK(test::refusal([&] { sweep::SceneMaker maker(grid); }) ==
                  "grid.toml: contact.ball_radius: is for fstiff run; a sweep has the faces alone");
        else
            check_lines(grid);
    });
    CHECK(all == std::vector<std::string>{"seating", "ball_radius"});
}

}  // namespace joint_fields_test
