// SPDX-License-Identifier: BSD-3-Clause
#include "io/header_words.hpp"

#include "support/catch.hpp"

namespace header_words_test {

using namespace fstiff::io::detail;

TEST_CASE("A word is known in UTF-8 and in 8-bit code pages") {
    CHECK(is_one_of_words("breite", width_words));
    CHECK(is_one_of_words("h\xC3\xB6he", height_words));     // UTF-8
    CHECK(is_one_of_words("h\xF6he", height_words));         // CP1252
    CHECK(is_one_of_words("\x8A\xED\xF8ka", width_words));   // CP1250
    CHECK(is_one_of_words("\xA9\xED\xF8ka", width_words));   // ISO 8859-2
    CHECK(is_one_of_words("v\xFD\x9Aka", height_words));     // CP1250
    CHECK(is_one_of_words("unit\xE9s", height_unit_words));  // CP1252
    CHECK(is_one_of_words("\xE5\xB9\x85", width_words));     // Japanese
    CHECK_FALSE(is_one_of_words("\x95\x9D", width_words));   // Shift-JIS has no ASCII letter to know it by
    CHECK_FALSE(is_one_of_words("\xD8\xE8\xF0\xE8\xED\xE0", width_words));  // nor has CP1251
}

TEST_CASE("Other words are not taken for one") {
    for (const char* other :
         {"hohe", "hoehe", "h\xC3\xB6", "h\xC3\xB6hen", "h\xC3\xB6h\xC3\xA9", "", " ", "\xF6", "breit"})
        CHECK_FALSE((is_one_of_words(other, height_words) || is_one_of_words(other, width_words)));
}

}  // namespace header_words_test
