// SPDX-License-Identifier: BSD-3-Clause
// Truth: Hertz's formula for one sphere; K as the slope of p; sums over elliptic summits of periodic maps in
// tests/data/elliptic_summits.csv.
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/interaction.hpp>
#include <fstiff/contact/summit_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/table.hpp"

#include <map>
#include <numbers>
#include <random>
#include <string>

namespace summit_contact_test {

using namespace fstiff;

static_assert(detail::ProportionalContact<SummitContact<double>, double>);
static_assert(detail::ProportionalContact<HybridContact<double, SummitContact<double>>, double>);

namespace {

Summits<double> drawn(std::size_t count) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    Summits<double> summits;
    summits.area = 1e-8;
    summits.rms_height = 1e-6;
    for (std::size_t i = 0; i < count; ++i)
        summits.summits.push_back({1e-6 * normal(random), 1e4 * std::exp(0.5 * normal(random)), 2e4, 0, 0});
    std::sort(summits.summits.begin(), summits.summits.end(),
              [](const auto& a, const auto& b) { return a.height > b.height; });
    return summits;
}

}  // namespace

TEST_CASE("one summit is Hertz's sphere") {
    const Summits<double> one{{{2e-6, 4e4, 4e4, 0, 0}}, 1e-8, 1e-4, 1e-4, 1e-6};
    const double E = 1e11, R = 2 / 8e4, omega = 3e-7;
    const SummitContact<double> contact(one, E);
    const auto state = contact.at_separation(2e-6 - omega);
    CHECK(test::relative_error(state.pressure.value, 4.0 / 3 * E * std::sqrt(R) * std::pow(omega, 1.5) / 1e-8) < 1e-13);
    CHECK(test::relative_error(state.stiffness.value, 2 * E * std::sqrt(R * omega) / 1e-8) < 1e-13);
    CHECK(test::relative_error(state.real_area_fraction.value, std::numbers::pi * R * omega / 1e-8) < 1e-13);
    CHECK(test::relative_error(state.contact_density.value, 1e8) < 1e-15);
}

TEST_CASE("pressure and separation undo each other, K is the slope, whatever the pressure") {
    const Summits<double> summits = drawn(1000);
    const SummitContact<double> contact(summits, 1e11);
    for (const double p : {1.0, 1e4, 1e7, 1e9, 1e11}) {
        const auto state = contact.at_pressure(p);
        const double d = state.separation.value, h = 1e-4 * (summits.summits[0].height - d);
        CAPTURE(p, d);
        // d is rounded
        CHECK(test::relative_error(contact.at_separation(d).pressure.value, p) <
              1e-11 + 1e-15 * d * state.stiffness.value / p);
        CHECK(state.separation.error < 1e-14 * 1e-4);
        const double slope =
            (contact.at_separation(d - h).pressure.value - contact.at_separation(d + h).pressure.value) / (2 * h);
        CHECK(test::relative_error(slope, state.stiffness.value) < 1e-4);  // a summit may join between
        CHECK(state.loading_stiffness.value == state.stiffness.value);
        const auto log_p = contact.log_pressure(state.eta);
        CHECK(test::relative_error(log_p.log, std::log(p)) < 1e-10);
        CHECK(test::relative_error(log_p.slope, -state.stiffness.value / p * 1e-6) < 1e-10);
    }
}

TEST_CASE("sums over the elliptic summits of maps, from round ones to ones stretched 4:1, by other means") {
    const test::Table points("elliptic_summits.csv"), truth("elliptic_summits_stiffness.csv");
    std::map<std::string, Summits<double>> maps;
    for (std::size_t row = 0; row < points.size(); ++row) {
        Summits<double>& map = maps[points.text(row, "map")];
        map.area = map.rms_height = 1;
        map.summits.push_back({points.input(row, "height"), points.input(row, "max_curvature"),
                               points.input(row, "min_curvature"), 0, 0});
    }
    REQUIRE(maps.size() == 3);
    for (std::size_t row = 0; row < truth.size(); ++row) {
        const SummitContact<double> contact(maps.at(truth.text(row, "map")), 1.0);
        const double K = contact.at_pressure(truth.input(row, "p_over_E")).stiffness.value;
        CAPTURE(truth.text(row, "map"), truth.input(row, "p_over_E"));
        CHECK(test::relative_error(K, truth.input(row, "stiffness_times_L_over_E")) < 1e-11);
    }
}

TEST_CASE("contacts of summits that are none are refused") {
    CHECK(test::refusal([] { SummitContact<double>({{}, 1, 1, 1, 1}, 1.0); }).find("summits") == 0);
    CHECK(test::refusal([] { SummitContact<double>(drawn(3), 0.0); }).find("effective_modulus") == 0);
    const SummitContact<double> contact(drawn(10), 1e11);
    for (const double p : {0.0, -1.0, std::nan("")})
        CHECK(test::refusal([&] { (void)contact.at_pressure(p); }).find("pressure") == 0);
    CHECK(test::refusal([&] { (void)contact.at_separation(1e-3); }).find("separation") == 0);
}

}  // namespace summit_contact_test
