// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/profile_form.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <array>

namespace detrend_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Values that look random, from -1 to 1, the same everywhere.
double rough(std::size_t i) {
    return std::fmod(static_cast<double>(i) * static_cast<double>(i) * 0.6180339887498949, 2.0) - 1;
}

/// The residual by normal equations in long double over centred positions: the independent slow code.
std::vector<double> slow(const Profile<double>& profile, std::size_t terms) {
    std::array<std::array<long double, 4>, 3> a{};
    const auto n = static_cast<long double>(profile.size());
    const auto u = [&](std::size_t i) { return (static_cast<long double>(i) - n / 2) / n; };
    for (std::size_t i = 0; i < profile.size(); ++i) {
        if (std::isnan(profile.heights[i])) continue;
        const std::array<long double, 3> p{1, u(i), u(i) * u(i)};
        for (std::size_t r = 0; r < terms; ++r) {
            for (std::size_t c = 0; c < terms; ++c) a[r][c] += p[r] * p[c];
            a[r][3] += p[r] * profile.heights[i];
        }
    }
    for (std::size_t k = 0; k < terms; ++k)
        for (std::size_t r = 0; r < terms; ++r)
            if (r != k) {
                const long double factor = a[r][k] / a[k][k];
                for (std::size_t c = 0; c < 4; ++c) a[r][c] -= factor * a[k][c];
            }
    std::vector<double> residual;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        long double form = 0, power = 1;
        for (std::size_t k = 0; k < terms; ++k, power *= u(i)) form += a[k][3] / a[k][k] * power;
        residual.push_back(static_cast<double>(profile.heights[i] - form));
    }
    return residual;
}

}  // namespace

TEST_CASE("Removing a form leaves the residual of the normal equations in long double") {
    const double tilt = GENERATE(0.0, 1.0, 1e6);
    const bool gaps = GENERATE(false, true);
    const int terms = GENERATE(1, 2, 3);
    CAPTURE(tilt, gaps, terms);
    Profile<double> profile{std::vector<double>(3000), 1e-6};
    for (std::size_t i = 0; i < 3000; ++i) {
        const double x = static_cast<double>(i) / 3000;
        profile.heights[i] = 1e-6 * (rough(i) + tilt * (1 + (terms > 1 ? x : 0) + (terms > 2 ? x * x : 0)));
        if (gaps && (i % 17 == 3 || (i > 500 && i < 900))) profile.heights[i] = missing;
    }
    const auto residual = detail::detrend(profile, static_cast<Form>(terms)).heights;
    const auto truth = slow(profile, static_cast<std::size_t>(terms));
    double worst = 0;
    for (std::size_t i = 0; i < 3000; ++i) {
        REQUIRE(std::isnan(residual[i]) == std::isnan(profile.heights[i]));
        if (!std::isnan(residual[i])) worst = std::max(worst, std::abs(residual[i] - truth[i]));
    }
    CHECK(worst <= 4e-16 * 1e-6 * (1 + terms * tilt));  // the bound of the header, relative to the largest height
}

TEMPLATE_TEST_CASE("A polynomial leaves nothing but rounding", "", FSTIFF_SCALARS) {
    using T = TestType;
    Profile<T> profile{std::vector<T>(500), T(1e-6)};
    for (std::size_t i = 0; i < 500; ++i) {
        const T x = static_cast<T>(i) / 500;
        profile.heights[i] = 3 + 2 * x - 5 * x * x;
    }
    const auto residual = detail::detrend(profile, Form::parabola);
    for (const T z : residual.heights)
        REQUIRE(std::abs(z) <= 8 * std::numeric_limits<T>::epsilon());  // heights of 3 are rounded to 2 epsilon
    CHECK(rms_height(detail::detrend(profile, Form::line)) > T(0.1));
    CHECK(detail::detrend(profile, Form::none).heights == profile.heights);
    CHECK(detail::detrend(profile, Form::mean).spacing == profile.spacing);
}

TEST_CASE("Removing a form twice changes nothing the second time") {
    Profile<double> profile{std::vector<double>(200), 1.0};
    for (std::size_t i = 0; i < 200; ++i) profile.heights[i] = rough(i) + 0.1 * static_cast<double>(i);
    for (const Form form : {Form::mean, Form::line, Form::parabola}) {
        const auto once = detail::detrend(profile, form), twice = detail::detrend(once, form);
        for (std::size_t i = 0; i < 200; ++i) REQUIRE(std::abs(once.heights[i] - twice.heights[i]) < 1e-15);
    }
}

TEST_CASE("A form of more coefficients than points is refused") {
    const Profile<double> two{{1, missing, 2, missing}, 1.0};
    CHECK(detail::detrend(two, Form::line).present() == 2);
    CHECK(test::refusal([&] { (void)detail::detrend(two, Form::parabola); }).find("2 points: must be at least 3") !=
          std::string::npos);
    CHECK_FALSE(test::refusal([] { (void)detail::detrend(Profile<double>{{}, 1.0}, Form::mean); }).empty());
    CHECK_FALSE(
        test::refusal([] {
            (void)detail::detrend(Profile<double>{{1, std::numeric_limits<double>::infinity()}, 1.0}, Form::mean);
        }).empty());
}

}  // namespace detrend_test
