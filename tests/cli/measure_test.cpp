// SPDX-License-Identifier: BSD-3-Clause
// measure, scenes whose surface is a file, and the band of run.
#include "command.hpp"

#include "support/accuracy.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/measured/surface_parameters.hpp>
#include <fstiff/topography/form.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace measure_test {

namespace {

const std::string material = "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n";
const std::string contact = "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\n";

std::string generated(const std::string& arguments) {
    const auto made = test::run_fstiff("generate " + arguments);
    INFO(arguments << "\n" << made.err);
    REQUIRE(made.status == 0);
    return made.out;
}

std::string map_text() {
    return generated("map --points 128 --spacing '1 um' --hurst 0.7 --rms '1 um' --shortest '8 um' --longest '64 um'");
}
std::string profile_text() {
    return generated(
        "profile --points 4096 --spacing '1 um' --hurst 0.6 --rms '1 um' --shortest '16 um' --longest '400 um'");
}

nlohmann::json json_of(const std::string& arguments, const std::string& input = "") {
    const auto outcome = test::run_fstiff(arguments, input);
    INFO("fstiff " << arguments << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    return nlohmann::json::parse(outcome.out);
}

void check_measured(const nlohmann::json& surface, const fstiff::SurfaceParameters<double>& expected) {
    const auto same = [&](const char* name, const fstiff::Measurement<double>& measured) {
        INFO(name);
        CHECK(surface[name]["value"] == measured.value);
        CHECK(surface[name]["error"] == measured.error);
        CHECK(measured.error > 0);
    };
    same("rms_height", expected.rms_height);
    same("peak_radius", expected.peak_radius);
    same("peak_density", expected.peak_density);
    same("max_peak_height", expected.max_peak_height);
    same("fractal_dimension", expected.fractal_dimension.value());
    same("fractal_roughness", expected.fractal_roughness.value());
    same("r", expected.r.value());
    same("theta", expected.theta.value());
}

/// K(p) of every row, with its band.
struct Row {
    double stiffness, low, high;
};
std::vector<Row> rows_of(const std::string& scene) {
    const auto outcome = test::run_fstiff("run - --format csv", scene);
    INFO(scene << "\n" << outcome.err);
    REQUIRE(outcome.status == 0);
    const test::Csv csv(outcome.out);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < csv.size(); ++i)
        rows.push_back({csv.number(i, "stiffness_Pa_per_m"), csv.number(i, "stiffness_p05_Pa_per_m"),
                        csv.number(i, "stiffness_p95_Pa_per_m")});
    return rows;
}

}  // namespace

TEST_CASE("The command measures what the library measures, to the last digit") {
    SECTION("of a map") {
        const std::string text = map_text();
        const auto map = fstiff::remove_form(fstiff::io::read_surface(text, "map").map(), fstiff::MapForm::plane);
        check_measured(json_of("measure - --lambda-s none", text)["surface"], fstiff::surface_parameters(map));
        fstiff::SurfaceParameterOptions<double> summits;
        summits.peaks = fstiff::PeakSource::summits;
        check_measured(json_of("measure - --lambda-s none --peaks summits", text)["surface"],
                       fstiff::surface_parameters(map, summits));
    }
    SECTION("of a profile") {
        const std::string text = profile_text();
        const auto profile = fstiff::level(fstiff::io::read_surface(text, "profile").profile(), fstiff::Form::line);
        fstiff::SurfaceParameterOptions<double> how;
        how.seed = how.fit.seed = 7;
        how.resamples = 100;
        check_measured(json_of("measure - --lambda-s none --lambda-c none --seed 7 --resamples 100", text)["surface"],
                       fstiff::surface_parameters(profile, how));
    }
}

/// Of numbers alone: hybrid, the first law of a measured surface, takes the summits of a map where there is one.
const std::string laws = "laws = [\"fractal\", \"hertz\", \"greenwood_williamson\"]\n";

