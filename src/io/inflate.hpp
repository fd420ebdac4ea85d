// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Inflates the zlib streams of compressed files. Compiled where zlib is.
///
/// Reference   RFC 1950 (zlib streams), by the library zlib
/// Valid       streams and results up to 2^31 bytes

#include <span>
#include <string_view>

namespace fstiff::inline v0_1::io {

/// Fills \p out with what the zlib stream \p stream holds. False where it is damaged, or holds more or fewer bytes.
[[nodiscard]] bool inflate_zlib(std::string_view stream, std::span<char> out);

}  // namespace fstiff::inline v0_1::io
