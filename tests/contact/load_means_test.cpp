// SPDX-License-Identifier: BSD-3-Clause
// Truth: the last column of tests/data/plastic_curves.csv (9 digits, two quadratures); one radius in one dimension.
#include <fstiff/contact/load_weighted.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/peaks/single_radius.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"
#include "support/table.hpp"

namespace load_means_test {

using namespace fstiff;

TEST_CASE("load-weighted interference of plastic peaks: the nine digits of the table") {
    const test::Table table("plastic_curves.csv");
    const double E = 205e9 / (2 * (1 - 0.09));
    const PlasticMaterial<double> steel{E, 400e6, 0.3, 1.12e9};
    const JacksonGreenLaw<double> jackson_green(steel);  // its omega_c is that of the whole column
    const KogutEtsionLaw<double> kogut_etsion(steel);
    int checked = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
        const std::string law = table.text(row, "law"), name = table.text(row, "surface");
        const auto surface =
            test::paper_surface(name == "electrical_discharge_machined" ? "electrical_discharge" : name);
        const PeakDistribution<double> peaks(table.input(row, "r"), table.input(row, "theta"));
        const double truth = table.input(row, "load_weighted_interference_over_critical");
        const auto check = [&](const auto& of, double critical_over_radius) {
            CAPTURE(name, law, row);
            const RoughContact contact(surface.roughness(), peaks, of, E);
            const double eta = contact.at_pressure(table.input(row, "pressure_Pa")).eta;
            const auto fine = detail::load_means(contact, eta, critical_over_radius, 1e-9).interference;
            CHECK(test::relative_error(fine.value, truth) < 6e-9);
            const auto quick = detail::load_means(contact, eta, critical_over_radius).interference;
            CHECK(std::abs(quick.value - truth) <= quick.error + 6e-9 * truth);
            CHECK(quick.error < 2e-3 * truth);
            ++checked;
        };
        if (row % 3 != 0) continue;
        if (law == "hertz") check(HertzLaw<double>{}, jackson_green.critical(1.0));
        if (law == "plastic") check(PlasticLaw<double>(1.12e9, E), jackson_green.critical(1.0));
        if (law == "jackson_green") check(jackson_green, jackson_green.critical(1.0));
        if (law == "kogut_etsion") check(kogut_etsion, jackson_green.critical(1.0));
    }
    CHECK(checked >= 50);
}

TEST_CASE("load-weighted a/R: peaks of one radius in one dimension, and pi a^2 = 2 pi R omega") {
    // a/R = sqrt(2 omega/R), so that <a/R> = sqrt(2 sigma/R) <e^(3/2)>/<e> with e the excess height of plastic peaks
    const double E = 112.6e9, sigma = 1e-6, R = 30e-6;
    const Roughness<double> surface{.rms_height = sigma, .peak_radius = R, .peak_density = 1e9};
    const RoughContact contact(surface, SingleRadius<double>{Heights::gaussian}, PlasticLaw<double>(1.12e9, E), E);
    for (const double eta : {-0.5, 1.0, 3.0}) {
        const auto mean = [eta](double power) {
            constexpr int n = 200000;  // the rule of midpoints: e^(3/2) is smooth enough for 1e-9
            double sum = 0;
            for (int i = 0; i < n; ++i) {
                const double e = 14.0 * (i + 0.5) / n;
                sum += std::pow(e, power) * std::exp(-(eta + e) * (eta + e) / 2);
            }
            return sum;
        };
        const auto found = detail::load_means(contact, eta, 1e-4, 1e-9);
        CAPTURE(eta);
        CHECK(test::relative_error(found.radius_ratio.value, std::sqrt(2 * sigma / R) * mean(1.5) / mean(1)) < 1e-8);
        CHECK(test::relative_error(found.interference.value, sigma / (1e-4 * R) * mean(2) / mean(1)) < 1e-8);
    }
    CHECK(test::refusal([&] { (void)detail::load_means(contact, 1.0, 0.0); }).find("critical_over_radius") !=
          std::string::npos);
}

TEST_CASE("a law with its own omega_c needs no other") {
    const PlasticMaterial<double> steel{112.6e9, 400e6, 0.3, 1.12e9};
    const KogutEtsionLaw<double> law(steel);
    const RoughContact contact(test::sand_blasted_fine.roughness(), PeakDistribution<double>::exponential(0.8), law,
                               112.6e9);
    const auto own = detail::load_means(contact, 2.0), given = detail::load_means(contact, 2.0, 2 * law.critical(1.0));
    CHECK(test::relative_error(own.interference.value, 2 * given.interference.value) < 1e-14);
    CHECK(own.radius_ratio.value == given.radius_ratio.value);
}

}  // namespace load_means_test
