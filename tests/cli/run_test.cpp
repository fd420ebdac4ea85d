// SPDX-License-Identifier: BSD-3-Clause
#include "command.hpp"

#include "support/accuracy.hpp"
#include "support/table.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace run_test {

TEST_CASE("The full table has units, K in both units, the validity figures and the warnings below, once") {
    const auto outcome = test::run_fstiff("run --full");
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    for (const char* part : {"sand blasted (fine)", "p [MPa]", "p*", "K/A0 [GPa/µm]", "K/A0 [Pa/m]", "separation [µm]",
                             "numerical error [Pa/m]", "mean pressure [GPa]", "contacts [1/mm²]",
                             "plasticity index 14.5", "warning: plasticity index", "sigma R D_p = 0.0166"}) {
        INFO(part);
        CHECK(test::contains(outcome.out, part));
    }
    CHECK(test::contains(test::lines(outcome.out).back(), "warning: "));
}

namespace {

/// Columns that people see, but for the warnings, which are sentences.
std::size_t widest_line(const std::string& text) {
    std::size_t most = 0;
    for (const std::string& line : test::lines(text)) {
        std::size_t width = 0;
        for (const char c : line) width += (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
        if (!line.starts_with("warning: ")) most = std::max(most, width);
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

TEST_CASE("The summary shows every law at decades of the pressure, what it is, and K against boundary elements") {
    const auto outcome = test::run_fstiff("run");
    CHECK(outcome.status == 0);
    CHECK(widest_line(outcome.out) <= 100);
    CHECK(test::lines(outcome.out).size() < 40);
    // the numbers are those of the CSV at 0.1, 1, 10 and 100 MPa
    const test::Csv csv(test::run_fstiff("run --format csv").out);
    const auto row = cells_of(outcome.out, "hertz, theta 1.047, r 0.8165");
    REQUIRE(row.size() == 4);
    for (std::size_t k = 0; k < 4; ++k)
        CHECK(test::relative_error(std::stod(row[k]) * 1e15, csv.number(3 * 31 + 10 * k, "stiffness_Pa_per_m")) < 1e-4);
    for (const char* part :
         {"fractal is the print of the paper", "hertz is elastic", "docs/validation.md", "K has no band", "--full"}) {
        INFO(part);
        CHECK(test::contains(outcome.out, part));
    }
    CHECK_FALSE(test::contains(outcome.out, "error ["));
    // p* = p/(E g), g^2 = 2 r sigma sigma_kappa, sigma_kappa = 3 sqrt(pi)/(8 R) by (4.10): 0.0059 at 100 MPa, between
    // the rows 0.004 and 0.008 of docs/validation.md
    const double curvature = 3 * std::sqrt(3.141592653589793) / (8 * 40e-6);
    const double p = 100e6 / (112.637e9 * std::sqrt(2 * 0.816497 * 0.832e-6 * curvature));
    const auto text = outcome.out.substr(outcome.out.find("p*, K over"));
    const auto ratios = cells_of(text, "hertz, theta 1.047, r 0.8165");
    REQUIRE(ratios.size() == 8);  // "p*:" and the range, four times
    CHECK(std::abs(std::stod(ratios[6]) / p - 1) < 0.02);
    CHECK(ratios[5] == "-");
    CHECK(ratios[7] == "0.82–1.04");
    CHECK(cells_of(text, "hertz, theta 0.7854, r 0") == ratios);  // p* is one of the surface, for every curve
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
    for (std::string rest = outcome.out.substr(0, outcome.out.find("p*, K over"));;) {
        const std::size_t at = rest.find("K/A0 [GPa/µm], 5 % to 95 %");
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
    const auto validity = outcome.out.substr(outcome.out.find("p*, K over"));
    CHECK(cells_of(validity, "hertz, theta 0.7854, r 0").size() >= 4);
    CHECK(cells_of(validity, "greenwood_williamson").size() >= 4);
    CHECK_FALSE(test::contains(outcome.out, "p* is not known"));
    const auto full = test::run_fstiff("run - --full", text);
    CHECK(test::contains(full.out, "separation [nm]"));
    CHECK(test::contains(full.out, "p*"));
    CHECK(test::contains(full.out, "contacts [1/µm²]"));
}

TEST_CASE("In machine formats the warnings go to standard error and the document stays one document") {
    const auto csv = test::run_fstiff("run --format csv");
    CHECK(test::contains(csv.err, "plasticity index"));
    CHECK_FALSE(test::contains(csv.out, "warning"));
    const auto json = test::run_fstiff("run --format json");
    CHECK(test::contains(json.err, "plasticity index"));
    const auto document = nlohmann::json::parse(json.out);
    CHECK(document["warnings"].size() == test::lines(json.err).size());
    CHECK(document["rows"].size() == test::lines(csv.out).size() - 1);
    CHECK(document["laws"]["fractal"]["stiffness"] == "(3.14), (4.9)");
}

TEST_CASE("JSON, CSV and the table hold the same numbers") {
    const test::Csv csv(test::run_fstiff("run --format csv").out);
    const auto document = nlohmann::json::parse(test::run_fstiff("run --format json").out);
    for (std::size_t i = 0; i < csv.size(); ++i)
        for (const auto& column : csv.header())
            if (column != "law" && !csv.text(i, column).empty())
                CHECK(document["rows"][i][column].get<double>() == csv.number(i, column));
}

TEST_CASE("The output file is whole, replaces an older one and leaves nothing beside it") {
    const test::Folder folder;
    const std::string file = folder.write("curve.csv", "old");
    const auto outcome = test::run_fstiff("run --format csv -o '" + file + "'");
    CHECK(outcome.status == 0);
    CHECK(outcome.out.empty());
    CHECK(test::read(file) == test::run_fstiff("run --format csv").out);
    CHECK(folder.files() == 1);
    // a refused run leaves the older file as it was
    CHECK(test::run_fstiff("run '" + folder / "none.toml" + "' -o '" + file + "'").status == 3);
    CHECK(test::lines(test::read(file)).size() == 1 + 5 * 31);
    CHECK(test::run_fstiff("run -o '" + folder / "no/folder" + "'").status == 3);
    CHECK(test::contains(test::run_fstiff("run -o '" + folder / "no/folder" + "'").err, "no/folder"));
    CHECK(test::run_fstiff("run --format csv -o /dev/stdout").out == test::read(file));
}

TEST_CASE("A real area above the nominal one is printed with exit code 4") {
    const std::string deep =
        test::scene_with("sand_blasted_fine",
                         {{"pressures", "separations = [\"-30 um\"]"}, {"laws", "laws = [\"hertz\"]"}});
    const auto outcome = test::run_fstiff("run - --format csv", deep);
    CHECK(outcome.status == 4);
    CHECK(test::contains(outcome.err, "real area exceeds the nominal area"));
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
    const std::string warning = "boundary_elements has no result at 1 of 2 points, the first of them 9e+10 Pa: all points of "
                                "the map are in contact";
    const Outcome table = shell(in + "run s.toml --plot k.svg");
    CHECK(table.status == 4);
    CHECK(contains(table.out, warning));
    CHECK(contains(read(folder / "k.svg"), "boundary_elements"));
    const Outcome csv = shell(in + "run s.toml --format csv"), json = shell(in + "run s.toml --format json");
    CHECK(csv.status == 4);
    CHECK(contains(csv.err, warning));
    CHECK(Csv(csv.out).size() == 3);
    CHECK(nlohmann::json::parse(json.out)["rows"].size() == 3);
    const Outcome page = shell(in + "report s.toml -o page");
    CHECK(page.status == 4);
    CHECK(contains(read(folder / "page/report.html"), "all points of the map are in contact"));
    folder.write("g.toml", text_of("\"90 GPa\", { values = [\"10 MPa\", \"20 MPa\", \"91 GPa\"] }", both));
    for (const char* attempt : {"computed", "there already"}) {
        INFO(attempt);
        const Outcome some = shell(in + "sweep g.toml -o k.jsonl --plot sweep.svg");
        CHECK(some.status == 4);
        CHECK(contains(some.err, "3 scenes cannot be computed, or not whole"));
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
