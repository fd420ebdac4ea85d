// SPDX-License-Identifier: BSD-3-Clause
// lambda_s and lambda_c of what is measured, fitted and cut into islands, and the same keys of a scene.
#include "support/library.hpp"

#include "support/skip.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>

#include <cmath>
#include <filesystem>

namespace cut_offs_test {

namespace {

std::string map_text() {
    return test::map_text(160, 1e-6,
                          {.hurst = 0.7, .rms = 1e-6, .longest_wavelength = 48e-6, .shortest_wavelength = 4e-6});
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

TEST_CASE("A trace at every 1st to 16th point has one R, D_p and gradient with one lambda_s, within their errors") {
    const std::string file = std::string(FSTIFF_SURFACES) + "/opdx-3.txt";
    if (!std::filesystem::exists(file)) SKIP_CASE("there is no measured surface " + file);
    const std::string text = test::read(file);
    std::vector<nlohmann::json> found, as_measured;
    for (const std::size_t step : {1u, 2u, 4u, 8u, 16u}) {
        const std::string part = decimated(text, step);
        found.push_back(test::measured("--units m,m --lambda-s '1 um'", part)["surface"]);
        as_measured.push_back(test::measured("--units m,m --lambda-s none", part)["surface"]);
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
    const auto low = fstiff::detail::gaussian_low_pass(fstiff::detail::remove_form(map, fstiff::MapForm::plane), 8e-6);
    const auto both = fstiff::detail::gaussian_high_pass(low, 40e-6);
    const auto one = test::measured("--lambda-s '8 um'", text);
    CHECK(same(one["surface"]["rms_height"]["value"], fstiff::rms_height(low)));
    CHECK(one["lambda_s_m"] == 8e-6);
    CHECK(one["lambda_c_m"].is_null());
    CHECK(test::decided(one, "lambda_s 8 µm (Gaussian, after the form was removed), lambda_c none"));
    const auto two = test::measured("--lambda-s '8 um' --lambda-c '40 um'", text);
    CHECK(same(two["surface"]["rms_height"]["value"], fstiff::rms_height(both)));
    CHECK(two["lambda_c_m"] == 40e-6);
    CHECK(test::decided(two, "lambda_c 40 µm (Gaussian, after lambda_s)"));
    const auto islands = test::islands_of("--lambda-s '8 um' --lambda-c '40 um'", text);
    CHECK(same(islands["rms_height_m"], fstiff::rms_height(both)));
    CHECK(islands["lambda_c_m"] == 40e-6);
    // after 8 um the roll-off at 48 um leaves no half decade for D
    const auto fit = test::fitted("--lambda-s '3 um'", text);
    const auto smoothed =
        fstiff::detail::gaussian_low_pass(fstiff::detail::remove_form(map, fstiff::MapForm::plane), 3e-6);
    CHECK(same(fit["rms_height_m"], fstiff::rms_height(smoothed)));
    CHECK(fit["lambda_s_m"] == 3e-6);
    CHECK(fit["lambda_c_m"].is_null());
    CHECK(fit["x"]["window_m"][0].get<double>() >= 3e-6 * (1 - 1e-9));
}

TEST_CASE("With none nothing is filtered, and the output states it") {
    const std::string text = map_text();
    const auto map = fstiff::io::read_surface(text, "map").map();
    const auto none = test::measured("--lambda-s none --lambda-c none", text);
    CHECK(same(none["surface"]["rms_height"]["value"],
               fstiff::rms_height(fstiff::detail::remove_form(map, fstiff::MapForm::plane))));
    CHECK(none["lambda_s_m"].is_null());
    CHECK(none["lambda_c_m"].is_null());
    CHECK(test::decided(none, "lambda_s none (as measured), lambda_c none"));
    CHECK(test::fitted("--lambda-s none", text)["lambda_s_m"].is_null());
    CHECK(test::islands_of("--lambda-s none", text)["lambda_s_m"].is_null());
}

TEST_CASE("Without the options the table chooses lambda_s by the step, and the output gives the reason") {
    const std::string text = map_text();  // steps of 1 um
    const auto plain = test::measured("", text), given = test::measured("--lambda-s '5 um'", text);
    CHECK(plain["surface"] == given["surface"]);
    CHECK(plain["lambda_s_m"] == 5e-6);
    CHECK(plain["lambda_c_m"].is_null());
    CHECK(test::decided(plain,
                        "lambda_s 5 µm (by the table, the index of five steps of 1 µm; Gaussian, after the form was "
                        "removed), lambda_c none (the form alone bounds the long waves)"));
    CHECK(test::measured("--lambda-s auto --lambda-c auto", text)["surface"] == plain["surface"]);
    const auto blurred = test::measured("--resolution '7 um'", text);
    CHECK(blurred["lambda_s_m"] == 8e-6);
    CHECK(test::decided(blurred, "the index of the resolution"));
    CHECK(test::fitted("", text)["lambda_s_m"] == 5e-6);
    CHECK(test::islands_of("", text)["lambda_s_m"] == 5e-6);
}

TEST_CASE("The table chooses lambda_c of Ra alone, and sigma and D are those of all waves") {
    const std::string made =
        test::profile_text(16384, 0.5e-6, {.hurst = 0.5, .rms = 0.1e-6, .longest_wavelength = 0.2e-3});
    const auto measured = test::measured("", made), whole = test::measured("--lambda-c none", made);
    CHECK(measured["lambda_s_m"] == 2.5e-6);
    CHECK(measured["lambda_c_m"].is_null());
    CHECK(test::decided(measured, "lambda_c none (the form alone bounds the long waves)"));
    CHECK(measured["roughness"]["lambda_c_m"] == 0.25e-3);  // Ra is between 20 nm and 0.1 um
    CHECK(whole["roughness"]["lambda_c_m"].is_null());
    CHECK(measured["surface"] == whole["surface"]);
    CHECK(same(whole["roughness"]["Rq_m"], whole["surface"]["rms_height"]["value"]));
    const auto cut = test::measured("--lambda-c '0.25 mm'", made);
    CHECK(cut["lambda_c_m"] == 0.25e-3);
    CHECK(cut["surface"]["rms_height"]["value"] < whole["surface"]["rms_height"]["value"]);
    CHECK(same(cut["surface"]["rms_height"]["value"], measured["roughness"]["Rq_m"]));
    CHECK(same(cut["roughness"]["Ra_m"], measured["roughness"]["Ra_m"]));
    const auto fit = test::fitted("", made), of_cut = test::fitted("--lambda-c '0.25 mm'", made);
    CHECK(fit["structure_function"]["value_m2"] == of_cut["structure_function"]["value_m2"]);
    CHECK(fit["window_m"][0] >= 2.5e-6 * (1 - 1e-12));
    CHECK(of_cut["window_m"][1] <= 0.25e-3 * (1 + 1e-9));
    CHECK(measured["surface"]["fractal_dimension"]["value"] == fit["fractal_dimension"]);
    const auto tip = test::measured("--tip-radius '5 um'", made);
    CHECK(tip["lambda_s_m"] == 8e-6);
    CHECK(test::decided(tip, "the index of a tip of 5 µm"));
    const auto gaussian = test::measured("--detrend gaussian --cutoff '0.8 mm'", made);  // no other lambda_c
    CHECK(gaussian["lambda_c_m"] == 0.8e-3);
}

TEST_CASE("A file that is too short or too coarse for a default has none, and the output gives the reason") {
    const auto few = test::measured("", test::map_text(40, 1e-6, {.hurst = 0.8, .rms = 1e-6}));
    CHECK(few["lambda_s_m"].is_null());
    CHECK(test::decided(
        few,
        "lambda_s none (as measured; 10 of 5 µm, the index of five steps of 1 µm, do not fit the length of 40 µm)"));
    const auto short_one = test::measured("", test::profile_text(700, 0.5e-6, {.hurst = 0.5, .rms = 1e-6}));
    CHECK(short_one["lambda_s_m"] == 2.5e-6);
    CHECK(short_one["roughness"]["lambda_c_m"].is_null());
    const auto why = [](const std::string& bytes) {
        const auto measured = fstiff::surface::measure_surface({}, bytes);
        return fstiff::surface::sentence_of(fstiff::actions::roughness_of(measured).cut_offs);
    };
    CHECK(test::contains(why(test::profile_text(700, 0.5e-6, {.hurst = 0.5, .rms = 1e-6})),
                         "does not hold five of 80 µm"));
    const auto coarse = test::measured("", test::profile_text(200, 10e-6, {.hurst = 0.5, .rms = 10e-9}));
    CHECK(coarse["lambda_s_m"] == 50e-6);
    CHECK(coarse["roughness"]["lambda_c_m"].is_null());
    CHECK(test::contains(why(test::profile_text(200, 10e-6, {.hurst = 0.5, .rms = 10e-9})), "too short for the step"));
    CHECK(test::measured("--lambda-c '5 um'", map_text())["lambda_s_m"].is_null());  // 5 um is not below 5 um
}

TEST_CASE("A scene takes lambda_s and lambda_c next to from, and measures what is measured alone") {
    const test::Folder folder;
    const std::string text = map_text();
    folder.write("map.txt", text);
    const std::string rest =
        "\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
        "[contact]\npressures = [\"10 MPa\"]\n";
    const auto scene_with = [&](const std::string& keys) {
        return test::scene_of("[surface]\nfrom = \"map.txt\"\n" + keys + rest, folder / "scene.toml");
    };
    const auto scene = scene_with("lambda_s = \"8 um\"\nlambda_c = \"40 um\"");
    const auto measured = test::measured("--lambda-s '8 um' --lambda-c '40 um'", text);
    CHECK(test::face(scene).parameters.peak_radius.value == measured["surface"]["peak_radius"]["value"]);
    CHECK(test::face(scene).measured->cut_offs.lambda_s == 8e-6);
    CHECK(test::face(scene).measured->cut_offs.lambda_c == 40e-6);
    folder.write("map.json", measured.dump());
    const auto read_back = test::scene_of("[surface]\nfrom = \"map.json\"" + rest, folder / "scene.toml");
    CHECK(test::face(read_back).measured->cut_offs.lambda_s == 8e-6);
    const auto refused = [&](const std::string& keys) { return test::refusal([&] { (void)scene_with(keys); }); };
    test::check_sentence(refused("lambda_s = \"1 um\""), {"lambda_s = \"1 um\"", "at least 2 steps"});
    test::check_sentence(refused("lambda_s = 1.0"), {"lambda_s"});
}

TEST_CASE("Cut-offs that a file cannot hold are refused in one sentence") {
    const std::string text = map_text();  // 160 um x 160 um, steps of 1 um
    const auto check = [&](const std::string& how, const std::vector<std::string>& parts) {
        test::check_sentence(test::refusal([&] { (void)test::measured(how, text); }), parts);
        test::check_sentence(test::refusal([&] { (void)test::fitted(how, text); }), parts);
        test::check_sentence(test::refusal([&] { (void)test::islands_of(how, text); }), parts);
    };
    check("--lambda-s '1.9 um'", {"--lambda-s = \"1.9 um\" cannot be held by this file", "at least 2 steps, 2 µm"});
    check("--lambda-c '4 um'", {"--lambda-c = \"4 um\" cannot be held by this file", "at least 5 steps, 5 µm"});
    check("--lambda-c '161 um'", {"--lambda-c = \"161 um\"", "at most the length of the surface, 160 µm"});
    check("--lambda-s '10 um' --lambda-c '10 um'", {"--lambda-s = 10 µm", "less than --lambda-c"});
    check("--lambda-s 8", {"--lambda-s", "without a unit"});
    check("--lambda-c '8 Pa'", {"--lambda-c"});
    check("--lambda-s '0 um'", {"--lambda-s"});
    std::string profile;
    for (int i = 0; i < 400; ++i) profile += std::to_string(std::sin(i * i * 0.1)) + "\n";
    const std::string gaussian = "--units um --spacing '1 um' --detrend gaussian --cutoff '80 um'";
    test::check_sentence(test::refusal([&] { (void)test::fitted(gaussian + " --lambda-c '40 um'", profile); }),
                         {"--cutoff", "another cut-off"});
    CHECK_THROWS_AS(test::fitted(gaussian + " --lambda-c '40 um'", profile), fstiff::document::option_error);
    CHECK(test::measured(gaussian, profile)["lambda_c_m"] == 80e-6);
}

TEST_CASE("A face has the waves of a contact larger than its trace, measured now or read back") {
    const test::Folder folder;
    const std::string trace =
        folder.write("trace.csv", test::profile_text(2000, 1.5e-6, {.hurst = 0.6, .rms = 0.4e-6}));
    auto document = test::measured("", test::read(trace));
    CHECK(same(document["long_end"]["side_m"], 3e-3 / std::sqrt(2.0)));
    const auto unmeasured = [&](const std::string& from, const std::string& keys = "") {
        const auto scene = test::scene_of("[surface]\nfrom = \"" + from + "\"\n" + keys +
                                              "[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
                                              "[contact]\npressures = [\"10 MPa\"]\n",
                                          folder / "scene.toml");
        return test::face(scene).unmeasured(30e-3);
    };
    const auto direct = unmeasured("trace.csv");
    CHECK(direct.growth > 0.1);
    CHECK(unmeasured("trace.csv", "lambda_c = \"0.25 mm\"\n").growth == 0);   // longer waves are not asked for
    CHECK(unmeasured("trace.csv", "rms_height = \"0.4 um\"\n").growth == 0);  // nor are they known of a given sigma
    folder.write("trace.json", document.dump());
    CHECK(same(unmeasured("trace.json").growth, direct.growth));
    CHECK(unmeasured("trace.json").at_least == direct.at_least);
    auto wrong = document;
    wrong["long_end"]["open"] = 2;
    test::check_sentence(test::refusal([&] { (void)fstiff::surface::read_measured_document(wrong.dump(), "m.json"); }),
                         {"m.json: long_end.open: must be from 0 to 1"});
    document.erase("long_end");  // of an older fstiff
    folder.write("older.json", document.dump());
    CHECK(unmeasured("older.json").growth == 0);
}

TEST_CASE("The robust filter of lambda_c is that of the library, and reports what it left out") {
    const std::string text = map_text();
    const auto map = fstiff::detail::remove_form(fstiff::io::read_surface(text, "map").map(), fstiff::MapForm::plane);
    auto rough = map;
    rough.heights -= fstiff::detail::robust_waviness(map, 40e-6).waviness.heights;
    const auto document = test::measured("--lambda-s none --lambda-c '40 um' --filter robust", text);
    CHECK(same(document["surface"]["rms_height"]["value"], fstiff::rms_height(rough)));
    CHECK(test::decided(document, "lambda_c 40 µm (robust Gaussian, after the form was removed, "));
    CHECK(test::decided(document, " of 25600 points without weight, "));
    const std::string made = test::profile_text(4096, 1e-6, {.hurst = 0.5, .rms = 1e-6});
    const auto flat = fstiff::detail::level(fstiff::io::read_surface(made, "profile").profile(), fstiff::Form::line);
    auto rest = flat.profile;
    const auto waviness = fstiff::detail::robust_waviness(flat.profile, 80e-6).waviness;
    for (std::size_t i = 0; i < rest.size(); ++i) rest.heights[i] -= waviness.heights[i];
    const auto profile = test::measured("--lambda-s none --lambda-c '80 um' --filter robust", made);
    CHECK(same(profile["surface"]["rms_height"]["value"], fstiff::rms_height(rest)));
    CHECK(test::decided(profile, "robust Gaussian"));
    CHECK(profile["filter"] == "robust");
    CHECK(test::measured("--lambda-s none --lambda-c none --filter robust", made)["filter"].is_null());
}

}  // namespace cut_offs_test
