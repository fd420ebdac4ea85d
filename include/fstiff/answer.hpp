// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// One stiffness with its band for a joint: declarations, which cost a file no more than Eigen does. The functions come
/// from fstiff::double, from one file of the program that includes fstiff/implementation.hpp, or with
/// fstiff/answer_inline.hpp into the file itself (docs/linking-cpp.md).

#include <fstiff/answer/answer.hpp>

#ifdef FSTIFF_COMPILED
#include <fstiff/double/alignment.hpp>
#endif
