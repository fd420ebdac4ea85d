// SPDX-License-Identifier: BSD-3-Clause
// Second differences one by one, the identity with the structure function, and forms that do not change them.
#include <fstiff/profile/structure_function.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/normal.hpp"

namespace second_differences_test {

using namespace fstiff;

namespace {

const std::vector<std::size_t> lags{1, 3, 20, 400};

}  // namespace

TEST_CASE("The mean square of second differences is that of each of them") {
    auto profile = test::random_walk(1000, 1);
    profile.heights[10] = profile.heights[500] = std::numeric_limits<double>::quiet_NaN();
    const auto s = detail::second_differences(profile, std::span<const std::size_t>(lags));
    for (std::size_t k = 0; k < lags.size(); ++k) {
        long double sum = 0;
        std::size_t count = 0;
        for (std::size_t i = lags[k]; i + lags[k] < 1000; ++i) {
            const auto& z = profile.heights;
            const long double d = static_cast<long double>(z[i + lags[k]]) - 2 * static_cast<long double>(z[i]) +
                                  static_cast<long double>(z[i - lags[k]]);
            if (std::isnan(d)) continue;
            sum += d * d;
            ++count;
        }
        CHECK(s.pairs[k] == count);
        CHECK(test::relative_error(s.value[k], static_cast<double>(sum / static_cast<long double>(count))) < 1e-13);
        CHECK(s.lag[k] == static_cast<double>(lags[k]) * 1e-6);
    }
}

TEST_CASE("For a periodic profile it is four times S less S of twice the lag") {
    const std::size_t period = 64;
    const auto wave = test::random_walk(period, 2);
    Profile<double> profile{{}, 1e-6};
    for (std::size_t i = 0; i < 400 * period; ++i) profile.heights.push_back(wave.heights[i % period]);
    const std::vector<std::size_t> n{5}, both{5, 10};
    const auto s = structure_function(profile, std::span<const std::size_t>(both));
    const auto second = detail::second_differences(profile, std::span<const std::size_t>(n));
    // but for the ends of the profile, of which there are 10 in 25600 points
    CHECK(test::relative_error(second.value[0], 4 * s.value[0] - s.value[1]) < 2e-3);
}

TEST_CASE("A line is not seen, and lags beyond half the profile are refused") {
    const auto profile = test::random_walk(1000, 3);
    auto tilted = profile;
    for (std::size_t i = 0; i < 1000; ++i) tilted.heights[i] += 1e-8 * (5 + 3 * static_cast<double>(i));
    const auto a = detail::second_differences(profile, std::span<const std::size_t>(lags));
    const auto b = detail::second_differences(tilted, std::span<const std::size_t>(lags));
    for (std::size_t k = 0; k < lags.size(); ++k) CHECK(test::relative_error(b.value[k], a.value[k]) < 1e-10);
    const std::vector<std::size_t> too_long{500};
    CHECK(test::refusal([&] { (void)detail::second_differences(profile, std::span<const std::size_t>(too_long)); }) ==
          "lag = 500 samples: must be between 1 and 499");
}

}  // namespace second_differences_test
