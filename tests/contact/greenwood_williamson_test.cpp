// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/peaks/single_radius.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"
#include "support/table.hpp"

#include <gsl/gsl_sf_gamma.h>

#include <numbers>

namespace greenwood_williamson_test {

using namespace fstiff;

namespace {
const Roughness<double> fine = test::sand_blasted_fine.roughness();
constexpr double modulus = 112.6e9;
}  // namespace

TEST_CASE("Gaussian height moments: the table to 1e-12, and to the accuracy stated") {
    const test::Table table("gw_gaussian.csv");
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double n = table.input(row, "n"), h = table.input(row, "h");
        const auto truth = static_cast<double>(table.number(row, "value"));
        INFO("n " << n << " h " << h);
        CHECK(test::ulps(detail::height_moment(n, h), truth) <= (n == 2.5 ? 40 : 16));
    }
}

TEST_CASE("exponential height moments are incomplete gamma functions") {
    for (const double n : {0.0, 0.5, 1.0, 1.5, 2.5}) {
        for (const double h : {0.0, 0.5, 3.0, 40.0})
            CHECK(test::ulps(detail::height_moment(n, h, Heights::exponential), std::tgamma(n + 1) * std::exp(-h)) <=
                  20);
        for (const double h : {-1e-3, -0.3, -2.0, -20.0}) {
            INFO("n " << n << " h " << h);
            CHECK(test::relative_error(detail::height_moment(n, h, Heights::exponential),
                                       std::exp(-h) * gsl_sf_gamma_inc(n + 1, -h)) < 1e-13);
        }
    }
    CHECK_FALSE(test::refusal([] { static_cast<void>(detail::height_moment(0.7, 1.0)); }).empty());
    CHECK_FALSE(test::refusal([] {
                    static_cast<void>(detail::height_moment(0.5, std::nan(""), Heights::exponential));
                }).empty());
}

TEST_CASE("exponential heights: K, area and contacts are proportional to pressure") {
    const GreenwoodWilliamson<double> contact(fine, modulus, Heights::exponential);
    const auto low = contact.at_pressure(1e3), high = contact.at_pressure(1e7);
    // K/p = 2 Gamma(3/2)/((4/3) Gamma(5/2) sigma) = 1/sigma
    CHECK(test::relative_error(low.stiffness.value / 1e3, 1 / fine.rms_height) < 1e-12);
    CHECK(test::relative_error(high.stiffness.value / 1e7, 1 / fine.rms_height) < 1e-12);
    CHECK(test::relative_error(high.real_area_fraction.value / low.real_area_fraction.value, 1e4) < 1e-12);
    CHECK(test::relative_error(high.contact_density.value / low.contact_density.value, 1e4) < 1e-12);
}

TEST_CASE("pressure and separation are each other's inverse and K is -dp/dd") {
    for (const Heights heights : {Heights::gaussian, Heights::exponential}) {
        const GreenwoodWilliamson<double> contact(test::sand_blasted_fine.roughness(), 112.6e9, heights);
        for (const double pressure : {1e-100, 1.0, 1e6, 1e9, 1e13}) {
            const auto at = contact.at_pressure(pressure);
            INFO("p " << pressure << " eta " << at.eta);
            const auto back = contact.at_separation(at.separation.value);
            CHECK(test::relative_error(back.pressure.value, pressure) < 2e-14 * (1 + at.eta * at.eta));
            CHECK(at.stiffness.error < 1e-13 * (10 + at.eta * at.eta) * at.stiffness.value);
        }
        const double d = 0.7e-6, h = 1e-10;
        const auto p = [&](double x) { return contact.at_separation(x).pressure.value; };
        const double slope = -(8 * (p(d + h) - p(d - h)) - (p(d + 2 * h) - p(d - 2 * h))) / (12 * h);
        CHECK(test::relative_error(slope, contact.at_separation(d).stiffness.value) < 1e-10);
    }
}

TEST_CASE("quantities that are not requested are 0 and bad input is refused") {
    const GreenwoodWilliamson<double> contact(fine, modulus);
    CHECK(contact.at_pressure(1e6, Quantity::stiffness).real_area_fraction.value == 0);
    CHECK(contact.at_pressure(1e6, Quantity::stiffness).stiffness.value == contact.at_pressure(1e6).stiffness.value);
    CHECK(test::refusal([&] {
              static_cast<void>(contact.at_pressure(1e30));
          }).starts_with("pressure = 1e+30: must be between"));
    CHECK(
        test::refusal([&] { static_cast<void>(contact.at_separation(-1.0)); }).starts_with("separation = -1: must be"));
    CHECK(test::refusal([] { GreenwoodWilliamson<double>(fine, -1); }).starts_with("effective_modulus = -1"));
}

}  // namespace greenwood_williamson_test