TEST_CASE("A measured quantity is written so that a scene takes it") {
    const auto surface = json_of("measure -", map_text())["surface"];
    std::string scene = "[surface]\n";
    for (const char* name : {"rms_height", "peak_radius", "peak_density", "max_peak_height", "fractal_roughness"})
        scene += std::string(name) + " = \"" + surface[name]["quantity"].get<std::string>() + "\"\n";
    for (const char* name : {"fractal_dimension", "r", "theta"})
        scene += std::string(name) + " = " + surface[name]["value"].dump() + "\n";
    const auto written = json_of("run - --format json", scene + material + contact + laws);
    const auto piped = nlohmann::json::parse(
        test::shell("fstiff measure - | (cat > m.json; printf '%s' '" + std::string("[surface]\nfrom = \"m.json\"\n") +
                        material + contact + laws + "' > s.toml; fstiff run s.toml --format json; rm m.json s.toml)",
                    map_text())
            .out);
    REQUIRE(written["rows"].size() == piped["rows"].size());
    REQUIRE(written["rows"].size() == 6);
    // "value unit" is read as value times 1, which is exact, but 1/mm^2 and the like are not used: equal to the last digit
    for (std::size_t i = 0; i < written["rows"].size(); ++i)
        CHECK(written["rows"][i]["stiffness_Pa_per_m"] == piped["rows"][i]["stiffness_Pa_per_m"]);
}

TEST_CASE(
    "A scene takes its surface from a file beside it, from the JSON of measure, or from --surface, all the same") {
    const test::Folder folder;
    const std::string map = folder.write("map.txt", map_text());
    folder.write("from_map.toml", "[surface]\nfrom = \"map.txt\"\n" + material + contact + laws);
    folder.write("from_json.toml", "[surface]\nfrom = \"measured.json\"\n" + material + contact + laws);
    const std::string other = folder.write(
        "other.toml", "[surface]\nrms_height = \"9 um\"\npeak_radius = \"9 um\"\npeak_density = \"9 /mm^2\"\n" +
                          material + contact + laws);
    REQUIRE(test::run_fstiff("measure '" + map + "' -o '" + (folder / "measured.json") + "'").status == 0);
    const auto direct = json_of("run '" + folder / "from_map.toml" + "' --format json");
    const auto indirect = json_of("run '" + folder / "from_json.toml" + "' --format json");
    CHECK(direct["rows"] == indirect["rows"]);
    CHECK(direct["surface"]["source"]["sha256"] == indirect["surface"]["source"]["sha256"]);
    CHECK(direct["surface"]["measured"] == indirect["surface"]["measured"]);
    CHECK(direct["uncertainty"]["samples"] == 400);
    // the scene's own numbers give way
    const test::Outcome piped = test::shell("fstiff measure '" + map + "' | fstiff run '" + folder / "from_json.toml" +
                                            "' --surface - --format json");
    REQUIRE(piped.status == 0);
    CHECK(nlohmann::json::parse(piped.out)["rows"] == direct["rows"]);
}

TEST_CASE("A key beside surface.from replaces what was measured, and an error of its own makes its band") {
    const test::Folder folder;
    folder.write("map.txt", map_text());
    const auto run = [&](const std::string& more) {
        const std::string scene = folder.write("s.toml", "[surface]\nfrom = \"map.txt\"\n" + more + material + contact);
        return json_of("run '" + scene + "' --format json");
    };
    const auto measured = run(""), replaced = run("rms_height = \"2 um\"\n"), summits = run("peaks = \"summits\"\n");
    CHECK(replaced["inputs"]["surface.rms_height"]["value"] == 2e-6);
    CHECK(replaced["rows"][0]["stiffness_Pa_per_m"] != measured["rows"][0]["stiffness_Pa_per_m"]);
    CHECK(summits["surface"]["measured"]["peak_radius"] != measured["surface"]["measured"]["peak_radius"]);
}

