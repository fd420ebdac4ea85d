// SPDX-License-Identifier: BSD-3-Clause
// The version is written as numbers, as one number, as text, and again for C: all are equal.
#include <fstiff/core/version.hpp>
constexpr int version_of_headers = FSTIFF_VERSION;
#undef FSTIFF_VERSION
#include <fstiff.h>

#include "support/catch.hpp"

#include <string>

namespace version_test {

TEST_CASE("the version text is made of the version numbers", "[version]") {
    CHECK(std::string(FSTIFF_VERSION_TEXT) == std::to_string(FSTIFF_VERSION_MAJOR) + "." +
                                                  std::to_string(FSTIFF_VERSION_MINOR) + "." +
                                                  std::to_string(FSTIFF_VERSION_PATCH));
}

TEST_CASE("the version number is made of the version numbers, in fstiff.h too", "[version]") {
    CHECK(FSTIFF_VERSION == 10000 * FSTIFF_VERSION_MAJOR + 100 * FSTIFF_VERSION_MINOR + FSTIFF_VERSION_PATCH);
    CHECK(FSTIFF_VERSION == version_of_headers);
}

}  // namespace version_test
