// SPDX-License-Identifier: BSD-3-Clause
#include "io/unpack.hpp"

#include "support/samples.hpp"

#include <functional>

namespace sur_test {

using namespace fstiff;
using test::contains;

namespace {

const test::FormReader read{io::SurfaceFormat::sur};
const test::RefusalOf refusal(read);

/// A file, field by field at the byte that the description names.
struct File {
    int order = 0, objects = 1, type = 2, marked = 0, bits = 16, lowest = 0, columns = 3, rows = 2, inversion = 0;
    float x = 0.5F, y = 0.25F, z = 2;
    std::string x_unit = "\xB5m", z_unit = "nm", comment{}, secret{};
    std::vector<int> numbers{-5, 2, 3, 4, 1000, 6};

    std::string number(std::int64_t value, std::size_t size) const {
        return order == 0 ? test::little(value, size) : test::big(value, size);
    }
    std::string bytes() const {
        std::string all(512, ' ');
        const auto put = [&](std::size_t at, const std::string& field) { all.replace(at, field.size(), field); };
        const auto real = [&](std::size_t at, float value) { put(at, test::bytes_of(value, order != 0)); };
        put(0, "DIGITAL SURF");
        put(12, number(order, 2));
        put(14, number(objects, 2));
        put(16, number(1, 2));
        put(18, number(type, 2));
        put(20, "a surface");
        put(86, number(marked, 2));
        put(98, number(bits, 2));
        put(100, number(lowest, 4));
        put(108, number(columns, 4));
        put(112, number(rows, 4));
        real(120, x);
        real(124, y);
        real(128, z);
        put(180, x_unit);
        put(196, "mm");
        put(212, z_unit + std::string(1, '\0') + "junk");
        put(290, number(inversion, 2));
        put(334, number(static_cast<int>(comment.size()), 2));
        put(336, number(static_cast<int>(secret.size()), 2));
        all += comment + secret;
        for (const int value : numbers) all += number(value, bits == 32 ? 4 : 2);
        return all;
    }
};

}  // namespace

TEST_CASE("Surfaces of 16 and 32 bits and both byte orders are read after a comment and a private zone") {
    const int bits = GENERATE(16, 32), order = GENERATE(0, 257);
    const std::string comment = GENERATE("", "a comment");
    CAPTURE(bits, order, comment);
    const io::Reading found = read(File{.order = order, .bits = bits, .comment = comment, .secret = comment}.bytes());
    REQUIRE(found.map.rows == 2);
    REQUIRE(found.map.columns == 3);
    CHECK(found.map.dx == 0.5 * 1e-6);
    CHECK(found.map.dy == 0.25 * 1e-3);
    const double expected[2][3] = {{-5, 2, 3}, {4, 1000, 6}};
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 3; ++column)
            CHECK(found.map.at(row, column) == expected[row][column] * (2 * 1e-9));
    CHECK(found.record.said("comment and private zone") ==
          (comment.empty() ? "" : std::to_string(2 * comment.size()) + " bytes, not read"));
    CHECK(found.record.said("trailer").empty());
    CHECK(contains(found.record.said("form"), "\"a surface\""));
    CHECK(found.record.warnings.empty());
}

TEST_CASE("The lowest number less 2 is missing where the header marks missing points") {
    const File marked{.marked = 1, .lowest = 2, .numbers = {0, 2, 3, 0, 5, 6}};
    CHECK(read(marked.bytes()).record.missing == 2);
    CHECK(std::isnan(read(marked.bytes()).map.at(1, 0)));
    File plain = marked;
    plain.marked = 0;
    CHECK(read(plain.bytes()).record.missing == 0);
    CHECK(contains(read(plain.bytes()).record.sentences()[3], "none are marked"));
}

TEST_CASE("An inversion warns, a negative step of z turns the heights, and what follows them is a trailer") {
    const io::Reading found = read(File{.inversion = 1, .z = -2}.bytes() + "more");
    CHECK(found.map.at(0, 0) == 5 * (2 * 1e-9));
    CHECK(found.record.said("trailer") == "4 bytes, not read");
    REQUIRE(found.record.warnings.size() == 1);
    CHECK(contains(found.record.warnings[0], "inverted (code 1)"));
    CHECK(io::read_surface(File{.inversion = 1}.bytes(), "file").record.warnings.size() == 1);
}

TEST_CASE("Headers of Digital Surf that cannot be meant are refused with field, value and range") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(contains(refusal(File{.order = 1}.bytes()), "byte order = 256"));
    CHECK(contains(refusal(File{.objects = 2}.bytes()), "number of objects = 2"));
    CHECK(contains(refusal(File{.type = 3}.bytes()), "type of object = 3"));
    CHECK(contains(refusal(File{.bits = 8}.bytes()), "bits of a height = 8: must be 16 or 32"));
    CHECK(contains(refusal(File{.columns = -1}.bytes()), "points of a row x rows = -1 x 2"));
    CHECK(contains(refusal(File{.rows = 0}.bytes()), "3 x 0"));
    CHECK(contains(refusal(File{.x = 0}.bytes()), "step of x = 0"));
    CHECK(contains(refusal(File{.y = -1}.bytes()), "step of y = -1"));
    CHECK(contains(refusal(File{.z = nan}.bytes()), "step of z = nan"));
    CHECK(contains(refusal(File{.x_unit = "s "}.bytes()), "unit of the step of x = \"s\": must be a unit of length"));
    CHECK(contains(refusal(File{.z_unit = "V"}.bytes()), "unit of the step of z"));
    CHECK(contains(refusal(File{.columns = 2147483647, .rows = 2147483647}.bytes()),
                   "declares 2147483647 x 2147483647 heights of 2 bytes, but holds 12"));
    CHECK(contains(refusal(File{.numbers = {1, 1, 1, 1, 1, 1}}.bytes()), "constant height"));
    CHECK(contains(refusal("nothing"), "does not begin as a file of Digital Surf"));
}

