// SPDX-License-Identifier: BSD-3-Clause
// D and G of a profile or map, and the other results about it, against the headers.
#include "support/library.hpp"
#include "support/skip.hpp"

#include <fstiff/answer/face.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/io/surface_file.hpp>
#include <fstiff/measure/sections.hpp>
#include <fstiff/profile/fractal_fit.hpp>
#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/peak_statistics.hpp>
#include <fstiff/profile/power_spectrum.hpp>
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/surface/structure_coefficient.hpp>
#include <fstiff/topography/areal_statistics.hpp>
#include <fstiff/topography/form.hpp>

#include <cmath>
#include <filesystem>

namespace fractal_test {

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

using fstiff::detail::shortest_text;

/// Heights as a column of metres.
std::string one_column(const fstiff::Profile<double>& profile) {
    std::string text;
    for (const double z : profile.heights) text += shortest_text(z) + "\n";
    return text;
}

/// As measured: what the library computes of the same heights has no cut-offs.
const std::string read_metres = "--lambda-s none --lambda-c none --spacing '0.5 um' --units m ";

std::string numbered(int rows, const std::string& separator = ",", const std::string& header = "x [um],z [nm]\n") {
    std::string text = header;
    for (int i = 0; i < rows; ++i) text += std::to_string(i) + ".0" + separator + std::to_string(i * 37 % 19) + "\n";
    return text;
}

}  // namespace

TEST_CASE("The document of a fit holds what the headers fit, to the last digit") {
    const auto profile = random_walk(4096);
    const auto document = test::fitted(read_metres, one_column(profile));
    const auto flat = fstiff::detail::level(profile, fstiff::Form::line);
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
    CHECK(document["second_differences"]["value_m2"].get<std::vector<double>>() == fit.second_differences.value);
    CHECK(document["fitted"]["lag_m"].get<std::vector<double>>() == fit.fitted.lag);
    CHECK(document["fitted"]["value_m2"].get<std::vector<double>>() == fit.fitted.value);

    fstiff::actions::FractalOptions how;
    how.surface = test::surface_options(read_metres);
    const auto result =
        fstiff::actions::fractal_of_profile(how, fstiff::surface::read_surface_input(how.surface, one_column(profile)));
    const test::Csv csv(fstiff::actions::lag_rows(result.fit, result.fit.structure_function).csv());
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
    const auto document = test::fitted(read_metres, one_column(random_walk(16384)));
    const double error = document["fractal_dimension_error"];
    CHECK(error < 0.05);
    CHECK(std::abs(document["fractal_dimension"].get<double>() - 1.5) < 3 * error);
}

TEST_CASE("Window, convention and form are those asked for") {
    const std::string text = one_column(random_walk(4096));
    const auto json = [&](const std::string& more, fstiff::actions::FractalOptions how = {}) {
        return test::fitted(read_metres + more, text, how);
    };
    const auto given = json("--window '2 um,40 um'");
    CHECK(given["window_automatic"] == false);
    CHECK(given["window_m"][0].get<double>() >= 2e-6 * (1 - 1e-12));
    CHECK(given["window_m"][1].get<double>() <= 40e-6 * (1 + 1e-12));
    // G^(2D-2) times the constant of the convention is the same C
    const auto paper = json("--window '2 um,40 um'", {.surface = {}, .convention = fstiff::StructureConvention::paper});
    const auto tien =
        json("--window '2 um,40 um'", {.surface = {}, .convention = fstiff::StructureConvention::majumdar_tien});
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
    const auto metres = test::fitted("--spacing '0.5 um' --units m", one_column(profile));
    for (double& z : profile.heights) z *= 1e9;
    const auto nanometres = test::fitted("--spacing '500 nm' --units nm", one_column(profile));
    // z * 1e9 is rounded once: some 1e-16 of the height, which is 100 times the step between neighbours
    CHECK(test::relative_error(nanometres["fractal_dimension"].get<double>(),
                               metres["fractal_dimension"].get<double>()) < 1e-12);
    CHECK(test::relative_error(nanometres["fractal_roughness_m"].get<double>(),
                               metres["fractal_roughness_m"].get<double>()) < 1e-11);
}

TEST_CASE("Profiles that cannot be read are refused with file, line, value and what is allowed") {
    const auto refused = [](const std::string& text, const std::vector<std::string>& parts,
                            const std::string& options = "") {
        INFO(text.substr(0, 200));
        test::check_sentence(test::refusal([&] { (void)test::fitted(options, text); }), parts);
    };
    refused("x [um]\n" + std::string((1u << 20) + 1, '1') + "\n", {"line 2", "longer than 2^20"});
    refused(std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), {"binary", "PNG"});
    refused("nothing but words\nin here\n", {"must"});
    refused(test::replaced(numbered(40), "20.0,", "twenty,"), {"line 22", "twenty"});
    refused(test::replaced(numbered(40), "\n20.0,18\n", "\n20.0,infinite\n"), {"line 22", "infinite"});
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
    const auto refused = [&](const std::string& options, const std::vector<std::string>& parts) {
        test::check_sentence(test::refusal([&] { (void)test::fitted(options, text); }), parts);
    };
    refused(read_metres + "--window '1 um'", {"--window = \"1 um\"", "two lengths"});
    refused(read_metres + "--window '1,100'", {"--window = \"1\"", "without a unit"});
    refused(read_metres + "--window '9 um,1 um'", {"--window", "less than the second"});
    refused(read_metres + "--window '1 m,2 m'", {"window"});
    refused(read_metres + "--detrend cubic", {"detrend", "cubic"});
    refused("--units m --spacing 0.5", {"--spacing = \"0.5\"", "without a unit"});
    refused("--units m --spacing '-1 um'", {"--spacing = \"-1 um\"", "greater than 0"});
    refused("--units furlong --spacing '1 um'", {"furlong"});
    refused("--units m", {"spacing"});
}

