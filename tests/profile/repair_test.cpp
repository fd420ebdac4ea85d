// SPDX-License-Identifier: BSD-3-Clause
// Spikes are found where they were put, roughness is left alone; missing points are filled by lines.
#include <fstiff/profile/profile.hpp>
#include <fstiff/profile/profile_repair.hpp>

#include "support/catch.hpp"
#include "support/fractional_brownian.hpp"

#include <random>

namespace repair_test {

using namespace fstiff;

/// A neighbour of a spike may go with it where the roughness is smooth: its median has the spike among four.
TEST_CASE("Spikes that were put into a profile are taken out and hardly any other point") {
    for (const double hurst : {0.2, 0.5, 0.8}) {
        Profile<double> profile{test::fractional_brownian(4096, hurst, 11), 1e-6};
        const auto clean = profile.heights;
        for (std::size_t i = 100; i < 4096; i += 200) profile.heights[i] += i % 400 == 100 ? 30 : -30;
        const std::size_t found = detail::find_spikes(profile, 5, false).removed;
        CHECK(found >= 20);
        CHECK(found <= 22);
        CHECK(detail::find_spikes(profile, 5).removed == found);
        for (std::size_t i = 100; i < 4096; i += 200) CHECK(std::isnan(profile.heights[i]));
        CHECK(detail::fill_missing(profile).missing == found);
        for (std::size_t i = 100; i < 4096; i += 200) CHECK(std::abs(profile.heights[i] - clean[i]) < 3);
    }
}

TEST_CASE("Less than 1e-4 of Gaussian and of self-affine roughness counts as spikes") {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    Profile<double> noise{std::vector<double>(100000), 1e-6};
    for (double& z : noise.heights) z = normal(random);
    CHECK(detail::find_spikes(noise, 5, false).removed < 10);
    for (const double hurst : {0.2, 0.5, 0.8})
        for (unsigned seed = 1; seed <= 5; ++seed) {
            Profile<double> rough{test::fractional_brownian(16384, hurst, seed), 1e-6};
            CHECK(detail::find_spikes(rough, 5, false).removed < 2);
        }
}

TEST_CASE("Gaps of a profile are filled by straight lines, its ends by the nearest height") {
    const double nan = std::nan("");
    Profile<double> profile{{nan, nan, 1, nan, nan, nan, 9, 4, nan}, 1e-6};
    const auto repair = detail::fill_missing(profile);
    CHECK(repair.missing == 6);
    CHECK(repair.longest == 3);
    CHECK(profile.heights == std::vector<double>{1, 1, 1, 3, 5, 7, 9, 4, 4});
    Profile<double> none{{nan, nan, nan, nan, nan}, 1e-6};
    CHECK_THROWS_AS(detail::fill_missing(none), domain_error);
    CHECK_THROWS_AS(detail::find_spikes(profile, 0), domain_error);
}

}  // namespace repair_test