TEST_CASE("Errors of nothing make a band of no width") {
    const std::string surface =
        "[surface]\nrms_height = \"1 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\nfractal_dimension = "
        "1.5\n";
    const auto none = test::run_fstiff("run - --format csv", surface + material + contact);
    CHECK(!test::contains(none.out, "stiffness_p05"));  // without errors no band
    // an error of 1e-9 of sigma moves K by some 1e-9 of itself
    for (const Row& row : rows_of(surface + "errors = { rms_height = \"1e-9 um\" }\n" + material + contact)) {
        CHECK(row.low <= row.stiffness);
        CHECK(row.high >= row.stiffness);
        CHECK(test::relative_error(row.low, row.stiffness) < 1e-8);
        CHECK(test::relative_error(row.high, row.stiffness) < 1e-8);
    }
}

TEST_CASE("An error of nothing may be written with its unit, and gives what no error gives") {
    const std::string surface =
        "[surface]\nrms_height = \"1 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\nfractal_dimension = "
        "1.5\n";
    const auto none = test::run_fstiff("run - --format csv", surface + material + contact);
    const auto zero =
        test::run_fstiff("run - --format csv",
                     surface + "errors = { rms_height = \"0 um\", peak_density = \"0 /mm^2\" }\n" + material + contact);
    CHECK(zero.status == 0);
    CHECK(zero.out == none.out);
    test::check_refused("run -", 3, {"surface.errors.rms_height", "not negative"},
                        surface + "errors = { rms_height = \"-1 um\" }\n" + material + contact);
}

TEST_CASE("A plane and a line are refused, their rounding is not measured") {
    std::string plane, line;
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i) plane += std::to_string(i + j) + (i < 63 ? "," : "\n");
        line += std::to_string(j) + "\n";
    }
    for (const char* form : {"plane", "quadratic", "cubic"})
        test::check_refused("measure - --units um --dx '1 um' --dy '1 um' --detrend " + std::string(form), 3,
                            {"map of constant height", form}, plane);
    for (const char* form : {"line", "parabola"})
        test::check_refused("measure - --units um --spacing '1 um' --detrend " + std::string(form), 3,
                            {"profile of constant height", form}, line);
}

TEST_CASE("A surface as short as its longest waves says that sigma is that of its length, and ends well") {
    const auto measured = [](const std::string& longest) {
        return test::shell("fstiff generate profile --points 4096 --spacing '1 um' --hurst 0.8 --rms '1 um' --seed 3" +
                           longest + " | fstiff measure - --lambda-c none");
    };
    const auto short_one = measured(""), long_one = measured(" --longest '128 um'");
    CHECK(short_one.status == 0);
    CHECK(long_one.status == 0);
    const std::string sentence =
        " % of the mean square height are waves longer than an eighth of the profile: sigma is that of this length";
    CHECK(test::contains(short_one.err, sentence));
    CHECK(!test::contains(long_one.err, sentence));
    const auto error = [](const test::Outcome& one) {
        const auto sigma = nlohmann::json::parse(one.out)["surface"]["rms_height"];
        return sigma["error"].get<double>() / sigma["value"].get<double>();
    };
    CHECK(error(short_one) > 4 * error(long_one));
}

TEST_CASE("Endless input ends at once") { test::check_refused("measure /dev/zero", 3, {"/dev/zero", "is binary"}); }

TEST_CASE("The number for missing points is an option, a key of a scene, and in the JSON") {
    std::string map;
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i)
            map += ((i + j) % 17 == 0 ? std::string("-9999") : std::to_string(std::sin(i * i + 3.0 * j * i))) +
                   (i < 63 ? "," : "\n");
    const std::string how = "measure - --units um --dx '1 um' --dy '1 um'";
    test::check_refused(how, 3, {"-9999 um", "--missing \"-9999\""}, map);
    const auto read = test::run_fstiff(how + " --missing -9999", map);
    CHECK(read.status == 0);
    CHECK(test::contains(read.out, "missing (-9999, from options)"));
    const test::Folder folder;
    const std::string file = folder.write("map.csv", map);
    for (const char* missing : {"-9999", "\"-9999\""}) {
        const auto scene = test::run_fstiff("run - --format csv",
                                        "[surface]\nfrom = '" + file +
                                            "'\nunits = \"um\"\ndx = \"1 um\"\ndy = \"1 um\"\nmissing = " + missing +
                                            "\nfractal_dimension = 1.5\n" + material + contact);
        INFO(scene.err);
        CHECK(scene.status == 0);
    }
}