TEST_CASE("Measured profiles give D and G with their units, or a reason why not") {
    const std::string folder = FSTIFF_SURFACES;
    if (!std::filesystem::exists(folder)) SKIP_CASE("there is no folder of measured surfaces " + folder);
    const auto fit = [&](const std::string& file, const std::string& options) {
        return test::fitted(options, test::read(folder + "/" + file));
    };
    const auto refused = [&](const std::string& file, const std::string& options,
                             const std::vector<std::string>& parts) {
        test::check_sentence(test::refusal([&] { (void)fit(file, options); }), parts);
    };
    // smooth by its tip, flat after it, then waves: no half decade of a power law (a D of 1.85 was once read off
    // there)
    refused("dektak-1.csv", "--lambda-s none --lambda-c none", {"fractal dimension of the window", "a plateau"});
    const auto document = fit("opdx-3.txt", "--units m,m --lambda-s none");
    CHECK(document["points"] == 3001);
    CHECK(document["fractal_dimension"] > 1);
    CHECK(document["fractal_dimension"] < 2);
    CHECK(document["fractal_dimension_error"] > 0);
    CHECK_FALSE(document["curved"]);
    CHECK(test::contains(document["window_ends"], "saturates"));
    // smooth at its short lags, a fifth of a decade of bend, then flat: the slope is that of no fractal
    refused("xy-4.txt", "--units um,um", {"no half decade of lags follows a power law"});
    refused("xy-4.txt", "--units um,um --tip-radius '40 nm'", {"no half decade", "tip radius"});
}

TEST_CASE("A map is fitted along x and along y, and reported as anisotropic when it is") {
    const std::string made = test::map_text(128, 1e-6, {.hurst = 0.5, .rms = 1e-6});
    const auto read = fstiff::io::read_surface(made, "map");
    const auto flat = fstiff::detail::remove_form(read.map(), fstiff::MapForm::quadratic);
    const auto expected = fstiff::detail::fit_directions(flat);
    const auto document = test::fitted("--lambda-s none --detrend quadratic", made);
    CHECK(document["x"]["fractal_dimension"] == expected.x.value().fractal.dimension);
    CHECK(document["y"]["fractal_dimension_error"] == expected.y.value().dimension_error);
    CHECK(document["anisotropic"] == expected.anisotropic());
    const auto areal = fstiff::detail::areal_statistics(flat);
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
            stretched += (i > 0 ? " " : "") + shortest_text(z * 1e6);
        }
        stretched += "\n";
    }
    CHECK(test::contains(test::fitted("", stretched)["warnings"].dump(), "the map is anisotropic"));
    test::check_sentence(test::refusal([&] { (void)test::fitted("--detrend line", made); }), {"detrend", "plane"});
}

TEST_CASE("Tip, resolution, seed and filter act on a file as in the headers") {
    const auto profile = random_walk(4096);
    const std::string text = one_column(profile);
    const auto json = [&](const std::string& more, fstiff::actions::FractalOptions how = {}) {
        return test::fitted(read_metres + more, text, how);
    };
    const auto flat = fstiff::detail::level(profile, fstiff::Form::line);
    const auto same = [](const nlohmann::json& document, const fstiff::FractalFit<double>& fit) {
        CHECK(document["fractal_dimension"] == fit.fractal.dimension);
        CHECK(document["fractal_dimension_bootstrap_error"] == fit.bootstrap_dimension_error);
        CHECK(document["reliable_from_m"] == fit.reliable_from);
        CHECK(document["ordinary_least_squares"]["fractal_dimension"] == fit.line_dimension);
    };
    same(json("--resolution '4 um'"), fstiff::fit_fractal(flat, {.resolution = 4e-6}));
    CHECK(json("--resolution '4 um'")["window_m"][0].get<double>() >= 4e-6 * (1 - 1e-12));
    same(json("--tip-radius '5 um'"), fstiff::fit_fractal(flat, {.tip_radius = 5e-6}));
    same(json("", {.surface = {}, .seed = 5, .resamples = 50}),
         fstiff::fit_fractal(flat, {.seed = 5, .resamples = 50}));
    const auto filtered = fstiff::detail::gaussian_roughness(flat.profile, 200e-6);
    const auto document = json("--detrend gaussian --cutoff '200 um'");
    same(document, fstiff::fit_fractal(filtered));
    CHECK(document["rms_height_m"] == fstiff::rms_height(filtered));
    const auto moments = fstiff::detail::spectral_moments(flat.profile);
    CHECK(json("")["spectral_moments"]["m4_per_m2"] == moments.m4);
    CHECK(json("")["spectral_moments"]["nayak_alpha"] == moments.bandwidth());
    const auto peaks = fstiff::peak_statistics(flat.profile);
    CHECK(json("")["peak_statistics"]["theta"] == peaks.theta);
    CHECK(json("")["peak_statistics"]["peak_ratio"] == peaks.peak_ratio());
    CHECK(json("")["peak_statistics"]["counted_peak_ratio"] == peaks.counted_peak_ratio);
    CHECK(json("")["power_spectrum"]["fractal_dimension"] ==
          fstiff::detail::fit_spectrum(fstiff::power_spectrum(flat.profile)).dimension);

    const auto refused = [&](const std::string& options, const std::string& part) {
        test::check_sentence(test::refusal([&] { (void)json(options); }), {part});
    };
    refused("--detrend gaussian", "--cutoff");
    refused("--cutoff '1 um'", "--detrend gaussian");
    refused("--tip-radius '1 s'", "--tip-radius");
    refused("--resolution '5 mm'", "standard input");
}

}  // namespace fractal_test
