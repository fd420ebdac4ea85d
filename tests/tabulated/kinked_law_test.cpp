// SPDX-License-Identifier: BSD-3-Clause
// Truth: the contacts themselves at random pressures; differences of p(d); sums over a few summits in closed form.
#include <fstiff/contact/contact.hpp>
#include <fstiff/contact/crossover.hpp>
#include <fstiff/contact/hybrid_contact.hpp>
#include <fstiff/contact/mutual_summits.hpp>
#include <fstiff/contact/plastic_contact.hpp>
#include <fstiff/contact/summit_contact.hpp>
#include <fstiff/tabulated/contact_law.hpp>
#include <fstiff/topography/gaussian_map_filter.hpp>
#include <fstiff/topography/gaussian_order.hpp>
#include <fstiff/topography/map_spectrum.hpp>
#include <fstiff/topography/summits.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace kinked_law_test {

using namespace fstiff;
using Law = ContactLaw<double>;

/// A periodic map of 64 x 64 points: waves of random directions and phases.
HeightMap<double> random_map(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
    HeightMap<double> map;
    map.dx = map.dy = 1.0 / 64;
    map.heights = decltype(map.heights)::Zero(64, 64);
    for (int a = -8; a <= 8; ++a)
        for (int b = 0; b <= 8; ++b) {
            const double q = std::hypot(a, b), at = phase(random);
            if (q < 2 || q > 8) continue;
            for (Eigen::Index i = 0; i < 64; ++i)
                for (Eigen::Index j = 0; j < 64; ++j)
                    map.heights(i, j) += std::pow(q, -1.8) *
                                         std::cos(2 * std::numbers::pi * static_cast<double>(a * i + b * j) / 64 + at);
        }
    map.heights *= 0.1 / map_spectrum(map, Edges::periodic).rms_gradient();
    return map;
}

/// All laws of one map, E = 1; g is its rms gradient.
struct Laws {
    HeightMap<double> map;
    double g = map_spectrum(map, Edges::periodic).rms_gradient();
    detail::GaussianOrder<double> order = detail::gaussian_order(map);
    MaterialRatioContact<double> crowded{PerssonContact<double>(map_spectrum(order.map, Edges::periodic), 1.0),
                                         order.curve, order.rms_height};
    Summits<double> summits = summits_of(map);
    SummitContact<double> alone{summits, 1.0};
    detail::MutualSummits<double> mutual{summits, 1.0, Edges::periodic};
    HybridContact<double, SummitContact<double>, Crossover<double>> hybrid{
        alone, crowded, detail::hand_over_of(summits, crowded, Edges::periodic)};
    PlasticContact<double, decltype(hybrid), detail::MapCut<double>> plastic{
        hybrid, detail::MapCut<double>(map, 1.0, Edges::periodic), 0.1 * g};
};

/// The law of \p contact against it at \p points random pressures, and its own p(d), -dp/dd and K(p) against each
/// other.
template <class C>
void check(const C& contact, double low, double high, int points) {
    const Law law = Law::tabulate(contact, {low, high});
    CHECK(law.relative_error() <= 1e-3);
    const auto [closest, furthest] = law.separations();
    std::mt19937 random(7);
    std::uniform_real_distribution<double> uniform;
    for (int i = 0; i < points; ++i) {
        const double p = low * std::pow(high / low, uniform(random));
        const auto truth = contact.at_pressure(p, Quantity::stiffness | Quantity::separation);
        const double d = std::clamp(truth.separation.value, closest, furthest);
        CAPTURE(p, law.relative_error());
        CHECK(test::relative_error(law.stiffness(p), truth.stiffness.value) < 1e-3);
        CHECK(test::relative_error(law.at_separation(d).pressure, p) < 1e-3);
        CHECK(std::abs(law.separation(p) - d) < 1e-3 * contact.rms_height());

        const double own = law.separation(p), step = 1e-7 * (furthest - closest);
        const auto tangent = law.tangent_at_separation(own);
        CHECK(test::relative_error(tangent.pressure, p) < 1e-12);
        if (detail::ProportionalContact<C, double>)
            CHECK(test::relative_error(tangent.slope, law.stiffness(p)) < 1e-12);
        if (own - step < closest || own + step > furthest) continue;
        const double fall = law.pressure_at_separation(own - step) - law.pressure_at_separation(own + step);
        CHECK(test::relative_error(tangent.slope, fall / (2 * step)) < 1e-4);
    }
    bool p_falls = true, k_rises = true;
    double last_p = law.pressure_at_separation(closest), last_k = law.stiffness(low);
    for (int i = 1; i <= 5000; ++i) {
        const double d = std::min(closest + (furthest - closest) * i / 5000, furthest);
        const double p = law.pressure_at_separation(d);
        const double k = law.stiffness(std::min(low * std::pow(high / low, i / 5000.0), high));
        p_falls = p_falls && p < last_p, k_rises = k_rises && k >= last_k;
        last_p = p, last_k = k;
    }
    CHECK(p_falls);
    CHECK(k_rises);
}

