// SPDX-License-Identifier: BSD-3-Clause
// Points in JSON and text, and two faces that look at each other, as measure and scenes read them.
#include "support/library.hpp"
#include "surface/facing.hpp"
#include "surface/points_json.hpp"

#include <cmath>
#include <random>

namespace points_test {

using namespace fstiff;

namespace {

/// Points of a face every 0.5 mm, from (x, y) of the step on: heights as hash, printed exactly.
using Heights = double (*)(int, int);
std::string points(int x, int y, int columns, int rows, Heights height, const char* begin, const char* between,
                   const char* end) {
    std::string text;
    for (int j = y; j < y + rows; ++j)
        for (int i = x; i < x + columns; ++i)
            text += begin + std::to_string(0.5 * i) + between + std::to_string(0.5 * j) + between +
                    std::to_string(height(i, j)) + end;
    return text;
}
std::string text_points(int x, int y, int columns, int rows, Heights height) {
    return points(x, y, columns, rows, height, "", " ", "\n");
}
double lower(int i, int j) { return ((7 * i + 13 * j) % 17) / 256.0; }
double upper(int i, int j) { return 1 + ((5 * i + 3 * j) % 11) / 256.0; }

surface::SurfaceInput read(const std::string& file, const std::string& facing, const char* grid) {
    surface::SurfaceOptions options;
    options.file = file;
    options.facing = facing;
    options.units = "mm";
    if (*grid) options.grid = request::Amount(grid);
    return surface::read_surface_input(options);
}

}  // namespace

TEST_CASE("Lists of points in JSON are read as the same text", "[points]") {
    const std::string text = text_points(0, 0, 40, 30, lower);
    std::string array = points(0, 0, 40, 30, lower, "[", ",", "],\n"), objects;
    array = "[" + array.substr(0, array.size() - 2) + "]";
    for (int j = 0; j < 30; ++j)
        for (int i = 0; i < 40; ++i)
            objects += (objects.empty() ? "" : ",") + ("{\"q\":\"ok\",\"z\":" + std::to_string(lower(i, j))) +
                       ",\"x\":" + std::to_string(0.5 * i) + ",\"y\":" + std::to_string(0.5 * j) + "}";
    const std::string how = "--units mm ";
    for (const char* grid : {"", "--grid '0.5 mm' "}) {
        const auto expected = test::measured(how + grid, text);
        for (const std::string& json : {array, "{\"unit\": \"mm\", \"surface_points\": [" + objects + "]}"}) {
            const auto found = test::measured(how + grid, json);
            CHECK(found["surface"] == expected["surface"]);
            CHECK(test::contains(found["source"].dump(), "JSON: 1200 points"));
        }
    }
    const auto refused = [](const std::string& json) {
        return test::refusal([&] { (void)surface::lines_of_points(json, "file"); });
    };
    CHECK(test::contains(refused("[[1,2,3],[4,5,6]"), "file: is no JSON at byte 17; must be a list of points"));
    CHECK(test::contains(refused("{\"a\":[[1,2,3]],\"b\":[[1,2,3]]}"), "holds several lists of points"));
    CHECK(test::contains(refused("[1,2,3]"), "is JSON without points"));
    CHECK(test::contains(refused(std::string(100000, '[')), "more than 32 levels"));
    CHECK(surface::lines_of_points("[[1,null,-2e-3],[\"nan\",5,6]]", "file").text == "1\tnan\t-2e-3\nnan\t5\t6\n");
    CHECK(surface::lines_of_points("{\"p\":[{\"x\":1,\"z\":3,\"w\":[7,8]}]}", "file").text == "1\t3\n");
    CHECK_FALSE(surface::is_points_json("[DataSet]\n1 2\n"));
    CHECK_FALSE(surface::is_points_json("{\"fstiff_version\": \"0.1.0\", \"x\": [[1]]}"));
}

TEST_CASE("Two faces on one grid are their sum on the points that both have", "[points]") {
    const test::Folder folder;
    const std::string low = folder.write("lower.xyz", text_points(0, 0, 40, 30, lower)),
                      high = folder.write("upper.xyz", text_points(3, 2, 40, 30, upper));
    for (const char* grid : {"", "0.5 mm"}) {
        const surface::SurfaceInput input = read(low, high, grid);
        const HeightMap<double>& map = input.surface.map();
        REQUIRE(map.columns() == 37);
        REQUIRE(map.rows() == 28);
        for (Eigen::Index j = 0; j < 28; ++j)
            for (Eigen::Index i = 0; i < 37; ++i) {
                const int x = int(i) + 3, y = int(j) + 2;
                CHECK(std::abs(map.heights(j, i) - 1e-3 * (lower(x, y) - upper(x, y))) < 1e-8);  // six decimals
            }
        CHECK(input.surface.record.details.back() ==
              "facing: sum of both faces, 37 x 28 points, the upper one of " + high);
    }
    const auto refused = [&](const std::string& below, const std::string& above, const char* grid = "0.5 mm") {
        return test::refusal([&] { (void)read(below, above, grid); });
    };
    CHECK(test::contains(refused(high, low), "lies below " + high + " by "));
    const std::string far = folder.write("far.xyz", text_points(300, 2, 40, 30, upper)),
                      between = folder.write("between.xyz", [] {
                          std::string text;
                          for (int j = 0; j < 30; ++j)
                              for (int i = 0; i < 40; ++i)
                                  text += std::to_string(0.5 * i + 0.2) + " " + std::to_string(0.5 * j) + " " +
                                          std::to_string(upper(i, j)) + "\n";
                          return text;
                      }());
    CHECK(test::contains(refused(low, far), "covers no points of"));
    CHECK(test::contains(refused(low, between, ""), "has points between those of"));
    CHECK(read(low, between, "0.5 mm").surface.map().rows() >= 28);
    CHECK(test::contains(refused(low,
                                 folder.write(
                                     "profile.txt", "1 2\n2 3\n3 5\n" +
                                                        [] {
                                                            std::string text;
                                                            for (int i = 4; i < 40; ++i)
                                                                text += std::to_string(i) + " " +
                                                                        std::to_string(i % 5) + "\n";
                                                            return text;
                                                        }()),
                                 ""),
                         "is a profile"));
}

TEST_CASE("A form may be the gap of two faces", "[points]") {
    const test::Folder folder;
    const double side = 0.05, step = side / 64;
    HeightMap<double> gap{HeightMap<double>::Array(64, 64), step, step};
    std::string low, high;
    for (Eigen::Index j = 0; j < 64; ++j)
        for (Eigen::Index i = 0; i < 64; ++i) {
            const double x = (2 * double(i) + 1) / 64 - 1, y = (2 * double(j) + 1) / 64 - 1;
            gap.heights(j, i) = 1e-5 * std::min(1.0, x * x + y * y);
            char line[128];
            std::snprintf(line, sizeof line, "%.17g %.17g ", double(i) * step, double(j) * step);
            low += line, high += line;
            const double bend = 2e-5 * x;  // of both faces, which their gap does not see
            std::snprintf(line, sizeof line, "%.17g\n", bend - gap.heights(j, i) / 4), low += line;
            std::snprintf(line, sizeof line, "%.17g\n", bend + 0.75 * gap.heights(j, i)), high += line;
        }
    const std::string scene =
        "[surface]\nRa = \"0.8 um\"\nprocess = \"ground\"\n[material]\nupper = \"steel\"\n[contact]\n"
        "pressures = [\"10 MPa\"]\n";
    const auto stiffness = [&](const std::string& form) {
        return test::results_of(scene + "form = " + form + "\n").answer.points[0].stiffness.value;
    };
    const double expected = stiffness("'" + folder.write("gap.txt", test::file_text(gap)) + "'");
    const std::string faces = "from = '" + folder.write("lower.xyz", low) + "', facing = '" +
                              folder.write("upper.xyz", high) + "', units = \"m\"";
    CHECK(test::relative_error(stiffness("{ " + faces + " }"), expected) < 1e-9);
    char grid[64];
    std::snprintf(grid, sizeof grid, ", grid = \"%.17g m\"", step);
    CHECK(test::relative_error(stiffness("{ " + faces + grid + " }"), expected) < 1e-9);
    CHECK(test::contains(test::refusal([&] { (void)stiffness("{ " + faces + ", detrend = \"plane\" }"); }),
                         "contact.form.detrend"));
}

}  // namespace points_test
