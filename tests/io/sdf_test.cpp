// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace sdf_test {

using namespace fstiff;
using test::bytes_of;
using test::contains;

namespace {

const test::FormReader read{io::SurfaceFormat::sdf};
const test::RefusalOf refusal(read);

struct Header {
    std::string version = "bISO-1.0";
    std::uint32_t points = 3, profiles = 2;
    double x = 1e-6, y = 2e-6, z = 0.5;
    int compression = 0, type = 7, check = 0;
    std::string bytes() const {
        const bool wide = version == "bISO-2.0";
        const auto count = [&](std::uint32_t n) {
            return wide ? bytes_of(n) : bytes_of(static_cast<std::uint16_t>(n));
        };
        return version + "maker     " + "010120000000" + "010120000000" + count(points) + count(profiles) +
               bytes_of(x) + bytes_of(y) + bytes_of(z) + bytes_of(-1.0) + static_cast<char>(compression) +
               static_cast<char>(type) + static_cast<char>(check);
    }
};

template <class T>
std::string six(T first) {
    std::string data = bytes_of(first);
    for (int i = 1; i < 6; ++i) data += bytes_of(static_cast<T>(i));
    return data;
}

std::string text(const std::string& data, const std::string& version = "aISO-1.0", const std::string& points = "3",
                 const std::string& profiles = "2", const std::string& type = "7", const std::string& end = "\r\n") {
    return version + end + "ManufacID = maker" + end + "CreateDate = 010120000000" + end + "ModDate = 010120000000" +
           end + "NumPoints = " + points + end + "NumProfiles = " + profiles + end + "Xscale = 1e-6" + end +
           "Yscale = 2e-6" + end + "Zscale = 0.5" + end + "Zresolution = -1" + end + "Compression = 0" + end +
           "DataType = " + type + end + "CheckType = 0" + end + "*" + end + data + end + "*" + end;
}

/// Heights 1 to 5 halved, after a first one.
void check_heights(const io::Reading& found) {
    REQUIRE(found.map.rows == 2);
    REQUIRE(found.map.columns == 3);
    CHECK(found.map.dx == 1e-6);
    CHECK(found.map.dy == 2e-6);
    for (int i = 1; i < 6; ++i) CHECK(found.map.at(i / 3, i % 3) == i * 0.5);
}

}  // namespace

TEMPLATE_TEST_CASE("Binary heights of every type are read, the reserved number as missing", "", std::uint8_t,
                   std::uint16_t, std::uint32_t, float, std::int8_t, std::int16_t, std::int32_t, double) {
    using Limits = std::numeric_limits<TestType>;
    const int type = std::is_same_v<TestType, float>    ? 3
                     : std::is_same_v<TestType, double> ? 7
                                                        : (Limits::is_signed ? 4 : 0) + (sizeof(TestType) == 1   ? 0
                                                                                         : sizeof(TestType) == 2 ? 1
                                                                                                                 : 2);
    const std::string version = GENERATE("bISO-1.0", "bISO-2.0", "bBCR-1.0");
    const bool bcr = version == "bBCR-1.0";
    CAPTURE(type, version);
    const std::string header = Header{.version = version, .type = type}.bytes();
    check_heights(read(header + six<TestType>(9)));
    CHECK(read(header + six<TestType>(9)).map.at(0, 0) == 4.5);
    CHECK(read(header + six<TestType>(9) + "trailer").record.said("trailer") == "7 bytes, not read");

    const TestType reserved = bcr || !Limits::is_signed ? Limits::max() : Limits::lowest();
    const auto missing = read(header + six(reserved));
    CHECK(missing.record.missing == 1);
    CHECK(std::isnan(missing.map.at(0, 0)));
    check_heights(missing);
    // the other end of the range is a height where the version does not reserve it
    if (Limits::is_signed && sizeof(TestType) < 8) {
        const TestType other = bcr ? Limits::lowest() : Limits::max();
        CHECK(read(header + six(other)).map.at(0, 0) == static_cast<double>(other) * 0.5);
    }
    CHECK(contains(refusal(header + six<TestType>(9).substr(1)), "declares 3 x 2 heights"));
}

TEST_CASE("Reals that are no numbers or infinite are missing, those that the scale makes infinite are refused") {
    const std::string header = Header{}.bytes();
    CHECK(read(header + six(std::numeric_limits<double>::quiet_NaN())).record.missing == 1);
    const auto infinite = read(header + six(-std::numeric_limits<double>::infinity()));
    CHECK(infinite.record.missing == 1);
    CHECK(std::isnan(infinite.map.at(0, 0)));
    CHECK(contains(refusal(Header{.z = 1e300}.bytes() + six(1e300)), "height 1 is beyond the range"));
    CHECK(read(Header{.version = "bBCR-1.0"}.bytes() + six(1.75e308)).record.missing == 1);
}

