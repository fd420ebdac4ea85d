// SPDX-License-Identifier: BSD-3-Clause
#include "io/binary_numbers.hpp"

#include "support/catch.hpp"

#include <limits>

namespace binary_numbers_test {

using namespace fstiff::io::detail;
using namespace std::string_view_literals;

TEST_CASE("Integers of either byte order are those that their bytes spell") {
    CHECK(unsigned_at("\x01\x02"sv, true) == 0x0102);
    CHECK(unsigned_at("\x01\x02"sv, false) == 0x0201);
    CHECK(unsigned_at("\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFE"sv, true) == 0xFFFFFFFFFFFFFFFE);
    CHECK(signed_at("\x80"sv, true) == -128);
    CHECK(signed_at("\xFE\xFF"sv, false) == -2);
    CHECK(signed_at("\x7F\xFF\xFF\xFF"sv, true) == 2147483647);
    CHECK(signed_at("\x80\0\0\0\0\0\0\0"sv, true) == std::numeric_limits<std::int64_t>::min());
    CHECK(little_endian<std::uint16_t>("\x34\x12\xFF"sv) == 0x1234);
}

TEST_CASE("Floating-point numbers of either byte order are those of IEEE 754") {
    // 118.625 = 1.110110101 (binary) times 2^6; 1/3 = 1.0101... times 2^-2
    CHECK(real_at("\xC2\xED\x40\0"sv, true) == -118.625);
    CHECK(real_at("\0\x40\xED\xC2"sv, false) == -118.625);
    CHECK(real_at("\x3F\xD5\x55\x55\x55\x55\x55\x55"sv, true) == 1.0 / 3);
    CHECK(double_at("\x55\x55\x55\x55\x55\x55\xD5\x3F and more"sv) == 1.0 / 3);
    CHECK(float_at("\0\x40\xED\xC2 and more"sv) == -118.625F);
}

TEST_CASE("Numbers are read by their kind") {
    CHECK(value_at("\xC2\xED\x40\0"sv, 'f', true) == -118.625);
    CHECK(value_at("\xFE\xFF"sv, 'i', false) == -2);
    CHECK(value_at("\xFE\xFF"sv, 'u', false) == 65534);
}

}  // namespace binary_numbers_test
