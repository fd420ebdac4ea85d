// SPDX-License-Identifier: BSD-3-Clause
// Matrices with positions as their first row and column, as Excel, MATLAB and pandas write them: the same map as
// without.
#include <fstiff/io/surface_file.hpp>
#include "io/map_text.hpp"

#include "support/samples.hpp"

namespace matrix_axes_test {

using namespace fstiff;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

constexpr int columns = 7, rows = 6;
double height(int i, int j) { return ((i * i * 5 + j * 11 + i * j) % 23) / 8.0; }

/// The heights with the \p corner and axes of the steps \p dx and \p dy; "" for no axes.
std::string matrix(const std::string& corner, double dx, double dy, const std::string& separator = ";",
                   bool axes = true) {
    std::ostringstream text;
    if (axes) {
        text << corner;
        for (int i = 0; i < columns; ++i) text << separator << i * dx;
        text << "\n";
    }
    for (int j = 0; j < rows; ++j) {
        if (axes) text << j * dy << separator;
        for (int i = 0; i < columns; ++i) text << height(i, j) << (i + 1 < columns ? separator : "\n");
    }
    return text.str();
}
std::string with_commas(std::string text) {
    std::replace(text.begin(), text.end(), '.', ',');
    return text;
}
constexpr test::FileReader read{};
const test::RefusalOf refusal(read);
void check(const io::Surface& found, double dx, double dy, double unit) {
    REQUIRE_FALSE(found.is_profile());
    REQUIRE(found.map().columns() == columns);
    REQUIRE(found.map().rows() == rows);
    CHECK(test::relative_error(found.map().dx, dx) < 1e-12);
    CHECK(test::relative_error(found.map().dy, dy) < 1e-12);
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) REQUIRE(test::ulps(found.map().heights(j, i), height(i, j) * unit) <= 1);
}

}  // namespace

TEST_CASE("Positions in the first row and column are the steps of a matrix, never heights", "[axes]") {
    for (const char* corner : {"y\\x [um]", "y/x [\xC2\xB5m]", "X (um)", "\"y\\x [um]\"", "# y\\x [um]"}) {
        CAPTURE(corner);
        const io::Surface found = read(with_commas(matrix(corner, 0.5, 0.25)), {.units = "nm"});
        check(found, 0.5e-6, 0.25e-6, 1e-9);
        CHECK(has(found.record.sentences()[0], "matrix, from positions in the first row and the first column"));
        CHECK(found.record.sentences().back() ==
              "axes: the first row and the first column are positions in " +
                  std::string(corner).substr(std::string(corner).find_first_of("[(") + 1, has(corner, "\xB5") ? 3 : 2));
    }
    // the corner is empty, not a number, or a number, as MATLAB writes it; units by option
    for (const char* corner : {"", "NaN", "0", "7"})
        for (const char* separator : {";", "\t", ",", " "}) {
            if (std::string(corner).empty() && *separator == ' ') continue;
            CAPTURE(corner, separator);
            check(read(matrix(corner, 0.5, 0.25, separator), {.units = "um,nm"}), 0.5e-6, 0.25e-6, 1e-9);
            check(read(matrix(corner, 0.5, 0.25, separator), {.units = "um"}), 0.5e-6, 0.25e-6, 1e-6);
        }
    check(read(matrix("y\\x [um]", 0.5, 0.25, " "), {.units = "nm"}), 0.5e-6, 0.25e-6, 1e-9);
    // axes that fall; a unit of the heights in the header
    check(read(matrix("", -0.5, -0.25), {.units = "um"}), 0.5e-6, 0.25e-6, 1e-6);
    check(read("Value units: nm\n" + matrix("y\\x [um]", 0.5, 0.25)), 0.5e-6, 0.25e-6, 1e-9);
}

TEST_CASE("Axes that count points give no steps", "[axes]") {
    for (const char* corner : {"", "Index", "0"}) {
        CAPTURE(corner);
        CHECK(has(refusal(matrix(corner, 1, 1), {.units = "um"}), "states no dx and no width"));
        check(read(matrix(corner, 1, 1), {.units = "um", .dx = 2e-6, .dy = 3e-6}), 2e-6, 3e-6, 1e-6);
    }
    check(read(matrix("y\\x [um]", 1, 1), {.units = "nm"}), 1e-6, 1e-6, 1e-9);
}

