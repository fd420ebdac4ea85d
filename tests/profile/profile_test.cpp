// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/profile/profile.hpp>

#include <numbers>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

namespace profile_test {

using namespace fstiff;

TEMPLATE_TEST_CASE("The rms height of a sine over whole periods is its amplitude over the root of 2", "",
                   FSTIFF_SCALARS) {
    using T = TestType;
    for (const T amplitude : {T(1e-15), T(1e-6), T(1e12)}) {
        Profile<T> profile{std::vector<T>(1000), T(1e-6)};
        for (std::size_t i = 0; i < 1000; ++i)
            profile.heights[i] = amplitude * std::sin(2 * std::numbers::pi_v<T> * static_cast<T>(i) / 100);
        CHECK(test::ulps(rms_height(profile), amplitude / std::numbers::sqrt2_v<T>) <= 20);
    }
}

TEST_CASE("An offset of 1e6 times the roughness costs the rms height no digit that the data still hold") {
    Profile<double> profile{std::vector<double>(4000), 1e-6};
    for (std::size_t i = 0; i < 4000; ++i)
        profile.heights[i] = 1.0 + 1e-6 * static_cast<double>((i * 7919) % 4000) / 4000;
    long double mean = 0, squares = 0;  // the same doubles, summed in long double
    for (const double z : profile.heights) mean += z;
    mean /= 4000;
    for (const double z : profile.heights) squares += (z - mean) * (z - mean);
    CHECK(test::relative_error(rms_height(profile), static_cast<double>(std::sqrt(squares / 4000))) < 1e-13);
    CHECK(test::ulps(detail::mean_height(profile), static_cast<double>(mean)) <= 1);
}

TEST_CASE("Missing points count neither in the mean nor in the rms height") {
    const double missing = std::numeric_limits<double>::quiet_NaN();
    const Profile<double> profile{{1, missing, 3, missing}, 1.0};
    CHECK(profile.size() == 4);
    CHECK(profile.present() == 2);
    CHECK(profile.length() == 3.0);
    CHECK(detail::mean_height(profile) == 2.0);
    CHECK(rms_height(profile) == 1.0);
    CHECK_FALSE(test::refusal([&] { (void)detail::mean_height(Profile<double>{{missing}, 1.0}); }).empty());
}

TEST_CASE("A profile that is too short, constant, infinite or without spacing is refused") {
    const auto refusal = [](Profile<double> profile) { return test::refusal([&] { profile.validate(16); }); };
    Profile<double> good{std::vector<double>(16, 0.0), 1e-6};
    CHECK(refusal(good).find("constant height = 0") != std::string::npos);
    good.heights[3] = 1;
    CHECK(refusal(good).empty());
    Profile<double> bad = good;
    bad.heights[5] = std::numeric_limits<double>::quiet_NaN();
    CHECK(refusal(bad).find("15 points: must be at least 16") != std::string::npos);
    bad = good;
    bad.heights[5] = std::numeric_limits<double>::infinity();
    CHECK(refusal(bad).find("height = inf") != std::string::npos);
    for (const double spacing :
         {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        bad = good;
        bad.spacing = spacing;
        CHECK(refusal(bad).find("spacing = ") != std::string::npos);
    }
}

}  // namespace profile_test
