// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <utility>

namespace fstiff::cli {
namespace {

constexpr auto first_after = std::chrono::milliseconds(1000), again_after = std::chrono::milliseconds(100);
constexpr const char* wipe = "\r\x1b[K";

bool can_draw() {
    const char* const kind = std::getenv("TERM");
    return isatty(STDERR_FILENO) != 0 && !(kind && std::string_view(kind) == "dumb");
}

std::string time_text(double seconds) {
    const auto whole = static_cast<long>(std::min(std::ceil(seconds), 359999.0));
    const std::string rest = std::to_string(whole % 60);
    if (whole < 60) return rest + " s";
    if (whole < 3600) return std::to_string(whole / 60) + " min " + rest + " s";
    return std::to_string(whole / 3600) + " h " + std::to_string(whole / 60 % 60) + " min";
}

}  // namespace

Progress::Progress(std::string text)
    : text_(std::move(text)), start_(Clock::now()), drawn_(start_), terminal_(can_draw()) {}

Progress::~Progress() {
    if (shown_) std::cerr << wipe << std::flush;
}

void Progress::at(double share) {
    if (!terminal_) return;
    const auto now = Clock::now();
    if (now - start_ < first_after || (shown_ && now - drawn_ < again_after)) return;
    share = std::clamp(share, 0.0, 1.0);
    constexpr int cells = 30;
    const auto full = static_cast<std::size_t>(share * cells);
    std::string line = wipe + text_ + " [" + std::string(full, '#') + std::string(cells - full, '.') + "] " +
                       std::to_string(static_cast<int>(100 * share)) + " %";
    if (share > 0)
        line += ", " + time_text(std::chrono::duration<double>(now - start_).count() * (1 - share) / share) + " left";
    std::cerr << line << std::flush;
    shown_ = true;
    drawn_ = now;
}

}  // namespace fstiff::cli
