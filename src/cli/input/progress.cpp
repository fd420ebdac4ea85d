// SPDX-License-Identifier: BSD-3-Clause
#include "input/progress.hpp"

#include "document/system.hpp"

#include <fstiff/core/text.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <future>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

namespace fstiff::cli {
namespace {

using Clock = std::chrono::steady_clock;

std::string duration(double seconds) {
    const long long total = std::llround(std::min(seconds, 1e9));
    return (total < 60 ? "" : std::to_string(total / 60) + " min ") + std::to_string(total % 60) + " s";
}

class Bar {
public:
    explicit Bar(bool with_rate) : with_rate_(with_rate) {}
    Bar(const Bar&) = delete;
    Bar& operator=(const Bar&) = delete;
    ~Bar() {
        if (shown_) std::cerr << "\r\x1b[K" << std::flush;
    }

    void operator()(std::string_view what, std::size_t done, std::size_t total) {
        const auto now = Clock::now();
        if (what != what_ || done < done_) {  // another part
            what_ = what;
            begun_ = next_ = now;
            first_ = done;
        }
        done_ = done;
        if (now < next_ || done <= first_ || total == 0) return;
        next_ = now + std::chrono::milliseconds(100);
        shown_ = true;
        const double share = std::min(static_cast<double>(done) / static_cast<double>(total), 1.0);
        const double rate = static_cast<double>(done - first_) / std::chrono::duration<double>(now - begun_).count();
        const auto full = static_cast<std::size_t>(share * width);
        std::cerr << "\r" << what_ << " [" << std::string(full, '#') << std::string(width - full, '.') << "] "
                  << static_cast<int>(100 * share) << " %, "
                  << (with_rate_ ? detail::rounded_text(rate, 3) + "/s, " : "")
                  << duration(static_cast<double>(total - std::min(done, total)) / rate) << " left\x1b[K" << std::flush;
    }

private:
    static constexpr std::size_t width = 30;
    bool with_rate_, shown_ = false;
    std::string what_;
    std::size_t first_ = 0, done_ = 0;
    Clock::time_point begun_, next_;
};

}  // namespace

ProgressHook progress_bar(bool with_rate) {
    const char* terminal = std::getenv("TERM");
    if (!document::os::is_terminal(stderr) || (terminal && std::string_view(terminal) == "dumb")) return {};
    return [bar = std::make_shared<Bar>(with_rate)](std::string_view what, std::size_t done, std::size_t total) {
        (*bar)(what, done, total);
    };
}

ParallelHook all_cores(const ProgressHook& progress) {
    return [progress, caller = std::this_thread::get_id()](std::size_t count, const auto& run) {
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t i; (i = next++) < count;) run(i);
        };
        std::vector<std::future<void>> helpers;  // each ends before it is destroyed
        try {
            for (std::size_t i = 1; i < std::min<std::size_t>(std::thread::hardware_concurrency(), count); ++i)
                helpers.push_back(std::async(std::launch::async, work));
        } catch (const std::system_error&) {  // a limit on threads
        }
        const bool reports = progress && std::this_thread::get_id() == caller;  // not for the pieces of a piece
        for (std::size_t i; (i = next++) < count; run(i))
            if (reports) progress("pieces", i, count);
    };
}

}  // namespace fstiff::cli
