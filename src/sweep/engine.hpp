// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Computes the scenes of a grid with several threads and hands them over in their order. Memory does not grow with the
// grid: a thread has one block, which it hands over before it takes the next.

#include "sweep/lines.hpp"

#include <fstiff/core/parallel.hpp>

#include <functional>

namespace fstiff::sweep {

struct EngineOptions {
    unsigned threads = 1;     ///< that are asked for
    bool lines = true;        ///< blocks have their lines alone; else their rows
    ProgressHook progress{};  ///< "scenes", of \p rows; from the thread that calls run()
};

/// Takes the next block, from any thread, one at a time. Where it throws std::bad_alloc it must have taken nothing: the
/// block comes again.
using Sink = std::function<void(const Block& block)>;

/// The scenes of \p rows, in their order, a block of some 50 ms of work at a time. What \p sink throws, or any
/// exception of a scene other than domain_error and file_error, ends it.
/// \returns how many threads computed the last of them, the one that calls among them. Where the system starts fewer
/// than asked for, or has not the memory for so many, fewer compute everything.
unsigned run(const Grid& grid, SceneMaker& maker, Rows rows, const EngineOptions& options, const Sink& sink);

}  // namespace fstiff::sweep
