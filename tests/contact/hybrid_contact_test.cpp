// SPDX-License-Identifier: BSD-3-Clause
// Truth: tests/data/hybrid.csv (15 digits); boundary elements of tests/data/bem_maps.csv; the exact spectrum of maps
// that repeat themselves.
#include <fstiff/contact/crossover.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/rough_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/surface/band_spectrum.hpp>
#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/gaussian_order.hpp>
#include <fstiff/topography/map_spectrum.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"
#include "support/table.hpp"

#include <thread>

namespace hybrid_contact_test {

using namespace fstiff;

namespace {

using Hybrid = HybridContact<double, RoughContact<double, HertzLaw<double>>>;

Hybrid hybrid_at(const test::Table& table, std::size_t row) {
    const auto at = [&](const char* column) { return table.input(row, column); };
    const Roughness<double> surface{at("rms_height"), at("peak_radius"), at("peak_density")};
    const SpectralMoments<double> moments{at("m0"), at("m2"), at("m4")};
    const double E = at("effective_modulus");
    return {RoughContact(surface, PeakDistribution<double>(at("r"), at("theta")), HertzLaw<double>{}, E),
            PerssonContact<double>(detail::band_of_moments(moments, at("hurst")), E, 0.45, 0.0)};
}

}  // namespace

TEST_CASE("K of the hybrid law: the table to 1e-11") {
    const test::Table table("hybrid.csv");
    REQUIRE(table.size() == 10);
    for (std::size_t row = 0; row < table.size(); ++row) {
        const Hybrid contact = hybrid_at(table, row);
        const double p = table.input(row, "pressure"), truth = table.input(row, "stiffness_hybrid");
        CAPTURE(row, p);
        const auto state = contact.at_pressure(p);
        CHECK(test::relative_error(contact.stiffness(p), truth) < 1e-11);
        CHECK(std::abs(state.stiffness.value - truth) <= state.stiffness.error);
        CHECK(test::relative_error(contact.peaks().at_pressure(p).stiffness.value,
                                   table.input(row, "stiffness_hertz")) < 1e-11);
        CHECK(test::relative_error(contact.crowded().stiffness(p), table.input(row, "stiffness_persson")) < 1e-11);
    }
}

TEST_CASE("threads may share a hybrid contact, whose separations the first of them tabulates", "[threads]") {
    const Hybrid contact = hybrid_at(test::Table("hybrid.csv"), 0), apart = hybrid_at(test::Table("hybrid.csv"), 0);
    const double p = 2e-3 * apart.crowded().effective_modulus() * apart.crowded().rms_gradient();
    const double truth = apart.at_pressure(p).separation.value;
    std::array<double, 4> separations{};
    std::vector<std::thread> threads;
    for (double& separation : separations)
        threads.emplace_back([&, p] { separation = contact.at_pressure(p).separation.value; });
    for (std::thread& thread : threads) thread.join();
    for (const double separation : separations) CHECK(separation == truth);
}

TEST_CASE("the separation of the hybrid law is the integral of 1/K, and is undone") {
    const test::Table table("hybrid.csv");
    for (const std::size_t row : {std::size_t(0), std::size_t(4), std::size_t(7)}) {
        const Hybrid contact = hybrid_at(table, row);
        const double full = 2 * contact.crowded().effective_modulus() * contact.crowded().rms_gradient();
        for (const double p : {full * 1e-11, full * 1e-6, full * 1e-3, full * 0.2, full * 0.99}) {
            // Simpson's rule in ln p in 4000 steps
            const double from = std::log(p), to = std::log(full), step = (to - from) / 4000;
            double sum = 0;
            for (int i = 0; i <= 4000; ++i) {
                const double x = std::exp(from + i * step);
                sum += (i == 0 || i == 4000 ? 1 : i % 2 == 1 ? 4 : 2) * x / contact.stiffness(x);
            }
            const double d = sum * step / 3;
            const auto found = contact.separation(p);
            CAPTURE(row, p);
            CHECK(std::abs(found.value - d) < 1e-11 * contact.rms_height() + found.error);
            CHECK(found.error < 1e-9 * contact.rms_height());
            const auto back = contact.log_pressure(found.value / contact.rms_height());
            CHECK(std::abs(back.log - std::log(p)) <= back.error);
            CHECK(std::abs(back.log - std::log(p)) < 1e-9);
            if (p > contact.crowded().gaussian().largest_compared_pressure()) continue;
            CHECK(contact.at_pressure(p).separation.value == found.value);
            CHECK(test::relative_error(contact.at_separation(found.value).pressure.value, p) < 1e-9);
        }
        CHECK(contact.separation(1.5 * full).value == 0);
        const std::string refusal = test::refusal([&] { (void)contact.at_pressure(0.376 * full); });
        CHECK(refusal.find("the bulk carries") != std::string::npos);
    }
}

TEST_CASE("hybrid of a map's own summits and bearing curve is near boundary elements of other code") {
    const test::Table bem("bem_maps.csv");
    double least = 2, largest = 0;
    for (std::size_t row = 0; row < bem.size(); ++row) {
        const HeightMap<double> map = test::half_space_map(bem.text(row, "map"));
        const detail::GaussianOrder<double> order = detail::gaussian_order(map);
        const MaterialRatioContact<double> crowded(
            PerssonContact<double>(map_spectrum(order.map, Edges::periodic), 1.0), order.curve, order.rms_height);
        const Summits<double> summits = summits_of(map);
        const HybridContact hybrid(SummitContact<double>(summits, 1.0), crowded,
                                   detail::hand_over_of(summits, crowded, Edges::periodic));
        const double ratio = hybrid.stiffness(bem.input(row, "p_over_E")) / bem.input(row, "stiffness_times_L_over_E");
        CAPTURE(bem.text(row, "map"), bem.input(row, "p_star"), ratio);
        CHECK(std::abs(ratio - 1) < 0.1);
        least = std::min(least, ratio), largest = std::max(largest, ratio);
    }
    CAPTURE(least, largest);
    CHECK(largest / least < 1.2);
}

TEST_CASE(
    "A hand-over is continuous, fades out over a factor of 8, and keeps its ratios on surfaces drawn about a map") {
    const HeightMap<double> map = test::half_space_map("gaussian");
    const MaterialRatioContact<double> crowded(PerssonContact<double>(map_spectrum(map, Edges::periodic), 1.0));
    const Summits<double> summits = summits_of(map);
    const SummitContact<double> peaks(summits, 1.0);
    const Crossover<double> join = detail::hand_over_of(summits, crowded, Edges::periodic);
    const HybridContact hybrid(peaks, crowded, join);
    const double p = join.pressure();
    CHECK(test::relative_error(crowded.at_pressure(p).real_area_fraction.value, 0.06) < 0.02);
    const detail::MutualSummits<double> mutual(summits, 1.0, Edges::periodic);
    for (const double part : {1.0, 0.5, 0.25})  // at its own pressures the table is what it was made of
        CHECK(test::relative_error(hybrid.stiffness(part * p), mutual.at_pressure(part * p).stiffness.value) < 1e-5);
    CHECK(test::relative_error(hybrid.stiffness(0.7 * p), mutual.at_pressure(0.7 * p).stiffness.value) < 0.02);
    CHECK(test::relative_error(hybrid.stiffness(p * (1 + 1e-9)), hybrid.stiffness(p * (1 - 1e-9))) < 1e-6);
    CHECK(test::relative_error(hybrid.stiffness(8.001 * p), crowded.stiffness(8.001 * p)) < 1e-14);
    double last = 0;
    for (double x = 1e-3 * p; x < 20 * p; x *= 1.05) {
        CHECK(hybrid.stiffness(x) > last);
        last = hybrid.stiffness(x);
    }
    // twice as high, everything is the same under twice the pressure
    Summits<double> high = summits;
    high.rms_height *= 2;
    for (Summit<double>& one : high.summits) one.height *= 2, one.max_curvature *= 2, one.min_curvature *= 2;
    const SummitContact<double> high_peaks(high, 1.0);
    const HybridContact taller(high_peaks, crowded.scaled(2), join.scaled(high_peaks, 2));
    for (const double x : {0.1 * p, p, 3 * p})
        CHECK(test::relative_error(taller.stiffness(2 * x), hybrid.stiffness(x)) < 1e-9);
}

TEST_CASE("Mirror images change K of persson of maps that repeat themselves as little as docs/scene.md states") {
    const auto rms = [](double longest, std::initializer_list<double> hursts) {
        double squares = 0;
        int points = 0;
        for (const double hurst : hursts)
            for (const std::uint64_t seed : {1u, 2u}) {
                const auto map = self_affine_map<double>({.hurst = hurst,
                                                          .rms = 1e-3,
                                                          .longest_wavelength = longest,
                                                          .shortest_wavelength = 1.0 / 32,
                                                          .seed = seed},
                                                         256, 256, 1.0 / 256, 1.0 / 256);
                const auto exact = map_spectrum(map, Edges::periodic);
                const PerssonContact<double> mirrored(map_spectrum(map), 1.0), repeated(exact, 1.0);
                for (const double p_star : {0.01, 0.03, 0.1, 0.25}) {
                    const double p = p_star * exact.rms_gradient();
                    squares += std::pow(std::log(mirrored.stiffness(p) / repeated.stiffness(p)), 2);
                    ++points;
                }
            }
        return std::sqrt(squares / points);
    };
    CHECK(std::abs(rms(1.0 / 16, {0.8}) - 0.004) < 0.0005);
    CHECK(std::abs(rms(1.0 / 8, {0.8, 0.5}) - 0.007) < 0.0005);
    CHECK(std::abs(rms(1.0 / 4, {0.8, 0.5, 0.3}) - 0.018) < 0.0005);
    CHECK(std::abs(rms(1.0 / 2, {0.8}) - 0.08) < 0.005);
}

TEST_CASE("Persson's and the hybrid contact are tabulated like any other") {
    const test::Table table("hybrid.csv");
    const Hybrid hybrid = hybrid_at(table, 0);
    const auto check = [](const auto& contact, double low, double high) {
        const auto law = ContactLaw<double>::tabulate(contact, {.min_pressure = low, .max_pressure = high});
        for (const double share : {0.01, 0.3, 0.5, 0.77, 0.99}) {
            const double p = low * std::pow(high / low, share);
            const auto truth = contact.at_pressure(p);
            CAPTURE(p, law.relative_error());
            // the stated error of the table, and that of the separation, which is an integral of 1/K
            CHECK(test::relative_error(law.stiffness(p), truth.stiffness.value) < law.relative_error() + 1e-9);
            CHECK(std::abs(law.separation(p) - truth.separation.value) < 1e-9 * contact.rms_height());
        }
        CHECK(law.relative_error() < 1e-7);
    };
    check(hybrid.crowded(), 1e-5, 0.02);
    check(hybrid, 1e-5, 0.02);
}

}  // namespace hybrid_contact_test
