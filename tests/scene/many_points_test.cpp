// SPDX-License-Identifier: BSD-3-Clause
// Answers at thousands of pressures, which are interpolated. Truth: the answer at some of the pressures alone.
#include "actions/identify.hpp"
#include "actions/overclosure.hpp"

#include "support/library.hpp"

#include <fstiff/answer.hpp>
#include <fstiff/answer/state_table.hpp>
#include <fstiff/asperity/named_materials.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace many_points_test {

using namespace fstiff;

namespace {

Body body(const char* name) { return body_of(*find_material(name)); }

/// \p count pressures from \p from to \p to [Pa] at random, the ends among them.
std::vector<double> pressures_of(double from, double to, int count) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<double> all{to, from};
    while (static_cast<int>(all.size()) < count) all.push_back(from * std::pow(to / from, share(random)));
    return all;
}

/// \p many has, within the bounds that it states, the numbers of \p alone, which are at every \p step of its points.
void require_near(const std::vector<AnswerPoint>& many, const std::vector<AnswerPoint>& alone, std::size_t step) {
    for (std::size_t i = 0; i < alone.size(); ++i) {
        const AnswerPoint &one = alone[i], &of_many = many[i * step];
        CAPTURE(i, one.pressure);
        REQUIRE(of_many.ok() == one.ok());
        CHECK(of_many.law == one.law);
        CHECK(of_many.reason == one.reason);
        if (!one.ok()) continue;
        CHECK(test::relative_error(of_many.stiffness.value, one.stiffness.value) < 1e-7);
        if (one.find("approach")) CHECK(std::abs(of_many["approach"] - one["approach"]) < 1e-13);
        if (one.loading_stiffness)
            CHECK(test::relative_error(*of_many.loading_stiffness, *one.loading_stiffness) < 1e-7);
        if (one.contacts) CHECK(test::relative_error(*of_many.contacts, *one.contacts) < 1e-7);
        if (one.pressure > 1e9) continue;  // next to a hardness the ends of the band are no smooth curves
        CHECK(test::relative_error(of_many.stiffness.low, one.stiffness.low) < 1e-3);
        CHECK(test::relative_error(of_many.stiffness.high, one.stiffness.high) < 1e-3);
        const auto shares = shares_of(one.causes), of_shares = shares_of(of_many.causes);
        for (std::size_t c = 0; c < shares.size(); ++c) CHECK(std::abs(of_shares[c] - shares[c]) < 2e-3);
    }
}

}  // namespace

TEST_CASE("Thousands of pressures have the answer of each alone: K within 1e-7, the ends of its band within 1e-3") {
    Joint known{.face = {.rms_height = 0.8e-6,
                         .rms_gradient = 0.1,
                         .alpha = 8,
                         .hurst = 0.8,
                         .skewness = -0.4,
                         .kurtosis = 3.5,
                         .errors = {.height = 0.04e-6, .gradient = 0.01}},
                .upper = body("steel"),
                .lower = body("cast_iron"),
                .nominal_area = 1e-4};
    known.upper.hardness = 2e9, known.lower.hardness = 3e9;
    Joint elastic = known;
    elastic.upper.hardness = elastic.lower.hardness = std::numeric_limits<double>::infinity();
    const Joint open{.face = {.mean_height = 0.8e-6}, .upper = body("steel"), .lower = body("steel")};
    constexpr std::size_t step = 170;
    for (const Joint& joint : {known, elastic, open}) {
        const std::vector<double> many = pressures_of(1e4, 3e10, 1700);  // beyond the hardness and the closed contact
        std::vector<double> some;
        for (std::size_t i = 0; i < many.size(); i += step) some.push_back(many[i]);
        AnswerOptions options{.samples = 100};
        if (joint.upper.hardness == 2e9) options.laws = {laws::hybrid, laws::persson, laws::hertz};
        const Answer of_many = answer(joint, many, options), alone = answer(joint, some, options);
        require_near(of_many.points, alone.points, step);
        REQUIRE(of_many.laws.size() == alone.laws.size());
        for (std::size_t i = 0; i < alone.laws.size(); ++i) {
            CAPTURE(name_of(alone.laws[i].law));
            require_near(of_many.laws[i].points, alone.laws[i].points, step);
        }
    }
}

