// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/peaks/peak_distribution.hpp>
#include <fstiff/profile/peak_statistics.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <numbers>
#include <random>

namespace peak_statistics_test {

using namespace fstiff;

namespace {

/// Gaussian ordinates z_i = rho z_(i-1) + noise: an exponential autocorrelation, rho2 = rho1^2.
Profile<double> exponential_profile(double rho, std::size_t points, unsigned seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return (static_cast<double>(random() >> 11) + 0.5) / 9007199254740992.0; };
    const auto gaussian = [&] {
        return std::sqrt(-2 * std::log(uniform())) * std::cos(2 * std::numbers::pi * uniform());
    };
    Profile<double> profile{std::vector<double>(points), 2e-7};
    double z = gaussian();
    for (double& height : profile.heights) {
        height = 1e-6 * z;
        z = rho * z + std::sqrt(1 - rho * rho) * gaussian();
    }
    return profile;
}

}  // namespace

TEMPLATE_TEST_CASE("The statistics of three ordinates obey their identities on any profile", "", FSTIFF_SCALARS) {
    using T = TestType;
    const auto source = exponential_profile(0.8, 5000, 1);
    Profile<T> profile{{}, static_cast<T>(source.spacing)};
    for (const double z : source.heights) profile.heights.push_back(static_cast<T>(z));
    const auto s = peak_statistics(profile);
    const T h = profile.spacing, sigma = s.rms_height, sine = std::sin(s.theta), sine2 = std::sin(2 * s.theta);
    const T close = 100 * std::numeric_limits<T>::epsilon();
    CHECK(test::relative_error(s.rms_slope * s.rms_slope, 2 * sigma * sigma * (1 - s.rho1) / (h * h)) < close);
    CHECK(test::relative_error(s.rms_curvature * s.rms_curvature / (sigma * sigma) * h * h * h * h,
                               6 - 8 * s.rho1 + 2 * s.rho2) < close);
    CHECK(test::relative_error(s.r, s.rms_slope * s.rms_slope / (sigma * s.rms_curvature)) < close);
    CHECK(test::relative_error(sine, h * s.rms_curvature / (2 * s.rms_slope)) < close);
    CHECK(std::abs(s.rho1 - (1 - 2 * s.r * s.r * sine * sine)) < close);
    CHECK(std::abs(s.rho2 - (1 - 2 * s.r * s.r * sine2 * sine2)) < close);
    CHECK(s.triples == 4998);
}

TEST_CASE("An exponential autocorrelation comes back, and (4.3) counts its peaks") {
    for (const double rho : {0.2, 0.5, 0.9}) {
        CAPTURE(rho);
        const auto s = peak_statistics(exponential_profile(rho, 200000, 2));
        // sampling errors of an autocorrelation of 200000 points: about 1/sqrt(200000) times sqrt((1+rho^2)/(1-rho^2))
        CHECK(std::abs(s.rho1 - rho) < 0.02);
        CHECK(std::abs(s.rho2 - rho * rho) < 0.02);
        const double cot = 1 / std::tan(s.theta);
        CHECK(std::abs((1 - s.r * s.r) - cot * cot) < 0.03);
        // a binomial of 200000 trials: 0.001
        CHECK(std::abs(s.counted_peak_ratio - s.peak_ratio()) < 0.005);
        CHECK(test::relative_error(s.peaks_per_length, s.counted_peak_ratio / 2e-7) < 1e-15);
        const auto from_rho = PeakDistribution<double>::from_autocorrelation(s.rho1, s.rho2);
        CHECK(test::relative_error(from_rho.r(), s.r) < 1e-12);
        CHECK(test::relative_error(from_rho.theta(), s.theta) < 1e-12);
    }
}

TEST_CASE("A profile worked by hand gives the numbers of the hand") {
    // 0 1 0 1 0 1 ... with one step of 2: zigzag, but not quite
    Profile<double> profile{{0, 1, 0, 1, 0, 1, 0, 1, 2, 1, 0, 1, 0, 1, 0, 1, 0}, 1.0};
    const auto s = peak_statistics(profile);
    CHECK(s.triples == 15);
    // every difference is 1; the second difference is 2 but for the ordinates at 7 and 9, where it is 0
    CHECK(test::relative_error(s.rms_slope, 1.0) < 1e-15);
    CHECK(test::relative_error(s.rms_curvature, std::sqrt(4.0 * 13 / 15)) < 1e-15);
    CHECK(test::relative_error(s.theta, std::asin(std::sqrt(13.0 / 15))) < 1e-14);
    CHECK(test::relative_error(s.counted_peak_ratio, 7.0 / 15) < 1e-15);
}

TEST_CASE("Triples with a missing point are left out") {
    auto profile = exponential_profile(0.5, 1000, 3);
    profile.heights[100] = std::numeric_limits<double>::quiet_NaN();
    CHECK(peak_statistics(profile).triples == 995);
    for (std::size_t i = 0; i < 1000; i += 2) profile.heights[i] = std::numeric_limits<double>::quiet_NaN();
    CHECK_FALSE(test::refusal([&] { (void)peak_statistics(profile); }).empty());
}

TEST_CASE("r and theta do not depend on the unit of length") {
    auto profile = exponential_profile(0.7, 3000, 4);
    const auto s = peak_statistics(profile);
    for (const double unit : {1e-9, 1e9}) {
        auto scaled = profile;
        for (double& z : scaled.heights) z *= unit;
        scaled.spacing *= unit;
        const auto t = peak_statistics(scaled);
        CHECK(test::relative_error(t.r, s.r) < 1e-14);
        CHECK(test::relative_error(t.theta, s.theta) < 1e-14);
        CHECK(test::relative_error(t.rms_curvature * unit, s.rms_curvature) < 1e-14);
        CHECK(t.counted_peak_ratio == s.counted_peak_ratio);
    }
}

TEST_CASE("Profiles whose statistics leave the range of the peak density are refused") {
    Profile<double> zigzag{std::vector<double>(40), 1.0}, straight = zigzag, flat = zigzag;
    Profile<double> sine{std::vector<double>(42), 1.0};
    for (std::size_t i = 0; i < 40; ++i) {
        zigzag.heights[i] = i % 2 == 0 ? 1 : -1;
        straight.heights[i] = static_cast<double>(i);
    }
    for (std::size_t i = 0; i < 42; ++i)
        sine.heights[i] = std::sin(2 * std::numbers::pi * static_cast<double>(i) / 4 + 0.3);
    const auto refusal = [](const Profile<double>& profile) {
        return test::refusal([&] { (void)peak_statistics(profile); });
    };
    CHECK(refusal(zigzag).find("sin(theta)") != std::string::npos);
    CHECK(refusal(straight).find("sin(theta)") != std::string::npos);
    CHECK(refusal(flat).find("constant") != std::string::npos);
    CHECK(refusal({{1, 2, 1}, 1.0}).find("3 points") != std::string::npos);
    // one sine has r = 1, but for the ends of the profile: with 42 points 1.0009, with 41 0.99975
    CHECK(refusal(sine).find("r of the profile = 1.0008") != std::string::npos);
    sine.heights.pop_back();
    CHECK(std::abs(peak_statistics(sine).r - 0.99975) < 1e-6);
}

}  // namespace peak_statistics_test
