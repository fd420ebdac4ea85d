// SPDX-License-Identifier: BSD-3-Clause
// MATLAB files of tools/make_surface_samples.py, and variables that are put together here.
#include "io/mat_file.hpp"
#include "support/samples.hpp"

namespace mat_test {

using namespace fstiff;
using io::SurfaceOptions;
using test::contains;
using test::little;
using test::put;
using test::replaced;

namespace {

const test::FormReader read{io::SurfaceFormat::mat, {.units = "um,nm"}};
const test::RefusalOf refusal(read);

std::string element(std::int64_t type, const std::string& content) {
    return little(type, 4) + little(static_cast<std::int64_t>(content.size()), 4) + content +
           std::string(-content.size() & 7, '\0');
}

/// A variable of \p kind, with its first dimension, and its numbers column after column.
std::string variable(const std::string& name, std::size_t rows, const std::vector<double>& values, int kind = 6) {
    std::string numbers;
    for (const double value : values) numbers += test::bytes_of(value);
    const std::string sizes =
        little(static_cast<std::int64_t>(rows), 4) + little(static_cast<std::int64_t>(values.size() / rows), 4);
    return element(
        14, element(6, little(kind, 4) + little(0, 4)) + element(5, sizes) + element(1, name) + element(9, numbers));
}
std::string file(const std::string& variables) {
    return "MATLAB 5.0 MAT-file" + std::string(105, ' ') + std::string("\0\1IM", 4) + variables;
}

/// Heights of 6 x 5 points (10 row + column^2), column after column, and the positions of each.
struct Grid {
    std::vector<double> z, x, y;
};
Grid grid() {
    Grid made;
    for (int column = 0; column < 5; ++column)
        for (int row = 0; row < 6; ++row) {
            made.z.push_back(10 * row + column * column);
            made.x.push_back(100 + 2 * column);
            made.y.push_back(3 * row);
        }
    return made;
}
const std::vector<double> axis_x{100, 102, 104, 106, 108}, axis_y{0, 3, 6, 9, 12, 15};

void check_grid(const io::Reading& found) {
    REQUIRE((found.map.rows == 6 && found.map.columns == 5));
    CHECK(test::ulps(found.map.dx, 2e-6) <= 1);
    CHECK(test::ulps(found.map.dy, 3e-6) <= 1);
    for (std::size_t row = 0; row < 6; ++row)
        for (std::size_t column = 0; column < 5; ++column)
            CHECK(test::ulps(found.map.at(row, column), static_cast<double>(10 * row + column * column) * 1e-9) <= 1);
}

/// The sample "packed", whose streams need zlib.
bool has_packed() { return io::reads_compressed_sur(); }

}  // namespace

TEST_CASE("A map of MATLAB is read from either byte order, and from zlib streams") {
    for (const char* name : {"mat/map.mat", "mat/big.mat", "mat/packed.mat"}) {
        CAPTURE(name);
        if (!has_packed() && contains(name, "packed")) continue;
        const io::Reading found = read(test::sample(name));
        REQUIRE((found.map.rows == 4 && found.map.columns == 4));
        CHECK(test::ulps(found.map.dx, 0.5e-6) <= 1);
        CHECK(test::ulps(found.map.dy, 0.25e-6) <= 1);
        CHECK(found.record.missing == 5);
        CHECK(test::ulps(found.map.at(2, 3), 29e-9) <= 1);
        CHECK(found.record.said("form") == "MATLAB file, variable 2 \"z\", 4 x 4 double");
        CHECK(contains(found.record.said("other variables"), "1 \"note\", 1 x 2 char; 3 \"x\", 1 x 4 double; "));
    }
}

TEST_CASE("Positions of MATLAB may be of columns and rows, of every height, or of points in any order") {
    Grid made = grid();
    check_grid(read(file(variable("x", 1, axis_x) + variable("y", 6, axis_y) + variable("height", 6, made.z))));
    check_grid(read(file(variable("X", 6, made.x) + variable("Y", 6, made.y) + variable("Z", 6, made.z))));
    Grid turned;  // y falls, as an image has it
    for (std::size_t i = 0; i < 30; ++i) {
        turned.z.push_back(made.z[i / 6 * 6 + 5 - i % 6]);
        turned.y.push_back(made.y[i / 6 * 6 + 5 - i % 6]);
    }
    check_grid(read(file(variable("z", 6, turned.z) + variable("x", 1, axis_x) + variable("y", 6, turned.y))));
    for (std::size_t i = 0; i < 30; ++i)
        for (std::vector<double>* numbers : {&made.z, &made.x, &made.y})
            std::swap((*numbers)[i], (*numbers)[i * 7 % 30]);
    const std::string triples = variable("z", 30, made.z) + variable("x", 30, made.x) + variable("y", 30, made.y);
    check_grid(read(file(triples)));
    check_grid(read(file(triples + variable("intensity", 30, made.y))));
    made.z[3] = std::nan("");
    CHECK(read(file(variable("z", 1, made.z) + variable("x", 1, made.x) + variable("y", 1, made.y))).record.missing ==
          1);
}

TEST_CASE("A matrix or a vector of MATLAB without positions takes the steps of the options") {
    const Grid made = grid();
    check_grid(read(file(variable("z", 6, made.z)), {.units = "nm", .dx = 2e-6, .height = 18e-6}));
    check_grid(read(file(variable("a", 6, made.y) + variable("b", 6, made.z)),
                    {.units = "nm", .dx = 2e-6, .dy = 3e-6, .channel = "b"}));
    check_grid(read(file(variable("a", 6, made.y) + variable("b", 6, made.z)),
                    {.units = "nm", .dx = 2e-6, .dy = 3e-6, .channel = "2"}));
    // steps of the options replace the positions
    CHECK(test::ulps(read(file(variable("x", 1, axis_x) + variable("y", 6, axis_y) + variable("z", 6, made.z)),
                          {.units = "nm", .dx = 1e-6, .dy = 1e-6})
                         .map.dx,
                     1e-6) == 0);
    const io::Reading profile = read(file(variable("trace", 30, made.z)), {.units = "nm", .spacing = 1e-6});
    CHECK((profile.map.rows == 1 && profile.map.columns == 30 && profile.record.resolution == 0));
    CHECK(read(test::sample("mat/profile.mat")).record.resolution == 1e-9);
}

TEST_CASE("Variables of MATLAB that may be something else are refused with their list") {
    const Grid made = grid();
    const std::string z = variable("z", 6, made.z);
    CHECK(contains(refusal(file(z), {}), "states no units and none are given; must be given as units = \"um,nm\""));
    CHECK(contains(refusal(file(z)), "states no steps; must be given as dx and dy"));
    CHECK(contains(refusal(file(z + variable("b", 6, made.z))),
                   "holds 2 variables: 1 \"z\", 6 x 5 double; 2 \"b\", 6 x 5 double; the heights must be one of them, "
                   "given as channel = \"1\""));
    CHECK(contains(refusal(file(variable("x", 1, axis_x) + variable("y", 1, axis_x))), "holds 2 variables"));
    CHECK(contains(refusal(file(z), {.units = "nm", .channel = "w"}), "has no variable \"w\"; must be one of 1 \"z\""));
    CHECK(contains(refusal(file(variable("s", 6, made.z, 2))),
                   "holds no variable of heights, but 1 \"s\", 6 x 5 struct; must be real numbers of two dimensions"));
    CHECK(contains(refusal(file(variable("m", 6, made.z, 9 + 0x200))), "6 x 5 logical uint8"));
    CHECK(contains(refusal(file(variable("m", 6, made.z, 6 + 0x800))), "6 x 5 complex double"));
    CHECK(contains(refusal(file("")), "holds no variable; must be"));
    CHECK(contains(refusal(file(variable("xz", 15, made.z))), "may be columns of a table"));
    CHECK(contains(refusal(file(z + variable("x", 1, axis_x))), "has positions x, but no y"));
    CHECK(contains(refusal(file(z + variable("x", 1, axis_y) + variable("y", 1, axis_y))),
                   "has 6 positions \"x\" for 30 heights; must be 5 or 30, or given as dx and dy"));
    CHECK(contains(refusal(file(z + variable("x", 1, {0, 1, 2, 3, 4.2}) + variable("y", 1, axis_y))),
                   "not equally spaced"));
    CHECK(contains(refusal(file(z + variable("x", 1, {0, 0, 0, 0, 0}) + variable("y", 1, axis_y))),
                   "not equally spaced"));
    CHECK(contains(refusal(file(z + variable("x", 1, {0, 1, 2, 3, std::nan("")}) + variable("y", 1, axis_y))),
                   "missing"));
    CHECK(contains(refusal(file(z + variable("x", 1, {0, 1, 2, 3, 3}) + variable("y", 1, axis_y))),
                   "has two heights at one position"));
    std::vector<double> line;
    for (int i = 0; i < 30; ++i) line.push_back(i);
    CHECK(contains(refusal(file(variable("z", 30, made.z) + variable("x", 30, line) + variable("y", 30, line))),
                   "fill no grid, of 30 x 30 points"));
}

TEST_CASE("MATLAB files that are damaged, or declare more than they hold, are refused") {
    const std::string whole = file(variable("z", 6, grid().z));
    CHECK(contains(refusal("MATLAB 5"), "does not begin as a MATLAB file"));
    CHECK(contains(refusal(whole.substr(0, 100)), "ends within its header"));
    CHECK(contains(refusal(put(whole, 126, "??")), "states no version and byte order"));
    CHECK(contains(refusal(put(whole, 128, little(3, 4))), "has an element of type 3 for variable 1"));
    CHECK(contains(refusal(put(whole, 132, little(-1, 4))), "ends within variable 1 (4294967295 bytes"));
    CHECK(contains(refusal(put(whole, 136, little(0x70006, 4))), "has 7 bytes in the 4 of the flags of variable 1"));
    CHECK(contains(refusal(put(whole, 140, little(0, 4))), "has no flags of variable 1"));
    const std::size_t sizes = 128 + 8 + 16 + 8;
    CHECK(contains(refusal(put(whole, sizes, little(7, 4)), {.units = "nm", .dx = 1, .dy = 1}),
                   "declares 35 numbers of 8 bytes in variable 1 \"z\", but has 240"));
    CHECK(
        contains(refusal(put(whole, sizes, little(0x7FFFFFFF, 4) + little(0x7FFFFFFF, 4))), "no variable of heights"));
    CHECK(contains(refusal(put(whole, sizes + 8 + 16, little(8, 4))),
                   "stores the numbers of variable 1 \"z\" as type 8"));
    if (!has_packed()) return;
    const std::string packed = test::sample("mat/packed.mat");
    CHECK(contains(refusal(put(packed, 136, "????")), "has a damaged stream of variable 1"));
    CHECK(contains(refusal(put(packed, packed.size() - 4, "????")), "has a damaged stream of variable 4"));
    // a stream of 2 kB that holds 2 MB of numbers
    const std::string bomb = test::read(FSTIFF_TEST_DATA "/../fuzz/corpus/mat/bomb.mat");
    CHECK(contains(refusal(bomb, {.units = "nm", .dx = 1, .dy = 1}), "must be at most 200 times as many"));
}

}  // namespace mat_test
