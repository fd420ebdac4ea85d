// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/contact/greenwood_williamson.hpp>
#include <fstiff/tabulated/law_after.hpp>
#include <fstiff/tabulated/tangential_law.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/paper.hpp"
#include "support/table.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace law_after_test {

using namespace fstiff;

namespace {

using Law = ContactLaw<double>;
constexpr double modulus = 115e9, hardness = 2e9;

/// Yielded peaks as a law: K of unloading rises as p^0.93, and is 1.6 times -dp/dd of loading.
Law first_loading(OutsideRange outside = OutsideRange::extrapolate) {
    constexpr double at_1_MPa = 2e12, steeper = 1.6, power = 0.93;
    return Law::tabulate_points(
        [](double p) {
            const double x = p / 1e6;
            return detail::LawPoint<double>{-steeper * 1e6 * std::pow(x, 1 - power) / ((1 - power) * at_1_MPa),
                                            at_1_MPa * std::pow(x, power)};
        },
        1e-6, {1e4, 1e8, outside}, 0.0);
}

/// ln y over ln x by straight lines.
double between(const std::map<double, double>& points, double x) {
    auto after = points.lower_bound(x);
    if (after == points.begin()) ++after;
    if (after == points.end()) --after;
    const auto before = std::prev(after);
    const double t = std::log(x / before->first) / std::log(after->first / before->first);
    return std::exp(std::lerp(std::log(before->second), std::log(after->second), t));
}

/// The approach from 1 to \p x of K = \p points, by the same lines.
double approach(const std::map<double, double>& points, double x) {
    constexpr int parts = 2000;
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        const double p = std::exp(std::log(x) * (i + 0.5) / parts);
        sum -= p / between(points, p) * std::log(x) / parts;
    }
    return sum;
}

}  // namespace

// Truth: tests/data/earlier_load.csv, boundary elements of three maps loaded, flowed and solved again.
TEST_CASE("law after a load: the approach to it is within 15 % of that of boundary elements at most points") {
    const test::Table table("earlier_load.csv");
    struct Curves {
        std::map<double, double> first, after;
    };
    std::map<std::tuple<std::string, double, double>, Curves> groups;
    for (std::size_t k = 0; k < table.size(); ++k) {
        const double h = table.input(k, "hardness_over_Eg"), x = table.input(k, "p_over_greatest");
        Curves& curves = groups[{table.text(k, "seed"), h, table.input(k, "greatest_p_over_H")}];
        curves.first[x] = table.input(k, "stiffness_of_first_loading_over_at_greatest");
        curves.after[x] = table.input(k, "stiffness_over_stiffness_at_greatest");
    }
    int within = 0, all = 0;
    for (const auto& [key, curves] : groups) {
        const double least = curves.first.begin()->first;
        const Law loading = Law::tabulate_points(
            [&, &first = curves.first](double x) {
                return detail::LawPoint<double>{1.5 * approach(first, x), between(first, x)};
            },
            1, {least, 1}, 0.0);
        const Law law = law_after(loading, 1, std::get<1>(key));
        for (const auto& [x, K] : curves.after) {
            if (x == 1) continue;
            const double truth = approach(curves.after, x), found = law.separation(x) - law.separation(1);
            ++all, within += std::abs(found / truth - 1) < 0.15;
            CAPTURE(std::get<0>(key), std::get<1>(key), std::get<2>(key), x, found, truth);
            CHECK(std::abs(found / truth - 1) < 0.4);
        }
    }
    CAPTURE(within, all);
    CHECK(within >= 0.85 * all);
}

TEST_CASE("law after a load: it meets the first loading there, and is stiffer below") {
    const Law loading = first_loading();
    for (const double greatest : {1e5, 3e6, 2e7, 1e8}) {
        const Law law = law_after(loading, greatest, 0.1);
        CAPTURE(greatest);
        CHECK(law.stiffness_is_slope());
        CHECK(law.pressures() == loading.pressures());
        CHECK(std::abs(law.separation(greatest) - loading.separation(greatest)) < 1e-14);
        for (const double share : {1.2, 2.0, 4.0}) {  // along the first loading
            if (share * greatest > 1e8) continue;
            const double d = loading.separation(share * greatest);
            CHECK(test::relative_error(law.pressure_at_separation(d), share * greatest) < 5e-4);
            const double slope = 2e12 * std::pow(share * greatest / 1e6, 0.93) / 1.6;
            CHECK(test::relative_error(law.slope_at_separation(d), slope) < 5e-3);  // of parabolas through its p
        }
        for (const double share : {0.999, 0.5, 0.2}) {
            const double p = share * greatest;
            if (p < 1e4) continue;
            CHECK(law.separation(p) < loading.separation(p));
            const double expected =
                loading.stiffness(greatest) *
                detail::stiffness_after_load(loading.stiffness(p) / loading.stiffness(greatest), 0.1);
            CHECK(test::relative_error(law.stiffness(p), expected) < law.relative_error());
        }
    }
}

