// SPDX-License-Identifier: BSD-3-Clause
// Noise that was added to self-affine maps is found again; maps without it have none to speak of.
#include <fstiff/topography/map_spectrum.hpp>

#include <fstiff/synthetic/self_affine.hpp>
#include <fstiff/topography/white_noise.hpp>

#include "support/accuracy.hpp"
#include "support/catch.hpp"

#include <random>

namespace map_noise_test {

using fstiff::HeightMap;

HeightMap<double> rough(double hurst, std::uint64_t seed) {
    return fstiff::self_affine_map<double>({.hurst = hurst, .rms = 1e-6, .longest_wavelength = 128e-6, .seed = seed},
                                           256, 256, 1e-6, 1e-6);
}

double found_in(const HeightMap<double>& map) {
    return fstiff::detail::white_noise(fstiff::map_spectrum(map, fstiff::Edges::periodic), map.dx, map.dy);
}

TEST_CASE("White noise in a map is found by its spectrum") {
    for (const double hurst : {0.6, 0.8, 0.95})
        for (const double noise : {0.03e-6, 0.1e-6})
            for (const std::uint64_t seed : {3u, 4u}) {
                HeightMap<double> map = rough(hurst, seed);
                std::mt19937_64 random(seed);
                std::normal_distribution<double> normal(0, noise);
                for (double& z : map.heights.reshaped()) z += normal(random);
                INFO(hurst << " " << noise);
                // of H = 0.6 the surface itself has as much as 3 % of noise at the shortest waves
                const bool hidden = hurst < 0.7 && noise < 0.05e-6;
                CHECK(test::relative_error(found_in(map), noise) < (hidden ? 0.5 : 0.15));
            }
}

TEST_CASE("A surface whose spectrum falls as a power has no noise") {
    for (const double hurst : {0.3, 0.5, 0.8, 0.99})
        for (const std::uint64_t seed : {5u, 6u, 7u}) CHECK(found_in(rough(hurst, seed)) < 0.015e-6);
}

TEST_CASE("The gradient of noise is that of its waves") {
    // of all waves of a rectangle the mean of q^2 is (x^2 + y^2)/3, x and y its half sides
    HeightMap<double> map;
    map.dx = 1e-6, map.dy = 2e-6, map.heights.setZero(128, 256);
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal(0, 1e-8);
    for (double& z : map.heights.reshaped()) z = normal(random);
    const double of_waves = fstiff::map_spectrum(map, fstiff::Edges::periodic).rms_gradient();
    CHECK(test::relative_error(fstiff::detail::gradient_of_noise(1e-8, map.dx, map.dy), of_waves) < 0.02);
}

}  // namespace map_noise_test
