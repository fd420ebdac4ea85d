// SPDX-License-Identifier: BSD-3-Clause
#include "input/progress.hpp"

#include <fstiff/core/text.hpp>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>

namespace fstiff::cli {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

bool on_terminal() {
    const char* terminal = std::getenv("TERM");
    return isatty(STDERR_FILENO) != 0 && !(terminal && std::string_view(terminal) == "dumb");
}

milliseconds delay(int otherwise) {
    const char* given = std::getenv("FSTIFF_PROGRESS_DELAY");
    return milliseconds(given ? std::atoi(given) : otherwise);
}

std::string duration(double seconds) {
    const long long whole = std::llround(std::min(seconds, 1e9));
    if (whole < 60) return std::to_string(whole) + " s";
    return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s";
}

/// The line of the terminal that bars and the clock share.
class Line {
public:
    void show(const std::string& text) {
        const std::lock_guard lock(mutex_);
        std::cerr << "\r" << text << "\x1b[K" << std::flush;
        shown_ = true;
        changed_ = Clock::now();
    }
    void wipe() {
        const std::lock_guard lock(mutex_);
        if (shown_) std::cerr << "\r\x1b[K" << std::flush;
        shown_ = false;
    }
    Clock::time_point changed() {
        const std::lock_guard lock(mutex_);
        return changed_;
    }

private:
    std::mutex mutex_;
    bool shown_ = false;
    Clock::time_point changed_{};
};
Line status_line;

class Bar {
public:
    explicit Bar(bool with_rate) : with_rate_(with_rate) {}
    Bar(const Bar&) = delete;
    Bar& operator=(const Bar&) = delete;
    ~Bar() { status_line.wipe(); }

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
        next_ = now + milliseconds(100);
        const double share = static_cast<double>(done) / static_cast<double>(all);
        const double elapsed = std::chrono::duration<double>(now - begun_).count();
        const double left =
            elapsed * static_cast<double>(all - std::min(done, all)) / static_cast<double>(done - first_);
        constexpr int width = 30;
        const auto full = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * width);
        status_line.show(what_ + " [" + std::string(full, '#') + std::string(width - full, '.') + "] " +
                  std::to_string(static_cast<int>(100 * share)) + " %, " +
                  (with_rate_ ? rounded_text(static_cast<double>(done - first_) / elapsed, 3) + "/s, " : "") +
                  duration(left) + " left");
    }

private:
    bool with_rate_;
    milliseconds delay_ = delay(500);
    std::string what_;
    std::size_t done_ = 0, first_ = 0;
    Clock::time_point begun_, next_;
};

}  // namespace

ProgressHook progress_bar(bool with_rate) {
    if (!on_terminal()) return {};
    return [bar = std::make_shared<Bar>(with_rate)](std::string_view what, std::size_t done, std::size_t all) {
        (*bar)(what, done, all);
    };
}

struct Working::Clock {
    std::mutex mutex;
    std::condition_variable end;
    bool ended = false;
    std::thread thread;

    void run(const std::string& what) {
        const auto begun = cli::Clock::now();
        const milliseconds quiet = delay(1000);  // since a bar said more
        std::unique_lock lock(mutex);
        for (milliseconds wait = quiet; !end.wait_for(lock, wait, [&] { return ended; }); wait = milliseconds(250)) {
            const auto now = cli::Clock::now();
            if (now - status_line.changed() >= std::max(quiet, milliseconds(200)))
                status_line.show(what + ": working, " + duration(std::chrono::duration<double>(now - begun).count()));
        }
        status_line.wipe();
    }
};

Working::Working(std::string what) {
    if (!on_terminal()) return;
    clock_ = std::make_unique<Clock>();
    try {
        clock_->thread = std::thread([clock = clock_.get(), name = std::move(what)] { clock->run(name); });
    } catch (const std::system_error&) {  // no more threads: work goes on without the line
        clock_.reset();
    }
}

Working::~Working() {
    if (!clock_) return;
    {
        const std::lock_guard lock(clock_->mutex);
        clock_->ended = true;
    }
    clock_->end.notify_one();
    clock_->thread.join();
}

}  // namespace fstiff::cli
