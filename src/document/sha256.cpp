// SPDX-License-Identifier: BSD-3-Clause
#include "document/file.hpp"

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

/// One round: \p d and \p h change, and are called e and a in the next. \p added is its constant and its word.
inline void one_round(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t& d, std::uint32_t e,
                      std::uint32_t f, std::uint32_t g, std::uint32_t& h, std::uint32_t added) {
    const auto s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
    const auto t1 = h + s1 + ((e & f) ^ (~e & g)) + added;
    const auto s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
    d += t1;
    h = t1 + s0 + ((a & b) ^ (a & c) ^ (b & c));
}

}  // namespace

std::string sha256(std::string_view text) {
    constexpr auto round_constants = root_fractions<64>(3);
    auto state = root_fractions<8>(2);

    const std::size_t whole =
        text.size() - text.size() % 64;  // without a copy: the text may be as long as memory allows
    std::string padded(text.substr(whole));
    padded += '\x80';
    padded.append((120 - padded.size() % 64) % 64, '\0');
    const std::uint64_t bits = std::uint64_t(text.size()) * 8;
    for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(static_cast<unsigned char>(bits >> shift));

    for (std::size_t block = 0; block < whole + padded.size(); block += 64) {
        const char* const bytes = block < whole ? text.data() + block : padded.data() + (block - whole);
        std::array<std::uint32_t, 64> w;
        const auto byte = [&](std::size_t i) { return std::uint32_t(static_cast<unsigned char>(bytes[i])); };
        for (std::size_t i = 0; i < 16; ++i)
            w[i] = byte(4 * i) << 24 | byte(4 * i + 1) << 16 | byte(4 * i + 2) << 8 | byte(4 * i + 3);
        for (std::size_t i = 16; i < 64; ++i) {
            const auto s0 = std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ (w[i - 15] >> 3);
            const auto s1 = std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ (w[i - 2] >> 10);
            w[i] = w[i - 16] + s0 + w[i - 7] + s1;
        }
        auto [a, b, c, d, e, f, g, h] = state;
        // the letters move on by one a round, so that after eight rounds each stands where it was
        for (std::size_t i = 0; i < 64; i += 8) {
            one_round(a, b, c, d, e, f, g, h, round_constants[i] + w[i]);
            one_round(h, a, b, c, d, e, f, g, round_constants[i + 1] + w[i + 1]);
            one_round(g, h, a, b, c, d, e, f, round_constants[i + 2] + w[i + 2]);
            one_round(f, g, h, a, b, c, d, e, round_constants[i + 3] + w[i + 3]);
            one_round(e, f, g, h, a, b, c, d, round_constants[i + 4] + w[i + 4]);
            one_round(d, e, f, g, h, a, b, c, round_constants[i + 5] + w[i + 5]);
            one_round(c, d, e, f, g, h, a, b, round_constants[i + 6] + w[i + 6]);
            one_round(b, c, d, e, f, g, h, a, round_constants[i + 7] + w[i + 7]);
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
