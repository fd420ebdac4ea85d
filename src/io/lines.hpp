// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// The bytes and the lines of a file, and how its readers refuse it.
///
/// Valid       lines up to 2^20 characters, files up to 2^31 bytes

#include "io/known_binary.hpp"
#include "io/number.hpp"
#include "io/utf16.hpp"

#include <fstiff/core/error.hpp>

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <istream>
#include <utility>
#include <vector>

namespace fstiff::inline v0_1::io::detail {

/// A part of a sentence: text, a whole number, or a number with ten digits.
struct Part {
    std::string text;
    template <class T>
    Part(const T& part) {
        if constexpr (std::integral<T>)
            text = std::to_string(part);
        else if constexpr (Real<T>)
            text = number_text(part);
        else
            text = part;
    }
};

[[noreturn]] FSTIFF_COLD void refuse_line(const std::string& name, std::size_t line, std::initializer_list<Part> parts);
[[noreturn]] void refuse_file(const std::string& name, std::initializer_list<Part> parts);
[[noreturn]] void refuse_field(const std::string& name, std::string_view field, const std::string& value,
                               std::string_view allowed);

/// A file, and its name in messages.
struct NamedBytes {
    std::string name, bytes;
};

/// Limit of the size of a file: a map of 8000 x 8000 points with 17 digits each has 1.5e9 bytes.
inline constexpr std::uint64_t most_bytes = std::uint64_t(1) << 31;

/// Appends \p block to \p bytes. \return whether append_bytes needs more
bool takes_more(std::string_view block, const std::string& name, std::string& bytes, std::uint64_t enough);
/// Appends the bytes of \p input, to its end, to somewhat more than \p enough, or to the end of the first block with a
/// NUL byte of a text, not a binary form that is read: no reader takes that, and endless input ends there.
/// \throws domain_error for text without an end of line in 2^20 characters, or a digit in 4 MiB, file_error
void append_bytes(std::istream& input, const std::string& name, std::string& bytes, std::uint64_t enough = most_bytes);
/// The same of a file. A pipe is read while a program writes it, and is waited for 2 s to be; what else makes wait, a
/// device, is refused. \return false where it cannot be opened
[[nodiscard]] bool append_file(const std::filesystem::path& path, const std::string& name, std::string& bytes,
                               std::uint64_t enough = most_bytes);

/// All bytes of \p input.
NamedBytes read_bytes(std::istream& input, std::string_view name);

NamedBytes read_bytes(const std::filesystem::path& path, std::string_view what);

/// \p bytes without a byte order mark, in UTF-8 where they are UTF-16, when they may be text; \p what names the text
/// that must be there.
std::string text_of(std::string bytes, const std::string& name, std::string_view what);

struct Line {
    std::string_view text;  // trimmed
    std::size_t number;     // counted from 1
};

/// Lines that are not blank. \p count receives the number of all lines.
std::vector<Line> lines_of(std::string_view text, const std::string& name, std::size_t& count);

}  // namespace fstiff::inline v0_1::io::detail
