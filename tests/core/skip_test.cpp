// SPDX-License-Identifier: BSD-3-Clause
// Output of support/skip.hpp. Both cases are hidden: tests/CMakeLists.txt runs each and checks its output.
#include "support/skip.hpp"

namespace skip_test {

TEST_CASE("an example of a case that is skipped", "[.]") { SKIP_CASE("an example"); }

TEST_CASE("an example of a case that fails and leaves out the rest", "[.]") {
    CHECK(1 + 1 == 3);
    test::leave_out("an example");
}

}  // namespace skip_test
