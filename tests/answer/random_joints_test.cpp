// SPDX-License-Identifier: BSD-3-Clause
// What must hold of the answer of any joint of numbers: more pressure makes it stiffer and closer, and a small change
// of what is known makes a small change of K.
#include <fstiff/answer/answer.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

namespace random_joints_test {

using namespace fstiff;

namespace {

/// Joints of numbers over the ranges of engineering faces, half of them with a shape of the heights.
class Joints {
public:
    Joint operator()() {
        Joint joint{.face = {.rms_height = log_uniform(2e-8, 2e-5)}, .effective_modulus = log_uniform(2e9, 3e11)};
        if (one_of(3) > 0) joint.face.rms_gradient = log_uniform(0.01, 0.6);
        if (one_of(2) > 0) joint.face.alpha = log_uniform(2, 100);
        if (one_of(2) > 0) {
            const double skewness = -1.2 + 2 * uniform();
            joint.face.skewness = skewness, joint.face.kurtosis = 2.5 + skewness * skewness + 2 * uniform();
        }
        const double E = *joint.effective_modulus;
        switch (one_of(4)) {
            case 0: joint.upper.hardness = std::numeric_limits<double>::infinity(); break;
            case 1: joint.upper.hardness_range = PriorRange{0.005 * E, 0.012 * E, 0.05 * E}; break;
            default: joint.upper.hardness = log_uniform(0.002, 0.3) * E;
        }
        return joint;
    }

private:
    double uniform() { return std::ldexp(static_cast<double>(random_() >> 11), -53); }
    double log_uniform(double from, double to) { return from * std::pow(to / from, uniform()); }
    int one_of(int count) { return static_cast<int>(count * uniform()); }
    std::mt19937_64 random_{20261126};
};

/// The most that the law of \p joint is made for, by the height alone where no gradient is known [Pa].
double greatest_pressure(const Joint& joint) {
    const double elastic = 0.5 * joint.face.rms_gradient.value_or(0.05) * *joint.effective_modulus;
    const double H = joint.upper.hardness_range ? joint.upper.hardness_range->low : *joint.upper.hardness;
    return (std::min)(elastic, 0.9 * H);
}

std::vector<double> pressures_of(const Joint& joint) {
    std::vector<double> all;
    for (double p = greatest_pressure(joint); all.size() < 10; p /= 3) all.push_back(p);
    std::reverse(all.begin(), all.end());
    return all;
}

/// K of \p joint under \p pressure.
double stiffness_of(const Joint& joint, double pressure) {
    return answer(joint, pressure, {.samples = 0}).stiffness.value;
}

void check_rise(int joints) {
    Joints next;
    int closed = 0;
    for (int i = 0; i < joints; ++i) {
        const Joint joint = next();
        const std::vector<double> pressures = pressures_of(joint);
        const Answer found = answer(joint, pressures, {.samples = 50});
        const AnswerPoint* last = nullptr;
        for (const AnswerPoint& at : found.points) {
            CAPTURE(i, at.pressure, at.reason, at.p_star.value_or(0));
            if (!at.ok()) {
                CHECK(&at == &found.points.back());
                ++closed;
                continue;
            }
            CHECK(at.stiffness.low <= at.stiffness.value);
            CHECK(at.stiffness.high >= at.stiffness.value);
            if (at.loading_stiffness) CHECK(*at.loading_stiffness <= at.stiffness.value);
            if (last) {
                CHECK(at.stiffness.value > last->stiffness.value);
                CHECK(at.stiffness.low >= last->stiffness.low);
                CHECK(at.stiffness.high >= last->stiffness.high);
                CHECK(at["approach"] > (*last)["approach"]);
                // above half the hardness the mean planes approach ever faster (theory-contact.md, section 10)
                const auto& range = joint.upper.hardness_range;
                const double H = range ? range->middle : *joint.upper.hardness;
                if (at.loading_stiffness && at.pressure < 0.5 * H)
                    CHECK(*at.loading_stiffness > last->loading_stiffness.value_or(0));
            }
            last = &at;
        }
    }
    CHECK(20 * closed < joints);
}

void check_little_changes(int joints) {
    Joints next;
    for (int i = 0; i < joints; ++i) {
        const Joint joint = next();
        const double pressure = greatest_pressure(joint) * (i % 3 == 0 ? 0.7 : i % 3 == 1 ? 0.01 : 1e-4);
        const double K = stiffness_of(joint, pressure);
        CAPTURE(i, pressure, K);
        const auto little = [&](double other) { CHECK(std::abs(other / K - 1) < 0.04); };
        little(stiffness_of(joint, 1.01 * pressure));
        Joint other = joint;
        *other.face.rms_height *= 1.01;
        little(stiffness_of(other, pressure));
        if (joint.face.rms_gradient) {
            other = joint;
            *other.face.rms_gradient *= 1.01;
            little(stiffness_of(other, pressure));
        }
        if (joint.upper.hardness) {
            other = joint;
            *other.upper.hardness *= 1.01;
            little(stiffness_of(other, pressure));
        }
    }
}

}  // namespace

TEST_CASE("Pressures are one number, numbers in braces, a vector of the standard library or one of Eigen") {
    const Joint joint{.face = {.rms_height = 0.5e-6, .rms_gradient = 0.1}, .effective_modulus = 112.6e9};
    const AnswerOptions options{.samples = 40};
    const std::vector pressures{1e6, 1e7};
    const Answer all = answer(joint, pressures, options);
    const auto is_same = [&](const Answer& other) {
        return other.points.size() == 2 && other.points[0].stiffness.low == all.points[0].stiffness.low &&
               other.points[1].stiffness.high == all.points[1].stiffness.high;
    };
    CHECK(is_same(answer(joint, {1e6, 1e7}, options)));
    CHECK(is_same(answer(joint, Eigen::Vector2d(1e6, 1e7), options)));
    CHECK(answer(joint, {1e7}, options).points.size() == 1);
    CHECK(answer(joint, 1e7, {.samples = 0}).stiffness.value == all.points[1].stiffness.value);
    CHECK(answer(joint, 1e7, options).pressure == 1e7);
    CHECK(test::refused_for("pressure", [&] { (void)answer(joint, -1.0); }));
    // one that the law does not reach, which among others would be a point without K
    const Joint soft{.face = joint.face, .upper = {.hardness = 1e9}, .effective_modulus = 112.6e9};
    CHECK(answer(soft, {1e6, 2e9}, options).points[1].reason ==
          test::refusal([&] { (void)answer(soft, 2e9, options); }));
}

TEST_CASE("K, its ends, the loading stiffness and the approach of 100 random joints rise with the pressure") {
    check_rise(100);
}
TEST_CASE("K, its ends, the loading stiffness and the approach of 400 random joints rise with the pressure", "[long]") {
    check_rise(400);
}

TEST_CASE(
    "One per cent of the pressure, the hardness, the gradient or the height changes K of 100 joints by less than "
    "four") {
    check_little_changes(100);
}
TEST_CASE(
    "One per cent of the pressure, the hardness, the gradient or the height changes K of 400 joints by less than four",
    "[long]") {
    check_little_changes(400);
}

}  // namespace random_joints_test
