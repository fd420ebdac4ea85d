// SPDX-License-Identifier: BSD-3-Clause
// Truth: the contact itself, one state a call; a contact made for the test that reports its limits.
#include <fstiff/contact/contact_curve.hpp>
#include <fstiff/contact/contact_state.hpp>
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/contact/rough_contact.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <array>
#include <numbers>
#include <span>

namespace contact_curve_test {

using namespace fstiff;

namespace {

const Roughness<double> fine{.rms_height = 0.832e-6, .peak_radius = 40e-6, .peak_density = 500e6};
const auto peaks = PeakDistribution<double>::exponential(std::numbers::pi / 3);

bool same(const ContactState<double>& a, const ContactState<double>& b) {
    return a.eta == b.eta && a.separation.value == b.separation.value && a.pressure.value == b.pressure.value &&
           a.stiffness.value == b.stiffness.value && a.stiffness.error == b.stiffness.error &&
           a.real_area_fraction.value == b.real_area_fraction.value &&
           a.contact_density.value == b.contact_density.value;
}

/// K = p; accepts pressures up to 10, and has numbers up to 8.
struct Short {
    ContactPoint<double> point_at_pressure(double pressure, Quantity) const {
        if (pressure > 10) return ContactPoint<double>::out_of_reach("pressure = 11: must be at most 10");
        ContactState<double> state;
        state.pressure.value = pressure;
        state.stiffness.value = pressure > 8 ? std::numeric_limits<double>::max() : pressure;
        return ContactPoint<double>::of(state);
    }
};

static_assert(detail::HasPressures<Short, double> && !detail::HasSeparations<Short, double>);
static_assert(detail::HasPressures<GreenwoodWilliamson<double>, double> &&
              detail::HasSeparations<GreenwoodWilliamson<double>, double>);
static_assert(detail::HasPressures<RoughContact<float, HertzLaw<float>>, float> && !detail::HasPressures<int, double>);

}  // namespace

TEST_CASE("A curve has the states of its contact, bit for bit, in the order of its points") {
    const RoughContact contact(fine, peaks, HertzLaw<double>{}, 112.6e9);
    const GreenwoodWilliamson<double> spheres(fine, 112.6e9);
    const std::vector<double> pressures{1e7, 1e3, 3e6}, separations{-1e-6, 4e-6, 0.0};
    const auto check = [&](const auto& one) {
        const auto by_pressure = curve_at_pressures(one, pressures);
        const auto by_separation = curve_at_separations(one, std::span<const double>(separations), Quantity::stiffness);
        REQUIRE((by_pressure.size() == 3 && by_separation.size() == 3));
        for (std::size_t i = 0; i < 3; ++i) {
            CHECK((by_pressure[i].ok() && by_pressure[i].reason.empty()));
            CHECK(same(by_pressure[i].state, one.at_pressure(pressures[i])));
            CHECK(same(by_separation[i].state, one.at_separation(separations[i], Quantity::stiffness)));
            CHECK(by_separation[i].state.contact_density.evaluations == 0);
        }
    };
    check(contact);
    check(spheres);
    CHECK(curve_at_pressures(contact, std::array<double, 0>{}).empty());
}

TEST_CASE("A point that the model does not reach leaves the others alone") {
    const auto curve = curve_at_pressures(Short{}, std::vector{1.0, 11.0, 9.0, 2.0});
    REQUIRE(curve.size() == 4);
    CHECK((curve[0].ok() && curve[0].state.stiffness.value == 1));
    CHECK(curve[1].status == PointStatus::out_of_reach);
    CHECK(curve[1].reason == "pressure = 11: must be at most 10");
    CHECK((std::isnan(curve[1].state.stiffness.value) && curve[1].state.pressure.value == 0));
    CHECK((curve[2].status == PointStatus::beyond_numbers && curve[2].reason.empty()));
    CHECK((curve[3].ok() && curve[3].state.stiffness.value == 2));

    const RoughContact contact(fine, peaks, HertzLaw<double>{}, 112.6e9);
    const auto far = curve_at_pressures(contact, std::vector{1e-300, 1e6, 1e200});
    CHECK((far[0].status == PointStatus::out_of_reach && far[1].ok() && far[2].status == PointStatus::out_of_reach));
    CHECK(far[0].reason == test::refusal([&] { (void)contact.at_pressure(1e-300); }));
    const auto apart = curve_at_separations(contact, std::vector{1.0, 1e-6});
    CHECK((apart[0].status == PointStatus::out_of_reach && apart[1].ok()));
    CHECK(apart[0].reason == test::refusal([&] { (void)contact.at_separation(1.0); }));
    // with the interaction as printed, planes that the pressure presses through one another
    const RoughContact printed(fine, peaks, HertzLaw<double>{}, 112.6e9,
                               {.interaction = {InteractionReading::as_printed, 1.0}});
    const auto sunk = curve_at_pressures(printed, std::vector{1e9, 1e5});
    CHECK((sunk[0].status == PointStatus::out_of_reach && sunk[1].ok()));
    CHECK(sunk[0].reason == test::refusal([&] { (void)printed.at_pressure(1e9); }));
    CHECK(sunk[0].reason.starts_with("eta_new = "));
}

TEST_CASE("Invalid pressures and separations are refused before any computation") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const RoughContact contact(fine, peaks, HertzLaw<double>{}, 112.6e9);
    for (const double bad : {0.0, -1.0, nan, inf})
        CHECK(test::refusal([&] {
                  (void)curve_at_pressures(contact, std::vector{1e6, bad});
              }).ends_with("must be finite and greater than 0"));
    CHECK(test::refusal([&] { (void)curve_at_separations(contact, std::vector{nan}); }) ==
          "separation = nan: must be finite (m)");
}

TEST_CASE("A state is in range while twice each of its numbers is") {
    const auto with = [](Estimate<double> ContactState<double>::*which, double value, double error) {
        ContactState<double> state;
        (state.*which).value = value, (state.*which).error = error;
        return detail::in_range(state);
    };
    constexpr double most = std::numeric_limits<double>::max();
    using State = ContactState<double>;
    for (const auto which : {&State::separation, &State::pressure, &State::stiffness, &State::real_area_fraction,
                             &State::contact_density, &State::loading_stiffness}) {
        CHECK((with(which, most / 2, most / 2) && with(which, -most / 2, 0)));
        CHECK((!with(which, most, 0) && !with(which, 0, most) && !with(which, std::nan(""), 0)));
    }
}

}  // namespace contact_curve_test
