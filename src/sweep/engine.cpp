// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/engine.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace fstiff::sweep {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

constexpr double block_seconds = 0.05, sync_seconds = 1;
constexpr std::uint64_t most_in_block = 4096;
constexpr std::size_t sync_bytes = std::size_t(1) << 20;

/// Blocks of scenes between the threads that compute them and the one that hands them over.
class Queue {
public:
    Queue(std::uint64_t first, std::uint64_t end, unsigned threads)
        : next_(first), end_(end), most_ahead_(3 * std::size_t(threads)) {}

    struct Part {
        std::uint64_t first = 0, count = 0;
        Block block{};
    };

    /// The next scenes to compute, at most \p wanted; a count of 0: there are no more.
    Part take(std::uint64_t wanted) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return stopped_ || next_ == end_ || open_ < most_ahead_; });
        if (stopped_ || next_ == end_) return {};
        Part part{next_, std::min(wanted, end_ - next_), {}};
        next_ += part.count;
        ++open_;
        return part;
    }
    void put(Part part) {
        {
            const std::lock_guard lock(mutex_);
            const std::uint64_t first = part.first;
            ready_.emplace(first, std::move(part));
        }
        changed_.notify_all();
    }
    void stop(std::exception_ptr error) {
        {
            const std::lock_guard lock(mutex_);
            stopped_ = true;
            if (!error_) error_ = std::move(error);
        }
        changed_.notify_all();
    }
    /// The block that begins with the scene \p first. \throws what a thread has thrown.
    Part wait_for(std::uint64_t first) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return error_ || ready_.contains(first); });
        if (error_) std::rethrow_exception(error_);
        Part part = std::move(ready_.extract(first).mapped());
        --open_;
        lock.unlock();
        changed_.notify_all();
        return part;
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<std::uint64_t, Part> ready_;
    std::uint64_t next_, end_;
    std::size_t open_ = 0, most_ahead_;  ///< blocks that were taken and not yet handed over
    bool stopped_ = false;
    std::exception_ptr error_;
};

void work(const Grid& grid, SceneMaker& maker, Queue& queue) {
    try {
        SceneMaker::Work of_thread;
        std::uint64_t wanted = 1;  // nobody knows yet how long a scene takes
        while (true) {
            Queue::Part part = queue.take(wanted);
            if (part.count == 0) return;
            const auto begun = Clock::now();
            part.block = lines_of(grid, maker, of_thread, part.first, part.count);
            const double one = seconds_since(begun) / static_cast<double>(part.count);
            const double fit = std::min(block_seconds / std::max(one, 1e-9), 4 * static_cast<double>(wanted));
            wanted = std::clamp<std::uint64_t>(static_cast<std::uint64_t>(fit), 1, most_in_block);
            queue.put(std::move(part));
        }
    } catch (...) {
        queue.stop(std::current_exception());
    }
}

/// Ends the threads whatever happens.
class Threads {
public:
    Threads(Queue& queue, unsigned count, const std::function<void()>& call) : queue_(queue) {
        for (unsigned i = 0; i < count; ++i) all_.emplace_back(call);
    }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
    ~Threads() {
        queue_.stop(nullptr);
        for (std::thread& one : all_) one.join();
    }

private:
    Queue& queue_;
    std::vector<std::thread> all_;
};

}  // namespace

void run(const Grid& grid, SceneMaker& maker, std::uint64_t first, std::uint64_t end, const EngineOptions& options,
         const Sink& sink) {
    Queue queue(first, end, std::max(1U, options.threads));
    const Threads threads(queue, std::max(1U, options.threads), [&] { work(grid, maker, queue); });
    std::string lines;
    std::uint64_t failed = 0;
    auto synced = Clock::now();
    for (std::uint64_t at = first; at < end;) {
        const Queue::Part part = queue.wait_for(at);
        at += part.count;
        lines += part.block.text;
        failed += part.block.failed;
        if (lines.size() < sync_bytes && seconds_since(synced) < sync_seconds && at < end) continue;
        sink(lines, at, failed);
        lines.clear();
        failed = 0;
        synced = Clock::now();
        if (options.progress && at < end)
            options.progress("scenes", static_cast<std::size_t>(at - first), static_cast<std::size_t>(end - first));
    }
}

}  // namespace fstiff::sweep
