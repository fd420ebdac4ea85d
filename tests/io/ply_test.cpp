// SPDX-License-Identifier: BSD-3-Clause
// Polygon files that are written here byte by byte, and their refusals.
#include "support/samples.hpp"

#include <bit>
#include <cstdint>
#include <cstring>

namespace ply_test {

using namespace fstiff;
using test::contains;

namespace {

const test::FormReader read{io::SurfaceFormat::ply};

io::SurfaceOptions in_mm(double grid = 0) {
    io::SurfaceOptions options;
    options.units = "mm";
    if (grid > 0) options.grid = grid;
    return options;
}

std::string refusal(const std::string& bytes, const io::SurfaceOptions& options = in_mm(1e-3)) {
    return test::refusal([&] { (void)read(bytes, options); });
}

/// 5 x 4 points 1 mm apart, z = x^2 + 10 y, the order of rows.
std::vector<std::array<float, 3>> points() {
    std::vector<std::array<float, 3>> all;
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 5; ++i) all.push_back({float(i), float(j), float(i * i) / 16 + float(j) / 4});
    return all;
}

template <class T>
std::string bytes_of(T value, bool big) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big != (std::endian::native == std::endian::big)) std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

/// With a list and a property that are left out, and one face.
std::string file(const std::string& format) {
    std::string bytes =
        "ply\nformat " + format +
        " 1.0\ncomment made here\nelement vertex 20\nproperty uchar red\nproperty float x\nproperty float "
        "y\nproperty list uchar short more\nproperty float z\nend_header\n";
    for (const auto& [x, y, z] : points()) {
        if (format == "ascii") {
            bytes += "7 " + std::to_string(x) + " " + std::to_string(y) + " 2 -1 300 " + std::to_string(z) + "\n";
            continue;
        }
        const bool big = format == "binary_big_endian";
        bytes += '\7' + bytes_of(x, big) + bytes_of(y, big) + '\2' + bytes_of<std::int16_t>(-1, big) +
                 bytes_of<std::int16_t>(300, big) + bytes_of(z, big);
    }
    return bytes;
}

}  // namespace

TEST_CASE("A polygon file is read as text and in either byte order, on its grid or another") {
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        CAPTURE(format);
        for (const double grid : {0.0, 1e-3}) {
            const io::Reading found = read(file(format), in_mm(grid));
            REQUIRE(found.map.rows == 4);
            REQUIRE(found.map.columns == 5);
            CHECK(std::abs(found.map.dx - 1e-3) < 1e-18);
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t i = 0; i < 5; ++i)
                    CHECK(std::abs(found.map.at(j, i) - 1e-3 * (double(i * i) / 16 + double(j) / 4)) < 1e-17);
            CHECK(contains(found.record.said("form"), "20 vertices, 0 triangles"));
        }
    }
}

TEST_CASE("The faces of a polygon file are its triangles") {
    const std::string head =
                          "ply\r\nformat ascii 1.0\r\nelement vertex 5\r\nproperty float x\r\nproperty float y\r\n"
                          "property double z\r\nelement face 2\r\nproperty list uchar int vertex_indices\r\n"
                          "end_header\r\n",
                      corners = "0 0 0\n4 0 0\n4 4 0\n0 4 0\n2 2 1\n";
    const io::Reading found = read(head + corners + "4 4 0 1 2\n4 4 2 3 0\n", in_mm(1e-3));
    CHECK(contains(found.record.said("form"), "5 vertices, 4 triangles"));
    CHECK(std::abs(found.map.at(2, 2) - 1e-3) < 1e-18);
    CHECK(std::abs(found.map.at(1, 3) - 0.5e-3) < 1e-18);
    CHECK(std::abs(found.map.at(0, 3)) < 1e-18);
    CHECK(
        contains(refusal(head + corners + "3 0 1 5\n3 0 1 2\n"), "has a face with vertex 5 of 5; must be one of them"));
    CHECK(contains(refusal(head + corners + "3 0 1 -1\n3 0 1 2\n"), "has a face with vertex -1"));
    CHECK(contains(refusal(head + corners + "3 0 1 2\n"), "ends before the elements that its header declares"));
}

TEST_CASE("A polygon file that is damaged, hostile or without units is refused") {
    const auto with = [](const std::string& from, const std::string& to) {
        std::string bytes = file("ascii");
        return bytes.replace(bytes.find(from), from.size(), to);
    };
    CHECK(
        contains(refusal(with("vertex 20", "vertex 1000000000")), "declares 1000000000 times \"vertex\", but holds "));
    CHECK(contains(refusal(with("vertex 20", "vertex -3")), "is no count"));
    CHECK(contains(refusal(with("vertex 20", "vertex 1e300")), "is no count"));
    CHECK(contains(refusal(with("7 0", "seven 0")), "\"seven\" among the elements is not a number"));
    CHECK(contains(refusal(with(" 2 -1 300", " 4000000 -1 300")), "has a list of 4000000 numbers"));
    CHECK(contains(refusal(with("float z", "float depth")), "without the property z"));
    CHECK(contains(refusal(with("property uchar red", "property byte red")), "\"byte\" is no type"));
    CHECK(contains(refusal(with("ascii", "packed")), "format"));
    CHECK(contains(refusal(with("end_header", "end")), "is no line of a header"));
    CHECK(contains(refusal(with("element vertex", "element corner")), "has no element vertex"));
    CHECK(contains(refusal("ply\nformat ascii 1.0\nend_header\n"), "has no element vertex"));
    CHECK(contains(refusal("ply\nformat ascii 1.0\nelement vertex 3\nend_header\n"), "declares 3 times"));
    CHECK(contains(refusal("ply\nformat ascii"), "has a header without end_header"));
    CHECK(contains(refusal(file("binary_little_endian").substr(0, 300)), "ends before the elements"));
    CHECK(contains(refusal(file("ascii"), {}), "states no units and none are given; must be given as units = \"mm\""));
    // off the grid, and a proposal in the unit of the file
    CHECK(contains(refusal(with("7 1.0", "7 1.4"), in_mm()), "must be put on one by grid = \"1 mm\""));
    // missing heights
    CHECK(read(with("300 0.000000", "300 nan"), in_mm()).record.missing == 1);
}

}  // namespace ply_test
