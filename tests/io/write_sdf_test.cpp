// SPDX-License-Identifier: BSD-3-Clause
// The reader returns the written data; data that a file cannot hold are refused.
#include <fstiff/io/write.hpp>

#include "support/samples.hpp"

#include <bit>
#include <sstream>

namespace write_sdf_test {

using namespace fstiff;
using test::contains;

namespace {

const test::FormReader read{io::SurfaceFormat::sdf};

}  // namespace

TEST_CASE("Written text and binary files are read back bit for bit") {
    const bool binary = GENERATE(true, false);
    const HeightMap<double> map = test::rough_map();
    std::ostringstream output;
    io::write_sdf(output, map, {.binary = binary, .manufacturer = "me", .date = "311219991234"});
    const auto back = read(output.str());
    CHECK(back.record.said("form").find("ISO-1.0") != std::string::npos);
    CHECK(back.record.said("form").ends_with("by me"));
    CHECK(back.map.dx == map.dx);
    CHECK(back.map.dy == map.dy);
    REQUIRE(back.map.heights.size() == static_cast<std::size_t>(map.size()));
    for (Eigen::Index i = 0; i < map.size(); ++i) {
        const double old = map.heights.data()[i], now = back.map.heights[i];
        CHECK(((std::isnan(old) && std::isnan(now)) ||
               std::bit_cast<std::uint64_t>(old) == std::bit_cast<std::uint64_t>(now)));
    }
    // the header as another program counts its bytes
    if (binary) CHECK(output.str().size() == 81 + 35 * 8);
}

TEST_CASE("A profile is written as a file of one profile, a long side as version 2.0") {
    Profile<double> profile{{}, 1e-7};
    for (int i = 0; i < 70000; ++i) profile.heights.push_back(i % 17 * 1e-9);
    std::ostringstream output;
    io::write_sdf(output, profile);
    const auto back = read(output.str());
    CHECK(back.record.said("form").find("ISO-2.0") != std::string::npos);
    REQUIRE(back.map.columns == 70000);
    CHECK(back.map.at(0, 16) == 16e-9);
    CHECK(back.map.dx == 1e-7);
}

TEST_CASE("Data that a file cannot hold are not written") {
    HeightMap<double> map = test::rough_map();
    std::ostringstream output;
    const auto refused = [&](const io::SdfOptions& options) {
        return test::refusal([&] { io::write_sdf(output, map, options); });
    };
    CHECK(contains(refused({.manufacturer = "elevenchars"}), "at most 10"));
    CHECK(contains(refused({.date = "today"}), "12 digits"));
    map.heights(0, 0) = std::numeric_limits<double>::lowest();
    CHECK(contains(refused({}), "marks a missing point"));
    map.heights(0, 0) = std::numeric_limits<double>::infinity();
    CHECK(contains(refused({}), "infinite"));
    CHECK(output.str().empty());
}

TEST_CASE("An output that takes nothing is a file that cannot be written") {
    std::ostringstream output;
    output.setstate(std::ios::badbit);
    CHECK_THROWS_AS(io::write_sdf(output, test::rough_map()), file_error);
}

}  // namespace write_sdf_test
