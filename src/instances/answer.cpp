// SPDX-License-Identifier: BSD-3-Clause
#include <fstiff/double/models.hpp>

#undef FSTIFF_INLINE  // as fstiff/implementation.hpp
#define FSTIFF_INLINE
#include <fstiff/answer/answer_inline.hpp>
#include <fstiff/answer/measured_face_inline.hpp>
