// SPDX-License-Identifier: BSD-3-Clause
#include "io/utf16.hpp"

namespace fstiff::inline v0_1::io::detail {

bool is_utf16(std::string_view bytes) { return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"); }

namespace {

/// Appends the character \p code to \p text, which is UTF-8.
void append_utf8(std::string& text, std::uint32_t code) {
    const auto add = [&](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (code < 0x80) {
        add(code);
        return;
    }
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;  // bytes after the first
    static constexpr std::uint32_t first[] = {0, 0xC0, 0xE0, 0xF0};
    add(first[more] | code >> (6 * more));
    for (int i = more - 1; i >= 0; --i) add(0x80 | (code >> (6 * i) & 0x3F));
}

}  // namespace

std::optional<std::string> utf8_of_utf16(std::string_view bytes, std::size_t& wrong) {
    const bool big = bytes[0] == '\xFE';
    std::string text;
    text.reserve(bytes.size() / 2);
    const auto unit = [&](std::size_t i) { return static_cast<std::uint32_t>(unsigned_at(bytes.substr(i, 2), big)); };
    for (std::size_t i = 2; i < bytes.size(); i += 2) {
        wrong = i;
        if (i + 1 == bytes.size()) return std::nullopt;
        std::uint32_t code = unit(i);
        if (code >= 0xD800 && code < 0xE000) {
            if (code >= 0xDC00 || i + 3 >= bytes.size()) return std::nullopt;
            const std::uint32_t low = unit(i + 2);
            if (low < 0xDC00 || low >= 0xE000) return std::nullopt;
            code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
            i += 2;
        }
        append_utf8(text, code);
    }
    return text;
}

}  // namespace fstiff::inline v0_1::io::detail
