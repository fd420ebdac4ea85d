// SPDX-License-Identifier: BSD-3-Clause
#include "document/file.hpp"

#include "io/lines.hpp"

#include <fstiff/core/names.hpp>
#include <fstiff/core/text.hpp>
#include <fstiff/io/quantities.hpp>
#include <fstiff/io/units.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace fstiff::document {

namespace {

std::string number(double value, int digits) {
    if (!std::isfinite(value)) throw std::logic_error("a result is not a finite number; this is a defect of fstiff");
    return detail::rounded_text(value, digits);
}

/// \p text, which may be "1.1e+02", as "110"; with an exponent of 5 and more as it is.
std::string without_small_exponent(std::string text) {
    const std::size_t e = text.find("e+0");
    if (e == std::string::npos || e + 4 != text.size() || text.back() > '4') return text;
    const auto exponent = static_cast<std::size_t>(text.back() - '0');
    const std::size_t first = text.find_first_not_of('-'), point = text.find('.');
    text.resize(e);
    if (point != std::string::npos) text.erase(point, 1);
    text.resize(first + exponent + 1, '0');
    return text;
}

}  // namespace

std::filesystem::path output_target(const std::string& file) {
    namespace fs = std::filesystem;
    std::error_code error;
    fs::path path = fs::absolute(path_of(file));
    for (int links = 0; !fs::exists(path, error) && fs::is_symlink(fs::symlink_status(path, error)); ++links) {
        if (links == 40)
            throw file_error(
                file, "cannot be written: " + std::make_error_code(std::errc::too_many_symbolic_link_levels).message());
        path = path.parent_path() / fs::read_symlink(path, error);
    }
    const fs::path target = fs::weakly_canonical(path, error);
    return error ? path : target;
}

std::string read_all(const std::string& file, std::uint64_t enough) {
    std::string bytes;
    if (file == "-") {
        io::detail::append_bytes(std::cin, "standard input", bytes, enough);
    } else {
        std::error_code error;
        const std::filesystem::path path = path_of(file);
        if (!std::filesystem::exists(path, error))
            throw file_error(file, error == std::errc::too_many_symbolic_link_levels
                                       ? "is a link that leads to itself; the input must be an existing file"
                                   : std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))
                                       ? "is a link to a file that is not there; the input must be an existing file"
                                       : "no such file; the input must be an existing file");
        if (std::filesystem::is_directory(path, error)) throw file_error(file, "is a folder; the input must be a file");
        const std::uintmax_t size =
            std::filesystem::is_regular_file(path, error) ? std::filesystem::file_size(path, error) : 0;
        if (!error && size <= enough) bytes.reserve(static_cast<std::size_t>(size));
        if (!io::detail::append_file(path, file, bytes, enough))
            throw file_error(file, "cannot be read; the input must be a readable file");
    }
    if (bytes.find_first_not_of(" \t\r\n") == std::string::npos)
        throw domain_error(display_name(file) + ": is empty; the input must hold text");
    return bytes;
}

std::string display_name(const std::string& file) { return file == "-" ? "standard input" : file; }

double parse_positive(const std::string& text, io::Dimension dimension, std::string_view name) {
    const double value = io::parse_quantity(text, dimension, name);
    if (!(value > 0))  // it is finite
        throw domain_error({.parameter = name, .value = "\"" + text + "\"", .allowed = "greater than 0"});
    return value;
}

bool is_control(std::string_view character) {
    const auto byte = static_cast<unsigned char>(character[0]);
    return byte < 0x20 || byte == 0x7f ||
           (character.size() == 2 && byte == 0xc2 && static_cast<unsigned char>(character[1]) < 0xa0) ||
           (character >= "\u200E" && character <= "\u200F") || (character >= "\u2028" && character <= "\u202E") ||
           (character >= "\u2066" && character <= "\u2069");
}