TEST_CASE("The band of one uncertain parameter lies at its own quantiles") {
    // K falls as sigma grows: the 5 % of K is K at the 95 % of sigma, which is median exp(1.6449 s), s^2 = ln(1 + 0.2^2)
    const auto scene = [](double sigma, const std::string& errors) {
        return "[surface]\nrms_height = \"" + std::to_string(sigma) +
               " um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\nfractal_dimension = 1.5\n" + errors +
               material + contact +
               "laws = [\"fractal\", \"greenwood_williamson\"]\n[uncertainty]\nsamples = 4000\nseed = 3\n";
    };
    const double s = std::sqrt(std::log(1.04)), z = 1.6448536269514722;
    const auto band = rows_of(scene(1, "errors = { rms_height = \"0.2 um\" }\n"));
    const auto stiffness_at = [&](double sigma) {
        const test::Csv csv(test::run_fstiff("run - --format csv", scene(sigma, "")).out);
        std::vector<double> values;
        for (std::size_t i = 0; i < csv.size(); ++i) values.push_back(csv.number(i, "stiffness_Pa_per_m"));
        return values;
    };
    const auto low = stiffness_at(std::exp(z * s)), high = stiffness_at(std::exp(-z * s));
    REQUIRE(band.size() == 6);
    for (std::size_t i = 0; i < band.size(); ++i) {
        CAPTURE(i);
        // the 5 % point of 4000 samples scatters by sqrt(0.05 0.95/4000)/0.103 = 0.033 standard deviations, 2 % of 1.645;
        // four of those
        const double half = std::log(band[i].high / band[i].low) / 2, expected = std::log(high[i] / low[i]) / 2;
        CHECK(expected > 0.1);
        CHECK(std::abs(half - expected) < 0.08 * expected);
        CHECK(std::abs(std::log(band[i].low / low[i])) < 0.16 * expected);
        CHECK(std::abs(std::log(band[i].high / high[i])) < 0.16 * expected);
    }
}

TEST_CASE("The same seed gives the same band, another seed another, and samples = 0 none") {
    const test::Folder folder;
    folder.write("map.txt", map_text());
    const auto run = [&](const std::string& uncertainty) {
        const std::string scene =
            folder.write("s.toml", "[surface]\nfrom = \"map.txt\"\n" + material + contact + uncertainty);
        const auto outcome = test::run_fstiff("run '" + scene + "' --format csv");
        INFO(outcome.err);
        REQUIRE(outcome.status == 0);
        return outcome.out;
    };
    const std::string first = run("");
    CHECK(first == run("[uncertainty]\nsamples = 400\nseed = 2014\n"));
    CHECK(first != run("[uncertainty]\nseed = 2015\n"));
    CHECK(!test::contains(run("[uncertainty]\nsamples = 0\n"), "stiffness_p05"));
}

