// SPDX-License-Identifier: BSD-3-Clause
// Truth: states written by hand, whose checks can be read off; the formulas of the header, computed here once more.
#include <fstiff/answer/checks.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>

namespace checks_test {

using namespace fstiff;
using test::relative_error;

namespace {

const Roughness<double> fine{.rms_height = 0.832e-6, .peak_radius = 40e-6, .peak_density = 500e6};

ContactState<double> state(double separation, double pressure, double stiffness, double area, double contacts) {
    ContactState<double> s;
    s.separation.value = separation;
    s.pressure.value = pressure;
    s.stiffness = {stiffness, 1e-9 * stiffness, 1};
    s.real_area_fraction.value = area;
    s.contact_density.value = contacts;
    return s;
}

/// Good, and then one that breaks everything.
std::vector<ContactState<double>> states() {
    std::vector<ContactState<double>> all{state(2e-6, 1e6, 1e13, 0.001, 1e7), state(1e-6, 5e6, 4e13, 0.01, 1e8),
                                          state(5e-6, 1e3, 1e10, 1e-6, 1e6), state(-1e-7, 4e9, 1e16, 1.5, 5e8)};
    all[2].stiffness.error = 1e5;
    return all;
}

detail::CurveLimits<double> limits() {
    return {.effective_modulus = 1e11,
            .rms_gradient = 0.1,
            .max_peak_height = 4e-6,
            .nominal_area = 9e-6,
            .yield_strength = 300e6};
}

}  // namespace

TEST_CASE("Each check of a curve has its range, its limit and where it first fails") {
    const auto checks = detail::check_curve<double>(states(), limits());
    struct Expected {
        Concern concern;
        double limit, least, greatest;
        std::size_t violations, first;
    };
    const std::vector<Expected> expected{{Concern::interacting_asperities, 0.01, 1e-7, 0.4, 1, 3},
                                         {Concern::mean_planes_crossed, 0, -1e-7, 5e-6, 1, 3},
                                         {Concern::above_highest_peak, 4e-6, -1e-7, 5e-6, 1, 2},
                                         {Concern::few_contacts, 10, 9, 4500, 1, 2},
                                         {Concern::area_above_nominal, 1, 1e-6, 1.5, 1, 3},
                                         {Concern::above_hardness, 840e6, 500e6, 8e9 / 3, 3, 0},
                                         {Concern::not_converged, 1e-6, 1e-9, 1e-5, 1, 2}};
    REQUIRE(checks.size() == expected.size());
    for (std::size_t i = 0; i < checks.size(); ++i) {
        INFO(name_of(checks[i].concern));
        CHECK((checks[i].concern == expected[i].concern && !checks[i].holds()));
        CHECK(relative_error(checks[i].limit, expected[i].limit) < 1e-15);
        CHECK(relative_error(checks[i].least, expected[i].least) < 1e-15);
        CHECK(relative_error(checks[i].greatest, expected[i].greatest) < 1e-15);
        CHECK((checks[i].violations == expected[i].violations && checks[i].first == expected[i].first));
    }
}

TEST_CASE("A good state raises no concern and unknown values are not checked") {
    const std::vector<ContactState<double>> good{states()[1]};
    for (const auto& check : detail::check_curve<double>(good, limits())) {
        INFO(name_of(check.concern));
        CHECK((check.holds() && check.least == check.greatest));
    }
    const auto few = detail::check_curve<double>(states(), {.effective_modulus = 1e11}, Quantity::pressure);
    REQUIRE(few.size() == 1);
    CHECK(few[0].concern == Concern::mean_planes_crossed);

    // without a yield strength the mean pressure is reported and valid
    const auto checks = detail::check_curve<double>(states(), {.effective_modulus = 1e11});
    const auto* hardness = detail::find_check(checks, Concern::above_hardness);
    REQUIRE(hardness);
    CHECK((hardness->holds() && std::isinf(hardness->limit) && hardness->greatest > 1e9));
    CHECK(detail::find_check(checks, Concern::few_contacts) == nullptr);

    // no state with an area: no pressure on it
    const std::vector<ContactState<double>> apart{state(4e-6, 1, 1, 0, 0)};
    const auto none = detail::check_curve<double>(apart, limits());
    CHECK(detail::find_check(none, Concern::above_hardness)->least >
          detail::find_check(none, Concern::above_hardness)->greatest);
}

TEST_CASE("A stiffness that underflows is not a failure to converge") {
    std::vector<ContactState<double>> tiny{state(4e-6, 1, 0, 0, 0)};
    tiny[0].stiffness.error = std::numeric_limits<double>::denorm_min();
    CHECK(detail::find_check(detail::check_curve<double>(tiny, limits()), Concern::not_converged)->holds());
}

TEST_CASE("The checks of a surface are the plasticity index and the limits of Gaussian surfaces") {
    const auto checks = detail::check_surface(fine, 112.6e9, std::optional(400e6));
    REQUIRE(checks.size() == 2);
    CHECK((checks[0].concern == Concern::plasticity && !checks[0].holds()));
    CHECK(relative_error(checks[0].least, 112.6e9 / (2.8 * 400e6) * std::sqrt(0.832 / 40)) < 1e-15);
    CHECK((checks[1].concern == Concern::gaussian_surface && !checks[1].holds() && checks[1].violations == 1));
    CHECK(relative_error(checks[1].least, 0.832e-6 * 40e-6 * 500e6) < 1e-15);

    Roughness<double> dense = fine;
    dense.peak_density = 1e9;
    const auto only = detail::check_surface(dense, 112.6e9);
    REQUIRE(only.size() == 1);
    CHECK((only[0].concern == Concern::gaussian_surface && only[0].holds()));
    CHECK(detail::check_surface(dense, 1e9, std::optional(400e6))[0].holds());
    CHECK(test::refusal([] {
              (void)detail::check_surface(fine, 1e11, std::optional(0.0));
          }).starts_with("yield_strength = 0"));
}

TEST_CASE("No scale of length or modulus changes what holds") {
    for (const double length : {1e-9, 1e9})
        for (const double modulus : {1e-9, 1e9}) {
            auto all = states();
            for (auto& s : all) {
                s.separation.value *= length;
                s.pressure.value *= modulus;
                s.stiffness = s.stiffness * (modulus / length);
                s.contact_density.value /= length * length;
            }
            detail::CurveLimits<double> scaled = limits();
            scaled.effective_modulus *= modulus;
            *scaled.yield_strength *= modulus;
            scaled.max_peak_height *= length;
            *scaled.nominal_area *= length * length;
            const auto checks = detail::check_curve<double>(all, scaled),
                       before = detail::check_curve<double>(states(), limits());
            REQUIRE(checks.size() == before.size());
            for (std::size_t i = 0; i < checks.size(); ++i)
                CHECK((checks[i].violations == before[i].violations && checks[i].first == before[i].first));
        }
}

TEST_CASE("A surface implies a gradient by R and D_p, and by sigma and R") {
    const auto [of_density, of_height] = detail::implied_gradients(fine, 0.5);
    const double curvature = 3 * std::sqrt(std::numbers::pi) / 8 / 40e-6;
    CHECK(relative_error(of_density, curvature * std::sqrt(2 / (6 * std::numbers::pi * std::sqrt(3.0) * 500e6))) <
          1e-14);
    CHECK(relative_error(of_height, std::sqrt(0.832e-6 * curvature)) < 1e-14);
    CHECK(detail::implied_gradients(fine, 0.0)[1] == of_height);  // r = 0 does not determine the gradient
    CHECK(name_of(Concern::implausible_gradient) == "implausible_gradient");
}

}  // namespace checks_test
