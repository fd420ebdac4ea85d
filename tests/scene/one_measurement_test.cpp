// SPDX-License-Identifier: BSD-3-Clause
// One file has one R, one sigma and one K: what the command writes and the headers agree to the last digit.
// tests/python/test_surfaces.py holds the Python package to the command, tests/c the C interface to the headers.
#include "support/library.hpp"
#include "support/skip.hpp"

#include <fstiff/answer/band.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/contact/contact_curve.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/hybrid_of_map.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/measure/pooled_surface.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <variant>

namespace one_measurement_test {

using namespace fstiff;

namespace {

/// Options that a file needs, because it does not state its units.
const std::map<std::string, std::string> units_of_files{
    {"nanovea_test1.txt", "mm,um"}, {"opdx-3.txt", "m,m"}, {"xy-4.txt", "um"}};

/// \p a is \p b, bit for bit. A processor that fuses products and sums may round them elsewhere in another program.
bool same(double a, double b) {
#if defined(__FMA__) || !defined(__x86_64__)
    return a == b || std::abs(a - b) <= 1e-12 * std::abs(b);
#else
    return a == b;
#endif
}

/// Name, value and error of every number of a surface in every language; 0 for what is not known.
using Numbers = std::map<std::string, Measurement<double>>;

Numbers numbers_of(const Surface<double>& surface) {
    Numbers all{{"rms_height", surface.rms_height},
                {"peak_radius", surface.peak_radius},
                {"peak_density", surface.peak_density},
                {"max_peak_height", surface.max_peak_height}};
    if (surface.heights) {
        all["rms_gradient"] = surface.rms_gradient;
        all["skewness"] = surface.heights->skewness;
        all["kurtosis"] = surface.heights->kurtosis;
    }
    if (surface.fractal_dimension) all["fractal_dimension"] = *surface.fractal_dimension;
    if (surface.fractal_roughness) all["fractal_roughness"] = *surface.fractal_roughness;
    if (surface.r) all["r"] = *surface.r, all["theta"] = *surface.theta;
    return all;
}

Numbers numbers_of(const nlohmann::json& surface) {
    Numbers all;
    for (const auto& [name, one] : surface.items()) all[name] = {one["value"], one["error"]};
    return all;
}

void require_same(const Numbers& found, const Numbers& wanted) {
    REQUIRE(found.size() == wanted.size());
    for (const auto& [name, one] : wanted) {
        CAPTURE(name);
        REQUIRE(found.count(name) == 1);
        CHECK(same(found.at(name).value, one.value));
        CHECK(same(found.at(name).error, one.error));
    }
}

void require_same(const nlohmann::json& found, const std::optional<double>& wanted) {
    REQUIRE(found.is_null() == !wanted);
    if (wanted) CHECK(same(found.get<double>(), *wanted));
}

/// What the command prints of \p surface, that of \p document.
void require_same(const nlohmann::json& document, const Surface<double>& surface) {
    require_same(numbers_of(document["surface"]), numbers_of(surface));
    require_same(document["lambda_s_m"], surface.cut_offs.lambda_s);
    require_same(document["lambda_c_m"], surface.cut_offs.lambda_c);
    if (surface.heights) CHECK(same(document["moments"]["alpha"], surface.heights->moments.bandwidth()));
    if (document.contains("widest_band") && !document["widest_band"].is_null())
        CHECK(same(document["widest_band"], surface.widest_band));
    const auto neighbours = document.value("neighbours", nlohmann::json::array());
    REQUIRE(neighbours.size() == surface.neighbours.size());
    for (std::size_t k = 0; k < neighbours.size(); ++k) require_same(neighbours[k], surface.neighbours[k]);
}

/// Whether the file is measured; then the headers find the same numbers, else they refuse it too.
bool is_measured(const std::filesystem::path& path) {
    const auto units = units_of_files.find(path.filename().string());
    const std::string line = units == units_of_files.end() ? "" : "--units " + units->second;
    const surface::SurfaceOptions options = test::surface_options(line, path.string());
    nlohmann::json document;
    if (!test::refusal([&] { document = test::measured_files(line, {path.string()}); }).empty()) {
        CHECK_THROWS_AS(std::visit([](const auto& heights) { return measure(heights).size; },
                                   surface::read_surface_input(options).surface.data),
                        domain_error);
        return false;
    }
    const surface::SurfaceInput input = surface::read_surface_input(options);
    const auto measured = [](const auto& heights) { return measure(heights); };
    const Surface<double> surface = std::visit(measured, input.surface.data);
    require_same(document, surface);
    std::vector<std::string> concerns;
    for (const MeasuredConcern one : surface.concerns) concerns.emplace_back(name_of(one));
    CHECK(document["concerns"] == concerns);
    return true;
}

/// K of \p curve and its band, step by step: the surfaces drawn about \p surface, and its neighbours, each by a
/// contact of its own with the law \p law_of(D).
template <class LawOf>
void require_same_band(const AnswerCurve& curve, const Surface<double>& surface, double modulus, const LawOf& law_of) {
    const std::vector<double> pressures{1e6, 1e7};
    const auto at = [&](const std::array<double, detail::surface_parameter_count>& drawn, std::size_t = 0) {
        const auto value = [&](Parameter which) { return drawn[detail::index_of(which)]; };
        std::vector<double> all;
        for (const auto& point : curve_at_pressures(
                 RoughContact(Roughness<double>{value(Parameter::rms_height), value(Parameter::peak_radius),
                                                value(Parameter::peak_density)},
                              PeakDistribution<double>(value(Parameter::r), value(Parameter::theta)),
                              law_of(value(Parameter::fractal_dimension)), modulus),
                 pressures, Quantity::stiffness))
            all.push_back(point.state.stiffness.value);
        return all;
    };
    const std::vector<double> own = at(surface.values());
    const auto errors = detail::sampled_band<double>(surface, at);
    REQUIRE(curve.points.size() == own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
        double low = 0, high = 0;
        for (const Surface<double>& neighbour : surface.neighbours) {
            auto values = neighbour.values();
            for (const Parameter which : {Parameter::r, Parameter::theta})
                if (!neighbour.find(which)) values[detail::index_of(which)] = surface.values()[detail::index_of(which)];
            const double change = std::log(at(values)[i] / own[i]);
            low = (std::min)(low, change), high = (std::max)(high, change);
        }
        if (const double share = surface.long_end.form_share; surface.is_profile && share > 0.01) {
            auto values = surface.values();
            values[detail::index_of(Parameter::rms_height)] *= std::hypot(1.0, share);
            low = (std::min)(low, std::log(at(values)[i] / own[i]));
        }
        CHECK(same(curve.points[i].state.stiffness.value, own[i]));
        CHECK(test::relative_error(curve.points[i].stiffness.low,
                                   own[i] * std::exp(-std::hypot(std::log(errors[i].low / own[i]), low))) < 1e-12);
        CHECK(test::relative_error(curve.points[i].stiffness.high,
                                   own[i] * std::exp(std::hypot(std::log(errors[i].high / own[i]), high))) < 1e-12);
        CHECK(high - low > 0.001);  // so that a band without it is another
    }
}

/// How many files of \p folder are measured.
std::size_t measured_files(const std::filesystem::path& folder) {
    std::size_t measured = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        INFO(entry.path().string());
        measured += is_measured(entry.path()) ? 1 : 0;
    }
    return measured;
}

}  // namespace

