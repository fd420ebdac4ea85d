// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/engine.hpp"

#include "support/catch.hpp"

#include <fstiff/core/error.hpp>

#include <new>
#include <stdexcept>

namespace engine_test {

using namespace fstiff::sweep;

namespace {

/// Moduli that are put into a scene, ratios for which it is read anew, draws, and a pressure that is out of reach.
const std::string text =
    "[surface]\nrms_height = [\"0.5 um\", \"1 um\"]\npeak_radius = { lognormal = [\"40 um\", 0.2] }\n"
    "peak_density = \"500 /mm^2\"\n[material.upper]\nyoungs_modulus = { from = \"100 GPa\", to = \"210 GPa\", count = "
    "3 }\n"
    "poisson_ratio = { from = 0.2, to = 0.4, count = 20 }\n[contact]\nlaws = [\"hertz\"]\npeaks = [ { theta = 1, r = "
    "0.5 } ]\n"
    "pressures = [ { values = [\"1 MPa\", \"1e20 MPa\", \"3 MPa\"] } ]\n[sweep]\nsamples = 2\n";

struct Collected {
    std::string text;
    std::uint64_t next = 0, failed = 0;
    unsigned threads = 0;
};

/// The lines of \p rows; memory ends once at each of the scenes \p full.
Collected collected(const Grid& grid, Rows rows, unsigned threads, std::vector<std::uint64_t> full = {}) {
    SceneMaker maker(grid);
    Collected all;
    all.next = rows.first;
    all.threads = run(grid, maker, rows, {.threads = threads}, [&](const Block& block) {
        CHECK(block.first == all.next);
        CHECK(block.rows.empty());
        if (!full.empty() && block.end > full.back()) {
            full.pop_back();
            throw std::bad_alloc();
        }
        all.text += block.lines;
        all.next = block.end;
        all.failed += block.failed;
    });
    return all;
}

}  // namespace

TEST_CASE("Any number of threads hands over the same lines in the order of the scenes", "[threads]") {
    const Grid grid = read_grid(text, "grid.toml");
    REQUIRE(grid.size == 2 * 3 * 20 * 3 * 2);
    const Collected one = collected(grid, {0, grid.size}, 1);
    CHECK(one.next == grid.size);
    CHECK(one.failed == grid.size / 3);
    for (const unsigned threads : {2U, 3U, 8U}) {
        const Collected many = collected(grid, {0, grid.size}, threads);
        CHECK(many.text == one.text);
        CHECK(many.failed == one.failed);
        CHECK(many.threads == threads);
    }
    // as two parts, wherever they are parted
    for (const std::uint64_t middle : {std::uint64_t(1), std::uint64_t(7), grid.size / 2})
        CHECK(collected(grid, {0, middle}, 2).text + collected(grid, {middle, grid.size}, 3).text == one.text);
    // where memory ends, fewer threads go on with the same scenes
    const Collected fewer = collected(grid, {0, grid.size}, 8, {500, 3});
    CHECK(fewer.text == one.text);
    CHECK(fewer.threads == 2);
    CHECK_THROWS_AS(collected(grid, {0, grid.size}, 2, {600, 3}), std::bad_alloc);
}

TEST_CASE("What the receiver throws ends all threads and reaches the caller", "[threads]") {
    const Grid grid = read_grid(text, "grid.toml");
    SceneMaker maker(grid);
    CHECK_THROWS_AS(
        run(grid, maker, {0, grid.size}, {.threads = 3}, [](const Block&) { throw std::runtime_error("full"); }),
        std::runtime_error);
}

}  // namespace engine_test
