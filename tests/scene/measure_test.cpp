// SPDX-License-Identifier: BSD-3-Clause
// What is measured of a file, as a document and as the surface of a scene; the band of K of both.
#include "support/library.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/measure/parameters.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/topography/form.hpp>

#include <cmath>

namespace measure_test {

using namespace fstiff;
using test::contains;

namespace {

const std::string material = "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n";
const std::string contact = "[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\n";
const std::string rest = material + contact;
/// Laws that take numbers alone, whatever they were measured from.
const std::string laws = "laws = [\"fractal\", \"hertz\", \"greenwood_williamson\"]\n";
const std::string numbers =
    "[surface]\nrms_height = \"1 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\nfractal_dimension = "
    "1.5\n";

std::string map_text() {
    return test::map_text(128, 1e-6,
                          {.hurst = 0.7, .rms = 1e-6, .longest_wavelength = 64e-6, .shortest_wavelength = 8e-6});
}
std::string profile_text() {
    return test::profile_text(4096, 1e-6,
                              {.hurst = 0.6, .rms = 1e-6, .longest_wavelength = 400e-6, .shortest_wavelength = 16e-6});
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
std::vector<Row> rows_of(const std::string& text) {
    const test::Csv csv = test::rows_of_scene(text);
    std::vector<Row> rows;
    for (std::size_t i = 0; i < csv.size(); ++i)
        rows.push_back({csv.number(i, "stiffness_Pa_per_m"), csv.number(i, "stiffness_p05_Pa_per_m"),
                        csv.number(i, "stiffness_p95_Pa_per_m")});
    return rows;
}

/// The sentence in which \p bytes are refused with the options of \p line.
std::string refused(const std::string& line, const std::string& bytes) {
    return test::refusal([&] { (void)test::measured(line, bytes); });
}

}  // namespace

TEST_CASE("What is measured of a file is what the headers measure, to the last digit") {
    SECTION("of a map") {
        const std::string text = map_text();
        const auto map =
            fstiff::detail::remove_form(fstiff::io::read_surface(text, "map").map(), fstiff::MapForm::plane);
        check_measured(test::measured("--lambda-s none", text)["surface"], fstiff::detail::surface_parameters(map));
        fstiff::detail::SurfaceParameterOptions<double> summits;
        summits.peaks = fstiff::PeakSource::summits;
        check_measured(test::measured("--lambda-s none --peaks summits", text)["surface"],
                       fstiff::detail::surface_parameters(map, summits));
    }
    SECTION("of a profile") {
        const std::string text = profile_text();
        const auto profile =
            fstiff::detail::level(fstiff::io::read_surface(text, "profile").profile(), fstiff::Form::line);
        fstiff::detail::SurfaceParameterOptions<double> how;
        how.seed = how.fit.seed = 7;
        how.resamples = 100;
        check_measured(test::measured("--lambda-s none --lambda-c none", text,
                                      {.input = {}, .resamples = 100, .seed = 7})["surface"],
                       fstiff::detail::surface_parameters(profile, how));
    }
}

TEST_CASE(
    "A measured quantity is written so that a scene takes it, and as a document gives the same K to the last digit") {
    const test::Folder folder;
    const auto document = test::measured("", map_text());
    std::string text = "[surface]\n";
    for (const char* name : {"rms_height", "peak_radius", "peak_density", "max_peak_height", "fractal_roughness"})
        text += std::string(name) + " = \"" + document["surface"][name]["quantity"].get<std::string>() + "\"\n";
    for (const char* name : {"fractal_dimension", "r", "theta"})
        text += std::string(name) + " = " + document["surface"][name]["value"].dump() + "\n";
    const test::Csv written = test::rows_of_scene(text + rest + laws);
    folder.write("m.json", document.dump());
    const test::Csv read = test::rows_of_scene("[surface]\nfrom = \"m.json\"\n" + rest + laws, folder / "scene.toml");
    REQUIRE(written.size() == 6);
    REQUIRE(read.size() == 6);
    for (std::size_t i = 0; i < 6; ++i)
        CHECK(written.number(i, "stiffness_Pa_per_m") == read.number(i, "stiffness_Pa_per_m"));
}

TEST_CASE("A scene takes its surface from a file next to it, from the document of it, or from outside, all the same") {
    const test::Folder folder;
    const std::string map = folder.write("map.txt", map_text());
    folder.write("measured.json", test::measured_files("", {map}).dump());
    const std::string file = folder / "scene.toml";
    const auto from = [&](const std::string& surface) {
        return test::scene_of("[surface]\nfrom = \"" + surface + "\"\n" + rest + laws, file);
    };
    const scene::Scene direct = from("map.txt"), indirect = from("measured.json");
    const std::string rows = test::csv_of(actions::compute(direct));
    CHECK(rows == test::csv_of(actions::compute(indirect)));
    CHECK(direct.samples == 400);
    REQUIRE(test::face(direct).measured);
    REQUIRE(test::face(indirect).measured);
    CHECK(test::measured_of(direct).sha256 == test::measured_of(indirect).sha256);
    CHECK(test::parsed(actions::measured_document(test::measured_of(direct)))["surface"] ==
          test::parsed(actions::measured_document(test::measured_of(indirect)))["surface"]);
    // the scene's own numbers give way
    const scene::Scene replaced =
        scene::read_scene(numbers + rest + laws, {.name = file, .surface = folder / "measured.json"});
    CHECK(test::csv_of(actions::compute(replaced)) == rows);
}

TEST_CASE("A key next to surface.from replaces what was measured") {
    const test::Folder folder;
    folder.write("map.txt", map_text());
    const auto of = [&](const std::string& more) {
        return test::scene_of("[surface]\nfrom = \"map.txt\"\n" + more + rest, folder / "s.toml");
    };
    const scene::Scene measured = of(""), replaced = of("rms_height = \"2 um\"\n"),
                       summits = of("peaks = \"summits\"\n");
    CHECK(test::face(replaced).parameters.rms_height.value == 2e-6);
    CHECK(actions::compute(replaced).curves()[0].points[0].state.stiffness.value !=
          actions::compute(measured).curves()[0].points[0].state.stiffness.value);
    CHECK(test::face(summits).parameters.peak_radius.value != test::face(measured).parameters.peak_radius.value);
}

TEST_CASE("Zero errors give a zero-width band, and no errors give none") {
    const std::string rest = measure_test::rest + laws;
    CHECK_FALSE(contains(test::csv_of(test::results_of(numbers + rest)), "stiffness_p05"));
    // an error of 1e-9 of sigma moves K by some 1e-9 of itself
    for (const Row& row : rows_of(numbers + "errors = { rms_height = \"1e-9 um\" }\n" + rest)) {
        CHECK(row.low <= row.stiffness);
        CHECK(row.high >= row.stiffness);
        CHECK(test::relative_error(row.low, row.stiffness) < 1e-8);
        CHECK(test::relative_error(row.high, row.stiffness) < 1e-8);
    }
    CHECK(test::csv_of(test::results_of(numbers + "errors = { rms_height = \"0 um\", peak_density = \"0 /mm^2\" }\n" +
                                        rest)) == test::csv_of(test::results_of(numbers + rest)));
    test::check_sentence(test::refused_scene(numbers + "errors = { rms_height = \"-1 um\" }\n" + rest),
                         {"surface.errors.rms_height", "not negative"});
}

TEST_CASE("A plane and a line are refused, their rounding is not measured") {
    std::string plane, line;
    for (int j = 0; j < 64; ++j) {
        for (int i = 0; i < 64; ++i) plane += std::to_string(i + j) + (i < 63 ? "," : "\n");
        line += std::to_string(j) + "\n";
    }
    for (const std::string form : {"plane", "quadratic", "cubic"})
        test::check_sentence(refused("--units um --dx '1 um' --dy '1 um' --detrend " + form, plane),
                             {"map of constant height", form});
    for (const std::string form : {"line", "parabola"})
        test::check_sentence(refused("--units um --spacing '1 um' --detrend " + form, line),
                             {"profile of constant height", form});
}

TEST_CASE("A surface as short as its longest waves warns that sigma is that of its length") {
    const auto measured = [](double longest) {
        return test::measured(
            "--lambda-c none",
            test::profile_text(4096, 1e-6, {.hurst = 0.8, .rms = 1e-6, .longest_wavelength = longest, .seed = 3}));
    };
    const auto short_one = measured(0), long_one = measured(128e-6);
    const std::string sentence =
        " % of the mean square height is from waves longer than an eighth of the profile: sigma is that of this length";
    CHECK(contains(short_one["warnings"].dump(), sentence));
    CHECK_FALSE(contains(long_one["warnings"].dump(), sentence));
    const auto error = [](const nlohmann::json& one) {
        const auto& sigma = one["surface"]["rms_height"];
        return sigma["error"].get<double>() / sigma["value"].get<double>();
    };
    CHECK(error(short_one) > 4 * error(long_one));
}

TEST_CASE("The number for missing points is an option, a key of a scene, and in the document") {
    std::string map;
    for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i)
            map += ((i + j) % 17 == 0 ? std::string("-9999") : std::to_string(std::sin(i * i + 3.0 * j * i))) +
                   (i < 63 ? "," : "\n");
    const std::string how = "--units um --dx '1 um' --dy '1 um'";
    test::check_sentence(refused(how, map), {"-9999 um", "--missing \"-9999\""});
    CHECK(test::decided(test::measured(how + " --missing -9999", map), "missing (-9999, from options)"));
    const test::Folder folder;
    folder.write("map.csv", map);
    for (const char* missing : {"-9999", "\"-9999\""})
        CHECK(test::refused_scene(
                  "[surface]\nfrom = \"map.csv\"\nunits = \"um\"\ndx = \"1 um\"\ndy = \"1 um\"\nmissing = " +
                      std::string(missing) + "\nfractal_dimension = 1.5\n" + rest,
                  folder / "scene.toml")
                  .empty());
}

TEST_CASE("The band of one uncertain parameter lies at its own quantiles", "[more]") {
    // K falls as sigma grows: the 5 % of K is K at the 95 % of sigma, which is median exp(1.6449 s), s^2 = ln(1 +
    // 0.2^2)
    const auto text = [](double sigma, const std::string& errors) {
        return "[surface]\nrms_height = \"" + std::to_string(sigma) +
               " um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\nfractal_dimension = 1.5\n" + errors +
               rest + "laws = [\"fractal\", \"greenwood_williamson\"]\n[uncertainty]\nsamples = 4000\nseed = 3\n";
    };
    const double s = std::sqrt(std::log(1.04)), z = 1.6448536269514722;
    const auto band = rows_of(text(1, "errors = { rms_height = \"0.2 um\" }\n"));
    const auto stiffness_at = [&](double sigma) { return test::rows_of_scene(text(sigma, "")); };
    const test::Csv low = stiffness_at(std::exp(z * s)), high = stiffness_at(std::exp(-z * s));
    REQUIRE(band.size() == 6);
    for (std::size_t i = 0; i < band.size(); ++i) {
        CAPTURE(i);
        const double least = low.number(i, "stiffness_Pa_per_m"), most = high.number(i, "stiffness_Pa_per_m");
        // the 5 % point of 4000 samples scatters by sqrt(0.05 0.95/4000)/0.103 = 0.033 standard deviations, 2 % of
        // 1.645; four of those
        const double half = std::log(band[i].high / band[i].low) / 2, expected = std::log(most / least) / 2;
        CHECK(expected > 0.1);
        CHECK(std::abs(half - expected) < 0.08 * expected);
        CHECK(std::abs(std::log(band[i].low / least)) < 0.16 * expected);
        CHECK(std::abs(std::log(band[i].high / most)) < 0.16 * expected);
    }
}

TEST_CASE("The same seed gives the same band, another seed another, and samples = 0 none") {
    const test::Folder folder;
    folder.write("map.txt", map_text());
    const auto csv = [&](const std::string& uncertainty) {
        return test::csv_of(
            test::results_of("[surface]\nfrom = \"map.txt\"\n" + rest + laws + uncertainty, folder / "scene.toml"));
    };
    const std::string first = csv("");
    CHECK(first == csv("[uncertainty]\nsamples = 400\nseed = 2014\n"));
    CHECK(first != csv("[uncertainty]\nseed = 2015\n"));
    CHECK_FALSE(contains(csv("[uncertainty]\nsamples = 0\n"), "stiffness_p05"));
}

TEST_CASE("A file that is not a surface is refused, alone, by surface.from and from outside of the scene") {
    const test::Folder folder;
    const std::string map = folder.write("map.txt", map_text());
    test::check_sentence(refused("", "1\n2\n3\n1\n2\n"), {"standard input", "unit"});
    test::check_sentence(refused("--spacing '1 um' --units um", std::string(200, '1') + "\n"), {"standard input"});
    test::check_sentence(test::refusal([] { (void)test::measured_files("", {"nowhere.sdf"}); }),
                         {"nowhere.sdf", "no such file"});
    test::check_sentence(test::refusal([&] { (void)test::measured_files("--tip-radius '2 um'", {map}); }),
                         {"map.txt", "map", "resolution"});
    const auto outside = [&](const std::string& bytes) {
        const std::string file = bytes.empty() ? "nowhere.sdf" : folder.write("surface.txt", bytes);
        return test::refusal(
            [&] { (void)scene::read_scene("[surface]\n" + rest, {.name = "s.toml", .surface = file}); });
    };
    test::check_sentence(outside(""), {"--surface", "nowhere.sdf", "no such file"});
    test::check_sentence(outside("1\n2\n3\n1\n2\n"), {"surface.txt", "given as fstiff measure --units",
                                                      "; --surface reads the JSON that fstiff measure prints"});
    test::check_sentence(outside("{\"command\": \"fit\"}"), {"surface.txt", "not the JSON of fstiff measure"});
    test::check_sentence(outside("{\"command\": \"mea"), {"surface.txt", "not the JSON"});
    const auto in_scene = [&](const std::string& lines, const std::vector<std::string>& parts) {
        test::check_sentence(test::refused_scene("[surface]\n" + lines + rest), parts);
    };
    in_scene("from = \"nowhere.txt\"\n", {"scene.toml:2", "surface.from", "nowhere.txt"});
    in_scene("from = 3\n", {"scene.toml:2", "surface.from"});
    in_scene("from = \"\"\n", {"scene.toml:2", "surface.from"});
    in_scene("units = \"um\"\n", {"scene.toml:2", "surface.units", "unknown key", "\"from\""});
    const std::string from = "from = '" + map + "'\n";
    in_scene(from + "column = 0\n", {":3", "surface.column", "whole number"});
    in_scene(from + "x_column = 4097\n", {":3", "surface.x_column", "from 1 to 4096"});
    in_scene(from + "peaks = \"hills\"\n", {":3", "surface.peaks", "islands"});
    in_scene(from + "spacing = \"1 um\"\n", {"surface.from", "128 columns"});
    in_scene(from + "r = 1.0\n", {":3", "surface.r", "less than 1"});
    in_scene(from + "[uncertainty]\nsamples = 3\n", {":4", "uncertainty.samples"});
}

TEST_CASE("An option of a surface that makes no sense is refused in the words it was given in") {
    std::string heights;
    for (int i = 0; i < 600; ++i) heights += std::to_string(std::sin(0.3 * i) + 0.2 * std::sin(i * i)) + "\n";
    const auto check = [&](const std::string& options, const std::string& part) {
        test::check_sentence(refused("--units um " + options, heights), {part});
    };
    const std::string step = "--spacing '0.5 um' ";
    check("--spacing '-0.5 um'", "--spacing = \"-0.5 um\": must be greater than 0");
    check("--spacing '0,5 um'", "--spacing = \"0,5 um\": has a comma; the decimal mark is the point");
    check(step + "--lambda-c '299.50001 um'",
          "--lambda-c = \"299.50001 um\": must be at most the length of the surface, 299.5 µm");
    check(step + "--lambda-s '0.9 um'", "--lambda-s = \"0.9 um\" cannot be held");
    check(step + "--window '10 um'", "--window = \"10 um\": must be two lengths");
    check(step + "--window '0,8 um,80 um'", "two lengths with one comma between them; the decimal mark is the point");
    check(step + "--window '10 um,1 um'", "--window = \"10 um,1 um\": the first length must be less");
    check(step + "--peaks summits", "--peaks = \"summits\" is for a map; standard input holds a profile");
    CHECK(refused("--units um " + step + "--lambda-c '299.5 um'", heights).empty());  // as long as the profile: allowed
    // what does not fit the file is a fault of the caller, and a value that is none one of the data
    CHECK_THROWS_AS(test::measured("--units um " + step + "--window '10 um'", heights), document::option_error);
    surface::MeasureOptions how;
    how.input = test::surface_options("--units um " + step);
    const std::string document = test::values_of(how, surface::measure_surface(how, heights)).str();
    test::check_sentence(refused("", document), {"standard input: is JSON that fstiff printed", "run --surface"});
    std::string rise;
    for (int i = 0; i < 600; ++i) rise += i < 300 ? "0\n" : "1\n";
    test::check_sentence(refused("--units um " + step, rise), {"or of one step", "distinguished from rounding"});
}

TEST_CASE("A changed document of a measurement is refused where it was changed") {
    const auto document = test::measured("", map_text());
    const auto check = [](const nlohmann::json& changed, const std::vector<std::string>& parts) {
        test::check_sentence(test::refusal([&] { (void)surface::read_measured_document(changed.dump(), "m.json"); }),
                             parts);
    };
    auto changed = document;
    changed["surface"]["rms_height"].erase("value");
    check(changed, {"m.json", "surface.rms_height", "value"});
    changed = document;
    changed["surface"].erase("peak_radius");
    check(changed, {"surface.peak_radius", "missing"});
    changed = document;
    changed["surface"]["fractal_dimension"]["value"] = 2.5;
    check(changed, {"fractal_dimension", "2.5"});
    changed = document;
    changed["surface"]["r"]["error"] = -1;
    check(changed, {"r", "-1"});
    changed = document;
    changed["correlation_of_errors"]["matrix"][1][2] = 5;
    check(changed, {"correlation"});
    changed = document;
    changed["schema_version"] = 7;
    check(changed, {"schema_version"});
}

TEST_CASE("Islands densest at an end are a concern of the file, its islands and every scene of it", "[more]") {
    const test::Folder folder;
    const std::string text = test::two_hills();
    const std::string options = "--units um,nm --dx '1 um' --dy '1 um'";
    const auto document = test::measured(options, text);
    const std::string said = "must not be used as a pair";
    CHECK(contains(document["concerns"].dump(), "\"no_densest_level\""));
    CHECK(contains(document["warnings"].dump(), said));
    const auto islands = test::islands_of(options, text);
    CHECK(islands["doubtful"] == true);
    CHECK(contains(islands["warnings"].dump(), said));
    folder.write("hills.json", document.dump());
    const auto results = [&](const std::string& keys) {
        return test::results_of("[surface]\nfrom = \"hills.json\"\n" + keys + rest + "laws = [\"hertz\"]\n",
                                folder / "scene.toml");
    };
    CHECK(results("").doubtful);
    CHECK(contains(test::joined(results("").warnings), said));
    // all given by hand: the warning stays, but nothing rests on the islands
    const auto by_hand = results("rms_height = \"1 um\"\npeak_radius = \"40 um\"\npeak_density = \"500 /mm^2\"\n");
    CHECK_FALSE(by_hand.doubtful);
    CHECK(contains(test::joined(by_hand.warnings), said));
}

TEST_CASE("Heights in a wrong unit are doubted wherever they enter") {
    const test::Folder folder;
    const std::string text = profile_text();
    const std::string wrong = "the rms gradient, ", unit = "a unit of its lengths is likely wrong";
    const auto check = [&](const nlohmann::json& sound, const nlohmann::json& steep) {
        CHECK_FALSE(contains(sound["warnings"].dump(), unit));
        for (const std::string& part : {wrong, unit, std::string("is above 1 (measured)")})
            CHECK(contains(steep["warnings"].dump(), part));
        CHECK(contains(test::joined(steep["warnings"]), "which states m for the heights; the option is used"));
    };
    check(test::measured("", text), test::measured("--units m,km", text));
    check(test::fitted("", text), test::fitted("--units m,km", text));
    const auto measured = test::measured("--units m,km", text);
    CHECK(contains(measured["concerns"].dump(), "\"implausible_gradient\""));
    folder.write("steep.json", measured.dump());
    const auto results = test::results_of("[surface]\nfrom = \"steep.json\"\n" + rest, folder / "scene.toml");
    CHECK(results.doubtful);
    CHECK(contains(test::joined(results.warnings), unit));
}

TEST_CASE("The column of the positions is an option, a key of a scene, and in the document") {
    std::string text = "Nr.;X [um];Z [um]\n";
    for (int i = 0; i < 200; ++i)
        text += std::to_string(i + 1) + ";" + std::to_string(0.5 * i) + ";" +
                std::to_string(0.1 * std::sin(i * i % 101)) + "\n";
    const auto plain = test::measured("", text);
    CHECK(test::decided(plain, "positions [um] in column 2; column 1 numbers the points"));
    CHECK_FALSE(plain["inputs"].contains("x_column"));
    const auto chosen = test::measured("--x-column 1 --column 3 --units um", text);
    CHECK(chosen["inputs"]["x_column"] == 1);
    CHECK(test::decided(chosen, "positions [um] in column 1"));
    const test::Folder folder;
    folder.write("nr.csv", text);
    const scene::Scene read =
        test::scene_of("[surface]\nfrom = \"nr.csv\"\nx_column = 2\n" + rest, folder / "scene.toml");
    CHECK(std::any_of(read.inputs.begin(), read.inputs.end(),
                      [](const request::Input& one) { return one.key == "surface.x_column" && one.value == 2; }));
}

TEST_CASE("Numbers of a measured surface beyond all reason are refused in one sentence or give no other") {
    const auto measured = test::measured("", test::map_text(32, 1e-6, {.hurst = 0.8, .rms = 1e-6}));
    const test::Folder folder;
    for (const char* key : {"rms_height", "rms_gradient"})
        for (const double value : {1e308, 1e155, 1e-170, 1e-308}) {
            auto changed = measured;
            changed["surface"][key]["value"] = value;
            folder.write("m.json", changed.dump());
            INFO(key << " = " << value);
            std::string said;
            const std::string sentence = test::refusal([&] {
                said = test::joined(test::results_of("[surface]\nfrom = \"m.json\"\n" + rest + "laws = [\"hybrid\"]\n",
                                                     folder / "scene.toml")
                                        .warnings);
            });
            CHECK(contains(sentence.empty() ? said : sentence,
                           sentence.empty() ? "beyond the range of double" : "must be "));
        }
}

}  // namespace measure_test
