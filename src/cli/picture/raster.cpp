// SPDX-License-Identifier: BSD-3-Clause
// Maps of heights as BMP, which every browser shows.
#include "picture/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace fstiff::cli {
namespace {

std::string little_endian(std::uint32_t value, int bytes) {
    std::string text;
    for (; bytes > 0; --bytes, value >>= 8) text += static_cast<char>(static_cast<unsigned char>(value));
    return text;
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

std::string heat_map_bmp(const std::vector<unsigned char>& shade, std::size_t columns, std::size_t rows) {
    constexpr std::uint32_t begin = 14 + 40 + 4 * 256;  // file header, image header, colours
    const std::size_t width = (columns + 3) / 4 * 4;
    std::string out = "BM" + little_endian(begin + static_cast<std::uint32_t>(width * rows), 4) + little_endian(0, 4) +
                      little_endian(begin, 4);
    const auto [across, up] = std::pair(static_cast<std::uint32_t>(columns), static_cast<std::uint32_t>(rows));
    for (const std::uint32_t number : {40u, across, up, 1u | 8u << 16, 0u, 0u, 0u, 0u, 256u, 0u})
        out += little_endian(number, 4);  // one plane of 8 bits, indexed, not compressed
    for (int i = 0; i < 255; ++i)
        for (const auto [red, green, blue] = heat(i / 254.0); const int value : {blue, green, red, 0})
            out += static_cast<char>(static_cast<unsigned char>(value));
    out += little_endian(0x808080, 4);  // missing points are grey
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) out += static_cast<char>(shade[j * columns + i]);
        out.append(width - columns, '\0');
    }
    return out;
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
