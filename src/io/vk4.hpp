// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Reads maps of Keyence VK microscopes (.vk3, .vk4, .vk6, .vk7).
///
/// "VK3_" or "VK4_", and a table of places in the file (uint32, the least significant byte first), of which are used:
///
///     12  of the settings                            36, 40, 44  of up to three images of heights, 0: none
///
/// The settings have at their bytes 168 and 172 the steps of x and y, at 176 that of the heights, as uint32 in pm. An
/// image has at its bytes 0 columns, 4 rows, 8 bits of a height (8, 16, 32), 12 compression (0: none), 16 bytes of the
/// heights, and from 796 on, after a palette, the heights row after row as unsigned integers.
///
///     height = number times step of the heights
///
/// The first image is read, the record lists the others. Missing points are not marked in these files.
///
/// A .vk6 or .vk7 begins with "VK6" or "VK7" and a picture (a NUL byte distinguishes it from text); its end is a zip
/// archive with a .vk4 as its file Vk4File.
///
/// Reference   layout as in SurfaceTopography 1.27.1 (MIT licence)
/// Units       map in m
/// Valid       2 points a side at least, or one row; heights that vary; .vk6 and .vk7 where X3P is read
/// Accuracy    number times step, rounded twice (tests/io/vk4_test.cpp)

#include "io/reading.hpp"

#include <functional>

namespace fstiff::inline v0_1::io {

/// The file \p entry of the zip archive \p bytes, which messages call \p name: zip_entry() of io/plux.hpp, or nothing
/// where X3P is not read.
using Unzip = std::function<std::string(std::string_view bytes, const std::string& name, std::string_view entry)>;

/// Whether \p bytes begin as a file of Keyence VK does.
[[nodiscard]] bool is_vk4(std::string_view bytes);

/// Without \p unzip, .vk6 and .vk7 are refused. \throws domain_error naming file, field, value and what is allowed.
[[nodiscard]] Reading read_vk4(std::string_view bytes, std::string_view name, const Unzip& unzip = {});

}  // namespace fstiff::inline v0_1::io
