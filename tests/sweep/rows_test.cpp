// SPDX-License-Identifier: BSD-3-Clause
// Damaged lines of results are distinguished from whole ones.
#include "sweep/rows.hpp"

#include "cli/command.hpp"

#include <fstiff/core/error.hpp>

namespace rows_test {

using namespace fstiff::sweep;

namespace {

const std::string good =
    "{\"index\":7,\"surface.from\":\"a \\\"b\\\\ "
    "\\u001b.csv\",\"law\":\"hertz\",\"theta\":1.5,\"r\":null,\"pressure_Pa\":"
    "1e+06,\"stiffness_Pa_per_m\":-2.5e-07}";

std::string line(int index, const std::string& law, const std::string& rest = "\"stiffness_Pa_per_m\":1}") {
    return "{\"index\":" + std::to_string(index) + ",\"law\":\"" + law + "\",\"pressure_Pa\":1," + rest + "\n";
}

/// K of all rows of a file that holds \p text, or what it is refused with.
std::string read_back(const std::string& text) {
    const test::Folder folder;
    const std::string file = folder.write("k", text);
    std::string found;
    try {
        for_each_row(file, [&](const Row& row) {
            found += std::to_string(row.index) + "." + std::to_string(row.point) + (row.stiffness ? "=K " : " ");
            return true;
        });
    } catch (const fstiff::file_error& error) {
        return std::string(error.what()).substr(file.size());
    }
    return found;
}

}  // namespace

TEST_CASE("A line of results is one whole object, and no part of it or anything else") {
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

TEST_CASE("Rows are read in their order, and the first that is damaged is named") {
    const std::string missed = "\"stiffness_Pa_per_m\":null,\"error\":\"law hertz: closed\"}";
    CHECK(read_back(line(0, "hertz") + line(0, "hertz", missed) + line(0, "hertz") + line(1, "hertz")) ==
          "0.0=K 0.1 0.2=K 1.0=K ");
    CHECK(read_back("{\"index\":0,\"error\":\"no\"}\n" + line(1, "hertz")) == "1.0=K ");
    const std::string damaged =
        " is not a whole line of results, or not in its order; move the file and its .sweep away and "
        "run the sweep again";
    const std::string two = line(0, "hertz") + line(1, "hertz");
    CHECK(read_back(two + "XXXXXXXX" + line(2, "hertz").substr(8)) == ":3:" + damaged);
    CHECK(read_back(two + line(2, "hertz").substr(0, 30)) == ":3:" + damaged);
    CHECK(read_back(two + line(3, "hertz")) == ":3:" + damaged);
    CHECK(read_back(two + line(2, "hXXtz")) == ":3:" + damaged);
    CHECK(read_back(two + line(2, "hertz", "\"stiffXXXX_Pa_per_m\":1}")) == ":3:" + damaged);
    CHECK(read_back("nothing\n") == ": is not a file of results; must be what fstiff sweep wrote");
}

}  // namespace rows_test
