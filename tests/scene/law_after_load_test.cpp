// SPDX-License-Identifier: BSD-3-Clause
// The laws of an answer for a joint that is tightened and then vibrates.
#include <fstiff/answer/answer.hpp>
#include <fstiff/tabulated/law_after.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/half_space_maps.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace law_after_load_test {

using namespace fstiff;

namespace {

using Law = ContactLaw<double>;

Joint plates(std::optional<double> greatest = {}) {
    const Body steel{.elastic = {210e9, 0.3}, .hardness = 2e9};
    return {.face = {.rms_height = 0.8e-6, .rms_gradient = 0.1},
            .upper = steel,
            .lower = steel,
            .nominal_area = 1e-3,
            .greatest_pressure = greatest};
}

std::vector<double> pressures(double from, double to, int each_decade = 10) {
    std::vector<double> points;
    const int count = static_cast<int>(std::lround(std::log10(to / from) * each_decade));
    for (int i = 0; i <= count; ++i) points.push_back(from * std::pow(to / from, double(i) / count));
    return points;
}

constexpr LawRange<double> range{1e5, 3e8, OutsideRange::extrapolate};

}  // namespace

TEST_CASE("The loading law of an answer has the slope of the first loading, and K of unloading") {
    const Answer found = answer(plates(), pressures(1e5, 3e8));
    const Law law = found.loading_law(0.5, range);
    CHECK(!law.stiffness_is_slope());
    CHECK(law.has_unloading());
    for (const AnswerPoint& point : found.points) {
        CAPTURE(point.pressure);
        CHECK(test::relative_error(law.stiffness(point.pressure), point.stiffness.value) < 1e-3);
        const double slope = law.slope_at_separation(law.separation(point.pressure));
        CHECK(test::relative_error(slope, *point.loading_stiffness) < 1e-3);
    }
    // the approach is that of the model itself
    for (const std::size_t i : {std::size_t{5}, std::size_t{15}, std::size_t{25}}) {
        const double approach = found.points[i]["approach"] - found.points[0]["approach"];
        CHECK(std::abs(law.approach(found.points[i].pressure, 1e5) / approach - 1) < 5e-3);
    }
}

TEST_CASE("The law after a load has K of the joint that has carried it, at each end of the band") {
    const Answer found = answer(plates(), pressures(1e5, 3e8));
    for (const double greatest : {3e6, 5e7}) {
        const std::vector<double> below = pressures(greatest / 30, greatest * 0.99, 5);
        const Answer carried = answer(plates(greatest), below);
        const Law loading = found.loading_law(0.5, range);
        for (const double quantile : {0.05, 0.5, 0.95}) {
            const Law law = found.law_after(greatest, quantile, range);
            CAPTURE(greatest, quantile);
            CHECK(law.stiffness_is_slope());
            if (quantile == 0.5) {
                CHECK(std::abs(law.separation(greatest) - loading.separation(greatest)) < 1e-13);
                for (const AnswerPoint& point : carried.points)
                    CHECK(test::relative_error(law.stiffness(point.pressure), point.stiffness.value) < 3e-3);
            }
            CHECK(test::relative_error(law.stiffness(0.999 * greatest),
                                       found.law_at(quantile, range).stiffness(greatest)) < 3e-3);
            CHECK(law.stiffness(1.001 * greatest) < law.stiffness(0.999 * greatest));
        }
        // the joint that has carried it gives the same law
        std::vector<double> all = pressures(1e5, greatest);
        all.push_back(1.5 * greatest), all.push_back(2 * greatest);
        const Answer of_joint = answer(plates(greatest), all);
        CHECK(*of_joint.greatest_pressure == greatest);
        const Law same = of_joint.law_after(greatest, 0.5, {1e5, 2 * greatest, OutsideRange::extrapolate}),
                  law = found.law_after(greatest, 0.5, {1e5, 2 * greatest, OutsideRange::extrapolate});
        for (const double p : {0.05, 0.3, 0.9, 1.2, 1.8}) {
            CAPTURE(p);
            CHECK(test::relative_error(same.stiffness(p * greatest), law.stiffness(p * greatest)) < 2e-2);
            CHECK(test::relative_error(same.approach(1.9 * greatest, p * greatest),
                                       law.approach(1.9 * greatest, p * greatest)) < 2e-2);
        }
        CHECK(test::refused_for("that of the joint", [&] { (void)of_joint.law_after(0.5 * greatest, 0.5, range); }));
        CHECK(test::refused_for("left out of the joint", [&] { (void)of_joint.loading_law(0.5, range); }));
    }
    CHECK(test::refused_for("quantile", [&] { (void)found.law_after(1e7, 0.3, range); }));
    for (const double p : {0.0, 1e5, 4e8, std::nan("")})
        CHECK(test::refused_for("greatest_pressure", [&] { (void)found.law_after(p, 0.5, range); }));
}

TEST_CASE("The laws after several loads are those after each, whatever the joint") {
    Joint elastic = plates();
    elastic.upper.hardness = elastic.lower.hardness = std::numeric_limits<double>::infinity();
    for (const Joint& joint : {plates(), elastic, plates(2e7)}) {
        const Answer found = answer(joint, pressures(1e5, 2e7));
        const std::vector<double> greatest =
            joint.greatest_pressure ? std::vector{2e7, 2e7} : std::vector{2e6, 1e7, 2e7};
        const LawRange<double> below{1e5, 2e7, OutsideRange::extrapolate};
        for (const double quantile : {0.05, 0.5, 0.95}) {
            const std::vector<Law> laws = found.law_after(greatest, quantile, below);
            REQUIRE(laws.size() == greatest.size());
            for (std::size_t i = 0; i < laws.size(); ++i)
                CHECK(laws[i] == found.law_after(greatest[i], quantile, below));
        }
        CHECK(found.law_after(std::span<const double>(), 0.5, below).empty());
    }
    const Answer found = answer(plates(), pressures(1e5, 2e7));
    const auto loading = found.loading_law(0.5, {1e5, 2e7});
    CHECK(found.law_after(std::vector{1e7}, 0.5, {1e5, 2e7}).front() ==
          law_after(loading, 1e7, *found.relative_hardness));
}

TEST_CASE("The law after a load of an elastic joint is that of its K, and a form leaves it alone") {
    Joint elastic = plates();
    elastic.upper.hardness = elastic.lower.hardness = std::numeric_limits<double>::infinity();
    const Answer found = answer(elastic, pressures(1e5, 3e8));
    CHECK(found.law_after(1e7, 0.5, range) == found.law_at(0.5, range));
    CHECK(found.loading_law(0.95, range) == found.law_at(0.95, range));
    Joint formed = plates();
    formed.flatness = 5e-6;
    const Law with = answer(formed, pressures(1e5, 3e8)).law_after(2e7, 0.5, range),
              flat = answer(plates(), pressures(1e5, 3e8)).law_after(2e7, 0.5, range);
    for (const double p : {1e6, 1e7, 4e7}) CHECK(test::relative_error(with.stiffness(p), flat.stiffness(p)) < 1e-6);
}

}  // namespace law_after_load_test
