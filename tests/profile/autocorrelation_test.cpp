// SPDX-License-Identifier: BSD-3-Clause
// Truth: a cosine, whose autocorrelation is a cosine; direct sums; numpy.
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/profile/roughness_parameters.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/fractional_brownian.hpp"
#include "support/roughness_reference.hpp"

namespace autocorrelation_test {

using namespace fstiff;

TEST_CASE("The autocorrelation by transform is that of direct sums over the pairs that exist") {
    const bool holes = GENERATE(false, true);
    auto z = test::fractional_brownian(1024, 0.6, 5);
    z.resize(777);
    for (std::size_t i = 0; holes && i < z.size(); i += 7) z[i] = std::nan("");
    const Profile<double> profile{z, 2e-6};
    const auto found = autocorrelation(profile);
    REQUIRE(found.size() == 389);
    const double mean = detail::mean_height(profile), variance = std::pow(rms_height(profile), 2);
    for (std::size_t n = 0; n < found.size(); ++n) {
        double sum = 0;
        std::size_t pairs = 0;
        for (std::size_t i = 0; i + n < z.size(); ++i) {
            const double product = (z[i] - mean) * (z[i + n] - mean);
            if (std::isnan(product)) continue;
            sum += product;
            ++pairs;
        }
        REQUIRE(found.pairs[n] == pairs);
        REQUIRE(std::abs(found.value[n] - sum / static_cast<double>(pairs) / variance) < 1e-13);
        REQUIRE(found.lag[n] == static_cast<double>(n) * 2e-6);
    }
}

TEST_CASE("The autocorrelation of a cosine is a cosine, and falls to a fifth at acos(0.2)") {
    const double pi = std::numbers::pi_v<double>;
    Profile<double> profile{std::vector<double>(100000), 1e-6};
    for (std::size_t i = 0; i < 100000; ++i) profile.heights[i] = 5 + std::cos(2 * pi * static_cast<double>(i) / 1000);
    const auto found = autocorrelation(profile);
    for (std::size_t n = 0; n <= 50000; n += 1000)  // over whole waves the pairs have the variance of all points
        CHECK(std::abs(found.value[n] - 1) < 1e-12);
    // else a part of one wave of at least 50 is over: its sum of cos(a) cos(b) is at most 1/(2 pi) of a wave, twice the
    // variance
    for (std::size_t n = 0; n <= 50000; ++n)
        REQUIRE(std::abs(found.value[n] - std::cos(2 * pi * static_cast<double>(n) / 1000)) < 1 / (50 * pi));
    CHECK(test::relative_error(*detail::autocorrelation_length(found), std::acos(0.2) / (2 * pi) * 1e-3) <
          1 / (100 * pi));
}

TEST_CASE("Autocorrelation and its length are those that numpy finds") {
    for (const std::string source : {"profile_row", "profile_holes"}) {
        CAPTURE(source);
        auto expected = test::roughness_reference(source);
        const auto found = autocorrelation(test::reference_profile(source));
        CHECK(test::relative_error(*detail::autocorrelation_length(found), expected.at("Ral_m")) < 1e-9);
        for (const std::size_t n : {1u, 7u, 51u})
            CHECK(std::abs(found.value[n] - expected.at("acf_" + std::to_string(n))) < 1e-12);
    }
}

TEST_CASE("A profile that is all one slope has no autocorrelation length within half of it at a low threshold") {
    Profile<double> ramp{std::vector<double>(200), 1.0};
    for (std::size_t i = 0; i < 200; ++i) ramp.heights[i] = static_cast<double>(i);
    const auto found = autocorrelation(ramp);
    CHECK(detail::autocorrelation_length(found));
    auto above = found;
    for (double& value : above.value) value = std::max(value, 0.5);
    CHECK_FALSE(detail::autocorrelation_length(above));
    CHECK(test::refusal([&] { (void)detail::autocorrelation_length(found, 1.0); }).find("between 0 and 1") !=
          std::string::npos);
}

}  // namespace autocorrelation_test
