// SPDX-License-Identifier: BSD-3-Clause
#include "io/utf16.hpp"

#include "support/samples.hpp"

namespace utf16_test {

using namespace fstiff;
using namespace std::string_literals;

namespace {

/// \p text, whose characters are all below U+0800 and given as code points, with a byte order mark.
std::string utf16(const std::u16string& text, bool big) {
    std::string bytes = big ? "\xFE\xFF" : "\xFF\xFE";
    for (const char16_t c : text) {
        const char high = static_cast<char>(c / 256), low = static_cast<char>(c % 256);
        bytes += big ? high : low;
        bytes += big ? low : high;
    }
    return bytes;
}
std::u16string rows(const std::u16string& titles) {
    std::u16string text = titles + u"\r\n";
    for (int i = 0; i < 20; ++i)
        for (const char c : std::to_string(i) + "\t" + std::to_string(i * i % 7) + "\r\n")
            text += static_cast<char16_t>(c);
    return text;
}
std::string utf8(const std::string& bytes) {
    std::size_t wrong = 0;
    return io::detail::utf8_of_utf16(bytes, wrong).value_or("none " + std::to_string(wrong));
}
const test::RefusalOf refusal{test::FileReader()};

}  // namespace

TEST_CASE("Characters of one to four bytes come out as the Unicode Standard lists them") {
    // table 3-4 of the standard: U+004D, U+0430, U+4E8C, U+10302
    CHECK(utf8("\xFE\xFF\0\x4D\x04\x30\x4E\x8C\xD8\0\xDF\x02"s) == "\x4D\xD0\xB0\xE4\xBA\x8C\xF0\x90\x8C\x82");
    CHECK(utf8("\xFF\xFE\x4D\0\x30\x04\x8C\x4E\0\xD8\x02\xDF"s) == "\x4D\xD0\xB0\xE4\xBA\x8C\xF0\x90\x8C\x82");
    CHECK(utf8("\xFF\xFE").empty());
    CHECK(utf8("\xFE\xFF\0\x7F\0\x80\x07\xFF\x08\0\xFF\xFF"s) == "\x7F\xC2\x80\xDF\xBF\xE0\xA0\x80\xEF\xBF\xBF");
    CHECK(utf8("\xFE\xFF\xDB\xFF\xDF\xFF"s) == "\xF4\x8F\xBF\xBF");
}

TEST_CASE("Halves of characters are refused at their byte") {
    CHECK(utf8("\xFE\xFF\0\x4D\x04"s) == "none 4");
    CHECK(utf8("\xFE\xFF\0\x4D\xD8\0"s) == "none 4");
    CHECK(utf8("\xFE\xFF\xD8\0\0\x4D"s) == "none 2");
    CHECK(utf8("\xFE\xFF\xDC\0\xD8\0"s) == "none 2");
    CHECK(utf8("\xFE\xFF\xD8\0\xE0\0"s) == "none 2");
    CHECK(test::contains(refusal("\xFE\xFF\0\x4D\x04"s), "byte 5 begins no whole character"));
}

TEST_CASE("A text in UTF-16 is read like its twin in UTF-8 and its record reports it") {
    const bool big = GENERATE(false, true);
    const std::u16string text = rows(u"x [\u00B5m]\tz [nm]");
    std::string narrow;
    for (const char16_t c : text) narrow += c == u'\u00B5' ? "\xC2\xB5" : std::string(1, static_cast<char>(c));
    const io::Surface wide = io::read_surface(utf16(text, big), "file"), plain = io::read_surface(narrow, "file");
    REQUIRE(wide.is_profile());
    CHECK(wide.profile().heights == plain.profile().heights);
    CHECK(wide.profile().spacing == plain.profile().spacing);
    CHECK(wide.profile().heights[2] == 4e-9);
    CHECK(wide.record.sentences().back() == "encoding: UTF-16, from its byte order mark");
    CHECK(wide.record.sentences().size() == plain.record.sentences().size() + 1);
}

TEST_CASE("A text in UTF-16 cut short is read or refused") {
    const std::string whole = utf16(rows(u"x [\u00B5m]\tz [nm]"), false);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        CAPTURE(size);
        const std::string text = refusal(whole.substr(0, size));
        REQUIRE((size % 2 == 0 || !text.empty()));
    }
    CHECK(test::contains(refusal(whole.substr(2)), "UTF-16 without its byte order mark"));
    CHECK(test::contains(refusal("\xFF\xFE\0\0\x31\0\0\0"s), "NUL bytes"));  // UTF-32
}

}  // namespace utf16_test
