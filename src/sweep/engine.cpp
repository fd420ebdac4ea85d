// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/engine.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace fstiff::sweep {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double block_seconds = 0.05;
constexpr std::uint64_t most_in_block = 4096;
constexpr std::size_t bytes_kept_free = std::size_t(1)
                                        << 26;  // while threads are started; of address space, not of memory

/// The blocks of a run: threads take them in their order, and hand them over in the same order, each at its turn.
class Blocks {
public:
    Blocks(const Grid& grid, SceneMaker& maker, Rows rows, const EngineOptions& options, const Sink& sink)
        : grid_(grid),
          maker_(maker),
          rows_(rows),
          options_(options),
          sink_(sink),
          next_(rows.first),
          due_(rows.first) {}

    /// Computes blocks until none is left. \throws nothing: the first exception of all threads is kept.
    void work(bool reports) noexcept {
        try {
            SceneMaker::Work work;
            std::uint64_t wanted = 1;  // the time of a scene is not known yet
            while (step(work, wanted))
                if (reports && options_.progress && due() < rows_.end)
                    options_.progress("scenes", static_cast<std::size_t>(due() - rows_.first),
                                      static_cast<std::size_t>(rows_.end - rows_.first));
        } catch (...) {
            stop(std::current_exception());
        }
    }
    /// No thread takes or hands over another block.
    void stop(std::exception_ptr error) noexcept {
        {
            const std::lock_guard lock(mutex_);
            stopped_ = true;
            if (!error_) error_ = std::move(error);
        }
        turn_.notify_all();
    }
    /// \throws what a thread has thrown.
    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }
    /// The first scene that was not handed over.
    [[nodiscard]] std::uint64_t due() const {
        const std::lock_guard lock(mutex_);
        return due_;
    }

private:
    bool step(SceneMaker::Work& work, std::uint64_t& wanted) {
        std::unique_lock lock(mutex_);
        const std::uint64_t first = next_, count = stopped_ ? 0 : std::min(wanted, rows_.end - first);
        if (count == 0) return false;
        next_ += count;
        lock.unlock();
        const auto begun = Clock::now();
        Block block = block_of(grid_, maker_, work, first, count);
        if (options_.lines)
            block = {.first = first, .end = block.end, .failed = block.failed, .lines = lines_of(grid_, block)};
        const double each = std::chrono::duration<double>(Clock::now() - begun).count() / static_cast<double>(count);
        const double fit = std::min(block_seconds / std::max(each, 1e-9), 4 * static_cast<double>(wanted));
        wanted = std::clamp<std::uint64_t>(static_cast<std::uint64_t>(fit), 1, most_in_block);
        lock.lock();
        turn_.wait(lock, [&] { return stopped_ || due_ == first; });
        if (stopped_) return false;
        sink_(block);
        due_ = block.end;
        lock.unlock();
        turn_.notify_all();
        return true;
    }

    const Grid& grid_;
    SceneMaker& maker_;
    const Rows rows_;
    const EngineOptions& options_;
    const Sink& sink_;
    mutable std::mutex mutex_;
    std::condition_variable turn_;
    std::uint64_t next_, due_;  ///< to take, to hand over
    bool stopped_ = false;
    std::exception_ptr error_;
};

/// Starts \p count threads, or as many as the system has room for.
std::vector<std::thread> helpers(unsigned count, Blocks& blocks) {
    std::vector<std::thread> all;
    try {
        all.reserve(count);
        // where the stacks of the threads meet a limit on memory, the work needs some too
        const std::unique_ptr<char[]> kept_free(new (std::nothrow) char[bytes_kept_free]);
        while (kept_free && all.size() < count) all.emplace_back([&] { blocks.work(false); });
    } catch (const std::system_error&) {  // a limit on threads, or on memory
    } catch (const std::bad_alloc&) {
    }
    return all;
}

}  // namespace

unsigned run(const Grid& grid, SceneMaker& maker, Rows rows, const EngineOptions& options, const Sink& sink) {
    for (unsigned wanted = std::max(1U, options.threads);; wanted = std::max(1U, wanted / 2)) {
        Blocks blocks(grid, maker, rows, options, sink);
        std::vector<std::thread> threads = helpers(wanted - 1, blocks);
        blocks.work(true);
        for (std::thread& thread : threads) thread.join();
        try {
            blocks.rethrow();
            return static_cast<unsigned>(threads.size()) + 1;
        } catch (const std::bad_alloc&) {  // fewer threads leave more memory to each
            if (wanted == 1) throw;
            rows.first = blocks.due();
        }
    }
}

}  // namespace fstiff::sweep
