// SPDX-License-Identifier: BSD-3-Clause
// fstiff sweep as people run it.
#include "cli/command.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <map>
#include <regex>
#include <set>

namespace sweep_test {

using namespace test;

namespace {

/// A line of results: keys and the very characters of their values, in their order.
using Line = std::vector<std::pair<std::string, std::string>>;

Line fields(const std::string& line) {
    Line all;
    const std::regex field("\"([^\"]*)\":(\"(?:[^\"\\\\]|\\\\.)*\"|[^,}]*)");
    for (std::sregex_iterator i(line.begin(), line.end(), field), end; i != end; ++i)
        all.emplace_back((*i)[1], (*i)[2]);
    return all;
}

std::string value(const Line& line, const std::string& key) {
    for (const auto& [name, text] : line)
        if (name == key) return text;
    throw std::runtime_error("the line has no " + key);
}

const std::string grid =
    "[surface]\n"
    "rms_height = { from = \"0.5 um\", to = \"2 um\", count = 7, spacing = \"log\" }\n"
    "peak_radius = [\"20 um\", \"40 um\"]\n"
    "peak_density = \"500 /mm^2\"\n"
    "fractal_dimension = 1.62\n"
    "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
    "[contact]\n"
    "laws = [\"hertz\", \"fractal\"]\n"
    "peaks = [ { theta = \"pi/3\", r = 0.5 } ]\n"
    "pressures = [ { from = \"0.1 MPa\", to = \"100 MPa\", count = 11 } ]\n";

/// A scene in which every quantity may be swept, with \p key replaced by \p written.
std::string scene_with(const std::string& key, const std::string& written) {
    const std::string scene =
        "[surface]\nrms_height = \"0.832 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n"
        "fractal_dimension = 1.62\nr = 0.4\ntheta = 1.0\nalpha = 6.0\n"
        "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\nyield_strength = \"400 MPa\"\n"
        "[material.lower]\nlower_modulus = \"70 GPa\"\nlower_ratio = 0.33\n"
        "[contact]\nnominal_area = \"195 mm^2\"\nlaws = [\"hertz\", \"fractal\", \"plastic\"]\npeaks = \"surface\"\n"
        "interaction = { reading = \"effective_separation\", length = \"nominal\" }\n"
        "pressures = [ \"3 MPa\", \"30 MPa\" ]\n"
        "[ultrasound]\nfrequency = \"7 MHz\"\nupper = { impedance = \"46 MRayl\" }\n";
    const auto changed = key == "pressures" ? std::regex_replace(scene, std::regex("\"3 MPa\""), written)
                                            : std::regex_replace(scene, std::regex("(^|\n)" + key + " = [^\n]*"),
                                                                 "$1" + key + " = " + written);
    if (changed == scene) throw std::runtime_error("the scene has no " + key);
    return std::regex_replace(std::regex_replace(changed, std::regex("lower_modulus"), "youngs_modulus"),
                              std::regex("lower_ratio"), "poisson_ratio");
}

/// Checks that every line of \p results holds what `fstiff run --format csv` prints of the scene that \p of makes of
/// it.
template <class Of>
void check_as_run(const std::string& results, const Of& of, std::size_t every = 1) {
    std::map<std::string, std::vector<Line>> by_index;
    for (const std::string& line : lines(results)) {
        const Line all = fields(line);
        by_index[value(all, "index")].push_back(all);
    }
    std::size_t at = 0;
    for (const auto& [index, rows] : by_index) {
        if (at++ % every != 0) continue;
        const Outcome run = run_fstiff("run - --format csv", of(rows.front()));
        INFO("scene " << index << ": " << run.err);
        REQUIRE((run.status == 0 || run.status == 4));
        auto csv = lines(run.out);
        if (!contains(lines(results).front(),
                      "\"answer\":1"))  // the laws that are named, without the answer above them
            std::erase_if(csv, [](const std::string& line) { return line.ends_with(",1"); });
        REQUIRE(csv.size() == rows.size() + 1);
        for (std::size_t row = 0; row < rows.size(); ++row) {
            std::istringstream header(csv[0]), cells(csv[row + 1] + ",");
            std::size_t columns = 0;
            for (std::string key, cell; std::getline(header, key, ',') && std::getline(cells, cell, ','); ++columns) {
                const std::string text = key == "law" ? "\"" + cell + "\"" : cell.empty() ? "null" : cell;
                INFO(key);
                const bool of_answer = key == "answer" || contains(key, "_p05") || contains(key, "_p95");
                if (!of_answer || (!cell.empty() && cell != "0")) CHECK(value(rows[row], key) == text);
            }
            CHECK(columns >= 5);
        }
    }
}

}  // namespace

TEST_CASE("Each line of a sweep has the digits of fstiff run of that scene, for every quantity that may be swept") {
    const std::vector<std::array<std::string, 3>> swept{
        {"rms_height", "{ from = \"0.5 um\", to = \"2 um\", count = 3 }", " m"},
        {"peak_radius", "[\"20 um\", \"35 um\"]", " m"},
        {"peak_density", "{ values = [\"100 /mm^2\", \"700 /mm^2\"] }", " 1/m^2"},
        {"fractal_dimension", "{ from = 1.2, to = 1.7, count = 3 }", ""},
        {"theta", "{ from = \"0.9 rad\", to = \"60 deg\", count = 2 }", " rad"},
        {"r", "[0.1, 0.6]", ""},
        {"alpha", "[2, 6.5]", ""},
        {"youngs_modulus", "{ from = \"100 GPa\", to = \"210 GPa\", count = 3 }", " Pa"},
        {"lower_modulus", "{ lognormal = [\"70 GPa\", 0.1] }", " Pa"},
        {"poisson_ratio", "{ uniform = [0.2, 0.4] }", ""},
        {"yield_strength", "[\"300 MPa\", \"500 MPa\"]", " Pa"},
        {"nominal_area", "[\"100 mm^2\", \"200 mm^2\"]", " m^2"},
        {"pressures", "{ from = \"1 MPa\", to = \"100 MPa\", count = 3 }", " Pa"},
        {"frequency", "{ normal = [\"7 MHz\", \"1 MHz\"] }", " Hz"}};
    for (const auto& [key, written, unit] : swept) {
        const Folder folder;
        const bool draws = contains(written, "normal") || contains(written, "uniform");
        const std::string file =
            folder.write("grid.toml", scene_with(key, written) + (draws ? "[sweep]\nsamples = 3\n" : ""));
        const Outcome outcome = run_fstiff("sweep '" + file + "' -o '" + folder / "out" + "' --threads 1");
        INFO(key << ": " << outcome.err);
        REQUIRE(outcome.status == 0);
        check_as_run(read(folder / "out"), [&, name = key, si = unit](const Line& line) {
            const std::string number = line.at(1).second;
            return scene_with(name, si.empty() ? number : "\"" + number + si + "\"");
        });
    }
}

TEST_CASE("A grid that names no law has the answer, of soft and of hard bodies by one law") {
    const auto scene = [](const std::string& strength) {
        return "[surface]\nrms_height = \"0.5 um\"\nrms_gradient = 0.1\nalpha = 5\n"
               "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\nyield_strength = " +
               strength + "\n[contact]\npressures = [\"3 MPa\", \"30 MPa\"]\n";
    };
    const Folder folder;
    const std::string file = folder.write("grid.toml", scene("[\"100 MPa\", \"9 GPa\"]"));
    const Outcome outcome = run_fstiff("sweep '" + file + "' -o '" + folder / "out" + "' --threads 1");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const std::string results = read(folder / "out");
    CHECK(contains(lines(results).front(), "\"law\":\"plastic\""));
    CHECK(contains(lines(results).back(), "\"law\":\"plastic\""));
    CHECK(contains(results, "\"stiffness_p05_Pa_per_m\":"));
    check_as_run(results, [&](const Line& line) { return scene("\"" + line.at(1).second + " Pa\""); });
}

TEST_CASE(
    "A grid carries the conductances with their bands, and its gaps may be filled with one medium after the other") {
    const auto scene = [](const std::string& medium) {
        return "material = { upper = \"steel\", lower = \"aluminium\" }\n[surface]\nrms_height = \"0.5 um\"\n"
               "rms_gradient = 0.1\n[contact]\npressures = [\"3 MPa\", \"30 MPa\"]\n[gap]\nmedium = " +
               medium + "\n";
    };
    const Folder folder;
    const std::string file = folder.write("grid.toml", scene("[\"air\", \"helium\", \"vacuum\"]"));
    const Outcome outcome = run_fstiff("sweep '" + file + "' -o '" + folder / "out" + "' --threads 1");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const std::string results = read(folder / "out");
    for (const char* end : {"", "_p05", "_p95"})
        CHECK(contains(lines(results).front(), "\"thermal_conductance" + std::string(end) + "_W_per_m2K\":"));
    CHECK(contains(lines(results).back(), "\"thermal_conductance_gap_W_per_m2K\":0,"));
    check_as_run(results, [&](const Line& line) { return scene(line.at(1).second); });
}

TEST_CASE("Words and tables may be swept, and are in the lines as texts") {
    const Folder folder;
    const std::string text = scene_with("laws", "[ { values = [\"hertz\", \"plastic\"] } ]");
    const std::string file = folder.write(
        "grid.toml",
        replaced(text, "peaks = \"surface\"",
                 "peaks = { values = [\"surface\", [ { theta = 1, r = 0.2 }, { theta = 0.9, r = 0 } ]] }"));
    REQUIRE(run_fstiff("sweep '" + file + "' -o '" + folder / "out" + "'").status == 0);
    const auto all = lines(read(folder / "out"));
    REQUIRE(all.size() == 2 * (1 + 2) * 2);  // laws, peaks, points
    CHECK(value(fields(all[0]), "contact.laws[0]") == "\"hertz\"");
    CHECK(value(fields(all[0]), "contact.peaks") == "\"surface\"");
    CHECK(value(fields(all[2]), "contact.peaks") == "\"[{r = 0.2, theta = 1}, {r = 0, theta = 0.9}]\"");
    CHECK(value(fields(all[11]), "contact.laws[0]") == "\"plastic\"");
    check_as_run(read(folder / "out"), [&](const Line& line) {
        std::string peaks = value(line, "contact.peaks");
        if (peaks != "\"surface\"") peaks = peaks.substr(1, peaks.size() - 2);
        return replaced(scene_with("laws", "[" + value(line, "contact.laws[0]") + "]"), "peaks = \"surface\"",
                        "peaks = " + peaks);
    });
}

TEST_CASE("Measured files may be swept") {
    const Folder folder;
    for (const char* seed : {"1", "2"})
        REQUIRE(run_fstiff("generate profile --hurst 0.8 --rms '1 um' --points 2000 --spacing '1 um' --seed " +
                           std::string(seed) + " -o '" + folder / ("trace" + std::string(seed) + ".csv") + "'")
                    .status == 0);
    const std::string text =
        "[surface]\nfrom = { values = [\"trace1.csv\", [\"trace1.csv\", \"trace2.csv\"]] }\n"
        "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
        "[contact]\nlaws = [\"hertz\"]\npressures = [ { values = [\"1 MPa\", \"10 MPa\"] } ]\n[uncertainty]\nsamples = "
        "0\n";
    const std::string file = folder.write("grid.toml", text);
    const Outcome outcome = run_fstiff("sweep '" + file + "' -o '" + folder / "out" + "'");
    INFO(outcome.err);
    REQUIRE(outcome.status == 0);
    const auto all = lines(read(folder / "out"));
    REQUIRE(all.size() == 4);
    CHECK(value(fields(all[3]), "surface.from") == "\"[trace1.csv, trace2.csv]\"");
    const auto scene = [&](const std::string& from, const std::string& pressure) {
        const std::string by_hand =
            replaced(replaced(text, "{ values = [\"trace1.csv\", [\"trace1.csv\", \"trace2.csv\"]] }", from),
                     "{ values = [\"1 MPa\", \"10 MPa\"] }", pressure);
        return lines(run_fstiff("run '" + folder.write("hand.toml", by_hand) + "' --format csv").out).back();
    };
    CHECK(contains(scene("\"trace1.csv\"", "\"10 MPa\""), value(fields(all[1]), "stiffness_Pa_per_m")));
    CHECK(
        contains(scene("[\"trace1.csv\", \"trace2.csv\"]", "\"1 MPa\""), value(fields(all[2]), "stiffness_Pa_per_m")));
}

TEST_CASE("The band of a named law of a measured surface has the digits of fstiff run") {
    const Folder folder;
    REQUIRE(run_fstiff(
                "generate profile --points 1024 --spacing '0.5 um' --hurst 0.7 --rms '0.4 um' --shortest '5 um' -o '" +
                folder / "p.csv" + "'")
                .status == 0);
    const std::string rest =
        "[surface]\nfrom = \"p.csv\"\n[material]\nupper = \"steel\"\n[uncertainty]\nsamples = 40\n[contact]\n"
        "laws = [\"hertz\"]\npressures = ";
    const Csv run(
        run_fstiff("run '" + folder.write("run.toml", rest + "[\"2 MPa\", \"30 MPa\"]\n") + "' --format csv").out);
    REQUIRE(run_fstiff("sweep '" + folder.write("grid.toml", rest + "[\"2 MPa\", { values = [\"30 MPa\"] }]\n") +
                       "' -o '" + folder / "out.jsonl" + "'")
                .status == 0);
    std::istringstream written(read(folder / "out.jsonl"));
    std::string line;
    for (std::size_t row = 2; row < 4; ++row) {  // after the answer's
        REQUIRE(std::getline(written, line));
        const auto found = nlohmann::json::parse(line);
        for (const char* key : {"stiffness_Pa_per_m", "stiffness_p05_Pa_per_m", "stiffness_p95_Pa_per_m"})
            CHECK(found.at(key).get<double>() == run.number(row, key));
    }
}

TEST_CASE("Laws of a measured map have the digits of fstiff run, whether their points are computed together or not") {
    const Folder folder;
    REQUIRE(run_fstiff("generate map --hurst 0.8 --rms '0.3 um' --points 48 --spacing '1 um' --format sdf -o '" +
                       folder / "map.sdf" + "'")
                .status == 0);
    for (const char* laws : {"\"summits\", \"hybrid\", \"persson\"", "\"hybrid\", \"boundary_elements\""}) {
        const std::string text =
            "[surface]\nfrom = \"" + folder / "map.sdf" +
            "\"\n[material.upper]\nyoungs_modulus = [\"100 GPa\", \"205 GPa\"]\npoisson_ratio = [0.3, 0.2]\n"
            "[contact]\nlaws = [" +
            laws +
            "]\npeaks = [ { theta = 1, r = 0.5 } ]\npressures = [ { values = [\"1 MPa\", \"3 MPa\", \"9 "
            "MPa\"] } ]\n[boundary_elements]\npoints = 32\n[uncertainty]\nsamples = 0\n";
        const std::string file = folder.write("grid.toml", text), out = folder / "out";
        const Outcome outcome = run_fstiff("sweep '" + file + "' -o '" + out + "'");
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        check_as_run(read(out), [&](const Line& line) {
            const std::string of_modulus =
                replaced(text, "[\"100 GPa\", \"205 GPa\"]", "\"" + line.at(1).second + " Pa\"");
            return replaced(replaced(of_modulus, "[0.3, 0.2]", line.at(2).second),
                            "{ values = [\"1 MPa\", \"3 MPa\", \"9 MPa\"] }", "\"" + line.at(3).second + " Pa\"");
        });
    }
}

TEST_CASE("Parts of a sweep joined in their order are the sweep itself, byte for byte, for any rows and threads") {
    for (const std::string& text : {grid, replaced(grid, "[\"20 um\", \"40 um\"]", "{ lognormal = [\"40 um\", 0.2] }") +
                                              "[sweep]\nsamples = 3\n"}) {
        const Folder folder;
        const std::string sweep = "sweep '" + folder.write("grid.toml", text) + "'";
        REQUIRE(run_fstiff(sweep + " -o '" + folder / "whole" + "' --threads 1").status == 0);
        const std::string whole = read(folder / "whole");
        const unsigned scenes = 7 * (contains(text, "samples") ? 3 : 2) * 11;
        CHECK(lines(whole).size() == 2 * scenes);
        CHECK(run_fstiff(sweep + " --count").out == std::to_string(scenes) + "\n");
        for (const unsigned parts : {1U, 2U, 9U}) {
            std::string all;
            for (unsigned i = 0; i < parts; ++i) {
                const std::string rows =
                    std::to_string(scenes * i / parts) + ":" + std::to_string(scenes * (i + 1) / parts);
                const std::string part = sweep + " --rows " + rows + " --threads " + std::to_string(1 + i % 3);
                const Outcome to_file = run_fstiff(part + " -o '" + folder / "part" + "'");
                INFO(to_file.err);
                CHECK(to_file.status == 0);
                CHECK(contains(to_file.out, "which " + rows + " are computed") == contains(to_file.out, "part"));
                all += read(folder / "part");
                CHECK(run_fstiff(part).out == read(folder / "part"));
            }
            CHECK(all == whole);
        }
    }
}

TEST_CASE("Rows that are none of the grid are refused") {
    for (const char* rows :
         {"5:2", "3:3", "0:155", "a:b", "5", "5:", ":5", "1:2:3", "-1:2", "1e1:20", "18446744073709551616:2"}) {
        const Folder folder;
        const std::string sweep =
            "sweep '" + folder.write("grid.toml", grid) + "' -o '" + folder / "out" + "' --rows " + rows;
        check_refusal(
            run_fstiff(sweep), sweep, 2,
            {"--rows = \"" + std::string(rows) + "\": must be FROM:TO, whole numbers with 0 <= FROM < TO <= 154"});
        CHECK(folder.files() == 1);
    }
    check_refused("sweep grid.toml --count", 2, {"--count prints a number and computes nothing"});
}

TEST_CASE("A sweep replaces results of a sweep, whole, and nothing else") {
    const Folder folder;
    folder.write("grid.toml", grid);
    const std::string go = "cd '" + folder / "" + "' && fstiff sweep grid.toml -o out";
    for (const std::string& old :
         {std::string(), read(folder / "grid.toml"), std::string("{\"index\":0,\"law\":1}\n")}) {
        folder.write("out", old);
        const Outcome outcome = shell(go);
        INFO(outcome.err);
        CHECK(outcome.status == (old.empty() ? 0 : 3));
        if (old.empty()) continue;
        CHECK(contains(outcome.err, "out: was not made by fstiff and is not replaced"));
        CHECK(read(folder / "out") == old);
    }
    REQUIRE(shell(go + " --force").status == 0);
    const std::string whole = read(folder / "out");
    CHECK(shell(go + " --rows 0:10").status == 0);
    CHECK(whole.starts_with(read(folder / "out")));
    CHECK(folder.files() == 2);
    const Outcome itself = shell(replaced(go, "-o out", "-o grid.toml --force"));
    CHECK(itself.status == 3);
    CHECK(contains(itself.err, "would be written over"));
    CHECK(read(folder / "grid.toml") == grid);
}

TEST_CASE("Errors of values are reported before anything is computed") {
    const Folder folder;
    const auto check = [&](const std::string& text, const std::string& sentence) {
        const std::string file = folder.write("grid.toml", text);
        const Outcome outcome = run_fstiff("sweep '" + file + "' -o '" + folder / "out" + "'");
        INFO(outcome.err);
        CHECK(outcome.status == 3);
        CHECK(contains(outcome.err, sentence));
        CHECK(lines(outcome.err).size() == 1);
    };
    check(replaced(grid, "\"20 um\", \"40 um\"", "\"20 MPa\", \"40 MPa\""), "surface.peak_radius = \"20 MPa\"");
    check(replaced(grid, "fractal_dimension = 1.62", "fractal_dimension = [1.62, 2.5]"),
          "surface.fractal_dimension = 2.5: must be");
    check(replaced(grid, "peak_density = \"500 /mm^2\"", "peak_density = \"500 /mm^2\"\nfrom = [\"none.csv\"]"),
          "none.csv: no such file");
    check(replaced(grid, "poisson_ratio", "poison_ratio"), "unknown key");
    check(replaced(grid, "[\"20 um\", \"40 um\"]", "{ from = \"20 um\", to = \"40 um\", count = 1e18 }"),
          "surface.peak_radius.count = 1e+18: must be a whole number from 2 to 9007199254740992, written without a");
    CHECK(run_fstiff("sweep").status == 2);
}

TEST_CASE("A scene that cannot be computed has its reason, and the others have their results") {
    const Folder folder;
    const std::string file =
        folder.write("grid.toml", replaced(grid, "{ from = \"0.1 MPa\", to = \"100 MPa\", count = 11 }",
                                           "{ values = [\"1 MPa\", \"1e20 MPa\", \"2 MPa\"] }"));
    const Outcome outcome = run_fstiff("sweep '" + file + "' -o '" + folder / "out" + "'");
    CHECK(outcome.status == 4);
    CHECK(contains(outcome.err, "14 scenes cannot be computed"));
    std::map<bool, std::set<std::string>> seen;
    for (const std::string& line : lines(read(folder / "out"))) {
        const Line all = fields(line);
        const bool wrong = value(all, "contact.pressures[0]") == "1e+26";
        CHECK(wrong == (all.back().first == "error"));
        seen[wrong].insert(value(all, "index"));
    }
    CHECK(seen[true].size() == 14);
    CHECK(seen[false].size() == 28);
}

}  // namespace sweep_test
