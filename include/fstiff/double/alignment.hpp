// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// Alignment of the arrays of Eigen that a program and the library fstiff::double hand to each other. Eigen chooses it,
/// and with it the way to free memory, by the processor that a file is compiled for: a program with -mavx2 would free
/// in its own way what a library without it has allocated. The target fstiff::double therefore defines
/// EIGEN_MAX_ALIGN_BYTES and EIGEN_MAX_STATIC_ALIGN_BYTES, and a file with other numbers does not link: it refers to a
/// function that the library has for its own numbers alone (docs/portability.md).

#include <fstiff/core/config.hpp>

#include <Eigen/Core>

namespace fstiff { inline namespace v0_1 { namespace detail {

template <int Dynamic, int Static, bool ByMalloc>
int fstiff_double_has_another_EIGEN_MAX_ALIGN_BYTES_than();

[[maybe_unused]] static const int aligned_as_fstiff_double =
    fstiff_double_has_another_EIGEN_MAX_ALIGN_BYTES_than<EIGEN_DEFAULT_ALIGN_BYTES, EIGEN_MAX_STATIC_ALIGN_BYTES,
                                                         EIGEN_MALLOC_ALREADY_ALIGNED != 0>();

}}}  // namespace fstiff::detail
