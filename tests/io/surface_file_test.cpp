// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/io/surface_file.hpp>
#include <fstiff/io/write.hpp>

#include "support/samples.hpp"
#include "support/skip.hpp"
#include "support/table.hpp"

namespace surface_file_test {

using namespace fstiff;
using io::SurfaceFormat;
using io::SurfaceOptions;

namespace {

constexpr test::FileReader read{};
const test::RefusalOf refusal(read);
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Rows of \p columns numbers that form no grid.
std::string columns_of_numbers(int columns, int rows = 20) {
    std::string text;
    for (int k = 0; k < columns * rows; ++k)
        text += std::to_string(std::sin(k * k)) + (k % columns + 1 < columns ? " " : "\n");
    return text;
}
std::string profile_rows() {
    std::string text;
    for (int i = 0; i < 20; ++i) text += std::to_string(i / 2.0) + " " + std::to_string(std::sin(i)) + "\n";
    return text;
}
std::string grid() {
    std::string text;
    for (int i = 0; i < 40; ++i)
        text += std::to_string(i % 8) + " " + std::to_string(i / 8) + " " + std::to_string(std::sin(i)) + "\n";
    return text;
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
    CHECK(has(refusal(grid()), "states no units"));
    CHECK(has(refusal(profile_rows()), "states no unit"));
    const std::filesystem::path folder = FSTIFF_SURFACES;
    if (!std::filesystem::exists(folder)) SKIP_CASE("there is no folder of measured surfaces " + folder.string());
    for (const char* name : {"nanovea_test1.txt", "opdx-3.txt", "xy-4.txt"})
        CHECK(has(test::refusal([&] { (void)io::read_surface(folder / name); }), "must be given"));
}

TEST_CASE("The form of a text follows from its columns") {
    CHECK(read(profile_rows(), {.units = "um"}).record.format == SurfaceFormat::profile);
    CHECK(read(columns_of_numbers(1), {.units = "um", .spacing = 1e-6}).is_profile());
    CHECK(read(grid(), {.units = "um"}).record.format == SurfaceFormat::triples);
    CHECK(read(columns_of_numbers(7), {.units = "um", .dx = 1e-6, .dy = 1e-6}).record.format == SurfaceFormat::matrix);
    CHECK(read("Width: 3 um\nHeight: 3 um\nunit: nm\n" + columns_of_numbers(3)).record.format == SurfaceFormat::matrix);
    CHECK(read(columns_of_numbers(3), {.units = "um", .width = 1e-6, .height = 1e-6}).record.format ==
          SurfaceFormat::matrix);
    CHECK(read(columns_of_numbers(4), {.units = "um", .spacing = 1e-6, .column = 3}).record.format ==
          SurfaceFormat::profile);
    CHECK(read(grid(), {.units = "um"}).record.sentences().front() ==
          "format: triples, from three columns, the first two of which form a grid");
}

TEST_CASE("Ambiguous files are refused and the option format decides") {
    CHECK(
        has(refusal(columns_of_numbers(3), {.units = "um"}), "format = triples, format = matrix, or format = profile"));
    const std::string sized = "Width: 3 um\nHeight: 3 um\nunit: nm\n";
    CHECK(has(refusal(sized + grid()), "format = triples or format = matrix"));
    CHECK(has(refusal(sized + profile_rows()), "format = profile or format = matrix"));
    CHECK(has(refusal("x [um] a [nm] b [nm] c [nm]\n" + columns_of_numbers(4)), "format = profile with column"));
    CHECK(read(sized + grid(), {.format = SurfaceFormat::matrix}).map().columns() == 3);
    CHECK(read(sized + grid(), {.format = SurfaceFormat::triples, .units = "um"}).map().columns() == 8);
    CHECK(read(sized + profile_rows(), {.format = SurfaceFormat::matrix}).map().columns() == 2);
    CHECK(has(refusal(columns_of_numbers(5), {.format = SurfaceFormat::triples, .units = "um"}), "must have 3"));
}

TEST_CASE("Options that the form has no use for are refused") {
    CHECK(has(refusal(grid(), {.units = "um", .dx = 1e-6}), "format = triples or format = matrix"));
    CHECK(has(refusal(grid(), {.format = SurfaceFormat::triples, .units = "um", .dx = 1e-6}), "no use for dx"));
    CHECK(has(refusal(profile_rows(), {.format = SurfaceFormat::profile, .units = "um", .width = 1}),
              "no use for width"));
    CHECK(has(refusal("aISO-1.0\n", {.units = "um"}), "no use for units"));
    CHECK(has(refusal(columns_of_numbers(5), {.format = SurfaceFormat::matrix, .spacing = 1.0}), "no use for spacing"));
}

TEST_CASE("Binary files are known by their first bytes") {
    HeightMap<double> map;
    map.heights = HeightMap<double>::Array::Random(6, 5);
    map.dx = 1e-6;
    map.dy = 2e-6;
    std::ostringstream sdf, line;
    io::write_sdf(sdf, map);
    const io::Surface found = read(sdf.str());
    CHECK(found.record.format == SurfaceFormat::sdf);
    CHECK((found.map().heights == map.heights).all());

    Profile<double> profile{std::vector<double>(20, 1.0), 1e-6};
    profile.heights[3] = 2;
    io::write_sdf(line, profile);
    REQUIRE(read(line.str()).is_profile());
    CHECK(read(line.str()).profile().heights == profile.heights);

    CHECK(has(refusal("PK\3\4rest"), io::reads_x3p() ? "is not a zip archive" : "built without"));
    std::istringstream input(sdf.str());
    CHECK((io::read_surface(input, "file").map().heights == map.heights).all());
    CHECK(has(refusal(std::string("\0\1\2", 3)), "is binary"));
    CHECK(has(refusal(""), "is empty"));
    CHECK(
        has(test::refusal([] { (void)io::read_surface(std::filesystem::path("no such file")); }), "cannot be opened"));
    CHECK_THROWS_AS(io::read_surface(std::filesystem::path("no such file")), fstiff::file_error);
    CHECK_THROWS_AS(io::read_surface(std::filesystem::path(".")), fstiff::file_error);
}

TEST_CASE("A second file after the first one is reported") {
    const std::string gsf =
        "Gwyddion Simple Field 1.0\nXRes = 2\nYRes = 2\nXReal = 1\nYReal = 1\nXYUnits = m\nZUnits = m\n" +
        std::string(4, '\0') + std::string(12, '\0') + std::string("\0\0\x80\x3F", 4);
    const std::string padded =
        gsf.substr(0, gsf.find('\0')) + std::string(4 - gsf.find('\0') % 4, '\0') + gsf.substr(gsf.find('\0') + 4);
    CHECK(read(padded).record.warnings.empty());
    const auto warnings = read(padded + padded).record.warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(has(warnings[0], "a second one of the form gsf from byte " + std::to_string(padded.size())));
}

TEST_CASE("Warnings of the text readers are reported with the surface") {
    CHECK(read("x [um] z [nm]\n" + profile_rows(), {.units = "mm"}).record.warnings.size() == 2);
    CHECK(
        read("Width: 3 um\nHeight: 3 um\nunit: nm\n" + columns_of_numbers(3), {.width = 9e-6}).record.warnings.size() ==
        1);
    CHECK(read(grid(), {.units = "um"}).record.warnings.empty());
}

}  // namespace surface_file_test