TEST_CASE("What is no surface is refused by measure, by surface.from and by --surface") {
    const test::Folder folder;
    const std::string map = folder.write("map.txt", map_text());
    const auto scene = [&](const std::string& lines) { return "[surface]\n" + lines + material + contact; };
    test::check_refused("measure -", 3, {"standard input", "empty"});
    test::check_refused("measure nowhere.sdf", 3, {"nowhere.sdf", "no such file"});
    test::check_refused("measure -", 3, {"unit"}, "1\n2\n3\n1\n2\n");
    test::check_refused("measure - --spacing '1 um' --units um", 3, {"standard input"}, std::string(200, '1') + "\n");
    test::check_refused("measure '" + map + "' --tip-radius '2 um'", 3, {"map.txt", "map", "resolution"});
    test::check_refused("measure '" + map + "' --resamples 1", 2, {"--resamples"});
    test::check_refused("run - --surface -", 2, {"standard input"}, scene(""));
    test::check_refused("run --surface nowhere.sdf", 3, {"--surface", "nowhere.sdf", "no such file"});
    test::check_refused("run --surface -", 3,
                        {"standard input", "given as fstiff measure --units",
                         "; --surface reads the JSON that fstiff measure prints"},
                        "1\n2\n3\n1\n2\n");
    test::check_refused("run --surface -", 3, {"standard input", "not the JSON of fstiff measure"},
                        "{\"command\": \"fit\"}");
    test::check_refused("run --surface -", 3, {"standard input", "not the JSON"}, "{\"command\": \"mea");
    test::check_refused("run -", 3, {"standard input:2", "surface.from", "nowhere.txt"},
                        scene("from = \"nowhere.txt\"\n"));
    test::check_refused("run -", 3, {"standard input:2", "surface.from"}, scene("from = 3\n"));
    test::check_refused("run -", 3, {"standard input:2", "surface.from"}, scene("from = \"\"\n"));
    test::check_refused("run -", 3, {"standard input:2", "surface.units", "unknown key", "\"from\""},
                        scene("units = \"um\"\n"));
    test::check_refused("run -", 3, {":3", "surface.column", "whole number"},
                        scene("from = '" + map + "'\ncolumn = 0\n"));
    test::check_refused("run -", 3, {":3", "surface.peaks", "islands"},
                        scene("from = '" + map + "'\npeaks = \"hills\"\n"));
    test::check_refused("run -", 3, {"surface.from", "128 columns"},
                        scene("from = '" + map + "'\nspacing = \"1 um\"\n"));
    test::check_refused("run -", 3, {":3", "surface.r", "less than 1"}, scene("from = '" + map + "'\nr = 1.0\n"));
    test::check_refused("run -", 3, {":4", "uncertainty.samples"},
                        "[surface]\nfrom = '" + map + "'\n[uncertainty]\nsamples = 3\n" + material + contact);
}

TEST_CASE("An option of a surface that makes no sense is refused in the words it was given in") {
    std::string heights;
    for (int i = 0; i < 600; ++i) heights += std::to_string(std::sin(0.3 * i) + 0.2 * std::sin(i * i)) + "\n";
    const auto refused = [&](const std::string& options, int status, const std::string& part) {
        test::check_refused("measure - --units um " + options, status, {part}, heights);
    };
    const std::string step = "--spacing '0.5 um' ";
    refused("--spacing '-0.5 um'", 3, "--spacing = \"-0.5 um\": must be greater than 0");
    refused("--spacing '0,5 um'", 3, "--spacing = \"0,5 um\": has a comma; the decimal mark is the point");
    refused(step + "--lambda-c '299.50001 um'", 3,
            "--lambda-c = \"299.50001 um\": must be at most the length of the surface, 299.5 µm");
    refused(step + "--lambda-s '0.9 um'", 3, "--lambda-s = \"0.9 um\" cannot be held");
    refused(step + "--scales --pressure '-1 MPa'", 3, "--pressure = \"-1 MPa\": must be greater than 0");
    refused(step + "--window '10 um'", 2, "--window = \"10 um\": must be two lengths");
    refused(step + "--window '0,8 um,80 um'", 2, "two lengths with one comma between them; the decimal mark is the point");
    refused(step + "--window '10 um,1 um'", 2, "--window = \"10 um,1 um\": the first length must be less");
    refused(step + "--peaks summits", 2, "--peaks = \"summits\" is for a map; standard input holds a profile");
    test::check_refused("truth - --pressures='-5 MPa'", 3, {"--pressures = \"-5 MPa\": must be greater than 0"},
                        map_text());
    test::check_refused("truth - --pressures '1,5 MPa'", 3,
                        {"--pressures = \"1,5 MPa\": every pressure needs its unit, and the point"}, map_text());
    test::check_refused("ultrasound --stiffness '1 GPa/um' --impedance '46 MRayl' --frequency='-7 MHz'", 3,
                        {"--frequency = \"-7 MHz\": must be greater than 0"});
    const auto whole = test::run_fstiff("measure - --units um " + step + "--lambda-c '299.5 um'", heights);
    INFO(whole.err);
    CHECK(whole.status % 4 == 0);  // as long as the profile: allowed
    const auto document = test::run_fstiff("measure - --units um " + step, heights).out;
    for (const std::string command : {"measure -", "spectrum -", "truth -"})
        test::check_refused(command, 3, {"standard input: is JSON that fstiff printed", "run --surface"}, document);
    std::string rise;
    for (int i = 0; i < 600; ++i) rise += i < 300 ? "0\n" : "1\n";
    test::check_refused("measure - --units um " + step, 3, {"or of one step", "told from the rounding"}, rise);
}

