// SPDX-License-Identifier: BSD-3-Clause
// Truth: Hertz's sphere with its images; the derivative of p; boundary elements of tests/data/bem_maps.csv.
#include <fstiff/contact/contact_concept.hpp>
#include <fstiff/contact/mutual_summits.hpp>
#include <fstiff/contact/summit_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"
#include "support/table.hpp"

#include <numbers>

namespace mutual_summits_test {

using namespace fstiff;

static_assert(ProportionalContact<MutualSummits<double>, double>);

TEST_CASE("one summit that repeats: Hertz less the mean field of its images") {
    const double E = 1e11, side = 1e-4, R = 2.5e-5, omega = 1e-7;
    const Summits<double> one{{{2e-6, 4e4, 4e4, 3e-5, 4e-5}}, side * side, side, side, 1e-6};
    const MutualSummits<double> contact(one, E, Edges::periodic);
    // 4 ln(1 + sqrt 2) is the mean of side/r over the square about its middle
    const double C = 4 * std::log(1 + std::numbers::sqrt2) * side / (std::numbers::pi * E);
    const double p = 4.0 / 3 * E * std::sqrt(R) * std::pow(omega, 1.5) / (side * side);
    const auto state = contact.at_pressure(p);
    CHECK(test::relative_error(state.separation.value, 2e-6 - omega + p * C) < 1e-10);
    CHECK(test::relative_error(1 / state.stiffness.value, side * side / (2 * E * std::sqrt(R * omega)) - C) < 1e-9);
}

TEST_CASE("summits that push each other down: K is the slope, pressure and separation undo each other") {
    const auto map = test::half_space_map("rougher");
    const MutualSummits<double> contact(summits_of(map), 1.0, Edges::periodic);
    for (const double p : {3e-5, 3e-4, 1e-3}) {
        const auto state = contact.at_pressure(p), low = contact.at_pressure(p * (1 - 1e-5)),
                   high = contact.at_pressure(p * (1 + 1e-5));
        CAPTURE(p);
        const double slope = 2e-5 * p / (low.separation.value - high.separation.value);
        CHECK(test::relative_error(state.stiffness.value, slope) < 1e-6);  // of 1e-5 and the 1e-10 of the solution
        CHECK(test::relative_error(contact.at_separation(state.separation.value).pressure.value, p) < 1e-9);
    }
}

TEST_CASE("summits that push each other down against boundary elements") {
    const test::Table table("bem_maps.csv");
    double least = 9, most = 0, least_alone = 9, most_alone = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
        if (table.input(row, "p_star") > 0.0101) continue;
        const auto summits = summits_of(test::half_space_map(table.text(row, "map")));
        const double p = table.input(row, "p_over_E"), truth = table.input(row, "stiffness_times_L_over_E");
        const double ratio =
            MutualSummits<double>(summits, 1.0, Edges::periodic).at_pressure(p).stiffness.value / truth;
        const double alone = SummitContact<double>(summits, 1.0).at_pressure(p).stiffness.value / truth;
        least = std::min(least, ratio), most = std::max(most, ratio);
        least_alone = std::min(least_alone, alone), most_alone = std::max(most_alone, alone);
    }
    CAPTURE(least, most, least_alone, most_alone);
    CHECK(least > 0.90);
    CHECK(most < 1.04);
    CHECK(least_alone < 0.78);  // what the deflection mends
}

TEST_CASE("summits that are too crowded are refused") {
    const auto map = test::half_space_map("rougher");
    const MutualSummits<double> contact(summits_of(map), 1.0, Edges::periodic);
    const auto far = contact.point_at_pressure(0.05);
    CHECK(far.status == PointStatus::out_of_reach);
    CHECK(far.reason.find("hybrid and boundary_elements go on") != std::string::npos);
    CHECK(test::refusal([&] { (void)contact.at_pressure(0.0); }).find("pressure") == 0);
    CHECK(test::refusal([&] { (void)contact.at_separation(1.0); }).find("separation") == 0);
}

}  // namespace mutual_summits_test