TEST_CASE("The command and the headers find the same numbers in every file of data") {
    const test::Folder folder;
    const SelfAffineOptions<double> fine{.hurst = 0.4, .rms = 0.3e-6, .longest_wavelength = 90e-6},
        coarse{.hurst = 0.7, .rms = 3e-6, .seed = 2}, of_map{.hurst = 0.7, .rms = 0.2e-6, .longest_wavelength = 12e-6};
    for (const std::string& text : {test::profile_text(4096, 0.5e-6, fine), test::profile_text(2048, 10e-6, coarse),
                                    test::map_text(96, 0.5e-6, of_map)})
        CHECK(is_measured(folder.write("made.txt", text)));
    (void)measured_files(FSTIFF_SCENES);
    CHECK(measured_files(FSTIFF_TEST_DATA "/formats") > 0);
}

TEST_CASE("The command and the headers pool several measurements of one surface to the same numbers") {
    const test::Folder folder;
    const auto require_pooled = [&](const std::vector<std::string>& texts, auto heights) {
        std::vector<std::string> files;
        for (const std::string& text : texts) {
            files.push_back(folder.write("made" + std::to_string(files.size()) + ".txt", text));
            heights.push_back(std::get<typename decltype(heights)::value_type>(
                surface::read_surface_input(test::surface_options("", files.back())).surface.data));
        }
        const auto document = test::measured_files("", files);
        const Surface<double> surface = measure(heights);
        require_same(document, surface);
        CHECK(surface.parts.size() == texts.size());
        CHECK(surface.neighbours.size() == 2);
        std::vector<std::string> concerns;
        for (const MeasuredConcern one : surface.concerns) concerns.emplace_back(name_of(one));
        CHECK(document["concerns"] == concerns);
    };
    const auto trace = [](std::uint64_t seed) {
        return SelfAffineOptions<double>{.hurst = 0.4, .rms = 0.3e-6, .longest_wavelength = 90e-6, .seed = seed};
    };
    require_pooled({test::profile_text(4096, 0.5e-6, trace(1)), test::profile_text(3000, 0.5e-6, trace(2)),
                    test::profile_text(2048, 0.6e-6, trace(3))},  // the tables choose another lambda_s for the third
                   std::vector<Profile<double>>{});
    const auto map = [](std::uint64_t seed) {
        return SelfAffineOptions<double>{.hurst = 0.7, .rms = 0.2e-6, .longest_wavelength = 12e-6, .seed = seed};
    };
    require_pooled({test::map_text(96, 0.5e-6, map(1)), test::map_text(80, 0.5e-6, map(2))},
                   std::vector<HeightMap<double>>{});
}

