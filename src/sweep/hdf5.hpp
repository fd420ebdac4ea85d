// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Results as an HDF5 file: a data set for each key of the lines, as long as there are lines. Numbers are doubles, NaN where
// there is none, the index is a whole number, texts have a fixed length in UTF-8. The attributes of the file are grid,
// hash, scenes and failed of the description.

#include <string>

namespace fstiff::sweep {

/// Whether \p file ends in .h5 or .hdf5.
[[nodiscard]] bool is_hdf5(const std::string& file);
/// The file of lines behind \p output: "out.h5.jsonl" of "out.h5"; any other is its own.
[[nodiscard]] std::string lines_file(const std::string& output);

/// \throws option_error for the ending of another form, such as .csv and .parquet, and for .h5 where fstiff was built without
/// HDF5. Any other name holds lines of JSON.
void require_form(const std::string& output);

/// Writes the finished results \p lines as \p output, beside it first, then renamed.
/// \throws file_error for what cannot be read or written.
void write_hdf5(const std::string& lines, const std::string& output);

}  // namespace fstiff::sweep
