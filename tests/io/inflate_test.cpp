// SPDX-License-Identifier: BSD-3-Clause
#include "io/unpack.hpp"

#include "support/catch.hpp"

#include <string>

namespace inflate_test {

using namespace fstiff;
using namespace std::string_literals;

namespace {

// RFC 1950: the header 78 01, one stored block (RFC 1951, 3.2.4) and the Adler-32 of "abc"
const std::string stored = "\x78\x01\x01\x03\x00\xFC\xFF"s + "abc" + "\x02\x4D\x01\x27";

std::string inflated(const std::string& stream, std::size_t size) {
    std::string out(size, '?');
    return io::detail::inflate_zlib(stream, out) ? out : "refused";
}

}  // namespace

TEST_CASE("A zlib stream laid out by hand inflates to its bytes") { CHECK(inflated(stored, 3) == "abc"); }

TEST_CASE("A stream that holds more or fewer bytes, is cut short or damaged is refused") {
    CHECK(inflated(stored, 2) == "refused");
    CHECK(inflated(stored, 4) == "refused");
    CHECK(inflated(stored, 0) == "refused");
    for (std::size_t size = 0; size < stored.size(); ++size) CHECK(inflated(stored.substr(0, size), 3) == "refused");
    std::string damaged = stored;
    damaged[8] = 'x';  // the check sum differs
    CHECK(inflated(damaged, 3) == "refused");
}

}  // namespace inflate_test
