// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines.hpp"

#include "io/file_name.hpp"

#include <algorithm>

namespace fstiff::inline v0_1::io::detail {

void refuse_line(const std::string& name, std::size_t line, std::initializer_list<Part> parts) {
    std::string reason;
    for (const Part& part : parts) reason += part.text;
    throw domain_error(reason).with_place({.file = name, .line = line});
}
void refuse_file(const std::string& name, std::initializer_list<Part> parts) { refuse_line(name, 0, parts); }
void refuse_field(const std::string& name, std::string_view field, const std::string& value, std::string_view allowed) {
    throw domain_error({.parameter = field, .value = value, .allowed = allowed}).with_place({.file = name});
}

namespace {

/// Refuses \p bytes that are not text, and names what they are.
[[noreturn]] FSTIFF_COLD void refuse_binary(const std::string& name, std::string_view bytes) {
    const std::string known = known_binary_refusal(bytes);
    if (!known.empty()) refuse_file(name, {known});
    refuse_file(name,
                {"is binary, or UTF-16 without its byte order mark (it holds NUL bytes); must be ", readable_forms(),
                 "; text in UTF-8, UTF-16 with a byte order mark, or an 8-bit code page: export the heights from "
                 "the program that wrote it"});
}

constexpr std::size_t longest_line = std::size_t(1) << 20;

/// Refuses text that is of no surface as soon as this shows, since it may have no end: a line that goes on, JSON apart,
/// or no digit in 4 MiB. \p block is the last part of \p bytes.
void require_lines(std::string_view block, const std::string& name, std::string_view bytes) {
    constexpr std::size_t enough = std::size_t(1) << 22;
    const std::size_t end = bytes.find_last_of("\n\r"), begin = end == std::string_view::npos ? 0 : end + 1;
    const bool is_long = bytes.size() - begin > longest_line && bytes.front() != '{';
    const bool is_empty = bytes.size() > enough && bytes.size() - block.size() <= enough &&
                          bytes.find_first_of("0123456789") == std::string_view::npos;
    if (!(is_long || is_empty) || may_hold_nul_bytes(bytes)) return;
    if (is_empty) refuse_file(name, {"has no digit in its first 4 MiB; must hold numbers"});
    const char end_of_line = bytes.find('\n') == std::string_view::npos ? '\r' : '\n';
    const auto lines = static_cast<std::size_t>(std::count(bytes.begin(), bytes.end(), end_of_line));
    refuse_line(name, lines + 1, {"is longer than 2^20 characters; must be shorter"});
}

}  // namespace

bool takes_more(std::string_view block, const std::string& name, std::string& bytes, std::uint64_t enough) {
    bytes += block;
    if (block.find('\0') != std::string_view::npos && !may_hold_nul_bytes(bytes)) return false;
    require_lines(block, name, bytes);
    if (bytes.size() > most_bytes) refuse_file(name, {"is longer than 2^31 bytes (2 GiB); must be shorter"});
    return bytes.size() <= enough;
}

void append_bytes(std::istream& input, const std::string& name, std::string& bytes, std::uint64_t enough) {
    std::vector<char> chunk(std::size_t(1) << 16);
    while (input.read(chunk.data(), static_cast<std::streamsize>(chunk.size())), input.gcount() > 0)
        if (!takes_more({chunk.data(), static_cast<std::size_t>(input.gcount())}, name, bytes, enough)) return;
    if (input.bad()) throw file_error(name, "cannot be read to its end; must be a readable file");
}

NamedBytes read_bytes(std::istream& input, std::string_view name) {
    NamedBytes file{std::string(name), {}};
    append_bytes(input, file.name, file.bytes);
    return file;
}

NamedBytes read_bytes(const std::filesystem::path& path, std::string_view what) {
    const std::string name = name_of_path(path);
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored))
        throw file_error(name, "is a folder; must be a file of " + std::string(what));
    std::ifstream input(path, std::ios::binary);
    if (!input) throw file_error(name, "cannot be opened; must be an existing, readable file");
    return read_bytes(input, name);
}

namespace {

/// Writes the minus sign of Unicode as that of ASCII, as .NET does not in some languages.
void write_minus_signs(std::string& text) {
    constexpr std::string_view minus = "\xE2\x88\x92";
    std::size_t to = text.find(minus);
    if (to == std::string::npos) return;
    for (std::size_t from = to; from < text.size(); ++to) {
        const bool found = text.compare(from, minus.size(), minus) == 0;
        text[to] = found ? '-' : text[from];
        from += found ? minus.size() : 1;
    }
    text.resize(to);
}

/// Takes away the end of a text of MS-DOS, Ctrl-Z and the blanks after it.
void drop_end_sign(std::string& text) {
    const std::size_t last = text.find_last_not_of(" \r\n\t\x1A");
    if (text.find('\x1A', last == std::string::npos ? 0 : last) != std::string::npos) text.resize(last + 1);
}

}  // namespace

std::string text_of(std::string bytes, const std::string& name, std::string_view what) {
    if (is_utf16(bytes)) {
        std::size_t wrong = 0;
        auto text = utf8_of_utf16(bytes, wrong);
        if (!text)
            refuse_file(name, {"begins as UTF-16, but byte ", wrong + 1,
                               " begins no whole character of it; must be UTF-16 throughout, or UTF-8"});
        bytes = std::move(*text);
    }
    if (bytes.find('\0') != std::string::npos || !known_binary_refusal(bytes).empty()) refuse_binary(name, bytes);
    if (bytes.empty()) refuse_file(name, {"is empty; must be delimited text with " + std::string(what)});
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
    write_minus_signs(bytes);
    drop_end_sign(bytes);
    return bytes;
}

std::vector<Line> lines_of(std::string_view text, const std::string& name, std::size_t& count) {
    const char end_of_line = text.find('\n') == std::string_view::npos ? '\r' : '\n';
    std::vector<Line> lines;
    count = 0;
    while (!text.empty()) {
        const std::size_t end = (std::min)(text.find(end_of_line), text.size());
        ++count;
        if (end > longest_line) refuse_line(name, count, {"is longer than 2^20 characters; must be shorter"});
        // a tab at the end of a line may be an empty cell: only blanks and carriage returns go
        std::string_view line = text.substr(0, end);
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
        while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
        if (!trimmed(line).empty()) lines.push_back({line, count});
        text.remove_prefix((std::min)(end + 1, text.size()));
    }
    return lines;
}

}  // namespace fstiff::inline v0_1::io::detail
