// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

#include <cstring>

namespace gsf_test {

using namespace fstiff;
using test::contains;
using namespace std::string_literals;

namespace {

const test::FormReader read{io::SurfaceFormat::gsf};
const test::RefusalOf refusal(read);

/// 1, 2, -0.5, 0.25, 3, 100 as float32, least significant byte first, by hand.
const std::string six = "\0\0\x80\x3F\0\0\0\x40\0\0\0\xBF\0\0\x80\x3E\0\0\x40\x40\0\0\xC8\x42"s;
const std::string fields = "XRes = 3\nYRes = 2\nXReal = 6e-06\nYReal = 2e-06\nXYUnits = m\nZUnits = m\n";

std::string file(const std::string& lines = fields, const std::string& data = six) {
    std::string bytes = "Gwyddion Simple Field 1.0\n" + lines;
    do bytes += '\0';
    while (bytes.size() % 4 != 0);
    return bytes + data;
}
std::string replaced(const std::string& from, const std::string& to) {
    std::string text = fields;
    return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST_CASE("A simple field is read, whatever the padding of its header") {
    for (const char* title : {"", "Title = a\n", "Title = ab\n", "Title = abc\n", "Title = abcd\n", "Other=x=y\n\n"}) {
        CAPTURE(title);
        const io::Reading found = read(file(title + fields));
        REQUIRE(found.map.rows == 2);
        REQUIRE(found.map.columns == 3);
        const double expected[2][3] = {{1, 2, -0.5}, {0.25, 3, 100}};
        for (int row = 0; row < 2; ++row)
            for (int column = 0; column < 3; ++column) CHECK(found.map.at(row, column) == expected[row][column]);
        CHECK(found.map.dx == 6e-6 / 3);
        CHECK(found.map.dy == 1e-6);
        CHECK(found.record.said("trailer").empty());
    }
    CHECK(contains(read(file("Title = a b\n" + fields)).record.sentences()[0], "\"a b\""));
    CHECK(read(file(fields, six + "abc")).record.said("trailer") == "3 bytes, not read");
    CHECK(read(file(replaced("ZUnits = m", "ZUnits = nm"))).map.at(0, 1) == 2 * 1e-9);
    CHECK(read(file(replaced("XYUnits = m", "XYUnits = um"))).map.dy == 2e-6 * 1e-6 / 2);
}

TEST_CASE("NaN and infinity are missing") {
    std::string data = six;
    data.replace(4, 4, "\0\0\xC0\x7F"s);
    CHECK(read(file(fields, data)).record.missing == 1);
    CHECK(std::isnan(read(file(fields, data)).map.at(0, 1)));
    data.replace(12, 4, "\0\0\x80\xFF"s);
    CHECK(read(file(fields, data)).record.missing == 2);
    CHECK(std::isnan(read(file(fields, data)).map.at(1, 0)));
}

TEST_CASE("Fields that are not there, or cannot be meant, are refused by name") {
    for (const char* field :
         {"XRes = 3\n", "YRes = 2\n", "XReal = 6e-06\n", "YReal = 2e-06\n", "XYUnits = m\n", "ZUnits = m\n"}) {
        const std::string name(field, std::strchr(field, ' '));
        CAPTURE(name);
        CHECK(contains(refusal(file(replaced(field, ""))), "states no " + name));
        CHECK(contains(refusal(file(fields + field)), "line 8: states \"" + name + "\" again"));
    }
    CHECK(contains(refusal(file(replaced("ZUnits = m", "ZUnits = V"))), "ZUnits = \"V\": must be a unit of length"));
    CHECK(contains(refusal(file(replaced("XRes = 3", "XRes = 2.5"))), "XRes = 2.5"));
    CHECK(contains(refusal(file(replaced("XRes = 3", "XRes = 0"))), "XRes = 0"));
    CHECK(contains(refusal(file(replaced("XRes = 3", "XRes = x"))), "XRes"));
    CHECK(contains(refusal(file(replaced("XReal = 6", "XReal = -6"))), "XReal = -6"));
    CHECK(contains(refusal(file("words\n" + fields)), "line 2: \"words\" has no equals sign"));
    CHECK(contains(refusal(file(replaced("XRes = 3\nYRes = 2", "XRes = 4294967295\nYRes = 4294967295"))),
                   "declares 4294967295 x 4294967295 heights of 4 bytes, but holds 24"));
    std::string padded = "Gwyddion Simple Field 1.0\n" + fields;
    padded += std::string("\0x\0\0", 4);
    if (padded.find('\0') % 4 < 3) CHECK(contains(refusal(padded + six), "must have NUL bytes"));
    CHECK(contains(refusal("Gwyddion Simple Field 1.0\n" + fields), "has no NUL byte"));
    CHECK(contains(refusal("nothing"), "does not begin as a simple field"));
}

TEST_CASE("A row of a simple field is a profile") {
    std::string data;
    for (int i = 0; i < 3; ++i) data += six;
    const std::string row = file("XRes = 18\nYRes = 1\nXReal = 18e-6\nYReal = 1\nXYUnits = m\nZUnits = m\n", data);
    CHECK(io::read_surface(row, "file").is_profile());
}

}  // namespace gsf_test
