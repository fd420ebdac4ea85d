// SPDX-License-Identifier: BSD-3-Clause
#include "support/samples.hpp"

namespace npy_test {

using namespace fstiff;
using test::contains;
using namespace std::string_literals;

namespace {

const test::FormReader read{io::SurfaceFormat::npy, {.units = "nm", .dx = 1e-6, .dy = 2e-6}};
const test::RefusalOf refusal(read);

/// A file of version 1.0 with the header \p text, padded to a multiple of 64 bytes as NumPy does.
std::string file(std::string text, const std::string& data, int version = 1) {
    const std::size_t before = version == 1 ? 10 : 12;
    while ((before + text.size() + 1) % 64 != 0) text += ' ';
    text += '\n';
    std::string bytes = "\x93NUMPY" + std::string(1, static_cast<char>(version)) + '\0';
    for (std::size_t i = 0, rest = text.size(); i < before - 8; ++i, rest /= 256)
        bytes += static_cast<char>(rest % 256);
    return bytes + text + data;
}
std::string header(const std::string& type, const std::string& shape = "(2, 3)", bool fortran = false) {
    return "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': " + shape + ", }";
}
template <class T>
std::string bytes_of(std::initializer_list<double> values, bool big = false) {
    std::string all;
    for (const double value : values) all += test::bytes_of(static_cast<T>(value), big);
    return all;
}

}  // namespace

TEST_CASE("The bytes that NumPy writes are read") {
    // numpy.save of numpy.array([[1.5, -2], [3, 0.25]], '>f4'), written out by hand from the description of the format
    const std::string bytes = "\x93NUMPY\x01\0\x76\0"s + "{'descr': '>f4', 'fortran_order': False, 'shape': (2, 2), }" +
                              std::string(58, ' ') + "\n" + "\x3F\xC0\0\0\xC0\0\0\0\x40\x40\0\0\x3E\x80\0\0"s;
    REQUIRE(bytes.size() == 128 + 16);
    const io::Reading found = read(bytes);
    CHECK(found.map.at(0, 0) == 1.5 * 1e-9);
    CHECK(found.map.at(0, 1) == -2 * 1e-9);
    CHECK(found.map.at(1, 0) == 3 * 1e-9);
    CHECK(found.map.at(1, 1) == 0.25 * 1e-9);
    CHECK(found.map.dx == 1e-6);
    CHECK(found.map.dy == 2e-6);
    CHECK(contains(found.record.said("form"), ">f4"));
    CHECK(found.record.resolution == 0);
}

TEMPLATE_TEST_CASE("Numbers of every type, byte order and order of the indices are read", "", float, double,
                   std::int8_t, std::int16_t, std::int32_t, std::int64_t, std::uint8_t, std::uint16_t, std::uint32_t,
                   std::uint64_t) {
    const bool big = GENERATE(false, true), fortran = GENERATE(false, true);
    const bool real = std::is_floating_point_v<TestType>;
    const std::string kind = (real ? "f" : std::is_signed_v<TestType> ? "i" : "u") + std::to_string(sizeof(TestType));
    const std::string type = (sizeof(TestType) == 1 ? "|" : big ? ">" : "<") + kind;
    CAPTURE(type, fortran);
    const double low = std::is_signed_v<TestType> ? -5 : 5;
    const std::string data =
        fortran ? bytes_of<TestType>({low, 4, 2, 100, 3, 6}, big) : bytes_of<TestType>({low, 2, 3, 4, 100, 6}, big);
    const io::Reading found = read(file(header(type, "(2, 3)", fortran), data));
    const double expected[2][3] = {{low, 2, 3}, {4, 100, 6}};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column) CHECK(found.map.at(row, column) == expected[row][column] * 1e-9);
    CHECK(found.record.resolution == (real ? 0 : 1e-9));
    CHECK(contains(found.record.sentences()[0], fortran ? "Fortran" : "order of C"));
}

TEST_CASE("One dimension, one row and one column are a profile of the spacing given") {
    const std::string shape = GENERATE("(16,)", "(1, 16)", "(16, 1)", "(16L,)");
    const std::string bytes =
        file(header("<i2", shape), bytes_of<std::int16_t>({1, 2, 3, 4, 5, 6, 7, 9, 1, 2, 3, 4, 5, 6, 7, 8}));
    const io::Surface found = io::read_surface(bytes, "file", {.units = "um", .spacing = 5e-7});
    REQUIRE(found.is_profile());
    CHECK(found.profile().spacing == 5e-7);
    CHECK(found.profile().heights[7] == 9 * 1e-6);
    CHECK(contains(refusal(bytes, {.units = "um"}), "states no steps and none are given; must be given as spacing"));
    CHECK(contains(refusal(bytes, {.units = "um", .spacing = 1e-6, .dx = 1e-6}), "holds a profile"));
    CHECK(contains(refusal(bytes, {.units = "um", .spacing = -1}), "spacing = -1"));
}

