// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fstiff/core/parallel.hpp>

namespace fstiff::cli {

/// A bar with the time left, on the terminal of standard error; empty, and never called, where that is not a terminal.
/// It is wiped when the hook and its copies are gone: keep them no longer than the work lasts. \p with_rate: it also
/// shows how many are done in a second.
ProgressHook progress_bar(bool with_rate = false);

/// Runs pieces on as many threads as the machine has cores, or as start, and reports them to \p progress.
ParallelHook all_cores(const ProgressHook& progress);

}  // namespace fstiff::cli
