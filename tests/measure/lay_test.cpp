// SPDX-License-Identifier: BSD-3-Clause
// A lay is found in profiles and maps that have one, and in few that do not.
#include <fstiff/measure/concerns.hpp>
#include <fstiff/measure/lay.hpp>
#include <fstiff/profile/autocorrelation.hpp>
#include <fstiff/synthetic/self_affine.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lay_test {

using namespace fstiff;

namespace {

SelfAffineOptions<double> rough(double hurst, double longest, std::uint64_t seed) {
    SelfAffineOptions<double> options;
    options.hurst = hurst;
    options.rms = 1e-7;
    options.shortest_wavelength = 4e-6;
    options.longest_wavelength = longest;
    options.seed = seed;
    return options;
}

/// Parabolic grooves of \p period [m] and the rms height \p rms [m].
double groove(double x, double period, double rms) {
    const double t = x / period - std::floor(x / period) - 0.5;
    return rms * std::sqrt(45.0 / 4) * (4 * t * t - 1.0 / 3);
}

}  // namespace

TEST_CASE("A profile across grooves repeats itself with their period, whatever the unit of length") {
    for (const double period : {64e-6, 230e-6, 900e-6}) {
        CAPTURE(period);
        Profile<double> profile = self_affine_profile(rough(0.8, 40e-6, 3), 4096, 1e-6);
        for (std::size_t i = 0; i < profile.size(); ++i)
            profile.heights[i] = 0.5 * profile.heights[i] + groove(double(i) * 1e-6, period, 1e-7);
        const Repetition<double> found = detail::repetition(autocorrelation(profile));
        CHECK(found.is_lay());
        const double periods = found.period / period;  // one of them, or the next, which chance may have made higher
        CHECK(std::abs(periods - std::round(periods)) < 0.05);
        for (double& z : profile.heights) z *= 1e6;
        profile.spacing *= 1e6;
        CHECK(std::abs(detail::repetition(autocorrelation(profile)).correlation - found.correlation) < 1e-12);
    }
}

TEST_CASE("A cosine repeats itself to 1 less the pairs missing in the last quarter") {
    Profile<double> wave{{}, 1e-6};
    for (int i = 0; i < 4096; ++i) wave.heights.push_back(std::cos(2 * std::numbers::pi_v<double> * i / 64));
    const Repetition<double> found = detail::repetition(autocorrelation(wave));
    CHECK(std::abs(found.correlation - (1 - 64.0 / 4096)) < 1e-12);
    CHECK(std::abs(found.period - 64e-6) < 1e-18);
}

TEST_CASE("At most 4 of 400 profiles without a lay repeat themselves") {
    int said = 0;
    for (const double hurst : {0.2, 0.5, 0.8, 0.95})
        for (const double longest : {2048e-6, 512e-6, 128e-6, 32e-6})
            for (std::uint64_t seed = 1; seed <= 25; ++seed)
                said +=
                    detail::repetition(autocorrelation(self_affine_profile(rough(hurst, longest, seed), 2048, 1e-6)))
                            .is_lay()
                        ? 1
                        : 0;
    CHECK(said <= 4);
}

TEST_CASE("Str distinguishes a map with grooves and a stretched one from an isotropic one") {
    HeightMap<double> map = self_affine_map(rough(0.8, 40e-6, 5), 128, 128, 1e-6, 1e-6);
    const double isotropic = detail::texture_aspect_ratio(map);
    CHECK(isotropic > 0.5);
    CHECK_FALSE(detail::is_lay(isotropic));
    HeightMap<double> grooved = map;
    for (Eigen::Index j = 0; j < grooved.rows(); ++j)
        for (Eigen::Index i = 0; i < grooved.columns(); ++i)
            grooved.heights(j, i) = 0.5 * map.heights(j, i) + groove(double(i) * 1e-6, 32e-6, 1e-7);
    CHECK(detail::is_lay(detail::texture_aspect_ratio(grooved)));
    grooved.heights(3, 4) = std::numeric_limits<double>::quiet_NaN();
    CHECK(detail::is_lay(detail::texture_aspect_ratio(grooved)));
    map.dy *= 6;
    CHECK(detail::is_lay(detail::texture_aspect_ratio(map)));
}

TEST_CASE("Str of a strip is that of its own points, however long it is") {
    const HeightMap<double> map = self_affine_map(rough(0.8, 40e-6, 5), 1024, 16, 1e-6, 1e-6);
    HeightMap<double> strip = map;
    for (const Eigen::Index rows : {4, 5, 9, 16}) {
        strip.heights = map.heights.topRows(rows);
        const double str = detail::texture_aspect_ratio(strip);
        CHECK(str > 0);
        CHECK(str <= 1);
        strip.heights = map.heights.topRows(rows).transpose().eval();
        CHECK(std::abs(detail::texture_aspect_ratio(strip) / str - 1) < 1e-9);
    }
    strip.heights = map.heights.topRows(3);
    CHECK(test::refusal([&] { (void)detail::texture_aspect_ratio(strip); }) ==
          "map of 1024 x 3 points: must have at least 4 a side");
}

TEST_CASE("A lay is a concern of what was measured") {
    Profile<double> profile = self_affine_profile(rough(0.8, 40e-6, 3), 2048, 1e-6);
    const auto has_lay = [](const Profile<double>& of) {
        const auto all = detail::concerns_of(detail::surface_parameters(of));
        return std::count(all.begin(), all.end(), MeasuredConcern::lay) == 1;
    };
    CHECK_FALSE(has_lay(profile));
    for (std::size_t i = 0; i < profile.size(); ++i) profile.heights[i] += groove(double(i) * 1e-6, 200e-6, 3e-7);
    CHECK(has_lay(profile));
}

}  // namespace lay_test
