// SPDX-License-Identifier: BSD-3-Clause
// Truth: tests/data/persson.csv (20 digits, two variables of integration) and persson_shells.csv.
#include <fstiff/contact/persson_contact.hpp>
#include <fstiff/surface/band_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/table.hpp"

#include <map>

namespace persson_contact_test {

using namespace fstiff;

namespace {

BandSpectrum<double> band_at(const test::Table& table, std::size_t row) {
    const auto at = [&](const char* column) { return table.input(row, column); };
    return {at("C0"), at("hurst"), at("q1"), at("q_rolloff"), at("q2")};
}

}  // namespace

TEST_CASE("K of a band: the table to 1e-13") {
    const test::Table table("persson.csv");
    REQUIRE(table.size() > 40);
    for (std::size_t row = 0; row < table.size(); ++row) {
        const double gamma = table.input(row, "gamma"), p = table.input(row, "p_over_E");
        const PerssonContact<double> contact(band_at(table, row), 1.0, gamma, 0.0);
        CAPTURE(row, p);
        const double truth = table.input(row, "stiffness_over_E");
        CHECK(test::relative_error(contact.stiffness(p), truth) < 1e-13);
        CHECK(test::relative_error(contact.light_load_length(), table.input(row, "light_load_length")) < 1e-13);
        CHECK(test::relative_error(contact.real_area_fraction(p), table.input(row, "area_fraction")) < 1e-13);
        if (p <= contact.largest_compared_pressure()) {
            const auto state = contact.at_pressure(p);
            CHECK(state.stiffness.value == contact.stiffness(p));
            CHECK(std::abs(state.stiffness.value - truth) <= state.stiffness.error);
            CHECK(state.real_area_fraction.value == contact.real_area_fraction(p));
        }
        if (!table.text(row, "separation").empty()) {
            const double d = table.input(row, "separation");  // 15 digits
            CHECK(test::relative_error(contact.separation(p).value, d) < 1e-13);
            CHECK(std::abs(contact.separation(p).value - d) <= contact.separation(p).error + 1e-14 * d);
        }
    }
}

TEST_CASE("K and separation with the share of P^16: the table of another variable of integration to 1e-13") {
    const test::Table table("persson_closing.csv");
    REQUIRE(table.size() == 30);
    for (std::size_t row = 0; row < table.size(); ++row) {
        const auto at = [&](const char* column) { return table.input(row, column); };
        const PerssonContact<double> contact(band_at(table, row), 1.0, at("gamma"), at("closing"));
        const double p = at("p_over_E"), above = p * (1 + 1e-4), below = p * (1 - 1e-4);
        CAPTURE(row, p);
        const auto K = contact.stiffness_and_slope(p);
        CHECK(test::relative_error(contact.stiffness(p), at("stiffness_over_E")) < 1e-13);
        CHECK(K.stiffness == contact.stiffness(p));
        const double difference = (contact.stiffness(above) - contact.stiffness(below)) / (above - below);
        CHECK(test::relative_error(difference, K.slope) < 1e-6);
        if (!table.text(row, "separation").empty())
            CHECK(test::relative_error(contact.separation(p).value, at("separation")) < 1e-13);
    }
}

TEST_CASE("the energy at full contact is exact, whatever gamma and the share of P^16") {
    // int p dd = int p/K dp = (pi E/2) int q^2 C dq, here by Simpson's rule in p up to 4 E g
    const BandSpectrum<double> band{1, 0.8, 8, 8, 64};
    const double full = std::numbers::pi_v<double> / 2 * band.integral(2);
    for (const auto& [gamma, closing] : {std::pair(0.45, 0.25), {0.45, 0.0}, {0.7, 1.0}, {1.0, 0.5}}) {
        const PerssonContact<double> contact(band, 1.0, gamma, closing);
        const int steps = 4000;
        const double step = 4 * contact.rms_gradient() / steps;
        double sum = 0;
        for (int i = 1; i <= steps; ++i)
            sum += (i == steps ? 1 : i % 2 == 1 ? 4 : 2) * i * step / contact.stiffness(i * step);
        CAPTURE(gamma, closing);
        // p/K is u0 at p = 0
        CHECK(test::relative_error((sum + contact.light_load_length()) * step / 3, full) < 1e-9);
    }
}

TEST_CASE("K of shells: the table to 1e-12") {
    const test::Table table("persson_shells.csv");
    std::map<std::string, SpectrumShells<double>> spectra;
    int checked = 0;
    for (std::size_t row = 0; row < table.size(); ++row) {
        SpectrumShells<double>& spectrum = spectra[table.text(row, "spectrum")];
        spectrum.rms_height = 1;
        if (table.text(row, "row") == "shell") {
            spectrum.shells.push_back({table.input(row, "sum_q2_h2"), table.input(row, "sum_q_h2")});
        } else {
            const PerssonContact<double> contact(spectrum, 1.0, 0.45, 0.0);
            const double p = table.input(row, "p_over_E");
            CAPTURE(p);
            CHECK(test::relative_error(contact.stiffness(p), table.input(row, "stiffness_over_E")) < 1e-12);
            ++checked;
        }
    }
    CHECK(checked == 10);
}

TEST_CASE("K is -dp/dd, dK/dp the difference of K, and p of d the inverse of d of p") {
    const BandSpectrum<double> band{1, 0.8, 8, 8, 64};
    const PerssonContact<double> contact(band, 1.0);
    for (const double share : {1e-8, 1e-4, 0.01, 0.3, 0.6, 1.0, 3.0, 12.0}) {
        const double p = share * contact.rms_gradient(), h = 1e-5 * p / std::max(1.0, share * share);
        CAPTURE(share);
        const auto K = contact.stiffness_and_slope(p);
        CHECK(K.stiffness == contact.stiffness(p));
        // central differences of h = 1e-5: 1e-10 by truncation, 1e-11 by rounding of d over its change
        const double dd = contact.separation(p - h).value - contact.separation(p + h).value;
        CHECK(test::relative_error(dd / (2 * h) * K.stiffness, 1.0) < 1e-6);
        CHECK(test::relative_error((contact.stiffness(p + h) - contact.stiffness(p - h)) / (2 * h), K.slope) < 1e-6);
        const auto back = contact.log_pressure(contact.separation(p).value / contact.rms_height());
        CHECK(test::relative_error(std::exp(back.log), p) < 1e-11);
        if (share > 0.75) continue;
        const auto state = contact.at_separation(contact.separation(p).value);
        CHECK(std::abs(state.pressure.value - p) <= state.pressure.error);
    }
}

TEST_CASE("Persson's law does not depend on the units, and E enters as p/E alone") {
    const BandSpectrum<double> band{1, 0.7, 8, 16, 64};
    const double unit = 1e-6;  // lengths, so that C0 grows by unit^(2-2H)
    const BandSpectrum<double> metric{std::pow(unit, 2 - 2 * 0.7), 0.7, 8 / unit, 16 / unit, 64 / unit};
    const PerssonContact<double> one(band, 1.0), other(metric, 2e11);
    for (const double p : {1e-5, 0.02, 0.5, 3.0}) {
        CHECK(test::relative_error(other.stiffness(p * 2e11), one.stiffness(p) * 2e11 / unit) < 1e-13);
        CHECK(test::relative_error(other.separation(p * 2e11).value, one.separation(p).value * unit) < 1e-12);
    }
}

TEST_CASE("float is the rounding of double") {
    const PerssonContact<float> contact(BandSpectrum<float>{1, 0.8F, 8, 8, 64}, 1.0F);
    const PerssonContact<double> exact(BandSpectrum<double>{1, static_cast<double>(0.8F), 8, 8, 64}, 1.0,
                                       static_cast<double>(0.45F));
    for (const float p : {1e-4F, 0.1F, 2.0F})
        CHECK(test::relative_error(static_cast<double>(contact.stiffness(p)), exact.stiffness(double(p))) < 2e-7);
}

TEST_CASE("arguments that Persson's law does not allow are refused") {
    const BandSpectrum<double> band{1, 0.8, 8, 8, 64};
    for (const double gamma : {0.0, -1.0, 1.1, std::nan("")})
        CHECK(test::refusal([&] { PerssonContact<double>(band, 1.0, gamma); }).find("gamma") == 0);
    CHECK(test::refusal([&] { PerssonContact<double>(band, 0.0); }).find("effective_modulus") == 0);
    const PerssonContact<double> contact(band, 1.0);
    for (const double closing : {-0.1, 1.1, std::nan("")})
        CHECK(test::refusal([&] { PerssonContact<double>(band, 1.0, 0.45, closing); }).find("closing") == 0);
    const double most = contact.largest_compared_pressure();
    CHECK(contact.at_pressure(most).real_area_fraction.value > 0.86);
    const std::string refusal = test::refusal([&] { (void)contact.at_pressure(1.001 * most); });
    CHECK(refusal.find("the bulk carries") != std::string::npos);
    const double beyond = contact.separation(1.01 * most).value;
    CHECK(test::refusal([&] { (void)contact.at_separation(beyond); }).find("pressure") == 0);
    CHECK(contact.point_at_pressure(1.001 * most).status == PointStatus::out_of_reach);
    for (const double p : {0.0, -1.0, std::nan(""), 19 * contact.rms_gradient()})
        CHECK(test::refusal([&] { (void)contact.stiffness(p); }).find("pressure") == 0);
    for (const double p : {0.0, -1.0, std::nan(""), 19 * contact.rms_gradient()})
        CHECK(test::refusal([&] { (void)contact.at_pressure(p); }).find("pressure") == 0);
    for (const double eta : {0.0, -1.0, std::nan(""), 1e9})
        CHECK(test::refusal([&] { (void)contact.log_pressure(eta); }).find("eta") == 0);
}

}  // namespace persson_contact_test
