// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Fractional Brownian motion, whose structure function is exactly n^(2H): sums of fractional Gaussian noise made by
// circulant embedding (Davies, Harte, Biometrika 74 (1987) 95-101). Shares nothing with the library: the transform is
// the ten lines below, and the random numbers are the same on every platform.
#include "support/normal.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace test {

/// Discrete Fourier transform of a power of two of numbers, by halves.
inline void transform(std::vector<std::complex<double>>& a) {
    const std::size_t size = a.size();
    if (size < 2) return;
    std::vector<std::complex<double>> even(size / 2), odd(size / 2);
    for (std::size_t k = 0; k < size / 2; ++k) {
        even[k] = a[2 * k];
        odd[k] = a[2 * k + 1];
    }
    transform(even);
    transform(odd);
    for (std::size_t k = 0; k < size / 2; ++k) {
        const auto turned =
            std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(size)) * odd[k];
        a[k] = even[k] + turned;
        a[k + size / 2] = even[k] - turned;
    }
}

/// \p points heights with mean (z_(i+n) - z_i)^2 = n^(2 \p hurst). \p points must be a power of two.
inline std::vector<double> fractional_brownian(std::size_t points, double hurst, std::uint64_t seed) {
    const std::size_t size = 2 * points;
    const auto covariance = [&](std::size_t k) {
        const double n = static_cast<double>(k), power = 2 * hurst;
        return (std::pow(n + 1, power) + std::pow(std::abs(n - 1), power) - 2 * std::pow(n, power)) / 2;
    };
    std::vector<std::complex<double>> eigenvalue(size), noise(size);
    for (std::size_t k = 0; k < size; ++k) eigenvalue[k] = covariance(k <= points ? k : size - k);
    transform(eigenvalue);
    Normal normal(seed);
    for (std::size_t k = 0; k < size; ++k) {
        const double real = normal(), imaginary = normal();
        noise[k] = std::sqrt(std::max(0.0, eigenvalue[k].real()) / static_cast<double>(size)) *
                   std::complex<double>(real, imaginary);
    }
    transform(noise);
    std::vector<double> heights(points);
    double height = 0;
    for (std::size_t k = 0; k < points; ++k) heights[k] = height += noise[k].real();
    return heights;
}

}  // namespace test
