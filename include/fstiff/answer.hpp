// SPDX-License-Identifier: BSD-3-Clause
#pragma once
/// \file
/// One stiffness with its band for a joint: answer/answer.hpp with its functions, which are inline unless
/// fstiff::double is linked. Without it a file that includes this takes a minute to compile.

#include <fstiff/answer/answer.hpp>

#ifdef FSTIFF_COMPILED
#include <fstiff/double/alignment.hpp>
#else
#include <fstiff/answer/answer_inline.hpp>
#endif
