// SPDX-License-Identifier: BSD-3-Clause
// [surface.upper] and [surface.lower]: two rough faces as one.
#include "json.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/topography/shifted_sum.hpp>

#include <cmath>

namespace two_faces_test {

namespace {

const std::string rest =
    "[material.upper]\nyoungs_modulus = \"210 GPa\"\npoisson_ratio = 0.3\n"
    "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\n";

const std::string numbers =
    "rms_height = \"0.8 um\"\npeak_radius = \"40 um\"\npeak_density = \"900 /mm^2\"\nfractal_dimension = 1.3\nr = "
    "0.5\ntheta = 0.6\n";

std::string map_text(int seed, const std::string& rms) {
    return test::run_fstiff("generate map --points 192 --spacing '1 um' --hurst 0.8 --rms '" + rms +
                        "' --shortest '8 um' --longest '60 um' --seed " + std::to_string(seed))
        .out;
}

}  // namespace

TEST_CASE("a face beside a smooth one is [surface], and says so") {
    const test::Folder folder;
    const auto alone = folder.write("alone.toml", "[surface]\n" + numbers + rest);
    const auto upper = folder.write("upper.toml", "[surface.upper]\n" + numbers + rest);
    const auto one = test::run_fstiff("run " + alone + " --format csv"),
               same = test::run_fstiff("run " + upper + " --format csv");
    REQUIRE(one.status == 0);
    CHECK(one.out == same.out);
    CHECK(
        test::json_of("run " + alone + " --format json")["inputs"]["surface.lower"]["written"].get<std::string>().find(
            "smooth") == 0);
    CHECK(test::contains(test::run_fstiff("run " + alone).out, "the other face smooth"));
}

TEST_CASE("two equal faces are one of sqrt(2) the heights, with the same peaks a unit of area") {
    const test::Folder folder;
    const auto two = folder.write("two.toml", "[surface.upper]\n" + numbers + "[surface.lower]\n" + numbers + rest);
    const auto as_one =
        folder.write("one.toml",
                     "[surface]\nrms_height = \"1.1313708498984762 um\"\npeak_radius = \"28.284271247461902 um\"\n"
                     "peak_density = \"900 /mm^2\"\nfractal_dimension = 1.3\nr = 0.5\ntheta = 0.6\n" +
                         rest);
    const auto a = test::run_fstiff("run " + two + " --format json"), b = test::run_fstiff("run " + as_one + " --format json");
    REQUIRE(a.status == 0);
    const auto rows = nlohmann::json::parse(a.out)["rows"], truth = nlohmann::json::parse(b.out)["rows"];
    REQUIRE(rows.size() == truth.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double k = rows[i]["stiffness_Pa_per_m"], of = truth[i]["stiffness_Pa_per_m"];
        CHECK(std::abs(k - of) < 1e-10 * of);
    }
    CHECK(!test::contains(test::run_fstiff("run " + two).out, "the other face smooth"));
}

TEST_CASE("two maps: what is measured of both adds up to what is measured of their sum, within the errors") {
    const test::Folder folder;
    const auto upper = folder.write("upper.txt", map_text(3, "1 um")),
               lower = folder.write("lower.txt", map_text(4, "0.6 um"));
    const auto a = fstiff::io::read_surface(std::filesystem::path(upper)).map(),
               b = fstiff::io::read_surface(std::filesystem::path(lower)).map();
    const auto sum = fstiff::shifted_sum(a, b, 0, 0);
    std::ostringstream text;
    text.precision(17);
    for (Eigen::Index j = 0; j < sum.rows(); ++j)
        for (Eigen::Index i = 0; i < sum.columns(); ++i)
            text << static_cast<double>(i) * sum.dx << ' ' << static_cast<double>(j) * sum.dy << ' '
                 << sum.heights(j, i) << '\n';
    const auto measured =
        test::json_of("measure " + folder.write("sum.txt", text.str()) + " --units m --peaks summits")["surface"];
    const auto scene = folder.write("scene.toml",
                                    "[surface.upper]\nfrom = \"upper.txt\"\npeaks = \"summits\"\n"
                                    "[surface.lower]\nfrom = \"lower.txt\"\npeaks = \"summits\"\n" +
                                        rest +
                                        "laws = [\"hertz\", \"persson\", \"hybrid\", \"summits\", "
                                        "\"boundary_elements\"]\n");
    const auto document = test::json_of("run " + scene + " --format json");
    for (const char* key : {"rms_height", "peak_radius", "peak_density", "r", "theta"}) {
        const double added = document["inputs"]["surface." + std::string(key) + " (of the sum)"]["value"];
        const double found = measured[key]["value"], error = measured[key]["error"];
        INFO(key << ": added " << added << ", of the sum " << found << " +- " << error);
        CHECK(std::abs(added - found) < 3 * error);
        CHECK(std::abs(added - found) < 0.1 * found);
    }
    // K of the added heights at random shifts against K of the one shift of 0 that was measured
    const auto whole = folder.write("whole.toml", "[surface]\nfrom = \"sum.txt\"\nunits = \"m\"\n" + rest +
                                                      "laws = [\"hybrid\", \"summits\", \"boundary_elements\"]\n");
    const auto of_sum = test::json_of("run " + whole + " --format json")["rows"];
    int compared = 0;
    for (const auto& row : document["rows"])
        for (const auto& truth : of_sum)
            if (row["law"] == truth["law"] && row["pressure_Pa"] == truth["pressure_Pa"] && row["pressure_Pa"] == 1e7) {
                const double k = row["stiffness_Pa_per_m"], one = truth["stiffness_Pa_per_m"];
                const double scatter = row["stiffness_error_Pa_per_m"];  // of one shift about the mean
                INFO(row["law"] << ": " << k << " +- " << scatter << " over shifts, " << one << " at one");
                CHECK(std::abs(k - one) < 3 * scatter);
                CHECK(scatter > 0.02 * k);
                CHECK(scatter < 0.5 * k);
                ++compared;
            }
    CHECK(compared == 3);
    CHECK(document["surface"]["upper"]["measured"]["rms_height"]["value"] > 0.9e-6);
    CHECK(document["surface"]["lower"]["measured"]["rms_height"]["value"] < 0.7e-6);
}

TEST_CASE("what two faces cannot have is told in one sentence") {
    const test::Folder folder;
    const auto refused = [&](const std::string& surface, const std::string& sentence, const std::string& more = "") {
        const auto outcome = test::run_fstiff("run " + folder.write("scene.toml", surface + rest + more));
        INFO(outcome.err);
        CHECK(outcome.status == 3);
        CHECK(test::contains(outcome.err, sentence));
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
