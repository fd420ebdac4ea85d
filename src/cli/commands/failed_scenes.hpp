// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Warning of fstiff sweep and fstiff sweep --merge about scenes without a result.

#include "document/output.hpp"

#include <cstdint>
#include <string>

namespace fstiff::cli {

/// "1 scene", "2 scenes".
[[nodiscard]] inline std::string counted(std::uint64_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// Warns of the \p failed scenes in \p report, which is then doubtful; no warning without any.
inline void warn_of_failed_scenes(Report& report, std::uint64_t failed) {
    if (failed == 0) return;
    report.diagnostics.push_back(
        "warning: " + counted(failed, "scene") +
        " cannot be computed, or only in part; a line with the key \"error\" replaces the missing results");
    report.status = doubtful_result;
}

}  // namespace fstiff::cli
