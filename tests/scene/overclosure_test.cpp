// SPDX-License-Identifier: BSD-3-Clause
// The table of pressures over overclosures. Truth: the chords of an exponential in closed form; the library's contacts,
// made by hand, at pressures that the table was not made of.
#include "actions/overclosure.hpp"

#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/rough_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/files.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overclosure_test {

using namespace fstiff;
using Row = actions::PressureTable::Row;

namespace {

scene::Scene fine() { return scene::read_scene(test::read(FSTIFF_SCENES "/sand_blasted_fine.toml"), {.name = "fine"}); }

/// The largest relative error of the chord of exp(x) over a length \p length of x.
double error_of_chord(double length) {
    double worst = 0;
    for (int i = 1; i < 4000; ++i) {
        const double share = i / 4000.0;
        worst = std::max(worst, (1 + share * std::expm1(length)) * std::exp(-share * length) - 1);
    }
    return worst;
}

double interpolated(const std::vector<Row>& rows, double overclosure) {
    const auto above =
        std::find_if(rows.begin() + 1, rows.end() - 1, [&](const Row& r) { return r.overclosure >= overclosure; });
    const Row a = *(above - 1), b = *above;
    return a.pressure + (b.pressure - a.pressure) * (overclosure - a.overclosure) / (b.overclosure - a.overclosure);
}

/// Error of the lines of \p table against the separations of \p contact.
template <class Contact>
double largest_error(const actions::PressureTable& table, const Contact& contact) {
    double worst = 0;
    for (int i = 0; i < 3001; ++i) {
        const double p = table.from * std::pow(table.to / table.from, i / 3000.0);
        const double overclosure = table.zero_separation - contact.at_pressure(p, Quantity::pressure).separation.value;
        worst = std::max(worst, std::abs(interpolated(table.rows, overclosure) / p - 1));
    }
    return worst;
}

}  // namespace

TEST_CASE("Of an exponential as many rows are taken as its chords ask for") {
    actions::Line points;
    for (int i = 0; i <= 7000; ++i) points.push_back({1e-3 * i, std::exp(1e-3 * i)});
    for (const double tolerance : {0.1, 0.01, 0.001}) {
        const auto rows = actions::rows_within({points}, {tolerance, 1});
        double length = 0;  // the longest chord, in steps of the points
        while (error_of_chord(length + 1e-3) <= tolerance) length += 1e-3;
        CHECK(rows.front() == 0);
        CHECK(rows.back() == 7000);
        CHECK(rows.size() == 1 + static_cast<std::size_t>(std::ceil(7.0 / length)));
        for (std::size_t i = 1; i + 1 < rows.size(); ++i)
            CHECK(std::abs(1e-3 * static_cast<double>(rows[i] - rows[i - 1]) - length) < 2e-3);
        // a straight line asks for no rows of its own, and takes those of the other
        actions::Line straight;
        for (const actions::LinePoint& point : points) straight.push_back({point.x, 1 + point.x});
        CHECK(actions::rows_within({straight}, {tolerance, 1}).size() == 2);
        CHECK(actions::rows_within({straight, points}, {tolerance, 1}) == rows);
        CHECK(actions::rows_within({points, straight}, {tolerance, 1}) == rows);
        CHECK(std::abs(actions::error_of_rows({straight, points}, rows).value - tolerance) < 0.01 * tolerance);
    }
}

TEST_CASE("Between the rows the pressure is off by the tolerance and no more, under every law of the paper") {
    const auto peaks = PeakDistribution<double>::exponential(std::numbers::pi / 3);
    const double modulus = effective_modulus<double>({205e9, 0.3}, {205e9, 0.3});
    const Roughness<double> surface{.rms_height = 0.832e-6, .peak_radius = 40e-6, .peak_density = 500e6};
    for (const double tolerance : {0.1, 0.01, 1e-4}) {
        const auto check = [&](const char* law, const auto& contact) {
            const auto table =
                actions::pressure_table(fine(), {.law = law, .peaks = 2, .tolerance = tolerance, .slope_tolerance = 1});
            const double error = largest_error(table, contact);
            INFO(table.title << ", tolerance " << tolerance << ", error " << error);
            CHECK(error <= tolerance);
            CHECK(error > 0.87 * tolerance);  // no line could be a sixteenth longer
            CHECK(table.error.value <= tolerance);
            CHECK(std::abs(table.error.value - error) < 0.02 * tolerance);
            CHECK(test::relative_error(table.from, 1e5) < 1e-12);
            CHECK(test::relative_error(table.to, 1e8) < 1e-12);
            CHECK(table.rows.front().pressure == 0);
            CHECK(table.rows.front().overclosure == 0);
            for (std::size_t i = 1; i < table.rows.size(); ++i) {
                CHECK(table.rows[i].pressure > table.rows[i - 1].pressure);
                CHECK(table.rows[i].overclosure > table.rows[i - 1].overclosure);
            }
        };
        check("hertz", RoughContact(surface, peaks, HertzLaw<double>{}, modulus));
        check("fractal", RoughContact(surface, peaks, FractalLaw<double>(1.62), modulus));
    }
}