TEST_CASE("law after a load: it is reversible, with the slope of its pressure") {
    const Law law = law_after(first_loading(), 2e7, 0.1);
    const auto fall = [&](double from, double to) {  // of the energy, by Simpson's rule within each of many pieces
        constexpr int parts = 4096;
        double sum = 0;
        const double h = (to - from) / parts;
        for (int i = 0; i < parts; ++i)
            sum += h / 6 *
                   (law.pressure_at_separation(from + i * h) + 4 * law.pressure_at_separation(from + (i + 0.5) * h) +
                    law.pressure_at_separation(from + (i + 1) * h));
        return sum;
    };
    for (const auto& [low, high] : {std::pair{1e6, 1.9e7}, std::pair{1e5, 1e6}, std::pair{1e7, 6e7}}) {
        const double d = law.separation(low), closer = law.separation(high);
        CHECK(test::relative_error(law.energy(closer) - law.energy(d), fall(closer, d)) < 1e-8);
        // there and back
        CHECK(std::abs((law.energy(closer) - law.energy(d)) + (law.energy(d) - law.energy(closer))) < 1e-12);
    }
    for (double p = 2e4; p < 9e7; p *= 1.37) {
        const double d = law.separation(p), slope = law.slope_at_separation(d);
        double least = 1;
        for (const double share : {1e-3, 1e-4, 1e-5}) {
            const double h = share * p / slope;
            const double difference = (law.pressure_at_separation(d - h) - law.pressure_at_separation(d + h)) / (2 * h);
            least = std::min(least, std::abs(difference / slope - 1));
        }
        CAPTURE(p);
        CHECK(least < 1e-10);
    }
    CHECK(Law::from_text(law.to_text()) == law);
}

TEST_CASE("law after a load: friction takes it") {
    const Law law = law_after(first_loading(), 2e7, 0.1);
    const TangentialLaw<double> rough(law, 0.2, 0.82);
    const double d = law.separation(1.5e7), s = 0.1 * 0.2 * 1.5e7 / (0.82 * law.stiffness(1.5e7));
    SlipState<double, 2> state{.separation = d};
    double lost = 0, last = 0, at = 0;
    const auto go_to = [&](double to) {  // the work of a straight step: by a rule that the law is smooth enough for
        constexpr int parts = 4000;
        for (int i = 0; i < parts; ++i) {
            const double next = at + (to - at) / (parts - i);
            const double q = rough.step(state, d, {next - at, 0}, state).traction[0];
            lost += (q + last) / 2 * (next - at), last = q, at = next;
        }
    };
    go_to(s), lost = 0, go_to(-s), go_to(s);
    CHECK(test::relative_error(lost, rough.cycle(d, s).lost) < 1e-5);
}

TEST_CASE(
    "law after a load: at the load K is that of unloading, and friction goes on with it, without a gain of energy") {
    const Law loading = first_loading(), law = law_after(loading, 1e7, 0.1);
    CHECK(test::relative_error(law.stiffness(1e7), loading.stiffness(1e7)) < 1e-3);
    CHECK(test::relative_error(law.slope_at_separation(law.separation(1e7)), loading.stiffness(1e7)) < 1e-3);
    CHECK(law.stiffness(1.0001e7) < 0.7 * law.stiffness(1e7));
    const TangentialLaw<double> rough(law, 0.2, 0.82);
    CHECK(rough.normal().stiffness(1.2e7) > law.stiffness(1e7));
    const double d = law.separation(1e7), amplitude = 1e-9;  // which closes and slides at once
    SlipState<double, 2> state{.separation = d};
    double lost = 0, q = 0, p = 0, last = 0;
    for (int i = 0; i <= 3 * 512; ++i) {
        const double s = amplitude * std::sin(2 * std::numbers::pi * i / 512);
        const auto found = rough.step(state, d - s, {s - last, 0}, state);
        if (i > 2 * 512) lost += (q + found.traction[0]) / 2 * (s - last) + (p + found.pressure) / 2 * (s - last);
        q = found.traction[0], p = found.pressure, last = s;
    }
    CHECK(lost > -1e-12 * 1e7 * amplitude);
    CHECK(lost < 0.1 * 0.2 * 1e7 * amplitude);
}

TEST_CASE("law after a load: an elastic law is its own, and what has no unloading or no such pressure is refused") {
    const Law elastic = Law::tabulate(GreenwoodWilliamson<double>(test::sand_blasted_fine.roughness(), modulus),
                                      {1e4, 1e8, OutsideRange::refuse});
    CHECK(law_after(elastic, 1e7, 0.1) == elastic);
    const Law printed = Law::tabulate_points(
        [](double p) {
            return detail::LawPoint<double>{-1e-7 * std::log(p), 2e7 * p};
        },
        1e-6, {1e4, 1e8}, 2.0);
    CHECK(test::refused_for("it has no unloading", [&] { (void)law_after(printed, 1e7, 0.1); }));
    for (const double p : {0.0, -1.0, 1e4, 1.01e8, std::nan("")})
        CHECK(test::refused_for("greatest_pressure", [&] { (void)law_after(first_loading(), p, 0.1); }));
    CHECK(test::refused_for("H/(E g)", [&] { (void)law_after(first_loading(), 1e7, -1); }));
    const double next = std::nextafter(1e8, 0.0);  // the end of the law but for rounding
    CHECK(test::relative_error(law_after(first_loading(), next, 0.1).stiffness(1e7),
                               law_after(first_loading(), 1e8, 0.1).stiffness(1e7)) < 1e-12);
    CHECK(
        test::refused_for("max_pressure", [&] { (void)law_after(first_loading(), std::nextafter(1e4, 1.0e9), 0.1); }));
    CHECK(law_after(first_loading(), 1e4 * (1 + 1e-9), 0.1).stiffness(1e6) > 0);
    CHECK(law_after(first_loading(), 1e8 * (1 - 1e-9), 0.1).stiffness(1e6) > 0);
}

}  // namespace law_after_test
