// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Numbers in the bytes of a file, of either byte order on every host. All of it is internal.
///
/// Valid       1 to 8 bytes; of numbers of floating point (IEEE 754) 4 or 8

#include <bit>
#include <cstdint>
#include <string_view>

namespace fstiff::io::detail {

/// The unsigned integer that \p bytes are, the most significant first when \p big.
inline std::uint64_t unsigned_at(std::string_view bytes, bool big) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[big ? i : bytes.size() - 1 - i]);
    return value;
}

/// The same of two's complement.
inline std::int64_t signed_at(std::string_view bytes, bool big) {
    const auto unused = static_cast<int>(64 - 8 * bytes.size());
    return static_cast<std::int64_t>(unsigned_at(bytes, big) << unused) >> unused;
}

/// The number of floating point that the 4 or 8 \p bytes are.
inline double real_at(std::string_view bytes, bool big) {
    const std::uint64_t bits = unsigned_at(bytes, big);
    return bytes.size() == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                             : std::bit_cast<double>(bits);
}

/// The unsigned integer in the first sizeof(T) bytes, the least significant first.
template <class T>
T little_endian(std::string_view bytes) {
    return static_cast<T>(unsigned_at(bytes.substr(0, sizeof(T)), false));
}
inline double double_at(std::string_view bytes) { return real_at(bytes.substr(0, 8), false); }
inline float float_at(std::string_view bytes) { return std::bit_cast<float>(little_endian<std::uint32_t>(bytes)); }

}  // namespace fstiff::io::detail