TEST_CASE("Of an exponential the slopes of chords ask for two tolerances of its logarithm a row") {
    actions::Line points;
    for (int i = 0; i <= 7000; ++i) points.push_back({1e-3 * i, std::exp(1e-3 * i), std::exp(1e-3 * i)});
    for (const double tolerance : {0.02, 0.1}) {
        const auto rows = actions::rows_within({points}, {1, tolerance});
        double length = 0;  // (e^x - 1)/x of the slope at the begin of a chord is its own
        while (std::expm1(length + 1e-3) / (length + 1e-3) - 1 <= tolerance) length += 1e-3;
        CHECK(rows.size() == 1 + static_cast<std::size_t>(std::ceil(7.0 / length - 1e-9)));
        CHECK(actions::error_of_rows({points}, rows).slope <= tolerance);
    }
}

TEST_CASE("Between the rows the slope is K of the law within its tolerance") {
    const auto peaks = PeakDistribution<double>::exponential(std::numbers::pi / 3);
    const double modulus = effective_modulus<double>({205e9, 0.3}, {205e9, 0.3});
    const Roughness<double> surface{.rms_height = 0.832e-6, .peak_radius = 40e-6, .peak_density = 500e6};
    const RoughContact contact(surface, peaks, HertzLaw<double>{}, modulus);
    for (const double tolerance : {0.02, 0.005, 0.1}) {
        const auto table = actions::pressure_table(fine(), {.law = "hertz", .peaks = 2, .slope_tolerance = tolerance});
        double worst = 0;
        for (std::size_t i = 2; i < table.rows.size(); ++i) {
            const Row a = table.rows[i - 1], b = table.rows[i];
            const double slope = (b.pressure - a.pressure) / (b.overclosure - a.overclosure);
            for (const double share : {1e-6, 0.3, 0.5, 0.7, 1 - 1e-6}) {
                const double p = a.pressure + share * (b.pressure - a.pressure);
                worst =
                    std::max(worst, std::abs(slope / contact.at_pressure(p, Quantity::stiffness).stiffness.value - 1));
            }
        }
        CHECK(worst <= tolerance);
        CHECK(worst > 0.8 * tolerance);  // one more of the eight points between two rows would be too many
        CHECK(std::abs(table.error.slope - worst) < 0.01 * tolerance);
        CHECK(table.follows_slope);
    }
}

TEST_CASE("A shorter range, and what a table cannot be made of") {
    const auto table = actions::pressure_table(fine(), {.law = "hertz", .from = 1e6, .to = 2e6});
    CHECK(test::relative_error(table.from, 1e6) < 1e-12);
    CHECK(test::relative_error(table.rows.back().pressure, 2e6) < 1e-12);
    const auto refusal = [](const actions::PressureTableOptions& options) {
        return test::refusal([&] { (void)actions::pressure_table(fine(), options); });
    };
    CHECK(
        refusal({.law = "plastic"}) ==
        "law = \"plastic\": is not a law of the scene that gives a separation; must be one of \"fractal\", \"hertz\", "
        "\"greenwood_williamson\", \"answer\"");
    CHECK(refusal({.peaks = 0}) == "peaks = 0: must be between 1 and 2, as many as contact.peaks has");
    CHECK(refusal({.from = 2e6, .to = 1e6}) == "until = 1000000: must be greater than from, 2e+06 Pa");
    scene::Scene one = fine();
    one.points = {1e6};
    CHECK(test::refusal([&] { (void)actions::pressure_table(one, {}); }) ==
          "until = 1000000: must be greater than from, 1e+06 Pa; the scene has only one pressure");
    CHECK(refusal({.from = -1.0}) == "from = -1: must be finite and greater than 0");
    CHECK(refusal({.tolerance = 0.3}) == "tolerance = 0.3: must be between 0.001 % and 20 %");
    CHECK(refusal({.tolerance = 0.9e-5}).starts_with("tolerance = 9e-06: must be"));
    CHECK(refusal({.slope_tolerance = 1e-4}) == "slope_tolerance = 0.0001: must be between 0.1 % and 100 %");
}

}  // namespace overclosure_test
