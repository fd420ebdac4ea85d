// SPDX-License-Identifier: BSD-3-Clause
// Truth: means and standard deviations written out by hand.
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/tabulated/mean_over_shifts.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <vector>

namespace mean_over_shifts_test {

using namespace fstiff;
using One = GreenwoodWilliamson<double>;
static_assert(detail::HasStates<MeanOverShifts<One>, double>);

namespace {

std::vector<One> contacts() {
    std::vector<One> all;
    for (const double radius : {20e-6, 40e-6, 70e-6})
        all.emplace_back(Roughness<double>{.rms_height = 0.8e-6, .peak_radius = radius, .peak_density = 500e6}, 1e11);
    return all;
}

}  // namespace

TEST_CASE("the mean over shifts is the mean, and its error holds the scatter of one shift") {
    const std::vector<One> all = contacts();
    const MeanOverShifts<One> mean(all);
    for (const bool at_pressure : {true, false}) {
        const auto state_of = [&](const auto& contact) {
            return at_pressure ? contact.at_pressure(1e6) : contact.at_separation(2e-6);
        };
        const auto a = state_of(all[0]), b = state_of(all[1]), c = state_of(all[2]), found = state_of(mean);
        for (const auto member : {&ContactState<double>::stiffness, &ContactState<double>::separation,
                                  &ContactState<double>::real_area_fraction, &ContactState<double>::contact_density,
                                  &ContactState<double>::loading_stiffness, &ContactState<double>::pressure}) {
            const double x = (a.*member).value, y = (b.*member).value, z = (c.*member).value, m = (x + y + z) / 3;
            const double scatter = std::sqrt(((x - m) * (x - m) + (y - m) * (y - m) + (z - m) * (z - m)) / 2);
            const double error = ((a.*member).error + (b.*member).error + (c.*member).error) / 3;
            CHECK(test::relative_error((found.*member).value, m) < 1e-14);
            CHECK(std::abs((found.*member).error - std::sqrt(scatter * scatter + error * error)) < 1e-12 * std::abs(m));
        }
        CHECK(test::relative_error(found.eta, (a.eta + b.eta + c.eta) / 3) < 1e-14);
        CHECK(found.stiffness.evaluations ==
              a.stiffness.evaluations + b.stiffness.evaluations + c.stiffness.evaluations);
    }
    CHECK(test::relative_error(mean.rms_height(), 0.8e-6) < 1e-15);
}

TEST_CASE("the mean of one contact is that contact and a point missing in one is missing in the mean") {
    const One alone = contacts()[0];
    const MeanOverShifts<One> mean({alone});
    CHECK(mean.at_pressure(1e6).stiffness.value == alone.at_pressure(1e6).stiffness.value);
    CHECK(mean.at_pressure(1e6).stiffness.error == alone.at_pressure(1e6).stiffness.error);
    CHECK(test::refusal([] { MeanOverShifts<One>(std::vector<One>{}); }) == "contacts = 0: must be at least 1");
    std::vector<One> uneven = contacts();
    uneven.emplace_back(Roughness<double>{.rms_height = 0.8e-9, .peak_radius = 20e-6, .peak_density = 500e6}, 1e11);
    const double apart = -1e-6;  // -1250 rms heights of the last one, below the -1000 that are searched
    const auto reason = uneven.back().point_at_separation(apart).reason;
    const auto point = MeanOverShifts<One>(uneven).point_at_separation(apart);
    CHECK_FALSE(point.ok());
    CHECK(point.reason == reason);
}

TEST_CASE("the table of a mean has its K and its separation") {
    const MeanOverShifts<One> mean(contacts());
    LawRange<double> range;
    range.min_pressure = 1e5, range.max_pressure = 1e7;
    const ContactLaw<double> law = mean.tabulate(range);
    const double tolerance = law.relative_error();
    CHECK(tolerance < 1e-3);
    for (const double p : {1.3e5, 1e6, 8e6}) {
        const ContactState<double> state = mean.at_pressure(p);
        CHECK(test::relative_error(law.stiffness(p), state.stiffness.value) < tolerance);
        CHECK(std::abs(law.separation(p) - state.separation.value) < tolerance * mean.rms_height());
    }
}

}  // namespace mean_over_shifts_test
