// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The files that an output may replace: those that fstiff made, as their first lines show.

#include <string>
#include <string_view>

namespace fstiff::cli {

/// Whether \p bytes, the beginning of a file, are those of an output: its maker and the version, a key of JSON, a
/// header of CSV with numbers as fstiff prints them, or the example that is printed to be edited, unchanged.
[[nodiscard]] bool is_own_output(std::string_view bytes);

/// Of an output that is going to be written. \throws file_error where \p file holds something that is no output of
/// fstiff, or, with \p of_picture, for a file that nobody named, that is not the numbers of a picture.
void require_own(const std::string& file, bool of_picture = false);

}  // namespace fstiff::cli
