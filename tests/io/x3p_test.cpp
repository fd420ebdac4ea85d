// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"
#include "support/zip.hpp"

#include <sstream>

namespace x3p_test {

using namespace fstiff;

namespace {

using test::contains;
using test::zipped;

constexpr int columns = 5, rows = 4;
int height(int k) { return (7 * k) % 20 - 3; }

template <class T>
std::string heights() {
    std::string bytes;
    for (int k = 0; k < columns * rows; ++k) bytes += test::bytes_of(static_cast<T>(height(k)));
    return bytes;
}

const std::string link = "<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink>";
const std::string masked =
    "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>"
    "<ValidPointsLink>bindata/valid.bin</ValidPointsLink></DataLink>";

struct Main {
    std::string type = "D", data = link, root = "p:ISO5436_2", space = " xmlns:p=\"urn:any\"", feature = "SUR";
    std::string size = "<MatrixDimension><SizeX>5</SizeX><SizeY>4</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
    std::string z = "<Increment>0.5</Increment>", x_type = "I", x = "1e-6", y = "2e-6";
    std::string text() const {
        return "<?xml version=\"1.0\"?><" + root + space + "><Record1><FeatureType>" + feature +
               "</FeatureType><Axes><CX><AxisType>" + x_type + "</AxisType><Increment>" + x +
               "</Increment></CX><CY><AxisType>I</AxisType><Increment>" + y +
               "</Increment></CY><CZ><AxisType>A</AxisType><DataType>" + type + "</DataType>" + z +
               "</CZ></Axes></Record1><Record3>" + size + data + "</Record3></" + root + ">";
    }
};

const test::FormReader read{io::SurfaceFormat::x3p};
std::string refusal(const std::string& bytes) { return test::RefusalOf(read)(bytes); }
std::string refusal(const Main& main, const std::string& data = heights<double>()) {
    return refusal(zipped({{"main.xml", main.text()}, {"bindata/data.bin", data}}));
}

void check_map(const io::Reading& found, double unit = 0.5) {
    REQUIRE(found.map.rows == rows);
    REQUIRE(found.map.columns == columns);
    CHECK(found.map.dx == 1e-6);
    CHECK(found.map.dy == 2e-6);
    for (int k = 0; k < columns * rows; ++k) REQUIRE(found.map.at(k / columns, k % columns) == height(k) * unit);
}

}  // namespace

TEMPLATE_TEST_CASE("Heights of every type are read, deflated and stored", "", std::int16_t, std::int32_t, float,
                   double) {
    const std::string type = std::is_same_v<TestType, std::int16_t>   ? "I"
                             : std::is_same_v<TestType, std::int32_t> ? "L"
                             : std::is_same_v<TestType, float>        ? "F"
                                                                      : "D";
    for (const bool deflate : {true, false}) {
        const auto found =
            read(zipped({{"main.xml", Main{.type = type}.text()}, {"bindata/data.bin", heights<TestType>()}}, deflate));
        check_map(found);
        CHECK(found.record.said("form").find(std::string("type ") + type[0]) != std::string::npos);
    }
    CHECK(contains(refusal(Main{.type = type}, heights<TestType>().substr(1)),
                   "must have " + std::to_string(sizeof(TestType))));
    CHECK(contains(refusal(Main{.type = type}, heights<TestType>() + "x"), "bytes; must have"));
}

TEST_CASE("A folder in the archive, any namespace or none, and other files do not matter") {
    const std::string folder = GENERATE("", "land/", "a/b/");
    const Main main = GENERATE(Main{}, Main{.root = "ISO5436", .space = ""}, Main{.root = "x:y", .space = ""});
    const auto found = read(zipped({{"__MACOSX/main.xml", "junk"},
                                    {folder + "deeper/main.xml", "junk"},
                                    {folder + "mask.png", "png"},
                                    {folder + "main.xml", main.text()},
                                    {folder + "bindata/data.bin", heights<double>()}}));
    check_map(found);
    CHECK(found.record.said("other files in the archive") == "3, not read");
    CHECK(found.record.sentences().size() == 5);
}

TEST_CASE("Missing points are NaN, an empty datum, or not set in the mask") {
    std::string mask = "\xff\xff\x0f";
    mask[1] = static_cast<char>(0xfd);  // the tenth point
    const auto found = read(zipped({{"main.xml", Main{.type = "I", .data = masked}.text()},
                                    {"bindata/data.bin", heights<std::int16_t>()},
                                    {"bindata/valid.bin", mask}}));
    CHECK(found.record.missing == 1);
    CHECK(std::isnan(found.map.at(1, 4)));
    CHECK(found.map.at(1, 3) == height(8) * 0.5);
    CHECK(contains(refusal(zipped({{"main.xml", Main{.type = "I", .data = masked}.text()},
                                   {"bindata/data.bin", heights<std::int16_t>()},
                                   {"bindata/valid.bin", "\xff"}})),
                   "one bit for each of 20 points"));

    std::string list = "<DataList>";
    for (int k = 0; k < 19; ++k) list += "<Datum>" + std::to_string(height(k)) + "</Datum>";
    const auto listed = read(zipped({{"main.xml", Main{.data = list + "<Datum/></DataList>"}.text()}}));
    CHECK(listed.record.missing == 1);
    CHECK(std::isnan(listed.map.at(3, 4)));
    CHECK(listed.map.at(3, 3) == height(18) * 0.5);
    CHECK(contains(refusal(Main{.data = list + "</DataList>"}), "DataList holds 19 heights; must hold 5 x 4"));
    CHECK(contains(refusal(Main{.data = list + "<Datum>x</Datum></DataList>"}), "height 20 is \"x\""));
}

TEST_CASE("Increment and offset of the heights are applied, a profile needs no CY increment") {
    const auto found = read(zipped({{"main.xml", Main{.z = "<Increment>2</Increment><Offset>0.25</Offset>"}.text()},
                                    {"bindata/data.bin", heights<double>()}}));
    CHECK(found.map.at(0, 1) == 8.25);
    check_map(read(zipped(
                  {{"main.xml", Main{.z = "<Increment/><Offset/>"}.text()}, {"bindata/data.bin", heights<double>()}})),
              1);
    const auto profile =
        read(zipped({{"main.xml", Main{.feature = "PRF", .size = "<ListDimension>20</ListDimension>", .y = ""}.text()},
                     {"bindata/data.bin", heights<double>()}}));
    CHECK(profile.map.rows == 1);
    CHECK(profile.map.columns == 20);
}

TEST_CASE("Units that are given replace the metres of the form, with a warning") {
    const std::string bytes = zipped({{"main.xml", Main{}.text()}, {"bindata/data.bin", heights<double>()}});
    const auto millimetres = read(bytes, {.units = "mm"});
    CHECK(test::relative_error(millimetres.map.dx, 1e-9) < 1e-14);
    CHECK(test::relative_error(millimetres.map.dy, 2e-9) < 1e-14);
    CHECK(test::relative_error(millimetres.map.at(0, 1), height(1) * 0.5e-3) < 1e-14);
    CHECK(millimetres.record.said("units") == "x and y in mm, heights in mm, from options");
    REQUIRE(millimetres.record.warnings.size() == 2);  // the first is of the increment
    CHECK(millimetres.record.warnings[1] ==
          "units = \"mm\" contradicts the form, whose numbers are m; the option is used");
    const auto heights_alone = read(bytes, {.units = "m,um"});
    CHECK(heights_alone.map.dx == 1e-6);
    CHECK(test::relative_error(heights_alone.map.at(0, 1), height(1) * 0.5e-6) < 1e-14);
    CHECK(read(bytes, {.units = "m"}).record.warnings.size() == 1);
    CHECK(contains(test::refusal([&] { (void)read(bytes, {.units = "mm,um,nm"}); }), "one unit, or two"));
}

TEST_CASE("Archives that would swell are refused before anything is inflated") {
    const std::string zeros(std::size_t(2048) * 1024 * 8, '\0');
    Main main;
    main.size = "<MatrixDimension><SizeX>2048</SizeX><SizeY>1024</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
    CHECK(contains(refusal(main, zeros), "would inflate from"));
    CHECK(contains(refusal(zipped({{"main.xml", std::string(zeros.size(), ' ')}})), "would inflate from"));
    const std::string bytes = zipped({{"main.xml", Main{}.text()}, {"bindata/data.bin", heights<double>()}});
    const auto limited = [&](const io::X3pLimits& limits) {
        return test::RefusalOf(read)(bytes, {.x3p_limits = limits});
    };
    CHECK(contains(limited({.bytes = 100}), "must be at most 100"));
    CHECK(contains(limited({.files = 1}), "holds 2 files; must be at most 1"));
    CHECK(limited({}).empty());
    Main huge;
    huge.size = "<MatrixDimension><SizeX>4294967295</SizeX><SizeY>4294967295</SizeY><SizeZ>1</SizeZ></MatrixDimension>";
    CHECK(contains(refusal(huge), "4294967295 x 4294967295 points"));
}

TEST_CASE("Names in the archive are compared, never followed") {
    for (const char* path : {"../../etc/passwd", "/etc/passwd", "bindata/../bindata/data.bin", "", "C:\\data.bin"}) {
        CAPTURE(path);
        CHECK(contains(
            refusal(Main{.data = "<DataLink><PointDataLink>" + std::string(path) + "</PointDataLink></DataLink>"}),
            "must name a file of the archive"));
    }
    // the same bytes under that very name are a file of the archive, and nothing outside it is touched
    const Main main{.data = "<DataLink><PointDataLink>../../x</PointDataLink></DataLink>"};
    check_map(read(zipped({{"main.xml", main.text()}, {"../../x", heights<double>()}})));
    check_map(read(zipped({{"main.xml", Main{.data = "<DataLink><PointDataLink>.\\bindata\\data.bin</PointDataLink>"
                                                     "</DataLink>"}
                                            .text()},
                           {"bindata/data.bin", heights<double>()}})));
}

TEST_CASE("Every damaged archive is refused with a sentence") {
    // one bit of the heights: the CRC differs
    std::string stored = zipped({{"main.xml", Main{}.text()}, {"bindata/data.bin", heights<double>()}}, false);
    const std::size_t place = stored.find(heights<double>());
    REQUIRE(place != std::string::npos);
    stored[place + 6] ^= 1;
    CHECK(contains(refusal(stored), "is damaged"));
    CHECK(contains(refusal(zipped({{"other.xml", ""}})), "holds no main.xml"));
    CHECK(contains(refusal(zipped({{"a/main.xml", ""}, {"b/main.xml", ""}})), "more than one main.xml"));
    CHECK(contains(refusal(zipped({{"main.xml", "<a"}})), "not valid XML"));
    CHECK(contains(refusal(zipped({{"main.xml", "<a/>"}})), "Record1 and Record3"));
}

TEST_CASE("Descriptions that cannot be read are refused with element, value and range") {
    CHECK(contains(refusal(Main{.type = "Q"}), "CZ/DataType = \"Q\": must be I, L, F or D"));
    CHECK(contains(refusal(Main{.x_type = "A"}), "CX/AxisType = \"A\": must be I"));
    CHECK(contains(refusal(Main{.feature = "PCL"}), "FeatureType = \"PCL\""));
    CHECK(contains(refusal(Main{.x = "0"}), "CX/Increment = 0: must be"));
    CHECK(contains(refusal(Main{.x = "nan"}), "CX/Increment"));
    CHECK(contains(refusal(Main{.y = "-1"}), "CY/Increment = -1: must be"));
    CHECK(contains(refusal(Main{.size = ""}), "no MatrixDimension"));
    CHECK(contains(
        refusal(Main{.size = "<MatrixDimension><SizeX>5</SizeX><SizeY>4</SizeY><SizeZ>2</SizeZ></MatrixDimension>"}),
        "SizeZ = 2: must be 1"));
    CHECK(contains(refusal(Main{.data = ""}), "has neither DataLink nor DataList"));
    std::string infinite = heights<double>();
    infinite.replace(0, 8, std::string("\0\0\0\0\0\0\xf0\x7f", 8));
    const io::Reading marked = read(zipped({{"main.xml", Main().text()}, {"bindata/data.bin", infinite}}));
    CHECK(std::isnan(marked.map.at(0, 0)));  // as Alicona marks missing points
}

TEST_CASE("An increment with floating-point heights is reported and may be ignored") {
    const std::string bytes = zipped({{"main.xml", Main().text()}, {"bindata/data.bin", heights<double>()}});
    const auto reading = [&](io::X3pIncrement increment) {
        return io::read_surface(bytes, "file.x3p", {.x3p_increment = increment});
    };
    const auto applied = reading(io::X3pIncrement::apply), ignored = reading(io::X3pIncrement::ignore);
    for (int k = 0; k < columns * rows; ++k) {
        CHECK(applied.map().heights.data()[k] == height(k) * 0.5);
        CHECK(ignored.map().heights.data()[k] == height(k));
    }
    REQUIRE(applied.record.warnings.size() == 1);
    CHECK(applied.record.warnings[0].find("increment of 0.5") != std::string::npos);
    CHECK(applied.record.warnings[0].ends_with("x3p_increment = ignore"));
    REQUIRE(ignored.record.warnings.size() == 1);
    CHECK(ignored.record.warnings[0].ends_with("x3p_increment = apply"));
    const Main plain{.z = "<Increment>1</Increment>"}, counted{.type = "I"};
    for (const auto& [main, data] : {std::pair{plain, heights<double>()}, {counted, heights<std::int16_t>()}})
        CHECK(io::read_surface(zipped({{"main.xml", main.text()}, {"bindata/data.bin", data}}), "file.x3p")
                  .record.warnings.empty());
}

TEST_CASE("An archive that is no X3P file is named by its type") {
    CHECK(refusal(zipped({{"xl/workbook.xml", "x"}})).find("Excel workbook (.xlsx)") != std::string::npos);
    CHECK(refusal(zipped({{"LAYER_0.raw", "x"}, {"index.xml", "x"}})).find("Sensofar") != std::string::npos);
    CHECK(refusal(zipped({{"heights.npy", "x"}})).find("NumPy") != std::string::npos);
}

}  // namespace x3p_test
