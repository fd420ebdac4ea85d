// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Text in UTF-16, as some programs on Windows export it, turned into UTF-8.
///
/// Reference   The Unicode Standard, 3.9 (encoding forms) and 3.10 (byte order mark)
/// Valid       bytes that begin with a byte order mark, of either byte order; halves of a surrogate pair are refused

#include "io/binary_numbers.hpp"

#include <optional>
#include <string>

namespace fstiff::inline v0_1::io::detail {

/// Whether \p bytes begin with a byte order mark of UTF-16.
bool is_utf16(std::string_view bytes);

/// The text of \p bytes, which is_utf16(), without its mark; none when byte \p wrong (from 0) begins no whole
/// character.
std::optional<std::string> utf8_of_utf16(std::string_view bytes, std::size_t& wrong);

}  // namespace fstiff::inline v0_1::io::detail