TEST_CASE("A changed document of measure is refused where it was changed") {
    const auto document = json_of("measure -", map_text());
    const auto refused = [](nlohmann::json changed, const std::vector<std::string>& parts) {
        test::check_refused("run --surface -", 3, parts, changed.dump());
    };
    auto changed = document;
    changed["surface"]["rms_height"].erase("value");
    refused(changed, {"surface.rms_height", "value"});
    changed = document;
    changed["surface"].erase("peak_radius");
    refused(changed, {"surface.peak_radius", "missing"});
    changed = document;
    changed["surface"]["fractal_dimension"]["value"] = 2.5;
    refused(changed, {"fractal_dimension", "2.5"});
    changed = document;
    changed["surface"]["r"]["error"] = -1;
    refused(changed, {"r", "-1"});
    changed = document;
    changed["correlation_of_errors"]["matrix"][1][2] = 5;
    refused(changed, {"correlation"});
    changed = document;
    changed["schema_version"] = 7;
    refused(changed, {"schema_version"});
}

// Two round hills: two islands from the highest level down to the saddle, and never more.
TEST_CASE(
    "That R and D_p of islands represent nothing is said by measure, run, identify and report, with exit code 4") {
    const test::Folder folder;
    std::string text;
    for (int j = 0; j < 32; ++j)
        for (int i = 0; i < 64; ++i)
            text += std::to_string(1e3 * (1 - std::cos(4 * std::numbers::pi * (i + 0.5) / 64)) *
                                       (1 - std::cos(2 * std::numbers::pi * (j + 0.5) / 32)) +
                                   1e-3 * i * j) +
                    (i == 63 ? "\n" : " ");
    const std::string map = folder.write("hills.txt", text), file = folder / "hills.json";
    const std::string options = " --units um,nm --dx '1 um' --dy '1 um'";
    const auto measured = test::run_fstiff("measure '" + map + "'" + options + " -o '" + file + "'");
    CHECK(measured.status == 4);
    const auto document = nlohmann::json::parse(test::read(file));
    const std::string said = "represents nothing";
    CHECK(test::contains(document["concerns"].dump(), "\"no_densest_level\""));
    CHECK(test::contains(document["warnings"].dump(), said));
    // R and D_p with two digits, sigma with five
    const auto shown = test::run_fstiff("measure '" + map + "'" + options + " --format table");
    CHECK(shown.status == 4);
    const auto digits = [&](const std::string& name) {
        std::istringstream row(shown.out.substr(shown.out.find(name) + name.size()));
        std::string value;
        row >> value;
        value = value.substr(0, value.find('e'));
        return std::count_if(value.begin(), value.end(), [](char c) { return c >= '0' && c <= '9'; });
    };
    CHECK(digits("rms_height") >= 4);
    CHECK(digits("peak_radius") <= 3);  // such as 0.12
    const auto islands = test::run_fstiff("islands '" + map + "'" + options);
    CHECK(islands.status == 4);
    CHECK(test::contains(islands.out, said));

    const auto repeats = [&](const std::string& call, int status) {
        const auto outcome = test::run_fstiff(call);
        INFO(call << "\n" << outcome.out << outcome.err);
        CHECK(outcome.status == status);
        CHECK(test::contains(outcome.out + outcome.err, said));
    };
    repeats("run --surface '" + file + "'", 4);
    repeats("report --surface '" + file + "' -o '" + folder / "report'", 4);
    const std::string scene =
        folder.write("from.toml",
                     "[surface]\nfrom = \"hills.json\"\n[material.upper]\nyoungs_modulus = \"205 GPa\"\n"
                     "poisson_ratio = 0.3\n[contact]\npressures = [\"1 MPa\", \"3 MPa\", \"10 MPa\"]\n"
                     "laws = [\"hertz\"]\n");
    REQUIRE(test::run_fstiff("run '" + scene + "' --format csv -o '" + folder / "k.csv" + "'").status == 4);
    repeats("identify '" + scene + "' --measured '" + folder / "k.csv" + "' --fit sigma", 4);
    // both given by hand: the warning stays, but nothing rests on the islands
    folder.write("from.toml",
                 test::replaced(test::read(scene), "[material.upper]",
                                "peak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n[material.upper]"));
    repeats("run '" + scene + "'", 0);
}