TEST_CASE("K of a law that is named and its band are those of the contacts one by one") {
    const test::Folder folder;
    for (const std::string& text :
         {test::profile_text(4096, 0.5e-6, {.hurst = 0.4, .rms = 0.3e-6, .longest_wavelength = 90e-6, .seed = 3}),
          test::map_text(192, 0.5e-6, {.hurst = 0.5, .rms = 0.2e-6, .longest_wavelength = 90e-6, .seed = 3})}) {
        const auto options = test::surface_options("", folder.write("made.txt", text));
        const auto results = test::results_of(
            "[surface]\nfrom = \"made.txt\"\n[material.upper]\n"
            "youngs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n[contact]\n"
            "pressures = [\"1 MPa\", \"10 MPa\"]\nlaws = [\"hertz\", \"fractal\"]\n",
            folder / "scene.toml");
        REQUIRE(results.curves().size() == 2);
        const auto measured = [](const auto& heights) { return measure(heights); };
        const Surface<double> found = std::visit(measured, surface::read_surface_input(options).surface.data);
        REQUIRE(found.fractal_dimension);
        const double modulus = effective_modulus<double>({205e9, 0.3}, {205e9, 0.3});
        const auto hertz = [](double) { return HertzLaw<double>{}; };
        const auto fractal = [](double dimension) { return FractalLaw<double>(dimension); };
        require_same_band(results.curves()[0], found, modulus, hertz);
        require_same_band(results.curves()[1], found, modulus, fractal);
    }
}

TEST_CASE("The command and the headers find the same K of a map by hybrid") {
    const test::Folder folder;
    const auto file = folder.write(
        "made.txt", test::map_text(128, 0.5e-6, {.hurst = 0.8, .rms = 0.2e-6, .longest_wavelength = 20e-6, .seed = 3}));
    const auto results = test::results_of(
        "[surface]\nfrom = \"made.txt\"\n[material.upper]\nyoungs_modulus = \"205 GPa\"\npoisson_ratio = 0.3\n"
        "[contact]\npressures = [\"1 MPa\", \"10 MPa\", \"100 MPa\"]\nlaws = [\"hybrid\"]\n",
        folder / "scene.toml");
    REQUIRE(results.curves().size() == 1);
    const auto read = surface::read_surface_input(test::surface_options("", file)).surface.data;
    const auto map = prepare(std::get<HeightMap<double>>(read), {.lambda_s = no_cut_off}).map;
    const auto contact = hybrid_of_map(map, effective_modulus<double>({205e9, 0.3}, {205e9, 0.3}));
    REQUIRE(results.curves()[0].points.size() == 3);
    for (const ContactState<double>& state : test::states_of(results.curves()[0]))
        CHECK(test::relative_error(contact.at_pressure(state.pressure.value).stiffness.value, state.stiffness.value) <
              1e-12);
}

TEST_CASE("The command and the headers find the same numbers in every measured file") {
    if (!std::filesystem::exists(FSTIFF_SURFACES))
        SKIP_CASE("there is no folder of measured surfaces " FSTIFF_SURFACES);
    CHECK(measured_files(FSTIFF_SURFACES) >= 8);
}

}  // namespace one_measurement_test