TEST_CASE("every law of a map is tabulated to 1e-3, one way, and with its own slope") {
    for (const unsigned seed : {1U, 2U}) {
        const Laws laws{random_map(seed)};
        const double g = laws.g;
        CAPTURE(seed);
        check(laws.alone, 1e-4 * g, 0.05 * g, 300);
        check(laws.crowded, 1e-3 * g, 0.2 * g, 100);
        check(laws.hybrid, 1e-4 * g, 0.2 * g, 300);
        check(laws.hybrid, 2e-3 * g, 2.2e-3 * g, 50);
        check(laws.mutual, 1e-4 * g, 3e-3 * g, 30);
        check(laws.plastic, 3e-4 * g, 1e-2 * g, 50);
    }
}

TEST_CASE("three summits: the table against sums over them, where one after the other touches") {
    const Summits<double> three{
        {{3e-6, 1e5, 1e5, 0, 0}, {2e-6, 1e5, 1e5, 0, 0}, {1e-6, 1e5, 1e5, 0, 0}}, 1e-8, 1e-4, 1e-4, 1e-6};
    const SummitContact<double> contact(three, 1e11);
    const auto sum = [](double d, double power, double factor) {
        double all = 0;
        for (const double z : {3e-6, 2e-6, 1e-6}) all += std::pow(std::max(z - d, 0.0), power);
        return factor * 1e11 / std::sqrt(1e5) * all / 1e-8;
    };
    const Law law = Law::tabulate(contact, {sum(2.9e-6, 1.5, 4.0 / 3), sum(0.1e-6, 1.5, 4.0 / 3)});
    CHECK(law.relative_error() <= 1e-3);
    for (const double d : {2.8e-6, 2.1e-6, 1.9999e-6, 1.99e-6, 1.5e-6, 1.01e-6, 0.9999e-6, 0.99e-6, 0.5e-6}) {
        CAPTURE(d);
        CHECK(test::relative_error(law.pressure_at_separation(d), sum(d, 1.5, 4.0 / 3)) < 1e-3);
        CHECK(test::relative_error(law.stiffness_at_separation(d), sum(d, 0.5, 2)) < 1e-3);
        CHECK(test::relative_error(law.stiffness(sum(d, 1.5, 4.0 / 3)), sum(d, 0.5, 2)) < 1e-3);
    }
}