std::string printable(std::string_view text, std::string_view kept) {
    std::string shown;
    shown.reserve(text.size());
    for (std::size_t place = 0; place < text.size();) {
        const std::size_t length = io::detail::utf8_length(text.substr(place));
        const std::string_view character = text.substr(place, std::max<std::size_t>(length, 1));
        if (length == 0)
            shown += "\uFFFD";
        else if (is_control(character) && kept.find(character) == std::string_view::npos)
            shown += ' ';
        else
            shown += character;
        place += character.size();
    }
    return shown;
}

std::string exact(double value) { return number(value, 17); }
std::string rounded(double value, int digits) { return without_small_exponent(number(value, digits)); }
std::string shortest(double value) { return detail::shortest_text(value); }

namespace {

/// How many letters must be put in, left out, replaced or swapped with their neighbour to make \p a of \p b.
std::size_t edits(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

}  // namespace

std::string_view nearest_word(std::string_view wrong, std::span<const std::string_view> words) {
    for (const std::string_view word : words)
        if (detail::is_same_name(wrong, word)) return word;
    constexpr std::size_t shortest = 4, longest = 64;  // of a word that somebody mistyped
    if (wrong.size() < shortest || wrong.size() > longest) return {};
    std::size_t least = (wrong.size() + 1) / 3 + 1;
    std::string_view nearest;
    for (const std::string_view word : words)
        if (const std::size_t distance = edits(wrong, word); distance < least) least = distance, nearest = word;
    return nearest;
}

std::string suggestion(std::string_view wrong, const std::vector<std::string>& words) {
    const std::string_view nearest = nearest_word(wrong, std::vector<std::string_view>(words.begin(), words.end()));
    return nearest.empty() ? "" : " (did you mean " + std::string(nearest) + "?)";
}

std::string list_and_suggestion(std::string_view wrong, std::span<const std::string_view> words) {
    return list_of(words) + suggestion(wrong, {words.begin(), words.end()});
}

std::string list_of(std::span<const std::string_view> items) {
    std::string text;
    for (const auto item : items) text += (text.empty() ? "\"" : ", \"") + std::string(item) + "\"";
    return text;
}

namespace {

// The first 32 bits of the fractional parts of the square roots of the first 8 primes, and of the cube roots of the
// first 64.
constexpr std::array<std::uint32_t, 8> first_state{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                                   0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
constexpr std::array<std::uint32_t, 64> round_constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

}  // namespace

std::string sha256(std::string_view text) {
    auto state = first_state;
    const std::size_t in_blocks =
        text.size() - text.size() % 64;  // without a copy: the text may be as long as memory allows
    std::string padded(text.substr(in_blocks));
    padded += '\x80';
    padded.append((120 - padded.size() % 64) % 64, '\0');
    const std::uint64_t bits = std::uint64_t(text.size()) * 8;
    for (int shift = 56; shift >= 0; shift -= 8) padded += static_cast<char>(static_cast<unsigned char>(bits >> shift));

    for (std::size_t block = 0; block < in_blocks + padded.size(); block += 64) {
        const char* const bytes = block < in_blocks ? text.data() + block : padded.data() + (block - in_blocks);
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
        for (std::size_t i = 0; i < 64; ++i) {
            const auto s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
            const auto s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
            const auto t1 = h + s1 + ((e & f) ^ (~e & g)) + round_constants[i] + w[i];
            h = g, g = f, f = e, e = d + t1;
            const auto t2 = s0 + ((a & b) ^ (a & c) ^ (b & c));
            d = c, c = b, b = a, a = t1 + t2;
        }
        const std::array<std::uint32_t, 8> add{a, b, c, d, e, f, g, h};
        for (std::size_t i = 0; i < 8; ++i) state[i] += add[i];
    }

    std::string hex;
    for (const auto word : state)
        for (int shift = 28; shift >= 0; shift -= 4) hex += "0123456789abcdef"[word >> shift & 15];
    return hex;
}

}  // namespace fstiff::document
