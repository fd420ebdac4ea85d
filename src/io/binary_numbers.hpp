// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Numbers in the bytes of a file, of either byte order on every host.
///
/// Valid       1 to 8 bytes; of floating-point numbers (IEEE 754) 4 or 8

#include <bit>
#include <cstdint>
#include <string_view>

namespace fstiff::inline v0_1::io::detail {

/// The unsigned integer that \p bytes are, the most significant first when \p big.
std::uint64_t unsigned_at(std::string_view bytes, bool big);

/// The same of two's complement.
std::int64_t signed_at(std::string_view bytes, bool big);

/// The floating-point number in the 4 or 8 \p bytes.
double real_at(std::string_view bytes, bool big);

/// The number that \p bytes are: floating-point for the \p kind 'f', an integer with a sign for 'i', without for 'u'.
double value_at(std::string_view bytes, char kind, bool big);

/// The unsigned integer in the first sizeof(T) bytes, the least significant first.
template <class T>
T little_endian(std::string_view bytes) {
    return static_cast<T>(unsigned_at(bytes.substr(0, sizeof(T)), false));
}
double double_at(std::string_view bytes);
float float_at(std::string_view bytes);

}  // namespace fstiff::inline v0_1::io::detail
