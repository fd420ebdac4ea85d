// SPDX-License-Identifier: BSD-3-Clause
// The requests of commands, in-process. Truth: closed forms, and the functions of the headers.
#include "actions/export.hpp"
#include "actions/generate.hpp"
#include "actions/identify.hpp"
#include "actions/spectrum.hpp"
#include "actions/ultrasound.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <fstiff/asperity/material.hpp>
#include <fstiff/contact/rough_contact.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace requests_test {

using namespace fstiff;

namespace {

/// The sentence of a refusal by an error of type \p Error.
template <class Error, class Call>
std::string refused(const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("The spectrum of one wave has its mean square at its place, and its autocorrelation is the wave") {
    constexpr std::size_t points = 256;
    constexpr double step = 1e-6, amplitude = 2e-7, q = 2 * std::numbers::pi / (16 * step);
    Profile<double> wave{std::vector<double>(points), step};
    for (std::size_t i = 0; i < points; ++i) wave.heights[i] = amplitude * std::cos(q * static_cast<double>(i) * step);
    actions::SpectrumRequest request{.taper = SpectrumWindow::none};
    request.surface.file = "wave", request.surface.detrend = "mean";
    request.surface.lambda_s = request.surface.lambda_c = "none";
    const auto input = surface::surface_of_heights(request.surface, wave, "a test");
    const auto psd = actions::spectrum_of(request, input);
    const double mean_square = amplitude * amplitude / 2, spacing = 2 * std::numbers::pi / (points * step);
    REQUIRE(psd.curves.size() == 1);
    CHECK(test::relative_error(psd.curves[0].x[15], q) < 1e-14);
    CHECK(test::relative_error(psd.curves[0].y[15] * spacing, mean_square) < 1e-13);
    CHECK(psd.curves[0].y[14] < 1e-20 * psd.curves[0].y[15]);
    CHECK(test::relative_error(psd.rms * psd.rms, mean_square) < 1e-13);
    request.of = actions::SpectrumKind::acf;
    const auto acf = actions::spectrum_of(request, input);
    for (const std::size_t lag : {0, 4, 8, 16})  // over whole waves, but for the pairs at the ends
        CHECK(std::abs(acf.curves[0].y[lag] - std::cos(q * static_cast<double>(lag) * step)) < 0.02);
    CHECK(acf.curves[0].counts[16] == points - 16);
}

TEST_CASE("What is generated is what the headers make of the same numbers") {
    const auto of = [](actions::GeneratedKind kind) {
        actions::GenerateRequest request{.kind = kind, .points = 32, .spacing = 1e-6};
        if (kind == actions::GeneratedKind::wm)
            request.dimension = 1.4, request.roughness = "12 nm";
        else
            request.hurst = 0.7, request.rms = 1e-6;
        return request;
    };
    SelfAffineOptions<double> how;
    how.hurst = 0.7, how.rms = 1e-6;
    const auto map = std::get<HeightMap<double>>(actions::generate(of(actions::GeneratedKind::map)).surface);
    CHECK((map.heights == self_affine_map(how, 32, 32, 1e-6, 1e-6).heights).all());
    const auto made = actions::generate(of(actions::GeneratedKind::profile));
    CHECK(std::get<Profile<double>>(made.surface).heights == self_affine_profile(how, 32, 1e-6).heights);
    CHECK(made.origin().find("generate (kind profile, H 0.7, rms 1e-06 m,") != std::string::npos);
    CHECK(actions::file_of(made, actions::GeneratedForm::csv).starts_with("# " + made.origin() + "\n"));
    auto wrong = of(actions::GeneratedKind::wm);
    wrong.prefix = "--", wrong.long_waves = LongWaves::none;
    CHECK(refused<document::option_error>([&] { (void)actions::generate(wrong); }) ==
          "--long-waves is not for generate wm; must not be given");
}

TEST_CASE("A quantity is a number in SI or a text with its unit") {
    using io::Dimension;
    CHECK(request::Amount("7 MHz").positive(Dimension::frequency, "f") == 7e6);
    CHECK(request::Amount(7e6).positive(Dimension::frequency, "f") == 7e6);
    CHECK(request::Amount(0.0).value(Dimension::pressure, "p") == 0);
    CHECK(refused<domain_error>([] { (void)request::Amount(0.0).positive(Dimension::pressure, "p"); }) ==
          "p = 0: must be finite and greater than 0");
    CHECK(refused<domain_error>([] { (void)request::Amount(std::nan("")).value(Dimension::pressure, "p"); }) ==
          "p = nan: must be finite");
    CHECK(request::Amount().empty());
}

TEST_CASE("A reflection is eq. (5.1), and a curve of reflections gives the stiffness of each") {
    actions::ReflectionRequest request{.stiffness = 1.764e15, .frequency = 7e6, .incident = {.impedance = 46e6}};
    const double x = 2 * 1.764e15 / (2 * std::numbers::pi * 7e6 * 46e6), r = 1 / std::sqrt(1 + x * x);
    CHECK(test::relative_error(actions::reflection_of(request).one.reflection, r) < 1e-14);
    request.stiffness = {};
    const std::vector<double> pressures{1e6, 2e6}, values{r, 1.5}, errors{0.01, 0.01};
    const auto found =
        actions::reflection_of(request, actions::curve_of_numbers(pressures, values, errors, true, "curve"));
    CHECK(test::relative_error(found.curve->stiffness[0]->value, 1.764e15) < 1e-13);
    // dK/dR of K = omega z/2 sqrt(1/R^2 - 1)
    CHECK(test::relative_error(found.curve->stiffness[0]->error, 0.01 * 1.764e15 / (r * (1 - r * r))) < 1e-12);
    CHECK(!found.curve->stiffness[1]);
    CHECK(found.doubtful);
    CHECK(refused<domain_error>([&] {
              (void)actions::curve_of_numbers(pressures, {values.data(), 1}, {}, true, "curve");
          }) == "curve: pressures, values and errors must have the same length");
    CHECK(refused<domain_error>([&] {
              (void)actions::curve_of_numbers(values, {{1.0, -1.0}}, {}, false, "curve");
          }) == "curve:2: stiffness = -1: must be finite and greater than 0");
}

TEST_CASE("A curve of a contact gives its parameters back") {
    const auto builtin = scene::read_scene(scene::builtin_scene, {.name = "built-in scene"});
    const Roughness<double> rougher{1.1 * 0.832e-6, 40e-6, 500e6};  // than that scene
    const auto of = PeakDistribution<double>::exponential(std::numbers::pi / 4);
    const double modulus = effective_modulus<double>({205e9, 0.3}, {205e9, 0.3});
    const RoughContact contact(rougher, of, HertzLaw<double>{}, modulus);
    const std::vector<double> pressures{1e6, 3e6, 1e7, 3e7};
    std::vector<double> stiffness;
    for (const double p : pressures) stiffness.push_back(contact.at_pressure(p).stiffness.value);
    const auto found = actions::identify_scene(builtin, {.fit = {"sigma"}, .law = "hertz"},
                                               actions::curve_of_numbers(pressures, stiffness, {}, false, "curve"));
    CHECK(test::relative_error(found.found.fits.front().found.parameters.front().value, rougher.rms_height) < 1e-8);
    CHECK(refused<document::option_error>([] {
              (void)actions::parameters_of({.fit = {"sigma", "rms_height"}});
          }) == "fit: \"rms_height\" is listed twice");
}

TEST_CASE("An export has a row of the table a line, in the units of the model") {
    const auto builtin = scene::read_scene(scene::builtin_scene, {.name = "built-in scene"});
    const actions::ExportRequest request{
        .to = actions::Solver::abaqus, .tolerance = "0.05", .from = 1e6, .until = "50 MPa"};
    const std::string made = actions::document_of(builtin, request).csv();
    const auto table = actions::pressure_table(builtin, {.from = 1e6, .to = 50e6, .tolerance = 0.05});
    const std::size_t keyword = made.find("TABULAR\n") + 8;
    const std::string rows = made.substr(keyword);
    CHECK(std::count(rows.begin(), rows.end(), '\n') == std::ssize(table.rows));
    CHECK(rows.starts_with("0, 0\n"));
    CHECK(made.find("\n50, ") != std::string::npos);  // MPa
    CHECK(refused<domain_error>([] {
              actions::check(actions::ExportRequest{.units = "mm,N,Pa"});
          }).starts_with("units = \"mm,N,Pa\""));
}

}  // namespace requests_test
