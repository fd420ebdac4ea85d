// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/profile_form.hpp>
#include <fstiff/profile/structure_function.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>
#include <random>

namespace structure_function_test {

using namespace fstiff;

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

Profile<double> walk(std::size_t points, unsigned seed) {
    std::mt19937_64 random(seed);
    Profile<double> profile{std::vector<double>(points), 1e-7};
    double height = 0;
    for (double& z : profile.heights) z = height += 1e-9 * (static_cast<double>(random() % 2001) - 1000) / 1000;
    return profile;
}

/// (2.8) in long double over the pairs that exist.
double slow(const Profile<double>& profile, std::size_t n) {
    long double sum = 0;
    std::size_t pairs = 0;
    for (std::size_t i = 0; i + n < profile.size(); ++i) {
        const long double d = static_cast<long double>(profile.heights[i + n]) - profile.heights[i];
        if (std::isnan(d)) continue;
        sum += d * d;
        ++pairs;
    }
    return static_cast<double>(sum / static_cast<long double>(pairs));
}

StructureFunction<double> at(const Profile<double>& profile, std::vector<std::size_t> lags,
                             Divisor divisor = Divisor::pairs) {
    return structure_function(profile, std::span<const std::size_t>(lags), divisor);
}

}  // namespace

TEST_CASE("The structure function is the mean over the pairs in long double, whatever the offset") {
    const double offset = GENERATE(0.0, 1.0);  // 1e6 times the roughness
    const bool gaps = GENERATE(false, true);
    CAPTURE(offset, gaps);
    auto profile = walk(65536, 1);
    for (std::size_t i = 0; i < profile.size(); ++i) {
        profile.heights[i] += offset;
        if (gaps && i % 13 == 5) profile.heights[i] = missing;
    }
    const auto s = at(profile, {1, 2, 3, 13, 100, 1000, 16384, 65000});
    REQUIRE(s.size() == 8);
    for (std::size_t k = 0; k < s.size(); ++k)
        CHECK(test::relative_error(s.value[k], slow(profile, s.step[k])) < 1e-13);
}

TEST_CASE("A tilt of 1e6 times the roughness costs ten digits of sixteen and no more") {
    const auto plain = walk(20000, 2);
    auto tilted = plain;
    const double sigma = rms_height(plain);
    for (std::size_t i = 0; i < tilted.size(); ++i)
        tilted.heights[i] += 1e6 * sigma * static_cast<double>(i) / 20000;  // rounds the data themselves to 1e-10 sigma
    const std::vector<std::size_t> lags{1, 5, 50, 500, 5000};
    const auto a = at(detail::detrend(plain, Form::line), lags), b = at(detail::detrend(tilted, Form::line), lags);
    // against the same doubles without their line in long double the data's own rounding does not count
    long double product = 0, squares = 0;
    for (std::size_t i = 0; i < tilted.size(); ++i) {
        const long double u = static_cast<long double>(i) - 9999.5L;
        product += u * tilted.heights[i], squares += u * u;
    }
    for (std::size_t k = 0; k < lags.size(); ++k) {
        const std::size_t n = lags[k];
        long double truth = 0;
        for (std::size_t i = 0; i + n < tilted.size(); ++i) {
            const long double d = static_cast<long double>(tilted.heights[i + n]) - tilted.heights[i] -
                                  product / squares * static_cast<long double>(n);
            truth += d * d / static_cast<long double>(tilted.size() - n);
        }
        CAPTURE(n);
        CHECK(test::relative_error(b.value[k], static_cast<double>(truth)) < 1e-10);
        // at one sample the rounding of the data is 1e-10 sigma against steps of 5e-3 sigma, averaged over 20000
        CHECK(test::relative_error(b.value[k], a.value[k]) < 1e-8);
    }
}

