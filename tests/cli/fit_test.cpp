// SPDX-License-Identifier: BSD-3-Clause
#include "cli/command.hpp"
#include "support/skip.hpp"

#include "support/accuracy.hpp"

#include <fstiff/io/surface_file.hpp>
#include <fstiff/measured/sections.hpp>
#include <fstiff/profile/detrend.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/peak_statistics.hpp>
#include <fstiff/profile/power_spectrum.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/form.hpp>

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>

#include <sstream>

namespace fit_test {

namespace {

/// A random walk, D = 1.5. A linear congruential generator is enough.
fstiff::Profile<double> random_walk(std::size_t points) {
    fstiff::Profile<double> profile;
    profile.spacing = 0.5e-6;
    unsigned long long state = 2014;
    double height = 0;
    for (std::size_t i = 0; i < points; ++i) {
        state = state * 6364136223846793005ull + 1442695040888963407ull;
        height += (static_cast<double>(state >> 40) / 16777216.0 - 0.5) * 1e-7;
        profile.heights.push_back(height);
    }
    return profile;
}

std::string digits(double value) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// Heights as a column of metres.
std::string one_column(const fstiff::Profile<double>& profile) {
    std::string text;
    for (const double z : profile.heights) text += digits(z) + "\n";
    return text;
}

/// As measured: what the library computes of the same heights has no cut-offs.
const std::string read_metres = "fit - --lambda-s none --lambda-c none --spacing '0.5 um' --units m";

std::string numbered(int rows, const std::string& separator = ",", const std::string& header = "x [um],z [nm]\n") {
    std::string text = header;
    for (int i = 0; i < rows; ++i) text += std::to_string(i) + ".0" + separator + std::to_string(i * 37 % 19) + "\n";
    return text;
}

}  // namespace

TEST_CASE("The command gives what the library gives, to the last digit") {
    const auto profile = random_walk(4096);
    const auto outcome = test::run_fstiff(read_metres + " --format json", one_column(profile));
    REQUIRE(outcome.status == 0);
    const auto document = nlohmann::json::parse(outcome.out);
    const auto flat = fstiff::level(profile, fstiff::Form::line);
    const auto fit = fstiff::fit_fractal(flat);
    CHECK(document["fractal_dimension"].get<double>() == fit.fractal.dimension);
    CHECK(document["fractal_dimension_error"].get<double>() == fit.dimension_error);
    CHECK(document["fractal_roughness_m"].get<double>() == fit.fractal.roughness);
    CHECK(document["fractal_roughness_error_m"].get<double>() == fit.roughness_error);
    CHECK(document["window_m"] == nlohmann::json{fit.window.from, fit.window.to});
    CHECK(document["rms_height_m"].get<double>() == fstiff::rms_height(flat.profile));
    CHECK(document["rms_height_before_detrend_m"].get<double>() == fstiff::rms_height(profile));
    CHECK(document["points"] == 4096);
    CHECK(document["spacing_m"].get<double>() == 0.5e-6);
    CHECK(document["structure_function"]["lag_m"].get<std::vector<double>>() == fit.structure_function.lag);
    CHECK(document["structure_function"]["value_m2"].get<std::vector<double>>() == fit.structure_function.value);
    CHECK(document["structure_function"]["pairs"].get<std::vector<std::size_t>>() == fit.structure_function.pairs);

    const test::Csv csv(test::run_fstiff(read_metres + " --format csv", one_column(profile)).out);
    CHECK(csv.header() == std::vector<std::string>{"lag_m", "value_m2", "pairs", "in_window"});
    REQUIRE(csv.size() == fit.structure_function.size());
    std::size_t inside = 0;
    for (std::size_t i = 0; i < csv.size(); ++i) {
        CHECK(csv.number(i, "value_m2") == fit.structure_function.value[i]);
        inside += csv.text(i, "in_window") == "1" ? 1 : 0;
    }
    CHECK(inside == fit.lags);
}

TEST_CASE("A random walk has the dimension 1.5 within three of its errors") {
    const auto document =
        nlohmann::json::parse(test::run_fstiff(read_metres + " --format json", one_column(random_walk(16384))).out);
    const double error = document["fractal_dimension_error"];
    CHECK(error < 0.05);
    CHECK(std::abs(document["fractal_dimension"].get<double>() - 1.5) < 3 * error);
}

TEST_CASE("Window, convention and form are those asked for") {
    const std::string text = one_column(random_walk(4096));
    const auto json = [&](const std::string& more) {
        const auto outcome = test::run_fstiff(read_metres + " --format json " + more, text);
        INFO(more << outcome.err);
        REQUIRE(outcome.status == 0);
        return nlohmann::json::parse(outcome.out);
    };
    const auto given = json("--window '2 um,40 um'");
    CHECK(given["window_automatic"] == false);
    CHECK(given["window_m"][0].get<double>() >= 2e-6 * (1 - 1e-12));
    CHECK(given["window_m"][1].get<double>() <= 40e-6 * (1 + 1e-12));
    // G^(2D-2) times the constant of the convention is the same C
    const auto paper = json("--window '2 um,40 um' --convention paper");
    const auto tien = json("--window '2 um,40 um' --convention majumdar_tien");
    const double d = given["fractal_dimension"];
    CHECK(paper["fractal_dimension"].get<double>() == d);
    // majumdar_tien is (2.4)/(2 ln gamma), gamma = 1.5; pow costs some ulp
    CHECK(
        test::relative_error(
            std::pow(tien["fractal_roughness_m"].get<double>() / paper["fractal_roughness_m"].get<double>(), 2 * d - 2),
            2 * std::log(1.5)) < 1e-12);
    CHECK(json("--detrend none")["rms_height_m"] == json("--detrend none")["rms_height_before_detrend_m"]);
    CHECK(json("--detrend parabola")["rms_height_m"].get<double>() <
          json("--detrend line")["rms_height_m"].get<double>());
}

TEST_CASE("The unit of length does not matter") {
    auto profile = random_walk(4096);
    const auto document = [&](const std::string& arguments, const std::string& input) {
        return nlohmann::json::parse(test::run_fstiff("fit - --format json " + arguments, input).out);
    };
    const auto metres = document("--spacing '0.5 um' --units m", one_column(profile));
    for (double& z : profile.heights) z *= 1e9;
    const auto nanometres = document("--spacing '500 nm' --units nm", one_column(profile));
    // z * 1e9 is rounded once: some 1e-16 of the height, which is 100 times the step between neighbours
    CHECK(test::relative_error(nanometres["fractal_dimension"].get<double>(),
                               metres["fractal_dimension"].get<double>()) < 1e-12);
    CHECK(test::relative_error(nanometres["fractal_roughness_m"].get<double>(),
                               metres["fractal_roughness_m"].get<double>()) < 1e-11);
}

TEST_CASE("The readable fit says what it decided about the file") {
    const auto outcome = test::run_fstiff("fit -", [] {
        std::string text = "x [\xC2\xB5m];z [nm]\r\n";
        const auto profile = random_walk(1024);
        for (std::size_t i = 0; i < profile.size(); ++i) {
            std::string row = digits(static_cast<double>(i) * 0.5) + ";" + digits(profile.heights[i] * 1e9) + "\r\n";
            std::replace(row.begin(), row.end(), '.', ',');
            text += row;
        }
        return text;
    }());
    INFO(outcome.err);
    CHECK(outcome.status == 0);
    for (const char* part :
         {"separator: semicolon, decimal comma", "header: 1 line", "points: 1024", "units: heights in nm",
          "spacing 0.5 µm", "D = 1.", " m +- ", "Rq ", "(line)", "window ", "lag [µm]", "S [µm²]"}) {
        INFO(part);
        CHECK(test::contains(outcome.out, part));
    }
}

TEST_CASE("Profiles that cannot be read are refused with file, line, value and what is allowed") {
    const test::Folder folder;
    const auto refused = [&](const std::string& text, const std::vector<std::string>& parts,
                             const std::string& options = "") {
        INFO(text.substr(0, 200));
        std::vector<std::string> all = parts;
        all.push_back("profile.csv");
        test::check_refused("fit '" + folder.write("profile.csv", text) + "'" + options, 3, all);
    };
    test::check_refused("fit '" + folder / "none.csv" + "'", 3, {"none.csv", "no such file"});
    test::check_refused("fit '" + folder / "." + "'", 3, {"folder"});
    refused("x [um]\n" + std::string((1u << 20) + 1, '1') + "\n", {"line 2", "longer than 2^20"});
    refused("", {"empty"});
    refused("\n \n", {"empty"});
    refused(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), {"binary", "PNG"});
    refused("nothing but words\nin here\n", {"must"});
    refused(test::replaced(numbered(40), "20.0,", "twenty,"), {"line 22", "twenty"});
    refused(test::replaced(numbered(40), "\n20.0,18\n", "\n20.0,inf\n"), {"line 22", "inf"});
    refused(test::replaced(numbered(40), "\n20.0,18\n", "\n19.0,18\n"),
            {"line 22", "19", "must"});  // the same place twice
    refused(test::replaced(numbered(40), "\n20.0,18\n", "\n-20.0,18\n"), {"line 22", "-20", "must"});  // backwards
    refused(test::replaced(numbered(40), "\n20.0,18\n", "\n20.4,18\n"), {"line 22", "20.4", "must"});  // unequal
    refused(numbered(40, ",", ""), {"unit"});
    refused(numbered(40, ",", "x,z\n"), {"unit"});
    refused(numbered(15), {"15", "16"});
    std::string constant = "x [um],z [nm]\n";
    for (int i = 0; i < 40; ++i) constant += std::to_string(i) + ",7\n";
    refused(constant, {"constant"});
    refused(numbered(40), {"column", "7"}, " --column 7");
}

