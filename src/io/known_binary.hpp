// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Binary files by their first bytes: what a reader of text calls a file that it cannot read, and what to do about it.
///
/// Reference   the public descriptions of the formats
/// Valid       any bytes; the first 4096 decide

#include <array>
#include <string>
#include <string_view>

namespace fstiff::inline v0_1::io::detail {

/// The endings of the forms that fstiff reads, for messages.
std::string readable_forms();

/// "is binary: a PNG picture, which is not read; must be ..."; empty when the first bytes are of no format that is
/// known here.
std::string known_binary_refusal(std::string_view bytes);

/// Whether a reader may accept bytes that begin so, including NUL bytes: of a binary form, or of text in UTF-16.
bool may_hold_nul_bytes(std::string_view bytes);

}  // namespace fstiff::inline v0_1::io::detail