TEST_CASE("The maker in the first line may be another") {
    check_heights(read(text("9 1 2\n3 4 5", "aNIST-1.0", "3", "2", "7", "\n")));
    CHECK(read.begins(text("9 1 2\n3 4 5", "aNPL-2.0", "3", "2", "7", "\n")));
    check_heights(read(Header{.version = "bNPL-1.0"}.bytes() + six(9.0)));
    CHECK_FALSE(read.begins("aNIST-1.0\n1 2 3\n"));
    CHECK_FALSE(read.begins("aNIST-10\nNumPoints = 3\nZscale = 1\n"));
}

TEST_CASE("Text is read with any line ends, in any layout of the heights, with BAD points") {
    const std::string end = GENERATE("\n", "\r\n", "\r");
    const std::string version = GENERATE("aISO-1.0", "aISO-2.0", "aBCR-1.0", "AISO-1.0");
    CAPTURE(end, version);
    check_heights(read(text("9 1 2" + end + "3 4 5", version, "3", "2", "7", end)));
    check_heights(read(text("9" + end + "1 2 3\t4" + end + end + " 5 ", version, "3", "2", "7", end)));
    const auto missing = read(text("BAD 1 2" + end + "3 4 5", version, "3", "2", "7", end));
    CHECK(missing.record.missing == 1);
    check_heights(missing);
    CHECK_FALSE(read(text("9 1 2 3 4 5", version, "3", "2", "7", end) + "junk\n*").record.said("trailer").empty());
}

TEST_CASE("Text of BCR has names for codes, comments, and the largest number for missing points") {
    const auto found = read(text("32767 1 2 ; the first is missing\n3 4 5", "aBCR-1.0", "3", "2", "INTEGER"));
    CHECK(found.record.missing == 1);
    CHECK(contains(found.record.said("form"), "int16"));
    check_heights(found);
    CHECK(read(text("32767 1 2\n3 4 5", "aISO-1.0", "3", "2", "5")).map.at(0, 0) == 32767 * 0.5);
}

TEST_CASE("Declared sizes are compared with the bytes before memory is taken") {
    // without the check 2^64 doubles would be allocated, and std::bad_alloc is no domain_error
    CHECK(contains(
        refusal(Header{.version = "bISO-2.0", .points = 0xFFFFFFFF, .profiles = 0xFFFFFFFF}.bytes() + six(1.0)),
        "declares 4294967295 x 4294967295 heights"));
    CHECK(contains(refusal(Header{.points = 65535, .profiles = 65535}.bytes() + six(1.0)), "declares 65535 x 65535"));
    CHECK(contains(refusal(text("1 2 3", "aISO-1.0", "4294967295", "4294967295")), "declares 4294967295 x 4294967295"));
    CHECK(contains(refusal(text("1 2 3", "aISO-1.0", "1e30")), "NumPoints = 1e+30: must be a whole number"));
    CHECK(contains(refusal(text("1 2 3", "aISO-1.0", "2.5")), "NumPoints = 2.5"));
    CHECK(contains(refusal(text("1 2 3", "aISO-1.0", "0")), "NumPoints = 0"));
    CHECK(contains(refusal(text("1 2 3 4 5")), "holds 5 heights; must hold the 6"));
    CHECK(contains(refusal(text("1 2 3 4 5 6 7")), "holds more heights than the 6"));
}

TEST_CASE("Headers that cannot be meant are refused with field, value and range") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(contains(refusal(Header{.x = 0}.bytes() + six(1.0)), "Xscale = 0: must be"));
    CHECK(contains(refusal(Header{.x = nan}.bytes() + six(1.0)), "Xscale = nan: must be"));
    CHECK(contains(refusal(Header{.y = -1}.bytes() + six(1.0)), "Yscale = -1: must be"));
    CHECK(contains(refusal(Header{.z = 0}.bytes() + six(1.0)), "Zscale = 0: must be"));
    CHECK(contains(refusal(Header{.compression = 1}.bytes() + six(1.0)), "Compression = 1: must be 0"));
    CHECK(contains(refusal(Header{.type = 8}.bytes() + six(1.0)), "DataType = 8: must be between 0 and 7"));
    CHECK(read(Header{.check = 1}.bytes() + six(9.0)).record.said("check sum") == "not verified");
    CHECK(contains(refusal(text("9 1 2 3 4 x")), "height 6 is \"x\""));
    CHECK(contains(refusal("aISO-3.0\n"), "begins with \"aISO-3.0\""));
    CHECK(contains(refusal("aISO-1.0\nNumPoints = 3\n"), "that ends its header"));
    CHECK(contains(refusal("aISO-1.0\n*\n1 2\n*\n"), "states no NumPoints"));
    CHECK(contains(refusal(text("1 1 1 1 1 1")), "constant height"));
}

TEST_CASE("A file of one profile needs no Yscale") {
    const auto found = read(Header{.points = 6, .profiles = 1, .y = 0}.bytes() + six(9.0));
    CHECK(found.map.rows == 1);
    CHECK(found.map.dy == 1e-6);
    CHECK(found.map.at(0, 0) == 4.5);
}

}  // namespace sdf_test
