// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/surface_file.hpp>
#include <fstiff/io/write.hpp>

#include "support/skip.hpp"
#include "support/table.hpp"
#include "support/texts.hpp"

namespace surface_file_test {

using namespace fstiff;
using io::SurfaceFormat;
using io::SurfaceOptions;
using test::check_texts, test::contains, test::profile, test::read_text, test::refusal, test::refused;

namespace {

const test::RefusalOf refusal_of(read_text);
const std::string points = test::rows("{x} {z}\n"), grid = test::triples("{i} {j} {z}\n");

/// Rows of \p columns numbers that form no grid.
std::string columns_of_numbers(int columns) {
    std::string text;
    for (int k = 0; k < columns * 20; ++k)
        text += std::to_string(std::sin(k * k)) + (k % columns + 1 < columns ? " " : "\n");
    return text;
}
/// A matrix of \p columns of such numbers.
test::Decision matrix(std::size_t columns, std::vector<std::string> warnings = {}) {
    return {.warnings = std::move(warnings), .size = 20 * columns, .rows = 20, .format = SurfaceFormat::matrix};
}

}  // namespace

TEST_CASE("Measured files equal the values of independent readers number for number") {
    const test::Table table("surfaces_expected.csv");
    if (!std::filesystem::exists(FSTIFF_SURFACES))
        SKIP_CASE("there is no folder of measured surfaces " FSTIFF_SURFACES);
    for (std::size_t row = 0; row < table.size(); ++row) {
        const std::string& name = table.text(row, "file");
        CAPTURE(name);
        const std::filesystem::path path = std::filesystem::path(FSTIFF_SURFACES) / name;
        SurfaceOptions options;
        if (name == "nanovea_test1.txt") options.units = "mm,um";
        if (name == "opdx-3.txt") options.units = "m";
        if (name == "xy-4.txt") options.units = "um";
        if (path.extension() == ".x3p" && !io::reads_x3p()) {
            test::leave_out("built without X3P: " + path.string());
            continue;
        }
        const auto [map, record] = io::detail::read(path, options);
        REQUIRE(static_cast<long double>(map.rows) == table.number(row, "rows"));
        REQUIRE(static_cast<long double>(map.columns) == table.number(row, "columns"));
        CHECK(static_cast<long double>(std::count_if(map.heights.begin(), map.heights.end(), [](double z) {
                  return std::isnan(z);
              })) == table.number(row, "missing"));
        // two roundings in each reader: of a length or a difference, and of its division by a count
        CHECK(test::ulps(map.dx, table.input(row, "dx")) <= 4);
        CHECK((map.rows == 1 || test::ulps(map.dy, table.input(row, "dy")) <= 4));

        double low = std::numeric_limits<double>::infinity(), high = -low;
        std::vector<double> present;
        std::copy_if(map.heights.begin(), map.heights.end(), std::back_inserter(present),
                     [](double z) { return !std::isnan(z); });
        math::CompensatedSum<double> sum, squares;
        for (const double z : present) {
            low = std::min(low, z);
            high = std::max(high, z);
            sum.add(z);
        }
        const auto n = static_cast<double>(present.size());
        const double mean = sum.value() / n;
        for (const double z : present) squares.add((z - mean) * (z - mean));
        // number times unit, rounded once or with a unit that is itself rounded
        CHECK(test::ulps(low, table.input(row, "min")) <= 1);
        CHECK(test::ulps(high, table.input(row, "max")) <= 1);
        const double largest = std::max(std::abs(low), std::abs(high));
        CHECK(std::abs(mean - table.input(row, "mean")) <= 4e-16 * largest);
        CHECK(test::ulps(std::sqrt(squares.value() / n), table.input(row, "rms")) <= 8);

        std::stringstream points(table.text(row, "heights"));
        for (std::string point; points >> point;) {
            CAPTURE(point);
            const std::size_t first = point.find(':'), second = point.rfind(':');
            const double z = map.at(std::stoul(point.substr(0, first)), std::stoul(point.substr(first + 1)));
            const std::string expected = point.substr(second + 1);
            CHECK((expected == "nan" ? std::isnan(z) : test::ulps(z, std::stod(expected)) <= 1));
        }
        CHECK(record.sentences().size() >= 5);
    }
}

TEST_CASE("Text without units is refused with the way to give them") {
    check_texts(
        {{"triples", grid, refused("states no unit of the heights")}, {"profile", points, refused("states no unit")}});
    const std::filesystem::path folder = FSTIFF_SURFACES;
    if (!std::filesystem::exists(folder)) SKIP_CASE("there is no folder of measured surfaces " + folder.string());
    for (const char* name : {"nanovea_test1.txt", "opdx-3.txt", "xy-4.txt"})
        CHECK(contains(refusal([&] { (void)io::read_surface(folder / name); }), "must be given"));
}

TEST_CASE("The form of a text follows from its columns, and the option format decides where they do not") {
    const std::string sized = "Width: 5 um\nHeight: 4 um\nunit: um\n", three = columns_of_numbers(3);
    const SurfaceOptions as_matrix{.format = SurfaceFormat::matrix};
    const SurfaceOptions as_triples{.format = SurfaceFormat::triples, .units = "um"};
    const test::Decision map = test::map(1e-6, 1e-6, 1e-6);
    check_texts({
        {"two columns", points, profile(0.5e-6, 1e-6, {"format: profile"}), {.units = "um"}},
        {"one column", columns_of_numbers(1), profile(1e-6, 0), {.units = "um", .spacing = 1e-6}},
        {"a grid",
         grid,
         test::map(1e-6, 1e-6, 1e-6, {"\nformat: triples, from three columns, the first two of which form a grid\n"}),
         {.units = "um"}},
        {"seven", columns_of_numbers(7), matrix(7), {.units = "um", .dx = 1e-6, .dy = 1e-6}},
        {"three and a size", sized + three, matrix(3)},
        {"three and a size given", three, matrix(3), {.units = "um", .width = 1e-6, .height = 1e-6}},
        {"four, one of them chosen",
         columns_of_numbers(4),
         profile(1e-6, 0, {"format: profile"}),
         {.units = "um", .spacing = 1e-6, .column = 3}},
        {"three, no grid",
         three,
         refused("format = triples with grid, format = matrix, or format = profile"),
         {.units = "um"}},
        {"a grid and a size", sized + grid, refused("format = triples or format = matrix")},
        {"two and a size", sized + points, refused("format = profile or format = matrix")},
        {"four titles", "x [um] a [nm] b [nm] c [nm]\n" + columns_of_numbers(4),
         refused("format = profile with column")},
        {"a grid as matrix", sized + grid, matrix(3), as_matrix},
        {"a grid as triples", sized + grid, map, as_triples},
        {"two as matrix", sized + points, matrix(2), as_matrix},
        {"five as triples", columns_of_numbers(5), refused("must have 3"), as_triples},
        {"a grid and a step", grid, refused("format = triples or format = matrix"), {.units = "um", .dx = 1e-6}},
        {"triples and a step",
         grid,
         refused("dx, dy, width and height must not be given"),
         {.format = SurfaceFormat::triples, .units = "um", .dx = 1e-6}},
        {"profile and width",
         points,
         refused("no use for width"),
         {.format = SurfaceFormat::profile, .units = "um", .width = 1}},
        {"binary and units", "aISO-1.0\n", refused("no use for units"), {.units = "um"}},
        {"matrix and spacing",
         columns_of_numbers(5),
         refused("no use for spacing"),
         {.format = SurfaceFormat::matrix, .spacing = 1.0}},
        {"warnings of a profile", "x [um] z [nm]\n" + points, profile(0.5e-3, 1e-3, {}, {"", ""}), {.units = "mm"}},
        {"warnings of a matrix", sized + three, matrix(3, {""}), {.width = 9e-6}},
    });
}

TEST_CASE("Binary files are known by their first bytes") {
    HeightMap<double> map;
    map.heights = HeightMap<double>::Array::Random(6, 5);
    map.dx = 1e-6;
    map.dy = 2e-6;
    std::ostringstream sdf, line;
    io::write_sdf(sdf, map);
    const io::Surface found = read_text(sdf.str());
    CHECK(found.record.format == SurfaceFormat::sdf);
    CHECK((found.map().heights == map.heights).all());

    Profile<double> profile{std::vector<double>(20, 1.0), 1e-6};
    profile.heights[3] = 2;
    io::write_sdf(line, profile);
    REQUIRE(read_text(line.str()).is_profile());
    CHECK(read_text(line.str()).profile().heights == profile.heights);

    CHECK(contains(refusal_of("PK\3\4rest"), io::reads_x3p() ? "is not a zip archive" : "built without"));
    std::istringstream input(sdf.str());
    CHECK((io::read_surface(input, "file").map().heights == map.heights).all());
    CHECK(contains(refusal_of(std::string("\0\1\2", 3)), "is binary"));
    CHECK(contains(refusal_of(""), "is empty"));
    CHECK(contains(refusal([] { (void)io::read_surface(std::filesystem::path("no such file")); }), "cannot be opened"));
    CHECK_THROWS_AS(io::read_surface(std::filesystem::path("no such file")), fstiff::file_error);
    CHECK_THROWS_AS(io::read_surface(std::filesystem::path(".")), fstiff::file_error);
}

TEST_CASE("A second file after the first one is reported") {
    const std::string gsf =
        "Gwyddion Simple Field 1.0\nXRes = 2\nYRes = 2\nXReal = 1\nYReal = 1\nXYUnits = m\nZUnits = m\n" +
        std::string(4, '\0') + std::string(12, '\0') + std::string("\0\0\x80\x3F", 4);
    const std::string padded =
        gsf.substr(0, gsf.find('\0')) + std::string(4 - gsf.find('\0') % 4, '\0') + gsf.substr(gsf.find('\0') + 4);
    CHECK(read_text(padded).record.warnings.empty());
    const auto warnings = read_text(padded + padded).record.warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(contains(warnings[0], "a second one of the form gsf from byte " + std::to_string(padded.size())));
}

}  // namespace surface_file_test
