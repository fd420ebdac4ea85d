// SPDX-License-Identifier: BSD-3-Clause
// Whole archives come from tests/support/zip.hpp, laid out by the specification; those of an independent writer,
// zipfile of Python, are read in tests/python/test_wheel.py.
#include "io/zip_archive.hpp"

#include "support/accuracy.hpp"
#include "support/catch.hpp"
#include "support/zip.hpp"

namespace zip_archive_test {

using namespace fstiff;
using test::ZipLies;
using test::zipped;

namespace {

const std::string text(1000, 'a');
const test::Members two{{"a", text}, {"b/c", "other"}};

/// The first file of an archive, or the refusal.
std::string first(const std::string& bytes, const io::X3pLimits& limits = {}) {
    std::string found;
    const std::string refusal =
        test::refusal([&] { found = io::detail::ZipArchive(bytes, "file", limits).content(0); });
    return refusal.empty() ? found : refusal;
}
bool refused(const ZipLies& lies, const std::string& sentence, bool deflate = true) {
    const std::string found = first(zipped(two, deflate, lies));
    CAPTURE(found);
    CHECK(found == "file: " + sentence);
    return found.ends_with(sentence);
}

const std::string no_archive = "is not a zip archive, or a damaged one; must be a whole archive";
const std::string damaged = "\"a\" is damaged; must be a whole archive";
const std::string unreadable = "\"a\" has no readable entry; must be a whole archive";

}  // namespace

TEST_CASE(
    "Stored and deflated files of an archive are read with sizes of 32 or 64 bits and with or without a comment") {
    const bool deflate = GENERATE(true, false), sizes64 = GENERATE(true, false);
    std::string bytes = zipped(two, deflate, {.sizes64 = sizes64});
    if (GENERATE(true, false)) {
        bytes[bytes.size() - 2] = 3;
        bytes += "end";
    }
    const io::detail::ZipArchive archive(bytes, "file", {});
    CHECK(archive.names() == std::vector<std::string>{"a", "b/c"});
    CHECK(archive.size(0) == text.size());
    CHECK(archive.content(0) == text);
    CHECK(archive.content(archive.find("b/c").value()) == "other");
    CHECK(!archive.find("c"));
}

TEST_CASE("Empty files and empty archives are read") {
    CHECK(first(zipped({{"a", ""}}, GENERATE(true, false))).empty());
    CHECK(io::detail::ZipArchive(zipped({}), "file", {}).names().empty());
}

TEST_CASE("Two files of one name are refused where that name is asked for") {
    const std::string bytes = zipped({{"a", "1"}, {"a", "2"}, {"b", "3"}});
    const io::detail::ZipArchive archive(bytes, "file", {});
    CHECK(archive.find("b") == 2u);
    CHECK(test::refusal([&] { (void)archive.find("a"); }) == "file: holds two files \"a\"; must hold one");
}

TEST_CASE("A directory whose count, length and entries disagree is refused") {
    CHECK(refused({.count = 1}, no_archive));
    CHECK(refused({.count = 3}, no_archive));
    CHECK(refused({.count = 0}, no_archive));
    CHECK(refused({.count = ~std::uint64_t(0), .sizes64 = true}, no_archive));
    CHECK(first(zipped(two), {.files = 1}) == "file: holds 2 files; must be at most 1");
}

TEST_CASE("An archive that is cut short anywhere is refused") {
    const std::string bytes = zipped(two, true, {.sizes64 = GENERATE(true, false)});
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        CAPTURE(size);
        REQUIRE(first(bytes.substr(0, size)) == "file: " + no_archive);
    }
}

TEST_CASE("A file that holds more or fewer bytes than its entry states is refused") {
    for (const bool deflate : {true, false}) {
        CAPTURE(deflate);
        // the check sum is that of the bytes that the entry admits: only their count is wrong
        const auto crc = [](std::size_t size) {
            const std::string part = text.substr(0, size);
            return static_cast<std::uint32_t>(crc32(0, reinterpret_cast<const Bytef*>(part.data()), uInt(size)));
        };
        CHECK(refused({.size = 500, .crc = crc(500)}, damaged, deflate));
        CHECK(refused({.size = 999, .crc = crc(999)}, damaged, deflate));
        CHECK(refused({.size = 0, .crc = crc(0)}, damaged, deflate));
        CHECK(refused({.size = 1001}, damaged, deflate));
        CHECK(refused({.behind = "x"}, damaged, deflate));
        CHECK(refused({.crc = 1}, damaged, deflate));
    }
    CHECK(refused({.packed = 3}, damaged));
    CHECK(refused({.packed = 0}, damaged));
}

TEST_CASE("Sizes and places outside of the file are refused") {
    CHECK(refused({.packed = 5000},
                  "\"a\" declares 5000 deflated bytes, more than the file has; must be a whole archive"));
    const std::size_t length = zipped(two).size();
    CHECK(refused({.packed = length}, unreadable));
    CHECK(refused({.offset = length}, unreadable));
    CHECK(refused({.offset = 0xfffffff0}, unreadable));
    CHECK(refused({.offset = ~std::uint64_t(0), .sizes64 = true}, unreadable));
    CHECK(refused({.offset = 1}, unreadable));
    CHECK(refused({.size = ~std::uint64_t(0), .sizes64 = true},
                  "\"a\" would inflate to 18446744073709551615 bytes; must be at most 1073741824"));
}

TEST_CASE("Encrypted files and other methods are refused") {
    CHECK(refused({.flags = 1}, "\"a\" is encrypted; must not be"));
    CHECK(refused({.method = 12}, "\"a\" cannot be inflated; must be deflated or stored"));
    CHECK(first(zipped(two, true, {.flags = 8})) == text);  // sizes after the bytes too; those of the directory count
}

}  // namespace zip_archive_test