TEST_CASE("Options of fit that make no sense are refused") {
    const std::string text = one_column(random_walk(64));
    using test::check_refused;
    check_refused(read_metres + " --window '1 um'", 2, {"--window = \"1 um\"", "two lengths"}, text);
    check_refused(read_metres + " --window '1,100'", 3, {"--window = \"1\"", "without a unit"}, text);
    check_refused(read_metres + " --window '9 um,1 um'", 2, {"--window", "less than the second"}, text);
    check_refused(read_metres + " --window '1 m,2 m'", 3, {"window"}, text);
    check_refused(read_metres + " --convention own", 2, {"--convention", "own"}, text);
    check_refused(read_metres + " --detrend cubic", 2, {"--detrend", "cubic"}, text);
    check_refused(read_metres + " --column 0", 2, {"--column"}, text);
    check_refused("fit - --units m --spacing 0.5", 3, {"--spacing = \"0.5\"", "without a unit"}, text);
    check_refused("fit - --units m --spacing '-1 um'", 3, {"--spacing = \"-1 um\"", "greater than 0"}, text);
    check_refused("fit - --units furlong --spacing '1 um'", 3, {"furlong"}, text);
    check_refused("fit - --units m", 3, {"spacing"}, text);
    check_refused("fit", 2, {"profile"});
}

