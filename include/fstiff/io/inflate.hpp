// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Inflates the zlib streams of compressed files. An opt-in header: needs zlib (CMake target fstiff::zlib), and is not part
/// of io.hpp.
///
/// Reference   RFC 1950 (zlib streams), by the library zlib
/// Valid       streams and results up to 2^31 bytes

#include <zlib.h>

#include <span>
#include <string_view>

namespace fstiff::io {

/// Fills \p out with what the zlib stream \p stream holds. False where it is damaged, or holds more or fewer bytes.
[[nodiscard]] inline bool inflate_zlib(std::string_view stream, std::span<char> out) {
    if (stream.empty() || out.empty()) return false;
    auto length = static_cast<uLongf>(out.size());
    const int status = ::uncompress(reinterpret_cast<Bytef*>(out.data()), &length,
                                    reinterpret_cast<const Bytef*>(stream.data()), static_cast<uLong>(stream.size()));
    return status == Z_OK && length == out.size();
}

}  // namespace fstiff::io