TEST_CASE("One row of Digital Surf is a profile") {
    CHECK(read(File{}.bytes()).record.resolution == 2 * 1e-9);
    File row{.type = 1, .columns = 20, .rows = 1, .y = 0, .numbers = {}};
    for (int i = 0; i < 20; ++i) row.numbers.push_back(i * i % 7);
    const io::Surface profile = io::read_surface(row.bytes(), "file");
    REQUIRE(profile.is_profile());
    CHECK(profile.profile().spacing == 0.5 * 1e-6);
}

namespace {

/// Replacement of zlib: a stream is its bytes, each inverted.
bool turn_over(std::string_view stream, std::span<char> out) {
    if (stream.size() != out.size()) return false;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<char>(~stream[i]);
    return true;
}

/// A compressed file of streams of the sizes \p parts (the last has the rest); \p declare(i, size) may lie about
/// them.
std::string compressed(const File& file, std::vector<std::size_t> parts,
                       const std::function<std::size_t(std::size_t, std::size_t)>& declare = {}) {
    std::string all = file.bytes();
    all.replace(0, 12, "DSCOMPRESSED");
    const std::size_t size = file.numbers.size() * (file.bits == 32 ? 4 : 2);
    std::string data = all.substr(all.size() - size), table, streams;
    all.resize(all.size() - size);
    std::size_t done = 0;
    for (const std::size_t part : parts) done += part;
    parts.push_back(size - done);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto inflated = declare ? declare(i, parts[i]) : parts[i];
        table +=
            file.number(static_cast<std::int64_t>(inflated), 4) + file.number(static_cast<std::int64_t>(parts[i]), 4);
        for (const char c : data.substr(0, parts[i])) streams += static_cast<char>(~c);
        data.erase(0, parts[i]);
    }
    return all + file.number(static_cast<std::int64_t>(parts.size()), 4) + table + streams;
}
io::Reading inflated(const std::string& bytes) { return io::detail::read_sur(bytes, "file.sur", turn_over); }
std::string refused(const std::string& bytes) {
    return test::refusal([&] { (void)inflated(bytes); });
}

}  // namespace

TEST_CASE("Compressed files hold what the same file holds that is not, in one stream and in several") {
    const int bits = GENERATE(16, 32), order = GENERATE(0, 257);
    const std::vector<std::size_t> parts =
        GENERATE(std::vector<std::size_t>{}, std::vector<std::size_t>{3}, std::vector<std::size_t>{1, 8});
    CAPTURE(bits, order, parts.size());
    const File file{.order = order, .bits = bits, .comment = "a comment"};
    const io::Reading found = inflated(compressed(file, parts) + "more");
    CHECK(found.map.heights == read(file.bytes()).map.heights);
    CHECK(found.record.said("trailer") == "4 bytes, not read");
    CHECK(contains(found.record.sentences().front(), "form: Digital Surf compressed surface"));
    CHECK(contains(read(file.bytes()).record.sentences().front(), "form: Digital Surf surface"));
}

TEST_CASE("Compressed files are refused without zlib, and where table and streams disagree") {
    const std::string whole = compressed(File{}, {4});
    CHECK(contains(test::refusal([&] { (void)io::detail::read_sur(whole, "file"); }),
                   "is compressed, and this program was built without zlib"));
    CHECK(io::form_of_first_bytes(whole) == io::SurfaceFormat::sur);
    // the streams are turned over, which zlib does not know
    CHECK(contains(test::refusal([&] { (void)io::read_surface(whole, "file"); }),
                   io::reads_compressed_sur() ? "has a stream 1 that does not inflate" : "without zlib"));
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CAPTURE(size);
        REQUIRE(!refused(whole.substr(0, size)).empty());
    }
    const auto lie = [](std::size_t first, std::size_t other) {
        return [=](std::size_t i, std::size_t size) { return size + (i == 0 ? first : other); };
    };
    CHECK(contains(refused(compressed(File{}, {4}, lie(1, std::size_t(-1)))),
                   "stream 1 that does not inflate to the 5 bytes"));
    CHECK(contains(refused(compressed(File{}, {4}, lie(0, 1))), "streams that inflate to 13 bytes; must be as many"));
    CHECK(contains(refused(compressed(File{}, {4}, lie(std::size_t(1) << 30, 0))),
                   "a stream of 4 bytes that inflates to 1073741828; must be at most 200 times"));
    std::string many = whole;
    many.replace(512, 4, "\xFF\xFF\xFF\xFF");
    CHECK(contains(refused(many), "number of streams = 4294967295"));
    CHECK(contains(refused(compressed(File{.columns = 2147483647, .rows = 2147483647}, {4})), "declares 2147483647 x"));
}

}  // namespace sur_test
