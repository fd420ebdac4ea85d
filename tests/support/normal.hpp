// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Standard normal numbers that are the same with every standard library (std::normal_distribution's are not),
// and a walk.
#include <fstiff/profile/profile.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

namespace test {

/// Box, Muller 1958.
class Normal {
public:
    explicit Normal(std::uint64_t seed) : random_(seed) {}
    double operator()() {
        const double radius = std::sqrt(-2 * std::log(1 - uniform()));
        return radius * std::cos(2 * std::numbers::pi * uniform());
    }

private:
    double uniform() { return std::ldexp(static_cast<double>(random_() >> 11), -53); }
    std::mt19937_64 random_;
};

/// Steps of 10 nm rms at every um.
inline fstiff::Profile<double> random_walk(std::size_t points, std::uint64_t seed) {
    Normal normal(seed);
    fstiff::Profile<double> profile{std::vector<double>(points), 1e-6};
    double height = 0;
    for (double& z : profile.heights) z = height += 1e-8 * normal();
    return profile;
}

}  // namespace test