TEMPLATE_TEST_CASE("A sine has the structure function 2 a^2 sin^2(pi tau/lambda)", "", FSTIFF_SCALARS) {
    using T = TestType;
    Profile<T> profile{std::vector<T>(10000), T(1e-6)};
    for (std::size_t i = 0; i < 10000; ++i)
        profile.heights[i] = T(2e-6) * std::sin(2 * std::numbers::pi_v<T> * static_cast<T>(i % 50) / 50);
    // 9950 and 9900 pairs: whole periods
    const std::vector<std::size_t> lags{50, 100};
    for (const auto n : lags) {
        const auto s = structure_function(profile, std::span<const std::size_t>(&n, 1));
        CHECK(s.value[0] <= std::numeric_limits<T>::min());
    }
    const std::size_t half = 25;
    const auto s = structure_function(profile, std::span<const std::size_t>(&half, 1));
    CHECK(s.pairs[0] == 9975);
    // 9975 pairs are 199.5 periods, and sin^2 has half that period: still whole
    CHECK(test::ulps(s.value[0], T(8) * T(1e-6) * T(1e-6)) <= 50);
    CHECK(test::ulps(s.lag[0], T(25) * T(1e-6)) <= 2);
}

TEST_CASE("The divisor as printed is one pair short") {
    const auto profile = walk(100, 3);
    const auto ours = at(profile, {1, 10, 90}), printed = at(profile, {1, 10, 90}, Divisor::paper);
    for (std::size_t k = 0; k < 3; ++k) {
        const auto pairs = static_cast<double>(ours.pairs[k]);
        CHECK(ours.pairs[k] == 100 - ours.step[k]);
        CHECK(test::relative_error(printed.value[k], ours.value[k] * pairs / (pairs - 1)) < 1e-15);
    }
    CHECK(at(profile, {99}, Divisor::paper).size() == 0);  // one pair, divided by none
    CHECK(at(profile, {99}).size() == 1);
}

TEST_CASE("Missing points drop their pairs, and a lag without a pair is left out") {
    const Profile<double> profile{{1, missing, 4, missing, 9, missing}, 1.0};
    const auto s = at(profile, {1, 2, 3, 4});
    REQUIRE(s.step == std::vector<std::size_t>{2, 4});
    CHECK(s.pairs == std::vector<std::size_t>{2, 1});
    CHECK(s.value[0] == (9.0 + 25.0) / 2);
    CHECK(s.value[1] == 64.0);
}

TEST_CASE("The structure function scales with the unit of length") {
    const auto profile = walk(1000, 4);
    const auto s = structure_function(profile);
    for (const double unit : {1e-9, 1e9}) {
        auto scaled = profile;
        for (double& z : scaled.heights) z *= unit;
        scaled.spacing *= unit;
        const auto t = structure_function(scaled);
        REQUIRE(t.step == s.step);
        for (std::size_t k = 0; k < s.size(); ++k)
            CHECK(test::relative_error(t.value[k], s.value[k] * unit * unit) < 1e-14);
    }
}

TEST_CASE("Logarithmic lags rise from 1, hold every small lag and end at the longest at the latest") {
    const auto lags = detail::logarithmic_lags(1000);
    CHECK(lags.front() == 1);
    CHECK(lags.back() <= 1000);
    CHECK(lags.back() > 940);  // a twelfth of an octave
    for (std::size_t k = 1; k < lags.size(); ++k) REQUIRE(lags[k] > lags[k - 1]);
    for (std::size_t n = 1; n <= 8; ++n) CHECK(std::find(lags.begin(), lags.end(), n) != lags.end());
    CHECK(lags.size() < 100);
    CHECK(detail::logarithmic_lags(0).empty());
    CHECK(detail::logarithmic_lags(1) == std::vector<std::size_t>{1});
}

TEST_CASE("A lag outside the profile is refused") {
    const auto profile = walk(100, 5);
    CHECK(test::refusal([&] { (void)at(profile, {100}); }).find("lag = 100 samples: must be between 1 and 99") !=
          std::string::npos);
    CHECK_FALSE(test::refusal([&] { (void)at(profile, {0}); }).empty());
    CHECK_FALSE(test::refusal([&] { (void)at(Profile<double>{{1, 2, 3}, 0.0}, {1}); }).empty());
}

}  // namespace structure_function_test
