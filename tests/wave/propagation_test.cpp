// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/wave/spring_interface.hpp>
#include <fstiff/wave/uncertain_reflection.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/normal.hpp"
#include "support/springs.hpp"

#include <numbers>
#include <random>

namespace propagation_test {

using namespace fstiff;

namespace {

using test::Wide;

/// f' by a six-point difference: truncation (1e-3)^6 of the scale of f, 1e-14 or so; rounding 1e-16.
template <class F>
Wide difference(const F& f, Wide at, Wide h) {
    return (45 * (f(at + h) - f(at - h)) - 9 * (f(at + 2 * h) - f(at - 2 * h)) + (f(at + 3 * h) - f(at - 3 * h))) /
           (60 * h);
}

const Impedances<double> pairs[] = {{46e6, 46e6}, {46e6, 17e6}, {17e6, 46e6}, {46e6, 1.5e6}, {46e6, 45.9e6}};

}  // namespace

TEST_CASE("dR/dK agrees with differences") {
    const double omega = 2 * std::numbers::pi * 7e6;
    for (const auto& media : pairs)
        for (double k = 1e12; k < 1e19; k *= 3.7) {
            const Wide truth = difference(
                [&](Wide x) { return std::abs(test::wide_reflection(x, media.incident, media.beyond, omega)); }, k,
                1e-3L * k);
            INFO("K " << k << " z " << media.incident << " " << media.beyond);
            // the difference itself loses eps R/(K dR/dK): up to 1e-12 where R hardly changes
            CHECK(std::abs(detail::reflection_slope(k, media, omega) - static_cast<double>(truth)) * k <=
                  1e-12 * std::abs(static_cast<double>(truth)) * k + 1e-15);
        }
    CHECK(detail::reflection_slope(0.0, pairs[0], omega) == 0);
}

TEST_CASE("dK/dR agrees with differences and is the inverse of dR/dK") {
    const double omega = 2 * std::numbers::pi * 7e6;
    for (const auto& media : pairs) {
        const double welded = detail::welded_reflection(media);
        for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99, 0.9999}) {
            const double r = welded + share * (1 - welded);
            const auto stiffness = [&](Wide x) { return test::wide_stiffness(x, media.incident, media.beyond, omega); };
            const Wide step = 1e-4L * std::min(1 - Wide(r), Wide(r) - welded), truth = difference(stiffness, r, step);
            const auto k = detail::measured_stiffness(r, 0.01, media, omega);
            INFO("R " << r << " z " << media.incident << " " << media.beyond);
            // r + step is rounded to 1e-19, which the division by the step enlarges
            CHECK(test::relative_error(k.slope, static_cast<double>(truth)) <
                  1e-12 + 1e-18 / static_cast<double>(step));
            // ln K = ln(1 - R^2)/2 - ln(R^2 s^2 - d^2)/2 + ..., s the sum of the impedances, d their difference
            const Wide s = Wide(media.incident) + media.beyond, d = Wide(media.incident) - media.beyond, x = r;
            const Wide exact = -stiffness(x) * (x / ((1 - x) * (1 + x)) + x * s * s / ((x * s - d) * (x * s + d)));
            if (r > welded + 1e-3) CHECK(test::ulps(k.slope, static_cast<double>(exact)) <= 16);
            // R in double moves by an ulp: its effect on the slopes is that over the distance to both ends
            const double loss = 1e-15 / std::min(1 - r, r - welded);
            CHECK(test::relative_error(k.slope * detail::reflection_slope(k.value, media, omega), 1.0) < 10 * loss);
            CHECK(k.error == -0.01 * k.slope);
            CHECK(k.value == stiffness_from_reflection(r, media, omega));
        }
    }
}

TEST_CASE("the relative error of K is least at R = 1/sqrt(3) for like media, 2.598 times that of R") {
    const auto relative = [](double r) {
        const auto k = detail::measured_stiffness(r, 1.0, {46e6, 46e6}, 4.4e7);
        return k.error / k.value;
    };
    const double best = 1 / std::sqrt(3.0);
    CHECK(test::relative_error(relative(best), 1.5 * std::sqrt(3.0)) < 1e-14);
    CHECK(relative(best) < relative(best - 0.01));
    CHECK(relative(best) < relative(best + 0.01));
}

TEST_CASE("the error of K is the spread of K from scattered R") {
    test::Normal normal(5);
    const Impedances<double> media{46e6, 17e6};
    const double omega = 4.4e7, r = 0.8, error = 0.002;
    double sum = 0, squares = 0;
    const int count = 20000;
    const auto k = detail::measured_stiffness(r, error, media, omega);
    for (int i = 0; i < count; ++i) {
        const double x = stiffness_from_reflection(r + error * normal(), media, omega) / k.value - 1;
        sum += x;
        squares += x * x;
    }
    const double spread = std::sqrt(squares / count - sum * sum / count / count);
    // 0.5 % is the error of a standard deviation of 20000 draws, 3 times that; curvature adds (0.002 * 5)^2
    CHECK(test::relative_error(k.error / k.value, spread) < 0.016);
}

TEST_CASE("K is bounded where two errors of R reach neither 1 nor the welded joint") {
    const Impedances<double> media{46e6, 23e6};  // welded: R = 1/3
    const auto bounded = [&](double r, double error) {
        return detail::measured_stiffness(r, error, media, 4.4e7).bounded;
    };
    CHECK(bounded(0.9, 0.049));
    CHECK_FALSE(bounded(0.9, 0.051));
    CHECK(bounded(0.4, 0.033));
    CHECK_FALSE(bounded(0.4, 0.034));
    CHECK(bounded(0.4, 0.0));
}

TEST_CASE("propagation refuses values without an error") {
    const auto call = [](double r, double error) {
        return test::refusal([&] { static_cast<void>(detail::measured_stiffness(r, error, {46e6, 46e6}, 4.4e7)); });
    };
    CHECK(call(0.5, -1).find("reflection_error = -1") == 0);
    CHECK(call(1, 0.1).find("reflection = 1") == 0);
}

TEST_CASE("The error of R is that of K carried on, and back again") {
    const double omega = 2 * std::numbers::pi * 7e6;
    for (const auto& media : pairs)
        for (double k = 1e13; k < 1e17; k *= 7.3) {
            const Estimate<double> r = reflection(Estimate<double>{k, 1e-3 * k, 5}, media, omega);
            CHECK((r.value == reflection(k, media, omega) && r.evaluations == 5));
            // to first order: half a change of either sign
            const double change =
                (reflection(k * (1 - 1e-3), media, omega) - reflection(k * (1 + 1e-3), media, omega)) / 2;
            CHECK(std::abs(r.error - change) < 1e-5 * change + 4e-15);
            const double c = detail::welded_reflection(media);
            if (r.value < c + 1e-3 || r.value > 1 - 1e-6) continue;
            const auto back = detail::measured_stiffness(r.value, r.error, media, omega);
            // R is rounded, and near the weld or 1 its last digit moves K and the slope
            const double lost = 1e-13 / std::min(r.value - c, 1 - r.value);
            CHECK(std::abs(back.value - k) < lost * k);
            CHECK(std::abs(back.error - 1e-3 * k) <
                  1e-3 * k * (lost + 1e-6) + 1e-14 * back.value / std::min(r.value - c, 1 - r.value));
        }
    CHECK(reflection(Estimate<double>{0, 0, 0}, pairs[0], omega).value == 1);
}

}  // namespace propagation_test