TEST_CASE("Axes without a unit, and one axis alone, are refused", "[axes]") {
    CHECK(has(refusal(matrix("y\\x", 0.5, 0.25)),
              "line 1: holds positions, whose unit is not stated; must be given as units"));
    CHECK(has(refusal(matrix("y [um]\\x [mm]", 0.5, 0.25), {}), "whose unit is stated twice"));
    CHECK(has(refusal(matrix("y\\x [um]", 0.5, 0.25)), "states no unit of the heights"));
    std::string profiles, sized;  // positions and three traces
    for (int i = 0; i < 20; ++i) {
        profiles += std::to_string(i * 0.5);
        for (int k = 1; k < 4; ++k) profiles += ";" + std::to_string((i * i * k) % 17);
        profiles += "\n";
    }
    const io::SurfaceOptions size{.units = "um", .dx = 1e-6, .dy = 1e-6};
    CHECK(has(refusal(profiles, size), "has a first column that rises in equal steps, as positions do"));
    CHECK(has(refusal("x [um];1;2;3\n" + profiles, size), "has a first column that rises in equal steps"));
    io::SurfaceOptions forced = size;
    forced.format = io::SurfaceFormat::matrix;
    CHECK(read(profiles, forced).map().columns() == 4);
    CHECK(read(profiles, {.units = "um", .column = 3}).profile().size() == 20);
}

TEST_CASE("Options that contradict the axes are used and reported", "[axes]") {
    const io::Surface found = read(matrix("y\\x [um]", 0.5, 0.25), {.units = "nm", .dx = 2e-6});
    check(found, 2e-6, 0.25e-6, 1e-9);
    REQUIRE(found.record.warnings.size() == 1);
    CHECK(found.record.warnings[0] ==
          "dx = 2e-06 m contradicts dx of the positions in line 1, 5e-07 m; the option is used");
    const io::Surface scaled = read(matrix("y\\x [um]", 0.5, 0.25), {.units = "mm,nm"});
    check(scaled, 0.5e-3, 0.25e-3, 1e-9);
    REQUIRE(scaled.record.warnings.size() == 1);
    CHECK(has(scaled.record.warnings[0], "units = \"mm,nm\" contradicts line 1, which states um for the axes"));
    CHECK(read(matrix("y\\x [um]", 0.5, 0.25), {.units = "nm", .dx = 0.5e-6}).record.warnings.empty());
}

TEST_CASE("A header that counts the columns of the whole table denies axes", "[axes]") {
    const std::string head = "dx: 2 um\ndy: 2 um\nunit: nm\n";
    CHECK(read(head + matrix("0", 0.5, 0.25)).map().columns() == columns + 1);
    CHECK(read(head + "cols: 7\n" + matrix("0", 2, 2, " ")).map().columns() == columns);
    CHECK(has(refusal(head + "cols: 7\n" + matrix("0", 0.5, 0.25), {.units = "um,nm"}), "disagrees with the axes"));
}

TEST_CASE("The heights in columns x and y and z and more are z", "[axes]") {
    const auto text = [](const std::string& head, const char* format, int count = 60) {
        std::string all = head;
        for (int i = 0; i < count; ++i) {
            char line[80];
            std::snprintf(line, sizeof line, format, 0.5 * (i % 10), 0.5 * (i / 10), (i * i % 13) / 8.0, 100 + i % 7);
            all += line;
        }
        return all;
    };
    const std::string bare = text("", "%.1f,%.1f,%.3f,%d\n");
    const HeightMap<double> truth = read(text("", "%.1f,%.1f,%.3f\n"), {.units = "um"}).map();
    const auto same = [&](const io::Surface& found) {
        return found.map().columns() == 10 && (found.map().heights == truth.heights).all() &&
               found.map().dx == truth.dx;
    };
    const io::Surface found = read(bare, {.units = "um"});
    CHECK(same(found));
    CHECK(has(found.record.sentences()[0], "triples, from 4 columns, the first two of which form a grid"));
    CHECK(found.record.sentences().back() == "columns: x, y and heights in 1, 2, 3; left out: 4");
    CHECK(same(read(text("x [um],y [um],z [um],I [a.u.]\n", "%.1f,%.1f,%.3f,%d\n"))));
    CHECK(same(read(text("x;y;z;intensity\n", "%.1f;%.1f;%.3f;%d\n"), {.units = "um"})));
    // the title of z is where z is
    std::string turned = "x [um],y [um],intensity,z [um]\n";
    for (int i = 0; i < 60; ++i) {
        char line[80];
        std::snprintf(line, sizeof line, "%.1f,%.1f,%d,%.3f\n", 0.5 * (i % 10), 0.5 * (i / 10), 100 + i % 7,
                      (i * i % 13) / 8.0);
        turned += line;
    }
    CHECK(same(read(turned)));
    CHECK(has(refusal(bare, {.units = "um", .dx = 1e-6, .dy = 1e-6}), "may be triples or a matrix"));
    CHECK(has(refusal(text("x [um],y [um],z [um],I\n", "%.1f,%.1f,%.3f,%d\n", 60) + "0.13,77.7,1,2\n"),
              "lie on no regular grid"));
}

}  // namespace matrix_axes_test
