// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Computes the scenes of a shard with several threads and hands them over in their order. Memory does not grow with the
// grid: the threads are never more than a few blocks ahead of what was handed over.

#include "sweep/lines.hpp"

#include <fstiff/core/parallel.hpp>

#include <cstdint>
#include <functional>
#include <thread>

namespace fstiff::sweep {

/// Starts a thread that runs a call. \throws std::system_error, std::bad_alloc where the system has no more.
using ThreadStart = std::function<std::thread(const std::function<void()>&)>;

struct EngineOptions {
    unsigned threads = 1;     ///< that are asked for
    bool lines = true;        ///< blocks have their lines alone; else their rows
    ProgressHook progress{};  ///< "scenes", of the shard; from the thread that calls run()
    ThreadStart start{};      ///< empty: std::thread
};

/// Takes the next block. Where it throws std::bad_alloc it must have taken nothing: the block comes again.
using Sink = std::function<void(const Block& block)>;

/// The scenes from \p first up to \p end, in their order, a block of some 50 ms of work at a time. What \p sink
/// throws, or any exception of a scene other than domain_error and file_error, ends it.
/// \returns how many threads computed the last of them. Where the system starts fewer than asked for, or has not the
/// memory for so many, fewer compute everything, and of none the thread that calls does.
unsigned run(const Grid& grid, SceneMaker& maker, std::uint64_t first, std::uint64_t end, const EngineOptions& options,
             const Sink& sink);

}  // namespace fstiff::sweep
