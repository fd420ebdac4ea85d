// SPDX-License-Identifier: BSD-3-Clause
// Parabolas, quadratic surfaces and steps in noise against the closed forms of their shares; roughness has none.
#include <fstiff/measure/plain_form.hpp>

#include <fstiff/profile/gaussian_filter.hpp>
#include <fstiff/profile/levelled_profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/topography/form.hpp>

#include "support/catch.hpp"
#include "support/map_kinds.hpp"

#include <random>

namespace plain_form_test {

using namespace fstiff;

namespace {

constexpr double noise = 1e-6;

/// Profile of \p form(u), u from 0 to 1, in noise, without its line.
template <class Form>
Profile<double> profile_of(const Form& form, std::size_t points = 4000) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    Profile<double> profile{std::vector<double>(points), 0.5e-6};
    for (std::size_t i = 0; i < points; ++i)
        profile.heights[i] = form(static_cast<double>(i) / static_cast<double>(points)) + noise * normal(random);
    return detail::level(profile, fstiff::Form::line).profile;
}

/// Map of \p form(u, v), u and v from 0 to 1, in noise, without its plane.
template <class Form>
HeightMap<double> map_of(const Form& form) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    HeightMap<double> map{HeightMap<double>::Array(150, 200), 1e-6, 1e-6};
    for (Eigen::Index j = 0; j < map.rows(); ++j)
        for (Eigen::Index i = 0; i < map.columns(); ++i)
            map.heights(j, i) =
                form(static_cast<double>(i) / 200, static_cast<double>(j) / 150) + noise * normal(random);
    return detail::level(map, MapForm::plane).map;
}

double share(double variance) { return variance / (variance + noise * noise); }

}  // namespace

TEST_CASE("The share of a parabola is that of its variance") {
    for (const double height : {0.3e-6, 3e-6, 30e-6}) {
        // (2 u - 1)^2 has the variance 4/45 about its mean, and no line
        const auto found =
            detail::plain_form(profile_of([&](double u) { return height * (2 * u - 1) * (2 * u - 1); }), 1);
        const double exact = share(height * height * 4 / 45);
        CHECK(std::abs(found.parabola - exact) < 0.02);
        CHECK(found.is_parabola() == (exact > 0.5));
        CHECK_FALSE(found.is_step());
    }
    // of a map twice that of a ball, once of a cylinder, and 1/9 of a saddle (2 u - 1) (2 v - 1)
    const auto of_map = [&](auto form) { return detail::plain_form(map_of(form), 1); };
    const auto square = [](double u) { return (2 * u - 1) * (2 * u - 1); };
    CHECK(std::abs(of_map([&](double u, double v) { return 5e-6 * (square(u) + square(v)); }).parabola -
                   share(25e-12 * 8 / 45)) < 0.02);
    CHECK(std::abs(of_map([&](double u, double) { return 5e-6 * square(u); }).parabola - share(25e-12 * 4 / 45)) <
          0.02);
    const auto saddle = of_map([](double u, double v) { return 5e-6 * (2 * u - 1) * (2 * v - 1); });
    CHECK(std::abs(saddle.parabola - share(25e-12 / 9)) < 0.02);
    CHECK(saddle.is_parabola());
    // a form that was removed already is none
    CHECK(detail::plain_form(profile_of([&](double u) { return 30e-6 * square(u); }), 2).parabola == 0);
}

TEST_CASE("The share of a step is that of its variance without a line, and its place is found") {
    for (const double place : {0.1, 0.3, 0.5, 0.8})
        for (const double height : {2e-6, 10e-6, 40e-6}) {
            const auto step = [&](double u) { return u < place ? 0.0 : height; };
            // h^2 f (1 - f), of which a line takes 3 h^2 f^2 (1 - f)^2
            const double f = place * (1 - place), exact = share(height * height * f * (1 - 3 * f));
            const auto found = detail::plain_form(profile_of(step), 1);
            CHECK(found.is_step() == (exact > 0.5));
            if (exact < 0.5) continue;
            CHECK(std::abs(found.step - exact) < 0.03);
            CHECK(std::abs(found.place - place * 2000e-6) < 2000e-6 / 128);
            const auto across = detail::plain_form(map_of([&](double u, double) { return step(u); }), 1);
            CHECK((across.is_step() && across.along_x && !across.along_y));
            CHECK(std::abs(across.place - place * 200e-6) < 200e-6 / 32);
            const auto down = detail::plain_form(map_of([&](double, double v) { return step(v); }), 1);
            CHECK((down.is_step() && down.along_y && !down.along_x));
            CHECK(std::abs(down.place - place * 150e-6) < 150e-6 / 32);
        }
    for (const double angle : {0.3, 0.7, 1.1, 2.0, 2.9}) {  // of 8 noises at an angle, on a wedge
        const auto found =
            detail::plain_form(map_of([&](double u, double v) {
                                   return 20e-6 * u + 7e-6 * v +
                                          ((u - 0.5) * std::cos(angle) + (v - 0.5) * std::sin(angle) > 0.05 ? 8e-6 : 0);
                               }),
                               1);
        CHECK((found.is_step() && !found.along_x && !found.along_y));
    }
}

TEST_CASE("Roughness, waviness and a groove are no form and no step") {
    for (const auto& kinds : {test::map_kinds(), test::more_map_kinds()})
        for (const test::MapKind& kind : kinds) {
            const auto found = detail::plain_form(detail::level(kind.map(2), MapForm::plane).map, 1);
            INFO(kind.name);
            CHECK((!found.is_step() && !found.is_parabola()));
        }
    for (const double waves : {1.5, 2.0, 3.3, 7.0}) {
        const auto found =
            detail::plain_form(profile_of([&](double u) { return 10e-6 * std::sin(6.283 * waves * u); }), 1);
        INFO(waves);
        CHECK((!found.is_step() && !found.is_parabola()));
    }
    HeightMap<double> half = map_of([](double u, double) { return u < 0.25 ? 0.0 : 9e-6; });
    half.heights.bottomRows(75) = std::nan("");  // half covered: the step is still one
    CHECK(detail::plain_form(half, 1).is_step());
}

}  // namespace plain_form_test
