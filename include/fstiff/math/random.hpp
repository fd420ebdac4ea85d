// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Random numbers from a seed: the bits are the same on every platform.
///
/// Reference   Steele, Lea, Flood, OOPSLA 2014 (splitmix64, public domain); Box, Muller, Ann. Math. Stat. 29 (1958)
/// Accuracy    normal numbers to the rounding of the local log, cos and sin (tests/math/random_test.cpp)

#include <fstiff/core/concepts.hpp>

#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>

namespace fstiff::inline v0_1::math {

/// 64 well-mixed bits a call; \p state is any number at first.
constexpr std::uint64_t splitmix64(std::uint64_t& state) {
    state += 0x9E3779B97F4A7C15ULL;
    std::uint64_t bits = state;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9ULL;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBULL;
    return bits ^ (bits >> 31);
}

/// Two independent standard normal numbers.
template <Real T>
[[nodiscard]] std::complex<T> normal_pair(std::uint64_t& state) {
    const T uniform = static_cast<T>((splitmix64(state) >> 11) + 1) * T(0x1p-53L);  // in (0, 1]: its log exists
    const T turn = static_cast<T>(splitmix64(state) >> 11) * T(0x1p-53L);
    return std::polar(std::sqrt(-2 * std::log(uniform)), 2 * std::numbers::pi_v<T> * turn);
}

}  // namespace fstiff::inline v0_1::math
