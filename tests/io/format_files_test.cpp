// SPDX-License-Identifier: BSD-3-Clause
// Files that other programs wrote, against the values that third programs read from them (tests/data/README.md).
#include <fstiff/io/surface_file.hpp>

#include "support/accuracy.hpp"
#include "support/skip.hpp"
#include "support/table.hpp"

#include <sstream>

namespace format_files_test {

using namespace fstiff;

TEST_CASE("Files of other programs have the values of other readers number for number") {
    const test::Table table("formats_expected.csv");
    REQUIRE(table.size() == 19);
    for (std::size_t row = 0; row < table.size(); ++row) {
        const std::string& name = table.text(row, "file");
        CAPTURE(name);
        io::SurfaceOptions options;
        if (name == "compressed.sur" && !io::reads_compressed_sur()) {
            test::leave_out("built without zlib: " + name);
            continue;
        }
        if (name == "fortran.npy") {
            options.units = "nm";
            options.dx = 0.25e-6;
            options.dy = 0.5e-6;
        }
        const auto [map, record] = io::detail::read(std::filesystem::path(FSTIFF_TEST_DATA "/formats") / name, options);
        REQUIRE(static_cast<long double>(map.rows) == table.number(row, "rows"));
        REQUIRE(static_cast<long double>(map.columns) == table.number(row, "columns"));
        // single precision in the files of Digital Surf is the same in both readers; two roundings a reader
        CHECK(test::ulps(map.dx, table.input(row, "dx")) <= 4);
        CHECK(test::ulps(map.dy, table.input(row, "dy")) <= 4);
        std::istringstream heights(table.text(row, "heights"));
        std::vector<double> expected;
        for (std::string one; heights >> one;) expected.push_back(std::stod(one));
        REQUIRE(expected.size() == map.heights.size());
        double largest = 0;
        for (const double z : expected)
            if (!std::isnan(z)) largest = std::max(largest, std::abs(z));
        for (std::size_t i = 0; i < expected.size(); ++i) {
            CAPTURE(i);
            const double z = map.heights[i];
            // units are rounded in some readers, and one adds a constant that was taken away again
            CHECK((std::isnan(expected[i]) ? std::isnan(z) : std::abs(z - expected[i]) <= 1e-15 * largest));
        }
        CHECK(record.sentences().size() >= 5);
    }
}

}  // namespace format_files_test
