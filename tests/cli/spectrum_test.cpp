// SPDX-License-Identifier: BSD-3-Clause
// Truth: the library; numpy and scipy on measured files (tests/data/roughness_reference.csv).
#include "cli/command.hpp"

#include "support/accuracy.hpp"
#include "support/roughness_reference.hpp"
#include "support/skip.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/profile/power_spectrum.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/profile/roughness_parameters.hpp>
#include <fstiff/topography/areal_autocorrelation.hpp>
#include <fstiff/topography/form.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include <nlohmann/json.hpp>

namespace spectrum_test {

using test::check_refused, test::contains, test::Csv, test::Folder, test::leave_out, test::read, test::relative_error,
    test::roughness_reference;

namespace {

const std::string none = " --lambda-s none --lambda-c none";

std::string profile_text() {
    const auto made =
        test::run_fstiff("generate profile --points 500 --spacing '1 um' --hurst 0.7 --rms '1 um' --shortest '8 um'");
    REQUIRE(made.status == 0);
    return made.out;
}

std::string map_text() {
    const auto made =
        test::run_fstiff("generate map --points 96 --spacing '1 um' --hurst 0.8 --rms '1 um' --shortest '8 um'");
    REQUIRE(made.status == 0);
    return made.out;
}

nlohmann::json document_of(const std::string& arguments, const std::string& input = "") {
    const auto outcome = test::run_fstiff(arguments + none + " --format json", input);
    INFO(arguments << "\n" << outcome.err);
    REQUIRE((outcome.status == 0 || outcome.status == 4));
    return nlohmann::json::parse(outcome.out);
}

/// The measured files of the table with the options that read them.
const std::vector<std::pair<std::string, std::string>> files{{"dektak-1.csv", ""},
                                                             {"opdx-3.txt", " --units m"},
                                                             {"xy-4.txt", " --units um"},
                                                             {"matrix-3.txt", ""},
                                                             {"matrix-4.txt", ""},
                                                             {"x3p-2.x3p", ""},
                                                             {"x3ptools_sample-land.x3p", ""}};

/// The file \p name, or nothing where it cannot be read here.
std::string measured_file(const std::string& name) {
    const std::string path = FSTIFF_SURFACES "/" + name;
    if (!std::filesystem::exists(path)) {
        leave_out("there is no " + path);
        return {};
    }
    if (name.ends_with(".x3p") && !fstiff::io::reads_x3p()) {
        leave_out("built without X3P: " + path);
        return {};
    }
    return path;
}

}  // namespace

TEST_CASE("The spectrum of a profile is that of the library, to the last digit") {
    const std::string text = profile_text();
    const auto profile =
        fstiff::detail::detrend(fstiff::io::read_surface(text, "profile").profile(), fstiff::Form::line);
    for (const auto window : {fstiff::SpectrumWindow::hann, fstiff::SpectrumWindow::none}) {
        const auto expected = fstiff::power_spectrum(profile, window);
        const std::string taper = " --taper " + std::string(fstiff::name_of(window));
        const auto document = document_of("measure --show spectrum -" + taper, text);
        const auto psd = document["psd"]["psd_m3"].get<std::vector<double>>();
        REQUIRE(psd.size() + 1 == expected.size());
        CHECK(psd == std::vector<double>(expected.value.begin() + 1, expected.value.end()));
        CHECK(document["inputs"]["taper"] == fstiff::name_of(window));
        const Csv csv(test::run_fstiff("measure --show spectrum - --format csv" + taper + none, text).out);
        REQUIRE(csv.size() == psd.size());
        CHECK(csv.number(7, "psd_m3") == psd[7]);
        CHECK(csv.number(7, "wavenumber_rad_per_m") == expected.wavenumber[8]);
    }
    const auto expected = fstiff::autocorrelation(profile);
    const auto document = document_of("measure --show spectrum - --of acf", text);
    CHECK(document["acf"]["acf"].get<std::vector<double>>() == expected.value);
    CHECK(document["acf"]["pairs"].get<std::vector<std::size_t>>() == expected.pairs);
    CHECK(document["by"] == "ISO 21920-2:2021");
}

TEST_CASE("The spectra of a map are those of the library, each with its own places") {
    const std::string text = map_text();
    const auto map = fstiff::detail::remove_form(fstiff::io::read_surface(text, "map").map(), fstiff::MapForm::plane);
    const auto expected = fstiff::radial_spectrum(map);
    const auto psd = document_of("measure --show spectrum -", text)["psd"];
    CHECK(psd["psd_m4"].get<std::vector<double>>() == expected.value);
    CHECK(psd["waves"].get<std::vector<std::size_t>>() == expected.waves);
    CHECK(psd["psd_x_m3"].get<std::vector<double>>() == expected.along_x.value);
    CHECK(psd["wavenumber_y_rad_per_m"].get<std::vector<double>>() == expected.along_y.wavenumber);
    const auto correlation = fstiff::detail::areal_autocorrelation(map);
    const auto acf = document_of("measure --show spectrum - --of acf", text)["acf"];
    CHECK(acf["acf"].get<std::vector<double>>() == fstiff::detail::radial_autocorrelation(correlation).value);
    CHECK(acf["acf_x"][5] == correlation.at(5, 0));
    CHECK(acf["acf_y"][48] == correlation.at(0, 48));
    // of an oblong map the columns end one after the other
    std::string half = text;
    half.resize(text.size() / 2);
    half.resize(half.rfind('\n') + 1);
    const auto oblong =
        document_of("measure --show spectrum - --input-format matrix --units m --dx '1 um' --dy '1 um'", half)["psd"];
    CHECK(oblong["psd_x_m3"].size() == oblong["psd_y_m3"].size());
    CHECK(oblong["psd_x_m3"].back().is_number());
    CHECK(oblong["psd_y_m3"].back().is_null());
}

TEST_CASE("Spectra of measured files are those that numpy and scipy find") {
    for (const auto& [name, options] : files) {
        const std::string path = measured_file(name);
        if (path.empty()) continue;
        CAPTURE(name);
        const auto expected = roughness_reference(name);
        const bool profile = expected.contains("Ra_m");
        if (!expected.contains("psd_hann_1")) {  // points are missing
            check_refused("measure --show spectrum " + path + none, 3,
                          {name, "missing points: must be filled before its spectrum is taken"});
            continue;
        }
        for (const std::string taper : {"hann", "none"}) {
            const auto psd = document_of("measure --show spectrum " + path + options + " --taper " + taper)["psd"];
            std::size_t compared = 0;
            const auto compare = [&](const std::string& prefix, const char* column) {
                for (const auto& [parameter, value] : expected) {
                    if (!parameter.starts_with(prefix)) continue;
                    CAPTURE(parameter);
                    const auto k = std::stoul(parameter.substr(prefix.size()));
                    CHECK(relative_error(psd[column][k - 1].get<double>(), value) < 1e-9);
                    ++compared;
                }
            };
            compare("psd_" + taper + "_", profile ? "psd_m3" : "psd_m4");
            if (!profile) compare("psd_x_" + taper + "_", "psd_x_m3");
            if (!profile) compare("psd_y_" + taper + "_", "psd_y_m3");
            CHECK(compared >= 2);
        }
    }
}

TEST_CASE("Roughness parameters of measured files are those that numpy and scipy find") {
    for (const auto& [name, options] : files) {
        const std::string path = measured_file(name);
        if (path.empty()) continue;
        const auto roughness = document_of("measure " + path + options + " --resamples 2")["roughness"];
        std::size_t compared = 0;
        for (const auto& [parameter, value] : roughness_reference(name)) {
            if (!roughness.contains(parameter)) continue;  // of a spectrum or an autocorrelation
            CAPTURE(name, parameter, value);
            REQUIRE(roughness[parameter].is_number());
            CHECK(relative_error(roughness[parameter].get<double>(), value) < 1e-9);
            ++compared;
        }
        CHECK(compared >= 14);
        for (const auto& [key, reason] : roughness["reasons"].items()) {
            CHECK(roughness[key].is_null());
            CHECK_FALSE(roughness_reference(name).contains(key));
            CHECK_FALSE(reason.get<std::string>().empty());
        }
    }
}

TEST_CASE("measure names the standard and the undefined parameters, and its CSV has no more rows than before") {
    const std::string text = map_text();
    const auto roughness = document_of("measure - --resamples 2", text)["roughness"];
    CHECK(roughness["standard"] == "ISO 25178-2:2021");
    CHECK(roughness["Sz_m"].get<double>() == roughness["Sp_m"].get<double>() + roughness["Sv_m"].get<double>());
    const auto table = test::run_fstiff("measure - --resamples 2 --format table" + none, text).out;
    CHECK(contains(table, "by ISO 25178-2:2021"));
    CHECK_FALSE(contains(test::run_fstiff("measure - --resamples 2 --format csv" + none, text).out, "Sa"));

    const auto line = document_of("measure - --resamples 2", profile_text())["roughness"];
    CHECK(line["standard"] == "ISO 21920-2:2021");
    CHECK(relative_error(line["section_length_m"].get<double>(), 100e-6) < 1e-12);
    const auto cut = test::run_fstiff("measure - --resamples 2 --lambda-s none --lambda-c '80 um'", profile_text());
    const auto sections = nlohmann::json::parse(cut.out)["roughness"];
    CHECK(contains(sections["sections"].get<std::string>(), "lambda_c"));
    CHECK(relative_error(sections["section_length_m"].get<double>(), 80e-6) < 1e-12);

    // grooves: the autocorrelation does not fall along them
    std::string grooves;
    for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 60; ++i)
            grooves +=
                std::to_string(std::sin(0.7 * i) + 0.001 * std::sin(i * i + 3.0 * j * j)) + (i < 59 ? " " : "\n");
    const auto found = document_of("measure - --resamples 2 --units um --dx '1 um' --dy '1 um'", grooves)["roughness"];
    CHECK(found["Sal_m"].is_number());
    CHECK(found["Str"].is_null());
    CHECK(contains(found["reasons"]["Str"].get<std::string>(), "degrees from x"));
    CHECK(std::abs(found["Std_deg"].get<double>() - 90) < 0.1);
}

