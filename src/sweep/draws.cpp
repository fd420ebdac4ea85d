// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/draws.hpp"

#include <fstiff/math/normal_distribution.hpp>

#include <cmath>

namespace fstiff::sweep {

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t first = std::uint64_t(0xD2511F53) * counter[0];
        const std::uint64_t second = std::uint64_t(0xCD9E8D57) * counter[2];
        counter = {static_cast<std::uint32_t>(second >> 32) ^ counter[1] ^ key[0], static_cast<std::uint32_t>(second),
                   static_cast<std::uint32_t>(first >> 32) ^ counter[3] ^ key[1], static_cast<std::uint32_t>(first)};
        key = {key[0] + 0x9E3779B9U, key[1] + 0xBB67AE85U};
    }
    return counter;
}

double uniform_draw(std::uint64_t seed, std::uint64_t index, std::uint32_t input) {
    const auto x = philox({static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32), input, 0},
                          {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
    // 52 bits: a half more than 53 of them would be rounded, and could become 1
    const std::uint64_t bits = ((std::uint64_t(x[0]) << 32) | x[1]) >> 12;
    return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

double Distribution::quantile(double probability) const {
    if (kind == Kind::uniform) return (1 - probability) * a + probability * b;
    const double z = math::normal_quantile(probability);
    return kind == Kind::normal ? a + b * z : a * std::exp(b * z);
}

}  // namespace fstiff::sweep
