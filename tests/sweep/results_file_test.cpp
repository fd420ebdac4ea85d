// SPDX-License-Identifier: BSD-3-Clause
// Damaged lines of results are distinguished from whole ones.
#include "sweep/results_file.hpp"

#include "support/catch.hpp"

namespace results_file_test {

using namespace fstiff::sweep;

TEST_CASE("A line of results is one whole object, and no part of it or anything else") {
    const std::string good =
        "{\"index\":7,\"surface.from\":\"a \\\"b\\\\ "
        "\\u001b.csv\",\"law\":\"hertz\",\"theta\":1.5,\"r\":null,\"pressure_Pa\":"
        "1e+06,\"stiffness_Pa_per_m\":-2.5e-07}";
    CHECK(index_of_line(good) == 7);
    CHECK(index_of_line("{\"index\":0}") == 0);
    for (std::size_t length = 0; length < good.size(); ++length) {
        INFO(good.substr(0, length));
        CHECK_FALSE(index_of_line(good.substr(0, length)));
    }
    CHECK_FALSE(index_of_line(good + "}"));
    for (const char* bad :
         {"{\"index\":1,}", "{\"index\":1,\"a\":}", "{\"index\":1,\"a\":nul}", "{\"index\":1,\"a\":1e}",
          "{\"index\":1,\"a\":inf}", "{\"index\":1 \"a\":1}", "{\"index\":1,\"a\":\"\\u12\"}",
          "{\"index\":1,\"a\":\"\\x\"}", "{\"index\":1,\"a\":\"\n\"}", "{\"index\":-1}", "{\"index\":1.5}",
          "{\"a\":1,\"index\":1}"}) {
        INFO(bad);
        CHECK_FALSE(index_of_line(bad));
    }
}

}  // namespace results_file_test