TEST_CASE("Missing points have an autocorrelation and no spectrum, with a note") {
    std::string text;
    for (int i = 0; i < 100; ++i) text += i == 30 ? "nan\n" : std::to_string(std::sin(0.3 * i)) + "\n";
    const std::string how = "measure --show spectrum - --units um --spacing '1 um'" + none;
    check_refused(how, 3, {"standard input", "1 missing points", "before its spectrum"}, text);
    const auto acf = test::run_fstiff(how + " --of acf", text);
    CHECK(acf.status == 0);
    CHECK(contains(acf.out, "1 of 100 points are missing; their pairs are left out"));
    check_refused("measure --show spectrum -", 3, {"standard input", "empty"});
    check_refused("measure --show spectrum - --of structure", 2, {"--of"}, text);
    check_refused("measure --show spectrum nowhere.csv", 3, {"nowhere.csv", "no such file"});
}

TEST_CASE("Of several files the roughness is the mean of theirs, and each file has its own") {
    const Folder folder;
    std::string names;
    for (const std::string seed : {"1", "2", "3"})
        names +=
            " '" +
            folder.write(seed + ".csv", test::run_fstiff("generate profile --points 400 --spacing '1 um' --hurst 0.7 "
                                                         "--rms '1 um' --shortest '8 um' --seed " +
                                                         seed)
                                            .out) +
            "'";
    const auto document = document_of("measure" + names + " --resamples 2");
    const auto& pooled = document["roughness"];
    CHECK(pooled["mean_of_files"] == 3);
    CHECK(relative_error(pooled["section_length_m"].get<double>(), 80e-6) < 1e-12);
    double mean = 0;
    for (const auto& file : document["files"]) {
        CHECK_FALSE(file["roughness"].contains("mean_of_files"));
        mean += file["roughness"]["Rz_m"].get<double>() / 3;
    }
    CHECK(relative_error(pooled["Rz_m"].get<double>(), mean) < 1e-14);
    const auto table = test::run_fstiff("measure" + names + " --resamples 2 --format table" + none);
    CHECK(contains(table.out, "means of 3 files"));
}

}  // namespace spectrum_test
