// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Progress of a long computation, reported to its caller; the library itself prints nothing.

#include <fstiff/core/config.hpp>

#include <cstddef>
#include <functional>
#include <string_view>

namespace fstiff::inline v0_1 {

/// Called with the name of the part that runs and how much of it is done: \p done of \p all, done < all; from the
/// thread that computes, a few hundred times or more. An exception from it ends the computation and reaches the caller.
/// Empty: not called. Where one part ends and the next begins, \p what changes or \p done falls.
using ProgressHook = std::function<void(std::string_view what, std::size_t done, std::size_t all)>;

}  // namespace fstiff::inline v0_1
