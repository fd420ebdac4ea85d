// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Independent pieces of work, for a host that brings its own threads; the library starts none.
///
///     options.parallel = [&](std::size_t count, const auto& run) { pool.for_each(count, run); };

#include <fstiff/core/config.hpp>

#include <cstddef>
#include <exception>
#include <functional>
#include <string_view>
#include <vector>

// Progress of a long computation, reported to its caller; the library itself prints nothing.

namespace fstiff { inline namespace v0_1 {

/// Called with the name of the part that runs and how much of it is done: \p done of \p total, done < total; from the
/// thread that computes, a few hundred times or more. An exception from it ends the computation and reaches the caller.
/// Empty: not called. Where one part ends and the next begins, \p part changes or \p done falls.
using ProgressHook = std::function<void(std::string_view part, std::size_t done, std::size_t total)>;

/// Calls \p run once with every index below \p count, in any order and from any threads, and returns when all calls
/// have. A call does not throw, and may have pieces of its own. Empty: one after the other.
using ParallelHook = std::function<void(std::size_t count, const std::function<void(std::size_t index)>& run)>;

namespace detail {

/// Calls \p call(i) for every i below \p count through \p hook. What a call throws reaches the caller, of several the
/// one with the least index.
template <class Call>
void run_pieces(const ParallelHook& hook, std::size_t count, const Call& call) {
    if (!hook) {
        for (std::size_t i = 0; i < count; ++i) call(i);
        return;
    }
    std::vector<std::exception_ptr> thrown(count);
    hook(count, [&](std::size_t i) {
        try {
            call(i);
        } catch (...) {
            thrown[i] = std::current_exception();
        }
    });
    for (const std::exception_ptr& exception : thrown)
        if (exception) std::rethrow_exception(exception);
}

}  // namespace detail

}}  // namespace fstiff
