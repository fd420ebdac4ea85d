// SPDX-License-Identifier: BSD-3-Clause
// Every number of a joint through every door: a member that each_field() hands over is a key of a scene with a record,
// a refusal and a suggestion, an axis of a sweep with its unit, and a row of docs/scene.md. The keywords of Python are
// in tests/python/test_answer.py, the names of C in tests/c.
#include <fstiff/answer/joint_fields.hpp>

#include "support/library.hpp"
#include "sweep/grid.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace joint_fields_test {

using namespace fstiff;

namespace {

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
            CHECK((page.find("`" + key + "`") != page.npos || page.find("`surface." + key + "`") != page.npos));

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
        }
    });
    CHECK(count == 16);
}

}  // namespace joint_fields_test