TEST_CASE("a law with kinks: text, policies, arrays, float") {
    const Laws laws{random_map(3)};
    const double low = 1e-4 * laws.g, high = 0.1 * laws.g;
    for (const OutsideRange outside : {OutsideRange::refuse, OutsideRange::clamp, OutsideRange::extrapolate}) {
        const Law law = Law::tabulate(laws.hybrid, {low, high, outside});
        const std::string text = law.to_text();
        CHECK(text.starts_with("fstiff contact law 5 8\n"));
        CHECK(Law::from_text(text) == law);
        CHECK(Law::from_text(text).stiffness(3 * low) == law.stiffness(3 * low));
        CHECK_THROWS_AS(Law::from_text(text + "0"), domain_error);
        CHECK_THROWS_AS(Law::from_text(text.substr(0, text.size() / 2)), domain_error);
    }
    const Law open = Law::tabulate(laws.hybrid, {low, high, OutsideRange::extrapolate});
    const auto [closest, furthest] = open.separations();
    for (const double end : {closest, furthest}) {
        const double step = 1e-9 * (furthest - closest);
        CHECK(test::relative_error(open.pressure_at_separation(end - step), open.pressure_at_separation(end + step)) <
              1e-6);
        CHECK(test::relative_error(open.slope_at_separation(end - step), open.slope_at_separation(end + step)) < 1e-5);
    }
    CHECK(open.stiffness(0) == 0);
    CHECK(open.stiffness(2 * high) > open.stiffness(high));
    CHECK(test::relative_error(open.pressure_at_separation(open.separation(2 * high)), 2 * high) < 1e-12);
    const Law clamped = open.with(OutsideRange::clamp);
    CHECK(clamped.stiffness(2 * high) == open.stiffness(high));
    CHECK(clamped.slope_at_separation(closest - 1) == 0);
    CHECK_THROWS_AS(open.with(OutsideRange::refuse).stiffness(2 * high), domain_error);
    CHECK_THROWS_AS(open.stiffness(std::nan("")), domain_error);
    const Law exact = Law::tabulate(laws.hybrid, {low, high, OutsideRange::exact});
    CHECK(exact.stiffness(low / 2) == laws.hybrid.stiffness(low / 2));

    const Eigen::ArrayXd pressures = Eigen::ArrayXd::LinSpaced(7, low, high);
    Eigen::ArrayXd k(7), p(7), slope(7);
    open.stiffness(pressures, k);
    for (Eigen::Index i = 0; i < 7; ++i) CHECK(k[i] == open.stiffness(pressures[i]));
    const Eigen::ArrayXd separations = Eigen::ArrayXd::LinSpaced(7, closest, furthest);
    open.tangent_at_separation(separations, p, slope);
    for (Eigen::Index i = 0; i < 7; ++i) {
        CHECK(p[i] == open.pressure_at_separation(separations[i]));
        CHECK(slope[i] == open.slope_at_separation(separations[i]));
    }
}

TEST_CASE("a law that is known at pressures alone, with a K of its own") {
    // p = p0 exp(-d/l), K twice its slope
    const double p0 = 1e8, l = 1e-6;
    const auto at = [&](double p) { return detail::LawPoint<double>{l * std::log(p0 / p), 2 * p / l}; };
    const Law law = Law::tabulate_points(at, l, {1e5, 1e7});
    CHECK(law.relative_error() < 1e-3);
    CHECK(!law.stiffness_is_slope());
    for (const double p : {1e5, 1.7e5, 2.345e6, 9.99e6}) {
        const auto tangent = law.tangent_at_separation(law.separation(p));
        CHECK(test::relative_error(law.stiffness(p), 2 * p / l) < law.relative_error());
        CHECK(std::abs(law.separation(p) - l * std::log(p0 / p)) < law.relative_error() * l);
        CHECK(test::relative_error(tangent.slope, p / l) < 0.01);
    }
    CHECK_THROWS_AS(Law::tabulate_points(at, l, {1e5, 1e7, OutsideRange::exact}), domain_error);
    CHECK_THROWS_AS(Law::tabulate_points(
                        [&](double p) {
                            return detail::LawPoint<double>{p, p};
                        },
                        l, {1e5, 1e7}),
                    domain_error);
    CHECK_THROWS_AS(Law::tabulate_points(
                        [&](double p) {
                            return detail::LawPoint<double>{1 / p, -p};
                        },
                        l, {1e5, 1e7}),
                    domain_error);
}

}  // namespace kinked_law_test
