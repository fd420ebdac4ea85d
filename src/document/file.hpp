// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Files that a scene names, and the texts of numbers and lists in its messages.

#include "io/file_name.hpp"

#include <fstiff/core/error.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fstiff::inline v0_1::io {
enum class Dimension;
}

namespace fstiff::document {

using io::detail::name_of_path;
using io::detail::path_of;

/// Options of reading a file that do not fit together, or have no meaning: the fault of the caller, not of the file.
class option_error : public domain_error {
public:
    using domain_error::domain_error;
};

/// Target of \p file: at the end of symbolic links, which stay links, even if the last one leads to a missing
/// file. \throws file_error for links that lead in a circle.
[[nodiscard]] std::filesystem::path output_target(const std::string& file);
/// All bytes of \p file, or somewhat more than \p enough; "-" is standard input. \throws file_error for a file that is
/// missing, unreadable or without an end, domain_error for one that is empty or too long.
[[nodiscard]] std::string read_all(const std::string& file, std::uint64_t enough = std::uint64_t(1) << 31);
/// Most bytes of the text of a scene or a grid.
inline constexpr std::uint64_t longest_scene = std::uint64_t(1) << 20;
/// How messages call \p file.
[[nodiscard]] std::string display_name(const std::string& file);

/// Whether \p character of UTF-8 moves a cursor, ends a line or turns the direction of writing: below U+0020, U+007F
/// to U+009F, U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069.
[[nodiscard]] bool is_control(std::string_view character);
/// \p text of UTF-8 without control characters (below U+0020, U+007F to U+009F, those of lines and of the direction of
/// writing), so that no name of a file moves a cursor, turns a line round or begins one: each is a blank, but for those
/// in \p kept. Bytes that are no UTF-8 are U+FFFD.
[[nodiscard]] std::string printable(std::string_view text, std::string_view kept = {});

/// How tables and titles call \p file.
[[nodiscard]] inline std::string shown_name(const std::string& file) { return printable(display_name(file)); }

/// Runs \p call; what it throws is put after the name of the file.
template <class Call>
auto about_file(const std::string& file, const Call& call) {
    return detail::located(Place{.file = display_name(file)}, call);
}

/// SHA-256 (FIPS 180-4) of a whole text in hexadecimal digits, so that a result names the very file it came from. No
/// security depends on it.
[[nodiscard]] std::string sha256(std::string_view text);

/// A quantity with its unit, greater than 0, of the option called \p name in messages [SI]. \throws domain_error, which
/// quotes \p text.
[[nodiscard]] double parse_positive(const std::string& text, io::Dimension dimension, std::string_view name);

/// 17 significant digits, '.' as the decimal mark. \throws std::logic_error for NaN and infinity: never printed.
[[nodiscard]] std::string exact(double value);
/// The same for people: \p digits significant digits, without an exponent below 1e5 ("110", not "1.1e+02").
[[nodiscard]] std::string rounded(double value, int digits = 5);
/// The fewest digits that read back as the same number, for echoing what somebody wrote.
[[nodiscard]] std::string shortest(double value);
/// \p items quoted as "a", "b", "c".
[[nodiscard]] std::string list_of(std::span<const std::string_view> items);
/// The word of \p words with the same letters as \p wrong, whatever their capitals; else the nearest by its letters, if
/// \p wrong has four or more: shorter ones mean something else. Empty where none is near.
[[nodiscard]] std::string_view nearest_word(std::string_view wrong, std::span<const std::string_view> words);
/// " (did you mean X?)" for the nearest of \p words, or nothing where none is near.
[[nodiscard]] std::string suggestion(std::string_view wrong, const std::vector<std::string>& words);
/// list_of with the suggestion after it: all \p words, and the nearest of them.
[[nodiscard]] std::string list_and_suggestion(std::string_view wrong, std::span<const std::string_view> words);

}  // namespace fstiff::document
