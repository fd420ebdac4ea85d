// SPDX-License-Identifier: BSD-3-Clause
// Lines of results. Truth: every scene of the grid read from its own table and computed by itself.
#include "sweep/lines.hpp"

#include "actions/answered.hpp"
#include "scene/readers.hpp"
#include "support/catch.hpp"
#include "sweep/template.hpp"

#include <nlohmann/json.hpp>

#include <sstream>

namespace lines_test {

using namespace fstiff::sweep;
using namespace fstiff;

namespace {

/// Numbers that are put into a scene that was read before, numbers and texts for which it is read anew, a draw, and a D
/// that no scene may have.
const std::string text =
    "[surface]\nrms_height = [\"0.5 um\", \"1 um\"]\npeak_radius = { lognormal = [\"40 um\", 0.2] }\n"
    "peak_density = \"500 /mm^2\"\nfractal_dimension = { values = [1.3, 1.995, 1.62] }\n"
    "errors = { rms_height = \"0.05 um\" }\n[material.upper]\n"
    "youngs_modulus = { from = \"100 GPa\", to = \"210 GPa\", count = 2 }\npoisson_ratio = { values = [0.2, 0.4] }\n"
    "[uncertainty]\nsamples = 20\n[contact]\nlaws = [\"hertz\", \"fractal\"]\npeaks = [ { theta = 1, r = 0.5 } ]\n"
    "pressures = [ { values = [\"1 MPa\", \"3 MPa\"] } ]\n[sweep]\nsamples = 2\n";

}  // namespace

TEST_CASE("The lines of a grid are those of its scenes, each read and computed by itself") {
    const Grid grid = read_grid(text, "grid.toml");
    REQUIRE(grid.size == 2 * 3 * 2 * 2 * 2 * 2);
    SceneMaker maker(grid);
    SceneMaker::Work work;
    const Block block = block_of(grid, maker, work, 0, grid.size);
    CHECK(block.failed == grid.size / 3);
    std::istringstream lines(lines_of(grid, block));
    std::vector<Value> values;
    for (std::uint64_t index = 0; index < grid.size; ++index) {
        grid.values(index, values);
        std::string line;
        try {
            const scene::Scene slow = scene::read_table(table_of(grid, values), {.name = grid.file});
            const actions::Answered answered = actions::compute(slow);
            for (const AnswerCurve& curve : answered.curves()) {
                REQUIRE(std::getline(lines, line));
                const auto row = nlohmann::json::parse(line);
                INFO(line);
                CHECK(row["index"] == index);
                CHECK(row["law"] == fstiff::name_of(curve.law));
                for (const scene::NumberOf& column : slow.columns(answered.has_band()))
                    if (const double value = column(curve.points.at(0)); !std::isnan(value))
                        CHECK(row[column.key()] == value);
            }
        } catch (const fstiff::domain_error& error) {
            REQUIRE(std::getline(lines, line));
            CHECK(nlohmann::json::parse(line)["error"] == error.what());
        }
    }
    std::string rest;
    CHECK_FALSE(std::getline(lines, rest));
}

}  // namespace lines_test
