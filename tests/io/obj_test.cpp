// SPDX-License-Identifier: BSD-3-Clause
// Wavefront objects that are written here, and their refusals.
#include "support/samples.hpp"

namespace obj_test {

using namespace fstiff;
using test::contains;

namespace {

const test::FormReader read{io::SurfaceFormat::obj};

io::SurfaceOptions in_mm(double grid = 1e-3) {
    io::SurfaceOptions options;
    options.units = "mm";
    if (grid > 0) options.grid = grid;
    return options;
}
std::string refusal(const std::string& bytes, const io::SurfaceOptions& options = in_mm()) {
    return test::refusal([&] { (void)read(bytes, options); });
}

const std::string corners =
    "# made here\no roof\nv 0 0 0\nv 4 0 0 1 1 1\nv 4 4 0\nvt 0.5 0.5\nv 0 4 0\nvn 0 0 1\nv 2 2 1\n";

}  // namespace

TEST_CASE("Vertices and faces of an object are read, with their indices forwards and backwards") {
    CHECK(io::form_of_first_bytes(corners) == io::SurfaceFormat::obj);
    CHECK(io::form_of_first_bytes("v 1 2 3\n") == io::SurfaceFormat::obj);
    CHECK(io::form_of_first_bytes("v x y\n1 2\n") == io::SurfaceFormat::automatic);
    CHECK(io::form_of_first_bytes("o 1\n2\n") == io::SurfaceFormat::automatic);
    for (const char* faces : {"f 5 1 2 3\nf 5 3 4 1\n", "f 1/1/1 2//1 5\nf 2/1 3 5/1\nf 3 4 5\nf -2 -5 -1\n"}) {
        const io::Reading found = read(corners + faces, in_mm());
        CHECK(contains(found.record.said("form"), "5 vertices, 4 triangles"));
        REQUIRE(found.map.heights.size() == 25);
        CHECK(std::abs(found.map.at(2, 2) - 1e-3) < 1e-18);
    }
    // points alone, on their own grid
    std::string raster;
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 6; ++i)
            raster += "v " + std::to_string(i) + " " + std::to_string(j) + " " + std::to_string(i * j % 3) + "\n";
    const io::Reading found = read(raster, in_mm(0));
    REQUIRE(found.map.columns == 6);
    CHECK(found.map.at(2, 1) == 2e-3);
    CHECK(found.record.origin == std::array<double, 2>{0, 0});
}

TEST_CASE("An object that is damaged or without units is refused") {
    CHECK(contains(refusal(corners + "f 1 2 9\n"), "has a face with vertex 9 of 5; must be one of them"));
    CHECK(contains(refusal(corners + "f 1 2 0\n"), "line 10: \"0\" is no vertex"));
    CHECK(contains(refusal(corners + "f 1 2 -9\n"), "\"-9\" is no vertex"));
    CHECK(contains(refusal(corners + "v 1 2\n"), "line 10: has no x, y and z after v"));
    CHECK(contains(refusal(corners + "v 1 2 z\n"), "line 10: \"z\" is not a number"));
    CHECK(contains(refusal(corners, {}), "states no units and none are given"));
    CHECK(contains(refusal("o empty\nvn 1 2 3\n"), "holds 0 points"));
}

}  // namespace obj_test