TEST_CASE("Measured profiles give D and G with their units, or say why not") {
    const std::string folder = FSTIFF_SURFACES;
    if (!std::filesystem::exists(folder)) SKIP_CASE("there is no folder of measured surfaces " + folder);
    // smooth by its tip, flat behind it, then waves: no half decade of a power law (a D of 1.85 was once read off there)
    test::check_refused("fit " + folder + "/dektak-1.csv --lambda-s none --lambda-c none", 3,
                        {"fractal dimension of the window", "a plateau"});
    for (const auto& [file, options, points] : {std::tuple{"opdx-3.txt", " --units m,m --lambda-s none", 3001}}) {
        const auto outcome = test::run_fstiff("fit '" + folder + "/" + file + "' --format json" + options);
        INFO(file << "\n" << outcome.err);
        REQUIRE(outcome.status == 0);
        const auto document = nlohmann::json::parse(outcome.out);
        CHECK(document["points"] == points);
        CHECK(document["fractal_dimension"] > 1);
        CHECK(document["fractal_dimension"] < 2);
        CHECK(document["fractal_dimension_error"] > 0);
        CHECK_FALSE(document["curved"]);
        CHECK(test::contains(document["window_ends"], "saturates"));
    }
    // smooth at its short lags, a fifth of a decade of bend, then flat: the slope is that of no fractal
    test::check_refused("fit '" + folder + "/xy-4.txt' --units um,um", 3,
                        {"xy-4.txt", "no half decade of lags follows a power law"});
    test::check_refused("fit '" + folder + "/xy-4.txt' --units um,um --tip-radius '40 nm'", 3,
                        {"xy-4.txt", "no half decade", "tip radius"});
}

TEST_CASE("A map is fitted along x and along y, and said to be anisotropic when it is") {
    const auto made = test::run_fstiff("generate map --points 128 --spacing '1 um' --hurst 0.5 --rms '1 um'");
    REQUIRE(made.status == 0);
    const auto read = fstiff::io::read_surface(made.out, "map");
    const auto flat = fstiff::remove_form(read.map(), fstiff::MapForm::quadratic);
    const auto expected = fstiff::fit_directions(flat);
    const auto document =
        nlohmann::json::parse(test::run_fstiff("fit - --lambda-s none --detrend quadratic --format json", made.out).out);
    CHECK(document["x"]["fractal_dimension"] == expected.x.value().fractal.dimension);
    CHECK(document["y"]["fractal_dimension_error"] == expected.y.value().dimension_error);
    CHECK(document["anisotropic"] == expected.anisotropic());
    const auto areal = fstiff::areal_statistics(flat);
    CHECK(document["areal"]["m2"] == areal.m2);
    CHECK(document["areal"]["m4_per_m2"] == areal.m4);
    CHECK(document["areal"]["summit_density_per_m2"] == areal.summit_density);
    CHECK(document["areal"]["summit_curvature_per_m"] == areal.summit_curvature);

    // the same heights, each column four times: steps along x are a quarter as frequent
    std::string stretched = "# dx: 1 um\n# dy: 1 um\n# Value units: um\n";
    for (Eigen::Index j = 0; j < 128; ++j) {
        for (Eigen::Index i = 0; i < 128; ++i) {
            const auto column = i / 4;
            const double share = static_cast<double>(i % 4) / 4;
            const double z = (1 - share) * flat.heights(j, column) + share * flat.heights(j, column + 1);
            stretched += (i > 0 ? " " : "") + digits(z * 1e6);
        }
        stretched += "\n";
    }
    const auto outcome = test::run_fstiff("fit -", stretched);
    INFO(outcome.out << outcome.err);
    CHECK(outcome.status == 0);
    CHECK(test::contains(outcome.out, "warning: the map is anisotropic"));
    test::check_refused("fit - --all-lags", 2, {"--all-lags", "map"}, made.out);
    test::check_refused("fit - --detrend line", 2, {"detrend", "plane"}, made.out);
}

