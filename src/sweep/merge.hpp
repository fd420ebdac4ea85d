// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// The shards of one grid as one file of results, the very bytes that a sweep without shards writes.

#include <cstdint>
#include <string>
#include <vector>

namespace fstiff::sweep {

/// What was merged, or what is wrong with the shards: one sentence each, with the command that computes a missing one.
struct Merged {
    std::vector<std::string> problems;  ///< empty: the file was written
    std::uint64_t scenes = 0, failed = 0, shards = 0;
};

/// Checks that \p files are the shards of one grid, that each is whole and that none is missing or double, and writes all of
/// their lines to \p output, beside it first, then renamed, with its description. Names that end in .sweep are left out.
/// \throws file_error for what cannot be read or written.
[[nodiscard]] Merged merge(std::vector<std::string> files, const std::string& output);

}  // namespace fstiff::sweep
