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
constexpr std::size_t bytes_kept_free = 1 << 26;  // while threads are started; of address space, not of memory

/// The blocks of a run: threads take them in their order, and hand them over in the same order, each at its turn.
struct Blocks {
    const Grid& grid;
    SceneMaker& maker;
    const Rows rows;
    const EngineOptions& options;
    const Sink& sink;
    std::uint64_t next = rows.first, due = rows.first;  ///< scenes to take, to hand over
    std::mutex mutex{};
    std::condition_variable turn{};
    bool stopped = false;
    std::exception_ptr error{};  ///< the first one of all threads

    /// Computes blocks until none is left.
    void work(const ProgressHook& progress) noexcept {
        try {
            SceneMaker::Work work;
            std::uint64_t wanted = 1;  // the time of a scene is not known yet
            while (const std::uint64_t end = step(work, wanted))
                if (progress && end < rows.end)
                    progress("scenes", static_cast<std::size_t>(end - rows.first),
                             static_cast<std::size_t>(rows.end - rows.first));
        } catch (...) {
            const std::lock_guard lock(mutex);
            stopped = true;
            if (!error) error = std::current_exception();
            turn.notify_all();
        }
    }
    /// Computes the next block of \p wanted scenes. \returns the scene after it; 0 where there is none.
    std::uint64_t step(SceneMaker::Work& work, std::uint64_t& wanted) {
        std::unique_lock lock(mutex);
        const std::uint64_t first = next, count = stopped ? 0 : std::min(wanted, rows.end - first);
        if (count == 0) return 0;
        next += count;
        lock.unlock();
        const auto begun = Clock::now();
        Block block = block_of(grid, maker, work, first, count);
        if (options.lines)
            block = {.first = first, .end = block.end, .failed = block.failed, .lines = lines_of(grid, block)};
        const double each = std::chrono::duration<double>(Clock::now() - begun).count() / static_cast<double>(count);
        const double fit = std::min(block_seconds / std::max(each, 1e-9), 4 * static_cast<double>(wanted));
        wanted = std::clamp<std::uint64_t>(static_cast<std::uint64_t>(fit), 1, most_in_block);
        lock.lock();
        turn.wait(lock, [&] { return stopped || due == first; });
        if (stopped) return 0;
        sink(block);
        due = block.end;
        turn.notify_all();
        return due;
    }
};

/// Starts \p count threads, or as many as the system has room for.
std::vector<std::thread> helpers(unsigned count, Blocks& blocks) {
    std::vector<std::thread> all;
    try {
        all.reserve(count);
        // where the stacks of the threads meet a limit on memory, the work needs some too
        const std::unique_ptr<char[]> kept_free(new (std::nothrow) char[bytes_kept_free]);
        while (kept_free && all.size() < count) all.emplace_back([&] { blocks.work({}); });
    } catch (const std::system_error&) {  // a limit on threads, or on memory
    } catch (const std::bad_alloc&) {
    }
    return all;
}

}  // namespace

unsigned run(const Grid& grid, SceneMaker& maker, Rows rows, const EngineOptions& options, const Sink& sink) {
    for (unsigned wanted = std::max(1U, options.threads);; wanted = std::max(1U, wanted / 2)) {
        Blocks blocks{grid, maker, rows, options, sink};
        std::vector<std::thread> threads = helpers(wanted - 1, blocks);
        blocks.work(options.progress);
        for (std::thread& thread : threads) thread.join();
        try {
            if (!blocks.error) return static_cast<unsigned>(threads.size()) + 1;
            std::rethrow_exception(blocks.error);
        } catch (const std::bad_alloc&) {  // fewer threads leave more memory to each
            if (wanted == 1) throw;
            rows.first = blocks.due;
        }
    }
}

}  // namespace fstiff::sweep
