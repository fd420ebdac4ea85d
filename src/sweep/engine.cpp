// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/engine.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

namespace fstiff::sweep {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

constexpr double block_seconds = 0.05;
constexpr std::uint64_t most_in_block = 4096;
constexpr std::size_t bytes_kept_free = std::size_t(1)
                                        << 26;  // while threads are started; of address space, not of memory

/// Blocks of scenes between the threads that compute them and the one that hands them over.
class Queue {
public:
    Queue(std::uint64_t first, std::uint64_t end, unsigned threads)
        : next_(first), end_(end), most_ahead_(3 * std::size_t(threads)) {}

    /// The next scenes to compute, at most \p wanted, as the first and how many; none where there are no more.
    std::pair<std::uint64_t, std::uint64_t> take(std::uint64_t wanted) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return stopped_ || next_ == end_ || open_ < most_ahead_; });
        if (stopped_ || next_ == end_) return {};
        const std::uint64_t first = next_, count = std::min(wanted, end_ - next_);
        next_ += count;
        ++open_;
        return {first, count};
    }
    void put(Block block) {
        {
            const std::lock_guard lock(mutex_);
            const std::uint64_t first = block.first;
            ready_.emplace(first, std::move(block));
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
    Block wait_for(std::uint64_t first) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return error_ || ready_.contains(first); });
        if (error_) std::rethrow_exception(error_);
        Block block = std::move(ready_.extract(first).mapped());
        --open_;
        lock.unlock();
        changed_.notify_all();
        return block;
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<std::uint64_t, Block> ready_;
    std::uint64_t next_, end_;
    std::size_t open_ = 0, most_ahead_;  ///< blocks that were taken and not yet handed over
    bool stopped_ = false;
    std::exception_ptr error_;
};

/// Computes one block after the other.
class Worker {
public:
    Worker(const Grid& grid, SceneMaker& maker, Queue& queue, bool lines)
        : grid_(grid), maker_(maker), queue_(queue), lines_(lines) {}

    /// \returns false where there is no block left.
    bool step() {
        const auto [first, count] = queue_.take(wanted_);
        if (count == 0) return false;
        const auto begun = Clock::now();
        Block block = block_of(grid_, maker_, work_, first, count);
        if (lines_) {
            std::string lines = lines_of(grid_, block);
            block = {.first = first, .end = block.end, .failed = block.failed, .lines = std::move(lines)};
        }
        const double seconds_each = seconds_since(begun) / static_cast<double>(count);
        const double fit = std::min(block_seconds / std::max(seconds_each, 1e-9), 4 * static_cast<double>(wanted_));
        wanted_ = std::clamp<std::uint64_t>(static_cast<std::uint64_t>(fit), 1, most_in_block);
        queue_.put(std::move(block));
        return true;
    }

private:
    const Grid& grid_;
    SceneMaker& maker_;
    Queue& queue_;
    bool lines_;
    SceneMaker::Work work_;
    std::uint64_t wanted_ = 1;  // the time of a scene is not known yet
};

/// As many threads as the system starts. Ends them whatever happens.
class Threads {
public:
    Threads(Queue& queue, unsigned count, const ThreadStart& start, const std::function<void()>& call) : queue_(queue) {
        all_.reserve(count);
        // where the stacks of the threads meet a limit on memory, the work needs some too
        const std::unique_ptr<char[]> kept_free(new (std::nothrow) char[bytes_kept_free]);
        try {
            while (kept_free && all_.size() < count) all_.push_back(start ? start(call) : std::thread(call));
        } catch (const std::system_error&) {  // a limit on threads, or on memory
        } catch (const std::bad_alloc&) {
        }
    }
    [[nodiscard]] unsigned count() const { return static_cast<unsigned>(all_.size()); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;
    ~Threads() {
        queue_.stop(nullptr);
        for (std::thread& thread : all_) thread.join();
    }

private:
    Queue& queue_;
    std::vector<std::thread> all_;
};

}  // namespace

unsigned run(const Grid& grid, SceneMaker& maker, std::uint64_t first, std::uint64_t end, const EngineOptions& options,
             const Sink& sink) {
    std::uint64_t next = first;
    /// Goes on with \p wanted threads, or as many as start, or of none with this one. \returns how many.
    const auto go_on = [&](unsigned wanted) {
        Queue queue(next, end, std::max(1U, wanted));
        const auto call = [&] {
            try {
                Worker worker(grid, maker, queue, options.lines);
                while (worker.step()) continue;
            } catch (...) {
                queue.stop(std::current_exception());
            }
        };
        const Threads threads(queue, wanted, options.start, call);
        Worker here(grid, maker, queue, options.lines);
        while (next < end) {
            if (threads.count() == 0) here.step();
            const Block block = queue.wait_for(next);
            sink(block);
            next = block.end;
            if (options.progress && next < end)
                options.progress("scenes", static_cast<std::size_t>(next - first),
                                 static_cast<std::size_t>(end - first));
        }
        return threads.count();
    };
    for (unsigned threads = std::max(1U, options.threads);; threads /= 2) try {
            return go_on(threads);
        } catch (const std::bad_alloc&) {  // fewer threads leave more memory to each
            if (threads == 0) throw;
        }
}

}  // namespace fstiff::sweep
