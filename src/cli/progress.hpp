// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// A bar with the time left on the standard error of a terminal, for work of more than a second; nothing in a pipe.

#include <chrono>
#include <string>

namespace fstiff::cli {

class Progress {
public:
    /// \p text says what is being done.
    explicit Progress(std::string text);
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    ~Progress();  ///< wipes the bar out
    /// \p share of the work is done, 0 to 1. Costs a look at the clock, and draws ten times a second at most.
    void at(double share);

private:
    using Clock = std::chrono::steady_clock;
    std::string text_;
    Clock::time_point start_, drawn_;
    bool terminal_, shown_ = false;
};

}  // namespace fstiff::cli
