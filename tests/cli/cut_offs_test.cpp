// SPDX-License-Identifier: BSD-3-Clause
// --lambda-s and --lambda-c of the commands that measure, and the same keys of a scene.
#include "json.hpp"

#include "support/skip.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/profile/level.hpp>
#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>

#include <cmath>

namespace cut_offs_test {

namespace {

std::string map_text() {
    return test::run_fstiff(
               "generate map --points 160 --spacing '1 um' --hurst 0.7 --rms '1 um' --shortest '4 um' --longest '48 "
               "um'")
        .out;
}

bool decided(const nlohmann::json& document, const std::string& words) {
    for (const std::string line : document["source"]["decisions"])
        if (test::contains(line, words)) return true;
    return false;
}

/// But for the order of sums, which the compiler chooses.
bool same(double a, double b) { return std::abs(a - b) < 1e-12 * std::abs(b); }

/// Every \p step th line.
std::string decimated(const std::string& text, std::size_t step) {
    std::string result;
    const auto all = test::lines(text);
    for (std::size_t i = 0; i < all.size(); i += step) result += all[i] + "\n";
    return result;
}

}  // namespace

TEST_CASE("A trace at every 1st to 16th point has one R, D_p and gradient behind one lambda_s, within their errors") {
    const std::string file = std::string(FSTIFF_SURFACES) + "/opdx-3.txt";
    if (!std::filesystem::exists(file)) SKIP_CASE("there is no measured surface " + file);
    const std::string text = test::read(file);
    std::vector<nlohmann::json> found, as_measured;
    for (const std::size_t step : {1u, 2u, 4u, 8u, 16u}) {
        const std::string part = decimated(text, step);
        found.push_back(test::json_of("measure - --units m,m --lambda-s '1 um'", part)["surface"]);
        as_measured.push_back(test::json_of("measure - --units m,m --lambda-s none", part)["surface"]);
    }
    const auto apart = [](const nlohmann::json& a, const nlohmann::json& b) {  // in errors of their difference
        return std::abs(a["value"].get<double>() - b["value"].get<double>()) /
               std::hypot(a["error"].get<double>(), b["error"].get<double>());
    };
    for (const char* name : {"rms_height", "peak_radius", "peak_density", "rms_gradient"})
        for (std::size_t i = 0; i < found.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                CAPTURE(name, i, j);
                CHECK(apart(found[i][name], found[j][name]) < 1.5);
            }
    for (const auto& one : found) {  // computed beforehand by other code, with another treatment of the ends
        CHECK(std::abs(one["peak_radius"]["value"].get<double>() - 150e-6) < 8e-6);
        CHECK(std::abs(one["peak_density"]["value"].get<double>() - 0.7e12) < 0.15e12);
    }
    // without the filter they are apart, which is why it is there
    CHECK(apart(as_measured[0]["peak_radius"], as_measured[4]["peak_radius"]) > 10);
    CHECK(apart(as_measured[0]["rms_gradient"], as_measured[4]["rms_gradient"]) > 10);
}

TEST_CASE("The map that is measured is the one that the library filters, first lambda_s, then lambda_c") {
    const std::string text = map_text();
    const auto map = fstiff::io::read_surface(text, "map").map();
    const auto low = fstiff::gaussian_low_pass(fstiff::remove_form(map, fstiff::MapForm::plane), 8e-6);
    const auto both = fstiff::gaussian_high_pass(low, 40e-6);
    const auto one = test::json_of("measure - --lambda-s '8 um'", text);
    CHECK(same(one["surface"]["rms_height"]["value"], fstiff::rms_height(low)));
    CHECK(one["lambda_s_m"] == 8e-6);
    CHECK(one["lambda_c_m"].is_null());
    CHECK(decided(one, "lambda_s 8 µm (Gaussian, after the form was removed), lambda_c none"));
    const auto two = test::json_of("measure - --lambda-s '8 um' --lambda-c '40 um'", text);
    CHECK(same(two["surface"]["rms_height"]["value"], fstiff::rms_height(both)));
    CHECK(two["lambda_c_m"] == 40e-6);
    CHECK(decided(two, "lambda_c 40 µm (Gaussian, after lambda_s)"));
    const auto islands = test::json_of("islands - --format json --lambda-s '8 um' --lambda-c '40 um'", text);
    CHECK(same(islands["rms_height_m"], fstiff::rms_height(both)));
    CHECK(islands["lambda_c_m"] == 40e-6);
    // behind 8 um the roll-off at 48 um leaves no half decade for D
    const auto fit = test::json_of("fit - --format json --lambda-s '3 um'", text);
    const auto smoothed = fstiff::gaussian_low_pass(fstiff::remove_form(map, fstiff::MapForm::plane), 3e-6);
    CHECK(same(fit["rms_height_m"], fstiff::rms_height(smoothed)));
    CHECK(fit["lambda_s_m"] == 3e-6);
    CHECK(fit["lambda_c_m"].is_null());
    CHECK(fit["x"]["window_m"][0].get<double>() >= 3e-6 * (1 - 1e-9));
}

TEST_CASE("With none nothing is filtered, and the output says so") {
    const std::string text = map_text();
    const auto map = fstiff::io::read_surface(text, "map").map();
    const auto none = test::json_of("measure - --lambda-s none --lambda-c none", text);
    CHECK(same(none["surface"]["rms_height"]["value"],
               fstiff::rms_height(fstiff::remove_form(map, fstiff::MapForm::plane))));
    CHECK(none["lambda_s_m"].is_null());
    CHECK(none["lambda_c_m"].is_null());
    CHECK(decided(none, "lambda_s none (as measured), lambda_c none"));
    for (const char* command : {"fit", "islands"})
        CHECK(test::contains(test::run_fstiff(command + std::string(" - --lambda-s none"), text).out,
                             "lambda_s none (as measured)"));
}

TEST_CASE("Without the options the table chooses lambda_s by the step, and the output says why") {
    const std::string text = map_text();  // steps of 1 um
    const auto plain = test::json_of("measure -", text), given = test::json_of("measure - --lambda-s '5 um'", text);
    CHECK(plain["surface"] == given["surface"]);
    CHECK(plain["lambda_s_m"] == 5e-6);
    CHECK(plain["lambda_c_m"].is_null());
    CHECK(decided(plain,
                  "lambda_s 5 µm (by the table, the index of five steps of 1 µm; Gaussian, after the form was "
                  "removed), lambda_c none (an S-F surface of ISO 25178-2"));
    CHECK(test::json_of("measure - --lambda-s auto --lambda-c auto", text)["surface"] == plain["surface"]);
    const auto blurred = test::json_of("measure - --resolution '7 um'", text);
    CHECK(blurred["lambda_s_m"] == 8e-6);
    CHECK(decided(blurred, "the index of the resolution"));
    for (const char* command : {"fit", "islands"})
        CHECK(test::contains(test::run_fstiff(command + std::string(" -"), text).out, "lambda_s 5 µm (by the table"));
}

TEST_CASE("The table chooses lambda_c of a profile by its Ra, and its D is that of the profile before lambda_c") {
    const std::string made =
        test::run_fstiff("generate profile --points 16384 --spacing '0.5 um' --hurst 0.5 --rms '0.1 um' --longest '0.2 mm'")
            .out;
    const auto measured = test::json_of("measure -", made);
    CHECK(measured["lambda_s_m"] == 2.5e-6);
    CHECK(measured["lambda_c_m"] == 0.25e-3);  // Ra is between 20 nm and 0.1 um
    CHECK(decided(measured, "lambda_c 250 µm (by the table, of Ra "));
    const auto whole = test::json_of("measure - --lambda-c none", made);
    CHECK(whole["lambda_c_m"].is_null());
    CHECK(measured["surface"]["rms_height"]["value"] < whole["surface"]["rms_height"]["value"]);
    const auto fit = test::json_of("fit - --format json", made),
               open = test::json_of("fit - --lambda-c none --format json", made);
    CHECK(fit["structure_function"]["value_m2"] == open["structure_function"]["value_m2"]);
    CHECK(fit["window_m"][0] >= 2.5e-6 * (1 - 1e-12));
    CHECK(fit["window_m"][1] <= 0.25e-3 * (1 + 1e-9));
    CHECK(measured["surface"]["fractal_dimension"]["value"] == fit["fractal_dimension"]);
    const auto tip = test::json_of("measure - --tip-radius '5 um'", made);
    CHECK(tip["lambda_s_m"] == 8e-6);
    CHECK(decided(tip, "the index of a tip of 5 µm"));
    const auto gaussian = test::json_of("measure - --detrend gaussian --cutoff '0.8 mm'", made);  // no other lambda_c
    CHECK(gaussian["lambda_c_m"] == 0.8e-3);
}

TEST_CASE("A file that is too short or too coarse for a default has none, and the output says why") {
    const auto few = test::json_of(
        "measure -", test::run_fstiff("generate map --points 40 --spacing '1 um' --hurst 0.8 --rms '1 um'").out);
    CHECK(few["lambda_s_m"].is_null());
    CHECK(decided(
        few,
        "lambda_s none (as measured; 10 of 5 µm, the index of five steps of 1 µm, do not fit the length of 40 µm)"));
    const auto short_one = test::json_of(
        "measure -", test::run_fstiff("generate profile --points 700 --spacing '0.5 um' --hurst 0.5 --rms '1 um'").out);
    CHECK(short_one["lambda_s_m"] == 2.5e-6);
    CHECK(short_one["lambda_c_m"].is_null());
    CHECK(decided(short_one, "does not hold five of 80 µm"));
    const auto coarse = test::json_of(
        "measure -", test::run_fstiff("generate profile --points 200 --spacing '10 um' --hurst 0.5 --rms '10 nm'").out);
    CHECK(coarse["lambda_s_m"] == 50e-6);
    CHECK(coarse["lambda_c_m"].is_null());
    CHECK(decided(coarse, "too short for the step"));
    CHECK(test::json_of("measure - --lambda-c '5 um'", map_text())["lambda_s_m"].is_null());  // 5 um is not below 5 um
}

TEST_CASE("A scene takes lambda_s and lambda_c beside from, and measures as the command does") {
    const test::Folder folder;
    const std::string text = map_text();
    folder.write("map.txt", text);
    const auto scene = [&](const std::string& keys) {
        return folder.write("scene.toml", "[surface]\nfrom = \"map.txt\"\n" + keys +
                                              "\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = "
                                              "0.3\n[contact]\npressures = [\"10 MPa\"]\n");
    };
    const auto ran =
        test::json_of("run '" + scene("lambda_s = \"8 um\"\nlambda_c = \"40 um\"") + "' --format json", "");
    const auto measured = test::json_of("measure - --lambda-s '8 um' --lambda-c '40 um'", text);
    CHECK(test::contains(ran.dump(), measured["surface"]["peak_radius"]["quantity"].get<std::string>().substr(0, 8)));
    CHECK(test::contains(ran.dump(), "\"lambda_s_m\":8e-06"));
    CHECK(test::contains(test::run_fstiff("run --surface -", measured.dump()).out, "lambda_s 8 µm"));
    const std::string read_back = test::run_fstiff("run --surface - --format json", measured.dump()).out;
    CHECK(test::contains(nlohmann::json::parse(read_back).dump(), "\"lambda_s_m\":8e-06"));
    test::check_refused("run '" + scene("lambda_s = \"1 um\"") + "'", 3, {"lambda_s = \"1 um\"", "at least 2 steps"});
    test::check_refused("run '" + scene("lambda_s = 1.0") + "'", 3, {"lambda_s"});
}

TEST_CASE("Cut-offs that a file cannot hold are refused in one sentence") {
    const std::string text = map_text();  // 160 um x 160 um, steps of 1 um
    const auto check = [&](const std::string& how, int status, const std::vector<std::string>& parts) {
        for (const char* command : {"measure - ", "fit - ", "islands - "})
            test::check_refused(command + how, status, parts, text);
    };
    check("--lambda-s '1.9 um'", 3, {"--lambda-s = \"1.9 um\" cannot be held by this file", "at least 2 steps, 2 µm"});
    check("--lambda-c '4 um'", 3, {"--lambda-c = \"4 um\" cannot be held by this file", "at least 5 steps, 5 µm"});
    check("--lambda-c '161 um'", 3, {"--lambda-c = \"161 um\"", "at most the length of the surface, 160 µm"});
    check("--lambda-s '10 um' --lambda-c '10 um'", 3, {"--lambda-s = 10 µm", "less than --lambda-c"});
    check("--lambda-s 8", 3, {"--lambda-s", "without a unit"});
    check("--lambda-c '8 Pa'", 3, {"--lambda-c"});
    check("--lambda-s '0 um'", 3, {"--lambda-s"});
    std::string profile;
    for (int i = 0; i < 400; ++i) profile += std::to_string(std::sin(i * i * 0.1)) + "\n";
    test::check_refused("fit - --units um --spacing '1 um' --detrend gaussian --cutoff '80 um' --lambda-c '40 um'", 2,
                        {"--cutoff", "another cut-off"}, profile);
    const auto document =
        test::json_of("measure - --units um --spacing '1 um' --detrend gaussian --cutoff '80 um'", profile);
    CHECK(document["lambda_c_m"] == 80e-6);
}

TEST_CASE("The robust filter of lambda_c is that of the library, and says what it left out") {
    const std::string text = map_text();
    const auto map = fstiff::remove_form(fstiff::io::read_surface(text, "map").map(), fstiff::MapForm::plane);
    const auto document = test::json_of("measure - --lambda-s none --lambda-c '40 um' --filter robust", text);
    CHECK(same(document["surface"]["rms_height"]["value"], fstiff::rms_height(fstiff::robust_high_pass(map, 40e-6))));
    CHECK(decided(document, "lambda_c 40 µm (robust Gaussian, after the form was removed, "));
    CHECK(decided(document, " of 25600 points without weight, "));
    const std::string made =
        test::run_fstiff("generate profile --points 4096 --spacing '1 um' --hurst 0.5 --rms '1 um'").out;
    const auto flat = fstiff::level(fstiff::io::read_surface(made, "profile").profile(), fstiff::Form::line);
    const auto profile = test::json_of("measure - --lambda-s none --lambda-c '80 um' --filter robust", made);
    CHECK(same(profile["surface"]["rms_height"]["value"],
               fstiff::rms_height(fstiff::robust_roughness(flat.profile, 80e-6))));
    CHECK(decided(profile, "robust Gaussian"));
    CHECK(profile["filter"] == "robust");
    CHECK(test::json_of("measure - --lambda-s none --lambda-c none --filter robust", made)["filter"].is_null());
    test::check_refused("measure - --filter spline", 2, {"--filter", "spline"}, made);
}

}  // namespace cut_offs_test
