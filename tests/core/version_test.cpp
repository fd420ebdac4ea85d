// SPDX-License-Identifier: BSD-3-Clause
// The version is written once as numbers and once as text: both say the same.
#include <fstiff/core/version.hpp>

#include "support/catch.hpp"

#include <string>

namespace version_test {

TEST_CASE("the version text is made of the version numbers", "[version]") {
    CHECK(std::string(FSTIFF_VERSION) == std::to_string(FSTIFF_VERSION_MAJOR) + "." +
                                             std::to_string(FSTIFF_VERSION_MINOR) + "." +
                                             std::to_string(FSTIFF_VERSION_PATCH));
}

}  // namespace version_test