TEST_CASE("A law with a kink is not interpolated there") {
    // K of two power laws: a table of it has no state next to the kink, and the right one elsewhere
    const auto state_at = [](double p) {
        ContactState<double> state;
        state.pressure.value = p, state.stiffness.value = p < 1e6 ? p : std::sqrt(p * 1e6);
        return ContactPoint<double>::of(state);
    };
    const std::vector<double> pressures = detail::StateTable::pressures(1e4, 1e8);
    std::vector<ContactPoint<double>> nodes;
    for (const double p : pressures) nodes.push_back(state_at(p));
    const detail::StateTable table(pressures, nodes);
    int exact = 0, between = 0;
    for (const double p : pressures_of(1e4, 1e8, 4000))
        if (const auto state = table.at(p)) {
            ++between;
            CHECK(test::relative_error(state->stiffness.value, state_at(p).state.stiffness.value) < 1e-9);
        } else {
            ++exact;
            CHECK(std::abs(std::log(p / 1e6)) < 5 * detail::StateTable::step);
        }
    CHECK(exact > 0);
    CHECK(between > 3000);
}

TEST_CASE("Thousands of measured points are identified as the hundreds among them") {
    const auto read = scene::read_scene(
        "[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.1\nalpha = 8\nhurst = 0.8\nskewness = 0\nkurtosis = 3\n"
        "[material.upper]\nname = \"steel\"\nhardness = \"2 GPa\"\n[contact]\npressures = [\"1 MPa\"]\n",
        {.name = "many.toml"});
    Joint joint{
        .face = {.rms_height = 0.9e-6, .rms_gradient = 0.1, .alpha = 8, .hurst = 0.8, .skewness = 0, .kurtosis = 3},
        .upper = body("steel"),
        .lower = body("steel")};
    joint.upper.hardness = joint.lower.hardness = 2e9;
    std::vector<double> pressures = pressures_of(1e5, 1e9, 2000), stiffness;
    std::sort(pressures.begin(), pressures.end());
    for (const AnswerPoint& point : answer(joint, pressures, {.samples = 0}).points)
        stiffness.push_back(point.stiffness.value);
    for (const char* law : {"plastic", "hybrid", "hertz"}) {
        std::vector<double> found, errors;
        for (const std::size_t step : {1u, 10u}) {
            std::vector<double> p, K;
            for (std::size_t i = 0; i < pressures.size(); i += step)
                p.push_back(pressures[i]), K.push_back(stiffness[i]);
            const auto curve = actions::curve_of_numbers(p, K, {}, false, "curve");
            const auto fits = actions::identify(read, curve, {.wanted = {Parameter::rms_height}, .law = law});
            found.push_back(fits.fits.front().found.parameters.front().value);
        }
        INFO(law);
        if (law == std::string("plastic")) CHECK(test::relative_error(found[0], 0.9e-6) < 1e-6);
        CHECK(test::relative_error(found[0], found[1]) < 0.01);
    }
}

TEST_CASE("A table for finite elements spans fifteen decades of pressure at most") {
    const auto read = scene::read_scene(
        "[surface]\nrms_height = \"0.8 um\"\nrms_gradient = 0.1\n[contact]\npressures = [\"1 MPa\", \"10 MPa\"]\n",
        {.name = "wide.toml"});
    CHECK(test::refusal([&] { (void)actions::pressure_table(read, {.from = 1e-50, .to = 1e50}); }) ==
          "until = 1e+50: must be at most 1e15 times from, 1e-50 Pa");
}

}  // namespace many_points_test