TEST_CASE("Heights in a wrong unit end with exit code 4 wherever they enter") {
    const std::string text = profile_text();
    const std::string wrong = "the rms gradient, ", unit = "a unit of its lengths is likely wrong";
    for (const char* command : {"measure -", "fit -", "spectrum -", "peaks --profile -"}) {
        CAPTURE(command);
        const std::string call = std::string(command) + " --format csv";
        CHECK(!test::contains(test::run_fstiff(call, text).err, unit));
        const auto steep = test::run_fstiff(call + " --units m,km", text);
        CHECK(steep.status == 4);
        CHECK(test::contains(steep.err, wrong));
        CHECK(test::contains(steep.err, "is above 1 (measured)"));
        CHECK(test::contains(steep.err, unit));
        CHECK(test::contains(steep.err, "which states m for the heights; the option is used"));
    }
    const auto measured = test::run_fstiff("measure - --units m,km --format json", text);
    CHECK(test::contains(measured.out, "\"implausible_gradient\""));
    const auto run = test::run_fstiff("run --surface - --format csv", measured.out);
    CHECK(run.status == 4);
    CHECK(test::contains(run.err, unit));
}

TEST_CASE("The column of the positions is an option, a key of a scene, and in the JSON") {
    std::string text = "Nr.;X [um];Z [um]\n";
    for (int i = 0; i < 200; ++i)
        text += std::to_string(i + 1) + ";" + std::to_string(0.5 * i) + ";" +
                std::to_string(0.1 * std::sin(i * i % 101)) + "\n";
    const auto plain = test::run_fstiff("measure - --format json", text);
    CHECK(test::contains(plain.out, "positions in column 2, column 1 numbers the points"));
    CHECK(!test::contains(plain.out, "x_column"));
    const auto chosen = test::run_fstiff("measure - --x-column 1 --column 3 --units um --format json", text);
    CHECK(test::contains(chosen.out, "\"x_column\": 1"));
    CHECK(test::contains(chosen.out, "positions in column 1"));
    const test::Folder folder;
    const std::string file = folder.write("nr.csv", text);
    const auto scene = [&](const std::string& key) {
        return "[surface]\nfrom = '" + file + "'\n" + key + "\n" + material + contact;
    };
    CHECK(test::contains(test::run_fstiff("run - --format json", scene("x_column = 2")).out, "surface.x_column"));
    test::check_refused("run -", 3, {":3", "surface.x_column", "from 1 to 4096"}, scene("x_column = 4097"));
    test::check_refused("measure - --column 4097", 2, {"--column"}, text);
}

}  // namespace measure_test