TEST_CASE("Units and steps are asked for, and taken in one way only") {
    const std::string bytes = file(header("<f8"), bytes_of<double>({1, 2, 3, 4, 5, 6}));
    CHECK(contains(refusal(bytes, {.dx = 1e-6, .dy = 1e-6}), "states no unit of the heights"));
    CHECK(contains(refusal(bytes, {.units = "nm"}), "states no steps; must be given as dx and dy"));
    CHECK(contains(refusal(bytes, {.units = "nm", .dx = 1e-6, .dy = 1e-6, .width = 1e-6}),
                   "dx and width are both given"));
    CHECK(contains(refusal(bytes, {.units = "nm", .spacing = 1e-6, .dy = 1e-6}), "must not be given with dx"));
    const auto square = read(bytes, {.units = "nm", .spacing = 1e-6});
    CHECK(square.map.dx == 1e-6);
    CHECK(square.map.dy == 1e-6);
    CHECK(contains(refusal(bytes, {.units = "V", .dx = 1e-6, .dy = 1e-6}), "is not a unit of length"));
    const auto sized = read(bytes, {.units = "um,nm", .width = 3e-6, .height = 8e-6});
    CHECK(sized.map.dx == 3e-6 / 3);
    CHECK(sized.map.dy == 4e-6);
    CHECK(sized.map.at(1, 2) == 6 * 1e-9);
    CHECK(contains(test::refusal([&] { (void)io::read_surface(bytes, "file", {.column = 2}); }), "no use for column"));
}

TEST_CASE("Missing points are NaN, infinity and the number given, and a number that looks like one is refused") {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    CHECK(read(file(header("<f8"), bytes_of<double>({1, nan, 3, 4, 5, 6}))).record.missing == 1);
    const std::string marked = file(header("<i4"), bytes_of<std::int32_t>({1, -9999, 3, -9999, 5, 6}));
    CHECK(contains(refusal(marked), "must be given as missing"));
    io::SurfaceOptions options = read.options;
    options.missing = "-9999";
    CHECK(read(marked, options).record.missing == 2);
    CHECK(std::isnan(read(marked, options).map.at(1, 0)));
    options.missing = "none";
    CHECK(read(marked, options).record.missing == 0);
    CHECK(std::isnan(read(file(header("<f8"), bytes_of<double>({1, 2, 3, 4, -infinite, 6}))).map.at(1, 1)));
    CHECK(contains(refusal(file(header("<f8"), bytes_of<double>({1, 1, 1, 1, 1, 1}))), "constant height"));
}

TEST_CASE("Headers of versions 2 and 3, keys in any order, and a trailer are read") {
    const std::string data = bytes_of<float>({1, 2, 3, 4, 5, 6});
    for (const int version : {2, 3}) CHECK(read(file(header("<f4"), data, version)).map.at(1, 2) == 6 * 1e-9);
    CHECK(read(file("{\"shape\":(2,3),\"fortran_order\":False,\"descr\":\"<f4\"}", data)).map.columns == 3);
    CHECK(read(file(header("<f4"), data + "more")).record.said("trailer") == "4 bytes, not read");
    CHECK(contains(refusal(file(header("<f4"), data, 4)), "version = 4: must be 1, 2 or 3"));
}

TEST_CASE("Damaged headers are refused with the reason before memory is allocated") {
    const std::string data = bytes_of<double>({1, 2, 3, 4, 5, 6});
    for (const char* type : {"<f2", "<c8", "|S3", "|O", "<f16", "=f8", "|f8", "f8", "<i3", "", "<u8x"})
        CHECK(!refusal(file(header(type), data)).empty());
    CHECK(contains(refusal(file(header("<f2"), data)), "descr = \"<f2\""));
    CHECK(contains(refusal(file("{'descr': [('x', '<f8')], 'fortran_order': False, 'shape': (6,), }", data)),
                   "goes wrong at"));
    for (const char* shape : {"()", "(1, 2, 3)", "(0, 6)", "(6, 0)", "(1,)", "(-2, 3)", "(2.0, 3)", "2", "(2 3", "(,)",
                              "(4294967296, 2)", "(99999999999999999999, 2)"})
        CHECK(!refusal(file(header("<f8", shape), data)).empty());
    CHECK(contains(refusal(file(header("<f8", "(4294967295, 4294967295)"), data)),
                   "declares 4294967295 x 4294967295 numbers of 8 bytes, but holds 48"));
    CHECK(contains(refusal(file("{'descr': '<f8', 'shape': (2, 3)}", data)), "without descr, fortran_order or shape"));
    CHECK(contains(refusal(file("{'descr': '<f8', 'fortran_order': 1, 'shape': (2, 3)}", data)), "goes wrong at \"1,"));
    CHECK(contains(refusal(file("{'kind': 1}", data)), "goes wrong at \"kind\""));
    CHECK(contains(refusal("nothing"), "does not begin as an array"));
}

TEST_CASE("Every array cut short is refused with a sentence, and every byte may be wrong") {
    const std::string whole = file(header("<f8"), bytes_of<double>({1, 2, 3, 4, 5, 6}));
    REQUIRE(refusal(whole).empty());
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CAPTURE(size);
        REQUIRE(!refusal(whole.substr(0, size)).empty());
    }
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (const char byte : {'\0', '\xFF', '9', '\''}) {
            std::string bytes = whole;
            bytes[at] = byte;
            (void)refusal(bytes);  // anything but a domain_error ends the test
        }
}

}  // namespace npy_test
