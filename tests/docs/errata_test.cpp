// SPDX-License-Identifier: BSD-3-Clause
// The figures of docs/errata.md that the test of no header checks, each to the digits in which it is quoted.
#include <fstiff/answer/checks.hpp>
#include <fstiff/asperity/laws.hpp>
#include <fstiff/asperity/material.hpp>
#include <fstiff/asperity/plastic_laws.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/wave/spring_interface.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"

#include <algorithm>
#include <array>
#include <numbers>

namespace errata_test {

using namespace fstiff;

namespace {

constexpr double pi = std::numbers::pi;
const double modulus = effective_modulus<double>({205e9, 0.3}, {205e9, 0.3});
const double nominal_length = std::sqrt(195e-6);  // L = sqrt(A0)
const PeakDistribution<double> quarter(0, pi / 4), third = PeakDistribution<double>::exponential(pi / 3);

using test::paper_surfaces;
using Surface = test::PaperSurface;

/// Whether \p value, rounded to the digit that \p unit is, reads \p quoted.
bool reads(double value, double quoted, double unit) { return std::abs(value - quoted) <= 0.5000001 * unit; }

double hertz_stiffness(const Surface& surface, double pressure, const PeakDistribution<double>& peaks,
                       Interaction<double> interaction = {}) {
    const RoughContactOptions<double> options{.interaction = interaction};
    return RoughContact(surface.roughness(), peaks, HertzLaw<double>{}, modulus, options)
        .at_pressure(pressure, Quantity::stiffness)
        .stiffness.value;
}

}  // namespace

TEST_CASE("(3.4): as printed, a truncation of a millionth keeps five of sixteen digits") {
    const double share = 1e-6;
    const double printed = 1 - std::cos(pi * share);
    const double sine = std::sin(pi * share / 2);
    const double error = test::relative_error(printed, 2 * sine * sine);
    CHECK(error > 1e-6);
    CHECK(error < 3e-5);  // half an epsilon of 1, over q = 4.9e-12
}

TEST_CASE(
    "(4.1), (4.8): the curvatures of the peaks alone spread by 0.60 and 0.58, which would raise K by 1.29, 1.31") {
    for (const auto& [peaks, spread, raised] : {std::tuple{quarter, 0.60, 1.29}, {third, 0.58, 1.31}}) {
        const double mean = peaks.mean_curvature();
        const double deviation = std::sqrt(peaks.curvature_moment(2) - mean * mean);
        CHECK(reads(deviation, spread, 0.01));
        CHECK(reads(1 / std::sqrt(deviation), raised, 0.01));  // K goes as sigma_kappa^(-1/2)
    }
}

TEST_CASE("(4.10): at equal separation the print is 1.15 and 1.20 times the consistent reading") {
    CHECK(reads(1 / std::sqrt(3 * std::sqrt(pi) / 8 * quarter.mean_curvature()), 1.15, 0.01));
    CHECK(reads(1 / std::sqrt(3 * std::sqrt(pi) / 8 * third.mean_curvature()), 1.20, 0.01));
}

TEST_CASE("(4.11): the table of the interaction, the bulk's own stiffness, and where substitution diverges") {
    struct Row {
        double shift;
        std::array<double, 3> effective, printed, units;  // at 1, 10, 100 MPa; last digit of `printed`
        double diverges_above;                            // MPa
    };
    const std::array<Row, 3> rows{
        Row{14.90, {0.68, 0.21, 0.038}, {1.52, 11.0, 16.1}, {0.01, 0.1, 0.1}, 2.3},
        Row{2.417, {0.92, 0.58, 0.15}, {1.08, 1.89, 17.6}, {0.01, 0.01, 0.1}, 14},
        Row{1.387, {0.95, 0.70, 0.23}, {1.05, 1.46, 8.8}, {0.01, 0.01, 0.1}, 26},
    };
    const std::array<double, 3> pressures{1e6, 1e7, 1e8};
    for (std::size_t i = 0; i < paper_surfaces.size(); ++i) {
        const Surface& surface = paper_surfaces[i];
        const Row& row = rows[i];
        const double shift = 1e8 * nominal_length / (modulus * surface.rms_height);
        CHECK(reads(shift, row.shift, row.shift > 10 ? 0.01 : 0.001));
        for (std::size_t k = 0; k < 3; ++k) {
            const auto ratio = [&](InteractionReading reading) {
                return hertz_stiffness(surface, pressures[k], quarter, {reading, nominal_length}) /
                       hertz_stiffness(surface, pressures[k], quarter);
            };
            const double effective = ratio(InteractionReading::effective_separation);
            const double printed = ratio(InteractionReading::as_printed);
            CAPTURE(surface.name, pressures[k], effective, printed);
            CHECK(reads(effective, row.effective[k], row.effective[k] < 0.1 ? 0.001 : 0.01));
            CHECK(reads(printed, row.printed[k], row.units[k]));
        }
        // the slope K L/E of the correction passes 1 there
        const auto slope = [&](double pressure) {
            return hertz_stiffness(surface, pressure, quarter) * nominal_length / modulus;
        };
        const double half_digit = row.diverges_above < 10 ? 0.05e6 : 0.5e6;
        CHECK(slope(row.diverges_above * 1e6 - half_digit) < 1);
        CHECK(slope(row.diverges_above * 1e6 + half_digit) > 1);
    }
    CHECK(reads(modulus / nominal_length * 1e-15, 0.0081, 0.0001));  // GPa/um
}

TEST_CASE("(5.1): between steel and aluminium no reflection below 0.46") {
    CHECK(reads((46.0 - 17.0) / (46.0 + 17.0), 0.46, 0.01));
    const double rigid = reflection(1e30, Impedances<double>{46e6, 17e6}, 2 * pi * 7e6);
    CHECK(test::relative_error(rigid, (46.0 - 17.0) / (46.0 + 17.0)) < 1e-12);
}

TEST_CASE("Table 1: sigma R D_p against the least of an isotropic Gaussian surface") {
    const std::array<double, 3> products{0.0166, 0.0354, 0.0272};
    for (std::size_t i = 0; i < 3; ++i) {
        const Surface& r = paper_surfaces[i];
        CHECK(reads(r.rms_height * r.peak_radius * r.peak_density, products[i], 0.0001));
    }
    CHECK(reads(0.02036 * std::sqrt(1.5), detail::min_gaussian_product<double>, 0.0001));
}

TEST_CASE("The conclusions: fractal over Greenwood-Williamson, and the influence of theta") {
    const std::array<std::pair<double, double>, 3> over_gw{{{2.47, 2.58}, {2.29, 2.35}, {2.93, 3.00}}};
    const std::array<std::pair<double, double>, 3> over_quarter{{{1.06, 1.18}, {1.05, 1.14}, {1.05, 1.14}}};
    for (std::size_t i = 0; i < 3; ++i) {
        const Surface& surface = paper_surfaces[i];
        const double f = detail::fractal_stiffness_factor(surface.fractal_dimension);
        const GreenwoodWilliamson<double> gw(surface.roughness(), modulus);
        std::pair<double, double> gw_range{1e9, 0}, theta_range{1e9, 0};
        const auto widen = [](std::pair<double, double>& range, double value) {
            range = {std::min(range.first, value), std::max(range.second, value)};
        };
        for (int k = 0; k <= 30; ++k) {
            const double pressure = 1e5 * std::pow(10.0, k / 10.0);
            const double at_quarter = hertz_stiffness(surface, pressure, quarter);
            const double at_third = hertz_stiffness(surface, pressure, third);
            widen(gw_range, f * at_quarter / gw.at_pressure(pressure, Quantity::stiffness).stiffness.value);
            widen(theta_range, at_third / at_quarter);
        }
        CAPTURE(surface.name, gw_range.first, gw_range.second, theta_range.first, theta_range.second);
        CHECK(reads(gw_range.first, over_gw[i].first, 0.01));
        CHECK(reads(gw_range.second, over_gw[i].second, 0.01));
        CHECK(reads(theta_range.first, over_quarter[i].first, 0.01));
        CHECK(reads(theta_range.second, over_quarter[i].second, 0.01));
    }
    // at equal separation, eta from 0 to 3
    double least = 1e9, most = 0;
    for (double eta = 0; eta <= 3; eta += 0.125) {
        const double ratio =
            contact_integral(0.5, -0.5, third, eta).value / contact_integral(0.5, -0.5, quarter, eta).value;
        least = std::min(least, ratio);
        most = std::max(most, ratio);
    }
    CHECK(reads(least, 1.68, 0.01));
    CHECK(reads(most, 2.14, 0.01));
}

TEST_CASE("What plastic flow alone would give over the printed fractal law") {
    const double pressures[] = {1e5, 1e6, 1e7, 1e8}, fine[] = {0.96, 1.01, 1.07, 1.15};
    const double ends[3][2] = {{0.96, 1.15}, {2.2, 3.4}, {2.8, 4.8}};  // least and most of plastic and jackson_green
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& surface = test::paper_surfaces[i];
        double least = 1e9, most = 0;
        for (std::size_t k = 0; k < 4; ++k) {
            const PlasticMaterial<double> steel{modulus, 400e6, 0.3};
            const auto at = [&](const auto& law) {
                return RoughContact(surface.roughness(), quarter, law, modulus)
                    .at_pressure(pressures[k], Quantity::stiffness)
                    .stiffness.value;
            };
            const double fractal = at(FractalLaw<double>(surface.fractal_dimension));
            const double flowing = at(JacksonGreenLaw<double>(steel)) / fractal;
            const double plastic = at(PlasticLaw<double>(steel.hardness_or_default(), modulus)) / fractal;
            if (i == 0) CHECK(reads(flowing, fine[k], 0.01));
            least = std::min(least, i == 0 ? flowing : std::min(flowing, plastic));
            most = std::max(most, i == 0 ? flowing : std::max(flowing, plastic));
        }
        CAPTURE(surface.name, least, most);
        CHECK(reads(least, ends[i][0], i == 0 ? 0.01 : 0.1));
        CHECK(reads(most, ends[i][1], i == 0 ? 0.01 : 0.1));
    }
}

}  // namespace errata_test