TEST_CASE("Tip, resolution, seed and filter do in the command what they do in the library") {
    const auto profile = random_walk(4096);
    const std::string text = one_column(profile);
    const auto json = [&](const std::string& more) {
        const auto outcome = test::run_fstiff(read_metres + " --format json " + more, text);
        INFO(more << outcome.err);
        REQUIRE(outcome.status == 0);
        return nlohmann::json::parse(outcome.out);
    };
    const auto flat = fstiff::level(profile, fstiff::Form::line);
    const auto same = [](const nlohmann::json& document, const fstiff::FractalFit<double>& fit) {
        CHECK(document["fractal_dimension"] == fit.fractal.dimension);
        CHECK(document["fractal_dimension_bootstrap_error"] == fit.bootstrap_dimension_error);
        CHECK(document["reliable_from_m"] == fit.reliable_from);
        CHECK(document["ordinary_least_squares"]["fractal_dimension"] == fit.line_dimension);
    };
    same(json("--resolution '4 um'"), fstiff::fit_fractal(flat, {.resolution = 4e-6}));
    CHECK(json("--resolution '4 um'")["window_m"][0].get<double>() >= 4e-6 * (1 - 1e-12));
    same(json("--tip-radius '5 um'"), fstiff::fit_fractal(flat, {.tip_radius = 5e-6}));
    same(json("--seed 5 --resamples 50"), fstiff::fit_fractal(flat, {.seed = 5, .resamples = 50}));
    const auto filtered = fstiff::gaussian_roughness(flat.profile, 200e-6);
    const auto document = json("--detrend gaussian --cutoff '200 um'");
    same(document, fstiff::fit_fractal(filtered));
    CHECK(document["rms_height_m"] == fstiff::rms_height(filtered));
    const auto moments = fstiff::spectral_moments(flat.profile);
    CHECK(json("")["spectral_moments"]["m4_per_m2"] == moments.m4);
    CHECK(json("")["spectral_moments"]["nayak_alpha"] == moments.bandwidth());
    const auto peaks = fstiff::peak_statistics(flat.profile);
    CHECK(json("")["peak_statistics"]["theta"] == peaks.theta);
    CHECK(json("")["peak_statistics"]["peak_ratio"] == peaks.peak_ratio());
    CHECK(json("")["peak_statistics"]["counted_peak_ratio"] == peaks.counted_peak_ratio);
    CHECK(json("")["power_spectrum"]["fractal_dimension"] ==
          fstiff::fit_spectrum(fstiff::power_spectrum(flat.profile)).dimension);
    CHECK(json("--all-lags")["structure_function"]["lag_m"].size() == 4095);

    test::check_refused(read_metres + " --detrend gaussian", 2, {"--cutoff"}, text);
    test::check_refused(read_metres + " --cutoff '1 um'", 2, {"--detrend gaussian"}, text);
    test::check_refused(read_metres + " --tip-radius '1 s'", 3, {"--tip-radius"}, text);
    test::check_refused(read_metres + " --resolution '5 mm'", 3, {"standard input"}, text);
}

TEST_CASE("Lengths of a fine profile are shown in nm, and a G that is not known to a factor of two with two digits") {
    const auto made = test::run_fstiff("generate profile --points 200 --spacing '5 nm' --hurst 0.3 --rms '3 nm'");
    REQUIRE(made.status == 0);
    const auto outcome = test::run_fstiff("fit - --lambda-s none", made.out);
    INFO(outcome.out);
    CHECK(test::contains(outcome.out, "spacing 5 nm, length 0.995 µm"));
    const auto at = outcome.out.find("  G = ");
    REQUIRE(at != std::string::npos);
    std::istringstream line(outcome.out.substr(at + 6));
    std::string value, unit, sign, error;
    line >> value >> unit >> sign >> error;
    REQUIRE(std::stod(error) > std::stod(value) / 2);
    CHECK(value.substr(0, value.find('e')).size() <= 3);  // such as 2.5
}

}  // namespace fit_test
