// SPDX-License-Identifier: BSD-3-Clause
#include "io/binary_numbers.hpp"

namespace fstiff::inline v0_1::io::detail {

std::uint64_t unsigned_at(std::string_view bytes, bool big) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        value = value << 8 | static_cast<unsigned char>(bytes[big ? i : bytes.size() - 1 - i]);
    return value;
}

std::int64_t signed_at(std::string_view bytes, bool big) {
    const auto unused = static_cast<int>(64 - 8 * bytes.size());
    return static_cast<std::int64_t>(unsigned_at(bytes, big) << unused) >> unused;
}

double real_at(std::string_view bytes, bool big) {
    const std::uint64_t bits = unsigned_at(bytes, big);
    return bytes.size() == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                             : std::bit_cast<double>(bits);
}

double value_at(std::string_view bytes, char kind, bool big) {
    return kind == 'f'   ? real_at(bytes, big)
           : kind == 'i' ? static_cast<double>(signed_at(bytes, big))
                         : static_cast<double>(unsigned_at(bytes, big));
}

double double_at(std::string_view bytes) { return real_at(bytes.substr(0, 8), false); }
float float_at(std::string_view bytes) { return std::bit_cast<float>(little_endian<std::uint32_t>(bytes)); }

}  // namespace fstiff::inline v0_1::io::detail
