// SPDX-License-Identifier: BSD-3-Clause
// Maps of heights as PNG, which needs no library here.
#include "picture/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace fstiff::cli {
namespace {

std::uint32_t crc32(std::string_view bytes) {
    std::uint32_t crc = 0xFFFFFFFFu;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1u ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

std::string big_endian(std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(static_cast<unsigned char>(value >> shift));
    return bytes;
}

std::string chunk(const std::string& name, const std::string& data) {
    return big_endian(static_cast<std::uint32_t>(data.size())) + name + data + big_endian(crc32(name + data));
}

/// \p data as a zlib stream of stored blocks (RFC 1950, 1951): not smaller, but needs no library.
std::string stored(const std::string& data) {
    std::string out = "\x78\x01";
    std::uint32_t a = 1, b = 0;
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521u;
        b = (b + a) % 65521u;
    }
    for (std::size_t at = 0;;) {
        const std::size_t size = std::min<std::size_t>(65535, data.size() - at);
        const bool last = at + size == data.size();
        for (const std::size_t byte : {std::size_t(last), size & 255u, size >> 8, ~size & 255u, (~size >> 8) & 255u})
            out += static_cast<char>(static_cast<unsigned char>(byte));
        out += data.substr(at, size);
        at += size;
        if (last) break;
    }
    return out + big_endian(b << 16 | a);
}

/// Red, green, blue of a share of the range: dark blue over green to yellow, of rising lightness.
std::array<int, 3> heat(double share) {
    static constexpr std::array<std::array<double, 3>, 5> stops{
        {{38, 22, 78}, {44, 84, 134}, {38, 144, 134}, {126, 196, 84}, {250, 230, 80}}};
    const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
    const auto k = std::min<std::size_t>(static_cast<std::size_t>(at), stops.size() - 2);
    std::array<int, 3> rgb{};
    for (std::size_t i = 0; i < 3; ++i)
        rgb[i] = static_cast<int>(std::lround(std::lerp(stops[k][i], stops[k + 1][i], at - static_cast<double>(k))));
    return rgb;
}

}  // namespace

std::string heat_map_png(const std::vector<unsigned char>& shade, std::size_t columns, std::size_t rows) {
    std::string header = big_endian(static_cast<std::uint32_t>(columns)) + big_endian(static_cast<std::uint32_t>(rows));
    header += std::string("\x08\x03\x00\x00\x00", 5);  // 8 bits, indexed
    std::string colours, lines;
    for (int i = 0; i < 255; ++i)
        for (const int value : heat(i / 254.0)) colours += static_cast<char>(static_cast<unsigned char>(value));
    colours += "\x80\x80\x80";
    for (std::size_t j = 0; j < rows; ++j) {
        lines += '\0';  // no filter
        for (std::size_t i = 0; i < columns; ++i) lines += static_cast<char>(shade[j * columns + i]);
    }
    const std::string clear = std::string(255, '\xFF') + '\0';  // missing points are transparent
    return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("PLTE", colours) + chunk("tRNS", clear) +
           chunk("IDAT", stored(lines)) + chunk("IEND", "");
}

std::string base64(std::string_view bytes) {
    static constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63u];
    }
    return text;
}

}  // namespace fstiff::cli
