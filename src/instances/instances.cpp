// SPDX-License-Identifier: BSD-3-Clause
#define FSTIFF_DOUBLE template
#include <fstiff/double/models.hpp>

namespace fstiff {

template <int Dynamic, int Static, bool ByMalloc>
int detail::fstiff_double_has_another_EIGEN_MAX_ALIGN_BYTES_than() {
    return 0;
}
template int detail::fstiff_double_has_another_EIGEN_MAX_ALIGN_BYTES_than<
    EIGEN_DEFAULT_ALIGN_BYTES, EIGEN_MAX_STATIC_ALIGN_BYTES, EIGEN_MALLOC_ALREADY_ALIGNED != 0>();

}  // namespace fstiff
