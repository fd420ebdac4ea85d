// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A bar with the time left, on the terminal of standard error; nothing where that is no terminal.

#include <fstiff/core/progress.hpp>

namespace fstiff::cli {

/// Empty, and so never called, where standard error is no terminal. The bar appears when a part has run for half a second
/// (FSTIFF_PROGRESS_DELAY milliseconds, where the environment has that variable), and is wiped when the hook and its copies are gone: keep them no longer than the work lasts.
ProgressHook progress_bar();

}  // namespace fstiff::cli
