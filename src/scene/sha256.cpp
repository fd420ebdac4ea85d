// SPDX-License-Identifier: BSD-3-Clause
#include "scene/file.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>

namespace fstiff::scene {

namespace {

/// The first 32 bits of the fractional part of the \p root-th root (2 or 3) of \p prime, by bisection on integers.
constexpr std::uint32_t root_fraction(std::uint64_t prime, int root) {
    __extension__ using Wide = unsigned __int128;
    // The largest x with (x / 2^32)^root <= prime; x < 2^37 for the primes up to 311.
    Wide low = 0, high = Wide(1) << 37;
    while (high - low > 1) {
        const Wide x = (low + high) / 2;
        // x^3 has up to 111 bits, prime * 2^96 up to 105.
        const bool fits = root == 2 ? x * x <= Wide(prime) << 64 : x * x * x <= Wide(prime) << 96;
        (fits ? low : high) = x;
    }
    return static_cast<std::uint32_t>(low);
}

/// Square roots (2) or cube roots (3) of the first \p N primes: the constants of the standard.
template <std::size_t N>
constexpr std::array<std::uint32_t, N> root_fractions(int root) {
    std::array<std::uint32_t, N> result{};
    std::size_t found = 0;
    for (std::uint64_t n = 2; found < N; ++n) {
        bool prime = true;
        for (std::uint64_t d = 2; d * d <= n; ++d) prime = prime && n % d != 0;
        if (prime) result[found++] = root_fraction(n, root);
    }
    return result;
}

}  // namespace

std::string sha256(std::string_view text) {
    constexpr auto round_constants = root_fractions<64>(3);
    auto state = root_fractions<8>(2);

    std::string padded(text);
    padded += '\x80';
    padded.append((120 - padded.size() % 64) % 64, '\0');
    const std::uint64_t bits = std::uint64_t(text.size()) * 8;
    for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(static_cast<unsigned char>(bits >> shift));

    for (std::size_t block = 0; block < padded.size(); block += 64) {
        std::array<std::uint32_t, 64> w{};
        for (std::size_t i = 0; i < 64; ++i) w[i / 4] = w[i / 4] << 8 | static_cast<unsigned char>(padded[block + i]);
        for (std::size_t i = 16; i < 64; ++i) {
            const auto s0 = std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ (w[i - 15] >> 3);
            const auto s1 = std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ (w[i - 2] >> 10);
            w[i] = w[i - 16] + s0 + w[i - 7] + s1;
        }
        auto [a, b, c, d, e, f, g, h] = state;
        for (std::size_t i = 0; i < 64; ++i) {
            const auto s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
            const auto t1 = h + s1 + ((e & f) ^ (~e & g)) + round_constants[i] + w[i];
            const auto s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
            const auto t2 = s0 + ((a & b) ^ (a & c) ^ (b & c));
            h = g, g = f, f = e, e = d + t1, d = c, c = b, b = a, a = t1 + t2;
        }
        const std::array<std::uint32_t, 8> add{a, b, c, d, e, f, g, h};
        for (std::size_t i = 0; i < 8; ++i) state[i] += add[i];
    }

    std::string hex;
    for (const auto word : state)
        for (int shift = 28; shift >= 0; shift -= 4) hex += "0123456789abcdef"[word >> shift & 15];
    return hex;
}

}  // namespace fstiff::scene
