// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Standard normal numbers that are the same with every standard library (std::normal_distribution's are not).
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

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

}  // namespace test
