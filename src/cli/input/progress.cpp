// SPDX-License-Identifier: BSD-3-Clause
#include "input/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <string>

namespace fstiff::cli {
namespace {

class Bar {
public:
    explicit Bar(std::chrono::milliseconds delay) : delay_(delay) {}
    Bar(const Bar&) = delete;
    Bar& operator=(const Bar&) = delete;
    ~Bar() {
        if (shown_) std::cerr << "\r\x1b[K" << std::flush;
    }

    void operator()(std::string_view what, std::size_t done, std::size_t all) {
        const auto now = Clock::now();
        if (what != what_ || done < done_) {  // another part
            what_ = what;
            begun_ = now;
            next_ = now + delay_;
            first_ = done;
        }
        done_ = done;
        if (now < next_ || done <= first_ || all == 0) return;
        next_ = now + std::chrono::milliseconds(100);
        const double share = static_cast<double>(done) / static_cast<double>(all);
        const double elapsed = std::chrono::duration<double>(now - begun_).count();
        const double left =
            elapsed * static_cast<double>(all - std::min(done, all)) / static_cast<double>(done - first_);
        constexpr int width = 30;
        const auto full = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * width);
        std::cerr << "\r" << what_ << " [" << std::string(full, '#') << std::string(width - full, '.') << "] "
                  << static_cast<int>(100 * share) << " %, " << duration(left) << " left\x1b[K" << std::flush;
        shown_ = true;
    }

private:
    using Clock = std::chrono::steady_clock;

    static std::string duration(double seconds) {
        const long long whole = std::llround(std::min(seconds, 1e9));
        if (whole < 60) return std::to_string(whole) + " s";
        return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
    }

    std::chrono::milliseconds delay_;
    std::string what_;
    std::size_t done_ = 0, first_ = 0;
    Clock::time_point begun_, next_;
    bool shown_ = false;
};

}  // namespace

ProgressHook progress_bar() {
    const char* terminal = std::getenv("TERM");
    if (isatty(STDERR_FILENO) == 0 || (terminal && std::string_view(terminal) == "dumb")) return {};
    const char* delay = std::getenv("FSTIFF_PROGRESS_DELAY");
    return [bar = std::make_shared<Bar>(std::chrono::milliseconds(delay ? std::atoi(delay) : 500))](
               std::string_view what, std::size_t done, std::size_t all) { (*bar)(what, done, all); };
}

}  // namespace fstiff::cli
