// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Files with a part that another library unpacks: their readers, to which a test may give another function.
///
/// Reference   RFC 1950 (zlib streams), by the library zlib
/// Valid       streams and results up to 2^31 bytes

#include "io/reading.hpp"

#include <functional>
#include <span>

namespace fstiff::inline v0_1::io::detail {

/// Inflates a zlib stream into exactly as many bytes, or returns false.
using Inflate = std::function<bool(std::string_view stream, std::span<char> out)>;
/// The file \p entry of a zip archive.
using Unzip = std::function<std::string(std::string_view archive, std::string_view entry)>;

/// Fills \p out with what the zlib stream \p stream holds. False where it is damaged, or holds more or fewer bytes.
/// Compiled where zlib is.
[[nodiscard]] bool inflate_zlib(std::string_view stream, std::span<char> out);

/// Fills \p out with the first bytes that the zlib stream \p stream holds. \return how many there are, 0 where it is
/// damaged. Compiled where zlib is.
[[nodiscard]] std::size_t inflate_first(std::string_view stream, std::span<char> out);

/// Reads a file of Digital Surf. Without \p inflate, compressed files are refused.
/// \throws domain_error naming file, field, value and what is allowed.
[[nodiscard]] Reading read_sur(std::string_view bytes, const std::string& name, const Inflate& inflate = {});
/// Reads a file of Keyence. Without \p unzip, .vk6 and .vk7 are refused.
/// \throws domain_error naming file, field, value and what is allowed.
[[nodiscard]] Reading read_vk4(std::string_view bytes, const std::string& name, const Unzip& unzip = {});

}  // namespace fstiff::inline v0_1::io::detail
