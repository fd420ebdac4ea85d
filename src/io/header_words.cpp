// SPDX-License-Identifier: BSD-3-Clause
#include "io/header_words.hpp"

namespace fstiff::inline v0_1::io::detail {

bool is_word(std::string_view key, std::string_view word) {
    if (key == word) return true;
    bool ascii = false;
    while (!key.empty() && !word.empty()) {
        const std::size_t length = std::max<std::size_t>(utf8_length(word), 1);
        const bool plain = length == 1;
        if (plain ? key.front() != word.front() : static_cast<unsigned char>(key.front()) < 0x80) return false;
        ascii = ascii || (plain && word.front() != ' ');
        key.remove_prefix(1);
        word.remove_prefix(length);
    }
    return ascii && key.empty() && word.empty();
}

}  // namespace fstiff::inline v0_1::io::detail
