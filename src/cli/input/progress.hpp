// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A bar with the time left, on the terminal of standard error; nothing where that is no terminal.

#include <fstiff/core/progress.hpp>

#include <memory>
#include <string>

namespace fstiff::cli {

/// Empty, and so never called, where standard error is no terminal. The bar appears when a part has run for half a second
/// (FSTIFF_PROGRESS_DELAY milliseconds, where the environment has that variable), and is wiped when the hook and its
/// copies are gone: keep them no longer than the work lasts. \p with_rate: it tells how many are done in a second, too.
ProgressHook progress_bar(bool with_rate = false);

/// While it lives, a line with the time that passed stands on the terminal wherever no bar tells more: while a file is
/// read, or numbers are transformed. It appears after a second (or FSTIFF_PROGRESS_DELAY).
class Working {
public:
    /// \p what is done, such as the name of the command.
    explicit Working(std::string what);
    Working(const Working&) = delete;
    Working& operator=(const Working&) = delete;
    ~Working();

private:
    struct Clock;
    std::unique_ptr<Clock> clock_;  ///< none where standard error is no terminal
};

}  // namespace fstiff::cli
