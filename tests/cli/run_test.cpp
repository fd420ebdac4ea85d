// SPDX-License-Identifier: BSD-3-Clause
#include "command.hpp"

#include "support/accuracy.hpp"
#include "support/skip.hpp"
#include "support/table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <utility>

namespace run_test {

namespace {

const std::string fine = "run '" FSTIFF_SCENES "/sand_blasted_fine.toml'";  // names its laws

}  // namespace

TEST_CASE("The full table has units, K in both units, the validity figures and the warnings below, once") {
    const auto outcome = test::run_fstiff(fine + " --full");
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    for (const char* part : {"sand blasted (fine)", "p [MPa]", "p*", "K/A0 [MPa/µm]", "K/A0 [Pa/m]", "separation [µm]",
                             "numerical error [Pa/m]", "mean pressure [GPa]", "contacts [1/mm²]",
                             "plasticity index 14.5", "warning: plasticity index", "sigma R D_p = 0.0166"}) {
        INFO(part);
        CHECK(test::contains(outcome.out, part));
    }
    CHECK(outcome.out.find("\nwarning: ") > outcome.out.find("\nmean pressure is"));
}

namespace {

/// Columns that people see.
std::size_t widest_line(const std::string& text) {
    std::size_t most = 0;
    for (const std::string& line : test::lines(text)) {
        std::size_t width = 0;
        for (const char c : line) width += (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
        most = std::max(most, width);
    }
    return most;
}

/// The cells of the first line of \p text that begins with \p label, after it.
std::vector<std::string> cells_of(const std::string& text, const std::string& label) {
    for (const std::string& line : test::lines(text)) {
        if (!line.starts_with("  " + label + " ")) continue;
        std::istringstream row(line.substr(label.size() + 2));
        std::vector<std::string> all;
        for (std::string cell; row >> cell;) all.push_back(cell);
        return all;
    }
    return {};
}

}  // namespace

namespace {

/// Checks that \p outcome is one screen of 23 lines of 100 columns with its warnings, which are at most four and never
/// about what the band holds.
void check_screen(const test::Outcome& outcome) {
    INFO(outcome.out << outcome.err);
    CHECK((outcome.status == 0 || outcome.status == 4));
    const auto lines = test::lines(outcome.out);
    CHECK(lines.size() <= 23);
    std::string page = outcome.out;  // without the folders of this machine, whose length is not the command's
    for (const std::string& folder : {std::string(FSTIFF_SURFACES), std::string(FSTIFF_SCENES)})
        for (std::size_t at = page.find(folder); at != std::string::npos; at = page.find(folder))
            page.erase(at, folder.size());
    CHECK(widest_line(page) <= 100);
    for (const std::string& line : lines) CHECK(line.find_last_not_of(' ') + 1 == line.size());
    const auto warns = [](const std::string& line) { return line.starts_with("warning: "); };
    CHECK(std::count_if(lines.begin(), lines.end(), warns) <= 4);
    const std::string all = test::as_one_line(outcome.out);
    CHECK(test::contains(all, " Not in the band: "));
    CHECK(test::contains(all, "--full"));
    for (const char* words : {"over the answer", "plasticity index", " % only", "longer than an eighth", "sigma R D_p",
                              "p*", "structure function", "D and G not found", "above the highest peak"})
        CHECK_FALSE(test::contains(all, words));
    for (const char* once : {"H/(E g)", "vibration", "no hardness"}) CHECK(all.find(once) == all.rfind(once));
}

}  // namespace

TEST_CASE("The answer of numbers, a profile and a map is one screen of a hundred columns") {
    const test::Folder folder;
    const auto made = [&](const std::string& name, const std::string& how) {
        return folder.write(name, test::run_fstiff("generate " + how + " --hurst 0.7 --rms '0.4 um' --seed 3").out);
    };
    for (const std::string& surface :
         {std::string(),
          " --surface '" + made("p.csv", "profile --points 4096 --spacing '1 um' --longest '300 um'") + "'",
          " --surface '" + made("m.csv", "map --points 64 --spacing '1 um' --longest '16 um' --shortest '4 um'") +
              "'"}) {
        const auto outcome = test::run_fstiff("run" + surface);
        check_screen(outcome);
        CHECK(outcome.status == 0);
        const auto lines = test::lines(outcome.out);
        CHECK(test::contains(lines.at(1), "90 % band"));
        for (const std::size_t i : {2u, 3u, 4u, 5u}) CHECK(test::contains(lines.at(i), "MPa "));
    }
    const std::string steel = "[material]\nupper = \"steel\"\n[contact]\npressures = [\"10 MPa\"]\n";
    check_screen(test::run_fstiff("run -", "[surface]\nRa = \"0.8 um\"\n" + steel));
    // a joint has the most columns: causes give way before the page does
    const auto joint = test::run_fstiff(
        "run -",
        "[surface]\nRa = \"0.8 um\"\n[material.upper]\nname = \"steel\"\nhardness = \"2 GPa\"\n[contact]\n"
        "force = [\"1 kN\", \"20 kN\"]\nnominal_area = \"200 mm^2\"\n");
    check_screen(joint);
    CHECK(test::contains(joint.out, "approach ["));
}

namespace {

/// \returns how many answers of files were shown, read by these units where a file has none.
int check_screens_of(const std::vector<std::pair<std::string, std::string>>& files) {
    const std::string folder = FSTIFF_SURFACES;
    int shown = 0;
    for (const auto& [file, units] : files) {
        INFO(file);
        for (const char* steel : {"upper = \"steel\"\n", "upper = { name = \"steel\", hardness = \"2 GPa\" }\n"}) {
            const auto outcome =
                test::run_fstiff("run -", "[surface]\nfrom = '" + folder + "/" + file + "'\n" +
                                              (units.empty() ? "" : "units = \"" + units + "\"\n") +
                                              (file.ends_with("land.x3p") ? "fill = true\n" : "") + "[material]\n" +
                                              steel + "[contact]\npressures = [\"1 MPa\", \"10 MPa\", \"100 MPa\"]\n");
            if (test::contains(outcome.err, "built without")) {
                test::leave_out("built without X3P: " + file);
                break;
            }
            check_screen(outcome);
            ++shown;
        }
        if (units.empty() && !file.ends_with(".x3p"))
            check_screen(test::run_fstiff("run --surface '" + folder + "/" + file + "'"));
    }
    return shown;
}

}  // namespace

TEST_CASE("The answer of every measured surface is one screen of a hundred columns, with at most four warnings") {
    if (!std::filesystem::exists(FSTIFF_SURFACES))
        SKIP_CASE("there is no folder of measured surfaces " FSTIFF_SURFACES);
    CHECK(check_screens_of({{"dektak-1.csv", "um,um"},
                            {"opdx-3.txt", "m,m"},
                            {"xy-4.txt", "um,um"},
                            {"nanovea_test1.txt", "mm,um"},
                            {"matrix-3.txt", ""},
                            {"matrix-4.txt", ""},
                            {"sdf-1.sdf", ""},
                            {"derived_matrix-4_binary.sdf", ""},
                            {"x3p-2.x3p", ""}}) >= 16);
}
TEST_CASE("The answer of a map that takes half a minute is one screen too", "[long]") {
    if (!std::filesystem::exists(FSTIFF_SURFACES))
        SKIP_CASE("there is no folder of measured surfaces " FSTIFF_SURFACES);
    check_screens_of({{"x3ptools_sample-land.x3p", ""}});
}

TEST_CASE("The summary shows every law that is named at decades of the pressure, what it is, and K over the answer") {
    const auto outcome = test::run_fstiff(fine);
    CHECK(outcome.status == 0);
    CHECK(widest_line(outcome.out) <= 100);
    CHECK(test::lines(outcome.out).size() <= 44);
    // the numbers are those of the CSV at 0.1, 1, 10 and 100 MPa, after the 31 rows of the answer
    const test::Csv csv(test::run_fstiff(fine + " --format csv").out);
    const std::string label = "hertz, theta 1.047, r 0.8165";
    const auto row = cells_of(outcome.out, label);
    REQUIRE(row.size() == 4);
    const auto ratios = cells_of(outcome.out.substr(outcome.out.find("K over the answer")), label);
    REQUIRE(ratios.size() == 4);
    for (std::size_t k = 0; k < 4; ++k) {
        const double K = csv.number(4 * 31 + 10 * k, "stiffness_Pa_per_m");
        CHECK(test::relative_error(std::stod(row[k]) * 1e12, K) < 1e-4);
        CHECK(test::relative_error(std::stod(ratios[k]), K / csv.number(10 * k, "stiffness_Pa_per_m")) < 5e-3);
    }
    for (const char* part :
         {"fractal is as printed in the paper", "hertz is elastic", "named laws have no band", "--full"}) {
        INFO(part);
        CHECK(test::contains(outcome.out, part));
    }
    CHECK_FALSE(test::contains(outcome.out, "error ["));
}

TEST_CASE("The other quantities that a scene without laws asks for are below its answer") {
    const std::string scene = test::scene_with("sand_blasted_fine", {{"laws", ""}, {"peaks", ""}});
    const auto waves = test::run_fstiff("run -", test::replaced(scene, "[output]",
                                                                "[ultrasound]\nfrequency = \"1 MHz\"\n"
                                                                "upper = { impedance = \"46 MRayl\" }\n[output]"));
    INFO(waves.out << waves.err);
    CHECK(test::contains(waves.out, "90 % band"));
    const auto areas = test::run_fstiff(
        "run -", scene.substr(0, scene.find("[output]")) + "[output]\nquantities = [\"separation\", \"real_area\"]\n");
    INFO(areas.out << areas.err);
    for (const char* part : {"90 % band", "\n  separation [µm]", "\n  real area"})
        CHECK(test::contains(areas.out, part));
}

TEST_CASE("The summary has every pressure that was asked for, in tables below one another where one is too wide") {
    std::string pressures;
    for (int i = 1; i <= 12; ++i) pressures += (i > 1 ? ", \"" : "\"") + std::to_string(7 * i) + " MPa\"";
    const std::string text =
        "[surface]\nrms_height = \"0.8 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n"
        "errors = { rms_height = \"0.1 um\" }\n[material.upper]\nyoungs_modulus = \"205 GPa\"\n"
        "poisson_ratio = 0.3\n[uncertainty]\nsamples = 20\n[contact]\nlaws = [\"hertz\"]\npressures = [" +
        pressures + "]\n";
    const auto outcome = test::run_fstiff("run -", text);
    INFO(outcome.out);
    CHECK(widest_line(outcome.out) <= 100);
    std::vector<std::string> shown;
    for (std::string rest = outcome.out.substr(0, outcome.out.find("K over the answer"));;) {
        const std::size_t at = rest.find("K/A0 [MPa/µm], 5 % to 95 %");
        if (at == std::string::npos) break;
        rest = rest.substr(at + 28);
        std::istringstream header(rest.substr(0, rest.find('\n')));
        for (std::string number, unit; header >> number >> unit;) shown.push_back(number);
    }
    REQUIRE(shown.size() == 12);
    for (std::size_t i = 0; i < 12; ++i) CHECK(shown[i] == std::to_string(7 * (i + 1)));
}

TEST_CASE("A measured surface gives p* to peaks with r = 0 and of one radius, a band, and units by size") {
    const test::Folder folder;
    // 40 nm rms, R 3 um, 1.3 /um^2: an AFM map
    const std::string text =
        "[surface]\nrms_height = \"40 nm\"\npeak_radius = \"3 um\"\npeak_density = \"1.3 /um^2\"\nr = 0.4\ntheta = "
        "0.6\n"
        "errors = { rms_height = \"4 nm\" }\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
        "[uncertainty]\nsamples = 40\n[contact]\npressures = { from = \"10 kPa\", to = \"1 GPa\", count = 6 }\n"
        "laws = [\"hertz\", \"greenwood_williamson\"]\npeaks = [ { theta = \"pi/4\", r = 0 } ]\n";
    const auto outcome = test::run_fstiff("run -", text);
    INFO(outcome.out);
    CHECK(widest_line(outcome.out) <= 100);
    CHECK(test::contains(outcome.out, "sigma 40 nm, R 3 µm, D_p 1.3 /µm²"));
    CHECK(test::contains(outcome.out, "5 % to 95 %"));
    CHECK_FALSE(test::contains(outcome.out, "no band"));
    const auto ratios = outcome.out.substr(outcome.out.find("K over the answer"));
    CHECK(cells_of(ratios, "hertz, theta 0.7854, r 0").size() == 6);
    CHECK(cells_of(ratios, "greenwood_williamson").size() == 6);
    const auto full = test::run_fstiff("run - --full", text);
    CHECK(test::contains(full.out, "separation [nm]"));
    CHECK(test::contains(full.out, "p*"));
    CHECK(test::contains(full.out, "contacts [1/µm²]"));
}

TEST_CASE("JSON and CSV hold the same numbers, the answer first, and their warnings go to standard error") {
    const auto printed = test::run_fstiff(fine + " --format csv"), json = test::run_fstiff(fine + " --format json");
    const test::Csv csv(printed.out);
    const auto document = nlohmann::json::parse(json.out);
    for (const auto& outcome : {printed, json}) CHECK(test::contains(outcome.err, "plasticity index"));
    CHECK_FALSE(test::contains(printed.out, "warning"));
    CHECK(document["warnings"].size() == test::lines(json.err).size());
    CHECK(document["laws"]["fractal"]["stiffness"] == "(3.14), (4.9)");
    const std::size_t answers = document["answer"].size();
    CHECK(answers == 31);
    REQUIRE(csv.size() == answers + document["rows"].size());
    for (std::size_t i = 0; i < csv.size(); ++i) {
        const auto& row = i < answers ? document["answer"][i] : document["rows"][i - answers];
        CHECK(csv.number(i, "answer") == (i < answers ? 1 : 0));
        CHECK(csv.text(i, "law") == row["law"].get<std::string>());
        std::size_t compared = 0;
        for (const auto& column : csv.header())
            if (column != "law" && !csv.text(i, column).empty() && row.contains(column)) {
                CHECK(row[column].get<double>() == csv.number(i, column));
                ++compared;
            }
        CHECK(compared >= (i < answers ? 4 : 7));  // of the answer p, K and both ends of its band
    }
}

TEST_CASE("Full contact at one pressure is no result there, in every form and in truth, and nothing else is lost") {
    using namespace test;
    const Folder folder;
    const Outcome map = test::run_fstiff("generate map --points 32 --spacing '1 um' --hurst 0.8 --rms '1 um'");
    folder.write("m.txt", map.out);
    const auto text_of = [&](const std::string& pressures, const std::string& laws) {
        return "[surface]\nfrom = \"m.txt\"\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
               "[contact]\npressures = [" +
               pressures + "]\nlaws = [" + laws + "]\n[uncertainty]\nsamples = 20\n";
    };
    const std::string both = "\"hertz\", \"boundary_elements\"";
    folder.write("s.toml", text_of("\"90 GPa\", \"10 MPa\"", both));
    const std::string in = "cd '" + (folder / "") + "' && fstiff ";
    const std::string warning =
        "boundary_elements has no result at 1 of 2 points, the first of them 9e+10 Pa: all points of "
        "the map are in contact";
    const Outcome table = shell(in + "run s.toml --plot k.svg");
    CHECK(table.status == 4);
    CHECK(contains(as_one_line(table.out), warning));
    CHECK(contains(read(folder / "k.svg"), "boundary_elements"));
    const Outcome csv = shell(in + "run s.toml --format csv"), json = shell(in + "run s.toml --format json");
    CHECK(csv.status == 4);
    CHECK(contains(csv.err, warning));
    CHECK(Csv(csv.out).size() == 1 + 3);  // the answer reaches one pressure
    CHECK(json.status == 4);
    CHECK(nlohmann::json::parse(json.out)["rows"].size() == 3);
    folder.write("g.toml", text_of("\"90 GPa\", { values = [\"10 MPa\", \"20 MPa\", \"91 GPa\"] }", both));
    for (const char* attempt : {"computed", "there already"}) {
        INFO(attempt);
        const Outcome some = shell(in + "sweep g.toml -o k.jsonl");
        CHECK(some.status == 4);
        CHECK(contains(some.err, "3 scenes cannot be computed, or only in part"));
    }
    const std::vector<std::string> rows = lines(read(folder / "k.jsonl"));
    REQUIRE(rows.size() == 3 * 2 * 2);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const auto row = nlohmann::json::parse(rows[i]);
        const bool missed = row["law"] == "boundary_elements" && row["pressure_Pa"] > 1e10;
        CHECK(row.contains("error") == missed);
        CHECK(row["stiffness_Pa_per_m"].is_null() == missed);
        if (missed) CHECK(row["error"] == "law boundary_elements: all points of the map are in contact");
    }
    const Outcome truth = shell(in + "truth m.txt --pressures '10 MPa,90 GPa' --format json");
    CHECK(truth.status == 4);
    const auto solved = nlohmann::json::parse(truth.out);
    CHECK(solved["rows"][0]["stiffness_Pa_per_m"] > 0);
    CHECK(solved["rows"][1]["stiffness_Pa_per_m"].is_null());
    CHECK(solved["rows"][1]["stiffness_error_Pa_per_m"].is_null());
    CHECK(solved["rows"][1]["real_area_fraction"] == 1);
    CHECK(solved["warnings"][0] == "all points of the map are in contact at 1 of 2 pressures: there is no K there");
    const Outcome least = shell(in + "truth m.txt --pressures '10 MPa,5e-324 Pa'");
    INFO(least.err);
    CHECK(least.status == 3);
    CHECK(contains(least.err, "is beyond the range of double precision; pressures must be less extreme"));
    const Outcome most = shell(in + "truth m.txt --pressures '10 MPa,1e308 Pa'");
    CHECK(most.status == 4);
    CHECK(contains(most.out + most.err, "all points of the map are in contact at 1 of 2 pressures"));
    const Outcome closed = shell(in + "truth m.txt --pressures '90 GPa'");
    CHECK(closed.status == 3);
    CHECK(contains(closed.err, "m.txt: all points of the map are in contact at 9e+10 Pa, so that there is no K"));
}

}  // namespace run_test
